/* prove_decide.c: valences one by one, or in ranges; what an earlier run has decided is only followed once more. */
#include "prove_run.h"

#include "partition.h"
#include "workers.h"

#include <stdlib.h>

static prove_answer *new_answer(void)
{
    prove_answer *a = calloc(1, sizeof *a);
    if (a)
        decision_init(&a->decision);
    return a;
}

/* By the certificate of an earlier run, if it can be followed. */
static bool decide_as_before(prove_answer *a, const prove_run *r, const archive_index_entry *e)
{
    buffer certificate;
    bool decided;
    buffer_init(&certificate);
    a->earlier = archive_read(&r->archive, &certificate, e->valences);
    decided = certificate.length && decide_by_certificate(&a->decision, &r->problem, e->valences, &certificate, &r->options.limits);
    buffer_clear(&certificate);
    return decided;
}

/* ---- one by one ---- */

/* By a certificate of many valences, so that two do not speak of one. */
static bool decide_within_range(prove_answer *a, const prove_run *r, long k)
{
    for (const archive_index_entry *e = NULL; (e = archive_index_next(&r->earlier, one_valence(k), e));)
        if (!is_one_valence(e->valences) && decide_as_before(a, r, e))
            return true;
    return false;
}

static void *decide(long i, void *data)
{
    const prove_run *r = data;
    long k = valence_list_get(&r->list, i);
    prove_answer *a = new_answer();
    archive_earlier of_k;
    buffer earlier;
    if (!a)
        return NULL;
    buffer_init(&earlier);
    of_k = archive_read(&r->archive, &earlier, one_valence(k));
    if (of_k != EARLIER_NONE || !decide_within_range(a, r, k)) {
        decide_valence(&a->decision, &r->problem, k, &earlier, &r->options.limits);
        a->earlier = of_k;
    }
    buffer_clear(&earlier);
    return a;
}

static bool finish(long i, void *result, void *data)
{
    prove_run *r = data;
    (void)i;
    return keeper_put(&r->keeper, result);
}

bool prove_decide_each(prove_run *r)
{
    workers w = {r->list.count, (int)r->options.jobs, decide, finish, prove_discard, r};
    return workers_run(&w);
}

/* ---- in ranges ---- */

static bool take(decision *d, void *data)
{
    prove_run *r = data;
    prove_answer *a = new_answer();
    buffer unused;
    if (a) {
        a->decision = *d;
        decision_init(d);
        buffer_init(&unused);
        a->earlier = archive_read(&r->archive, &unused, a->decision.k);
        buffer_clear(&unused);
    }
    return keeper_put(&r->keeper, a);
}

/* The next entry from *i on that decides something of `open`; NULL: none.  *i is behind it, then. */
static prove_answer *find_earlier(const prove_run *r, size_t *i, valence_range open)
{
    prove_answer *a = new_answer();
    while (a && *i < r->earlier.count) {
        const archive_index_entry *e = &r->earlier.entry[*i];
        if (e->valences.first > open.last)
            break;
        ++*i;
        if (e->verdict != VERDICT_UNDECIDED && e->valences.last >= open.first && decide_as_before(a, r, e))
            return a;
    }
    prove_discard(a);
    return NULL;
}

/* What was decided before stays as it is, and boxes fill the gaps: no two certificates speak of one valence. */
static bool decide_range_of_list(prove_run *r, valence_range open)
{
    partition p = {&r->problem, &r->options.limits, take, r};
    size_t i = 0;
    while (open.first <= open.last) {
        prove_answer *a = find_earlier(r, &i, open);
        valence_range gap = {open.first, a ? a->decision.k.first - 1 : open.last};
        long last = a ? a->decision.k.last : open.last;
        if (gap.first <= gap.last && !partition_run(&p, gap)) {
            prove_discard(a);
            return false;
        }
        if (a && !keeper_put(&r->keeper, a))
            return false;
        if (last >= open.last)
            break;
        open.first = last + 1;
    }
    return true;
}

bool prove_decide_ranges(prove_run *r)
{
    bool more = true;
    for (int i = 0; more && i < r->list.ranges; i++)
        more = decide_range_of_list(r, r->list.range[i]);
    return true;
}
