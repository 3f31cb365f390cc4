/* eigenvalues.h: all eigenvalues of a matrix, enclosed in discs, with their multiplicities as far as discs tell.
   Compiled once per number system.

   The matrix is taken apart into the components of its entries that are not 0 (lib/components.h).  In a basis of
   approximate eigenvectors each of them is nearly diagonal (lib/eigenbasis.h).  Gershgorin's theorem, after a diagonal
   scaling, puts the eigenvalues into discs; a union of discs that is disjoint from all others contains as many
   eigenvalues, with multiplicity, as it has discs.  Jordan blocks do no harm: they only make their disc larger.
   lib/eigenvalues.md proves it, rounding included. */
#ifndef LIB_EIGENVALUES_H
#define LIB_EIGENVALUES_H

#include "complex_matrix.h"

#define eigenvalues_enclose NUMBER_NAME(eigenvalues_enclose)
#define eigenvalues_free NUMBER_NAME(eigenvalues_free)

/* Exactly `count` eigenvalues, with multiplicity, lie in the disc. */
typedef struct {
    number re, im; /* centre, thin */
    number radius; /* thin */
    int count;
    bool real;      /* of a real matrix: all of them are real, because there is one, or because the radius is 0 */
    double modulus; /* about */
} eigenvalue_disc;

typedef struct {
    int size;              /* of disc */
    int count;             /* discs in use, disjoint, largest modulus first */
    eigenvalue_disc *disc;
} eigenvalues;

/* b + i imaginary (NULL: real) is n x n.  TRUTH_UNKNOWN: no enclosure found at this precision; TRUTH_FALSE: no memory.
   On any answer eigenvalues_free. */
truth eigenvalues_enclose(eigenvalues *z, const number *b, const number *imaginary, int n, long prec);
void eigenvalues_free(eigenvalues *z);

#endif
