/* winding_test.c: how often the characteristic map's outer curve winds round 0 (verify/certificate.md, section 10).  Compiled once
   per number system. */
#include "tests.h"

/* The leaves of the next tree; each split of a segment has two children. */
static size_t count_leaves(const tree_word *word, size_t *at)
{
    size_t leaves = 0;
    for (size_t open = 1; open && *at < word->length; ++*at) {
        bool split = word->letter[*at] == TREE_SPLIT;
        leaves += !split;
        open = split ? open + 1 : open - 1;
    }
    return leaves;
}

/* The directions in the order in which the curve runs: on segments along the first direction, the other way round. */
static void put_in_order(buffer *directions, const tree_word *word, const ring *g)
{
    size_t first = 0, at = 0;
    for (int e = 0; e < g->boundary_count; e++) {
        size_t leaves = count_leaves(word, &at);
        char *d = directions->bytes + first;
        for (size_t i = 0; g->boundary[e].type == ELEMENT_ALONG_FIRST && i < leaves / 2; i++) {
            char t = d[i];
            d[i] = d[leaves - 1 - i];
            d[leaves - 1 - i] = t;
        }
        first += leaves;
    }
}

/* Q: the sum of the changes.  false: one of them is two quarters. */
static bool sum_changes(long *q, const buffer *directions)
{
    *q = 0;
    for (size_t i = 1; i < directions->length; i++) {
        int change = (directions->bytes[i] - directions->bytes[i - 1]) & 3;
        if (change == 2)
            return false;
        *q += change == 3 ? -1 : change;
    }
    return true;
}

/* n = 1 + k j for the integer j with 2 pi/k + 2 pi j between (Q - 2) pi/2 and (Q + 2) pi/2: that is 4 k j > k (Q - 2) - 4, the least. */
static long windings(long q, long k)
{
    long low = k * (q - 2) - 4, j = low / (4 * k);
    while (4 * k * j <= low)
        j++;
    while (4 * k * (j - 1) > low)
        j--;
    return 1 + k * j;
}

outcome test_winding(analysis *a)
{
    buffer directions;
    long k = a->choices->k.first, q = 0;
    outcome o;
    buffer_init(&directions);
    o = analysis_follow_curve(a, &directions);
    if (o == OUTCOME_TRUE && directions.failed)
        o = OUTCOME_NO_MEMORY;
    if (o == OUTCOME_TRUE) {
        put_in_order(&directions, &a->choices->boundary, &a->plan->problem->geometry);
        if (!sum_changes(&q, &directions) || !(k * (q - 2) >= 4 || k * (q + 2) <= 4))
            o = findings_explain(a->findings, OUTCOME_FALSE, "the outer curve winds once round 0");
        else
            a->findings->windings = windings(q, k);
    }
    buffer_clear(&directions);
    return o;
}
