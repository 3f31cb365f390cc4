/* Graded values: certificate-valences.md, section 6, "Growing without bound". */

#include "graded.h"

#include "answer.h"

/* kappa
 * ----- */

struct affine kappa_power(struct grading *s, int n)
{
    if (n > MAX_KAPPA)
        cannot_check("the checker has no power %d of q/k", n);
    for (; s->powers <= n; s->powers++)
        s->kappa[s->powers] = affine_mul(s->kappa[s->powers - 1], s->kappa[1], s->g);
    return s->kappa[n];
}

static void prepare_kappa(struct grading *s, struct span k, int64_t q)
{
    interval u = k.last == ENDLESS ? grid_from(0, s->g)
                                   : grid_from_rational(rational_from(q, k.last), s->g);

    u = interval_hull(u, grid_from_rational(rational_from(q, k.first), s->g));
    s->kappa[0] = affine_from_whole(1, s->g);
    s->kappa[1] = (struct affine) { interval_thin(interval_mid(u)),
                                    interval_thin(interval_rad(u)) };
    s->powers = 2;
}

bool grading_prepare(struct block *block, int64_t q, int degree)
{
    const struct valence *v = block->v;
    struct environment e = environment_make(&v->scheme->language, v->k, NOTHING, NOTHING, v->g);
    struct grading *s = block->own = allocate(1, sizeof *s);

    s->g = v->g;
    s->degree = degree;
    prepare_kappa(s, v->k, q);
    for (int i = 0; i < v->scheme->steps; i++) {
        const struct active_rule *rule = valence_rule(&v->step[i], true, 0, 0);
        struct laurent *w;

        if (rule == NULL)
            continue;
        w = allocate((size_t)rule->rule->count, sizeof w[0]);
        if (!laurent_weights(w, rule->rule, &e))
            return false;
        for (int n = 0; n < rule->rule->count; n++) {
            laurent_rescale(&w[n], q);             /* b_c q^c */
            block->rule[i][rule - v->step[i].rule].term[n].own = &w[n];
        }
    }
    return true;
}

/* Sums
 * ---- */

/* w kappa^-c times the value */
static void add_weighted(struct grading *s, interval w, int c, const struct graded_value *value)
{
    if (value->present)
        s->term[s->terms++] = (struct graded_value) { true, value->e - c,
                                                      affine_mul(affine_from(w), value->v, s->g) };
}

/* The centre has Laurent values for weights. */
static void add_graded_term(void *sum, const struct term *t, const void *v,
                            const struct block *block)
{
    const struct laurent *weight = t->own;
    struct grading *s = block->own;

    (void)sum;
    if (weight == NULL)
        add_weighted(s, t->m[0].c, 0, v);
    for (int c = -LAURENT_DEGREE; weight != NULL && c <= LAURENT_DEGREE; c++)
        if (laurent_at(weight, c).num.sign != 0)
            add_weighted(s, grid_from_rational(laurent_at(weight, c), s->g), c, v);
}

static void add_graded_entry(void *sum, const struct stencil_entry *e, const void *v,
                             const struct block *block)
{
    (void)sum;
    add_weighted(block->own, e->weight, 0, v);
}

static void finish_graded(void *sum, const struct block *block)
{
    struct grading *s = block->own;
    struct graded_value *out = sum;

    *out = (struct graded_value) { s->terms > 0, 0, affine_from_whole(0, s->g) };
    for (int i = 0; i < s->terms; i++)
        out->e = i == 0 || s->term[i].e < out->e ? s->term[i].e : out->e;
    for (int i = 0; i < s->terms; i++)
        out->v = affine_add(out->v, affine_mul(kappa_power(s, s->term[i].e - out->e),
                                               s->term[i].v, s->g));
    s->terms = 0;
}

/* By L kappa^-d */
static void divide_graded(void *v, struct pair l, const struct block *block)
{
    const struct grading *s = block->own;
    struct graded_value *out = v;

    *out = (struct graded_value) { out->present, s->degree + out->e,
                                   affine_div(out->v, l.x, s->g) };
}

const struct arithmetic GRADED = { sizeof(struct graded_value), NULL, add_graded_term,
                                   add_graded_entry, finish_graded, divide_graded };
