/* Masks: the conditions of lib/scheme.md on them, and products and quotients of
 * symbols.  All exact. */

#include "mask.h"

#include "answer.h"

#include <stdlib.h>

int lattice_distance(enum mesh mesh, int a, int b)
{
    int distance = abs(a) > abs(b) ? abs(a) : abs(b);

    if (mesh == TRIANGLE && abs(a + b) > distance)
        distance = abs(a + b);
    return distance;
}

void label_rotate(enum mesh mesh, int *a, int *b)
{
    int turned = mesh == DUAL ? -*b - 1 : -*b;

    *b = mesh == TRIANGLE ? *a + *b : *a;
    *a = turned;
}

struct mask mask_new(int low_a, int low_b, int side_a, int side_b)
{
    struct mask out = { low_a, low_b, side_a, side_b, integer_from(1), NULL };

    out.coefficient = allocate((size_t)side_a * (size_t)side_b, sizeof out.coefficient[0]);
    return out;
}

integer *mask_cell(const struct mask *mask, int a, int b)
{
    int i = a - mask->low_a, j = b - mask->low_b;

    if (i < 0 || i >= mask->side_a || j < 0 || j >= mask->side_b)
        return NULL;
    return &mask->coefficient[i * mask->side_b + j];
}

static integer at(const struct mask *mask, int a, int b)
{
    const integer *cell = mask_cell(mask, a, b);

    return cell != NULL ? *cell : integer_from(0);
}

void mask_set_weights(struct mask *out, const rational *weight)
{
    int count = out->side_a * out->side_b;

    out->denominator = integer_from(1);            /* the least common multiple */
    for (int i = 0; i < count; i++) {
        integer gcd = integer_gcd(out->denominator, weight[i].den);

        out->denominator = integer_mul(out->denominator, integer_divide_floor(weight[i].den, gcd));
    }
    for (int i = 0; i < count; i++)
        out->coefficient[i] = integer_mul(weight[i].num,
            integer_divide_floor(out->denominator, weight[i].den));
    if (integer_bits(out->denominator) > RATIONAL_BITS)
        cannot_check("a rational number of more than %d bits occurs", RATIONAL_BITS);
}

struct points mask_points(const struct mask *mask)
{
    int cells = mask->side_a * mask->side_b;
    struct points out = { .point = allocate((size_t)cells, sizeof out.point[0]) };

    for (int n = 0; n < cells; n++) {
        int a = n / mask->side_b + mask->low_a, b = n % mask->side_b + mask->low_b;
        const int f[3] = { a, b, a + b };

        if (mask->coefficient[n].sign == 0)
            continue;
        for (int i = 0; i < 3; i++) {
            if (out.count == 0 || f[i] < out.low[i])
                out.low[i] = f[i];
            if (out.count == 0 || f[i] > out.high[i])
                out.high[i] = f[i];
        }
        out.point[out.count++] = (struct point) { a, b, mask->coefficient[n] };
    }
    return out;
}

/* The class modulo 2 */
static int parity(int a, int b)
{
    return abs(a) % 2 * 2 + abs(b) % 2;
}

/* Conditions
 * ---------- */

static bool classes_sum_to_one(const struct mask *mask)
{
    struct points p = mask_points(mask);
    integer sum[4] = { integer_from(0), integer_from(0), integer_from(0),
                       integer_from(0) };

    for (int i = 0; i < p.count; i++) {
        integer *own = &sum[parity(p.point[i].a, p.point[i].b)];

        *own = integer_add(*own, p.point[i].weight);
    }
    for (int class = 0; class < 4; class++)
        if (integer_compare(sum[class], mask->denominator) != 0)
            return false;
    return true;
}

static void exchange(enum mesh mesh, int *a, int *b)
{
    int x = *a;

    (void)mesh;
    *a = *b;
    *b = x;
}

/* Has every label with a coefficient an image with the same one?  (Then these labels are
 * permuted, and the images of all others have none.) */
static bool is_invariant(const struct mask *mask, enum mesh mesh,
                         void (*map)(enum mesh mesh, int *a, int *b))
{
    struct points p = mask_points(mask);

    for (int i = 0; i < p.count; i++) {
        int a = p.point[i].a, b = p.point[i].b;

        map(mesh, &a, &b);
        if (integer_compare(p.point[i].weight, at(mask, a, b)) != 0)
            return false;
    }
    return true;
}

bool mask_is_mirrored(const struct mask *mask)
{
    return is_invariant(mask, TRIANGLE, exchange);
}

const char *mask_fault(const struct mask *mask, enum mesh mesh)
{
    if (!classes_sum_to_one(mask))
        return "a mask whose weights sum to 1 in each class modulo 2";
    if (!is_invariant(mask, mesh, label_rotate))
        return mesh == TRIANGLE ? "a mask invariant under (i,j) -> (-j, i+j)"
                                : "a mask invariant under (i,j) -> (-j, i)";
    return NULL;
}

/* Symbols
 * -------
 *
 * a = q (1 + z^-d) says a(x) = q(x) + q(x+d).  Along a line in direction d that enters the box at
 * x, q is 0 up to x (the hulls of q and q - d lie in that of a), then q(x+d) = a(x) - q(x), and
 * there is no remainder iff it is 0 again where the line leaves the box. */
bool mask_divide(struct mask *out, const struct mask *a, int da, int db)
{
    *out = mask_new(a->low_a, a->low_b, a->side_a, a->side_b);
    out->denominator = a->denominator;
    for (int i = 0; i < a->side_a; i++) {
        for (int j = 0; j < a->side_b; j++) {
            int x = i + a->low_a, y = j + a->low_b;
            integer q = integer_from(0);

            if (mask_cell(a, x - da, y - db) != NULL)
                continue;                          /* not the line's first point */
            for (; mask_cell(a, x, y) != NULL; x += da, y += db) {
                *mask_cell(out, x, y) = q;
                q = integer_sub(at(a, x, y), q);
            }
            if (q.sign != 0)
                return false;
        }
    }
    return true;
}

struct mask mask_multiply(const struct mask *a, const struct mask *b)
{
    struct points p = mask_points(a), q = mask_points(b);
    struct mask out = mask_new(a->low_a + b->low_a, a->low_b + b->low_b,
                               a->side_a + b->side_a - 1, a->side_b + b->side_b - 1);

    out.denominator = integer_mul(a->denominator, b->denominator);
    for (int i = 0; i < p.count * q.count; i++) {
        const struct point *x = &p.point[i / q.count], *y = &q.point[i % q.count];
        integer *cell = mask_cell(&out, x->a + y->a, x->b + y->b);

        *cell = integer_add(*cell, integer_mul(x->weight, y->weight));
    }
    if (integer_bits(out.denominator) > RATIONAL_BITS)
        cannot_check("a rational number of more than %d bits occurs", RATIONAL_BITS);
    return out;
}

struct mask mask_double(const struct mask *a)
{
    struct mask out = mask_new(a->low_a, a->low_b, a->side_a, a->side_b);

    out.denominator = a->denominator;
    for (int i = 0; i < a->side_a * a->side_b; i++)
        out.coefficient[i] = integer_add(a->coefficient[i], a->coefficient[i]);
    return out;
}

bool mask_is_nonnegative(const struct mask *a)
{
    for (int i = 0; i < a->side_a * a->side_b; i++)
        if (a->coefficient[i].sign < 0)
            return false;
    return true;
}

/* Stencils
 * -------- */

int stencil_class(const struct stencil *s, int a, int b)
{
    return s->dilation == 1 ? 0 : parity(a, b);
}

struct stencil stencil_make(const struct mask *mask, int dilation, int g)
{
    struct stencil out = { .dilation = dilation };
    struct points p = mask_points(mask);
    int count = 0;

    if (p.count == 0)
        cannot_check("the checker has an empty mask");
    for (int i = 0; i < 3; i++) {
        out.low[i] = p.low[i];
        out.high[i] = p.high[i];
    }
    out.entry = allocate((size_t)p.count, sizeof out.entry[0]);
    for (int class = 0; class < 4; class++) {
        out.first[class] = count;
        for (const struct point *x = p.point; x < p.point + p.count; x++)
            if (stencil_class(&out, x->a, x->b) == class)
                out.entry[count++] = (struct stencil_entry) {
                    x->a, x->b, grid_from_fraction(x->weight, mask->denominator, g),
                    { x->weight, mask->denominator }
                };
    }
    out.first[4] = count;
    return out;
}
