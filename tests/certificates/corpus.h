/* corpus.h: the good certificates of accept/, accept-1/ and ../check/ranges/, and the checker as a program. */
#ifndef TESTS_CERTIFICATES_CORPUS_H
#define TESTS_CERTIFICATES_CORPUS_H

#include "mutations.h"

#include "verify/valence_range.h"

enum { MAX_BASES = 200, MAX_SETTINGS = 4, SECONDS_PER_CHECK = 30 };

/* A good certificate with its claim. */
typedef struct {
    char name[64], scheme_file[512];
    valence_range k;
    bool not_c1;
    char *setting[MAX_SETTINGS]; /* "name=value" */
    int settings;
    lines body;     /* without count and hash */
    char *whole;
} base;

typedef struct {
    base base[MAX_BASES];
    int count;
} corpus;

/* Some of a corpus. */
typedef struct {
    const base *base[MAX_BASES];
    int count;
} choice_of_bases;

/* Reads what the tables in `folder` of tests/certificates/ list; test_fail if that cannot be done. */
void corpus_read(corpus *z, const char *folder, const char *table, bool not_c1);
/* All of them. */
void corpus_read_all(corpus *z);
/* Those with one of the parts, a list that ends with NULL, in their names, or all if there are no parts; test_fail if there is none. */
void corpus_choose(choice_of_bases *z, const corpus *from, const char *const *parts);
/* The certificate of this name, NULL if there is none. */
const base *corpus_find(const corpus *z, const char *name);

/* The whole file as a string (to be freed), NULL if it cannot be read. */
char *read_text(const char *path);
void write_file(const char *path, const char *bytes, size_t length);
/* Appends the right count of lines and the right hash. */
void seal(buffer *z);

/* What the checker answers; status < 0: it died of a signal, or took too long. */
typedef struct {
    int status;
    char out[512], err[512];
} answer;

/* Asks SMOOTHCERT_CHECK about the file `certificate` with the claim of b, but for the valences, and for the scheme of the
   file `scheme` if that is not NULL. */
void ask_checker(answer *z, const base *b, const char *scheme, valence_range k, const char *certificate);

#endif
