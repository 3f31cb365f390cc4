/* exact_test.h: what the tests of exact eigenvalues share (verify/exact.md).  Compiled once per number system. */
#ifndef VERIFY_EXACT_TEST_H
#define VERIFY_EXACT_TEST_H

#include "tests.h"

#include "../lib/field_matrix.h"

#define exact_enclose NUMBER_NAME(exact_enclose)
#define exact_use_line NUMBER_NAME(exact_use_line)

/* Everything that is known exactly, and the enclosure of the eigenvalue that the blocks share. */
struct exact_state {
    number_field field;
    field_polynomial factor;                /* g */
    int lines;                              /* made so far */
    field_matrix matrix[EXACT_MAX_LINES];   /* M */
    field_polynomial rest[EXACT_MAX_LINES]; /* h, with chi = g(sign x)^multiplicity h */
    number eigenvalue;                      /* lambda, > 0 */
    number *quotient;                       /* of g by x - lambda: g's degree numbers, the last of them 1 */
};

/* z contains the element x of the field. */
void exact_enclose(number *z, const rational *x, const number_field *f, long prec);

/* Puts the eigenvector that the line's column leads to into the analysis, as test_eigenpair would: block, box and no net.  A
   search chooses the column.  OUTCOME_FAIL: no column leads to what is certainly not 0. */
outcome exact_use_line(analysis *a, int line);

#endif
