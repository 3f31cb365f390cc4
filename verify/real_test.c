/* real_test.c: a simple real eigenvalue of block 0 or k/2, and one of a pair of blocks, or of block 0 after k/2, next to it (verify/certificate.md, section
   10).  Compiled once per number system. */
#include "tests.h"

#include <string.h>

/* Is the modulus of the second eigenvalue smaller? */
static bool is_second_smaller(const analysis *a)
{
    bool smaller;
    number first, second;
    number_init(&first);
    number_init(&second);
    number_abs(&first, &a->box[a->order]);
    number_abs(&second, &a->other.box[a->other.order]);
    smaller = number_less(&second, &first) == TRUTH_TRUE;
    number_clear(&first);
    number_clear(&second);
    return smaller;
}

outcome test_second(analysis *a)
{
    choices *c = a->choices;
    double lower = a->findings->eigenvalue_lower, upper = a->findings->eigenvalue_upper;
    outcome o;
    if (!a->plan->problem->scheme->mirror_symmetric)
        return findings_explain(a->findings, OUTCOME_FALSE, "the scheme is not evidently mirror-symmetric");
    if (c->frequency != 0 && 2 * c->frequency != c->k.first)
        return findings_explain(a->findings, OUTCOME_FALSE, "block %ld is not of real nets", c->frequency);
    analysis_exchange(a);
    o = test_eigenpair(a);
    analysis_exchange(a);
    if (o == OUTCOME_TRUE && (c->eigenpair.complex_form || c->second.complex_form || !is_second_smaller(a)))
        o = findings_explain(a->findings, OUTCOME_FAIL, "the eigenvalue of block %ld could not be shown to be smaller than that of block %ld", c->second_frequency, c->frequency);
    a->findings->eigenvalue_lower = lower;
    a->findings->eigenvalue_upper = upper;
    return o;
}

/* ---- the Jacobian of both ---- */

/* Exchanges one component of x with one of y. */
static void exchange_component(charnet_windows *x, int i, charnet_windows *y, int j)
{
    number **p = i ? &x->y : &x->x, **q = j ? &y->y : &y->x, *t = *p;
    *p = *q;
    *q = t;
    number_swap(&x->radius[i], &y->radius[j]);
}

block_status real_windows(charnet_windows *z, const analysis *a, int which, const element *elements, int count)
{
    const ring *g = &a->plan->problem->geometry;
    charnet_windows second;
    block_status made = charnet_windows_make(z, &a->net, g, which, elements, count, a->prec), more;
    if (made != BLOCK_OK)
        return made;
    more = charnet_windows_make(&second, &a->other.net, g, which, elements, count, a->prec);
    if (more == BLOCK_OK) {
        if (a->mixed[0] == 1)
            exchange_component(z, 0, z, 1);
        exchange_component(z, 1, &second, a->mixed[1]);
    }
    charnet_windows_free(&second);
    return more;
}

/* One component of each and one sign after the other. */
static outcome seek_jacobian(analysis *a)
{
    const ring *g = &a->plan->problem->geometry;
    outcome o = OUTCOME_FALSE;
    for (int i = 0; o == OUTCOME_FALSE && i < 8; i++) {
        const int mixed[2] = {i / 4, i / 2 % 2};
        const long sign = i % 2 ? -1 : 1;
        adaptive_task task = {.nets = 2, .which = {RING_FIRST, RING_SECOND}, .quantity = analysis_signed_jacobian, .data = &sign, .boxes_only = true};
        a->mixed = mixed;
        o = analysis_seek(a, &task, &a->choices->witness[0], g->elements, g->element_count);
        a->mixed = NULL;
    }
    return o;
}

outcome test_real(analysis *a)
{
    outcome o;
    analysis_exchange(a);
    o = analysis_make_net(a);
    analysis_exchange(a);
    if (o == OUTCOME_TRUE)
        o = analysis_make_net(a);
    if (o == OUTCOME_TRUE)
        o = seek_jacobian(a);
    if (o == OUTCOME_FALSE)
        findings_explain(a->findings, o, "the Jacobian of both eigenfunctions could not be shown to be other than 0 anywhere on the ring");
    return o;
}
