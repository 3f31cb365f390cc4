/* separation.c: a chain as short as spans allow, and both proofs together. */
#include "separation.h"

/* How often the chain is made longer, each time by half, and how many arcs it may have. */
enum { MOST_ATTEMPTS = 8, MOST_ARCS = 1000 };

/* The least end of a chain that holds 1/k for all k of the range. */
static int64_t least_end(valence_range k)
{
    return arc_units_above(1, k.first);
}

/* From the end of the chain on. */
static span_task make_task(const rise_list *rises, const scheme *s, valence_range k)
{
    int64_t end = rises->count ? rises->box[rises->count - 1].q : 0;
    return (span_task){s, k, {2, FREQUENCIES_UNBOUNDED}, end, ARC_HALF};
}

/* Is a gap between 1/k and 2/k' to be hoped for, k and k' in the range? */
static bool is_narrow(valence_range k)
{
    return k.last < 2 * k.first;
}

static void take_span(separation_answer *z, span_answer span)
{
    z->span = span;
    z->status = span.status;
    z->stopped = z->stopped || span.stopped;
    z->proved = span.status == BLOCK_OK && span.proved;
}

static void take_rise(separation_answer *z, rise_answer rise)
{
    z->rise = rise;
    z->status = rise.status;
    z->stopped = z->stopped || rise.stopped;
}

separation_answer separation_search(rise_list *rises, span_list *spans, const scheme *s, valence_range k, const number *scale, const cover_limits *limits, long g, long prec, diagnostic *d)
{
    separation_answer z = {.status = BLOCK_OK};
    int64_t goal = least_end(k), reached = 0;
    take_rise(&z, rise_search(rises, s, k, 0, 0, limits, g, prec, d)); /* may there be a chain? */
    for (int i = 0; i < MOST_ATTEMPTS && z.status == BLOCK_OK && !z.stopped; i++) {
        if (i > 0 || is_narrow(k) || !z.rise.constant) {
            span_task task = make_task(rises, s, k);
            take_span(&z, span_search(spans, &task, scale, limits, prec, d));
        }
        if (z.proved || z.status != BLOCK_OK || z.stopped || !z.rise.constant || reached >= ARC_HALF)
            break;
        goal = goal < ARC_HALF / 3 * 2 ? goal / 2 * 3 : ARC_HALF;
        take_rise(&z, rise_search(rises, s, k, goal, MOST_ARCS, limits, g, prec, d));
        if (z.rise.end < least_end(k) || z.rise.end == reached)
            break;
        reached = z.rise.end;
    }
    if (!z.proved)
        rise_list_clear(rises);
    return z;
}

/* With a chain, one group; and it has to begin where all chains do. */
static bool is_one_group(const span_list *spans)
{
    return spans->count && spans->box[spans->count - 1].m.first == spans->box[0].m.first;
}

separation_answer separation_verify(const rise_list *rises, const span_list *spans, const scheme *s, valence_range k, const number *scale, long prec, diagnostic *d)
{
    separation_answer z = {.status = BLOCK_OK};
    span_task task = make_task(rises, s, k);
    if (rises->count) {
        take_rise(&z, rise_verify(rises, s, k, prec, d));
        if (!z.rise.proved || z.rise.end < least_end(k) || !is_one_group(spans))
            return z;
    }
    take_span(&z, span_verify(spans->box, spans->count, &task, scale, prec, d));
    return z;
}
