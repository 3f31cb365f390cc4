/* The decisions: section 8 of certificate.md.
 *
 * An element is decided with a function (boundary: the values) or two
 * (regularity: d1 and d2).  A patch holds, for an element, the intervals of one
 * function on the element's window.  The patch of a child comes from that of its
 * parent by the refinement rule: with the anchor of the child at twice the anchor
 * of the parent plus (a,b), relative labels are related by
 *
 *     new(x) = sum over y of q(x + (a,b) - 2y) old(y).
 */

#include "decide.h"

#include "answer.h"

enum { MAX_DEPTH = 60, MAX_FUNCTIONS = 2 };

/* The half-planes that a piece of the curve visits, by number: x > 0, y > 0, x < 0, y < 0; and the
 * quarters of a turn that it makes, counted by them. */
struct path {
    bool begun;
    int first, last, turns;
};

struct tree {
    const struct characteristic *c;
    const struct certificate *certificate;
    const char *name;                              /* for messages */
    int line;
    const char *next, *end;                        /* the word */
    int functions;
    const struct refinable *f[MAX_FUNCTIONS];
    bool (*decide)(struct tree *t, const struct pair *box);
    bool (*decide_coefficients)(struct tree *t, enum element_kind kind,
                                struct pair *const *coefficient);
    struct path path;                              /* of `winding`: the element's */
};

/* The patches of an element. */
struct patches {
    struct pair *of[MAX_FUNCTIONS];
};

static struct patches new_patches(const struct tree *t, enum element_kind kind)
{
    struct patches out = { { NULL } };

    for (int i = 0; i < t->functions; i++)
        out.of[i] = allocate((size_t)t->f[i]->window[kind].count, sizeof out.of[i][0]);
    return out;
}

static struct affine middle(struct affine x)
{
    return (struct affine) { interval_thin(interval_mid(x.c)),
                             interval_thin(interval_mid(x.d)) };
}

/* Level 0: the midpoints. */
static struct patches start_patches(const struct tree *t, const struct element *e)
{
    struct patches out = new_patches(t, e->kind);

    for (int i = 0; i < t->functions; i++) {
        const struct window *window = &t->f[i]->window[e->kind];

        for (int n = 0; n < window->count; n++) {
            struct pair v = characteristic_at(t->c, t->f[i], e->a + window->label[n].a,
                                              e->b + window->label[n].b);

            out.of[i][n].x = middle(v.x);
            out.of[i][n].y = middle(v.y);
        }
    }
    return out;
}

/* The value at the label (a,b), relative to twice the anchor of the old patch. */
static struct pair refine_label(const struct pair *old, const struct window *window,
                                const struct stencil *mask, int a, int b, int g)
{
    struct mark mark = scratch_mark();
    int class = stencil_class(mask, a, b);
    struct affine sum[2] = { affine_from_whole(0, g), affine_from_whole(0, g) };

    for (int i = mask->first[class]; i < mask->first[class + 1]; i++) {
        const struct stencil_entry *e = &mask->entry[i];
        int index = window_index(window, (a - e->a) / 2, (b - e->b) / 2);

        if (index < 0)
            cannot_check("the checker's windows are too small");
        affine_add_multiple(&sum[0], e->weight, &old[index].x, g);
        affine_add_multiple(&sum[1], e->weight, &old[index].y, g);
    }
    affine_keep(mark, sum, 2);
    return (struct pair) { sum[0], sum[1] };
}

static struct patches refine_patches(const struct tree *t, const struct patches *old,
                                     enum element_kind kind, const struct child *child)
{
    struct patches out = new_patches(t, child->kind);

    for (int i = 0; i < t->functions; i++) {
        const struct window *window = &t->f[i]->window[child->kind];

        for (int n = 0; n < window->count; n++)
            out.of[i][n] = refine_label(old->of[i], &t->f[i]->window[kind],
                                        &t->f[i]->mask, window->label[n].a + child->a,
                                        window->label[n].b + child->b, t->c->block->v->g);
    }
    return out;
}

/* Boxes
 * ----- */

/* [mid(H) - e, mid(H) + e], e = ceil(T (rad(H) + rho)/1024); in version 0 H widened by
 * rho. */
static interval widened(interval hull, integer rho, const struct refinable *f,
                        bool version_0)
{
    integer mid = interval_mid(hull), e;

    if (version_0)
        return interval_of(integer_sub(hull.lo, rho), integer_add(hull.hi, rho));
    e = integer_mul(integer_from(f->stability), integer_add(interval_rad(hull), rho));
    e = integer_shift_ceil(e, 10);
    return interval_of(integer_sub(mid, e), integer_add(mid, e));
}

/* c and d each. */
static struct affine widened_parts(struct affine hull, struct error rho,
                                   const struct refinable *f, bool version_0)
{
    hull.c = widened(hull.c, rho.c, f, version_0);
    if (!interval_is_zero(hull.d) || rho.d.sign != 0)
        hull.d = widened(hull.d, rho.d, f, version_0);
    return hull;
}

static struct pair patch_box(const struct pair *patch, const struct refinable *f,
                             enum element_kind kind, bool version_0)
{
    struct pair hull = patch[0];

    for (int i = 1; i < f->window[kind].count; i++) {
        hull.x = affine_hull(hull.x, patch[i].x);
        hull.y = affine_hull(hull.y, patch[i].y);
    }
    hull.x = widened_parts(hull.x, f->rho_x, f, version_0);
    hull.y = widened_parts(hull.y, f->rho_y, f, version_0);
    return hull;
}

static struct affine determinant(const struct pair *v, const struct pair *w, int g)
{
    return affine_sub(affine_mul(v->x, w->y, g), affine_mul(v->y, w->x, g));
}

/* det(d1, d2) > 0 */
static bool jacobian_is_positive(struct tree *t, const struct pair *box)
{
    return affine_is_positive(determinant(&box[0], &box[1], t->c->block->v->g));
}

/* nx x + ny y > 0 */
static bool half_plane_contains(struct tree *t, const struct pair *box)
{
    const int64_t *n = t->certificate->normal;
    int g = t->c->block->v->g;

    return affine_is_positive(affine_add(affine_scale(grid_from(n[0], g), box->x, g),
                                         affine_scale(grid_from(n[1], g), box->y, g)));
}

/* det(d1, d2) < 0 */
static bool jacobian_is_negative(struct tree *t, const struct pair *box)
{
    struct pair turned[2] = { box[1], box[0] };

    return jacobian_is_positive(t, turned);
}

static bool is_not_zero(struct tree *t, const struct pair *box)
{
    (void)t;
    return !interval_contains_zero(affine_range(box->x)) ||
           !interval_contains_zero(affine_range(box->y));
}

/* Appends what goes on where a path ends; what they share is in both half-planes. */
static void join_paths(const struct tree *t, struct path *path, struct path next)
{
    int change = path->begun ? (next.first - path->last + 4) % 4 : 0;

    if (change == 2)
        rejected(t->certificate->file, t->line, "%s: the curve is not followed from one "
                 "leaf to the next", t->name);
    path->turns += (change == 3 ? -1 : change) + next.turns;
    path->last = next.last;
    if (!path->begun)
        path->first = next.first;
    path->begun = true;
}

/* Appends the first half-plane that contains the box, if there is one. */
static bool follow(struct tree *t, const struct pair *box)
{
    const interval x = affine_range(box->x), y = affine_range(box->y);
    const interval positive[4] = { x, y, interval_minus(x), interval_minus(y) };

    for (int i = 0; i < 4; i++) {
        if (interval_is_positive(positive[i])) {
            join_paths(t, &t->path, (struct path) { true, i, i, 0 });
            return true;
        }
    }
    return false;
}

/* Coefficients
 * ------------ */

/* All coefficients of the Jacobian: the sum of d1_i and d2_j with i j = g. */
static bool jacobian_coefficients_are_positive(struct tree *t,
                                               enum element_kind kind,
                                               struct pair *const *c)
{
    const struct basis *p = &t->f[0]->basis[kind], *q = &t->f[1]->basis[kind];
    int side_a = p->side_a + q->side_a - 1, side_b = p->side_b + q->side_b - 1;
    int g = t->c->block->v->g;

    for (int a = 0; a < side_a; a++) {
        for (int b = 0; b < (p->triangular ? side_a - a : side_b); b++) {
            struct affine sum = affine_from_whole(0, g);

            for (int i = 0; i < p->side_a && i <= a; i++) {
                for (int j = 0; j < p->side_b && j <= b; j++) {
                    if (!basis_has(p, kind, i, j) || !basis_has(q, kind, a - i, b - j))
                        continue;
                    sum = affine_add(sum, determinant(&c[0][i * p->side_b + j],
                                     &c[1][(a - i) * q->side_b + b - j], g));
                }
            }
            if (!affine_is_positive(sum))
                return false;
        }
    }
    return true;
}

static bool half_plane_contains_coefficients(struct tree *t, enum element_kind kind,
                                             struct pair *const *c)
{
    const struct basis *p = &t->f[0]->basis[kind];

    for (int i = 0; i < p->side_a; i++)
        for (int j = 0; j < p->side_b; j++)
            if (basis_has(p, kind, i, j) && !half_plane_contains(t, &c[0][i * p->side_b + j]))
                return false;
    return true;
}

/* [-rho, rho] */
static struct affine around_zero(struct error rho)
{
    return (struct affine) { { integer_negate(rho.c), rho.c },
                             { integer_negate(rho.d), rho.d } };
}

/* The patch with its values widened by rho. */
static struct pair *widened_patch(const struct pair *patch, const struct refinable *f,
                                  int count)
{
    struct pair *out = allocate((size_t)count, sizeof out[0]);
    struct affine x = around_zero(f->rho_x), y = around_zero(f->rho_y);

    for (int n = 0; n < count; n++) {
        out[n].x = affine_add(patch[n].x, x);
        out[n].y = affine_add(patch[n].y, y);
    }
    return out;
}

/* Trees
 * ----- */

static void check_leaf(struct tree *t, const struct patches *patches,
                       enum element_kind kind, int depth, const struct element *e)
{
    struct pair box[MAX_FUNCTIONS];

    for (int i = 0; i < t->functions; i++)
        box[i] = patch_box(patches->of[i], t->f[i], kind, t->c->version_0);
    if (!t->decide(t, box))
        rejected(t->certificate->file, t->line,
                 "%s: a leaf of level %d in %s(%d,%d) is not decided", t->name,
                 depth, element_form[e->kind].name, e->a, e->b);
}

static void check_coefficients(struct tree *t, const struct patches *patches,
                               enum element_kind kind, int depth, const struct element *e)
{
    struct pair *coefficient[MAX_FUNCTIONS];

    for (int i = 0; i < t->functions; i++) {
        const struct refinable *f = t->f[i];

        if (!f->has_basis)
            rejected(t->certificate->file, t->line, "%s: the letter 2 is for masks of box "
                     "splines only", t->name);
        coefficient[i] = basis_coefficients(&f->basis[kind], &f->window[kind],
            widened_patch(patches->of[i], f, f->window[kind].count), t->c->block->v->g);
    }
    if (!t->decide_coefficients(t, kind, coefficient))
        rejected(t->certificate->file, t->line, "%s: a leaf of level %d in %s(%d,%d) is not "
                 "decided by coefficients", t->name, depth, element_form[e->kind].name,
                 e->a, e->b);
}

/* Checks the tree of an element of this kind and these patches, which is part of the
 * element e of level 0. */
static void check_tree(struct tree *t, const struct patches *patches,
                       enum element_kind kind, int depth, const struct element *e)
{
    struct mark mark = scratch_mark();
    char letter;

    if (t->next == t->end)
        rejected(t->certificate->file, t->line, "%s: the word is too short", t->name);
    letter = *t->next++;
    if (letter != '1') {
        if (letter == '0')
            check_leaf(t, patches, kind, depth, e);
        else
            check_coefficients(t, patches, kind, depth, e);
        scratch_release(mark);
        return;
    }
    if (depth == MAX_DEPTH)
        cannot_check_at(t->certificate->file, t->line, 0,
                        "%s: expected trees of a depth of at most %d", t->name,
                        MAX_DEPTH);
    for (int i = 0; i < element_form[kind].children; i++) {
        const struct child *child = &element_form[kind].child[i];
        struct patches next = refine_patches(t, patches, kind, child);

        check_tree(t, &next, child->kind, depth + 1, e);
        scratch_release(mark);
    }
}

static void check_element(struct tree *t, const struct element *e)
{
    struct mark mark = scratch_mark();
    struct patches patches = start_patches(t, e);

    check_tree(t, &patches, e->kind, 0, e);
    scratch_release(mark);
}

static void check_end(const struct tree *t)
{
    if (t->next != t->end)
        rejected(t->certificate->file, t->line, "%s: the word is too long", t->name);
}

static void check_elements(struct tree *t, const struct element *element, int elements)
{
    for (int i = 0; i < elements; i++)
        check_element(t, &element[i]);
    check_end(t);
}

static struct tree regularity_tree(const struct characteristic *c,
                                   const struct certificate *certificate)
{
    struct tree out = {
        .c = c, .certificate = certificate,
        .name = "regularity", .line = certificate->regularity.line,
        .next = certificate->regularity.word,
        .end = certificate->regularity.word + certificate->regularity.size,
        .functions = 2, .f = { &c->first, &c->second },
        .decide = jacobian_is_positive,
        .decide_coefficients = jacobian_coefficients_are_positive
    };

    return out;
}

static struct tree boundary_tree(const struct characteristic *c,
                                 const struct certificate *certificate)
{
    struct tree out = {
        .c = c, .certificate = certificate,
        .name = "boundary", .line = certificate->boundary.line,
        .next = certificate->boundary.word,
        .end = certificate->boundary.word + certificate->boundary.size,
        .functions = 1, .f = { &c->value },
        .decide = half_plane_contains,
        .decide_coefficients = half_plane_contains_coefficients
    };

    return out;
}

void decide_regularity(const struct characteristic *c,
                       const struct certificate *certificate)
{
    struct tree t = regularity_tree(c, certificate);

    check_elements(&t, c->element, c->elements);
}

void decide_boundary(const struct characteristic *c,
                     const struct certificate *certificate)
{
    struct tree t = boundary_tree(c, certificate);

    check_elements(&t, c->segment, c->segments);
}

/* Refutations
 * ----------- */

void decide_outer_curve(const struct characteristic *c,
                        const struct certificate *certificate)
{
    struct tree t = boundary_tree(c, certificate);

    t.decide = is_not_zero;
    check_elements(&t, c->segment, c->segments);
}

static struct path reversed(struct path p)
{
    return (struct path) { p.begun, p.last, p.first, -p.turns };
}

/* Is 2 pi/k not between (Q - 2) pi/2 and (Q + 2) pi/2? */
static bool winds_otherwise(int q, int64_t k)
{
    return k * (q - 2) >= 4 || k * (q + 2) <= 4;
}

/* The curve runs through elements G against the order of their leaves. */
void decide_winding(const struct characteristic *c, const struct certificate *certificate)
{
    struct tree t = boundary_tree(c, certificate);
    struct path curve = { .begun = false };
    int64_t k = c->block->v->k.first;

    t.decide = follow;
    for (int i = 0; i < c->segments; i++) {
        t.path = (struct path) { .begun = false };
        check_element(&t, &c->segment[i]);
        join_paths(&t, &curve, c->segment[i].kind == ELEMENT_G ? reversed(t.path) : t.path);
    }
    check_end(&t);
    if (!winds_otherwise(curve.turns, k))
        rejected(certificate->file, t.line, "boundary: the curve may wind once (it makes %d "
                 "quarters of a turn in a sector)", curve.turns);
}

/* The boxes on the descendant that the witness names. */
static void find_witness(struct pair box[MAX_FUNCTIONS], const struct tree *t,
                         const struct element *element, int elements,
                         const struct witness *w)
{
    struct patches patches;
    enum element_kind kind;

    if (w->element >= elements)
        rejected(t->certificate->file, w->line, "witness: there are %d elements", elements);
    if (w->path_size > MAX_DEPTH)
        cannot_check_at(t->certificate->file, w->line, 0,
                        "witness: expected a depth of at most %d", MAX_DEPTH);
    patches = start_patches(t, &element[w->element]);
    kind = element[w->element].kind;
    for (size_t i = 0; i < w->path_size; i++) {
        int number = w->path[i] - '0';

        if (number >= element_form[kind].children)
            rejected(t->certificate->file, w->line, "witness: there is no child %d", number);
        patches = refine_patches(t, &patches, kind, &element_form[kind].child[number]);
        kind = element_form[kind].child[number].kind;
    }
    for (int i = 0; i < t->functions; i++)
        box[i] = patch_box(patches.of[i], t->f[i], kind, t->c->version_0);
}

/* What t decides holds there. */
static void check_witness(struct tree *t, const struct element *element,
                          int elements, const struct witness *w)
{
    struct mark mark = scratch_mark();
    struct pair box[MAX_FUNCTIONS];

    find_witness(box, t, element, elements, w);
    if (!t->decide(t, box))
        rejected(t->certificate->file, w->line, "witness: it does not show what it should");
    scratch_release(mark);
}

void decide_not_zero(const struct characteristic *c, const struct certificate *certificate)
{
    struct tree t = boundary_tree(c, certificate);

    t.decide = is_not_zero;
    check_witness(&t, c->segment, c->segments, &certificate->witness[0]);
}

void decide_fold(const struct characteristic *c, const struct certificate *certificate)
{
    struct tree t = regularity_tree(c, certificate);

    check_witness(&t, c->element, c->elements, &certificate->witness[0]);
    t.decide = jacobian_is_negative;
    check_witness(&t, c->element, c->elements, &certificate->witness[1]);
}

/* Is one of the four determinants of a part of c and a part of d not 0? */
static bool is_independent(const struct pair c[2], const struct pair d[2], int g)
{
    const struct affine of_c[2][2] = { { c[0].x, c[1].x }, { c[0].y, c[1].y } };
    const struct affine of_d[2][2] = { { d[0].x, d[1].x }, { d[0].y, d[1].y } };

    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            struct affine det = affine_sub(affine_mul(of_c[i][0], of_d[j][1], g),
                                           affine_mul(of_c[i][1], of_d[j][0], g));

            if (!interval_contains_zero(affine_range(det)))
                return true;
        }
    }
    return false;
}

void decide_independent(const struct characteristic *c, const struct characteristic *d,
                        const struct certificate *certificate)
{
    struct tree t = regularity_tree(c, certificate), of_d = regularity_tree(d, certificate);
    struct pair box[2][MAX_FUNCTIONS];
    const struct witness *w = &certificate->witness[0];

    find_witness(box[0], &t, c->element, c->elements, w);
    find_witness(box[1], &of_d, d->element, d->elements, w);
    if (!is_independent(box[0], box[1], c->block->v->g))
        rejected(certificate->file, w->line, "witness: it does not show what it should");
}
