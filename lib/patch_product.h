/* patch_product.h: products of patches' polynomials (lib/patch.h), coefficient by coefficient.  Compiled once per number system.

   The coefficient (i, j) of x y is the sum of all products of a coefficient (k, l) of x and (i - k, j - l) of y. */
#ifndef LIB_PATCH_PRODUCT_H
#define LIB_PATCH_PRODUCT_H

#include "../bigfloat/number.h"
#include "bernstein.h"

/* z += x y (z -= x y, if `negative`), z of the shape bernstein_shape_product(x_shape, y_shape); z is neither x nor y.  false: no
   memory. */
BIGFLOAT_MUST_USE bool NUMBER_NAME(patch_add_product)(number *z, const number *x, bernstein_shape x_shape, const number *y, bernstein_shape y_shape, bool negative, long prec);

#if defined(NUMBER_AFFINE) /* the same of centres, slopes and ranges */
BIGFLOAT_MUST_USE bool BASE_NAME(patch_add_product)(base_number *z, const base_number *x, bernstein_shape x_shape, const base_number *y, bernstein_shape y_shape, bool negative, long prec);
#endif

#endif
