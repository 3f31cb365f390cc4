/* report_map.c: the characteristic map on the ring: nets, and the elements that decided. */
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Beyond this valence one sector is drawn, widened. */
#define MOST_SECTORS 24

#define SIZE 600.0
#define HEADER 78.0
#define MARGIN 14.0

typedef struct {
    const picture *picture;
    double middle_x, middle_y, scale; /* the drawing: pixels per unit */
    double widen;                     /* y is multiplied by it */
} view;

static point place(const view *v, point p)
{
    return (point){SIZE / 2 + (p.x - v->middle_x) * v->scale, HEADER + SIZE / 2 - (p.y * v->widen - v->middle_y) * v->scale};
}

/* ---- what is to be seen ---- */

/* The trees to be drawn: the certificate's if it has any, else those that look for signs. */
static const picture_leaves *trees(const picture *p)
{
    return p->tree.count ? &p->tree : &p->signs;
}

static int sign_of(const picture_leaf *leaf)
{
    return leaf->lower > 0 ? 1 : leaf->upper < 0 ? -1 : 0;
}

static bool shows_signs(const picture *p)
{
    for (size_t i = 0; trees(p) == &p->signs && i < p->signs.count; i++)
        if (sign_of(&p->signs.leaf[i]) <= 0)
            return true;
    return false;
}

/* Of what folds one sector is enough, and it should be large. */
static bool is_whole(const picture *p)
{
    return p->valence <= MOST_SECTORS && !shows_signs(p);
}

static void choose_view(view *v, const picture *p)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    v->picture = p;
    v->widen = p->valence <= MOST_SECTORS || p->height <= 0 ? 1 : 1 / p->height;
    for (int e = 0; e < p->ring->element_count; e++)
        for (int s = 0; s < (is_whole(p) ? p->valence : 1); s++)
            for (int i = 0; i < element_vertices(p->ring->elements[e].type); i++) {
                const element *at = &p->ring->elements[e];
                picture_leaf leaf = {at->type, at->a, at->b, 0, 0, 0, 0};
                lattice c = element_get_vertex(at->type, i);
                point both[2] = {picture_vertex(p, &leaf, i, s), picture_control(p, at->a + c.a, at->b + c.b, 0, s)};
                for (int j = 0; j < 2; j++)
                    if (isfinite(both[j].x) && isfinite(both[j].y)) {
                        low[0] = fmin(low[0], both[j].x);
                        high[0] = fmax(high[0], both[j].x);
                        low[1] = fmin(low[1], both[j].y * v->widen);
                        high[1] = fmax(high[1], both[j].y * v->widen);
                    }
            }
    v->middle_x = (low[0] + high[0]) / 2;
    v->middle_y = (low[1] + high[1]) / 2;
    v->scale = (SIZE - 2 * MARGIN) / fmax(fmax(high[0] - low[0], high[1] - low[1]), 1e-9);
}

/* ---- one sector ---- */

/* The corners of an element in order round it: those of squares are listed row by row. */
static int corner(element_type type, int i)
{
    static const int round_square[] = {0, 1, 3, 2};
    return type == ELEMENT_SQUARE ? round_square[i] : i;
}

/* The limit's image of an element, its sides as finely as the net is. */
static void outline(buffer *z, const view *v, const picture_leaf *leaf, const char *attributes)
{
    const picture *p = v->picture;
    int corners = element_vertices(leaf->type), pieces = leaf->level < p->level ? 1 << (p->level - leaf->level) : 1;
    double unit = ldexp(1, -leaf->level);
    svg_path_begin(z);
    for (int i = 0; i < corners; i++) {
        lattice c = element_get_vertex(leaf->type, corner(leaf->type, i)), d = element_get_vertex(leaf->type, corner(leaf->type, (i + 1) % corners));
        for (int j = 0; j < pieces; j++) {
            double t = (double)j / pieces;
            point q = place(v, picture_at(p, (leaf->a + c.a + t * (d.a - c.a)) * unit, (leaf->b + c.b + t * (d.b - c.b)) * unit, 0));
            svg_path_to(z, q.x, q.y);
        }
    }
    svg_path_end(z, true, attributes);
}

/* The net after `level` subdivisions, by the sides of the ring's elements. */
static void net(buffer *z, const view *v, int level)
{
    const picture *p = v->picture;
    const ring *g = p->ring;
    svg_path_begin(z);
    for (int e = 0; e < g->element_count; e++) {
        const element *at = &g->elements[e];
        int corners = element_vertices(at->type), pieces = 1 << level;
        for (int i = 0; i < corners; i++) {
            lattice c = element_get_vertex(at->type, corner(at->type, i)), d = element_get_vertex(at->type, corner(at->type, (i + 1) % corners));
            for (int j = 0; j <= pieces; j++) {
                point q = place(v, picture_control(p, (at->a + c.a) * pieces + j * (d.a - c.a), (at->b + c.b) * pieces + j * (d.b - c.b), level, 0));
                (j == 0 ? svg_path_move : svg_path_to)(z, q.x, q.y);
            }
        }
    }
    svg_path_end(z, false, "");
}

static const char *level_colour(int level)
{
    static const char *const colours[] = {"#ffffff", "#d6e9f8", "#a6d0ee", "#6baede", "#2b83ba", "#0b5a8a"};
    int last = (int)(sizeof colours / sizeof *colours) - 1;
    return colours[level < last ? level : last];
}

static void leaf_attributes(char *text, size_t size, const picture_leaf *leaf, bool by_level, const char *id)
{
    if (by_level)
        snprintf(text, size, "fill=\"%s\"", level_colour(leaf->level));
    else if (sign_of(leaf) < 0)
        snprintf(text, size, "fill=\"url(#%s-negative)\"", id);
    else if (sign_of(leaf) > 0)
        snprintf(text, size, "fill=\"#ffffff\"");
    else
        snprintf(text, size, "fill=\"url(#%s-open)\"", id);
}

/* Where the map folds sheets lie over each other: those that are turned over come last, and are seen. */
static void elements(buffer *z, const view *v, const char *id)
{
    const picture_leaves *leaves = trees(v->picture);
    bool signs = shows_signs(v->picture);
    svg_group(z, "stroke=\"" SVG_GREY "\" stroke-width=\"0.4\" stroke-linejoin=\"round\"");
    for (int sign = 1; sign >= -1; sign--)
        for (size_t i = 0; i < leaves->count; i++) {
            char attributes[96];
            if (sign != (signs ? sign_of(&leaves->leaf[i]) : 1))
                continue;
            leaf_attributes(attributes, sizeof attributes, &leaves->leaf[i], v->picture->tree.count > 0, id);
            outline(z, v, &leaves->leaf[i], attributes);
        }
    svg_end_group(z);
}

static void sector(buffer *z, const view *v, const char *id)
{
    bool signs = shows_signs(v->picture);
    elements(z, v, id);
    svg_group(z, signs ? "fill=\"none\" stroke=\"" SVG_BLUE "\" stroke-width=\"0.5\" opacity=\"0.6\"" : "fill=\"none\" stroke=\"" SVG_ORANGE "\" stroke-width=\"0.7\"");
    net(z, v, 1);
    svg_end_group(z);
    svg_group(z, signs ? "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"0.8\"" : "fill=\"none\" stroke=\"" SVG_BLACK "\" stroke-width=\"1.1\"");
    net(z, v, 0);
    svg_end_group(z);
}

/* Every sector is the first one, turned. */
static void all_sectors(buffer *z, const view *v, const char *id)
{
    point origin = place(v, (point){0, 0});
    char text[128];
    snprintf(text, sizeof text, "id=\"%s-sector\"", id);
    svg_group(z, text);
    sector(z, v, id);
    svg_end_group(z);
    for (long s = 1; is_whole(v->picture) && s < v->picture->valence; s++) {
        double degrees = 360.0 * (double)v->picture->frequency * (double)s / (double)v->picture->valence;
        buffer_print(z, "<use href=\"#%s-sector\" transform=\"rotate(%.6f %.3f %.3f)\"/>\n", id, -degrees, origin.x, origin.y);
    }
    if (is_whole(v->picture))
        svg_mark(z, SVG_CROSS, origin.x, origin.y, 4, SVG_VERMILION);
}

/* ---- the legend ---- */

static void patterns(buffer *z, const char *id)
{
    buffer_print(z, "<defs><pattern id=\"%s-negative\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\"><rect width=\"5\" height=\"5\" fill=\"" SVG_VERMILION
                    "\"/><path d=\"M0 5L5 0\" stroke=\"#ffffff\" stroke-width=\"0.8\"/></pattern>\n", id);
    buffer_print(z, "<pattern id=\"%s-open\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\"><rect width=\"5\" height=\"5\" fill=\"" SVG_YELLOW
                    "\"/><path d=\"M0 0L5 5M0 5L5 0\" stroke=\"" SVG_BLACK "\" stroke-width=\"0.6\"/></pattern></defs>\n", id);
}

static double sample(buffer *z, double x, const char *attributes, const char *text)
{
    svg_rectangle(z, x, 50, 16, 12, attributes);
    svg_text(z, x + 22, 60, SVG_START, text);
    return x + 36 + 6.3 * (double)strlen(text);
}

static double legend_of_signs(buffer *z, double x, const picture *p, const char *id)
{
    char text[128];
    bool open = false;
    for (size_t i = 0; i < p->signs.count; i++)
        open = open || sign_of(&p->signs.leaf[i]) == 0;
    x = sample(z, x, "fill=\"#ffffff\" stroke=\"" SVG_GREY "\"", "Jacobian > 0");
    snprintf(text, sizeof text, "fill=\"url(#%s-negative)\" stroke=\"" SVG_GREY "\"", id);
    x = sample(z, x, text, "< 0: turned over");
    snprintf(text, sizeof text, "fill=\"url(#%s-open)\" stroke=\"" SVG_GREY "\"", id);
    return open ? sample(z, x, text, "open") : x;
}

static double legend_of_levels(buffer *z, double x, const picture *p)
{
    int deepest = 0;
    char text[96], name[32];
    for (size_t i = 0; i < p->tree.count; i++)
        deepest = p->tree.leaf[i].level > deepest ? p->tree.leaf[i].level : deepest;
    for (int level = 0; level <= deepest && level <= 5; level++) {
        snprintf(text, sizeof text, "fill=\"%s\" stroke=\"" SVG_GREY "\"", level_colour(level));
        snprintf(name, sizeof name, level == 0 ? "level 0" : level == 5 && deepest > 5 ? "5 ..." : "%d", level);
        x = sample(z, x, text, name);
    }
    return x;
}

static void legend(buffer *z, const report *r, const report_entry *e, const char *id)
{
    const picture *p = &e->picture;
    char text[256];
    const char *part = is_whole(p) ? "" : p->valence <= MOST_SECTORS ? ", a sector" : ", a sector, widened";
    if (p->frequency == 1)
        snprintf(text, sizeof text, "Characteristic map of %s, valence %ld%s", r->scheme.name, p->valence, part);
    else
        snprintf(text, sizeof text, "Map of frequency %ld of %s, valence %ld%s", p->frequency, r->scheme.name, p->valence, part);
    svg_group(z, "font-size=\"13\" font-weight=\"bold\"");
    svg_text(z, MARGIN, 20, SVG_START, text);
    svg_end_group(z);
    svg_group(z, "stroke-width=\"1.4\" stroke=\"" SVG_BLACK "\"");
    svg_line(z, MARGIN, 36, MARGIN + 16, 36);
    svg_end_group(z);
    svg_text(z, MARGIN + 22, 40, SVG_START, "control net of the ring");
    svg_group(z, shows_signs(p) ? "stroke-width=\"1\" stroke=\"" SVG_BLUE "\"" : "stroke-width=\"1.2\" stroke=\"" SVG_ORANGE "\"");
    svg_line(z, 180, 36, 196, 36);
    svg_end_group(z);
    svg_text(z, 202, 40, SVG_START, "subdivided once");
    svg_group(z, "stroke-width=\"0.8\" stroke=\"" SVG_GREY "\"");
    svg_line(z, 310, 36, 326, 36);
    svg_end_group(z);
    svg_text(z, 332, 40, SVG_START, p->tree.count ? "elements that decide, limit" : "elements, limit");
    if (p->tree.count)
        legend_of_levels(z, MARGIN, p);
    else if (shows_signs(p))
        legend_of_signs(z, MARGIN, p, id);
}

/* Proved: the Jacobian is positive here and negative there. */
static void witnesses(buffer *z, const view *v, const report_entry *e)
{
    static const char *const signs[] = {"+", "\xe2\x88\x92"}; /* minus */
    for (int i = 0; i < 2; i++) {
        point p = place(v, e->witness[i]);
        svg_mark(z, i ? SVG_SQUARE : SVG_RING, p.x, p.y, 7, SVG_BLACK);
        svg_group(z, i ? "font-weight=\"bold\" fill=\"#ffffff\"" : "font-weight=\"bold\"");
        svg_text(z, p.x, p.y + 4, SVG_MIDDLE, signs[i]);
        svg_end_group(z);
    }
}

void report_map(buffer *z, const report *r, const report_entry *e)
{
    char id[64], title[160];
    view v;
    snprintf(id, sizeof id, "map-%s", e->at_name);
    snprintf(title, sizeof title, "Map of %s at valence %s", r->scheme.name, e->at_name);
    svg_begin(z, SIZE, SIZE + HEADER, title);
    patterns(z, id);
    choose_view(&v, &e->picture);
    all_sectors(z, &v, id);
    if (e->followed && e->claim == CLAIM_FOLD)
        witnesses(z, &v, e);
    legend(z, r, e, id);
    svg_end(z);
}
