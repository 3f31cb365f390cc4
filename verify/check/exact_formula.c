/* Exact values of formulas: section 3 of exact.md.  A formula that has no value by lib/scheme.md
 * may have an exact one (1/x, where no enclosure shows that x is not 0). */

#include "exact_formula.h"

#include <string.h>

enum { MAX_EXACT_EXPONENT = 16384 };               /* as in value.c */

/* Sums and products, from the left. */
static bool chain_value(void *out, const struct node *f, const struct environment *e,
                        const struct ring *r)
{
    void *term = allocate(1, r->size);

    r->set(out, rational_from(f->kind == NODE_SUM ? 0 : 1, 1));
    for (const struct node *n = f->first; n != NULL; n = n->next)
        if (!ring_value(term, n, e, r) || !r->apply(out, n->join, term, r->field))
            return false;
    return true;
}

static bool power_value(void *out, const struct node *f, const struct environment *e,
                        const struct ring *r)
{
    const struct node *exponent = f->first->next;
    struct value value = evaluate(exponent, e);
    void *base = allocate(1, r->size);
    int64_t n;

    if (value.kind != RATIONAL || value.range || !rational_is_whole(value.q) ||
        !integer_get_small(&n, value.q.num, r->most))
        return false;
    n = exponent->join == '-' ? -n : n;
    if (n < r->least || !ring_value(base, f->first, e, r))
        return false;
    r->set(out, rational_from(1, 1));
    for (int64_t i = n < 0 ? -n : n; i > 0; i--)
        if (!r->apply(out, '*', base, r->field))
            return false;
    if (n >= 0)
        return true;
    memcpy(base, out, r->size);
    r->set(out, rational_from(1, 1));
    return r->apply(out, '/', base, r->field);
}

static bool cases_value(void *out, const struct node *f, const struct environment *e,
                        const struct ring *r)
{
    for (const struct node *n = f->first; n != NULL; n = n->next->next) {
        enum truth truth = n->next == NULL ? YES : condition_truth(n, e);

        if (truth == UNKNOWN)
            return false;
        if (truth == YES)
            return ring_value(out, n->next == NULL ? n : n->next, e, r);
    }
    return false;
}

bool ring_value(void *out, const struct node *f, const struct environment *e, const struct ring *r)
{
    const struct node *formula;

    if (r->simple(out, f, e, r->field))
        return true;
    switch (f->kind) {
    case NODE_NAME:
        formula = e->language->definition[f->name].formula;
        return formula != NULL && ring_value(out, formula, e, r);
    case NODE_SUM:
    case NODE_PRODUCT:
        return chain_value(out, f, e, r);
    case NODE_POWER:
        return power_value(out, f, e, r);
    case NODE_CASES:
        return cases_value(out, f, e, r);
    default:
        return false;
    }
}

/* Numbers of a field
 * ------------------ */

static void set_number(void *out, rational q)
{
    *(struct number *)out = number_from(q);
}

/* What is rational by lib/scheme.md; cosines and sines of angles. */
static bool simple_number(void *out, const struct node *f, const struct environment *e,
                          const void *field)
{
    bool sine = f->kind == NODE_SIN;
    struct value value = evaluate(f, e), angle;

    if (value.kind == RATIONAL && !value.range) {
        set_number(out, value.q);
        return true;
    }
    if (f->kind != NODE_COS && !sine)
        return false;
    angle = evaluate(f->first, e);
    return angle.kind == ANGLE && !angle.range &&
           number_cos_pi(out, sine ? rational_sub(rational_from(1, 2), angle.q) : angle.q, field);
}

/* Quotients by rational numbers only. */
static bool apply_to_numbers(void *a, char operation, void *b, const void *field)
{
    struct number *x = a;
    rational q;

    if (operation == '+') {
        *x = number_add(x, b);
    } else if (operation == '-') {
        *x = number_sub(x, b);
    } else if (operation == '*') {
        *x = number_mul(x, b, field);
    } else {
        if (!number_get_rational(&q, b) || q.num.sign == 0)
            return false;
        *x = number_scale(rational_divide(rational_from(1, 1), q), x, field);
    }
    return true;
}

bool exact_value(struct number *out, const struct node *f, const struct environment *e,
                 const struct field *k)
{
    const struct ring ring = { sizeof *out, 0, MAX_EXACT_EXPONENT, k, simple_number, set_number,
                               apply_to_numbers };

    return ring_value(out, f, e, &ring);
}
