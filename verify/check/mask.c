/* Masks: the conditions of lib/scheme.md on them, and the division of symbols
 * that section 4 of certificate.md asks for.  All exact. */

#include "mask.h"

#include "answer.h"

#include <stdlib.h>

int lattice_distance(int a, int b)
{
    int distance = abs(a);

    if (abs(b) > distance)
        distance = abs(b);
    if (abs(a + b) > distance)
        distance = abs(a + b);
    return distance;
}

/* The value at a point, NULL for the 0 outside. */
static const integer *at(const struct mask *mask, int a, int b)
{
    if (abs(a) > MASK_RADIUS || abs(b) > MASK_RADIUS)
        return NULL;
    return &mask->coefficient[a + MASK_RADIUS][b + MASK_RADIUS];
}

void mask_from_exact(struct mask *out, const struct exact_mask *weights)
{
    integer gcd, factor;

    integer_set_small(&out->denominator, 1);       /* the least common multiple */
    for (int i = 0; i < MASK_SIDE; i++) {
        for (int j = 0; j < MASK_SIDE; j++) {
            const integer *den = &weights->weight[i][j].den;

            integer_gcd(&gcd, &out->denominator, den);
            integer_divide_floor(&factor, den, &gcd);
            integer_mul(&out->denominator, &out->denominator, &factor);
        }
    }
    for (int i = 0; i < MASK_SIDE; i++) {
        for (int j = 0; j < MASK_SIDE; j++) {
            const rational *w = &weights->weight[i][j];

            integer_divide_floor(&factor, &out->denominator, &w->den);
            integer_mul(&out->coefficient[i][j], &w->num, &factor);
        }
    }
}

/* Conditions
 * ---------- */

static bool classes_sum_to_one(const struct mask *mask)
{
    for (int odd_a = 0; odd_a < 2; odd_a++) {
        for (int odd_b = 0; odd_b < 2; odd_b++) {
            integer sum;

            integer_set_small(&sum, 0);
            for (int a = -MASK_RADIUS; a <= MASK_RADIUS; a++)
                for (int b = -MASK_RADIUS; b <= MASK_RADIUS; b++)
                    if (abs(a) % 2 == odd_a && abs(b) % 2 == odd_b)
                        integer_add(&sum, &sum, at(mask, a, b));
            if (integer_compare(&sum, &mask->denominator) != 0)
                return false;
        }
    }
    return true;
}

/* Is mask(a,b) the same as at the image of (a,b)?  mirror: (b,a), else
 * (-b, a+b).  Outside of the square the mask is 0. */
static bool is_invariant(const struct mask *mask, bool mirror)
{
    for (int a = -MASK_RADIUS; a <= MASK_RADIUS; a++) {
        for (int b = -MASK_RADIUS; b <= MASK_RADIUS; b++) {
            const integer *here = at(mask, a, b);
            const integer *there = mirror ? at(mask, b, a) : at(mask, -b, a + b);

            if (there == NULL ? here->sign != 0
                              : integer_compare(here, there) != 0)
                return false;
        }
    }
    return true;
}

const char *mask_fault(const struct mask *mask)
{
    if (!classes_sum_to_one(mask))
        return "a mask whose weights sum to 1 in each class modulo 2";
    if (!is_invariant(mask, false))
        return "a mask invariant under (i,j) -> (-j, i+j)";
    if (!is_invariant(mask, true))
        return "a mask invariant under (i,j) -> (j,i)";
    return NULL;
}

/* Division
 * --------
 *
 * a = q (1 + z^-d) says a(x) = q(x) + q(x+d).  Along a line in direction d that
 * enters the square at x, q is 0 up to x (the hulls of q and q - d lie in that
 * of a), then q(x+d) = a(x) - q(x), and there is no remainder iff it is 0 again
 * where the line leaves the square. */
bool mask_divide(struct mask *out, const struct mask *a, int da, int db)
{
    integer_set(&out->denominator, &a->denominator);
    for (int i = 0; i < MASK_SIDE; i++)
        for (int j = 0; j < MASK_SIDE; j++)
            integer_set_small(&out->coefficient[i][j], 0);

    for (int i = 0; i < MASK_SIDE; i++) {
        for (int j = 0; j < MASK_SIDE; j++) {
            int x = i - MASK_RADIUS, y = j - MASK_RADIUS;
            integer q;

            if (at(a, x - da, y - db) != NULL)
                continue;                          /* not the line's first point */
            integer_set_small(&q, 0);
            for (; at(a, x, y) != NULL; x += da, y += db) {
                integer_set(&out->coefficient[x + MASK_RADIUS][y + MASK_RADIUS], &q);
                integer_sub(&q, at(a, x, y), &q);
            }
            if (q.sign != 0)
                return false;
        }
    }
    return true;
}

void mask_double(struct mask *out, const struct mask *a)
{
    integer_set(&out->denominator, &a->denominator);
    for (int i = 0; i < MASK_SIDE; i++)
        for (int j = 0; j < MASK_SIDE; j++)
            integer_add(&out->coefficient[i][j], &a->coefficient[i][j],
                        &a->coefficient[i][j]);
}

bool mask_is_nonnegative(const struct mask *a)
{
    for (int i = 0; i < MASK_SIDE; i++)
        for (int j = 0; j < MASK_SIDE; j++)
            if (a->coefficient[i][j].sign < 0)
                return false;
    return true;
}

/* Stencils
 * -------- */

void stencil_from_mask(struct stencil *out, const struct mask *mask, int g)
{
    out->count = 0;
    for (int a = -MASK_RADIUS; a <= MASK_RADIUS; a++) {
        for (int b = -MASK_RADIUS; b <= MASK_RADIUS; b++) {
            const int f[3] = { a, b, a + b };
            const integer *coefficient = at(mask, a, b);

            if (coefficient->sign == 0)
                continue;

            struct stencil_entry *entry = &out->entry[out->count];

            entry->a = a;
            entry->b = b;
            grid_from_fraction(&entry->weight, coefficient, &mask->denominator, g);
            for (int i = 0; i < 3; i++) {
                if (out->count == 0 || f[i] < out->low[i])
                    out->low[i] = f[i];
                if (out->count == 0 || f[i] > out->high[i])
                    out->high[i] = f[i];
            }
            out->count++;
        }
    }
    if (out->count == 0)
        cannot_check("the checker has an empty mask");
}

int stencil_radius(const struct stencil *s)
{
    int radius = 0;

    for (int i = 0; i < s->count; i++) {
        int distance = lattice_distance(s->entry[i].a, s->entry[i].b);

        if (distance > radius)
            radius = distance;
    }
    return radius;
}
