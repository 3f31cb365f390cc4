/* The decisions: section 8 of certificate.md.
 *
 * An element is decided with a function (boundary: the values) or two (regularity: d1 and d2).  A
 * patch holds, for an element, the intervals of one function on the element's window.  The patch of
 * a child comes from that of its parent by the refinement rule: with the anchor of the child at
 * twice the anchor of the parent plus (a,b), relative labels are related by
 *
 *     new(x) = sum over y of q(x + (a,b) - 2y) old(y).
 */

#include "characteristic.h"

#include "answer.h"

enum { MAX_DEPTH = 60, MAX_FUNCTIONS = 2 };

/* The half-planes that a piece of the curve visits, by number: x > 0, y > 0, x < 0, y < 0; and the
 * quarters of a turn that it makes, counted by them. */
struct path {
    bool begun;
    int first, last, turns;
};

/* What the functions are on an element: all coefficients.  A box is that of a constant. */
struct leaf {
    enum element_kind kind;
    const struct basis *basis[MAX_FUNCTIONS];
    struct pair *value[MAX_FUNCTIONS];
};

static const struct basis CONSTANT = { .side_a = 1, .side_b = 1 };

struct tree {
    const struct characteristic *c;
    const struct certificate *certificate;
    const char *name;                              /* for messages */
    int line, g;
    const char *next, *end;                        /* the word */
    int elements;
    const struct element *element;
    int functions;
    const struct refinable *f[MAX_FUNCTIONS];
    bool (*decide)(struct tree *t, const struct leaf *l);
    struct path path;                              /* of `winding`: the element's */
};

/* The patches of an element. */
struct patches {
    enum element_kind kind;
    struct pair *of[MAX_FUNCTIONS];
};

static struct patches new_patches(const struct tree *t, enum element_kind kind)
{
    struct patches out = { kind, { NULL } };

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
                                     const struct child *child)
{
    struct patches out = new_patches(t, child->kind);

    for (int i = 0; i < t->functions; i++) {
        const struct window *window = &t->f[i]->window[child->kind];

        for (int n = 0; n < window->count; n++)
            out.of[i][n] = refine_label(old->of[i], &t->f[i]->window[old->kind],
                                        &t->f[i]->mask, window->label[n].a + child->a,
                                        window->label[n].b + child->b, t->g);
    }
    return out;
}

/* Leaves
 * ------ */

/* [mid(H) - e, mid(H) + e], e = ceil(T (rad(H) + rho)/1024); in version 0 H widened by rho. */
static interval widened(interval hull, interval rho, const struct refinable *f, bool version_0)
{
    integer mid = interval_mid(hull), e;

    if (version_0)
        return interval_add(hull, rho);
    e = integer_mul(integer_from(f->stability), integer_add(interval_rad(hull), rho.hi));
    e = integer_shift_ceil(e, 10);
    return interval_of(integer_sub(mid, e), integer_add(mid, e));
}

/* c and d each. */
static struct affine widened_parts(struct affine hull, struct affine rho,
                                   const struct refinable *f, bool version_0)
{
    hull.c = widened(hull.c, rho.c, f, version_0);
    if (!interval_is_zero(hull.d) || !interval_is_zero(rho.d))
        hull.d = widened(hull.d, rho.d, f, version_0);
    return hull;
}

static struct leaf box_leaf(const struct tree *t, const struct patches *patches)
{
    struct leaf out = { .kind = patches->kind };

    for (int i = 0; i < t->functions; i++) {
        const struct refinable *f = t->f[i];
        struct pair *hull = out.value[i] = allocate(1, sizeof *hull);

        out.basis[i] = &CONSTANT;
        *hull = patches->of[i][0];
        for (int n = 1; n < f->window[patches->kind].count; n++) {
            hull->x = affine_hull(hull->x, patches->of[i][n].x);
            hull->y = affine_hull(hull->y, patches->of[i][n].y);
        }
        hull->x = widened_parts(hull->x, f->rho.x, f, t->c->version_0);
        hull->y = widened_parts(hull->y, f->rho.y, f, t->c->version_0);
    }
    return out;
}

/* Those of the patches with their values widened by rho. */
static struct leaf coefficient_leaf(const struct tree *t, const struct patches *patches)
{
    struct leaf out = { .kind = patches->kind };

    for (int i = 0; i < t->functions; i++) {
        const struct refinable *f = t->f[i];
        const struct window *window = &f->window[patches->kind];

        if (!f->has_basis)
            rejected(t->certificate->file, t->line, "%s: the letter 2 is for masks of box "
                     "splines only", t->name);
        for (int n = 0; n < window->count; n++)
            patches->of[i][n] = pair_add(patches->of[i][n], f->rho);
        out.basis[i] = &f->basis[patches->kind];
        out.value[i] = basis_coefficients(out.basis[i], window, patches->of[i], t->g);
    }
    return out;
}

/* The coefficient (i,j) of function n, or NULL where it has none. */
static const struct pair *coefficient(const struct leaf *l, int n, int i, int j)
{
    const struct basis *b = l->basis[n];

    return i >= 0 && j >= 0 && basis_has(b, l->kind, i, j) ? &l->value[n][i * b->side_b + j] : NULL;
}

/* What leaves show
 * ---------------- */

static struct affine determinant(const struct pair *v, const struct pair *w, int g)
{
    return affine_sub(affine_mul(v->x, w->y, g), affine_mul(v->y, w->x, g));
}

/* det(d1, d2) > 0 for all coefficients: the sums of those of d1_i and d2_j with i j = g. */
static bool jacobian_is_positive(struct tree *t, const struct leaf *l)
{
    const struct basis *p = l->basis[0], *q = l->basis[1];
    int side_a = p->side_a + q->side_a - 1, side_b = p->side_b + q->side_b - 1;

    for (int a = 0; a < side_a; a++) {
        for (int b = 0; b < (p->triangular ? side_a - a : side_b); b++) {
            struct affine sum = affine_from_whole(0, t->g);

            for (int i = 0; i <= a; i++) {
                for (int j = 0; j <= b; j++) {
                    const struct pair *v = coefficient(l, 0, i, j);
                    const struct pair *w = coefficient(l, 1, a - i, b - j);

                    if (v != NULL && w != NULL)
                        sum = affine_add(sum, determinant(v, w, t->g));
                }
            }
            if (!affine_is_positive(sum))
                return false;
        }
    }
    return true;
}

/* det(d1, d2) < 0 for the boxes */
static bool jacobian_is_negative(struct tree *t, const struct leaf *l)
{
    return affine_is_positive(determinant(l->value[1], l->value[0], t->g));
}

/* nx x + ny y > 0 */
static bool half_plane_contains(struct tree *t, const struct leaf *l)
{
    const integer *n = t->certificate->normal;
    struct affine nx = affine_from(interval_thin(integer_shift_left(n[0], t->g)));
    struct affine ny = affine_from(interval_thin(integer_shift_left(n[1], t->g)));

    for (int i = 0; i < l->basis[0]->side_a; i++) {
        for (int j = 0; j < l->basis[0]->side_b; j++) {
            const struct pair *v = coefficient(l, 0, i, j);

            if (v != NULL && !affine_is_positive(affine_add(affine_mul(nx, v->x, t->g),
                                                            affine_mul(ny, v->y, t->g))))
                return false;
        }
    }
    return true;
}

static bool is_not_zero(struct tree *t, const struct leaf *l)
{
    (void)t;
    return !interval_contains_zero(affine_range(l->value[0]->x)) ||
           !interval_contains_zero(affine_range(l->value[0]->y));
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
static bool follow(struct tree *t, const struct leaf *l)
{
    const interval x = affine_range(l->value[0]->x), y = affine_range(l->value[0]->y);
    const interval positive[4] = { x, y, interval_minus(x), interval_minus(y) };

    for (int i = 0; i < 4; i++) {
        if (interval_is_positive(positive[i])) {
            join_paths(t, &t->path, (struct path) { true, i, i, 0 });
            return true;
        }
    }
    return false;
}

/* Trees
 * ----- */

static struct tree make_tree(const struct characteristic *c, const struct certificate *certificate,
                             bool (*shows)(struct tree *t, const struct leaf *l))
{
    bool of_jacobian = shows == jacobian_is_positive;
    const struct trees *trees = of_jacobian ? &certificate->regularity : &certificate->boundary;
    struct tree out = {
        .c = c, .certificate = certificate, .g = c->block->v->g, .decide = shows,
        .name = of_jacobian ? "regularity" : "boundary", .line = trees->line,
        .next = trees->word, .end = trees->word + trees->size,
        .elements = of_jacobian ? c->elements : c->segments,
        .element = of_jacobian ? c->element : c->segment,
        .functions = of_jacobian ? 2 : 1,
        .f = { &c->f[of_jacobian ? 1 : 0], &c->f[2] }
    };

    return out;
}

/* Checks the tree of an element of these patches, which is part of the element e of level 0. */
static void check_tree(struct tree *t, const struct patches *patches, int depth,
                       const struct element *e)
{
    struct mark mark = scratch_mark();
    struct leaf leaf;
    char letter;

    if (t->next == t->end)
        rejected(t->certificate->file, t->line, "%s: the word is too short", t->name);
    letter = *t->next++;
    if (letter != '1') {
        leaf = letter == '0' ? box_leaf(t, patches) : coefficient_leaf(t, patches);
        if (!t->decide(t, &leaf))
            rejected(t->certificate->file, t->line, "%s: a leaf of level %d in %s(%d,%d) is not "
                     "decided%s", t->name, depth, element_form[e->kind].name, e->a, e->b,
                     letter == '0' ? "" : " by coefficients");
        scratch_release(mark);
        return;
    }
    if (depth == MAX_DEPTH)
        cannot_check_at(t->certificate->file, t->line, 0,
                        "%s: expected trees of a depth of at most %d", t->name,
                        MAX_DEPTH);
    for (int i = 0; i < element_form[patches->kind].children; i++) {
        struct patches next = refine_patches(t, patches, &element_form[patches->kind].child[i]);

        check_tree(t, &next, depth + 1, e);
        scratch_release(mark);
    }
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

/* All trees; returns the path of the curve, if it is followed.  The curve runs through elements G
 * against the order of their leaves. */
static struct path check_trees(struct tree t)
{
    struct path curve = { .begun = false };

    for (int i = 0; i < t.elements; i++) {
        const struct element *e = &t.element[i];
        struct mark mark = scratch_mark();
        struct patches patches = start_patches(&t, e);

        t.path = (struct path) { .begun = false };
        check_tree(&t, &patches, 0, e);
        if (t.path.begun)
            join_paths(&t, &curve, e->kind == ELEMENT_G ? reversed(t.path) : t.path);
        scratch_release(mark);
    }
    if (t.next != t.end)
        rejected(t.certificate->file, t.line, "%s: the word is too long", t.name);
    return curve;
}

static void check_winding(const struct characteristic *c, const struct certificate *certificate)
{
    int turns = check_trees(make_tree(c, certificate, follow)).turns;

    if (!winds_otherwise(turns, c->block->v->k.first))
        rejected(certificate->file, certificate->boundary.line, "boundary: the curve may wind "
                 "once (it makes %d quarters of a turn in a sector)", turns);
}

/* Witnesses
 * --------- */

/* The boxes on the descendant that the witness names. */
static struct leaf find_witness(const struct tree *t, const struct witness *w)
{
    struct patches patches;

    if (w->element >= t->elements)
        rejected(t->certificate->file, w->line, "witness: there are %d elements", t->elements);
    if (w->path_size > MAX_DEPTH)
        cannot_check_at(t->certificate->file, w->line, 0,
                        "witness: expected a depth of at most %d", MAX_DEPTH);
    patches = start_patches(t, &t->element[w->element]);
    for (size_t i = 0; i < w->path_size; i++) {
        const struct element_form *form = &element_form[patches.kind];
        int number = w->path[i] - '0';

        if (number >= form->children)
            rejected(t->certificate->file, w->line, "witness: there is no child %d", number);
        patches = refine_patches(t, &patches, &form->child[number]);
    }
    return box_leaf(t, &patches);
}

static void expect_witness(bool shows, const struct certificate *c, const struct witness *w)
{
    if (!shows)
        rejected(c->file, w->line, "witness: it does not show what it should");
}

/* What t decides holds there. */
static void check_witness(struct tree t, const struct witness *w)
{
    struct leaf leaf = find_witness(&t, w);

    expect_witness(t.decide(&t, &leaf), t.certificate, w);
}

/* Is one of the four determinants of a part of c and a part of d not 0? */
static bool is_independent(const struct leaf *c, const struct leaf *d, int g)
{
    const struct pair of_c[2] = { { c->value[0]->x, c->value[1]->x },
                                  { c->value[0]->y, c->value[1]->y } };
    const struct pair of_d[2] = { { d->value[0]->x, d->value[1]->x },
                                  { d->value[0]->y, d->value[1]->y } };

    for (int i = 0; i < 4; i++)
        if (!interval_contains_zero(affine_range(determinant(&of_c[i / 2], &of_d[i % 2], g))))
            return true;
    return false;
}

void decide_independent(const struct characteristic *c, const struct characteristic *d,
                        const struct certificate *certificate)
{
    struct tree t = make_tree(c, certificate, jacobian_is_positive);
    struct tree u = make_tree(d, certificate, jacobian_is_positive);
    const struct witness *w = &certificate->witness[0];
    struct leaf of_c = find_witness(&t, w), of_d = find_witness(&u, w);

    expect_witness(is_independent(&of_c, &of_d, t.g), certificate, w);
}

/* All of it
 * --------- */

void decide_claim(const struct characteristic *c, const struct certificate *certificate)
{
    struct tree jacobian = make_tree(c, certificate, jacobian_is_positive);

    switch (certificate->reason) {
    case REASON_NONE:
        check_trees(jacobian);
        check_trees(make_tree(c, certificate, half_plane_contains));
        break;
    case REASON_FREQUENCY:
    case REASON_JORDAN:
        check_trees(make_tree(c, certificate, is_not_zero));
        break;
    case REASON_WINDING:
        check_winding(c, certificate);
        break;
    case REASON_FOLD:
        check_witness(jacobian, &certificate->witness[0]);
        jacobian.decide = jacobian_is_negative;
        check_witness(jacobian, &certificate->witness[1]);
        break;
    default:                                       /* a function that is not 0 */
        check_witness(make_tree(c, certificate, is_not_zero), &certificate->witness[0]);
    }
}
