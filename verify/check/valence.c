/* A scheme at one valence: which rules hold, and their weights. */

#include "valence.h"

#include "answer.h"
#include "trig.h"

#include <string.h>

enum { MAX_VALENCE_OF_EACH = 100000 };

const struct active_rule *valence_rule(const struct active_step *step, bool centre, int a,
                                       int b)
{
    for (int i = 0; i < step->rules; i++) {
        const struct rule *rule = step->rule[i].rule;

        if (rule->centre == centre && (centre || (rule->a == a && rule->b == b)))
            return &step->rule[i];
    }
    return NULL;
}

/* out = W_0 .. W_(k-1); returns their sum, which is never an angle. */
static struct value weigh_each(interval *out, const struct node *formula,
                               const struct valence *v)
{
    struct value sum = value_from(rational_from(0, 1));

    for (int64_t j = 0; j < v->k; j++) {
        struct mark mark = scratch_mark();
        struct environment e =
            environment_make(&v->scheme->language, v->k, -1, -1, j, v->g);
        struct value w = evaluate(formula, &e);

        value_require(w, &v->scheme->language, v->reference.file, v->reference.line);
        out[j] = value_enclose(w, v->g);
        value_apply(&sum, '+', &w, NULL, v->g);

        integer keep[4] = { out[j].lo, out[j].hi,
                            sum.kind == RATIONAL ? sum.q.num : sum.x.lo,
                            sum.kind == RATIONAL ? sum.q.den : sum.x.hi };

        integer_keep(mark, keep, 4);
        out[j] = (interval) { keep[0], keep[1] };
        if (sum.kind == RATIONAL)
            sum.q = (rational) { keep[2], keep[3] };
        else
            sum.x = (interval) { keep[2], keep[3] };
    }
    return sum;
}

/* The weights of the sources in order; at last the rest, 1 minus their sum. */
static void weigh(struct active_rule *out, const struct valence *v)
{
    const struct rule *rule = out->rule;
    const struct language *l = &v->scheme->language;
    struct environment plain = environment_make(l, v->k, -1, -1, -1, v->g);
    struct environment zero = environment_make(l, v->k, 0, 0, -1, v->g);
    struct value sum = value_from(rational_from(0, 1));
    struct value rest = value_from(rational_from(1, 1));

    out->weighted = allocate((size_t)rule->count, sizeof out->weighted[0]);
    for (int i = 0; i < rule->count; i++) {
        struct weighted *w = &out->weighted[i];
        struct value value;

        w->source = &rule->source[i];
        if (i == rule->rest)
            continue;
        if (w->source->kind == SOURCE_EACH) {
            if (v->k > MAX_VALENCE_OF_EACH)
                cannot_check("a weight for each sector is given up to valence 100000 only");
            w->each = allocate((size_t)v->k, sizeof w->each[0]);
            value = weigh_each(w->each, w->source->weight, v);
        } else {
            value = evaluate(w->source->weight,
                             w->source->kind == SOURCE_SPECTRUM ? &zero : &plain);
            value_require(value, l, v->reference.file, v->reference.line);
        }
        w->weight = value_enclose(value, v->g);
        value_apply(&sum, '+', &value, NULL, v->g);
    }
    value_apply(&rest, '-', &sum, NULL, v->g);
    out->weighted[rule->rest].weight = value_enclose(rest, v->g);
}

static void prepare_step(struct active_step *out, const struct step *step,
                         const struct valence *v)
{
    struct environment e = environment_make(&v->scheme->language, v->k, -1, -1, -1, v->g);

    out->step = step;
    out->stencil = stencil_make(&step->mask, step->dilation, v->g);
    out->rule = allocate((size_t)step->rules, sizeof out->rule[0]);
    for (int i = 0; i < step->rules; i++) {
        const struct rule *rule = &step->rule[i];

        if (valence_rule(out, rule->centre, rule->a, rule->b) != NULL)
            continue;                              /* the first one counts */
        if (rule->condition != NULL && !condition_holds(rule->condition, &e))
            continue;
        out->rule[out->rules].rule = rule;
        weigh(&out->rule[out->rules], v);
        out->rules++;
    }
}

/* cos and sin of 2 pi n/k, where a rule has a weight for each sector. */
static void prepare_angles(struct valence *v)
{
    bool wanted = false;

    for (int i = 0; i < v->scheme->steps; i++)
        for (int n = 0; n < v->step[i].rules; n++)
            for (int s = 0; s < v->step[i].rule[n].rule->count; s++)
                wanted = wanted || v->step[i].rule[n].weighted[s].each != NULL;
    if (!wanted)
        return;
    v->cosine = allocate((size_t)v->k, sizeof v->cosine[0]);
    v->sine = allocate((size_t)v->k, sizeof v->sine[0]);
    for (int64_t n = 0; n < v->k; n++) {
        v->cosine[n] = grid_cos_pi(rational_from(2 * n, v->k), v->g);
        v->sine[n] = grid_sin_pi(rational_from(2 * n, v->k), v->g);
    }
}

void valence_prepare(struct valence *out, const struct scheme *scheme,
                     struct reference reference, int64_t k, int g)
{
    memset(out, 0, sizeof *out);
    out->scheme = scheme;
    out->reference = reference;
    out->k = k;
    out->g = g;
    out->plainly_regular = k == (scheme->mesh == TRIANGLE ? 6 : 4);
    for (int i = 0; i < scheme->steps; i++) {
        prepare_step(&out->step[i], &scheme->step[i], out);
        out->plainly_regular = out->plainly_regular && out->step[i].rules == 0;
    }
    prepare_angles(out);
}

static bool has_value(const struct node *formula, const struct environment *e)
{
    struct mark mark = scratch_mark();
    bool out = formula == NULL || evaluate(formula, e).kind != UNDEFINED;

    scratch_release(mark);
    return out;
}

bool valence_has_values(const struct valence *v, int64_t m)
{
    struct mark mark = scratch_mark();
    struct environment e = environment_make(&v->scheme->language, v->k, m, m, -1, v->g);
    bool out = true;

    for (int i = 0; i < v->scheme->steps; i++) {
        for (int n = 0; n < v->step[i].rules; n++) {
            const struct rule *rule = v->step[i].rule[n].rule;

            for (int s = 0; s < rule->count; s++)
                if (rule->source[s].kind == SOURCE_SPECTRUM)
                    out = out && has_value(rule->source[s].weight, &e) &&
                          has_value(rule->source[s].imaginary, &e);
        }
    }
    scratch_release(mark);
    return out;
}
