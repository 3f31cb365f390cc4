/* matrix.h: random rational matrices whose eigenvalues and eigenvectors are known: P D P^-1 / denominator with whole
   numbers, P of determinant +-1. */
#ifndef TESTS_LIB_MATRIX_H
#define TESTS_LIB_MATRIX_H

#include "tests/bigfloat/random.h"
#include "tests/harness.h"

enum { MATRIX_MAX = 6 };

typedef struct {
    int n;
    long b[MATRIX_MAX][MATRIX_MAX]; /* the matrix, in units of 1 / denominator */
    long p[MATRIX_MAX][MATRIX_MAX];
    long d[MATRIX_MAX][MATRIX_MAX]; /* block diagonal */
    long denominator;
    long square; /* of the spectral radius, in units of 1 / denominator^2 */
} known_matrix;

/* b = p d p^-1: the rows and columns of d change by elementary steps. */
static inline void transform(known_matrix *z, int steps, int fixed)
{
    for (int i = 0; i < z->n; i++)
        for (int j = 0; j < z->n; j++) {
            z->b[i][j] = z->d[i][j];
            z->p[i][j] = i == j;
        }
    for (; steps > 0 && z->n > fixed + 1; steps--) {
        int to = (int)random_range(fixed, z->n - 1), from = (int)random_range(fixed, z->n - 1);
        long c = random_bool() ? 1 : -1;
        if (to == from)
            continue;
        for (int j = 0; j < z->n; j++) /* E b E^-1 and E p, E = 1 + c e_to,from */
            z->b[to][j] += c * z->b[from][j];
        for (int i = 0; i < z->n; i++)
            z->b[i][from] -= c * z->b[i][to];
        for (int j = 0; j < z->n; j++)
            z->p[to][j] += c * z->p[from][j];
    }
}

/* Adds row 0 to the others: if d's first column belongs to an eigenvalue, its eigenvector becomes that of ones. */
static inline void make_ones(known_matrix *z)
{
    for (int to = 1; to < z->n; to++) {
        for (int j = 0; j < z->n; j++)
            z->b[to][j] += z->b[0][j];
        for (int i = 0; i < z->n; i++)
            z->b[i][0] -= z->b[i][to];
        for (int j = 0; j < z->n; j++)
            z->p[to][j] += z->p[0][j];
    }
}

static inline void random_denominator(known_matrix *z)
{
    static const long denominators[] = {1, 64, 97, 1000, 3};
    z->denominator = denominators[random_below(5)];
}

/* Different real eigenvalues d[i][i], of which the first has the largest modulus. */
static inline void random_real_matrix(known_matrix *z, int n)
{
    *z = (known_matrix){.n = n};
    z->d[0][0] = random_range(20, 30) * (random_below(4) ? 1 : -1);
    for (int i = 1; i < n; i++)
        for (bool again = true; again;) {
            z->d[i][i] = random_range(-15, 15);
            again = false;
            for (int j = 0; j < i; j++)
                again = again || z->d[i][i] == z->d[j][j];
        }
    z->square = z->d[0][0] * z->d[0][0];
    random_denominator(z);
    transform(z, 3 * n, 0);
}

/* Fills the diagonal from `first` on with real eigenvalues, Jordan blocks and pairs p +- i q, |.| <= most. */
static inline void random_blocks(known_matrix *z, int first, long most)
{
    for (int i = first; i < z->n; i++) {
        long p = random_range(-most, most), q = random_range(1, most), square = p * p;
        bool two = i + 1 < z->n;
        z->d[i][i] = p;
        switch (random_below(4)) {
        case 0: /* as large a Jordan block as there is place for */
            for (; i + 1 < z->n && random_below(3); i++) {
                z->d[i][i + 1] = 1;
                z->d[i + 1][i + 1] = p;
            }
            break;
        case 1:
            if (two && p * p + q * q <= most * most) {
                z->d[i][i + 1] = -q;
                z->d[i + 1][i] = q;
                z->d[i + 1][i + 1] = p;
                square += q * q;
                i++;
            }
            break;
        default:
            break;
        }
        z->square = square > z->square ? square : z->square;
    }
}

static inline void random_general_matrix(known_matrix *z, int n)
{
    *z = (known_matrix){.n = n};
    random_blocks(z, 0, 9);
    random_denominator(z);
    transform(z, random_bool() ? n : 3 * n, 0);
}

/* The trace of (d / denominator)^power; the blocks before `from` do not count. */
static inline void trace_of_power(rational *z, const known_matrix *m, int from, int power)
{
    long now[MATRIX_MAX][MATRIX_MAX], next[MATRIX_MAX][MATRIX_MAX], trace = 0;
    rational q;
    rational_init(&q);
    for (int i = 0; i < m->n; i++)
        for (int j = 0; j < m->n; j++)
            now[i][j] = i == j;
    for (int p = 0; p < power; p++) {
        for (int i = 0; i < m->n; i++)
            for (int j = 0; j < m->n; j++) {
                next[i][j] = 0;
                for (int l = 0; l < m->n; l++)
                    next[i][j] += now[i][l] * m->d[l][j];
            }
        for (int i = 0; i < m->n; i++)
            for (int j = 0; j < m->n; j++)
                now[i][j] = next[i][j];
    }
    for (int i = from; i < m->n; i++)
        trace += now[i][i];
    MUST(rational_set_si(z, trace, 1));
    MUST(rational_set_si(&q, m->denominator, 1));
    MUST(rational_pow(&q, &q, -power));
    MUST(rational_mul(z, z, &q));
    rational_clear(&q);
}

#ifdef BIGFLOAT_NUMBER_H
static inline number *matrix_numbers(const known_matrix *m, long prec)
{
    number *z = number_array_new((size_t)(m->n * m->n));
    rational q;
    rational_init(&q);
    for (int i = 0; i < m->n; i++)
        for (int j = 0; j < m->n; j++) {
            MUST(rational_set_si(&q, m->b[i][j], m->denominator));
            number_set_rational(&z[i * m->n + j], &q, prec);
        }
    rational_clear(&q);
    return z;
}
#endif

#endif
