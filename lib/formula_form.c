/* formula_form.c: what can be seen of formulas by their form, without values. */
#include "formula.h"

static const formula *resolved(const formula *f)
{
    while (f && f->kind == FORMULA_REFERENCE)
        f = f->definition;
    return f;
}

bool formula_is_same(const formula *f, const formula *g)
{
    f = resolved(f);
    g = resolved(g);
    if (f == g)
        return true; /* the same node: for intervals that is the only way */
    if (!f || !g || f->kind != g->kind || f->op != g->op || f->children != g->children || f->size != g->size || f->kind == FORMULA_INTERVAL)
        return false;
    if (f->kind == FORMULA_NUMBER && rational_cmp(&f->number, &g->number) != 0)
        return false;
    for (int i = 0; i < f->children; i++)
        if (!formula_is_same(f->child[i], g->child[i]))
            return false;
    return true;
}

/* ---- does a formula in j stay the same if j = 1 .. k-1 becomes k - j? ---- */

static bool is_variable(const formula *f, char name)
{
    f = resolved(f);
    return f->kind == FORMULA_VARIABLE && f->op == name;
}

static bool is_number_zero(const formula *f)
{
    f = resolved(f);
    return f->kind == FORMULA_NUMBER && rational_is_zero(&f->number);
}

/* f = factor * j^powers[0] * k^powers[1], multiplied into what is there, or divided if sign = -1: a product in which j is
   multiplied by and k divided by, as the page says, and nothing that would come to the same (other programs would have to
   see it, too).  false: it is no such product, or no memory. */
static bool multiply_monomial(exact_value *factor, int powers[2], const formula *f, int sign)
{
    formula_point nowhere = {0, 0, 0};
    exact_value x;
    bool known, ok;
    f = resolved(f);
    if (f->kind == FORMULA_VARIABLE && f->op == (sign > 0 ? 'j' : 'k')) {
        powers[f->op == 'k'] += sign;
        return true;
    }
    if (f->depends) {
        if (sign < 0 || f->kind != FORMULA_BINARY || (f->op != '*' && f->op != '/'))
            return false;
        return multiply_monomial(factor, powers, f->child[0], 1) && multiply_monomial(factor, powers, f->child[1], f->op == '*' ? 1 : -1);
    }
    exact_init(&x);
    ok = formula_exact(&x, &known, f, &nowhere, NULL) == STATUS_OK && known && exact_binary(factor, factor, sign > 0 ? '*' : '/', &x) == EXACT_OK;
    exact_clear(&x);
    return ok;
}

/* Is f = 2 pi n j / k with a whole number n? */
static bool is_whole_turn(const formula *f)
{
    int powers[2] = {0, 0};
    exact_value factor;
    bool ok;
    exact_init(&factor);
    ok = rational_set_si(&factor.q, 1, 1) && multiply_monomial(&factor, powers, f, 1) && powers[0] == 1 && powers[1] == -1 && factor.is_angle
         && rational_mul_2exp(&factor.q, &factor.q, -1) && rational_is_integer(&factor.q);
    exact_clear(&factor);
    return ok;
}

/* min(j, k - j) */
static bool is_distance(const formula *f)
{
    const formula *other;
    if (f->kind != FORMULA_MIN || f->children != 2 || !is_variable(f->child[0], 'j'))
        return false;
    other = resolved(f->child[1]);
    return other->kind == FORMULA_BINARY && other->op == '-' && is_variable(other->child[0], 'k') && is_variable(other->child[1], 'j');
}

/* j = 0 or j != 0, which hold for both or none. */
static bool is_comparison_with_zero(const formula *f)
{
    if (f->kind != FORMULA_COMPARE || (f->op != '=' && f->op != '!'))
        return false;
    return is_variable(f->child[0], 'j') && is_number_zero(f->child[1]);
}

bool formula_is_even_in_sector(const formula *f)
{
    f = resolved(f);
    if (!f || !(f->depends & FORMULA_ON_SECTOR) || is_distance(f) || is_comparison_with_zero(f))
        return true;
    if (f->kind == FORMULA_VARIABLE)
        return false;
    if (f->kind == FORMULA_COS_SIN && f->op == 'c' && is_whole_turn(f->child[0]))
        return true;
    for (int i = 0; i < f->children; i++)
        if (!formula_is_even_in_sector(f->child[i]))
            return false;
    return true; /* a function of what stays the same */
}
