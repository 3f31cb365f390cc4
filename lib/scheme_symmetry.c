/* scheme_symmetry.c: are the rules of a scheme evidently the same seen in a mirror?

   The mirror exchanges the points (a,b) and (b,a) of the sector.  A point (a,b) of the sector s, b > 0, goes to (b,a) of
   the sector -s; (a,0), on a spoke, to (a,0) of the sector 1 - s.  A rule for (a,a) or the centre must be its own image.
   So must a rule for (a,0), whose image is the rule for (a,0) of the sector 1: there -s becomes -1 - s, and 1 - s, -s.  Any
   other rule for (a,b) must be the image of one for (b,a). */
#include "scheme_reader.h"

typedef struct {
    bool known;
    rational value;
} weight_value;

static bool is_spoke(mesh_kind mesh, lattice p)
{
    return mesh != MESH_DUAL && p.b == 0;
}

static bool is_own_image(const rule *r, mesh_kind mesh)
{
    return r->at_centre || is_spoke(mesh, r->point) || r->point.a == r->point.b;
}

static lattice image_of_point(mesh_kind mesh, lattice p)
{
    return is_spoke(mesh, p) ? p : (lattice){p.b, p.a};
}

/* The sector in which the image of a source of the sector s lies, seen from the image of the rule. */
static int image_of_sector(const rule *r, mesh_kind mesh, lattice point, int s)
{
    bool from_spoke = !r->at_centre && is_spoke(mesh, r->point);
    return (is_spoke(mesh, point) ? 1 - s : -s) - from_spoke;
}

/* The valence at which alone the rule holds, when its condition is `k = NUMBER`; else 0. */
static long only_valence(const rule *r)
{
    const formula *f = r->condition;
    if (!f || f->kind != FORMULA_COMPARE || f->op != '=' || f->child[0]->kind != FORMULA_VARIABLE || f->child[1]->kind != FORMULA_NUMBER
        || !rational_is_integer(&f->child[1]->number) || integer_bits(&f->child[1]->number.numerator) > 30)
        return 0;
    return (long)integer_get_si(&f->child[1]->number.numerator);
}

/* Sectors are counted round and round where the valence is known. */
static bool is_same_sector(const rule *r, int s, int t)
{
    long k = only_valence(r);
    return k > 0 ? (s - t) % k == 0 : s == t;
}

/* Weights that are exact numbers are equal if the numbers are, all others if they are written in the same way. */
static bool is_same_weight(const source *x, const weight_value *vx, const source *y, const weight_value *vy)
{
    if (vx->known && vy->known)
        return rational_cmp(&vx->value, &vy->value) == 0;
    return formula_is_same(x->weight, y->weight);
}

/* Is y, a source of the image of r, the image of x? */
static bool is_image(const rule *r, mesh_kind mesh, const source *x, const source *y)
{
    lattice p = image_of_point(mesh, x->point);
    if (x->kind != y->kind)
        return false;
    if (x->kind == SOURCE_CENTRE)
        return true;
    if (p.a != y->point.a || p.b != y->point.b)
        return false;
    switch (x->kind) {
    case SOURCE_ALL:
        return true;
    case SOURCE_POINT:
        return is_same_sector(r, image_of_sector(r, mesh, x->point, x->offset), y->offset);
    case SOURCE_SECTORS: /* j becomes -j; where it becomes 1 - j or -1 - j nothing is evident */
        return image_of_sector(r, mesh, x->point, 0) == 0 && formula_is_even_in_sector(x->weight);
    default: /* real spectra have weights that are the same for j and -j */
        return image_of_sector(r, mesh, x->point, 0) == 0 && !x->imaginary && !y->imaginary;
    }
}

/* false: no memory. */
static bool evaluate(weight_value *values, const rule *r)
{
    formula_point nowhere = {0, 0, 0};
    for (int i = 0; i < r->count; i++) {
        const formula *f = r->sources[i].weight;
        status s = STATUS_BAD_INPUT;
        if (f && !f->depends)
            s = formula_exact_rational(&values[i].value, f, &nowhere, NULL);
        if (s == STATUS_NO_MEMORY)
            return false;
        values[i].known = s == STATUS_OK;
    }
    return true;
}

/* Can the sources of s be paired with those of r such that each is the image of its partner? */
static bool find_partners(const rule *r, const weight_value *vr, const rule *s, const weight_value *vs, mesh_kind mesh)
{
    bool taken[SCHEME_MAX_SOURCES] = {false};
    for (int i = 0; i < r->count; i++) {
        int j = 0;
        while (j < s->count && (taken[j] || !is_image(r, mesh, &r->sources[i], &s->sources[j]) || !is_same_weight(&r->sources[i], &vr[i], &s->sources[j], &vs[j])))
            j++;
        if (j == s->count)
            return false;
        taken[j] = true;
    }
    return r->count == s->count;
}

/* *symmetric = is s the image of r? */
static bool compare_rules(bool *symmetric, const rule *r, const rule *s, mesh_kind mesh)
{
    weight_value vr[SCHEME_MAX_SOURCES], vs[SCHEME_MAX_SOURCES];
    bool ok;
    for (int i = 0; i < SCHEME_MAX_SOURCES; i++) {
        rational_init(&vr[i].value);
        rational_init(&vs[i].value);
    }
    ok = evaluate(vr, r) && evaluate(vs, s);
    *symmetric = ok && formula_is_same(r->condition, s->condition) && find_partners(r, vr, s, vs, mesh);
    for (int i = 0; i < SCHEME_MAX_SOURCES; i++) {
        rational_clear(&vr[i].value);
        rational_clear(&vs[i].value);
    }
    return ok;
}

/* The rule whose image rules[i] must be: itself, or the one for the image of its point that comes as late among those for
   that point.  NULL: there is none. */
static const rule *partner_of(const scheme_step *step, int i, mesh_kind mesh)
{
    const rule *r = &step->rules[i];
    lattice p = image_of_point(mesh, r->point);
    int before = 0;
    if (is_own_image(r, mesh))
        return r;
    for (int j = 0; j < i; j++)
        before += !step->rules[j].at_centre && step->rules[j].point.a == r->point.a && step->rules[j].point.b == r->point.b;
    for (int j = 0; j < step->rule_count; j++)
        if (!step->rules[j].at_centre && step->rules[j].point.a == p.a && step->rules[j].point.b == p.b && before-- == 0)
            return &step->rules[j];
    return NULL;
}

status find_symmetry(bool *symmetric, const scheme_step *step, mesh_kind mesh)
{
    *symmetric = true;
    for (int i = 0; *symmetric && i < step->rule_count; i++) {
        const rule *partner = partner_of(step, i, mesh);
        if (!partner)
            *symmetric = false;
        else if (!compare_rules(symmetric, partner, &step->rules[i], mesh))
            return STATUS_NO_MEMORY;
    }
    return STATUS_OK;
}
