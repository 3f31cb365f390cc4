/* rise.c: the proof for one arc, and the search for long ones. */
#include "rise.h"

#include "eigenpair_affine.h"
#include "scheme_range.h"
#include "stop.h"
#include "stride.h"

#define MOST_FAILURES 24

/* What one proof needs. */
typedef struct {
    const scheme *s;
    valence_range k;
    long prec;
    diagnostic *complaint;
} context;

/* What is known of one arc. */
typedef struct {
    block_status status;
    truth proved; /* TRUTH_FALSE: no memory */
} arc_answer;

/* Point 3.  power: between least and most. */
static truth prove_rest(int *power, const affine *box, const affine_matrix *b, int pivot, int least, int most, long prec)
{
    spectral_answer answer;
    number scale;
    number_init(&scale);
    affine_range(&scale, &box[b->n], prec);
    number_lower(&scale, &scale, prec);
    number_inv(&scale, &scale, prec);
    number_upper(&scale, &scale, prec);
    answer = affine_contract_rest(b->entry, box, b->n, pivot, &scale, least, most, prec);
    *power = answer.power;
    number_clear(&scale);
    return answer.contracts;
}

/* Points 1 to 3; the choices are made, or, if least = most, followed. */
static truth prove_matrix(rise_box *choice, const affine_matrix *b, int least, int most, long g, long prec)
{
    int n = b->n;
    affine *box = affine_array_new((size_t)n + 1);
    truth t = box ? TRUTH_TRUE : TRUTH_FALSE;
    if (t == TRUTH_TRUE && most > least)
        t = eigenpair_affine_choose(&choice->eigenpair, b->entry, n, g, prec);
    if (t == TRUTH_TRUE)
        t = eigenpair_affine_prove(box, &choice->eigenpair, b->entry, n, prec);
    if (t == TRUTH_TRUE && (affine_is_positive(&box[n]) != TRUTH_TRUE || number_is_positive(&box[n].slope) != TRUTH_TRUE))
        t = TRUTH_UNKNOWN;
    if (t == TRUTH_TRUE)
        t = prove_rest(&choice->power, box, b, choice->eigenpair.pivot, least, most, prec);
    affine_array_free(box, (size_t)n + 1);
    return t;
}

static arc_answer prove_arc(rise_box *choice, int64_t from, const context *c, int least, int most, long g)
{
    arc_answer z = {BLOCK_NO_MEMORY, TRUTH_UNKNOWN};
    affine_matrix b = {0, NULL};
    arc r;
    arc_init(&r);
    if (arc_set_units(&r, from, choice->q)) {
        z.status = affine_matrix_make(&b, c->s, c->k, (frequencies){1, FREQUENCIES_UNBOUNDED}, &r, c->prec, c->complaint);
        if (z.status == BLOCK_OK)
            z.proved = prove_matrix(choice, &b, least, most, g, c->prec);
        if (z.proved == TRUTH_FALSE)
            z.status = BLOCK_NO_MEMORY;
    }
    affine_matrix_free(&b);
    arc_clear(&r);
    return z;
}

/* Where the chain ends, if it can be one at all. */
static rise_answer start(const rise_list *list, const context *c)
{
    rise_answer z = {.status = BLOCK_OK};
    bool vary;
    status s = scheme_weights_vary(&vary, c->s, c->k, c->complaint);
    if (s != STATUS_OK)
        z.status = s == STATUS_BAD_INPUT ? BLOCK_BAD_INPUT : BLOCK_NO_MEMORY;
    z.constant = s == STATUS_OK && !vary && c->s->mirror_symmetric;
    z.end = list->count ? list->box[list->count - 1].q : arc_units_below(1, c->k.last);
    return z;
}

static bool stops(rise_answer *z)
{
    z->stopped = stop_now();
    return z->stopped;
}

rise_answer rise_search(rise_list *list, const scheme *s, valence_range k, int64_t goal, size_t most, const cover_limits *limits, long g, long prec, diagnostic *d)
{
    const context c = {s, k, prec, d};
    rise_answer z = start(list, &c);
    stride width = stride_start(z.end ? (double)z.end / 2 : (double)goal);
    int failures = 0;
    while (z.status == BLOCK_OK && z.constant && z.end < goal && list->count < most && failures < MOST_FAILURES && z.tries < limits->tries && !stops(&z)) {
        long here = stride_width(&width, goal - z.end);
        rise_box *box = rise_list_add(list);
        arc_answer r = {BLOCK_NO_MEMORY, TRUTH_UNKNOWN};
        if (box) {
            box->q = z.end + here;
            r = prove_arc(box, z.end, &c, 0, limits->power, g);
        }
        z.status = r.status;
        z.tries++;
        if (r.proved == TRUTH_TRUE) {
            z.end = box->q;
            failures = 0;
            stride_after_success(&width, (double)here);
        } else if (box) {
            eigenpair_choice_clear(&box->eigenpair);
            list->count--;
            failures = here == 1 ? MOST_FAILURES : failures + 1;
            stride_after_failure(&width, (double)here);
        }
    }
    z.proved = z.status == BLOCK_OK && z.constant && z.end >= goal;
    return z;
}

rise_answer rise_verify(const rise_list *list, const scheme *s, valence_range k, long prec, diagnostic *d)
{
    const rise_list none = {NULL, 0, 0};
    const context c = {s, k, prec, d};
    rise_answer z = start(&none, &c);
    for (size_t i = 0; z.status == BLOCK_OK && z.constant && i < list->count && !stops(&z); i++) {
        rise_box *box = &list->box[i];
        int power = box->power;
        arc_answer r = {BLOCK_OK, TRUTH_UNKNOWN};
        if (power >= 0 && box->q > z.end && box->q <= ARC_HALF)
            r = prove_arc(box, z.end, &c, power, power, 0);
        z.status = r.status;
        z.tries++;
        if (r.proved != TRUTH_TRUE)
            return z;
        z.end = box->q;
    }
    z.proved = z.status == BLOCK_OK && z.constant && !z.stopped;
    return z;
}
