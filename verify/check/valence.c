/* A scheme at one valence or several: which rules hold, and their weights. */

#include "valence.h"

#include "answer.h"
#include "grid.h"

#include <string.h>

enum { MAX_VALENCE_OF_EACH = 100000 };

const struct active_rule *valence_rule(const struct active_step *step, bool centre, int a, int b)
{
    for (int i = 0; i < step->rules; i++) {
        const struct rule *rule = step->rule[i].rule;

        if (rule->centre == centre && (centre || (rule->a == a && rule->b == b)))
            return &step->rule[i];
    }
    return NULL;
}

bool valence_is_regular(const struct valence *v)
{
    return !span_is_several(v->k) && v->k.first == (v->scheme->mesh == TRIANGLE ? 6 : 4);
}

/* Gives back the memory since the mark, but for both. */
static void keep_both(struct mark mark, interval *x, struct value *v)
{
    bool exact = v->kind != ENCLOSURE;
    integer part[4] = { x->lo, x->hi, exact ? v->q.num : v->x.lo, exact ? v->q.den : v->x.hi };

    integer_keep(mark, part, 4);
    *x = (interval) { part[0], part[1] };
    if (exact)                                     /* and no range */
        v->q = v->q_last = (rational) { part[2], part[3] };
    else
        v->x = (interval) { part[2], part[3] };
}

/* out = W_0 .. W_(k-1); returns their sum. */
static struct value weigh_each(interval *out, const struct node *formula, const struct valence *v)
{
    struct value sum = value_from(rational_from(0, 1));

    for (int64_t j = 0; j < v->k.first; j++) {
        struct mark mark = scratch_mark();
        struct environment e =
            environment_make(&v->scheme->language, v->k, NOTHING, span_of(j), v->g);
        struct value w = evaluate(formula, &e);

        value_require(w, &v->scheme->language, v->reference.file, v->reference.line);
        out[j] = value_enclose(w, v->g);
        sum = value_apply(sum, '+', w, NULL, v->g);
        keep_both(mark, &out[j], &sum);
    }
    return sum;
}

static const struct value *keep_value(struct value v)
{
    struct value *out = allocate(1, sizeof *out);

    *out = v;
    return out;
}

/* The weights of the sources in order; at last the rest, 1 minus their sum. */
static void weigh(struct active_rule *out, const struct valence *v)
{
    const struct rule *rule = out->rule;
    const struct language *l = &v->scheme->language;
    struct environment plain = environment_make(l, v->k, NOTHING, NOTHING, v->g);
    struct environment zero = environment_make(l, v->k, span_of(0), NOTHING, v->g);
    struct value sum = value_from(rational_from(0, 1));
    struct value rest = value_from(rational_from(1, 1));

    out->weighted = allocate((size_t)rule->count, sizeof out->weighted[0]);
    for (int i = 0; i < rule->count; i++)
        out->weighted[i].source = &rule->source[i];
    for (int i = 0; i < rule->count; i++) {
        struct weighted *w = &out->weighted[i];
        struct value value;

        if (i == rule->rest)
            continue;
        if (w->source->kind == SOURCE_EACH) {
            if (span_is_several(v->k))
                rejected(v->reference.file, v->reference.line,
                         "a weight for each sector is for single valences only");
            if (v->k.first > MAX_VALENCE_OF_EACH)
                cannot_check("a weight for each sector is given up to valence 100000 only");
            w->each = allocate((size_t)v->k.first, sizeof w->each[0]);
            value = weigh_each(w->each, w->source->weight, v);
        } else {
            value = evaluate(w->source->weight,
                             w->source->kind == SOURCE_SPECTRUM ? &zero : &plain);
            if (rule->centre && span_is_several(v->k) && value_is_only_unbounded(&value)) {
                out->missing = keep_value(value);
                return;
            }
            value_require(value, l, v->reference.file, v->reference.line);
        }
        w->weight = affine_from(value_enclose(value, v->g));
        sum = value_apply(sum, '+', value, NULL, v->g);
    }
    rest = value_apply(rest, '-', sum, NULL, v->g);
    out->weighted[rule->rest].weight = affine_from(value_enclose(rest, v->g));
}

/* Of several valences it must be the same for all. */
static bool rule_holds(const struct rule *rule, const struct environment *e,
                       const struct valence *v)
{
    enum truth truth;

    if (rule->condition == NULL)
        return true;
    if (!span_is_several(v->k))
        return condition_holds(rule->condition, e);
    truth = condition_truth(rule->condition, e);
    if (truth == UNKNOWN)
        rejected(v->reference.file, v->reference.line, "the condition in line %d, column %d "
                 "of the scheme is not proved to hold at all the valences or at none",
                 rule->condition->line, rule->condition->column);
    return truth == YES;
}

/* A centre without a rule keeps its value: it is the only old point in the mask of its class. */
static void check_centre(const struct active_step *s, const struct valence *v)
{
    const struct stencil_entry *own = &s->stencil.entry[0];
    bool of_plane = s->rules == 0 && valence_is_regular(v);
    bool keeps = s->stencil.first[1] == 1 && own->a == 0 && own->b == 0;

    if (s->step->new != DUAL && valence_rule(s, true, 0, 0) == NULL && !keeps && !of_plane)
        cannot_check("the centre has no rule, and the mask does not give it its old value");
}

static void prepare_step(struct active_step *out, const struct step *step, const struct valence *v)
{
    struct environment e = environment_make(&v->scheme->language, v->k, NOTHING, NOTHING, v->g);

    out->step = step;
    out->stencil = stencil_make(&step->mask, step->dilation, v->g);
    out->rule = allocate((size_t)step->rules, sizeof out->rule[0]);
    for (int i = 0; i < step->rules; i++) {
        const struct rule *rule = &step->rule[i];
        bool late = valence_rule(out, rule->centre, rule->a, rule->b) != NULL;

        if (late && !span_is_several(v->k))
            continue;                              /* the first one counts */
        if (!rule_holds(rule, &e, v) || late)
            continue;
        out->rule[out->rules].rule = rule;
        weigh(&out->rule[out->rules], v);
        out->rules++;
    }
    check_centre(out, v);
}

enum property { NOT_EACH, UNIFORM, LOCAL, DEFINED };

/* e: for DEFINED. */
static bool source_is(enum property property, const struct rule *rule, const struct source *s,
                      const struct environment *e)
{
    const struct node none = { .kind = NODE_NUMBER };
    const struct node *w = s->weight != NULL ? s->weight : &none;
    const struct node *i = s->imaginary != NULL ? s->imaginary : &none;

    switch (property) {
    case NOT_EACH:
        return s->kind != SOURCE_EACH;
    case UNIFORM:
        return rule->centre || ((w->meaning | i->meaning) & (MEANS_K | MEANS_M)) == 0;
    case LOCAL:
        return rule->centre || s->kind == SOURCE_ONE || s->kind == SOURCE_CENTRE;
    default:
        return s->kind != SOURCE_SPECTRUM ||
               (evaluate(w, e).kind != UNDEFINED && evaluate(i, e).kind != UNDEFINED);
    }
}

/* Are all sources of the rules that hold? */
static bool sources_are(enum property property, const struct valence *v,
                        const struct environment *e)
{
    for (int i = 0; i < v->scheme->steps; i++) {
        for (int n = 0; n < v->step[i].rules; n++) {
            const struct rule *rule = v->step[i].rule[n].rule;

            for (int s = 0; s < rule->count; s++)
                if (!source_is(property, rule, &rule->source[s], e))
                    return false;
        }
    }
    return true;
}

/* cos and sin of 2 pi n/k, where a rule has a weight for each sector. */
static void prepare_angles(struct valence *v)
{
    if (sources_are(NOT_EACH, v, NULL))
        return;
    v->cosine = allocate((size_t)v->k.first, sizeof v->cosine[0]);
    v->sine = allocate((size_t)v->k.first, sizeof v->sine[0]);
    for (int64_t n = 0; n < v->k.first; n++) {
        v->cosine[n] = grid_cos_pi(rational_from(2 * n, v->k.first), v->g);
        v->sine[n] = grid_sin_pi(rational_from(2 * n, v->k.first), v->g);
    }
}

void valence_prepare(struct valence *out, const struct scheme *scheme,
                     struct reference reference, struct span k, int g)
{
    memset(out, 0, sizeof *out);
    out->scheme = scheme;
    out->reference = reference;
    out->k = k;
    out->g = g;
    out->plainly_regular = valence_is_regular(out);
    for (int i = 0; i < scheme->steps; i++) {
        prepare_step(&out->step[i], &scheme->step[i], out);
        out->plainly_regular = out->plainly_regular && out->step[i].rules == 0;
    }
    prepare_angles(out);
}

bool valence_is_uniform(const struct valence *v)
{
    return sources_are(UNIFORM, v, NULL);
}

bool valence_is_local(const struct valence *v)
{
    return sources_are(LOCAL, v, NULL);
}

bool valence_has_values(const struct valence *v, int64_t m)
{
    struct mark mark = scratch_mark();
    struct environment e = environment_make(&v->scheme->language, v->k, span_of(m), NOTHING, v->g);
    bool out = sources_are(DEFINED, v, &e);

    scratch_release(mark);
    return out;
}
