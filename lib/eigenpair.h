/* eigenpair.h: one simple eigenvalue of a block and its eigenvector, found in doubles and proved by a Krawczyk step
   (verify/certificate.md, section 6).  Compiled once per number system.

   Real form: b is an n x n matrix, the eigenvalue is real; box has the n components of x, then the eigenvalue.
   Complex form: b is the real matrix (R, -I; I, R) of a complex matrix B = R + i I of order h = n/2.  Real vectors z of
   n components stand for the complex z_j + i z_(j+h); multiplication by i is J z = (-z_(j+h); z_j), and b J = J b.  box has
   z (z_pivot = 1, z_(pivot+h) = 0), then real and imaginary part of the eigenvalue: n + 2 numbers.

   Why the proof is the same: the n equations b z - alpha z - beta J z = 0 in the n - 2 free components and alpha, beta
   say B x = lambda x, x_pivot = 1.  If the Krawczyk operator maps the box strictly into itself there is exactly one
   zero in it, and the derivative there is non-singular.  The derivative is (y, mu) -> (B - lambda) y - mu x from y
   with y_pivot = 0 and complex mu.  Were lambda not algebraically simple, (B - lambda) y = c x would have a solution with y no
   multiple of x and c = 0 or 1 (a second eigenvector, or a Jordan chain); then y - y_pivot x and c would be in its kernel,
   and not both 0.  So lambda is simple.  All this holds for every B whose b is in the enclosure. */
#ifndef LIB_EIGENPAIR_H
#define LIB_EIGENPAIR_H

#include "../bigfloat/number.h"
#include "eigenpair_choice.h"

#define eigenpair_choose NUMBER_NAME(eigenpair_choose)
#define eigenpair_choose_radius NUMBER_NAME(eigenpair_choose_radius)
#define eigenpair_choose_range NUMBER_NAME(eigenpair_choose_range)
#define eigenpair_prove NUMBER_NAME(eigenpair_prove)
#define eigenpair_prove_range NUMBER_NAME(eigenpair_prove_range)
#define eigenpair_modulus NUMBER_NAME(eigenpair_modulus)

/* Looks for the dominant eigenpair (largest modulus) of the n x n matrix b and for a box round it that eigenpair_prove
   accepts, both on the grid 2^-g.  In complex form, of a real matrix R (I = 0), it may be one of a pair.
   TRUTH_UNKNOWN: not found, or more than one eigenvalue seems to have the largest modulus.  TRUTH_FALSE: no memory. */
truth eigenpair_choose(eigenpair_choice *z, const number *b, int n, bool complex_form, long g, long prec);

/* How many numbers a box has: choice->n + 1 or + 2. */
static inline size_t eigenpair_box_size(int n, bool complex_form) { return (size_t)n + 1 + complex_form; }

/* TRUTH_TRUE proves, for every matrix in the enclosure b (in complex form: every one of the shape above): the box holds
   exactly one pair (x, eigenvalue) with b x = eigenvalue x and x_pivot = 1, and the eigenvalue is algebraically simple.
   box receives enclosures of them, in the order above.  TRUTH_UNKNOWN: not proved, and box is no enclosure of anything.
   TRUTH_FALSE: no memory. */
truth eigenpair_prove(number *box, const eigenpair_choice *choice, const number *b, long prec);

/* The same with the radius choice->range. */
truth eigenpair_prove_range(number *box, const eigenpair_choice *choice, const number *b, long prec);

/* Where eigenpair_choose has found approximations and no radius, for b is wide: looks for a radius in smaller steps.  The answers
   are the same. */
truth eigenpair_choose_radius(eigenpair_choice *z, const number *b, long prec);

/* Looks for a z->range, not much larger than need be and z->radius at least, with which eigenpair_prove_range accepts b, a
   wider matrix than the choice was made for.  The answers are those of eigenpair_choose. */
truth eigenpair_choose_range(eigenpair_choice *z, const number *b, long prec);

/* z encloses the modulus of the eigenvalue in a box for matrices of order n. */
void eigenpair_modulus(number *z, const number *box, int n, bool complex_form, long prec);

#endif
