/* patch_product.c: each coefficient of one polynomial times each row of the other.

   Affine numbers are taken apart before: centres are multiplied by centres, slopes by ranges and ranges by slopes, so that each
   range is computed once, and not for every product that it is a part of. */
#include "patch_product.h"

#if !defined(NUMBER_AFFINE)

bool NUMBER_NAME(patch_add_product)(number *z, const number *x, bernstein_shape x_shape, const number *y, bernstein_shape y_shape, bool negative, long prec)
{
    bernstein_shape shape = bernstein_shape_product(x_shape, y_shape);
    for (int j = 0; j <= x_shape.degree[1]; j++)
        for (int i = 0; i <= bernstein_shape_last(x_shape, j); i++) {
            const number *factor = &x[bernstein_shape_index(x_shape, i, j)];
            if (number_is_zero(factor) == TRUTH_TRUE)
                continue;
            for (int l = 0; l <= y_shape.degree[1]; l++) {
                const number *row = &y[bernstein_shape_index(y_shape, 0, l)];
                number *to = &z[bernstein_shape_index(shape, i, j + l)];
                for (int k = 0; k <= bernstein_shape_last(y_shape, l); k++)
                    (negative ? number_submul : number_addmul)(&to[k], factor, &row[k], prec);
            }
        }
    return true;
}

#else

typedef struct {
    base_number *centre, *slope, *range;
} parts;

static void take_apart(parts *z, base_number *room, const affine *x, int count, long prec)
{
    *z = (parts){room, room + count, room + 2 * count};
    for (int i = 0; i < count; i++) {
        base_set(&z->centre[i], &x[i].centre);
        base_set(&z->slope[i], &x[i].slope);
        affine_range(&z->range[i], &x[i], prec);
    }
}

static void exchange_parts(base_number *centre, base_number *slope, affine *z, int count)
{
    for (int i = 0; i < count; i++) {
        base_swap(&centre[i], &z[i].centre);
        base_swap(&slope[i], &z[i].slope);
    }
}

bool NUMBER_NAME(patch_add_product)(affine *z, const affine *x, bernstein_shape x_shape, const affine *y, bernstein_shape y_shape, bool negative, long prec)
{
    int m = bernstein_shape_size(x_shape), n = bernstein_shape_size(y_shape), count = bernstein_shape_size(bernstein_shape_product(x_shape, y_shape));
    size_t size = 3 * ((size_t)m + (size_t)n) + 2 * (size_t)count;
    base_number *room = base_array_new(size), *centre, *slope;
    parts a, b;
    bool ok;
    if (!room)
        return false;
    take_apart(&a, room, x, m, prec);
    take_apart(&b, room + 3 * m, y, n, prec);
    centre = room + 3 * (m + n);
    slope = centre + count;
    exchange_parts(centre, slope, z, count);
    ok = BASE_NAME(patch_add_product)(centre, a.centre, x_shape, b.centre, y_shape, negative, prec)
         && BASE_NAME(patch_add_product)(slope, a.slope, x_shape, b.range, y_shape, negative, prec)
         && BASE_NAME(patch_add_product)(slope, a.range, x_shape, b.slope, y_shape, negative, prec);
    exchange_parts(centre, slope, z, count);
    base_array_free(room, size);
    return ok;
}

#endif
