/* The constants K: lib/stability.md, section 3, in the arithmetic of "Rounded rows".
 *
 * Row x of S^n is kept for the 4^n labels x with coordinates in [0, 2^n); the row of r + 2^n t is
 * that of r, moved by t.  With all points of the mask in [l, u] (each coordinate), the row of such
 * an x has entries at y with x - 2^n y in (2^n - 1) [l, u], so from -max(u, 0) to max(-l, 0).
 */

#include "regular.h"

#include "answer.h"

#include <stdlib.h>

enum { WEIGHT_BITS = 18, ROW_BITS = 30, UNIT = 1024 };

static const int64_t MAX_SUM = INT64_C(1) << 62;
static const int64_t MAX_PAIRS = 80000000;

/* The points of the mask, and their weights in units of 2^-18 rounded down. */
struct rounded {
    struct points p;
    int64_t *weight;
    int64_t greatest_sum;                          /* S: of |weight| in a class */
    int inexact;                                   /* w: most such in a class */
};

/* All rows of S^n in units of 2^-30. */
struct rows {
    int n;
    int low_a, low_b, side_a, side_b;              /* where their entries are */
    int64_t *entry;
    int64_t error, bound;                          /* E, R */
};

static int64_t magnitude(int64_t a)
{
    return a < 0 ? -a : a;
}

static struct rounded round_mask(const struct mask *mask)
{
    struct rounded out = { .p = mask_points(mask) };
    int64_t sum[4] = { 0 };
    int inexact[4] = { 0 };

    out.weight = allocate((size_t)out.p.count, sizeof out.weight[0]);
    for (int i = 0; i < out.p.count; i++) {
        const struct point *x = &out.p.point[i];
        int class = abs(x->a) % 2 * 2 + abs(x->b) % 2;
        integer scaled = integer_shift_left(x->weight, WEIGHT_BITS);
        integer whole = integer_divide_floor(scaled, mask->denominator);

        if (!integer_get_small(&out.weight[i], whole, INT64_C(1) << 40))
            cannot_check("a mask has weights that are too large for its stability");
        if (integer_compare(integer_mul(whole, mask->denominator), scaled) != 0)
            inexact[class]++;
        sum[class] += magnitude(out.weight[i]);
        if (sum[class] > out.greatest_sum)
            out.greatest_sum = sum[class];
        if (inexact[class] > out.inexact)
            out.inexact = inexact[class];
    }
    return out;
}

/* Rows
 * ---- */

static int64_t *row(const struct rows *r, int a, int b)
{
    size_t index = ((size_t)a << r->n) + (size_t)b;

    return r->entry + index * (size_t)r->side_a * (size_t)r->side_b;
}

/* x = r + 2^n t with 0 <= r < 2^n: returns r. */
static int split(int *t, int x, int n)
{
    int r = x & ((1 << n) - 1);

    *t = (x - r) / (1 << n);
    return r;
}

static struct rows rows_new(const struct rounded *s, int n)
{
    int low_a = s->p.high[0] > 0 ? -s->p.high[0] : 0, low_b = s->p.high[1] > 0 ? -s->p.high[1] : 0;
    int high_a = s->p.low[0] < 0 ? -s->p.low[0] : 0, high_b = s->p.low[1] < 0 ? -s->p.low[1] : 0;
    struct rows out = { .n = n, .low_a = low_a, .low_b = low_b,
                        .side_a = high_a - low_a + 1, .side_b = high_b - low_b + 1 };

    out.entry = allocate(((size_t)1 << (2 * n)) * (size_t)out.side_a * (size_t)out.side_b,
                         sizeof out.entry[0]);
    return out;
}

/* The row m of label (a,b) gets + weight times the row of old at (x,y). */
static void add_row(int64_t *m, const struct rows *new, const struct rows *old, int x,
                    int y, int64_t weight)
{
    int ta, tb, ra = split(&ta, x, old->n), rb = split(&tb, y, old->n);
    const int64_t *from = row(old, ra, rb);

    for (int i = 0; i < old->side_a; i++) {
        for (int j = 0; j < old->side_b; j++) {
            int64_t entry = from[i * old->side_b + j];

            if (entry == 0)
                continue;
            if (i + ta < 0 || i + ta >= new->side_a || j + tb < 0 || j + tb >= new->side_b)
                cannot_check("the checker's rows are too short");
            m[(i + ta) * new->side_b + j + tb] += weight * entry;
        }
    }
}

/* m(y) = trunc(sum / 2^18); returns whether anything is lost. */
static bool truncate_row(int64_t *m, int size)
{
    const int64_t unit = INT64_C(1) << WEIGHT_BITS;
    bool lost = false;

    for (int i = 0; i < size; i++) {
        lost = lost || m[i] % unit != 0;
        m[i] /= unit;
    }
    return lost;
}

static void check_sums(const struct rows *r, int64_t factor)
{
    if (r->bound > MAX_SUM / 4 / factor || r->error > r->bound)
        cannot_check("sums beyond 2^62 in the proof of a mask's stability");
}

static struct rows next_rows(const struct rows *old, const struct rounded *s)
{
    struct rows out = rows_new(s, old->n + 1);
    int64_t unit = INT64_C(1) << WEIGHT_BITS;
    bool lost = false;

    check_sums(old, s->greatest_sum + s->inexact + 1);
    for (int a = 0; a < 1 << out.n; a++) {
        for (int b = 0; b < 1 << out.n; b++) {
            int64_t *m = row(&out, a, b);

            for (int i = 0; i < s->p.count; i++) {
                int x = a - s->p.point[i].a, y = b - s->p.point[i].b;

                if (x % 2 == 0 && y % 2 == 0)
                    add_row(m, &out, old, x / 2, y / 2, s->weight[i]);
            }
            lost = truncate_row(m, out.side_a * out.side_b) || lost;
        }
    }
    out.error = (s->inexact * (old->bound + old->error) + s->greatest_sum * old->error +
                 unit - 1) / unit;
    if (lost)
        out.error += (int64_t)(s->p.high[0] - s->p.low[0] + 1) * (s->p.high[1] - s->p.low[1] + 1);
    out.bound = old->bound * s->greatest_sum / unit + 1;
    return out;
}

/* Close pairs
 * -----------
 *
 * Two labels x and x' are good if |m_x - m_x'| and h(x, x') = |(1024+T) m_x - (T-1024) m_x'|
 * are not too large.  From x' to x' + e_2 the latter changes by at most (T-1024) times the
 * largest |m_y - m_(y + e_2)|: one sum that stays well below its limit settles several x'.
 * Nothing else has to be said of their differences, because
 * 2 T |m_x - m_x'| <= h(x, x') + h(x', x), and the pairs come in both orders.
 */

struct close_pairs {
    const struct rows *r;
    int64_t t;
    int most_a, most_b, most_sum;                  /* |d1|, |d2|, |d1 + d2| of x' - x */
    int64_t *norm;                                 /* |m_x| */
    int64_t step;                                  /* most |m_y - m_(y + e_2)| */
};

/* |p m_x - q m_x'|, p, q > 0, for x = (a,b) and x' = x + (da,db): the sum of both norms, but
 * for the entries that both have. */
static int64_t difference(const struct close_pairs *c, int a, int b, int da, int db,
                          int64_t p, int64_t q)
{
    const struct rows *r = c->r;
    int ta, tb, ra = split(&ta, a + da, r->n), rb = split(&tb, b + db, r->n);
    int first_a = ta > 0 ? ta : 0, last_a = r->side_a + (ta < 0 ? ta : 0);
    int first_b = tb > 0 ? tb : 0, last_b = r->side_b + (tb < 0 ? tb : 0);
    int64_t sum = p * c->norm[(a << r->n) + b] + q * c->norm[(ra << r->n) + rb];

    for (int i = first_a; i < last_a; i++) {
        const int64_t *m = row(r, a, b) + i * r->side_b;
        const int64_t *other = row(r, ra, rb) + (i - ta) * r->side_b;

        for (int j = first_b; j < last_b; j++) {
            int64_t here = p * m[j], there = q * other[j - tb];

            sum += magnitude(here - there) - magnitude(here) - magnitude(there);
        }
    }
    return sum;
}

static void measure_rows(struct close_pairs *c)
{
    int side = 1 << c->r->n, entries = c->r->side_a * c->r->side_b;

    c->norm = allocate((size_t)side * (size_t)side, sizeof c->norm[0]);
    for (int i = 0; i < side * side * entries; i++)
        c->norm[i / entries] += magnitude(c->r->entry[i]);
    for (int x = 0; x < side * side; x++) {
        int64_t step = difference(c, x / side, x % side, 0, 1, 1, 1);

        c->step = step > c->step ? step : c->step;
    }
}

/* Are the close pairs x = (a,b), x + (da,db) good, for all db? */
static bool line_is_good(const struct close_pairs *c, int a, int b, int da)
{
    int64_t unit = (INT64_C(1) << ROW_BITS) - c->r->error;

    for (int64_t db = -c->most_b; db <= c->most_b; db++) {
        int64_t room;

        if (da + db < -c->most_sum || da + db > c->most_sum)
            continue;
        room = 2 * c->t * unit - difference(c, a, b, da, (int)db, UNIT + c->t, c->t - UNIT);
        if (room < 0 || (room == 0 && difference(c, a, b, da, (int)db, 1, 1) >= 2 * unit))
            return false;
        if (room > 0)                              /* so many more have room > 0 */
            db += (room - 1) / ((c->t - UNIT) * (c->step + 1));
    }
    return true;
}

static bool all_are_good(struct close_pairs *c)
{
    int side = 1 << c->r->n;

    measure_rows(c);
    for (int x = 0; x < side * side; x++)
        for (int da = -c->most_a; da <= c->most_a; da++)
            if (!line_is_good(c, x / side, x % side, da))
                return false;
    return true;
}

/* Of coefficients of S^n and displacements, along an axis in which the mask is so wide. */
static int64_t count_pairs(int width, int n)
{
    return (int64_t)(((1 << n) - 1) * width + 1) * (2 * width + 1);
}

bool stability_holds(const struct mask *mask, int n, int64_t t)
{
    struct mark mark = scratch_mark();
    struct rounded s = round_mask(mask);
    struct rows r = rows_new(&s, 0);
    struct close_pairs close = { .r = &r, .t = t, .most_a = s.p.high[0] - s.p.low[0] - 1,
                                 .most_b = s.p.high[1] - s.p.low[1] - 1,
                                 .most_sum = s.p.high[2] - s.p.low[2] - 1 };
    bool good;

    if (n < 1 || n > 9 || t <= UNIT)
        cannot_check("the checker verifies no such stability");
    if (close.most_a < 0 || close.most_b < 0 || close.most_sum < 0)
        cannot_check("the checker needs a mask that is not on a line");
    if (count_pairs(close.most_a + 1, n) > MAX_PAIRS / count_pairs(close.most_b + 1, n))
        cannot_check("the proof of a mask's stability is too large");
    r.entry[-r.low_a * r.side_b - r.low_b] = INT64_C(1) << ROW_BITS;
    r.bound = INT64_C(1) << ROW_BITS;
    for (int i = 0; i < n; i++)
        r = next_rows(&r, &s);
    check_sums(&r, t);
    good = all_are_good(&close);
    scratch_release(mark);
    return good;
}
