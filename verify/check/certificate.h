#ifndef CHECK_CERTIFICATE_H
#define CHECK_CERTIFICATE_H

/* Certificates
 * ============
 *
 * Section 1 of certificate.md: the file.  Reading checks its form, its limits,
 * its records and its hash; what the choices prove is checked elsewhere.
 * A file that has not exactly the form: rejected.  Beyond a limit: cannot
 * check.
 */

#include "integer.h"

struct certificate {
    const char *file;

    const char *scheme_text;                       /* canonical, it says */
    size_t scheme_size;
    bool claims_c1;
    int valence;                                   /* k */
    int grid;                                      /* g */

    int contraction[3];
    int pivot;                                     /* from 1 on */
    integer eigenvalue;
    int n;                                         /* number of unknowns */
    integer *eigenvector;                          /* n - 1 */
    integer radius;
    integer *inverse;                              /* n x n, row by row */
    int *power;                                    /* 0 .. floor(k/2) */
    int64_t normal[2];
    const char *regularity, *boundary;             /* words over {0,1} */
    size_t regularity_size, boundary_size;

    struct {                                       /* for messages */
        int scheme, claim, valence, grid, contraction, pivot, eigenvalue, radius;
        int power, halfplane, regularity, boundary;
    } line_of;

    const char *text, *end, *next;                 /* still to be read: next */
    int line;                                      /* number of the next line */
};

/* The records up to `grid`: what the certificate is about. */
void certificate_read_subject(struct certificate *out, const char *file,
                              const char *text, size_t size);

/* All other records, for blocks of n unknowns. */
void certificate_read_choices(struct certificate *out, int n);

void certificate_clear(struct certificate *c);

#endif
