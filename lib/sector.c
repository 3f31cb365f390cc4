/* sector.c: leaving the sector costs a twist; subdivision is the scheme's own mask. */
#include "sector.h"

#include <string.h>

void pair_matrix_init(pair_matrix *z)
{
    number_init(&z->xx);
    number_init(&z->xy);
    number_init(&z->yx);
    number_init(&z->yy);
}

void pair_matrix_clear(pair_matrix *z)
{
    number_clear(&z->xx);
    number_clear(&z->xy);
    number_clear(&z->yx);
    number_clear(&z->yy);
}

void pair_matrix_apply(number *x, number *y, const pair_matrix *t, long prec)
{
    number p, q;
    number_init(&p);
    number_init(&q);
    number_mul(&p, &t->xx, x, prec);
    number_addmul(&p, &t->xy, y, prec);
    number_mul(&q, &t->yx, x, prec);
    number_addmul(&q, &t->yy, y, prec);
    number_swap(x, &p);
    number_swap(y, &q);
    number_clear(&p);
    number_clear(&q);
}

/* z = s t (t first), column by column. */
void pair_matrix_multiply(pair_matrix *z, const pair_matrix *s, const pair_matrix *t, long prec)
{
    pair_matrix w;
    pair_matrix_init(&w);
    number_set(&w.xx, &t->xx);
    number_set(&w.yx, &t->yx);
    number_set(&w.xy, &t->xy);
    number_set(&w.yy, &t->yy);
    pair_matrix_apply(&w.xx, &w.yx, s, prec);
    pair_matrix_apply(&w.xy, &w.yy, s, prec);
    pair_matrix_clear(z);
    *z = w;
}

void twist_init(twist *t)
{
    t->complex_form = false;
    number_init(&t->u);
    pair_matrix_init(&t->forth);
    pair_matrix_init(&t->back);
}

void twist_clear(twist *t)
{
    number_clear(&t->u);
    pair_matrix_clear(&t->forth);
    pair_matrix_clear(&t->back);
}

/* forth = (c, -n; v, c), of determinant 1, so back = (c, n; -v, c). */
static void set_matrices(twist *t, const number *c, const number *n, const number *v)
{
    number_set(&t->forth.xx, c);
    number_neg(&t->forth.xy, n);
    number_set(&t->forth.yx, v);
    number_set(&t->forth.yy, c);
    number_set(&t->back.xx, c);
    number_set(&t->back.xy, n);
    number_neg(&t->back.yx, v);
    number_set(&t->back.yy, c);
}

/* In the real form v = 2u, c = cos w = v u - 1, n = 2 sin^2(w/2) u = v (1 - u u). */
bool twist_set_u(twist *t, const number *u, long prec)
{
    bool ok;
    number one, v, c, n;
    number_init(&one);
    number_init(&v);
    number_init(&c);
    number_init(&n);
    number_one(&one);
    number_set(&t->u, u);
    number_add(&v, &t->u, &t->u, prec);
    number_mul(&c, &v, &t->u, prec);
    number_sub(&c, &c, &one, prec);
    number_mul(&n, &t->u, &t->u, prec);
    number_sub(&n, &one, &n, prec);
    number_mul(&n, &v, &n, prec);
    set_matrices(t, &c, &n, &v);
    t->complex_form = false;
    ok = !number_lacks_memory(&n);
    number_clear(&one);
    number_clear(&v);
    number_clear(&c);
    number_clear(&n);
    return ok;
}

typedef void function_of_angle(number *z, const rational *r, long prec);

/* z contains f(pi turns m / k) for the first and the last m, and all numbers between. */
static bool hull_of_ends(number *z, function_of_angle *f, int turns, frequencies m, long k, long prec)
{
    bool ok;
    rational angle;
    number other;
    rational_init(&angle);
    number_init(&other);
    ok = rational_set_si(&angle, m.first, k) && rational_mul_2exp(&angle, &angle, turns - 1);
    if (ok)
        f(z, &angle, prec);
    if (ok && m.first != m.last) {
        ok = rational_set_si(&angle, m.last, k) && rational_mul_2exp(&angle, &angle, turns - 1);
        f(&other, &angle, prec);
        number_hull(z, z, &other, prec);
    }
    rational_clear(&angle);
    number_clear(&other);
    return ok && !number_lacks_memory(z);
}

/* The cosine falls on [0, pi/2]. */
bool twist_set_real_range(twist *t, frequencies m, long k, long prec)
{
    bool ok;
    number u;
    number_init(&u);
    ok = hull_of_ends(&u, number_cos_pi, 1, m, k, prec) && twist_set_u(t, &u, prec);
    number_clear(&u);
    return ok;
}

/* The cosine falls on [0, pi]; the sine is 1 at w = pi/2. */
bool twist_set_complex_range(twist *t, frequencies m, long k, long prec)
{
    bool ok;
    number c, s, one;
    number_init(&c);
    number_init(&s);
    number_init(&one);
    number_one(&one);
    ok = hull_of_ends(&c, number_cos_pi, 2, m, k, prec) && hull_of_ends(&s, number_sin_pi, 2, m, k, prec);
    if (ok) {
        if (m.first < k - 3 * m.first && m.last > k - 3 * m.last) /* 4 first < k < 4 last */
            number_hull(&s, &s, &one, prec);
        set_matrices(t, &c, &s, &s);
        t->complex_form = true;
        ok = !number_lacks_memory(&s);
    }
    number_clear(&c);
    number_clear(&s);
    number_clear(&one);
    return ok;
}

void twist_apply(number *x, number *y, const twist *t, int turns, long prec)
{
    for (; turns > 0; turns--)
        pair_matrix_apply(x, y, &t->forth, prec);
    for (; turns < 0; turns++)
        pair_matrix_apply(x, y, &t->back, prec);
}

bool mask_numbers_make(mask_numbers *z, const laurent *mask, long prec)
{
    rational weight;
    bool ok = true;
    z->mask = mask;
    z->weight = number_array_new((size_t)(mask->na * mask->nb));
    rational_init(&weight);
    for (long i = 0; ok && z->weight && i < mask->na * mask->nb; i++) {
        ok = rational_set_integers(&weight, &mask->coefficient[i], &mask->denominator);
        if (ok)
            number_set_rational(&z->weight[i], &weight, prec);
    }
    rational_clear(&weight);
    return ok && z->weight;
}

void mask_numbers_free(mask_numbers *z)
{
    if (z->weight)
        number_array_free(z->weight, (size_t)(z->mask->na * z->mask->nb));
    z->weight = NULL;
}

bool sector_net_make(sector_net *z, mesh_kind mesh, bool regular, int rings, const twist *t)
{
    z->mesh = mesh;
    z->regular = regular;
    z->rings = rings;
    z->twist = t;
    number_init(&z->centre);
    number_init(&z->centre_y);
    z->x = number_array_new((size_t)sector_size(rings));
    z->y = number_array_new((size_t)sector_size(rings));
    return z->x && z->y;
}

void sector_net_free(sector_net *z)
{
    number_clear(&z->centre);
    number_clear(&z->centre_y);
    if (z->x)
        number_array_free(z->x, (size_t)sector_size(z->rings));
    if (z->y)
        number_array_free(z->y, (size_t)sector_size(z->rings));
    z->x = z->y = NULL;
}

/* Of unit nets most values are, and 0 need not be multiplied. */
static bool is_zero_pair(const number *x, const number *y)
{
    return number_is_zero(x) == TRUTH_TRUE && number_is_zero(y) == TRUTH_TRUE;
}

sector_status sector_value(number *x, number *y, const sector_net *z, int a, int b, long prec)
{
    int turns;
    if (mesh_is_centre(z->mesh, a, b)) {
        number_set(x, &z->centre);
        number_set(y, &z->centre_y);
        return SECTOR_OK;
    }
    if (!mesh_reduce(z->mesh, z->regular, &a, &b, &turns))
        return SECTOR_OPPOSITE;
    if (mesh_ring(z->mesh, a, b) > z->rings)
        return SECTOR_OUTSIDE;
    number_set(x, &z->x[sector_index(z, a, b)]);
    number_set(y, &z->y[sector_index(z, a, b)]);
    if (z->twist && turns && !is_zero_pair(x, y))
        twist_apply(x, y, z->twist, turns, prec);
    return SECTOR_OK;
}

/* The least number >= low that differs from a by a multiple of dilation. */
static long first_congruent(long low, long a, long dilation)
{
    long rest = (a - low) % dilation;
    return low + (rest < 0 ? rest + dilation : rest);
}

/* The points p that contribute are those with (a,b) - dilation p in the mask's box. */
sector_status sector_masked_value(number *x, number *y, const sector_net *z, const mask_numbers *mask, int dilation, int a, int b, long prec)
{
    const laurent *terms = mask->mask;
    sector_status s = SECTOR_OK;
    number p, q;
    number_init(&p);
    number_init(&q);
    number_zero(x);
    number_zero(y);
    for (long i = first_congruent(terms->a0, a, dilation); s == SECTOR_OK && i < terms->a0 + terms->na; i += dilation)
        for (long j = first_congruent(terms->b0, b, dilation); s == SECTOR_OK && j < terms->b0 + terms->nb; j += dilation) {
            if (laurent_is_zero_at(terms, i, j))
                continue;
            s = sector_value(&p, &q, z, (int)(a - i) / dilation, (int)(b - j) / dilation, prec);
            if (s != SECTOR_OK || is_zero_pair(&p, &q))
                continue;
            number_addmul(x, mask_numbers_at(mask, i, j), &p, prec);
            if (number_is_zero(&q) != TRUTH_TRUE)
                number_addmul(y, mask_numbers_at(mask, i, j), &q, prec);
        }
    number_clear(&p);
    number_clear(&q);
    return s;
}
