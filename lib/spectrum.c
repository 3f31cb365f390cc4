/* spectrum.c: rho(C)^(2^p) <= |C^(2^p)| in the maximum norm. */
#include "spectrum.h"

#include "matrix_row.h"
#include "stop.h"

#include <math.h>
#include <stdlib.h>

void matrix_deflate(number *z, const number *b, const number *x, int n, int pivot, long prec)
{
    int row = 0;
    for (int i = 0; i < n; i++) {
        if (i == pivot)
            continue;
        for (int j = 0, column = 0; j < n; j++) {
            number *entry = &z[row * (n - 1) + column];
            if (j == pivot)
                continue;
            number_set(entry, &b[i * n + j]);
            if (x)
                number_submul(entry, &x[i], &b[pivot * n + j], prec);
            else
                number_sub(entry, entry, &b[pivot * n + j], prec);
            column++;
        }
        row++;
    }
}

/* b - x (row p of b) - J x (row p + h of b): with x_i = y + i w row i is b_i - y b_p + w b_(p+h), and row i + h is
   b_(i+h) - w b_p - y b_(p+h). */
void matrix_deflate_complex(number *z, const number *b, const number *x, int n, int pivot, long prec)
{
    int h = n / 2, next = 0;
    const number *first = &b[pivot * n], *second = &b[(pivot + h) * n];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            number *entry = &z[next];
            if (i % h == pivot || j % h == pivot)
                continue;
            number_set(entry, &b[i * n + j]);
            number_submul(entry, &x[i], &first[j], prec);
            if (i < h)
                number_addmul(entry, &x[i + h], &second[j], prec);
            else
                number_submul(entry, &x[i - h], &second[j], prec);
            next++;
        }
}

/* The plane of x has the basis f, g with f_pivot = g_second = 1, f_second = g_pivot = 0, and w - w_pivot f - w_second g stands for w
   modulo the plane. */
void matrix_deflate_pair(number *z, const number *b, const number *x, int n, int pivot, int second, long prec)
{
    int h = n / 2, next = 0;
    number f, g;
    number_init(&f);
    number_init(&g);
    for (int i = 0; i < h; i++) {
        if (i == pivot || i == second)
            continue;
        number_div(&g, &x[i + h], &x[second + h], prec);
        number_set(&f, &x[i]);
        number_submul(&f, &x[second], &g, prec);
        for (int j = 0; j < h; j++) {
            if (j == pivot || j == second)
                continue;
            number_set(&z[next], &b[i * n + j]);
            number_submul(&z[next], &f, &b[pivot * n + j], prec);
            number_submul(&z[next], &g, &b[second * n + j], prec);
            next++;
        }
    }
    number_clear(&f);
    number_clear(&g);
}

/* false: there was no time. */
static bool square(number *z, const number *c, int n, long prec)
{
    for (int i = 0; i < n * n; i++)
        number_zero(&z[i]);
    for (int i = 0; i < n; i++) {
        matrix_add_row(&z[i * n], &c[i * n], c, n, false, prec);
        if (stop_now())
            return false;
    }
    return true;
}

/* norm = the largest row sum of magnitudes.  Returns the largest magnitude that is certainly attained, roughly: the
   distance of an entry from 0. */
static double row_norm(number *norm, const number *c, int n, long prec)
{
    double attained = 0;
    number sum, magnitude;
    number_init(&sum);
    number_init(&magnitude);
    number_zero(norm);
    for (int i = 0; i < n; i++) {
        number_zero(&sum);
        for (int j = 0; j < n; j++) {
            double low = number_lower_bound(&c[i * n + j]), high = number_upper_bound(&c[i * n + j]);
            number_magnitude_upper(&magnitude, &c[i * n + j], prec);
            number_add(&sum, &sum, &magnitude, prec);
            attained = low > attained ? low : -high > attained ? -high : attained;
        }
        number_max(norm, norm, &sum, prec);
    }
    number_clear(&sum);
    number_clear(&magnitude);
    return attained;
}

/* At least the 2^p-th root of x.  A square root is rounded by less than 2^-51 of it, in whatever mode. */
static double root_upper(double x, int p)
{
    for (; p > 0 && x != 1; p--)
        x = sqrt(x) * (1 + 0x1p-50);
    return x;
}

/* Beyond this an entry has grown too much: see certificate.md, section 6.  If it does so within few squarings (of
   prec / 2: growth by 2^32 then means a ratio of 1 + 2^(5 - prec/2) at least), rounding is not the reason. */
#define DIVERGED 0x1p64

spectral_answer spectral_contraction(const number *b, const number *scale, int n, int least, int limit, long prec)
{
    spectral_answer answer = {TRUTH_FALSE, 0, false, INFINITY};
    size_t size = (size_t)n * (size_t)n;
    number *c = number_array_new(size), *d = number_array_new(size);
    number norm, one;
    number_init(&norm);
    number_init(&one);
    number_one(&one);
    if (c && d) {
        answer.contracts = TRUTH_UNKNOWN;
        for (size_t i = 0; i < size; i++)
            number_mul(&c[i], &b[i], scale, prec);
        for (;; answer.power++) {
            double attained = row_norm(&norm, c, n, prec), bound = number_upper_bound(&norm);
            answer.radius = fmin(answer.radius, root_upper(bound, answer.power));
            answer.diverges = attained > DIVERGED / 0x1p32 && answer.power <= prec / 2;
            if (answer.power >= least && number_less(&norm, &one) == TRUTH_TRUE)
                answer.contracts = TRUTH_TRUE;
            if (answer.contracts == TRUTH_TRUE || answer.power == limit || !(bound < DIVERGED) || !square(d, c, n, prec))
                break;
            number *t = c;
            c = d;
            d = t;
        }
        if (number_lacks_memory(&norm))
            answer.contracts = TRUTH_FALSE;
    }
    if (c)
        number_array_free(c, size);
    if (d)
        number_array_free(d, size);
    number_clear(&norm);
    number_clear(&one);
    return answer;
}

/* |C^(2^p)|^(1/2^p) falls towards the spectral radius: after so many squarings most of what is left of a factor 100 in
   the norm is half a percent. */
#define SHARP_POWER 10

spectral_answer spectral_contraction_sharp(const number *b, const number *scale, int n, int limit, long prec)
{
    spectral_answer answer = spectral_contraction(b, scale, n, 0, limit, prec);
    if (answer.contracts == TRUTH_TRUE && answer.power < SHARP_POWER)
        answer.radius = fmin(answer.radius, spectral_contraction(b, scale, n, SHARP_POWER, SHARP_POWER, prec).radius);
    return answer;
}
