/* limit.c: the pair, its slope, and the rest. */
#include "limit.h"

#include "eigenpair_affine.h"
#include "resting_centre.h"

/* hi(S_mu) + max(hi(S_L), 0) < 0 */
static bool falls_behind(const affine *eigenvalue, const number *slope, long prec)
{
    number sum, other;
    bool falls;
    number_init(&sum);
    number_init(&other);
    number_upper(&other, slope, prec);
    number_max(&sum, &sum, &other, prec);
    number_upper(&other, &eigenvalue->slope, prec);
    number_add(&sum, &sum, &other, prec);
    falls = number_is_negative(&sum) == TRUTH_TRUE;
    number_clear(&sum);
    number_clear(&other);
    return falls;
}

static truth prove_box(rise_box *z, affine *box, const affine_matrix *b, const limit_task *task, bool search, int most, long g, long prec)
{
    truth t = TRUTH_TRUE;
    if (search)
        t = eigenpair_affine_choose(&z->eigenpair, b->entry, b->n, g, prec);
    if (t == TRUTH_TRUE)
        t = eigenpair_affine_prove(box, &z->eigenpair, b->entry, b->n, prec);
    if (t == TRUTH_TRUE && (affine_is_positive(&box[b->n]) != TRUTH_TRUE || !falls_behind(&box[b->n], task->slope, prec)))
        t = TRUTH_UNKNOWN;
    if (t == TRUTH_TRUE) {
        spectral_answer rest = affine_contract_rest(b->entry, box, b->n, z->eigenpair.pivot, task->scale, search ? 0 : most, most, prec);
        z->power = rest.power;
        t = rest.contracts;
    }
    return t;
}

static limit_answer prove(rise_box *z, const limit_task *task, bool search, int most, long g, long prec, diagnostic *d)
{
    limit_answer answer = {BLOCK_OK, false, false};
    affine_matrix b = {0, NULL};
    status s = scheme_centre_rests(&answer.applies, task->scheme, task->k, d);
    if (s != STATUS_OK)
        answer.status = s == STATUS_BAD_INPUT ? BLOCK_BAD_INPUT : BLOCK_NO_MEMORY;
    if (s != STATUS_OK || !answer.applies)
        return answer;
    answer.status = affine_matrix_make_resting(&b, task->scheme, task->k, prec, d);
    if (answer.status == BLOCK_OK) {
        affine *box = affine_array_new((size_t)b.n + 1);
        truth t = box ? prove_box(z, box, &b, task, search, most, g, prec) : TRUTH_FALSE;
        answer.proved = t == TRUTH_TRUE;
        if (t == TRUTH_FALSE)
            answer.status = BLOCK_NO_MEMORY;
        affine_array_free(box, (size_t)b.n + 1);
    }
    affine_matrix_free(&b);
    return answer;
}

limit_answer limit_search(rise_box *z, const limit_task *task, int power, long g, long prec, diagnostic *d)
{
    return prove(z, task, true, power, g, prec, d);
}

limit_answer limit_verify(const rise_box *z, const limit_task *task, long prec, diagnostic *d)
{
    rise_box copy = *z; /* which a replay leaves as it is */
    if (z->power < 0)
        return (limit_answer){BLOCK_OK, false, false};
    return prove(&copy, task, false, z->power, 0, prec, d);
}
