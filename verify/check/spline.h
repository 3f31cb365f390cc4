#ifndef CHECK_SPLINE_H
#define CHECK_SPLINE_H

/* Limits that are polynomials on elements: section 7 of certificate.md, "Coefficients". */

#include "element.h"
#include "sector.h"

/* a(z) = 4 z^c times the product of ((1 + z^e_i)/2)^m_i */
struct spline {
    int m[3];
    struct label c;
    struct pieces *pieces;                         /* triangles: those that are known, for all m */
};

/* Whether the mask is of a box spline, of a size that is allowed. */
bool spline_find(struct spline *out, const struct mask *mask, enum mesh mesh);

/* That of q_1 (direction 0) or q_2 (direction 1). */
struct spline spline_derivative(const struct spline *s, int direction);

/* The polynomials that the labels of a window contribute to an element, on the grid.  A homogeneous
 * polynomial in w0, w1, w2 of degree D has its coefficient of w0^(D-i-j) w1^i w2^j at (i,j), one in
 * s, t and s', t' that of s^. t^i s'^. t'^j.  sides: how many i and j there are. */
struct basis {
    bool triangular;
    int side_a, side_b;
    interval *polynomial;                          /* triangles: by label, (i,j) */
    interval *along_a, *along_b;                   /* quads: by y1 and i, y2 and j */
};

/* False if the degree is negative. */
bool basis_make(struct basis *out, const struct spline *s, enum element_kind kind,
                enum mesh mesh, const struct window *window, int g);

/* Is (i,j) a monomial of the basis' degree that does not vanish on the element? */
bool basis_has(const struct basis *b, enum element_kind kind, int i, int j);

/* The net's coefficients (i,j), row by row, from its values on the window. */
struct pair *basis_coefficients(const struct basis *b, const struct window *window,
                                const struct pair *value, int g);

#endif
