/* Exact values of formulas: section 3 of exact.md.  A formula that has no value by lib/scheme.md
 * may have an exact one (1/x, where no enclosure shows that x is not 0). */

#include "exact_formula.h"

enum { MAX_EXPONENT = 16384 };                     /* as in value.c */

/* a := a / b for a rational b that is not 0. */
static bool divide(struct number *a, const struct number *b)
{
    rational q;

    if (!number_get_rational(&q, b) || q.num.sign == 0)
        return false;
    *a = number_scale(rational_divide(rational_from(1, 1), q), a);
    return true;
}

/* Sums and products, from the left. */
static bool chain_value(struct number *out, const struct node *f,
                        const struct environment *e, const struct field *k)
{
    struct number b;

    if (!exact_value(out, f->first, e, k))
        return false;
    if (f->kind == NODE_SUM && f->first->join == '-')
        *out = number_minus(out);
    for (const struct node *n = f->first->next; n != NULL; n = n->next) {
        if (!exact_value(&b, n, e, k))
            return false;
        if (n->join == '+')
            *out = number_add(out, &b);
        else if (n->join == '-')
            *out = number_sub(out, &b);
        else if (n->join == '*')
            *out = number_mul(out, &b, k);
        else if (!divide(out, &b))
            return false;
    }
    return true;
}

static bool power_value(struct number *out, const struct node *f,
                        const struct environment *e, const struct field *k)
{
    const struct node *exponent = f->first->next;
    struct value value = evaluate(exponent, e);
    struct number base;
    int64_t n;

    if (value.kind != RATIONAL || value.range || !rational_is_whole(value.q) ||
        !integer_get_small(&n, value.q.num, MAX_EXPONENT))
        return false;
    n = exponent->join == '-' ? -n : n;
    if (n < 0 || !exact_value(&base, f->first, e, k))
        return false;
    *out = number_from_whole(1);
    for (; n > 0; n--)
        *out = number_mul(out, &base, k);
    return true;
}

static bool cosine_value(struct number *out, const struct node *f,
                         const struct environment *e, const struct field *k)
{
    struct value angle = evaluate(f->first, e);

    if (angle.kind != ANGLE || angle.range)
        return false;
    if (f->kind == NODE_SIN)
        angle.q = rational_sub(rational_from(1, 2), angle.q);
    return number_cos_pi(out, angle.q, k);
}

static bool cases_value(struct number *out, const struct node *f,
                        const struct environment *e, const struct field *k)
{
    for (const struct node *n = f->first; n != NULL; n = n->next->next) {
        enum truth truth = n->next == NULL ? YES : condition_truth(n, e);

        if (truth == UNKNOWN)
            return false;
        if (truth == YES)
            return exact_value(out, n->next == NULL ? n : n->next, e, k);
    }
    return false;
}

bool exact_value(struct number *out, const struct node *f, const struct environment *e,
                 const struct field *k)
{
    struct value value = evaluate(f, e);
    const struct node *formula;

    if (value.kind == RATIONAL && !value.range) {
        *out = number_from(value.q);
        return true;
    }
    switch (f->kind) {
    case NODE_NAME:
        formula = e->language->definition[f->name].formula;
        return formula != NULL && exact_value(out, formula, e, k);
    case NODE_SUM:
    case NODE_PRODUCT:
        return chain_value(out, f, e, k);
    case NODE_POWER:
        return power_value(out, f, e, k);
    case NODE_COS:
    case NODE_SIN:
        return cosine_value(out, f, e, k);
    case NODE_CASES:
        return cases_value(out, f, e, k);
    default:
        return false;
    }
}
