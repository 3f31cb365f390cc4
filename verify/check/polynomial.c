/* Polynomials over a field of cosines: section 4 of exact.md. */

#include "polynomial.h"

#include <string.h>

struct polynomial polynomial_make(int degree)
{
    struct polynomial out = { .degree = degree };

    out.coefficient = allocate((size_t)degree + 1, sizeof out.coefficient[0]);
    for (int i = 0; i <= degree; i++)
        out.coefficient[i] = number_from_whole(i == degree ? 1 : 0);
    return out;
}

/* sum of a_j b_(j stride) over j */
static struct number dot(const struct number *a, const struct number *b, int stride, int size,
                         const struct field *k)
{
    struct mark mark = scratch_mark();
    struct number sum = number_from_whole(0);

    for (int j = 0; j < size; j++)
        number_add_product(&sum, &a[j], &b[j * stride], k);
    number_keep(mark, &sum, 1);
    return sum;
}

/* minus trace(a) / i */
static struct number next_coefficient(const struct number *a, int size, int i,
                                      const struct field *k)
{
    struct number sum = number_from_whole(0);

    for (int j = 0; j < size; j++)
        sum = number_add(&sum, &a[j * size + j]);
    return number_scale(rational_from(-1, i), &sum, k);
}

/* A_1 = M, c_i = -trace(A_i)/i, A_(i+1) = M (A_i + c_i): Faddeev and LeVerrier. */
struct polynomial polynomial_characteristic(const struct exact_matrix *m, const struct field *k)
{
    int n = m->size;
    size_t cells = (size_t)n * (size_t)n;
    struct polynomial out = polynomial_make(n);
    struct number *a = allocate(cells, sizeof a[0]), *new = allocate(cells, sizeof new[0]);

    memcpy(a, m->entry, cells * sizeof a[0]);
    for (int i = 1; i <= n; i++) {
        struct number c = next_coefficient(a, n, i, k);

        out.coefficient[n - i] = c;
        for (int j = 0; j < n; j++)
            a[j * n + j] = number_add(&a[j * n + j], &c);
        for (int row = 0; row < n; row++)
            for (int j = 0; j < n; j++)
                new[row * n + j] = dot(&m->entry[row * n], &a[j], n, n, k);
        memcpy(a, new, cells * sizeof a[0]);
    }
    return out;
}

/* The coefficient of x^i is multiplied by s^(e - i). */
struct polynomial polynomial_turn(const struct polynomial *g, int sign)
{
    struct polynomial out = polynomial_make(g->degree);

    for (int i = 0; i < g->degree; i++)
        out.coefficient[i] = sign < 0 && (g->degree - i) % 2 != 0
                           ? number_minus(&g->coefficient[i]) : g->coefficient[i];
    return out;
}

bool polynomial_divide(struct polynomial *a, const struct polynomial *b, const struct field *k)
{
    struct number *c = a->coefficient;
    int rest = a->degree - b->degree;

    if (rest < 0)
        return false;
    for (int i = rest; i >= 0; i--)
        for (int j = 0; j < b->degree; j++) {      /* c[i + deg b] is the quotient's */
            struct number product = number_mul(&c[i + b->degree], &b->coefficient[j], k);

            c[i + j] = number_sub(&c[i + j], &product);
        }
    for (int i = 0; i < b->degree; i++)
        if (!number_is_zero(&c[i]))
            return false;
    a->coefficient = &c[b->degree];
    a->degree = rest;
    return true;
}

void polynomial_apply(struct number *v, const struct polynomial *p,
                      const struct exact_matrix *m, const struct field *k)
{
    struct mark mark = scratch_mark();
    size_t size = (size_t)m->size;
    struct number *z = allocate(size, sizeof z[0]), *new = allocate(size, sizeof new[0]);

    memcpy(z, v, size * sizeof z[0]);
    for (int power = p->degree - 1; power >= 0; power--) {
        for (size_t i = 0; i < size; i++) {
            struct number term = number_mul(&p->coefficient[power], &v[i], k);

            new[i] = dot(&m->entry[i * size], z, 1, m->size, k);
            new[i] = number_add(&new[i], &term);
        }
        memcpy(z, new, size * sizeof z[0]);
    }
    memcpy(v, z, size * sizeof v[0]);
    number_keep(mark, v, size);
}

interval *polynomial_enclose(const struct polynomial *p, const struct field *k, int g)
{
    interval *out = allocate((size_t)p->degree + 1, sizeof out[0]);

    for (int i = 0; i < p->degree; i++)
        out[i] = number_enclose(&p->coefficient[i], k, g);
    return out;
}
