/* sector.c: leaving the sector costs a twist; subdivision is the scheme's own mask. */
#include "sector.h"

void twist_init(twist *t)
{
    number_init(&t->u);
    number_init(&t->v);
    number_init(&t->c);
    number_init(&t->n);
}

void twist_clear(twist *t)
{
    number_clear(&t->u);
    number_clear(&t->v);
    number_clear(&t->c);
    number_clear(&t->n);
}

bool twist_set(twist *t, long m, long k, long prec)
{
    bool ok;
    rational angle;
    number one;
    rational_init(&angle);
    number_init(&one);
    number_one(&one);
    ok = rational_set_si(&angle, m, k);
    if (ok) {
        number_cos_pi(&t->u, &angle, prec);
        number_add(&t->v, &t->u, &t->u, prec);
        number_mul(&t->c, &t->v, &t->u, prec);
        number_sub(&t->c, &t->c, &one, prec);
        number_mul(&t->n, &t->u, &t->u, prec);
        number_sub(&t->n, &one, &t->n, prec);
        number_mul(&t->n, &t->v, &t->n, prec);
        ok = !number_lacks_memory(&t->n);
    }
    rational_clear(&angle);
    number_clear(&one);
    return ok;
}

void twist_apply(number *x, number *y, const twist *t, int turns, long prec)
{
    number p, q;
    number_init(&p);
    number_init(&q);
    for (; turns > 0; turns--) {
        number_mul(&p, &t->c, x, prec);
        number_submul(&p, &t->n, y, prec);
        number_mul(&q, &t->v, x, prec);
        number_addmul(&q, &t->c, y, prec);
        number_swap(x, &p);
        number_swap(y, &q);
    }
    for (; turns < 0; turns++) {
        number_mul(&p, &t->c, x, prec);
        number_addmul(&p, &t->n, y, prec);
        number_mul(&q, &t->c, y, prec);
        number_submul(&q, &t->v, x, prec);
        number_swap(x, &p);
        number_swap(y, &q);
    }
    number_clear(&p);
    number_clear(&q);
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

bool sector_net_make(sector_net *z, int rings, const twist *t)
{
    z->rings = rings;
    z->twist = t;
    number_init(&z->centre);
    z->x = number_array_new((size_t)sector_size(rings));
    z->y = number_array_new((size_t)sector_size(rings));
    return z->x && z->y;
}

void sector_net_free(sector_net *z)
{
    number_clear(&z->centre);
    if (z->x)
        number_array_free(z->x, (size_t)sector_size(z->rings));
    if (z->y)
        number_array_free(z->y, (size_t)sector_size(z->rings));
    z->x = z->y = NULL;
}

/* Brings (a,b) into the sector; *turns is the power of t that its value has. */
static sector_status reduce(int *a, int *b, int *turns)
{
    *turns = 0;
    while (*a < 1 || *b < 0) {
        int p = *a, q = *b;
        if (q >= 1) { /* a <= 0: across the spoke (0,1) */
            *a = p + q;
            *b = -p;
            ++*turns;
        } else if (q < 0 && p >= 0) { /* across the spoke (1,0) */
            *a = -q;
            *b = p + q;
            --*turns;
        } else {
            return SECTOR_OPPOSITE;
        }
    }
    return SECTOR_OK;
}

sector_status sector_value(number *x, number *y, const sector_net *z, int a, int b, long prec)
{
    int turns;
    if (a == 0 && b == 0) {
        number_set(x, &z->centre);
        number_zero(y);
        return SECTOR_OK;
    }
    if (reduce(&a, &b, &turns) != SECTOR_OK)
        return SECTOR_OPPOSITE;
    if (a + b > z->rings)
        return SECTOR_OUTSIDE;
    number_set(x, &z->x[sector_index(a, b)]);
    number_set(y, &z->y[sector_index(a, b)]);
    if (z->twist && turns)
        twist_apply(x, y, z->twist, turns, prec);
    return SECTOR_OK;
}

/* The points y that contribute to x are those with x - 2y in the mask's box. */
sector_status sector_refined_value(number *x, number *y, const sector_net *z, const mask_numbers *mask, int a, int b, long prec)
{
    const laurent *terms = mask->mask;
    sector_status s = SECTOR_OK;
    number p, q;
    number_init(&p);
    number_init(&q);
    number_zero(x);
    number_zero(y);
    for (long i = terms->a0; s == SECTOR_OK && i < terms->a0 + terms->na; i++)
        for (long j = terms->b0; s == SECTOR_OK && j < terms->b0 + terms->nb; j++) {
            if (((a - i) | (b - j)) & 1 || laurent_is_zero_at(terms, i, j))
                continue;
            s = sector_value(&p, &q, z, (int)(a - i) / 2, (int)(b - j) / 2, prec);
            number_addmul(x, mask_numbers_at(mask, i, j), &p, prec);
            if (z->twist)
                number_addmul(y, mask_numbers_at(mask, i, j), &q, prec);
        }
    number_clear(&p);
    number_clear(&q);
    return s;
}
