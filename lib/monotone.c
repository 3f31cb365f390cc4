/* monotone.c: the proof for one range, and the search for long chains. */
#include "monotone.h"

#include "block_slope.h"
#include "eigenpair_slope.h"
#include "spectrum.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MAX_POWER 10000

/* What is known of one range. */
typedef struct {
    block_status status;
    truth proved; /* TRUTH_FALSE: no memory */
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

/* Points 1 and 2; sign of the slope, box and slope for the caller. */
static truth prove_pair(number *box, number *slope, int *sign, eigenpair_choice *choice, const block_slope *b, bool replay, long prec)
{
    int n = b->n;
    truth t = TRUTH_TRUE;
    if (replay)
        t = choice->n == n ? TRUTH_TRUE : TRUTH_UNKNOWN;
    else
        t = eigenpair_choose(choice, b->entry, n, false, prec, prec);
    if (t == TRUTH_TRUE)
        t = eigenpair_prove(box, choice, b->entry, prec);
    if (t == TRUTH_TRUE && number_is_positive(&box[n]) != TRUTH_TRUE)
        t = TRUTH_UNKNOWN;
    if (t == TRUTH_TRUE)
        t = eigenpair_slope_sharp(slope, box, choice, b->entry, b->slope, prec);
    *sign = t != TRUTH_TRUE ? 0 : number_is_positive(&slope[n]) == TRUTH_TRUE ? 1 : number_is_negative(&slope[n]) == TRUTH_TRUE ? -1 : 0;
    return t;
}

/* Points 1 to 3. */
static truth prove_matrix(monotone_box *choice, const block_slope *b, bool forward, bool replay, long prec)
{
    int n = b->n, sign = 0;
    number *box = number_array_new((size_t)n + 1), *slope = number_array_new((size_t)n + 1);
    truth t = box && slope ? TRUTH_TRUE : TRUTH_FALSE;
    if (t == TRUTH_TRUE)
        t = prove_pair(box, slope, &sign, &choice->eigenpair, b, replay, prec);
    if (t == TRUTH_TRUE && sign != (forward ? 1 : -1))
        t = TRUTH_UNKNOWN;
    if (t == TRUTH_TRUE)
        t = prove_rest(&choice->power, box, b, choice->eigenpair.pivot, replay, prec);
    number_array_free(box, (size_t)n + 1);
    number_array_free(slope, (size_t)n + 1);
    return t;
}

/* The blocks of the range, and their slopes. */
static block_status make_blocks(block_slope *z, const scheme_numbers *numbers, frequencies m, diagnostic *d)
{
    block_status result = BLOCK_NO_MEMORY;
    twist t;
    memset(z, 0, sizeof *z);
    twist_init(&t);
    if (twist_set_real_range(&t, m, numbers->k.first, numbers->prec))
        result = block_slope_make(z, numbers->scheme, numbers->k.first, m, &t.u, numbers->prec, d);
    twist_clear(&t);
    return result;
}

static range_answer prove_range(monotone_box *choice, const scheme_numbers *numbers, bool forward, bool replay, diagnostic *d)
{
    range_answer z = {BLOCK_OK, TRUTH_UNKNOWN};
    block_slope b;
    z.status = make_blocks(&b, numbers, choice->m, d);
    if (z.status == BLOCK_OK)
        z.proved = prove_matrix(choice, &b, forward, replay, numbers->prec);
    if (z.proved == TRUTH_FALSE)
        z.status = BLOCK_NO_MEMORY;
    block_slope_free(&b);
    return z;
}

block_status monotone_direction(number *eigenvalue, int *sign, const scheme_numbers *numbers, long m, diagnostic *d)
{
    block_slope b;
    eigenpair_choice choice;
    block_status result = make_blocks(&b, numbers, one_frequency(m), d);
    eigenpair_choice_init(&choice);
    *sign = 0;
    if (result == BLOCK_OK) {
        number *box = number_array_new((size_t)b.n + 1), *slope = number_array_new((size_t)b.n + 1);
        if (!box || !slope || prove_pair(box, slope, sign, &choice, &b, false, numbers->prec) == TRUTH_FALSE)
            result = BLOCK_NO_MEMORY;
        else if (*sign)
            number_set(eigenvalue, &box[b.n]);
        number_array_free(box, (size_t)b.n + 1);
        number_array_free(slope, (size_t)b.n + 1);
    }
    eigenpair_choice_clear(&choice);
    block_slope_free(&b);
    return result;
}

/* INFINITY: not found. */
static double eigenvalue_approx(const scheme_numbers *numbers, long m)
{
    number eigenvalue;
    diagnostic unused;
    double value = INFINITY;
    int sign;
    number_init(&eigenvalue);
    if (monotone_direction(&eigenvalue, &sign, numbers, m, &unused) == BLOCK_OK && sign)
        value = number_mid_approx(&eigenvalue);
    number_clear(&eigenvalue);
    return value;
}

/* A part of the circle that one range may well be able to cover. */
#define FIRST_PART 256

/* Widths become smaller until they fit.  What fits changes slowly: once a range has been proved they grow and shrink
   with care. */
monotone_answer monotone_search(monotone_list *list, const scheme_numbers *numbers, long start, long goal, size_t most, double enough, diagnostic *d)
{
    monotone_answer z = {BLOCK_OK, false, start, INFINITY, 0};
    bool forward = goal > start;
    long width = numbers->k.first / FIRST_PART + 1;
    double growth = 2;
    while (z.end != goal && list->count < most && !(z.last_approx < enough)) {
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
            z.last_approx = eigenvalue_approx(numbers, other);
            width = (long)((double)width * growth) + 1;
            growth = fmin(growth * 1.1, 2);
        } else {
            eigenpair_choice_clear(&box->eigenpair);
            list->count--;
            if (width == 1)
                break;
            width = (long)((double)width / (z.proved ? 1.5 : 4));
            width = width < 1 ? 1 : width;
            growth = 1.1;
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
    }
    z.proved = true;
    return z;
}
