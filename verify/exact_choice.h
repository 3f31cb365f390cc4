/* exact_choice.h: what a certificate says of eigenvalues that are equal to something (verify/exact.md, section 1). */
#ifndef VERIFY_EXACT_CHOICE_H
#define VERIFY_EXACT_CHOICE_H

#include "../bigfloat/rational.h"

enum { EXACT_MAX_FACTOR = 64, EXACT_MAX_LINES = 64, EXACT_MAX_POWER = 10000 };

/* A block that is known exactly: its characteristic polynomial has the factor g(sign x) `multiplicity` times, and its
   Jordan blocks there have at most `size` rows. */
typedef struct {
    long frequency;
    int sign;
    int multiplicity, size;
    int column; /* of the unit vector that leads to an eigenvector, from 1; 0: none is needed */
    int power;  /* with which the other eigenvalues contract */
} exact_line;

typedef struct {
    long n;                  /* of the field Q(2 cos(pi/n)) */
    int field_degree;
    int degree;              /* of g, monic; 0: there is none, the eigenvalue is 1 or -1 */
    rational *coefficient;   /* of x^0 .. x^(degree-1), field_degree numbers each; NULL if there are none */
    integer eigenvalue, radius; /* |L| lies within radius of it, in units of the grid */
    double low, high;        /* where a search may begin */
    int others;              /* the power with which g's other roots contract */
    int count;
    exact_line line[EXACT_MAX_LINES]; /* by rising frequency */
} exact_choice;

void exact_choice_init(exact_choice *z);
void exact_choice_clear(exact_choice *z);
/* Room for g; false: no memory. */
BIGFLOAT_MUST_USE bool exact_choice_make_factor(exact_choice *z, int degree, int field_degree);
BIGFLOAT_MUST_USE bool exact_choice_set(exact_choice *z, const exact_choice *x);

#endif
