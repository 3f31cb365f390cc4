/* The decisions: section 8 of certificate.md.
 *
 * An element is decided with a function (boundary: the values) or two
 * (regularity: d1 and d2).  A patch holds, for an element, the intervals of one
 * function on the element's window.  The patch of a child comes from that of its
 * parent by the refinement rule: with the anchor of the child at twice the anchor
 * of the parent plus (a,b), relative points are related by
 *
 *     new(x) = sum over y of q(x + (a,b) - 2y) old(y).
 */

#include "decide.h"

#include "answer.h"

#include <stdlib.h>

enum { MAX_DEPTH = 60, MAX_FUNCTIONS = 2 };

struct tree {
    const struct characteristic *c;
    const struct certificate *certificate;
    const char *name;                              /* for messages */
    int line;
    const char *next, *end;                        /* the word */
    int functions;
    const struct refinable *f[MAX_FUNCTIONS];
    struct pair *patch[MAX_DEPTH + 1][MAX_FUNCTIONS];      /* by depth */
    bool (*decide)(const struct tree *t, const struct pair *box);
};

/* Patches
 * ------- */

/* Level 0: the midpoints. */
static void start_patch(struct pair *out, const struct characteristic *c,
                        const struct refinable *f, enum element_kind kind, int a,
                        int b)
{
    const struct window *window = &f->window[kind];
    struct pair value;
    integer mid;

    for (int i = 0; i < window->count; i++) {
        characteristic_at(&value, c, f, a + window->point[i].a,
                          b + window->point[i].b);
        interval_mid(&mid, &value.x);
        interval_set_thin(&out[i].x, &mid);
        interval_mid(&mid, &value.y);
        interval_set_thin(&out[i].y, &mid);
    }
}

/* The value at the point (a,b), relative to twice the anchor of the old patch. */
static void refine_point(struct pair *out, const struct pair *old,
                         const struct window *window, const struct stencil *mask,
                         int a, int b, int g)
{
    interval product;

    grid_set_small(&out->x, 0, g);
    grid_set_small(&out->y, 0, g);
    for (int i = 0; i < mask->count; i++) {
        const struct stencil_entry *entry = &mask->entry[i];
        int twice_a = a - entry->a, twice_b = b - entry->b, y;

        if (twice_a % 2 != 0 || twice_b % 2 != 0)
            continue;
        y = window_index(window, twice_a / 2, twice_b / 2);
        if (y < 0)
            cannot_check("the checker's windows are not closed under refinement");
        grid_mul(&product, &entry->weight, &old[y].x, g);
        interval_add(&out->x, &out->x, &product);
        grid_mul(&product, &entry->weight, &old[y].y, g);
        interval_add(&out->y, &out->y, &product);
    }
}

static void refine_patch(struct pair *out, const struct pair *old,
                         const struct refinable *f, enum element_kind kind,
                         const struct child *child, int g)
{
    const struct window *window = &f->window[child->kind];

    for (int i = 0; i < window->count; i++)
        refine_point(&out[i], old, &f->window[kind], &f->mask,
                     window->point[i].a + child->a, window->point[i].b + child->b, g);
}

/* The box of an element: the hull of its patch, widened by rho. */
static void patch_box(struct pair *out, const struct pair *patch,
                      const struct refinable *f, enum element_kind kind)
{
    pair_set(out, &patch[0]);
    for (int i = 1; i < f->window[kind].count; i++) {
        interval_hull(&out->x, &out->x, &patch[i].x);
        interval_hull(&out->y, &out->y, &patch[i].y);
    }
    integer_sub(&out->x.lo, &out->x.lo, &f->rho_x);
    integer_add(&out->x.hi, &out->x.hi, &f->rho_x);
    integer_sub(&out->y.lo, &out->y.lo, &f->rho_y);
    integer_add(&out->y.hi, &out->y.hi, &f->rho_y);
}

/* Trees
 * ----- */

static void check_leaf(const struct tree *t, enum element_kind kind, int depth, int a,
                       int b)
{
    static const char *const kind_name[ELEMENT_KINDS] = { "U", "D", "E" };
    struct pair box[MAX_FUNCTIONS];

    for (int i = 0; i < t->functions; i++)
        patch_box(&box[i], t->patch[depth][i], t->f[i], kind);
    if (!t->decide(t, box))
        rejected(t->certificate->file, t->line,
                 "%s: a leaf of level %d in %s(%d,%d) is not decided", t->name,
                 depth, kind_name[kind], a, b);
}

/* Checks the tree of an element, whose patches are at `depth`; (a,b) is the
 * level-0 element that it is part of. */
static void check_tree(struct tree *t, enum element_kind kind, int depth, int a,
                       int b)
{
    char letter;

    if (t->next == t->end)
        rejected(t->certificate->file, t->line, "%s: the word is too short", t->name);
    letter = *t->next++;
    if (letter == '0') {
        check_leaf(t, kind, depth, a, b);
        return;
    }
    if (depth == MAX_DEPTH)
        cannot_check_at(t->certificate->file, t->line, 0,
                        "%s: expected trees of a depth of at most %d", t->name,
                        MAX_DEPTH);
    for (int i = 0; i < t->functions; i++)
        if (t->patch[depth + 1][i] == NULL)
            t->patch[depth + 1][i] = allocate((size_t)WINDOW_SIDE * WINDOW_SIDE,
                                              sizeof t->patch[0][0][0]);
    for (int child = 0; child < element_children[kind]; child++) {
        const struct child *next = &element_child[kind][child];

        for (int i = 0; i < t->functions; i++)
            refine_patch(t->patch[depth + 1][i], t->patch[depth][i], t->f[i], kind,
                         next, t->c->block->g);
        check_tree(t, next->kind, depth + 1, a, b);
    }
}

static void check_elements(struct tree *t, enum element_kind kind)
{
    int first, last;

    characteristic_range(&first, &last, t->c, kind);
    for (int sum = first; sum <= last; sum++) {
        for (int b = 0; b <= sum; b++) {
            for (int i = 0; i < t->functions; i++)
                start_patch(t->patch[0][i], t->c, t->f[i], kind, sum - b, b);
            check_tree(t, kind, 0, sum - b, b);
        }
    }
}

static void finish(struct tree *t)
{
    if (t->next != t->end)
        rejected(t->certificate->file, t->line, "%s: the word is too long", t->name);
    for (int depth = 0; depth <= MAX_DEPTH; depth++)
        for (int i = 0; i < MAX_FUNCTIONS; i++)
            free(t->patch[depth][i]);
}

/* Leaves
 * ------ */

/* det(d1, d2) > 0 */
static bool jacobian_is_positive(const struct tree *t, const struct pair *box)
{
    interval left, right;
    int g = t->c->block->g;

    grid_mul(&left, &box[0].x, &box[1].y, g);
    grid_mul(&right, &box[0].y, &box[1].x, g);
    interval_sub(&left, &left, &right);
    return interval_is_positive(&left);
}

/* nx x + ny y > 0 */
static bool half_plane_contains(const struct tree *t, const struct pair *box)
{
    interval nx, ny;
    int g = t->c->block->g;

    grid_set_small(&nx, t->certificate->normal[0], g);
    grid_set_small(&ny, t->certificate->normal[1], g);
    grid_mul(&nx, &nx, &box[0].x, g);
    grid_mul(&ny, &ny, &box[0].y, g);
    interval_add(&nx, &nx, &ny);
    return interval_is_positive(&nx);
}

void decide_regularity(const struct characteristic *c,
                       const struct certificate *certificate)
{
    struct tree t = {
        .c = c, .certificate = certificate,
        .name = "regularity", .line = certificate->line_of.regularity,
        .next = certificate->regularity,
        .end = certificate->regularity + certificate->regularity_size,
        .functions = 2, .f = { &c->first, &c->second },
        .decide = jacobian_is_positive
    };

    for (int i = 0; i < t.functions; i++)
        t.patch[0][i] = allocate((size_t)WINDOW_SIDE * WINDOW_SIDE,
                                 sizeof t.patch[0][0][0]);
    check_elements(&t, ELEMENT_U);
    check_elements(&t, ELEMENT_D);
    finish(&t);
}

void decide_boundary(const struct characteristic *c,
                     const struct certificate *certificate)
{
    struct tree t = {
        .c = c, .certificate = certificate,
        .name = "boundary", .line = certificate->line_of.boundary,
        .next = certificate->boundary,
        .end = certificate->boundary + certificate->boundary_size,
        .functions = 1, .f = { &c->value },
        .decide = half_plane_contains
    };

    t.patch[0][0] = allocate((size_t)WINDOW_SIDE * WINDOW_SIDE,
                             sizeof t.patch[0][0][0]);
    check_elements(&t, ELEMENT_E);
    finish(&t);
}
