/* Elements and their windows: section 7 of certificate.md. */

#include "window.h"

const int element_vertices[ELEMENT_KINDS] = { 3, 3, 2 };

const struct point element_vertex[ELEMENT_KINDS][3] = {
    { { 0, 0 }, { 1, 0 }, { 0, 1 } },
    { { 1, 1 }, { 0, 1 }, { 1, 0 } },
    { { 1, 0 }, { 0, 1 }, { 0, 0 } }               /* the third is not used */
};

const int element_children[ELEMENT_KINDS] = { 4, 4, 2 };

const struct child element_child[ELEMENT_KINDS][4] = {
    { { ELEMENT_U, 0, 0 }, { ELEMENT_U, 1, 0 }, { ELEMENT_U, 0, 1 },
      { ELEMENT_D, 0, 0 } },
    { { ELEMENT_D, 1, 1 }, { ELEMENT_D, 0, 1 }, { ELEMENT_D, 1, 0 },
      { ELEMENT_U, 1, 1 } },
    { { ELEMENT_E, 1, 0 }, { ELEMENT_E, 0, 1 }, { ELEMENT_E, 0, 0 },
      { ELEMENT_E, 0, 0 } }                        /* two are not used */
};

/* f(a,b) = a, b, a+b for f = 0, 1, 2 */
static int functional(int f, int a, int b)
{
    return f == 0 ? a : f == 1 ? b : a + b;
}

/* Does the interior of y + hull meet the element, as far as the three
 * functionals say? */
static bool is_in_window(enum element_kind kind, const struct stencil *mask, int a,
                         int b)
{
    for (int f = 0; f < 3; f++) {
        int here = functional(f, a, b);
        int least = 0, greatest = 0;

        for (int i = 0; i < element_vertices[kind]; i++) {
            struct point vertex = element_vertex[kind][i];
            int there = functional(f, vertex.a, vertex.b);

            if (i == 0 || there < least)
                least = there;
            if (i == 0 || there > greatest)
                greatest = there;
        }
        if (greatest - here <= mask->low[f] || least - here >= mask->high[f])
            return false;
    }
    return true;
}

/* All y in question are in the square: max f - f(y) > lo_f >= -8 and
 * min f - f(y) < hi_f <= 8 say -8 < f(y) < 9 for f = a, b. */
void window_prepare(struct window *out, enum element_kind kind,
                    const struct stencil *mask)
{
    out->count = 0;
    for (int i = 0; i < WINDOW_SIDE; i++) {
        for (int j = 0; j < WINDOW_SIDE; j++) {
            struct point y = { i + WINDOW_LOW, j + WINDOW_LOW };

            out->index[i][j] = -1;
            if (is_in_window(kind, mask, y.a, y.b)) {
                out->index[i][j] = out->count;
                out->point[out->count++] = y;
            }
        }
    }
}

int window_index(const struct window *w, int a, int b)
{
    int i = a - WINDOW_LOW, j = b - WINDOW_LOW;

    if (i < 0 || i >= WINDOW_SIDE || j < 0 || j >= WINDOW_SIDE)
        return -1;
    return w->index[i][j];
}

static int distance_to_element(enum element_kind kind, int a, int b)
{
    int least = -1;

    for (int i = 0; i < element_vertices[kind]; i++) {
        struct point vertex = element_vertex[kind][i];
        int distance = lattice_distance(a - vertex.a, b - vertex.b);

        if (least < 0 || distance < least)
            least = distance;
    }
    return least;
}

int window_reach(const struct window *w, enum element_kind kind, int shift_a,
                 int shift_b)
{
    int reach = 0;

    for (int i = 0; i < w->count; i++) {
        struct point y = w->point[i];
        int here = distance_to_element(kind, y.a, y.b);
        int there = distance_to_element(kind, y.a + shift_a, y.b + shift_b);

        reach = here > reach ? here : reach;
        reach = there > reach ? there : reach;
    }
    return reach;
}
