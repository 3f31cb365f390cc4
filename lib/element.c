/* element.c: children, windows and refinements of elements. */
#include "element.h"

#include <stdlib.h>
#include <string.h>

static const int child_count[ELEMENT_TYPES] = {4, 4, 2};
static const int vertex_count[ELEMENT_TYPES] = {3, 3, 2};
static const element_child children[ELEMENT_TYPES][ELEMENT_MAX_CHILDREN] = {
    {{ELEMENT_UP, {0, 0}}, {ELEMENT_UP, {1, 0}}, {ELEMENT_UP, {0, 1}}, {ELEMENT_DOWN, {0, 0}}},
    {{ELEMENT_DOWN, {1, 1}}, {ELEMENT_DOWN, {0, 1}}, {ELEMENT_DOWN, {1, 0}}, {ELEMENT_UP, {1, 1}}},
    {{ELEMENT_EDGE, {1, 0}}, {ELEMENT_EDGE, {0, 1}}},
};
static const lattice vertices[ELEMENT_TYPES][3] = {
    {{0, 0}, {1, 0}, {0, 1}},
    {{1, 1}, {0, 1}, {1, 0}},
    {{1, 0}, {0, 1}},
};

int element_children(element_type type) { return child_count[type]; }
element_child element_get_child(element_type type, int index) { return children[type][index]; }
int element_vertices(element_type type) { return vertex_count[type]; }
lattice element_get_vertex(element_type type, int index) { return vertices[type][index]; }

void element_stencil_init(element_stencil *z)
{
    memset(z, 0, sizeof *z);
}

void element_stencil_clear(element_stencil *z)
{
    for (int t = 0; t < ELEMENT_TYPES; t++) {
        free(z->window[t].point);
        for (int c = 0; c < ELEMENT_MAX_CHILDREN; c++) {
            free(z->child[t][c].row);
            free(z->child[t][c].source);
            free(z->child[t][c].term);
        }
    }
    element_stencil_init(z);
}

/* Can the basis function of y, which lives on y + hull of the mask, be non-zero on the element?  The hull is
   widened to the hexagon of its extent, so "no" is certain. */
static bool influences(element_type type, const laurent_extent *e, long a, long b)
{
    for (int f = 0; f < 3; f++) {
        long low = 0, high = 0;
        for (int v = 0; v < vertex_count[type]; v++) {
            long value = lattice_functional(f, vertices[type][v].a, vertices[type][v].b);
            low = v == 0 || value < low ? value : low;
            high = v == 0 || value > high ? value : high;
        }
        if (high - lattice_functional(f, a, b) <= e->low[f] || low - lattice_functional(f, a, b) >= e->high[f])
            return false;
    }
    return true;
}

/* The functionals a and b alone bound the search: -high < a < 2 - low. */
static bool make_window(element_window *w, element_type type, const laurent_extent *e)
{
    long width = (e->high[0] - e->low[0] + 2) * (e->high[1] - e->low[1] + 2);
    w->point = malloc((size_t)width * sizeof *w->point);
    if (!w->point)
        return false;
    w->count = 0;
    for (long a = -e->high[0]; a <= 1 - e->low[0]; a++)
        for (long b = -e->high[1]; b <= 1 - e->low[1]; b++)
            if (influences(type, e, a, b))
                w->point[w->count++] = (lattice){(int)a, (int)b};
    return true;
}

static bool make_refinement(element_refinement *r, const element_window *parent, const element_window *child, lattice shift, const laurent *mask)
{
    size_t most = (size_t)parent->count * (size_t)child->count;
    int entries = 0;
    r->count = child->count;
    r->row = malloc(((size_t)child->count + 1) * sizeof *r->row);
    r->source = malloc((most + 1) * sizeof *r->source);
    r->term = malloc((most + 1) * sizeof *r->term);
    if (!r->row || !r->source || !r->term)
        return false;
    for (int i = 0; i < child->count; i++) {
        r->row[i] = entries;
        for (int j = 0; j < parent->count; j++) {
            lattice term = {shift.a + child->point[i].a - 2 * parent->point[j].a, shift.b + child->point[i].b - 2 * parent->point[j].b};
            if (laurent_is_zero_at(mask, term.a, term.b))
                continue;
            r->source[entries] = j;
            r->term[entries++] = term;
        }
    }
    r->row[child->count] = entries;
    return true;
}

bool element_stencil_make(element_stencil *z, const laurent *mask)
{
    laurent_extent e = laurent_get_extent(mask);
    for (int t = 0; t < ELEMENT_TYPES; t++)
        if (!make_window(&z->window[t], (element_type)t, &e))
            return false;
    for (int t = 0; t < ELEMENT_TYPES; t++)
        for (int c = 0; c < child_count[t]; c++)
            if (!make_refinement(&z->child[t][c], &z->window[t], &z->window[children[t][c].type], children[t][c].shift, mask))
                return false;
    return true;
}

static int distance_to_element(element_type type, int a, int b)
{
    int best = -1;
    for (int v = 0; v < vertex_count[type]; v++) {
        int d = lattice_distance(a - vertices[type][v].a, b - vertices[type][v].b);
        best = best < 0 || d < best ? d : best;
    }
    return best;
}

int element_stencil_reach(const element_stencil *s, element_type type, lattice difference)
{
    int reach = 0;
    for (int i = 0; i < s->window[type].count; i++) {
        lattice y = s->window[type].point[i];
        int d = distance_to_element(type, y.a, y.b);
        int e = distance_to_element(type, y.a + difference.a, y.b + difference.b);
        reach = d > reach ? d : reach;
        reach = e > reach ? e : reach;
    }
    return reach;
}
