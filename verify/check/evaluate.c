/* Formulas evaluated.  They nest 64 deep, and definitions are evaluated one by one, before what
 * names them. */

#include "value.h"

#include "answer.h"

/* exact: enclosures leave it unknown. */
static enum truth decide(const struct node *condition, const struct environment *e, bool exact)
{
    enum truth out = condition->kind == NODE_AND ? YES : NO;

    for (const struct node *c = condition->first; c != NULL; c = c->next) {
        struct value a = evaluate(c->first, e), b = evaluate(c->first->next, e);
        enum truth here = value_compare(a, c->first->next->join, b, e->g);

        if (exact && (a.kind != b.kind || a.kind == ENCLOSURE))
            here = UNKNOWN;
        if (here == (condition->kind == NODE_AND ? NO : YES))
            return here;
        if (here == UNKNOWN)
            out = UNKNOWN;
    }
    return out;
}

enum truth condition_truth(const struct node *condition, const struct environment *e)
{
    struct mark mark = scratch_mark();
    enum truth out = decide(condition, e, true);

    scratch_release(mark);
    return out;
}

bool condition_holds(const struct node *condition, const struct environment *e)
{
    enum truth out = condition_truth(condition, e);

    if (out == UNKNOWN)
        cannot_check_at(e->language->file, condition->line, condition->column,
                        "this comparison cannot be decided");
    return out == YES;
}

/* Sums, products, functions of several arguments: from the left. */
static struct value evaluate_chain(const struct node *f, const struct environment *e)
{
    struct value out = evaluate(f->first, e);

    if (f->kind == NODE_SUM && f->first->join == '-')
        out = value_negate(out);
    for (const struct node *n = f->first->next; n != NULL; n = n->next) {
        if (f->kind == NODE_SUM || f->kind == NODE_PRODUCT)
            out = value_apply(out, n->join, evaluate(n, e), n, e->g);
        else if (f->kind == NODE_POWER)
            out = value_power(out, evaluate(n, e), n->join == '-', f, e->g);
        else
            out = value_function(out, evaluate(n, e), f, e->g);
    }
    if (f->first->next == NULL && f->kind != NODE_SUM)
        out = value_function(out, out, f, e->g);
    return out;
}

/* Over a range of m or k the hull of all cases that may apply, up to one that certainly does.  What
 * enclosures have decided is an enclosure, too. */
static struct value evaluate_cases(const struct node *f, const struct environment *e)
{
    bool range = (span_is_several(e->m) && (f->meaning & MEANS_M) != 0) ||
                 (span_is_several(e->k) && (f->meaning & MEANS_K) != 0);
    bool several = false, exact = true;
    struct value out = { .kind = UNDEFINED };

    for (const struct node *n = f->first; n != NULL; n = n->next->next) {
        enum truth truth = n->next == NULL ? YES : decide(n, e, true);
        const struct node *here = n->next == NULL ? n : n->next;   /* no `next`: else */

        if (truth == UNKNOWN) {
            exact = false;
            truth = decide(n, e, false);
        }
        if (truth == UNKNOWN && !range)
            return value_undefined(n, "this comparison cannot be decided", true);
        if (truth != NO)
            out = several ? value_hull(out, evaluate(here, e), here, e->g) : evaluate(here, e);
        if (truth == YES)
            return exact ? out : value_hull(out, out, here, e->g);
        several = several || truth == UNKNOWN;
    }
    return value_undefined(f, "no case certainly applies", several);
}

struct value evaluate(const struct node *f, const struct environment *e)
{
    struct mark mark = scratch_mark();
    struct value out;

    switch (f->kind) {
    case NODE_NUMBER:
        out = value_from(f->number);
        break;
    case NODE_PI:
        out = value_from(rational_from(1, 1));
        out.kind = ANGLE;
        break;
    case NODE_K:
        out = value_variable(e->k, span_is_several(e->k), f);
        break;
    case NODE_M:
        out = value_variable(e->m, span_is_several(e->k), f);
        break;
    case NODE_J:
        out = value_variable(e->j, false, f);
        break;
    case NODE_NAME:
        out = e->definition[f->name];
        break;
    case NODE_CASES:
        out = evaluate_cases(f, e);
        break;
    default:
        out = evaluate_chain(f, e);
        break;
    }
    value_keep(mark, &out);
    return out;
}

struct environment environment_make(const struct language *l, struct span k, struct span m,
                                    struct span j, int g)
{
    struct environment out = { l, k, m, j, g, NULL };

    out.definition = allocate((size_t)l->count, sizeof out.definition[0]);
    for (int i = 0; i < l->count; i++) {
        const struct definition *d = &l->definition[i];

        if (d->formula != NULL)
            out.definition[i] = evaluate(d->formula, &out);
        else if (!d->interval)
            out.definition[i] = value_from(d->low);
        else
            out.definition[i] = value_enclosure(
                interval_hull(grid_from_rational(d->low, g), grid_from_rational(d->high, g)));
    }
    return out;
}

struct environment environment_plain(const struct language *l, int g)
{
    return environment_make(l, NOTHING, NOTHING, NOTHING, g);
}
