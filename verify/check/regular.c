/* C1 on the regular complex: section 4 of certificate.md.
 *
 * The norm of s^N is the largest sum of |s^N(x - 2^N y)| over y, for x in the
 * 4^N classes modulo 2^N.  The sums are taken class by class, without forming
 * s^N as a whole.  As an operator, S_s^N has the entries s^N(x - 2^N y); its row
 * x comes from the row of S_s^0 (1 at x, else 0) by N steps
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

#include <stdlib.h>

enum { MAX_N = 10, MAX_ROW_SIDE = 2 * MASK_RADIUS + 2 };

bool regular_derive(struct derived_masks *out, const struct mask *mask)
{
    return mask_divide(&out->first[0], mask, 1, 0) &&
           mask_divide(&out->first[1], mask, 0, 1) &&
           mask_divide(&out->second[0], &out->first[0], 0, 1) &&
           mask_divide(&out->second[1], &out->first[0], 1, -1) &&
           mask_divide(&out->second[2], &out->first[1], 1, -1);
}

/* The points of s with their weights, times the denominator. */
struct weights {
    int count;
    int a[MASK_SIDE * MASK_SIDE], b[MASK_SIDE * MASK_SIDE];
    integer weight[MASK_SIDE * MASK_SIDE];
    int low, side;                                 /* rows: low, low + 1, ... */
};

static void list_weights(struct weights *out, const struct mask *s)
{
    int least = 0, greatest = 0;

    out->count = 0;
    for (int a = -MASK_RADIUS; a <= MASK_RADIUS; a++) {
        for (int b = -MASK_RADIUS; b <= MASK_RADIUS; b++) {
            const integer *w = &s->coefficient[a + MASK_RADIUS][b + MASK_RADIUS];

            if (w->sign == 0)
                continue;
            out->a[out->count] = a;
            out->b[out->count] = b;
            integer_set(&out->weight[out->count], w);
            out->count++;
            least = a < least ? a : least;
            least = b < least ? b : least;
            greatest = a > greatest ? a : greatest;
            greatest = b > greatest ? b : greatest;
        }
    }
    out->low = -greatest;
    out->side = 1 - least + greatest + 1;
}

struct row {
    integer entry[MAX_ROW_SIDE][MAX_ROW_SIDE];     /* times denominator^steps */
};

static void clear_row(struct row *out, const struct weights *s)
{
    for (int i = 0; i < s->side; i++)
        for (int j = 0; j < s->side; j++)
            integer_set_small(&out->entry[i][j], 0);
}

/* new(y) += old s(x - 2y) for all y, where x = (a,b): for all points p of s for
 * which y = (x - p)/2 is a lattice point. */
static void spread(struct row *new, const integer *old, int a, int b,
                   const struct weights *s)
{
    integer product;

    for (int i = 0; i < s->count; i++) {
        int twice_a = a - s->a[i], twice_b = b - s->b[i];

        if (twice_a % 2 != 0 || twice_b % 2 != 0)
            continue;

        integer *entry = &new->entry[twice_a / 2 - s->low][twice_b / 2 - s->low];

        integer_mul(&product, old, &s->weight[i]);
        integer_add(entry, entry, &product);
    }
}

/* Are the norms of all rows that come from row[0] by `left` steps < bound?
 * (row[1], row[2] ... are work space.) */
static bool rows_are_small(struct row *row, int left, const struct weights *s,
                           const integer *bound)
{
    if (left == 0) {
        integer sum, magnitude;

        integer_set_small(&sum, 0);
        for (int i = 0; i < s->side; i++) {
            for (int j = 0; j < s->side; j++) {
                integer_absolute(&magnitude, &row->entry[i][j]);
                integer_add(&sum, &sum, &magnitude);
            }
        }
        return integer_compare(&sum, bound) < 0;
    }
    for (int e = 0; e < 4; e++) {
        clear_row(row + 1, s);
        for (int i = 0; i < s->side; i++)
            for (int j = 0; j < s->side; j++)
                if (row->entry[i][j].sign != 0)
                    spread(row + 1, &row->entry[i][j], i + s->low + e % 2,
                           j + s->low + e / 2, s);
        if (!rows_are_small(row + 1, left - 1, s, bound))
            return false;
    }
    return true;
}

bool regular_contracts(const struct mask *second, int n)
{
    struct row *row = allocate((size_t)MAX_N + 1, sizeof *row);
    struct mask *doubled = allocate(1, sizeof *doubled);
    struct weights *s = allocate(1, sizeof *s);
    integer bound;

    bool small;

    if (n < 1 || n > MAX_N)
        cannot_check("the checker forms no powers beyond %d", MAX_N);
    mask_double(doubled, second);
    list_weights(s, doubled);
    integer_set_small(&bound, 1);
    for (int i = 0; i < n; i++)
        integer_mul(&bound, &bound, &doubled->denominator);
    clear_row(row, s);
    integer_set_small(&row->entry[-s->low][-s->low], 1);
    small = rows_are_small(row, n, s, &bound);
    free(row);
    free(doubled);
    free(s);
    return small;
}
