/* patch.h: the polynomials of windows in numbers (verify/certificate.md, section 7, "Coefficients").  Compiled once per number
   system.

   A patch is a homogeneous polynomial in the weights of the vertices: on triangles and segments in those of their vertices, on
   squares in the two weights of each direction.  Its coefficients are Bernstein's times binomial coefficients, so that
   polynomials are multiplied without any; the order is that of lib/bernstein.h. */
#ifndef LIB_PATCH_H
#define LIB_PATCH_H

#include "../bigfloat/number.h"
#include "bernstein.h"

#define patch_numbers_make NUMBER_NAME(patch_numbers_make)
#define patch_numbers_free NUMBER_NAME(patch_numbers_free)
#define patch_coefficients NUMBER_NAME(patch_coefficients)

typedef struct {
    const bernstein *exact;         /* kept by the caller, alive as long as this */
    number *entry[ELEMENT_TYPES];   /* as there, times multiplicities */
    number *spline[2];
} patch_numbers;

/* For segments, or for all other elements.  false: no memory; on either patch_numbers_free. */
bool patch_numbers_make(patch_numbers *z, const bernstein *exact, bool segments, long prec);
void patch_numbers_free(patch_numbers *z);

/* How many numbers patch_coefficients needs as scratch, for any element. */
static inline int patch_scratch(const bernstein *exact) { return (exact->degree[0] + 1) * (exact->degree[1] + 1); }
/* type must be of the kind that z was made for.  c = the coefficients, exact->rows[type] of them, of the polynomial of the values in the window. */
void patch_coefficients(number *c, const patch_numbers *z, element_type type, const number *value, number *scratch, long prec);

#endif
