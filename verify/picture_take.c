/* picture_take.c: a picture of what an analysis has found.  Compiled once per number system.

   The trees are walked by adaptive_run itself, with a quantity that looks at the boxes and then says what is to happen:
   positive, and the element is a leaf; undecided, and it is split. */
#include "tests.h"

#include <math.h>
#include <stdlib.h>

/* No more leaves than this are looked for; what is left then is taken as it is. */
enum { MOST_LEAVES = 6000, MOST_RINGS = 48 };

typedef struct {
    picture *picture;
    const char *follow;  /* letters of trees that are given; NULL: split until the sign is known */
    int children;        /* of elements of this kind */
    int depth;
    int left[TREE_MAX_DEPTH + 2]; /* at each depth, how many siblings are still to come, this one included */
    picture_leaf seen[MOST_LEAVES + 1]; /* the bounds of leaves, in order */
    size_t count;
    bool values;         /* the boxes are of values, not of derivatives */
} walk;

static void go_on(walk *w, bool split)
{
    if (split) {
        w->left[++w->depth] = w->children;
        return;
    }
    while (w->depth > 0 && --w->left[w->depth] == 0)
        w->depth--;
}

static double half_width(const number *x, long prec)
{
    double r;
    number t;
    number_init(&t);
    number_radius_upper(&t, x, prec);
    r = number_upper_bound(&t);
    number_clear(&t);
    return r;
}

/* error[i] = the largest so far. */
static void note_errors(walk *w, int nets, const number *const x[], const number *const y[], long prec)
{
    double *error = &w->picture->error[w->values ? 0 : 2];
    for (int i = 0; i < nets; i++) {
        error[2 * i] = fmax(error[2 * i], half_width(x[i], prec));
        error[2 * i + 1] = fmax(error[2 * i + 1], half_width(y[i], prec));
    }
}

/* Signs are looked for down to PICTURE_DEPTH, and values that are within a quarter down to half of that. */
static bool is_vague(const picture_leaf *leaf, int depth)
{
    bool open = leaf->lower <= 0 && leaf->upper >= 0;
    return depth < PICTURE_DEPTH && (open || (depth <= PICTURE_DEPTH / 2 && leaf->upper - leaf->lower > fmax(fabs(leaf->lower), fabs(leaf->upper)) / 4));
}

/* data: a walk, which it changes. */
static void look(number *z, const number *const x[], const number *const y[], const void *data, long prec)
{
    walk *w = (walk *)(uintptr_t)data;
    picture_leaf *leaf = &w->seen[w->count];
    bool split;
    leaf->lower = -INFINITY;
    leaf->upper = INFINITY;
    if (!w->values) {
        number j;
        number_init(&j);
        adaptive_jacobian(&j, x, y, NULL, prec);
        leaf->lower = number_lower_bound(&j);
        leaf->upper = number_upper_bound(&j);
        number_clear(&j);
    }
    split = w->follow ? *w->follow++ == TREE_SPLIT : is_vague(leaf, w->depth);
    split = split && w->count + (size_t)w->depth < MOST_LEAVES;
    if (!split) {
        if (w->follow)
            note_errors(w, w->values ? 1 : 2, x, y, prec);
        w->count += w->count < MOST_LEAVES;
    }
    go_on(w, split);
    if (split)
        number_indeterminate(z);
    else
        number_one(z);
}

static outcome walk_trees(analysis *a, walk *w, tree_word *made)
{
    const ring *g = &a->plan->problem->geometry;
    adaptive_task derivatives = {.nets = 2, .which = {RING_FIRST, RING_SECOND}, .quantity = look, .data = w, .boxes_only = true};
    adaptive_task values = {.nets = 1, .which = {RING_VALUES}, .quantity = look, .data = w, .boxes_only = true};
    w->children = w->values ? 2 : 4;
    return w->values ? analysis_subdivide(a, &values, made, g->boundary, g->boundary_count) : analysis_subdivide(a, &derivatives, made, g->elements, g->element_count);
}

/* One walk, and its leaves into `leaves` (NULL: not wanted). */
static outcome visit(analysis *a, picture *p, picture_leaves *leaves, const tree_word *follow, bool values)
{
    const ring *g = &a->plan->problem->geometry;
    walk *w = calloc(1, sizeof *w);
    tree_word made;
    outcome o = OUTCOME_NO_MEMORY;
    tree_init(&made);
    if (w) {
        *w = (walk){.picture = p, .follow = follow ? follow->letter : NULL, .values = values};
        o = walk_trees(a, w, &made);
    }
    if (o == OUTCOME_TRUE && leaves) {
        if (!picture_read_leaves(leaves, follow ? follow : &made, g->elements, g->element_count))
            o = OUTCOME_NO_MEMORY;
        for (size_t i = 0; i < leaves->count && i < w->count; i++) {
            leaves->leaf[i].lower = w->seen[i].lower;
            leaves->leaf[i].upper = w->seen[i].upper;
        }
    }
    tree_clear(&made);
    free(w);
    return o;
}

/* The Jacobian's minimum is at most the least upper bound, and at least the least lower bound; and so on. */
static void note_range(picture *p)
{
    p->least[0] = p->least[1] = INFINITY;
    p->most[0] = p->most[1] = -INFINITY;
    for (size_t i = 0; i < p->signs.count; i++) {
        const picture_leaf *leaf = &p->signs.leaf[i];
        p->least[0] = fmin(p->least[0], leaf->lower);
        p->least[1] = fmin(p->least[1], leaf->upper);
        p->most[0] = fmax(p->most[0], leaf->lower);
        p->most[1] = fmax(p->most[1], leaf->upper);
    }
}

/* ---- the net ---- */

/* The ring subdivided `level` times needs the rings up to 2^level 2r, and one more for dual labels. */
static void choose_level(picture *p, const ring *g)
{
    p->level = 1;
    while ((4 * g->radius << p->level) <= MOST_RINGS)
        p->level++;
    p->rings = (2 * g->radius << p->level) + 1;
    if (p->rings < g->rings)
        p->rings = g->rings;
}

static outcome copy_net(picture *p, const sector_net *net)
{
    size_t size = (size_t)sector_size(p->rings);
    p->x = malloc(size * sizeof *p->x);
    p->y = malloc(size * sizeof *p->y);
    if (!p->x || !p->y)
        return OUTCOME_NO_MEMORY;
    for (size_t i = 0; i < size; i++) {
        p->x[i] = number_mid_approx(&net->x[i]);
        p->y[i] = number_mid_approx(&net->y[i]);
    }
    return OUTCOME_TRUE;
}

/* The analysis's own net, scaled by x at its first point. */
static outcome take_control(picture *p, const analysis *a)
{
    const sector_net *net = &a->net;
    size_t size = (size_t)sector_size(net->rings);
    double unit = number_mid_approx(&net->x[sector_index(net, 1, net->mesh == MESH_DUAL ? 1 : 0)]);
    p->control = malloc(2 * size * sizeof *p->control);
    if (!p->control)
        return OUTCOME_NO_MEMORY;
    p->controls = 2 * size;
    for (size_t i = 0; i < size; i++) {
        p->control[2 * i] = number_mid_approx(&net->x[i]) / unit;
        p->control[2 * i + 1] = number_mid_approx(&net->y[i]) / unit;
    }
    return OUTCOME_TRUE;
}

static outcome take_net(picture *p, analysis *a)
{
    const ring *g = &a->plan->problem->geometry;
    diagnostic d = {0, 0, ""};
    sector_net net;
    block_status made;
    outcome o;
    p->ring = g;
    p->mesh = a->dominant.mesh;
    p->regular = a->net.regular;
    p->height = a->choices->eigenpair.complex_form ? 1 : sin(3.14159265358979323846 * (double)p->frequency / (double)p->valence);
    choose_level(p, g);
    if (scheme_numbers_set_frequency(&a->numbers, p->frequency, &a->dominant.twist, &d) != STATUS_OK)
        return OUTCOME_NO_MEMORY;
    made = charnet_make(&net, &a->dominant, a->box, a->choices->eigenpair.complex_form, &a->numbers, p->rings);
    o = analysis_from_block(a, made, &d);
    if (o == OUTCOME_TRUE)
        o = copy_net(p, &net);
    sector_net_free(&net);
    return o;
}

/* ---- all of it ---- */

/* The analysis is used as a search, with findings of its own. */
static outcome take(picture *p, const analysis *of, findings *unused)
{
    analysis a = *of;
    analysis_plan plan = *of->plan;
    const choices *c = of->choices;
    outcome o = OUTCOME_TRUE;
    plan.max_level = TREE_MAX_DEPTH;
    a.plan = &plan;
    a.findings = unused;
    a.replay = false;
    if (c->frequency == 1)
        o = visit(&a, p, &p->signs, NULL, false);
    note_range(p);
    if (o == OUTCOME_TRUE && of->replay && c->regularity.length)
        o = visit(&a, p, &p->tree, &c->regularity, false);
    if (o == OUTCOME_TRUE && of->replay && c->boundary.length)
        o = visit(&a, p, NULL, &c->boundary, true);
    if (o == OUTCOME_TRUE && c->frequency == 1 && !c->eigenpair.complex_form)
        o = take_control(p, of);
    if (o == OUTCOME_TRUE && p->with_net)
        o = take_net(p, &a);
    return o;
}

outcome picture_take(picture *p, analysis *a)
{
    const number *eigenvalue = &a->box[a->order];
    findings *unused;
    outcome o = OUTCOME_NO_MEMORY;
    if (number_is_positive(&a->scale) != TRUTH_TRUE) /* no eigenpair was proved */
        return OUTCOME_FALSE;
    p->valence = a->choices->k.first;
    p->frequency = a->choices->frequency;
    p->re = number_mid_approx(eigenvalue);
    p->im = a->choices->eigenpair.complex_form ? number_mid_approx(eigenvalue + 1) : 0;
    unused = malloc(sizeof *unused);
    if (unused && p->frequency > 0) {
        findings_init(unused);
        findings_begin(unused, "picture", a->plan->system, a->prec);
        o = analysis_make_net(a);
        if (o == OUTCOME_TRUE)
            o = take(p, a, unused);
        findings_clear(unused);
    }
    p->taken = o == OUTCOME_TRUE;
    free(unused);
    return o;
}
