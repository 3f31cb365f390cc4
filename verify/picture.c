/* picture.c: nets and trees as points of the plane. */
#include "picture.h"

#include "../lib/growing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

void picture_init(picture *z, bool with_net)
{
    memset(z, 0, sizeof *z);
    z->with_net = with_net;
    for (int i = 0; i < PICTURE_ERRORS; i++)
        z->error[i] = NAN;
}

void picture_clear(picture *z)
{
    free(z->tree.leaf);
    free(z->signs.leaf);
    free(z->x);
    free(z->y);
    free(z->control);
    picture_init(z, false);
}

double picture_distance(const picture *a, const picture *b)
{
    double distance = 0;
    if (!a->control || !b->control || a->controls != b->controls)
        return NAN;
    for (size_t i = 0; i < a->controls; i++)
        distance = fmax(distance, fabs(a->control[i] - b->control[i]));
    return distance;
}

/* ---- leaves ---- */

bool picture_add_leaf(picture_leaves *z, const picture_leaf *leaf)
{
    picture_leaf *p = growing_room(z->leaf, z->count, &z->capacity, sizeof *p);
    if (!p)
        return false;
    z->leaf = p;
    z->leaf[z->count++] = *leaf;
    return true;
}

static bool read_leaf(picture_leaves *z, const char **letter, picture_leaf node)
{
    node.letter = **letter;
    if (!tree_is_letter(node.letter) || node.level > TREE_MAX_DEPTH)
        return false;
    ++*letter;
    if (node.letter != TREE_SPLIT)
        return picture_add_leaf(z, &node);
    for (int c = 0; c < element_children(node.type); c++) {
        element_child child = element_get_child(node.type, c);
        picture_leaf below = {child.type, 2 * node.a + child.shift.a, 2 * node.b + child.shift.b, node.level + 1, 0, -INFINITY, INFINITY};
        if (!read_leaf(z, letter, below))
            return false;
    }
    return true;
}

bool picture_read_leaves(picture_leaves *z, const tree_word *word, const element *elements, int count)
{
    const char *letter = word->letter;
    for (int i = 0; letter && i < count; i++)
        if (!read_leaf(z, &letter, (picture_leaf){elements[i].type, elements[i].a, elements[i].b, 0, 0, -INFINITY, INFINITY}))
            return false;
    return letter != NULL;
}

/* ---- points ---- */

static point times(point p, double re, double im)
{
    return (point){p.x * re - p.y * im, p.x * im + p.y * re};
}

static point turned(const picture *z, point p, long sectors)
{
    double w = 2 * PI * (double)z->frequency * (double)sectors / (double)z->valence;
    return times(p, cos(w), sin(w));
}

/* The net's value at a label of the plane; the centre's is 0. */
static point value(const picture *z, int a, int b)
{
    int turns = 0;
    size_t i;
    if (mesh_is_centre(z->mesh, a, b))
        return (point){0, 0};
    if (!mesh_reduce(z->mesh, z->regular, &a, &b, &turns) || mesh_ring(z->mesh, a, b) > z->rings)
        return (point){NAN, NAN};
    i = (size_t)(a - 1) * (size_t)(z->rings + 1) + (size_t)b;
    return turned(z, (point){z->x[i], z->height * z->y[i]}, turns);
}

/* F(y/2) = L F(y): each subdivision of the net is the net itself, L times as large. */
static point scaled(const picture *z, point p, int levels)
{
    for (int i = 0; i < levels; i++)
        p = times(p, z->re, z->im);
    return p;
}

point picture_control(const picture *z, int a, int b, int level, int sector)
{
    return turned(z, scaled(z, value(z, a, b), level), sector);
}

static point between(point p, point q, double t)
{
    return (point){p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

/* The finest net there is, interpolated on triangles (on half squares); its points lie where dual labels say, half an edge
   further. */
point picture_at(const picture *z, double a, double b, int sector)
{
    double fine = ldexp(1, z->level), half = z->mesh == MESH_DUAL ? 0.5 : 0;
    double s = a * fine + half, t = b * fine + half, u = s - floor(s), v = t - floor(t);
    int i = (int)floor(s), j = (int)floor(t);
    point p = value(z, i, j), q;
    if (u > 0 || v > 0) {
        point right = value(z, i + 1, j), left = value(z, i, j + 1);
        if (u + v > 1) {
            p = value(z, i + 1, j + 1);
            q = between(right, left, u + v < 2 ? (1 - u) / (2 - u - v) : 0);
            p = between(p, q, 2 - u - v);
        } else {
            q = between(right, left, v / (u + v));
            p = between(p, q, u + v);
        }
    }
    return turned(z, scaled(z, p, z->level), sector);
}

point picture_vertex(const picture *z, const picture_leaf *leaf, int vertex, int sector)
{
    lattice v = element_get_vertex(leaf->type, vertex);
    double unit = ldexp(1, -leaf->level);
    return picture_at(z, (leaf->a + v.a) * unit, (leaf->b + v.b) * unit, sector);
}
