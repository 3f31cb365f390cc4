/* eigenpair_choice.h: the choices that make the proof of an eigenpair: exact integers, the same for all number
   systems (verify/certificate.md, section 6). */
#ifndef LIB_EIGENPAIR_CHOICE_H
#define LIB_EIGENPAIR_CHOICE_H

#include "../bigfloat/integer.h"

#define EIGENPAIR_INVERSE_BITS 32

typedef struct {
    int n;                  /* order of the real matrix */
    bool complex_form;      /* it stands for a complex matrix of order n / 2 (lib/eigenpair.h) */
    int pivot;              /* the component of the eigenvector that is fixed to 1, from 0; complex form: below n / 2 */
    long grid;              /* approximation, radius and range are in units of 2^-grid */
    integer *approximation; /* n: the other components in order, then the eigenvalue, then its imaginary part */
    integer radius;         /* of the box in every unknown, > 0 */
    integer range;          /* of the box for all matrices of an affine one, >= radius; 0: there is none (lib/eigenpair_affine.h) */
    integer *inverse;       /* n x n preconditioner, row by row, in units of 2^-EIGENPAIR_INVERSE_BITS */
} eigenpair_choice;

void eigenpair_choice_init(eigenpair_choice *z);
BIGFLOAT_MUST_USE bool eigenpair_choice_make(eigenpair_choice *z, int n, long grid); /* all 0, real form */
void eigenpair_choice_clear(eigenpair_choice *z);

/* In complex form: the first component other than the pivot, from 0, whose imaginary part is the largest; -1: there is none. */
int eigenpair_choice_second_pivot(const eigenpair_choice *z);

#endif
