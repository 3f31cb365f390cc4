/* t-patch_product.c: products of polynomials against the sum of all products of coefficients, by their definition: on grids the same
   integers, else the same numbers but for rounding.  The whole test computes with affine numbers. */
#define NUMBER_AFFINE

#include "lib/patch_product.h"

#include <math.h>

#include "common.h"
#include "region.h"

enum { PRECISION = 64, ROUNDS = 60, MOST = 45, MOST_PRODUCT = 153 };

/* Of any size from 2^-40 to 2^24, wide or thin; one in four is a constant, one in eight 0. */
static void random_coefficient(number *z)
{
    int kind = (int)random_range(0, 7);
    base_number radius;
    base_init(&radius);
    base_set_double(&z->centre, kind == 7 ? 0 : ldexp(random_unit(), (int)random_range(-40, 24)), PRECISION);
    base_set_double(&z->slope, kind >= 6 ? 0 : ldexp(random_unit(), (int)random_range(-40, 24)), PRECISION);
    base_set_double(&radius, kind >= 4 ? 0 : ldexp(random_unit(), (int)random_range(-60, 24)), PRECISION);
    NUMBER_OP(add_error)(&z->centre, &z->centre, &radius, PRECISION);
    if (kind < 3)
        NUMBER_OP(add_error)(&z->slope, &z->slope, &radius, PRECISION);
    base_clear(&radius);
}

static void define_product(number *z, const number *x, bernstein_shape x_shape, const number *y, bernstein_shape y_shape, bool negative)
{
    bernstein_shape shape = bernstein_shape_product(x_shape, y_shape);
    number product;
    number_init(&product);
    for (int j = 0; j <= x_shape.degree[1]; j++)
        for (int i = 0; i <= bernstein_shape_last(x_shape, j); i++)
            for (int l = 0; l <= y_shape.degree[1]; l++)
                for (int k = 0; k <= bernstein_shape_last(y_shape, l); k++) {
                    number *to = &z[bernstein_shape_index(shape, i + k, j + l)];
                    number_mul(&product, &x[bernstein_shape_index(x_shape, i, j)], &y[bernstein_shape_index(y_shape, k, l)], PRECISION);
                    (negative ? number_sub : number_add)(to, to, &product, PRECISION);
                }
    number_clear(&product);
}

static bool is_same(const base_number *x, const base_number *y)
{
#if defined(NUMBER_GRID)
    return grid_identical(x, y);
#else
    double low = NUMBER_OP(lower_bound)(x), high = NUMBER_OP(upper_bound)(x), error = 0x1p8 + 0x1p-20 * (fabs(low) + fabs(high)); /* errors of balls are short */
    return fabs(low - NUMBER_OP(lower_bound)(y)) <= error && fabs(high - NUMBER_OP(upper_bound)(y)) <= error;
#endif
}

static void test_product(bool triangle)
{
    number *x = number_array_new(MOST), *y = number_array_new(MOST), *z = number_array_new(MOST_PRODUCT), *expected = number_array_new(MOST_PRODUCT);
    MUST(x && y && z && expected);
    test_begin(triangle ? "triangles" : "squares");
    for (int round = 0; round < ROUNDS; round++) {
        int p = (int)random_range(0, 5), q = (int)random_range(0, 5);
        bernstein_shape x_shape = {triangle, {p, triangle ? p : q}}, y_shape = {triangle, {q, triangle ? q : p}}, shape = bernstein_shape_product(x_shape, y_shape);
        bool negative = round % 2;
        for (int i = 0; i < MOST; i++) {
            random_coefficient(&x[i]);
            random_coefficient(&y[i]);
        }
        for (int i = 0; i < bernstein_shape_size(shape); i++) {
            random_coefficient(&z[i]);
            number_set(&expected[i], &z[i]);
        }
        define_product(expected, x, x_shape, y, y_shape, negative);
        MUST(NUMBER_NAME(patch_add_product)(z, x, x_shape, y, y_shape, negative, PRECISION));
        for (int i = 0; i < bernstein_shape_size(shape); i++)
            CHECK(is_same(&z[i].centre, &expected[i].centre) && is_same(&z[i].slope, &expected[i].slope), "degrees %d, %d: coefficient %d", p, q, i);
    }
    test_end();
    number_array_free(x, MOST);
    number_array_free(y, MOST);
    number_array_free(z, MOST_PRODUCT);
    number_array_free(expected, MOST_PRODUCT);
}

static void tests(void)
{
    test_product(false);
    test_product(true);
}

MAIN(tests);
