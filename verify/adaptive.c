/* adaptive.c: depth first, one set of windows per level. */
#include "adaptive.h"

#include "../lib/patch_product.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The windows of one element: for each net the x and y values. */
typedef struct {
    number *x[ADAPTIVE_MAX_NETS], *y[ADAPTIVE_MAX_NETS];
} windows;

typedef struct {
    const adaptive_task *task;
    adaptive_report *report;
    tree_word *word;
    long prec;
    windows level[TREE_MAX_DEPTH + 1]; /* level 0 borrowed, the others made when first needed */
    number box_x[ADAPTIVE_MAX_NETS], box_y[ADAPTIVE_MAX_NETS];
    number stability[ADAPTIVE_MAX_NETS], spread, quantity;
    /* for polynomials; NULL if there are none */
    number *wide, *scratch;                                     /* a window's values with their errors */
    number *patch_x[ADAPTIVE_MAX_NETS], *patch_y[ADAPTIVE_MAX_NETS]; /* the nets' coefficients */
    number *product;                                            /* those of the quantity */
    size_t wide_size, scratch_size, patch_size[ADAPTIVE_MAX_NETS], product_size;
} run;

static bool make_level(run *r, int level)
{
    for (int i = 0; i < r->task->nets; i++) {
        size_t size = (size_t)r->task->windows[i]->stride;
        if (!r->level[level].x[i])
            r->level[level].x[i] = number_array_new(size);
        if (!r->level[level].y[i])
            r->level[level].y[i] = number_array_new(size);
        if (!r->level[level].x[i] || !r->level[level].y[i])
            return false;
    }
    return true;
}

static void free_levels(run *r)
{
    for (int level = 1; level <= TREE_MAX_DEPTH; level++)
        for (int i = 0; i < r->task->nets; i++) {
            size_t size = (size_t)r->task->windows[i]->stride;
            if (r->level[level].x[i])
                number_array_free(r->level[level].x[i], size);
            if (r->level[level].y[i])
                number_array_free(r->level[level].y[i], size);
        }
}

/* Is x > 0?  *margin = a lower bound of x. */
static outcome sign(double *margin, const number *x)
{
    *margin = number_lower_bound(x);
    if (number_lacks_memory(x))
        return OUTCOME_NO_MEMORY;
    if (number_is_positive(x) == TRUTH_TRUE)
        return OUTCOME_TRUE;
    return number_is_negative(x) == TRUTH_TRUE ? OUTCOME_FALSE : OUTCOME_UNDEFINED;
}

/* ---- boxes ---- */

/* box = middle of the values +- K (how far they are from it + radius). */
static void make_box(number *box, run *r, int net, const number *value, int count, const number *radius)
{
    number_set(box, &value[0]);
    for (int i = 1; i < count; i++)
        number_hull(box, box, &value[i], r->prec);
    number_radius_upper(&r->spread, box, r->prec);
    number_add(&r->spread, &r->spread, radius, r->prec);
    number_mul(&r->spread, &r->spread, &r->stability[net], r->prec);
    number_midpoint(box, box, r->prec);
    number_add_error(box, box, &r->spread, r->prec);
}

static outcome decide_by_boxes(run *r, element_type type, int level, double *margin)
{
    const adaptive_task *task = r->task;
    const number *x[ADAPTIVE_MAX_NETS], *y[ADAPTIVE_MAX_NETS];
    for (int i = 0; i < task->nets; i++) {
        const charnet_windows *w = task->windows[i];
        make_box(&r->box_x[i], r, i, r->level[level].x[i], w->window[type], &w->radius[0]);
        make_box(&r->box_y[i], r, i, r->level[level].y[i], w->window[type], &w->radius[1]);
        x[i] = &r->box_x[i];
        y[i] = &r->box_y[i];
    }
    number_zero(&r->quantity);
    task->quantity(&r->quantity, x, y, task->data, r->prec);
    return sign(margin, &r->quantity);
}

/* ---- polynomials ---- */

static bool has_polynomials(const adaptive_task *task)
{
    for (int i = 0; i < task->nets; i++)
        if (!task->patch[i])
            return false;
    return true;
}

static size_t most_rows(const bernstein *b)
{
    int most = 0;
    for (int t = 0; t < ELEMENT_TYPES; t++)
        most = b->rows[t] > most ? b->rows[t] : most;
    return (size_t)most;
}

static bool make_patches(run *r)
{
    const adaptive_task *task = r->task;
    int d0 = 0, d1 = 0;
    bool ok = true;
    for (int i = 0; i < task->nets; i++) {
        const bernstein *b = task->patch[i]->exact;
        size_t scratch = (size_t)patch_scratch(b), stride = (size_t)task->windows[i]->stride;
        r->scratch_size = scratch > r->scratch_size ? scratch : r->scratch_size;
        r->wide_size = stride > r->wide_size ? stride : r->wide_size;
        r->patch_size[i] = most_rows(b);
        r->patch_x[i] = number_array_new(r->patch_size[i]);
        r->patch_y[i] = number_array_new(r->patch_size[i]);
        ok = ok && r->patch_x[i] && r->patch_y[i];
        d0 += b->degree[0];
        d1 += b->degree[1];
    }
    r->product_size = (size_t)(d0 + 1) * (size_t)(d1 + 1); /* more than enough on triangles */
    r->wide = number_array_new(r->wide_size);
    r->scratch = number_array_new(r->scratch_size);
    r->product = number_array_new(r->product_size);
    return ok && r->wide && r->scratch && r->product;
}

static void free_array(number *a, size_t size)
{
    if (a)
        number_array_free(a, size);
}

static void free_patches(run *r)
{
    for (int i = 0; i < r->task->nets; i++) {
        free_array(r->patch_x[i], r->patch_size[i]);
        free_array(r->patch_y[i], r->patch_size[i]);
    }
    free_array(r->wide, r->wide_size);
    free_array(r->scratch, r->scratch_size);
    free_array(r->product, r->product_size);
}

/* The values that are near the thin ones by the radius of the net: at every level, for no weight is negative and weights
   sum to 1. */
static void make_patch(number *c, run *r, int net, element_type type, const number *value, const number *radius)
{
    int count = r->task->windows[net]->window[type];
    for (int i = 0; i < count; i++)
        number_add_error(&r->wide[i], &value[i], radius, r->prec);
    patch_coefficients(c, r->task->patch[net], type, r->wide, r->scratch, r->prec);
}

/* r->product = the Jacobian of both nets' polynomials, or the quantity of the one net's coefficients. */
static bool make_product(run *r, const bernstein_shape shape[], int size)
{
    const adaptive_task *task = r->task;
    for (int i = 0; i < size; i++)
        number_zero(&r->product[i]);
    if (task->nets == 2)
        return NUMBER_NAME(patch_add_product)(r->product, r->patch_x[0], shape[0], r->patch_y[1], shape[1], false, r->prec)
               && NUMBER_NAME(patch_add_product)(r->product, r->patch_y[0], shape[0], r->patch_x[1], shape[1], true, r->prec);
    for (int i = 0; i < size; i++) {
        const number *x = &r->patch_x[0][i], *y = &r->patch_y[0][i];
        task->quantity(&r->product[i], &x, &y, task->data, r->prec);
    }
    return true;
}

/* Are all coefficients of the quantity positive?  A corner's is its value there; the Bernstein coefficients, which bound it,
   are those of the homogeneous polynomial over their multiplicities. */
static outcome sign_of_coefficients(double *margin, const number *c, bernstein_shape s)
{
    outcome result = OUTCOME_TRUE;
    *margin = INFINITY;
    for (int j = 0; j <= s.degree[1]; j++)
        for (int i = 0; i <= bernstein_shape_last(s, j); i++) {
            bool corner = (j == 0 || j == s.degree[1]) && (i == 0 || i == bernstein_shape_last(s, j));
            double lower;
            outcome o = sign(&lower, &c[bernstein_shape_index(s, i, j)]);
            if (o == OUTCOME_NO_MEMORY || (o == OUTCOME_FALSE && corner))
                return o;
            if (o != OUTCOME_TRUE)
                result = OUTCOME_UNDEFINED;
            lower = lower / (double)bernstein_shape_multiplicity(s, i, j) * (1 - 0x1p-48);
            *margin = fmin(*margin, lower);
        }
    return result;
}

static outcome decide_by_coefficients(run *r, element_type type, int level, double *margin)
{
    const adaptive_task *task = r->task;
    bernstein_shape shape[ADAPTIVE_MAX_NETS], product = {0, {0, 0}};
    for (int i = 0; i < task->nets; i++) {
        const charnet_windows *w = task->windows[i];
        if (task->patch[i]->exact->rows[type] == 0)
            return OUTCOME_UNDEFINED;
        shape[i] = bernstein_get_shape(task->patch[i]->exact, type);
        product = i == 0 ? shape[i] : bernstein_shape_product(product, shape[i]);
        make_patch(r->patch_x[i], r, i, type, r->level[level].x[i], &w->radius[0]);
        make_patch(r->patch_y[i], r, i, type, r->level[level].y[i], &w->radius[1]);
    }
    if (!make_product(r, shape, bernstein_shape_size(product)))
        return OUTCOME_NO_MEMORY;
    return sign_of_coefficients(margin, r->product, product);
}

/* ---- the trees ---- */

static void refine(number *child, const number *parent, const element_refinement *refinement, const mask_numbers *mask, long prec)
{
    for (int i = 0; i < refinement->count; i++) {
        number_zero(&child[i]);
        for (int e = refinement->row[i]; e < refinement->row[i + 1]; e++)
            number_addmul(&child[i], mask_numbers_at(mask, refinement->term[e].a, refinement->term[e].b), &parent[refinement->source[e]], prec);
    }
}

/* The windows of one child at the next level. */
static outcome make_child(run *r, element_type type, int child, int level)
{
    const adaptive_task *task = r->task;
    if (!make_level(r, level + 1))
        return OUTCOME_NO_MEMORY;
    for (int i = 0; i < task->nets; i++) {
        const element_refinement *refinement = &task->geometry->stencil[task->which[i]].child[type][child];
        refine(r->level[level + 1].x[i], r->level[level].x[i], refinement, task->mask[i], r->prec);
        refine(r->level[level + 1].y[i], r->level[level].y[i], refinement, task->mask[i], r->prec);
    }
    return OUTCOME_TRUE;
}

static outcome examine(run *r, element_type type, int level);

static outcome split(run *r, element_type type, int level)
{
    for (int c = 0; c < element_children(type); c++) {
        outcome o = make_child(r, type, c, level);
        if (o == OUTCOME_TRUE)
            o = examine(r, element_get_child(type, c).type, level + 1);
        if (o != OUTCOME_TRUE)
            return o;
    }
    return OUTCOME_TRUE;
}

static outcome leaf(run *r, double margin)
{
    r->report->margin = fmin(r->report->margin, margin);
    return OUTCOME_TRUE;
}

static outcome follow(run *r, element_type type, int level)
{
    double margin = -INFINITY;
    outcome o = OUTCOME_FALSE;
    switch (tree_get(r->word)) {
    case TREE_BOXES:
        o = decide_by_boxes(r, type, level, &margin);
        break;
    case TREE_COEFFICIENTS:
        if (r->product)
            o = decide_by_coefficients(r, type, level, &margin);
        break;
    case TREE_SPLIT:
        return level < TREE_MAX_DEPTH ? split(r, type, level) : OUTCOME_FALSE;
    }
    return o == OUTCOME_TRUE ? leaf(r, margin) : o == OUTCOME_NO_MEMORY ? o : OUTCOME_FALSE;
}

static outcome search(run *r, element_type type, int level)
{
    double margin = -INFINITY;
    char letter = TREE_BOXES;
    outcome o = decide_by_boxes(r, type, level, &margin);
    if (o == OUTCOME_UNDEFINED && r->product) {
        letter = TREE_COEFFICIENTS;
        o = decide_by_coefficients(r, type, level, &margin);
    }
    if (o == OUTCOME_NO_MEMORY || o == OUTCOME_FALSE)
        return o;
    if (r->word->length >= TREE_MAX_LETTERS / 2)
        return OUTCOME_UNDEFINED;
    if (!tree_put(r->word, o == OUTCOME_TRUE ? letter : TREE_SPLIT))
        return OUTCOME_NO_MEMORY;
    if (o == OUTCOME_TRUE)
        return leaf(r, margin);
    return level < r->task->max_level ? split(r, type, level) : OUTCOME_UNDEFINED;
}

static outcome examine(run *r, element_type type, int level)
{
    r->report->examined++;
    r->report->level = level > r->report->level ? level : r->report->level;
    if (r->report->examined % 64 == 0 && deadline_passed(r->task->deadline))
        return OUTCOME_STOPPED;
    if (r->task->replay)
        return follow(r, type, level);
    return r->task->max_elements && r->report->examined > r->task->max_elements ? OUTCOME_UNDEFINED : search(r, type, level);
}

static run *run_make(adaptive_report *report, tree_word *word, const adaptive_task *task, long prec)
{
    run *r = calloc(1, sizeof *r);
    *report = (adaptive_report){0, 0, INFINITY};
    if (!r)
        return NULL;
    r->task = task;
    r->report = report;
    r->word = word;
    r->prec = prec;
    number_init(&r->spread);
    number_init(&r->quantity);
    for (int i = 0; i < task->nets; i++) {
        number_init(&r->box_x[i]);
        number_init(&r->box_y[i]);
        number_init(&r->stability[i]);
        number_set_si(&r->stability[i], task->stability[i], prec);
        number_mul_2exp(&r->stability[i], &r->stability[i], -10, prec);
    }
    return r;
}

static void run_free(run *r)
{
    for (int i = 0; i < r->task->nets; i++) {
        number_clear(&r->box_x[i]);
        number_clear(&r->box_y[i]);
        number_clear(&r->stability[i]);
    }
    number_clear(&r->spread);
    number_clear(&r->quantity);
    free_patches(r);
    free_levels(r);
    free(r);
}

static void start_element(run *r, int which)
{
    for (int i = 0; i < r->task->nets; i++) {
        r->level[0].x[i] = r->task->windows[i]->x + which * r->task->windows[i]->stride;
        r->level[0].y[i] = r->task->windows[i]->y + which * r->task->windows[i]->stride;
    }
}

outcome adaptive_run(adaptive_report *report, tree_word *word, const adaptive_task *task, long prec)
{
    outcome o = OUTCOME_TRUE;
    run *r = run_make(report, word, task, prec);
    if (!r)
        return OUTCOME_NO_MEMORY;
    word->at = 0;
    if (!task->replay)
        tree_reset(word);
    if (!task->boxes_only && has_polynomials(task) && !make_patches(r))
        o = OUTCOME_NO_MEMORY;
    for (int e = 0; o == OUTCOME_TRUE && e < task->count; e++) {
        start_element(r, e);
        o = examine(r, task->elements[e].type, 0);
    }
    if (o == OUTCOME_TRUE && task->replay && !tree_at_end(word))
        o = OUTCOME_FALSE;
    run_free(r);
    return o;
}

/* ---- one element ---- */

/* A search goes down from so many elements, and so many levels deep. */
enum { SEEK_STARTS = 8, SEEK_DEPTH = 40 };

/* The quantity's middle on the box of a node: where to look next. */
static outcome look(double *middle, run *r, element_type type, int level, double *margin)
{
    outcome o = decide_by_boxes(r, type, level, margin);
    r->report->examined++;
    *middle = number_mid_approx(&r->quantity);
    return o;
}

/* Down from an element, always to the child where the quantity seems largest. */
static outcome descend(run *r, witness_choice *w)
{
    element_type type = r->task->elements[w->element].type;
    for (int level = 0;; level++) {
        double middle, best = -INFINITY;
        int child = -1;
        outcome o = look(&middle, r, type, level, &r->report->margin);
        w->depth = level;
        w->path[level] = '\0';
        r->report->level = level;
        if (o != OUTCOME_UNDEFINED || level == SEEK_DEPTH)
            return o == OUTCOME_UNDEFINED ? OUTCOME_FALSE : o;
        if (deadline_passed(r->task->deadline))
            return OUTCOME_STOPPED;
        for (int c = 0; c <= element_children(type); c++) { /* the last time: the best one once more */
            bool again = c == element_children(type);
            double margin;
            if (again && child < 0)
                return OUTCOME_FALSE;
            o = make_child(r, type, again ? child : c, level);
            if (o != OUTCOME_TRUE)
                return o;
            if (again)
                break;
            o = look(&middle, r, element_get_child(type, c).type, level + 1, &margin);
            if (o == OUTCOME_NO_MEMORY)
                return o;
            if (middle > best) {
                best = middle;
                child = c;
            }
        }
        w->path[level] = (char)('0' + child);
        type = element_get_child(type, child).type;
    }
}

/* From the elements where the quantity seems largest. */
static outcome seek(run *r, witness_choice *w)
{
    int start[SEEK_STARTS], starts = 0;
    double height[SEEK_STARTS];
    outcome o = OUTCOME_FALSE;
    for (int e = 0; e < r->task->count; e++) {
        double middle, margin;
        int at;
        start_element(r, e);
        if (look(&middle, r, r->task->elements[e].type, 0, &margin) == OUTCOME_NO_MEMORY)
            return OUTCOME_NO_MEMORY;
        for (at = starts; at > 0 && !(height[at - 1] >= middle); at--)
            if (at < SEEK_STARTS) {
                start[at] = start[at - 1];
                height[at] = height[at - 1];
            }
        if (at < SEEK_STARTS) {
            start[at] = e;
            height[at] = middle;
            starts += starts < SEEK_STARTS;
        }
    }
    for (int i = 0; o == OUTCOME_FALSE && i < starts; i++) {
        w->element = start[i];
        start_element(r, start[i]);
        o = descend(r, w);
    }
    return o;
}

static outcome follow_path(run *r, const witness_choice *w)
{
    element_type type;
    double margin;
    outcome o = OUTCOME_TRUE;
    if (w->element >= r->task->count || w->depth > TREE_MAX_DEPTH)
        return OUTCOME_FALSE;
    start_element(r, w->element);
    type = r->task->elements[w->element].type;
    for (int level = 0; level < w->depth; level++) {
        int child = w->path[level] - '0';
        if (child < 0 || child >= element_children(type))
            return OUTCOME_FALSE;
        o = make_child(r, type, child, level);
        if (o != OUTCOME_TRUE)
            return o;
        type = element_get_child(type, child).type;
    }
    o = decide_by_boxes(r, type, w->depth, &margin);
    r->report->examined = 1;
    r->report->level = w->depth;
    r->report->margin = margin;
    return o == OUTCOME_TRUE || o == OUTCOME_NO_MEMORY ? o : OUTCOME_FALSE;
}

outcome adaptive_seek(adaptive_report *report, witness_choice *witness, const adaptive_task *task, long prec)
{
    outcome o;
    run *r = run_make(report, NULL, task, prec);
    if (!r)
        return OUTCOME_NO_MEMORY;
    o = task->replay ? follow_path(r, witness) : seek(r, witness);
    run_free(r);
    return o;
}
