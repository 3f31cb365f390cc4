/* spectrum_doubles.c: radii from blocks of intervals, and boxes of them. */
#define NUMBER_INTERVAL
#include "spectrum_doubles.h"

#include "../lib/block.h"
#include "../lib/cover.h"
#include "../lib/eigen_approx.h"

#include <stdlib.h>

struct spectrum_doubles {
    scheme_numbers numbers;
    bool works;     /* directed rounding does */
    int block_size; /* order of a block's real matrix */
};

#define PRECISION 53

static INTERVAL_NOINLINE double radius_in_region(spectrum_doubles *z, long m)
{
    block b;
    diagnostic unused;
    double radius = 0;
    if (block_make(&b, &z->numbers, m, z->numbers.scheme->mirror_symmetric, &unused) == BLOCK_OK) {
        int size;
        number *matrix = block_real_matrix(&size, &b);
        double *a = malloc(((size_t)size * (size_t)size + 1) * sizeof *a);
        z->block_size = size;
        for (int i = 0; matrix && a && i < size * size; i++)
            a[i] = number_mid_approx(&matrix[i]);
        if (matrix && a)
            radius = spectral_radius_approx(a, size);
        number_array_free(matrix, (size_t)size * (size_t)size);
        free(a);
    }
    block_free(&b);
    return radius >= 0 ? radius : 0;
}

static INTERVAL_NOINLINE long below_in_region(spectrum_doubles *z, frequencies m, double bound, long tries)
{
    cover_limits limits = {.tries = tries, .open = 0, .power = 10000};
    cover_answer answer;
    cover_list list;
    diagnostic unused;
    number scale;
    number_set_double(&scale, bound, PRECISION);
    number_inv(&scale, &scale, PRECISION);
    number_upper(&scale, &scale, PRECISION);
    cover_list_init(&list);
    answer = cover_search(&list, &z->numbers, &scale, m, &limits, &unused);
    cover_list_clear(&list);
    if (answer.status != BLOCK_OK)
        return m.first;
    return answer.proved ? m.last + 1 : answer.open.first;
}

static INTERVAL_NOINLINE status make_in_region(spectrum_doubles *z, const scheme *s, long k, diagnostic *d)
{
    return scheme_numbers_make(&z->numbers, s, k, PRECISION, d);
}

/* The rounding mode is set round calls that contain no arithmetic of their own (bigfloat/number.h). */
status spectrum_doubles_make(spectrum_doubles **z, const scheme *s, long k, diagnostic *d)
{
    status result;
    number_mode mode;
    *z = calloc(1, sizeof **z);
    if (!*z)
        return STATUS_NO_MEMORY;
    (*z)->works = interval_self_test();
    mode = number_enter();
    result = make_in_region(*z, s, k, d);
    number_leave(mode);
    return result;
}

void spectrum_doubles_free(spectrum_doubles *z)
{
    if (z)
        scheme_numbers_free(&z->numbers);
    free(z);
}

double spectrum_doubles_radius(spectrum_doubles *z, long m)
{
    number_mode mode = number_enter();
    double radius = radius_in_region(z, m);
    number_leave(mode);
    return radius;
}

int spectrum_doubles_size(const spectrum_doubles *z)
{
    return z->block_size;
}

long spectrum_doubles_below(spectrum_doubles *z, frequencies m, double bound, long tries)
{
    number_mode mode;
    long first = m.first;
    if (!z->works || !(bound > 0))
        return first;
    mode = number_enter();
    first = below_in_region(z, m, bound, tries);
    number_leave(mode);
    return first;
}
