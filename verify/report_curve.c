/* report_curve.c: once round the vertex, and what the eigenfunction makes of that. */
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846
#define RADIUS 200.0
#define HEADER 60.0
#define MIDDLE (HEADER + RADIUS + 50)
#define LEFT (RADIUS + 60)
#define RIGHT (3 * RADIUS + 140)

/* Points per segment of the curve, and how many of both kinds of things a reader can follow. */
enum { PIECES = 8, MOST_SECTORS = 400, MOST_NUMBERS = 24 };

/* Sectors for one turn of the image, either way. */
static double sectors_per_turn(const report_entry *e)
{
    return (double)e->picture.valence / (double)labs(e->windings);
}

/* How far the curve is drawn, in sectors: once round, or what makes two turns of the image. */
static long sectors_of(const report_entry *e)
{
    long valence = e->picture.valence;
    return valence <= MOST_SECTORS ? valence : (long)(2 * sectors_per_turn(e)) + 1;
}

/* t in [0, sectors]: the point of the outer curve; its segments follow each other, each from its second vertex to its first
   where they run clockwise. */
static point on_curve(const picture *p, double t)
{
    const ring *g = p->ring;
    int sector = (int)floor(t), at = (int)((t - sector) * g->boundary_count);
    double s = (t - sector) * g->boundary_count - at;
    const element *e = &g->boundary[at < g->boundary_count ? at : g->boundary_count - 1];
    lattice c = element_get_vertex(e->type, 0), d = element_get_vertex(e->type, 1);
    if (e->type == ELEMENT_ALONG_FIRST) { /* b = 2r, by falling a */
        lattice other = c;
        c = d;
        d = other;
    }
    return picture_at(p, e->a + c.a + s * (d.a - c.a), e->b + c.b + s * (d.b - c.b), sector);
}

static double largest(const picture *p)
{
    double most = 1e-300;
    for (int i = 0; i <= p->ring->boundary_count * PIECES; i++) {
        point q = on_curve(p, 0.999999 * i / (p->ring->boundary_count * PIECES));
        most = isfinite(q.x) && isfinite(q.y) ? fmax(most, hypot(q.x, q.y)) : most;
    }
    return most;
}

/* Grows on its way, so that one turn can be told from the next. */
static point place(const picture *p, double t, double scale, long sectors)
{
    point q = on_curve(p, t);
    double grow = (0.6 + 0.4 * t / (double)sectors) * scale;
    return (point){RIGHT + q.x * grow, MIDDLE - q.y * grow};
}

static const char *turn_style(long turn)
{
    static const char *const styles[] = {
        "fill=\"none\" stroke=\"" SVG_BLUE "\" stroke-width=\"2\"", "fill=\"none\" stroke=\"" SVG_VERMILION "\" stroke-width=\"2\" stroke-dasharray=\"9 3\"",
        "fill=\"none\" stroke=\"" SVG_GREEN "\" stroke-width=\"2\" stroke-dasharray=\"3 3\"", "fill=\"none\" stroke=\"" SVG_PURPLE "\" stroke-width=\"2\" stroke-dasharray=\"12 3 3 3\""};
    return styles[turn % 4];
}

/* The m-th turn ends after k/m sectors. */
static void image(buffer *z, const report_entry *e, long sectors)
{
    const picture *p = &e->picture;
    double scale = RADIUS / largest(p), per_turn = sectors_per_turn(e);
    int pieces = PIECES * p->ring->boundary_count;
    for (long turn = 0; (double)turn * per_turn < (double)sectors - 1e-9; turn++) {
        double from = (double)turn * per_turn, to = fmin(from + per_turn, (double)sectors);
        int steps = (int)ceil((to - from) * pieces);
        svg_path_begin(z);
        for (int i = 0; i <= steps; i++) {
            point q = place(p, fmin(from + (to - from) * i / steps, (double)sectors - 1e-9), scale, sectors);
            svg_path_to(z, q.x, q.y);
        }
        svg_path_end(z, false, turn_style(turn));
    }
    for (long s = 0; s <= sectors && p->valence <= MOST_NUMBERS; s++) {
        point q = place(p, fmin((double)s, (double)sectors - 1e-9), scale, sectors);
        char number[24];
        svg_mark(z, s % sectors ? SVG_DISC : SVG_SQUARE, q.x, q.y, 3.5, SVG_BLACK);
        snprintf(number, sizeof number, s == sectors ? "0 again" : "%ld", s);
        svg_text(z, q.x + (q.x > RIGHT ? 7 : -7), q.y + (q.y > MIDDLE ? 14 : -5), q.x > RIGHT ? SVG_START : SVG_END, number);
    }
    svg_mark(z, SVG_CROSS, RIGHT, MIDDLE, 5, SVG_VERMILION);
}

/* The mesh round the vertex: a circle with its sectors, in the turns of the image. */
static void mesh(buffer *z, const report_entry *e, long sectors)
{
    const picture *p = &e->picture;
    double per_turn = sectors_per_turn(e);
    double radius = 0.8 * RADIUS;
    buffer_print(z, "<circle cx=\"%.0f\" cy=\"%.0f\" r=\"%.0f\" fill=\"none\" stroke=\"" SVG_LIGHT "\"/>\n", LEFT, MIDDLE, radius);
    for (long turn = 0; (double)turn * per_turn < (double)sectors - 1e-9; turn++) {
        double from = (double)turn * per_turn, to = fmin(from + per_turn, (double)sectors);
        svg_path_begin(z);
        for (int i = 0; i <= 64; i++) {
            double w = 2 * PI * (from + (to - from) * i / 64) / (double)p->valence;
            svg_path_to(z, LEFT + radius * cos(w), MIDDLE - radius * sin(w));
        }
        svg_path_end(z, false, turn_style(turn));
    }
    for (long s = 0; s < sectors && p->valence <= MOST_NUMBERS; s++) {
        double w = 2 * PI * (double)s / (double)p->valence;
        char number[24];
        svg_group(z, "stroke=\"" SVG_GREY "\"");
        svg_line(z, LEFT, MIDDLE, LEFT + radius * cos(w), MIDDLE - radius * sin(w));
        svg_end_group(z);
        svg_mark(z, s ? SVG_DISC : SVG_SQUARE, LEFT + radius * cos(w), MIDDLE - radius * sin(w), 3.5, SVG_BLACK);
        snprintf(number, sizeof number, "%ld", s);
        svg_text(z, LEFT + (radius + 16) * cos(w), MIDDLE - (radius + 16) * sin(w) + 4, SVG_MIDDLE, number);
    }
}

void report_curve(buffer *z, const report *r, const report_entry *e)
{
    const picture *p = &e->picture;
    long sectors = sectors_of(e);
    char text[200];
    snprintf(text, sizeof text, "Frequency %ld of %s, valence %s: the image winds %ld times", p->frequency, r->scheme.name, e->at_name, e->windings);
    svg_begin(z, 4 * RADIUS + 200, MIDDLE + RADIUS + 40, text);
    svg_group(z, "font-size=\"14\" font-weight=\"bold\"");
    svg_text(z, 14, 20, SVG_START, text);
    svg_end_group(z);
    svg_text(z, LEFT, HEADER, SVG_MIDDLE, sectors == p->valence ? "once round the vertex" : "part of the way round the vertex, from the right");
    svg_text(z, RIGHT, HEADER, SVG_MIDDLE, "its image round 0, drawn larger and larger on its way");
    mesh(z, e, sectors);
    image(z, e, sectors);
    svg_end(z);
}
