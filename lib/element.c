/* element.c: children, windows and refinements of elements. */
#include "element.h"

#include <stdlib.h>
#include <string.h>

/* What a type is: its mesh (of quads for primal and dual ones), vertices and children. */
typedef struct {
    bool triangle;
    int vertices, children;
    lattice vertex[4];
    element_child child[ELEMENT_MAX_CHILDREN];
} shape;

static const shape shapes[ELEMENT_TYPES] = {
    [ELEMENT_UP] = {true, 3, 4, {{0, 0}, {1, 0}, {0, 1}}, {{ELEMENT_UP, {0, 0}}, {ELEMENT_UP, {1, 0}}, {ELEMENT_UP, {0, 1}}, {ELEMENT_DOWN, {0, 0}}}},
    [ELEMENT_DOWN] = {true, 3, 4, {{1, 1}, {0, 1}, {1, 0}}, {{ELEMENT_DOWN, {1, 1}}, {ELEMENT_DOWN, {0, 1}}, {ELEMENT_DOWN, {1, 0}}, {ELEMENT_UP, {1, 1}}}},
    [ELEMENT_EDGE] = {true, 2, 2, {{1, 0}, {0, 1}}, {{ELEMENT_EDGE, {1, 0}}, {ELEMENT_EDGE, {0, 1}}}},
    [ELEMENT_SQUARE] = {false, 4, 4, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{ELEMENT_SQUARE, {0, 0}}, {ELEMENT_SQUARE, {1, 0}}, {ELEMENT_SQUARE, {0, 1}}, {ELEMENT_SQUARE, {1, 1}}}},
    [ELEMENT_ALONG_FIRST] = {false, 2, 2, {{0, 0}, {1, 0}}, {{ELEMENT_ALONG_FIRST, {0, 0}}, {ELEMENT_ALONG_FIRST, {1, 0}}}},
    [ELEMENT_ALONG_SECOND] = {false, 2, 2, {{0, 0}, {0, 1}}, {{ELEMENT_ALONG_SECOND, {0, 0}}, {ELEMENT_ALONG_SECOND, {0, 1}}}},
};

bool element_is_of(element_type type, mesh_kind mesh) { return shapes[type].triangle == (mesh == MESH_TRIANGLE); }
bool element_is_segment(element_type type) { return shapes[type].vertices == 2; }
int element_children(element_type type) { return shapes[type].children; }
element_child element_get_child(element_type type, int index) { return shapes[type].child[index]; }
int element_vertices(element_type type) { return shapes[type].vertices; }
lattice element_get_vertex(element_type type, int index) { return shapes[type].vertex[index]; }

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
   widened to the hexagon of its extent (on quads: to the rectangle), so "no" is certain. */
static bool influences(element_type type, const laurent_extent *e, long a, long b)
{
    const shape *t = &shapes[type];
    for (int f = 0; f < (t->triangle ? 3 : 2); f++) {
        long low = 0, high = 0;
        for (int v = 0; v < t->vertices; v++) {
            long value = lattice_functional(f, t->vertex[v].a, t->vertex[v].b);
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

bool element_stencil_make(element_stencil *z, mesh_kind mesh, const laurent *mask)
{
    laurent_extent e = laurent_get_extent(mask);
    for (int t = 0; t < ELEMENT_TYPES; t++)
        if (element_is_of((element_type)t, mesh) && !make_window(&z->window[t], (element_type)t, &e))
            return false;
    for (int t = 0; t < ELEMENT_TYPES; t++)
        for (int c = 0; element_is_of((element_type)t, mesh) && c < shapes[t].children; c++) {
            element_child child = shapes[t].child[c];
            if (!make_refinement(&z->child[t][c], &z->window[t], &z->window[child.type], child.shift, mask))
                return false;
        }
    return true;
}

static int distance_to_element(element_type type, int a, int b)
{
    const shape *t = &shapes[type];
    int best = -1;
    for (int v = 0; v < t->vertices; v++) {
        int d = mesh_distance(t->triangle ? MESH_TRIANGLE : MESH_QUAD, a - t->vertex[v].a, b - t->vertex[v].b);
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
