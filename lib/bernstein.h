/* bernstein.h: where limits are piecewise polynomials, their Bernstein coefficients from the values in a window, exactly.

   The mask of a box spline is 4 times a product of factors (1 + z^d)/2 and a monomial, d one of e1, e2, on triangle meshes also
   e3 = (1,-1); so are the masks of its derivatives.  Loop's is one (each direction twice), and those of Catmull-Clark,
   Doo-Sabin and midpoint subdivision (tensor products of B-splines).  On each element of such a scheme the limit is one
   polynomial, and its coefficients are linear in the values of the element's window.

   Coefficients.  On a triangle with the vertices v0, v1, v2 (element_get_vertex), of degree n: first by the index l of v2, then
   by the index j of v1: coefficient l (n + 1) - l (l - 1)/2 + j belongs to the place ((n-j-l) v0 + j v1 + l v2)/n.  On SQUARE, of
   degrees p and q along e1 and e2: coefficient j (p + 1) + i belongs to (i/p, j/q).  On segments from vertex 0 to vertex 1. */
#ifndef LIB_BERNSTEIN_H
#define LIB_BERNSTEIN_H

#include "element.h"

/* The largest degree in one direction on squares, the largest total degree on triangles (verify/certificate.md, section 7,
   on the degrees of values). */
#define BERNSTEIN_MAX_DEGREE 15

typedef struct {
    int degree[2];                  /* along e1 and e2; on triangles both are the total degree */
    int rows[ELEMENT_TYPES];        /* how many coefficients; 0: no element of the mesh, or a segment on which limits jump */
    int columns[ELEMENT_TYPES];     /* the points of the window, in its order */
    rational *entry[ELEMENT_TYPES]; /* triangles: rows x columns; what a value in the window contributes to a coefficient */
    rational *spline[2];            /* squares: the same along e1 and along e2; see below */
    int labels[ELEMENT_TYPES][2];   /* squares: the window is a rectangle of so many points along e1 and e2 */
} bernstein;

/* On squares values contribute to coefficients by products: if n = degree[d] and the window has the labels 0, 1 ... along
   e_(d+1), then spline[d][(n - label) (n + 1) + i] is the factor of direction d in what a value with that label
   contributes to the coefficient i. */

void bernstein_init(bernstein *z);
void bernstein_clear(bernstein *z);

/* stencil is the mask's (element_stencil_make).  *found = false: the mask is none of a box spline, or its degree is
   too large; z is then 0.  false: no memory. */
BIGFLOAT_MUST_USE bool bernstein_make(bernstein *z, bool *found, mesh_kind mesh, const laurent *mask, const element_stencil *stencil);

/* z = what a value in the window contributes to a coefficient. */
BIGFLOAT_MUST_USE bool bernstein_get(rational *z, const bernstein *b, element_type type, int row, int column);

/* The coefficients of one element, by the exponents (i, j): of the weights of v1 and v2 on triangles, i + j <= degree[0] =
   degree[1]; else of the far ends along e1 and e2.  Segments have one degree, and EDGE has it in the first place. */
typedef struct {
    bool triangle;
    int degree[2];
} bernstein_shape;

bernstein_shape bernstein_get_shape(const bernstein *b, element_type type);
bernstein_shape bernstein_shape_product(bernstein_shape x, bernstein_shape y); /* of two polynomials on one element */
int bernstein_shape_size(bernstein_shape s);
static inline int bernstein_shape_last(bernstein_shape s, int j) { return s.triangle ? s.degree[0] - j : s.degree[0]; } /* the largest i */
static inline int bernstein_shape_index(bernstein_shape s, int i, int j) { return j * (s.degree[0] + 1) - (s.triangle ? j * (j - 1) / 2 : 0) + i; }
/* The binomial coefficients in the Bernstein polynomial (i, j); both degrees at most twice BERNSTEIN_MAX_DEGREE. */
int64_t bernstein_shape_multiplicity(bernstein_shape s, int i, int j);

#endif
