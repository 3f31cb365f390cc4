/* scheme_mask.c: masks, their orbits, and what must hold for them. */
#include "scheme_reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_MASK_POINTS 300

typedef struct {
    lattice point[MAX_MASK_POINTS];
    rational weight[MAX_MASK_POINTS];
    size_t count;
    integer denominator; /* common to all weights */
} terms;

/* Masks are kept over a common denominator, which must stay within the limits, too. */
static status add_denominator(terms *t, const integer *denominator, const scheme_reader *r)
{
    integer common, missing;
    bool ok;
    integer_init(&common);
    integer_init(&missing);
    ok = integer_gcd(&common, &t->denominator, denominator) && integer_divexact(&missing, denominator, &common)
         && integer_mul(&t->denominator, &t->denominator, &missing);
    integer_clear(&common);
    integer_clear(&missing);
    if (ok && integer_bits(&t->denominator) > EXACT_MAX_BITS)
        return reader_complain(r, "with this one the weights of the mask have a common denominator of more than %s bits", "16384");
    return ok ? STATUS_OK : STATUS_NO_MEMORY;
}

static status add_term(terms *t, lattice p, const rational *weight, const scheme_reader *r)
{
    for (size_t i = 0; i < t->count; i++)
        if (t->point[i].a == p.a && t->point[i].b == p.b)
            return reader_complain(r, "a point is given a weight twice%s", " (with 'symmetric' an entry stands for its whole orbit)");
    if (t->count == MAX_MASK_POINTS)
        return reader_complain(r, "a mask may have %s points at most", "300");
    t->point[t->count] = p;
    rational_init(&t->weight[t->count]);
    return rational_set(&t->weight[t->count++], weight) ? STATUS_OK : STATUS_NO_MEMORY;
}

/* Adds the images of p under the symmetries of the regular complex, each once. */
static status add_orbit(terms *t, mesh_kind mesh, lattice p, const rational *weight, const scheme_reader *r)
{
    lattice image[12];
    int count = 0, turns = mesh_regular_valence(mesh);
    for (int i = 0; i < 2 * turns; i++) {
        bool known = false;
        for (int j = 0; j < count; j++)
            known = known || (image[j].a == p.a && image[j].b == p.b);
        if (!known)
            image[count++] = p;
        p = i == turns - 1 ? mesh_reflect_mask(p) : mesh_rotate_mask(mesh, p);
    }
    for (int j = 0; j < count; j++) {
        status s = add_term(t, image[j], weight, r);
        if (s != STATUS_OK)
            return s;
    }
    return STATUS_OK;
}

static int floor_half(int twice)
{
    return (twice - (twice % 2 != 0 && twice < 0)) / 2;
}

static status read_mask_line(terms *t, bool symmetric, scheme_reader *r)
{
    mesh_kind mesh = r->z->mesh;
    formula_point nowhere = {0, 0, 0};
    lattice p;
    rational weight;
    formula *f = NULL;
    status s = reader_point(&p, mesh, r);
    if (s == STATUS_OK) { /* offsets of dual meshes: i + 1/2 has label i */
        p = (lattice){floor_half(p.a), floor_half(p.b)};
        if (mesh_mask_reach(mesh, p) > SCHEME_MAX_REACH)
            s = reader_complain(r, "a mask point may be at most %s edges from 0", "8");
    }
    if (s == STATUS_OK)
        s = reader_formula(&f, r, 0);
    rational_init(&weight);
    if (s == STATUS_OK)
        s = formula_exact_rational(&weight, f, &nowhere, r->complaint);
    if (s == STATUS_OK)
        s = add_denominator(t, &weight.denominator, r);
    if (s == STATUS_OK)
        s = symmetric ? add_orbit(t, mesh, p, &weight, r) : add_term(t, p, &weight, r);
    rational_clear(&weight);
    formula_free(f);
    return s;
}

/* Of the new points with a, b even or odd, as the bits of `class` say.  On dual meshes every square has four new points, and
   their offsets 1/2, 5/2 ... and -1/2, 3/2 ... from old ones take the place of even and odd. */
static status complain_of_class(const scheme_reader *r, int class, const char *sum)
{
    static const char *const parity[4] = {"an even a and an even b", "an even a and an odd b", "an odd a and an even b", "an odd a and an odd b"};
    static const char *const halves[4] = {"both a and b are", "a, but not b, is", "b, but not a, is", "neither a nor b is"};
    char what[100];
    if (r->z->mesh == MESH_DUAL)
        snprintf(what, sizeof what, "(a,b) where %s among ... -3/2, 1/2, 5/2 ...", halves[class]);
    else
        snprintf(what, sizeof what, "(a,b) with %s", parity[class]);
    return diagnostic_set(r->complaint, r->line->line, r->line->column[0], "the weights of the mask at the points %s sum to %.100s, not to 1", what, sum);
}

static status check_class_sums(const scheme_reader *r, const laurent *mask)
{
    rational sum;
    status s = STATUS_OK;
    rational_init(&sum);
    for (int i = 0; s == STATUS_OK && i < 4; i++) {
        if (!laurent_class_sum(&sum, mask, i / 2, i % 2, 2)) {
            s = STATUS_NO_MEMORY;
        } else if (rational_cmp_si(&sum, 1, 1) != 0) {
            char *value = rational_get_str(&sum);
            s = value ? complain_of_class(r, i, value) : STATUS_NO_MEMORY;
            free(value);
        }
    }
    rational_clear(&sum);
    return s;
}

static bool is_invariant(const laurent *mask, mesh_kind mesh, bool rotation)
{
    for (long a = mask->a0; a < mask->a0 + mask->na; a++)
        for (long b = mask->b0; b < mask->b0 + mask->nb; b++) {
            lattice p = {(int)a, (int)b};
            lattice q = rotation ? mesh_rotate_mask(mesh, p) : mesh_reflect_mask(p);
            const integer *x = laurent_at(mask, a, b), *y = laurent_at(mask, q.a, q.b);
            if (integer_is_zero(x) ? !laurent_is_zero_at(mask, q.a, q.b) : !y || integer_cmp(x, y) != 0)
                return false;
        }
    return true;
}

/* The whole mask of a scheme whose mesh is r->z->mesh: affine, and the same seen from every sector. */
status check_mask(scheme_reader *r, const laurent *mask)
{
    status s = check_class_sums(r, mask);
    if (s == STATUS_OK && !is_invariant(mask, r->z->mesh, true))
        s = reader_complain(r, "the mask is not invariant under rotation by one sector of the regular mesh (%s), so it has no meaning at other valences",
                          r->z->mesh == MESH_TRIANGLE ? "a sixth of a turn" : "a quarter of a turn");
    return s;
}

static int mask_reach(const laurent *mask, mesh_kind mesh)
{
    int reach = 0;
    for (long i = 0; i < mask->na * mask->nb; i++) {
        lattice p = {(int)(mask->a0 + i / mask->nb), (int)(mask->b0 + i % mask->nb)};
        if (!integer_is_zero(&mask->coefficient[i]) && mesh_mask_reach(mesh, p) > reach)
            reach = mesh_mask_reach(mesh, p);
    }
    return reach;
}

scheme_step *add_step(scheme *z, mesh_kind from, mesh_kind to, int dilation, int reach)
{
    scheme_step *s;
    if (z->step_count == SCHEME_MAX_STEPS)
        return NULL;
    s = &z->steps[z->step_count++];
    memset(s, 0, sizeof *s);
    laurent_init(&s->mask);
    s->from = from;
    s->to = to;
    s->dilation = dilation;
    s->reach = reach;
    return s;
}

/* The current line begins with `mask`. */
status read_mask(scheme_reader *r)
{
    bool symmetric = reader_take_word(r, "symmetric");
    scheme_step *step;
    status s = reader_expect_end(r);
    terms *t = calloc(1, sizeof *t);
    if (!t)
        return STATUS_NO_MEMORY;
    integer_init(&t->denominator);
    integer_set_si(&t->denominator, 1);
    while (s == STATUS_OK) {
        reader_next_line(r);
        if (reader_take_word(r, "end"))
            break;
        s = r->line ? read_mask_line(t, symmetric, r) : reader_expected(r, "a mask point or 'end'");
    }
    if (s == STATUS_OK)
        s = reader_expect_end(r);
    step = add_step(r->z, r->z->mesh, r->z->mesh, 2, 0);
    if (s == STATUS_OK && !laurent_set_terms(&step->mask, t->point, t->weight, t->count))
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK)
        s = check_mask(r, &step->mask);
    if (s == STATUS_OK && !laurent_set(&r->z->mask, &step->mask))
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK) {
        step->reach = mask_reach(&step->mask, r->z->mesh);
        r->z->mirror_symmetric = is_invariant(&step->mask, r->z->mesh, false);
    }
    for (size_t i = 0; i < t->count; i++)
        rational_clear(&t->weight[i]);
    integer_clear(&t->denominator);
    free(t);
    return s;
}
