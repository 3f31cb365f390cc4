/* adaptive.c: depth first, one set of windows per level. */
#include "adaptive.h"

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
    adaptive_box box[ADAPTIVE_MAX_NETS];
    number stability[ADAPTIVE_MAX_NETS], spread;
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

outcome adaptive_sign(double *margin, const number *x)
{
    *margin = number_lower_bound(x);
    if (number_lacks_memory(x))
        return OUTCOME_NO_MEMORY;
    if (number_is_positive(x) == TRUTH_TRUE)
        return OUTCOME_TRUE;
    return number_is_negative(x) == TRUTH_TRUE ? OUTCOME_FALSE : OUTCOME_UNDEFINED;
}

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

static outcome decide(run *r, element_type type, int level, double *margin)
{
    const adaptive_task *task = r->task;
    for (int i = 0; i < task->nets; i++) {
        const charnet_windows *w = task->windows[i];
        make_box(&r->box[i].x, r, i, r->level[level].x[i], w->window[type], &w->radius[0]);
        make_box(&r->box[i].y, r, i, r->level[level].y[i], w->window[type], &w->radius[1]);
    }
    return task->decide(margin, r->box, task->data, r->prec);
}

static void refine(number *child, const number *parent, const element_refinement *refinement, const mask_numbers *mask, long prec)
{
    for (int i = 0; i < refinement->count; i++) {
        number_zero(&child[i]);
        for (int e = refinement->row[i]; e < refinement->row[i + 1]; e++)
            number_addmul(&child[i], mask_numbers_at(mask, refinement->term[e].a, refinement->term[e].b), &parent[refinement->source[e]], prec);
    }
}

static outcome examine(run *r, element_type type, int level);

static outcome split(run *r, element_type type, int level)
{
    const adaptive_task *task = r->task;
    if (!make_level(r, level + 1))
        return OUTCOME_NO_MEMORY;
    for (int c = 0; c < element_children(type); c++) {
        outcome o;
        for (int i = 0; i < task->nets; i++) {
            const element_refinement *refinement = &task->geometry->stencil[task->which[i]].child[type][c];
            refine(r->level[level + 1].x[i], r->level[level].x[i], refinement, task->mask[i], r->prec);
            refine(r->level[level + 1].y[i], r->level[level].y[i], refinement, task->mask[i], r->prec);
        }
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
    outcome o;
    switch (tree_get(r->word)) {
    case '0':
        o = decide(r, type, level, &margin);
        return o == OUTCOME_TRUE ? leaf(r, margin) : o == OUTCOME_NO_MEMORY ? o : OUTCOME_FALSE;
    case '1':
        return level < TREE_MAX_DEPTH ? split(r, type, level) : OUTCOME_FALSE;
    default:
        return OUTCOME_FALSE;
    }
}

static outcome search(run *r, element_type type, int level)
{
    double margin = -INFINITY;
    outcome o = decide(r, type, level, &margin);
    if (o == OUTCOME_NO_MEMORY || o == OUTCOME_FALSE)
        return o;
    if (r->word->length >= TREE_MAX_LETTERS / 2)
        return OUTCOME_UNDEFINED;
    if (!tree_put(r->word, o == OUTCOME_TRUE ? '0' : '1'))
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
    return r->task->replay ? follow(r, type, level) : search(r, type, level);
}

outcome adaptive_run(adaptive_report *report, tree_word *word, const adaptive_task *task, long prec)
{
    outcome o = OUTCOME_TRUE;
    run *r = calloc(1, sizeof *r);
    *report = (adaptive_report){0, 0, INFINITY};
    if (!r)
        return OUTCOME_NO_MEMORY;
    r->task = task;
    r->report = report;
    r->word = word;
    r->prec = prec;
    word->at = 0;
    if (!task->replay)
        tree_reset(word);
    number_init(&r->spread);
    for (int i = 0; i < task->nets; i++) {
        number_init(&r->box[i].x);
        number_init(&r->box[i].y);
        number_init(&r->stability[i]);
        number_set_si(&r->stability[i], task->stability[i], prec);
        number_mul_2exp(&r->stability[i], &r->stability[i], -10, prec);
    }
    for (int e = 0; o == OUTCOME_TRUE && e < task->count; e++) {
        for (int i = 0; i < task->nets; i++) {
            r->level[0].x[i] = task->windows[i]->x + e * task->windows[i]->stride;
            r->level[0].y[i] = task->windows[i]->y + e * task->windows[i]->stride;
        }
        o = examine(r, task->elements[e].type, 0);
    }
    if (o == OUTCOME_TRUE && task->replay && !tree_at_end(word))
        o = OUTCOME_FALSE;
    for (int i = 0; i < task->nets; i++) {
        number_clear(&r->box[i].x);
        number_clear(&r->box[i].y);
        number_clear(&r->stability[i]);
    }
    number_clear(&r->spread);
    free_levels(r);
    free(r);
    return o;
}
