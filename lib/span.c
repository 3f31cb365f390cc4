/* span.c: the proof for one span, and the search for groups and wide spans. */
#include "span.h"

#include "scheme_range.h"
#include "spectrum.h"
#include "stop.h"
#include "stride.h"

#include <math.h>

#define MOST_FAILURES 24

typedef struct {
    const span_task *task;
    const number *scale;
    long prec;
    diagnostic *complaint;
} context;

/* ---- groups ---- */

/* The largest frequency that there is. */
static long top_frequency(const span_task *t)
{
    long half = t->k.last == VALENCES_UNBOUNDED ? FREQUENCIES_UNBOUNDED : t->k.last / 2;
    return half < t->m.last ? half : t->m.last;
}

/* Where the first span of a group begins. */
static int64_t group_start(const span_task *t, frequencies m)
{
    int64_t q = arc_units_below(m.first, t->k.last);
    return q > t->start ? q : t->start;
}

/* Where its last one may end. */
static int64_t group_end(const span_task *t, frequencies m)
{
    int64_t q = arc_units_above(m.last, t->k.first);
    return q < t->end ? q : t->end;
}

/* ---- one span ---- */

typedef struct {
    block_status status;
    spectral_answer answer;
} one_answer;

static spectral_answer contract(const affine_matrix *b, const context *c, int least, int most)
{
    spectral_answer z = {TRUTH_FALSE, 0, false, INFINITY};
    size_t size = (size_t)b->n * (size_t)b->n;
    number *range = number_array_new(size);
    for (size_t i = 0; range && i < size; i++)
        affine_range(&range[i], &b->entry[i], c->prec);
    if (range)
        z = spectral_contraction(range, c->scale, b->n, least, most, c->prec);
    number_array_free(range, size);
    return z;
}

static one_answer prove_span(frequencies m, int64_t from, int64_t to, const context *c, int least, int most)
{
    one_answer z = {BLOCK_NO_MEMORY, {TRUTH_UNKNOWN, 0, false, INFINITY}};
    affine_matrix b = {0, NULL};
    arc r;
    arc_init(&r);
    if (arc_set_units(&r, from, to)) {
        z.status = affine_matrix_make(&b, c->task->scheme, c->task->k, m, &r, c->prec, c->complaint);
        if (z.status == BLOCK_OK)
            z.answer = contract(&b, c, least, most);
        if (z.answer.contracts == TRUTH_FALSE)
            z.status = BLOCK_NO_MEMORY;
    }
    affine_matrix_free(&b);
    arc_clear(&r);
    return z;
}

static bool stops(span_answer *z)
{
    z->stopped = z->stopped || stop_now();
    return z->stopped;
}

static void note(span_answer *z, const one_answer *r, frequencies m, int64_t from)
{
    z->tries++;
    z->status = r->status;
    if (r->answer.contracts == TRUTH_TRUE && r->answer.radius > z->radius) {
        z->radius = r->answer.radius;
        z->largest = from;
    }
    if (r->answer.contracts != TRUTH_TRUE) {
        z->open = m;
        z->open_from = from;
        z->diverges = r->answer.diverges;
    }
}

/* ---- the search ---- */

/* Adds the spans of one group; false: not all of them could be found, and none is added. */
static bool search_group(span_answer *z, span_list *list, frequencies m, const context *c, const cover_limits *limits)
{
    size_t before = list->count;
    int64_t from = group_start(c->task, m), end = group_end(c->task, m);
    stride width = stride_start(from ? 4 * (double)from : (double)end);
    int failures = 0;
    bool more = true; /* also where the group is beyond its end: one span of no width */
    while (more && failures < MOST_FAILURES && z->tries < limits->tries && !stops(z)) {
        long here = from < end ? stride_width(&width, end - from) : 0;
        one_answer r = prove_span(m, from, from + here, c, 0, limits->power);
        note(z, &r, m, from);
        if (z->status == BLOCK_OK && r.answer.contracts == TRUTH_TRUE) {
            if (!span_list_add(list, (span_box){m, from + here, r.answer.power}))
                z->status = BLOCK_NO_MEMORY;
            from += here;
            more = from < end;
            failures = 0;
            stride_after_success(&width, (double)here);
        } else {
            failures = here <= 1 ? MOST_FAILURES : failures + 1;
            stride_after_failure(&width, (double)here);
        }
        if (z->status != BLOCK_OK)
            break;
    }
    if (more || z->status != BLOCK_OK)
        list->count = before;
    return !more && z->status == BLOCK_OK;
}

/* All that are left in one group, if possible; else, if weights depend on m, the first frequency by itself. */
span_answer span_search(span_list *list, const span_task *task, const number *scale, const cover_limits *limits, long prec, diagnostic *d)
{
    const context c = {task, scale, prec, d};
    span_answer z = {.status = BLOCK_OK};
    size_t before = list->count;
    frequencies m = task->m;
    long top = top_frequency(task);
    bool vary;
    status s = scheme_weights_vary_with_frequency(&vary, task->scheme, task->k, d);
    if (s != STATUS_OK)
        z.status = s == STATUS_BAD_INPUT ? BLOCK_BAD_INPUT : BLOCK_NO_MEMORY;
    z.proved = m.first > top;
    while (z.status == BLOCK_OK && !z.proved) {
        z.proved = search_group(&z, list, m, &c, limits);
        if (z.proved || !vary || m.first == top || z.status != BLOCK_OK || !search_group(&z, list, one_frequency(m.first), &c, limits))
            break;
        m.first++;
    }
    if (!z.proved)
        list->count = before;
    return z;
}

/* ---- the proof ---- */

/* Do the groups follow each other as they must?  (The spans of each are looked at one by one.) */
static bool is_cover(const span_box *boxes, size_t count, const span_task *t)
{
    long top = top_frequency(t);
    if (t->m.first > top)
        return count == 0;
    for (size_t i = 0; i < count; i++) {
        frequencies m = boxes[i].m, next = i + 1 < count ? boxes[i + 1].m : m;
        bool last = i + 1 == count, ends = last || next.first != m.first;
        if ((i == 0 && m.first != t->m.first) || m.last < m.first || m.last > t->m.last || (next.first == m.first && next.last != m.last))
            return false;
        if (ends && !last && (m.last >= top || next.first != m.last + 1))
            return false;
        if (ends != (boxes[i].q >= group_end(t, m)) || (last && m.last < top))
            return false;
    }
    return count > 0;
}

span_answer span_verify(const span_box *boxes, size_t count, const span_task *task, const number *scale, long prec, diagnostic *d)
{
    const context c = {task, scale, prec, d};
    span_answer z = {.status = BLOCK_OK, .open = task->m};
    int64_t from = 0;
    if (!task->scheme->mirror_symmetric || !is_cover(boxes, count, task))
        return z;
    for (size_t i = 0; i < count && !stops(&z); i++) {
        const span_box *box = &boxes[i];
        bool first = i == 0 || box->m.first != boxes[i - 1].m.first;
        one_answer r = {BLOCK_OK, {TRUTH_UNKNOWN, 0, false, INFINITY}};
        from = first ? group_start(task, box->m) : boxes[i - 1].q;
        if (box->power >= 0 && box->q <= ARC_HALF && (first ? from <= box->q : from < box->q))
            r = prove_span(box->m, from, box->q, &c, box->power, box->power);
        note(&z, &r, box->m, from);
        if (z.status != BLOCK_OK || r.answer.contracts != TRUTH_TRUE)
            return z;
    }
    z.proved = !z.stopped;
    return z;
}
