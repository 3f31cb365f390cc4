/* C1 on the regular complex: section 4 of certificate.md.
 *
 * The norm of s^N is the largest sum of |s^N(x - 2^N y)| over y, for x in the 4^N classes modulo
 * 2^N.  The sums are taken class by class, without forming s^N as a whole.  As an operator, S_s^N
 * has the entries s^N(x - 2^N y); its row x comes from the row of S_s^0 (1 at x, else 0) by N steps
 *
 *     new(y) = sum over x of old(x) s(x - 2y).
 *
 * Write x = e_0 + 2 e_1 + ... + 2^(N-1) e_(N-1) (+ 2^N times anything, which
 * shifts the row) with e_i in {0,1}^2.  If rows are stored relative to the point
 * (e_j, e_(j+1), ...) that is left after j steps, a step becomes
 *
 *     new(y) = sum over x of old(x) s(x + e_j - 2y)
 *
 * and depends on x only through e_j: the classes are the leaves of a tree of
 * depth N with four branches at a node, which is walked depth first.
 *
 * Where the points of s have both coordinates in [l, u], l <= 0 <= u, those of
 * rows stay in [-u, 1 - l]: for x there, e in {0, 1} and p in [l, u],
 * (x + e - p)/2 lies between (-u - u)/2 and (1 - l + 1 - l)/2.
 */

#include "regular.h"

#include "answer.h"

enum { MAX_N = 10 };

static const int direction[3][2] = { { 1, 0 }, { 0, 1 }, { 1, -1 } };

/* The pairs (d,d'), counted from 0: of triangles, of quads. */
static const int pair[2][3][2] = {
    { { 0, 1 }, { 0, 2 }, { 1, 2 } },
    { { 0, 0 }, { 0, 1 }, { 1, 1 } }
};

bool regular_derive(struct derived_masks *out, const struct mask *mask, enum mesh mesh)
{
    for (int i = 0; i < 2; i++)
        if (!mask_divide(&out->first[i], mask, direction[i][0], direction[i][1]))
            return false;
    for (int i = 0; i < 3; i++) {
        const int *p = pair[mesh == TRIANGLE ? 0 : 1][i];

        if (!mask_divide(&out->second[i], &out->first[p[0]], direction[p[1]][0],
                         direction[p[1]][1]))
            return false;
        out->name[i] = 10 * (p[0] + 1) + p[1] + 1;
    }
    return true;
}

/* The points of s with their weights, times the denominator. */
struct weights {
    struct points p;
    int low, side;                                 /* rows: low, low + 1, ... */
};

static struct weights list_weights(const struct mask *s)
{
    struct weights out = { .p = mask_points(s) };
    int least = 0, greatest = 0;

    for (int i = 0; i < 2; i++) {
        least = out.p.low[i] < least ? out.p.low[i] : least;
        greatest = out.p.high[i] > greatest ? out.p.high[i] : greatest;
    }
    out.low = -greatest;
    out.side = 1 - least + greatest + 1;
    return out;
}

/* new(y) += old s(x - 2y) for all y, where x = (a,b): for all points p of s for
 * which y = (x - p)/2 is a lattice point. */
static void spread(integer *new, integer old, int a, int b, const struct weights *s)
{
    for (int i = 0; i < s->p.count; i++) {
        int twice_a = a - s->p.point[i].a, twice_b = b - s->p.point[i].b;
        integer *entry;

        if (twice_a % 2 != 0 || twice_b % 2 != 0)
            continue;
        entry = &new[(twice_a / 2 - s->low) * s->side + twice_b / 2 - s->low];
        *entry = integer_add(*entry, integer_mul(old, s->p.point[i].weight));
    }
}

static bool row_is_small(const integer *row, const struct weights *s, integer bound)
{
    integer sum = integer_from(0);

    for (int i = 0; i < s->side * s->side; i++)
        sum = integer_add(sum, integer_absolute(row[i]));
    return integer_compare(sum, bound) < 0;
}

/* Are the norms of all rows that come from this one by `left` steps < bound?
 * Rows are times denominator^steps. */
static bool rows_are_small(const integer *row, int left, const struct weights *s, integer bound)
{
    struct mark mark = scratch_mark();
    bool small = true;

    if (left == 0)
        return row_is_small(row, s, bound);
    for (int e = 0; e < 4 && small; e++) {
        integer *new = allocate((size_t)s->side * (size_t)s->side, sizeof new[0]);

        for (int i = 0; i < s->side * s->side; i++)
            if (row[i].sign != 0)
                spread(new, row[i], i / s->side + s->low + e % 2, i % s->side + s->low + e / 2, s);
        small = rows_are_small(new, left - 1, s, bound);
        scratch_release(mark);
    }
    return small;
}

bool regular_contracts(const struct mask *second, int n)
{
    struct mask doubled = mask_double(second);
    struct weights s = list_weights(&doubled);
    integer *row = allocate((size_t)s.side * (size_t)s.side, sizeof row[0]);
    integer bound = integer_from(1);

    if (n < 1 || n > MAX_N)
        cannot_check("the checker forms no powers beyond %d", MAX_N);
    for (int i = 0; i < n; i++)
        bound = integer_mul(bound, doubled.denominator);
    row[-s.low * s.side - s.low] = integer_from(1);
    return rows_are_small(row, n, &s, bound);
}
