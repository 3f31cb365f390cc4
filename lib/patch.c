/* patch.c: sums over windows; on squares along e1 first, then along e2. */
#include "patch.h"

#include <string.h>

static size_t entry_count(const bernstein *b, int type)
{
    return (size_t)b->rows[type] * (size_t)b->columns[type];
}

static size_t spline_count(const bernstein *b, int d)
{
    return (size_t)(b->degree[d] + 1) * (size_t)(b->degree[d] + 1);
}

/* z, which is 0 = exact times a multiplicity. */
static bool set_entry(number *z, const rational *exact, const rational *multiplicity, rational *scratch, long prec)
{
    if (rational_is_zero(exact))
        return true;
    if (!rational_mul(scratch, multiplicity, exact))
        return false;
    number_set_rational(z, scratch, prec);
    return !number_lacks_memory(z);
}

static bool make_entry(patch_numbers *z, element_type type, rational scratch[2], long prec)
{
    const bernstein *b = z->exact;
    bernstein_shape s = bernstein_get_shape(b, type);
    bool ok = (z->entry[type] = number_array_new(entry_count(b, type))) != NULL;
    for (int j = 0; ok && j <= s.degree[1]; j++)
        for (int i = 0; ok && i <= bernstein_shape_last(s, j); i++) {
            int row = bernstein_shape_index(s, i, j) * b->columns[type];
            ok = rational_set_si(&scratch[1], bernstein_shape_multiplicity(s, i, j), 1);
            for (int y = row; ok && y < row + b->columns[type]; y++)
                ok = set_entry(&z->entry[type][y], &b->entry[type][y], &scratch[1], &scratch[0], prec);
        }
    return ok;
}

static bool make_spline(patch_numbers *z, int d, rational scratch[2], long prec)
{
    int n = z->exact->degree[d];
    bernstein_shape s = {false, {n, 0}};
    bool ok = (z->spline[d] = number_array_new(spline_count(z->exact, d))) != NULL;
    for (int i = 0; ok && i <= n; i++) {
        ok = rational_set_si(&scratch[1], bernstein_shape_multiplicity(s, i, 0), 1);
        for (int l = 0; ok && l <= n; l++)
            ok = set_entry(&z->spline[d][l * (n + 1) + i], &z->exact->spline[d][l * (n + 1) + i], &scratch[1], &scratch[0], prec);
    }
    return ok;
}

bool patch_numbers_make(patch_numbers *z, const bernstein *exact, bool segments, long prec)
{
    bool ok = true;
    rational scratch[2];
    memset(z, 0, sizeof *z);
    z->exact = exact;
    for (int i = 0; i < 2; i++)
        rational_init(&scratch[i]);
    for (int t = 0; ok && t < ELEMENT_TYPES; t++)
        if (exact->entry[t] && element_is_segment((element_type)t) == segments)
            ok = make_entry(z, (element_type)t, scratch, prec);
    for (int d = 0; ok && d < 2; d++)
        if (exact->spline[d])
            ok = make_spline(z, d, scratch, prec);
    for (int i = 0; i < 2; i++)
        rational_clear(&scratch[i]);
    return ok;
}

void patch_numbers_free(patch_numbers *z)
{
    for (int t = 0; t < ELEMENT_TYPES; t++)
        if (z->entry[t])
            number_array_free(z->entry[t], entry_count(z->exact, t));
    for (int d = 0; d < 2; d++)
        if (z->spline[d])
            number_array_free(z->spline[d], spline_count(z->exact, d));
    memset(z, 0, sizeof *z);
}

/* z = sum of count products. */
static void sum_products(number *z, const number *x, int x_step, const number *y, int y_step, int count, long prec)
{
    number_zero(z);
    for (int i = 0; i < count; i++)
        number_addmul(z, &x[i * x_step], &y[i * y_step], prec);
}

/* The label 0 has the last piece of a spline, so factors are read backwards. */
static void square_coefficients(number *c, const patch_numbers *z, element_type type, const number *value, number *scratch, long prec)
{
    const bernstein *b = z->exact;
    int p = b->degree[0], q = b->degree[1], along = b->labels[type][0], across = b->labels[type][1];
    int rows = type == ELEMENT_ALONG_SECOND ? 1 : p + 1, columns = type == ELEMENT_ALONG_FIRST ? 1 : q + 1;
    for (int i = 0; i < rows; i++)
        for (int y = 0; y < across; y++)
            sum_products(&scratch[i * across + y], &z->spline[0][p * (p + 1) + i], -(p + 1), &value[y], across, along, prec);
    for (int j = 0; j < columns; j++)
        for (int i = 0; i < rows; i++)
            sum_products(&c[j * rows + i], &z->spline[1][q * (q + 1) + j], -(q + 1), &scratch[i * across], 1, across, prec);
}

void patch_coefficients(number *c, const patch_numbers *z, element_type type, const number *value, number *scratch, long prec)
{
    const bernstein *b = z->exact;
    if (b->spline[0]) {
        square_coefficients(c, z, type, value, scratch, prec);
        return;
    }
    for (int row = 0; row < b->rows[type]; row++)
        sum_products(&c[row], &z->entry[type][row * b->columns[type]], 1, value, 1, b->columns[type], prec);
}
