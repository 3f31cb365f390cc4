/* examine.h: a certificate that somebody has kept, looked at again: read, understood, and followed on grids. */
#ifndef VERIFY_EXAMINE_H
#define VERIFY_EXAMINE_H

#include "analysis.h"
#include "buffer.h"
#include "statement.h"

/* The scheme of certificates, with its regular part: made once for all that have the same text. */
typedef struct {
    scheme scheme;
    problem problem;
    bool made;
} examine_subject;

void examine_subject_init(examine_subject *z);
void examine_subject_clear(examine_subject *z);

typedef struct {
    buffer bytes;
    char digest[65];   /* of the bytes */
    statement claim;
    long line;         /* > 0: where it is wrong, */
    char reason[256];  /*   and how; */
    bool readable;     /* else all of it could be read: the choices are there */
    choices choices;
    outcome followed;  /* OUTCOME_TRUE: the choices prove the claim */
    findings findings; /* of following them */
} examination;

void examination_init(examination *z);
void examination_clear(examination *z);

/* Reads the file.  false: errno says why. */
bool examine_read(examination *z, const char *path);
/* Reads what was read as a certificate, and follows it; limits of time: d, or NULL.  The subject becomes that of its scheme.
   false: no memory.  What is not readable is not followed; certificates of versions before the newest are not readable here, but
   their claim is. */
BIGFLOAT_MUST_USE bool examine(examination *z, examine_subject *s, const deadline *d);

/* The claim as words, with the name of the scheme: "loop is C1 at valence 7". */
void examine_print_claim(char *text, size_t size, const examination *z, const char *name);

/* The radius round L as a decimal that is no smaller: "7.2e-15". */
enum { EXAMINE_RADIUS_TEXT = 32 };
void examine_print_radius(char text[EXAMINE_RADIUS_TEXT], const eigenpair_choice *e);

#endif
