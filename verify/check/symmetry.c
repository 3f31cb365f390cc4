/* Evident mirror symmetry: lib/scheme.md, "Mirror symmetry".
 *
 * A reflection exchanges sectors: it takes the sector s to -s, and the rule of a point
 * (a,b), b > 0, to that of (b,a) in the sector 0, but the rule of a point (a,0) to that of
 * (a,0) in the sector 1.  Below, sectors are counted from the rule's own one. */

#include "scheme.h"

enum { CONSTANT_GRID = 64 };

/* Formulas
 * -------- */

/* Names written out. */
static const struct node *written_out(const struct node *f, const struct language *l)
{
    while (f->kind == NODE_NAME && l->definition[f->name].formula != NULL)
        f = l->definition[f->name].formula;
    return f;
}

/* The exact value of a formula, if it is rational and depends on nothing.  Conditions, which
 * stand in `cases` and behind `when`, have none. */
static bool is_constant(rational *out, const struct node *f, const struct language *l)
{
    struct environment e;
    struct value v;

    if (f->meaning != 0 || f->kind == NODE_AND || f->kind == NODE_OR || f->kind == NODE_COMPARISON)
        return false;
    e = environment_plain(l, CONSTANT_GRID);
    v = evaluate(f, &e);
    *out = v.q;
    return v.kind == RATIONAL;
}

static bool same_formula(const struct node *f, const struct node *g, const struct language *l)
{
    const struct node *x, *y;
    rational p, q;

    f = written_out(f, l);
    g = written_out(g, l);
    if (is_constant(&p, f, l) && is_constant(&q, g, l))
        return rational_compare(p, q) == 0;
    if (f->kind != g->kind || (f->kind == NODE_NAME && f->name != g->name))
        return false;
    if (f->kind == NODE_NUMBER && rational_compare(f->number, g->number) != 0)
        return false;
    for (x = f->first, y = g->first; x != NULL && y != NULL; x = x->next, y = y->next)
        if (x->join != y->join || !same_formula(x, y, l))
            return false;
    return x == NULL && y == NULL;
}

/* Both may be missing. */
static bool same_optional(const struct node *f, const struct node *g, const struct language *l)
{
    return f == NULL || g == NULL ? f == g : same_formula(f, g, l);
}

/* Multiplies *constant by the factors of f, which depend on nothing or are j or / k; how
 * often these occur is counted. */
static bool is_monomial(const struct node *f, char join, struct value *constant, int *js,
                        int *ks, const struct language *l)
{
    f = written_out(f, l);
    if (f->kind == NODE_J && join == '*') {
        (*js)++;
        return true;
    }
    if (f->kind == NODE_K && join == '/') {
        (*ks)++;
        return true;
    }
    if (f->meaning == 0) {
        struct environment e = environment_plain(l, CONSTANT_GRID);
        struct value v = evaluate(f, &e);

        *constant = value_apply(*constant, join, v, f, CONSTANT_GRID);
        return true;
    }
    if (f->kind != NODE_PRODUCT || join != '*')
        return false;
    for (const struct node *n = f->first; n != NULL; n = n->next)
        if (!is_monomial(n, n->join, constant, js, ks, l))
            return false;
    return true;
}

/* cos(c j / k), c an even multiple of pi */
static bool is_even_angle(const struct node *f, const struct language *l)
{
    struct value c = value_from(rational_from(1, 1));
    int js = 0, ks = 0;

    return is_monomial(f, '*', &c, &js, &ks, l) && js == 1 && ks == 1 &&
           c.kind == ANGLE &&
           rational_is_whole(rational_divide(c.q, rational_from(2, 1)));
}

/* min(j, k - j) */
static bool is_distance(const struct node *f, const struct language *l)
{
    const struct node *j = written_out(f->first, l);
    const struct node *d = written_out(f->first->next, l), *k;

    if (j->kind != NODE_J || d->kind != NODE_SUM || f->first->next->next != NULL)
        return false;
    k = d->first;
    return k->join == '+' && written_out(k, l)->kind == NODE_K && k->next != NULL &&
           k->next->join == '-' && written_out(k->next, l)->kind == NODE_J &&
           k->next->next == NULL;
}

/* j = 0 or j != 0 */
static bool is_comparison_with_zero(const struct node *f, const struct language *l)
{
    const struct node *n = f->first->next;
    rational q;

    return (n->join == '=' || n->join == '!') &&
           written_out(f->first, l)->kind == NODE_J && is_constant(&q, n, l) &&
           q.num.sign == 0;
}

/* Does the formula evidently have the same value at j and k - j (at 0: at 0)? */
static bool is_even(const struct node *f, const struct language *l)
{
    f = written_out(f, l);
    if ((f->meaning & MEANS_J) == 0)
        return true;
    if ((f->kind == NODE_COS && is_even_angle(f->first, l)) ||
        (f->kind == NODE_MIN && is_distance(f, l)) ||
        (f->kind == NODE_COMPARISON && is_comparison_with_zero(f, l)))
        return true;
    if (f->kind == NODE_J)
        return false;
    for (const struct node *n = f->first; n != NULL; n = n->next)
        if (!is_even(n, l))
            return false;
    return true;
}

/* Rules
 * ----- */

static bool on_spoke(enum mesh mesh, int b)
{
    return b == 0 && mesh != DUAL;
}

/* The mirror image of a label: (b,a), or of one on a spoke itself. */
static void reflect(enum mesh mesh, int *a, int *b)
{
    int x = *a;

    if (on_spoke(mesh, *b))
        return;
    *a = *b;
    *b = x;
}

/* The k of `when k = NUMBER', else 0. */
static int64_t only_valence(const struct rule *rule)
{
    const struct node *f = rule->condition != NULL ? rule->condition->first : NULL;
    int64_t k;

    if (f == NULL || f->next != NULL || f->first->kind != NODE_K ||
        f->first->next->join != '=' || f->first->next->kind != NODE_NUMBER ||
        !rational_is_whole(f->first->next->number) ||
        !integer_get_small(&k, f->first->next->number.num, 1000000000))
        return 0;
    return k;
}

static bool same_sector(const struct rule *rule, int s, int t)
{
    int64_t k = only_valence(rule);

    return k > 0 ? (s - t) % k == 0 : s == t;
}

/* Is t, of the image of a rule, the image of s? */
static bool is_image(const struct source *s, const struct source *t, const struct rule *rule,
                     enum mesh mesh, const struct language *l)
{
    bool spoke = on_spoke(mesh, s->b), rule_on_spoke = on_spoke(mesh, rule->b);
    int a = s->a, b = s->b, sectors = -s->sectors;

    if (spoke && !rule_on_spoke)
        sectors++;
    if (!spoke && rule_on_spoke)
        sectors--;
    reflect(mesh, &a, &b);
    if (s->kind != t->kind || !same_optional(s->weight, t->weight, l))
        return false;
    if (s->kind == SOURCE_CENTRE)
        return true;
    if (t->a != a || t->b != b)
        return false;
    switch (s->kind) {
    case SOURCE_ALL:
        return true;
    case SOURCE_ONE:
        return same_sector(rule, t->sectors, sectors);
    case SOURCE_EACH:
        return spoke == rule_on_spoke && is_even(s->weight, l);
    default:
        return spoke == rule_on_spoke && s->imaginary == NULL && t->imaginary == NULL;
    }
}

/* Can the sources be paired? */
static bool are_images(const struct rule *rule, const struct rule *other, enum mesh mesh,
                       const struct language *l)
{
    bool used[MAX_SOURCES] = { false };

    if (rule->count != other->count)
        return false;
    for (int i = 0; i < rule->count; i++) {
        int n = 0;

        while (n < other->count &&
               (used[n] || !is_image(&rule->source[i], &other->source[n], rule, mesh, l)))
            n++;
        if (n == other->count)
            return false;
        used[n] = true;
    }
    return true;
}

/* The rule of this number among those for (a,b), or NULL. */
static const struct rule *rule_number(const struct step *step, int a, int b, int number)
{
    for (int i = 0; i < step->rules; i++) {
        const struct rule *rule = &step->rule[i];

        if (!rule->centre && rule->a == a && rule->b == b && number-- == 0)
            return rule;
    }
    return NULL;
}

static bool step_is_mirrored(const struct step *step, const struct language *l)
{
    if (!mask_is_mirrored(&step->mask))
        return false;
    for (int i = 0; i < step->rules; i++) {
        const struct rule *rule = &step->rule[i], *other;
        int a = rule->a, b = rule->b, number = 0;

        if (rule->centre)
            continue;
        for (int n = 0; n < i; n++)
            if (!step->rule[n].centre && step->rule[n].a == a && step->rule[n].b == b)
                number++;
        reflect(step->new, &a, &b);
        other = a == rule->a && b == rule->b ? rule : rule_number(step, a, b, number);
        if (other == NULL || !same_optional(rule->condition, other->condition, l) ||
            !are_images(rule, other, step->old, l))
            return false;
    }
    return true;
}

bool scheme_is_mirrored(const struct scheme *scheme)
{
    for (int i = 0; i < scheme->steps; i++)
        if (!step_is_mirrored(&scheme->step[i], &scheme->language))
            return false;
    return true;
}
