#ifndef CHECK_CHECK_H
#define CHECK_CHECK_H

/* The check of a certificate: sections 3 to 10 of certificate.md, and exact.md. */

#include "scheme.h"

/* What is claimed: the reader's scheme. */
struct statement;

/* --set NAME=VALUE, of one line */
struct setting {
    const char *name, *value;
};

struct statement *statement_new(const char *scheme_file, const struct setting *settings,
                                int setting_count, bool not_c1);

struct verified {
    bool plainly_regular, real;
    bool exact;                                    /* L is 1 or -1 */
    int64_t unit;                                  /* q and d, if it is |L| (q/k)^d */
    int degree;
    int64_t frequency;                             /* m; -1: a window of frequencies */
    interval eigenvalue;                           /* L or |L|, on the grid g */
    int g;
};

/* Verifies that the certificate in the file proves the scheme C1 (or not C1) at the
 * valences k: returns only if everything is proved. */
struct verified check_certificate(struct statement *s, struct span k, const char *file);

/* The valences that the certificate says it is about: nothing is proved by that. */
struct span check_valences(const char *file);

/* The name of the scheme, once a certificate has been checked. */
const char *statement_scheme_name(const struct statement *s);

#endif
