/* monotone.c: the proof for one range, and the search for long chains. */
#include "monotone.h"

#include "block_slope.h"
#include "eigenpair_slope.h"
#include "spectrum.h"

#include <math.h>
#include <stdlib.h>

#define MAX_POWER 10000

/* What is known of one range. */
typedef struct {
    block_status status;
    truth proved; /* TRUTH_FALSE: no memory */
    double upper; /* of L */
} range_answer;

/* Point 3: with x and L in the box. */
static truth prove_rest(int *power, const number *box, const block_slope *b, int pivot, bool replay, long prec)
{
    int n = b->n;
    size_t size = (size_t)(n - 1) * (size_t)(n - 1);
    number *rest = number_array_new(size);
    number scale;
    spectral_answer answer = {TRUTH_FALSE, 0, false, INFINITY};
    number_init(&scale);
    if (rest) {
        matrix_deflate(rest, b->entry, box, n, pivot, prec);
        number_lower(&scale, &box[n], prec);
        number_inv(&scale, &scale, prec);
        number_upper(&scale, &scale, prec);
        answer = spectral_contraction(rest, &scale, n - 1, replay ? *power : 0, replay ? *power : MAX_POWER, prec);
        *power = answer.power;
    }
    number_array_free(rest, size);
    number_clear(&scale);
    return answer.contracts;
}

/* Points 1 to 3. */
static truth prove_matrix(monotone_box *choice, double *upper, const block_slope *b, bool forward, bool replay, long prec)
{
    int n = b->n;
    number *box = number_array_new((size_t)n + 1), *slope = number_array_new((size_t)n + 1);
    truth t = box && slope ? TRUTH_TRUE : TRUTH_FALSE;
    if (t == TRUTH_TRUE && replay)
        t = choice->eigenpair.n == n ? TRUTH_TRUE : TRUTH_UNKNOWN;
    else if (t == TRUTH_TRUE)
        t = eigenpair_choose(&choice->eigenpair, b->entry, n, false, prec, prec);
    if (t == TRUTH_TRUE)
        t = eigenpair_prove(box, &choice->eigenpair, b->entry, prec);
    if (t == TRUTH_TRUE && number_is_positive(&box[n]) != TRUTH_TRUE)
        t = TRUTH_UNKNOWN;
    if (t == TRUTH_TRUE)
        t = eigenpair_slope(slope, box, &choice->eigenpair, b->entry, b->slope, prec);
    if (t == TRUTH_TRUE && (forward ? number_is_positive : number_is_negative)(&slope[n]) != TRUTH_TRUE)
        t = TRUTH_UNKNOWN;
    if (t == TRUTH_TRUE)
        t = prove_rest(&choice->power, box, b, choice->eigenpair.pivot, replay, prec);
    if (t == TRUTH_TRUE)
        *upper = number_upper_bound(&box[n]);
    number_array_free(box, (size_t)n + 1);
    number_array_free(slope, (size_t)n + 1);
    return t;
}

static range_answer prove_range(monotone_box *choice, const scheme_numbers *numbers, bool forward, bool replay, diagnostic *d)
{
    range_answer z = {BLOCK_NO_MEMORY, TRUTH_UNKNOWN, 0};
    block_slope b;
    twist t;
    twist_init(&t);
    if (twist_set_real_range(&t, choice->m, numbers->k, numbers->prec)) {
        z.status = block_slope_make(&b, numbers->scheme, numbers->k, choice->m, &t.u, numbers->prec, d);
        if (z.status == BLOCK_OK)
            z.proved = prove_matrix(choice, &z.upper, &b, forward, replay, numbers->prec);
        if (z.proved == TRUTH_FALSE)
            z.status = BLOCK_NO_MEMORY;
        block_slope_free(&b);
    }
    twist_clear(&t);
    return z;
}

/* A part of the circle that one range may well be able to cover. */
#define FIRST_PART 256

/* Width becomes smaller until it fits, and is tried twice as large next. */
monotone_answer monotone_search(monotone_list *list, const scheme_numbers *numbers, long start, long goal, size_t most, diagnostic *d)
{
    monotone_answer z = {BLOCK_OK, false, start, INFINITY, 0};
    bool forward = goal > start;
    long width = numbers->k / FIRST_PART + 1;
    while (z.end != goal && list->count < most) {
        long left = labs(goal - z.end);
        long other = z.end + (forward ? 1 : -1) * (width < left ? width : left);
        monotone_box *box = monotone_list_add(list);
        range_answer r;
        if (!box) {
            z.status = BLOCK_NO_MEMORY;
            return z;
        }
        box->m = forward ? (frequencies){z.end, other} : (frequencies){other, z.end};
        r = prove_range(box, numbers, forward, false, d);
        z.tries++;
        z.status = r.status;
        if (r.status != BLOCK_OK)
            return z;
        width = box->m.last - box->m.first;
        if (r.proved == TRUTH_TRUE) {
            z.proved = true;
            z.end = other;
            z.upper = r.upper;
            width *= 2;
        } else {
            eigenpair_choice_clear(&box->eigenpair);
            list->count--;
            if (width == 1)
                break;
            width = width > 4 ? width / 4 : 1;
        }
    }
    return z;
}

monotone_answer monotone_verify(const monotone_list *list, const scheme_numbers *numbers, long start, bool forward, diagnostic *d)
{
    monotone_answer z = {BLOCK_OK, false, start, INFINITY, 0};
    if (!monotone_list_is_chain(list, start, forward))
        return z;
    for (size_t i = 0; i < list->count; i++) {
        monotone_box *box = &list->box[i];
        range_answer r = prove_range(box, numbers, forward, true, d);
        z.tries++;
        z.status = r.status;
        if (r.status != BLOCK_OK || r.proved != TRUTH_TRUE)
            return z;
        z.end = forward ? box->m.last : box->m.first;
        z.upper = r.upper;
    }
    z.proved = true;
    return z;
}
