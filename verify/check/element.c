/* Elements, windows and rings: sections 7 and 8 of certificate.md. */

#include "element.h"

const struct element_form element_form[ELEMENT_KINDS] = {
    { "U", 3, { { 0, 0 }, { 1, 0 }, { 0, 1 } },
      4, { { ELEMENT_U, 0, 0 }, { ELEMENT_U, 1, 0 }, { ELEMENT_U, 0, 1 },
           { ELEMENT_D, 0, 0 } } },
    { "D", 3, { { 1, 1 }, { 0, 1 }, { 1, 0 } },
      4, { { ELEMENT_D, 1, 1 }, { ELEMENT_D, 0, 1 }, { ELEMENT_D, 1, 0 },
           { ELEMENT_U, 1, 1 } } },
    { "E", 2, { { 1, 0 }, { 0, 1 } },
      2, { { ELEMENT_E, 1, 0 }, { ELEMENT_E, 0, 1 } } },
    { "S", 4, { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } },
      4, { { ELEMENT_S, 0, 0 }, { ELEMENT_S, 1, 0 }, { ELEMENT_S, 0, 1 },
           { ELEMENT_S, 1, 1 } } },
    { "G", 2, { { 0, 0 }, { 1, 0 } },
      2, { { ELEMENT_G, 0, 0 }, { ELEMENT_G, 1, 0 } } },
    { "H", 2, { { 0, 0 }, { 0, 1 } },
      2, { { ELEMENT_H, 0, 0 }, { ELEMENT_H, 0, 1 } } }
};

/* Windows
 * ------- */

/* Is max_T f - f(y) > lo_f and min_T f - f(y) < hi_f for the f of the mesh? */
static bool is_in_window(enum element_kind kind, const struct stencil *mask,
                         enum mesh mesh, int a, int b)
{
    const struct element_form *form = &element_form[kind];
    const int f[3] = { a, b, a + b };

    for (int i = 0; i < (mesh == TRIANGLE ? 3 : 2); i++) {
        int least = 2, greatest = 0;               /* all f are from 0 to 2 */

        for (int n = 0; n < form->vertices; n++) {
            struct label v = form->vertex[n];
            int here = i == 0 ? v.a : i == 1 ? v.b : v.a + v.b;

            least = here < least ? here : least;
            greatest = here > greatest ? here : greatest;
        }
        if (greatest - f[i] <= mask->low[i] || least - f[i] >= mask->high[i])
            return false;
    }
    return true;
}

/* f(y) lies between min f - hi_f and max f - lo_f, and f from 0 to 1. */
struct window window_make(enum element_kind kind, const struct stencil *mask, enum mesh mesh)
{
    struct window out = { .low_a = -mask->high[0], .low_b = -mask->high[1],
                          .side_a = mask->high[0] - mask->low[0] + 2,
                          .side_b = mask->high[1] - mask->low[1] + 2 };
    size_t cells = (size_t)out.side_a * (size_t)out.side_b;

    out.label = allocate(cells, sizeof out.label[0]);
    out.index = allocate(cells, sizeof out.index[0]);
    for (size_t i = 0; i < cells; i++) {
        struct label y = { (int)i / out.side_b + out.low_a,
                           (int)i % out.side_b + out.low_b };

        out.index[i] = -1;
        if (is_in_window(kind, mask, mesh, y.a, y.b)) {
            out.index[i] = out.count;
            out.label[out.count++] = y;
        }
    }
    return out;
}

int window_index(const struct window *w, int a, int b)
{
    int i = a - w->low_a, j = b - w->low_b;

    if (i < 0 || i >= w->side_a || j < 0 || j >= w->side_b)
        return -1;
    return w->index[i * w->side_b + j];
}

static int distance_to_element(enum element_kind kind, enum mesh mesh, int a, int b)
{
    const struct element_form *form = &element_form[kind];
    int least = -1;

    for (int i = 0; i < form->vertices; i++) {
        int distance = lattice_distance(mesh, a - form->vertex[i].a, b - form->vertex[i].b);

        if (least < 0 || distance < least)
            least = distance;
    }
    return least;
}

int window_reach(const struct window *w, enum element_kind kind, enum mesh mesh,
                 int shift_a, int shift_b)
{
    int reach = 0;

    for (int i = 0; i < w->count; i++) {
        struct label y = w->label[i];
        int here = distance_to_element(kind, mesh, y.a, y.b);
        int there = distance_to_element(kind, mesh, y.a + shift_a, y.b + shift_b);

        reach = here > reach ? here : reach;
        reach = there > reach ? there : reach;
    }
    return reach;
}

/* Rings
 * ----- */

static void add_element(struct element *list, int *count, enum element_kind kind, int a, int b)
{
    list[(*count)++] = (struct element) { kind, a, b };
}

/* All (a,b), a, b >= 0, with first <= a + b <= last: by a + b, then b. */
static void add_triangles(struct element *list, int *count, enum element_kind kind,
                          int first, int last)
{
    for (int sum = first; sum <= last; sum++)
        for (int b = 0; b <= sum; b++)
            add_element(list, count, kind, sum - b, b);
}

/* All (a,b), a, b >= 0, r <= max(a,b) < 2r: by max(a,b), then b, then falling a. */
static void add_squares(struct element *list, int *count, int r)
{
    for (int ring = r; ring < 2 * r; ring++)
        for (int b = 0; b <= ring; b++)
            for (int a = ring; a >= (b < ring ? ring : 0); a--)
                add_element(list, count, ELEMENT_S, a, b);
}

int ring_elements(struct element **out, enum mesh mesh, int r, bool boundary)
{
    struct element *list = allocate((size_t)(8 * r * r), sizeof list[0]);
    int count = 0;

    if (mesh == TRIANGLE && !boundary) {
        add_triangles(list, &count, ELEMENT_U, r, 2 * r - 1);
        add_triangles(list, &count, ELEMENT_D, r - 1, 2 * r - 2);
    } else if (mesh == TRIANGLE) {
        add_triangles(list, &count, ELEMENT_E, 2 * r - 1, 2 * r - 1);
    } else if (!boundary) {
        add_squares(list, &count, r);
    } else {
        for (int b = 0; b < 2 * r; b++)
            add_element(list, &count, ELEMENT_H, 2 * r, b);
        for (int a = 2 * r - 1; a >= 0; a--)
            add_element(list, &count, ELEMENT_G, a, 2 * r);
    }
    *out = list;
    return count;
}
