/* prove_options.h: what the command line of `prove` says. */
#ifndef VERIFY_PROVE_OPTIONS_H
#define VERIFY_PROVE_OPTIONS_H

#include "command_scheme.h"
#include "escalate.h"

typedef struct {
    scheme_options scheme;
    const char *list; /* of valences */
    const char *out;  /* NULL: prove_options_archive says where */
    limits limits;    /* but for what belongs to the uniform method */
    long jobs;
    bool uniform;
    bool each;
    bool json;
} prove_options;

/* -1: go on; else the exit status, and all is said. */
int prove_options_read(prove_options *z, int argc, char **argv);

/* The directory where the evidence goes, if the user names none: another scheme, method or precision needs another one. */
enum { PROVE_ARCHIVE_NAME = SCHEME_NAME_MAX + 160 };
void prove_options_archive(char name[PROVE_ARCHIVE_NAME], const prove_options *o, const char *scheme_name);

#endif
