/* plot.c: where ticks are, and where values lie between them. */
#include "plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

plot_scale plot_empty_scale(bool logarithmic, bool whole)
{
    return (plot_scale){INFINITY, -INFINITY, logarithmic, whole};
}

void plot_hold(plot_scale *z, double v)
{
    if (!isfinite(v) || (z->logarithmic && v <= 0))
        return;
    z->low = fmin(z->low, v);
    z->high = fmax(z->high, v);
}

void plot_finish_scale(plot_scale *z)
{
    double room;
    if (z->low > z->high)
        z->low = z->high = 1;
    if (z->logarithmic) {
        room = fmax(pow(z->high / z->low, 0.04), 1.15);
        z->low /= room;
        z->high *= room;
        return;
    }
    room = 0.04 * (z->high - z->low);
    if (room == 0)
        room = z->whole ? 1 : fmax(0.1 * fabs(z->high), 1e-3);
    z->low -= room;
    z->high += room;
}

static double fraction_of(const plot_scale *s, double v)
{
    if (!(v >= s->low && v <= s->high))
        return NAN;
    return s->logarithmic ? log(v / s->low) / log(s->high / s->low) : (v - s->low) / (s->high - s->low);
}

double plot_x(const plot *z, double v)
{
    return z->left + z->width * fraction_of(&z->x, v);
}

double plot_y(const plot *z, double v)
{
    return z->top + z->height * (1 - fraction_of(&z->y, v));
}

/* ---- ticks ---- */

enum { MOST_TICKS = 64 };

/* 1, 2 or 5 times a power of ten, so that about `wanted` of them fit. */
static double step_of(const plot_scale *s, int wanted)
{
    double rough = (s->high - s->low) / wanted, ten = pow(10, floor(log10(rough))), m = rough / ten;
    double step = (m <= 1 ? 1 : m <= 2 ? 2 : m <= 5 ? 5 : 10) * ten;
    return s->whole && step < 1 ? 1 : step;
}

static int linear_ticks(double *tick, const plot_scale *s, int wanted)
{
    double step = step_of(s, wanted);
    int count = 0;
    for (double i = ceil(s->low / step); i * step <= s->high && count < MOST_TICKS; i++)
        tick[count++] = i == 0 ? 0 : i * step;
    return count;
}

/* Powers of ten; of few decades 2 and 5 times these, too, of very many only each so many. */
static int logarithmic_ticks(double *tick, const plot_scale *s)
{
    static const double factor[] = {1, 2, 5};
    double decades = log10(s->high / s->low);
    int factors = decades < 3.5 ? 3 : 1, each = 1 + (int)(decades / 9), count = 0;
    for (int e = (int)floor(log10(s->low)); e <= (int)ceil(log10(s->high)); e++)
        for (int f = 0; f < factors; f++) {
            double v = factor[f] * pow(10, e);
            if (e % each == 0 && v >= s->low && v <= s->high && count < MOST_TICKS)
                tick[count++] = v;
        }
    return count;
}

static int ticks(double *tick, const plot_scale *s, int wanted)
{
    return s->logarithmic && s->high / s->low > 4 ? logarithmic_ticks(tick, s) : linear_ticks(tick, s, wanted);
}

static void name_tick(char *text, size_t size, double v)
{
    if (v != 0 && (fabs(v) < 1e-4 || fabs(v) >= 1e6))
        snprintf(text, size, "%.0e", v);
    else
        snprintf(text, size, "%.6g", v);
}

static void x_axis(buffer *out, const plot *z)
{
    double tick[MOST_TICKS];
    char text[32];
    int count = ticks(tick, &z->x, (int)(z->width / 60));
    double bottom = z->top + z->height;
    for (int i = 0; i < count; i++) {
        svg_line(out, plot_x(z, tick[i]), bottom, plot_x(z, tick[i]), bottom + 4);
        name_tick(text, sizeof text, tick[i]);
        svg_group(out, "stroke=\"none\" fill=\"" SVG_BLACK "\"");
        svg_text(out, plot_x(z, tick[i]), bottom + 17, SVG_MIDDLE, text);
        svg_end_group(out);
    }
}

static void y_axis(buffer *out, const plot *z)
{
    double tick[MOST_TICKS];
    char text[32];
    int count = ticks(tick, &z->y, (int)(z->height / 35));
    for (int i = 0; i < count; i++) {
        double y = plot_y(z, tick[i]);
        svg_group(out, "stroke=\"" SVG_LIGHT "\"");
        svg_line(out, z->left, y, z->left + z->width, y);
        svg_end_group(out);
        svg_line(out, z->left - 4, y, z->left, y);
        name_tick(text, sizeof text, tick[i]);
        svg_group(out, "stroke=\"none\" fill=\"" SVG_BLACK "\"");
        svg_text(out, z->left - 7, y + 4, SVG_END, text);
        svg_end_group(out);
    }
}

void plot_axes(buffer *out, const plot *z)
{
    svg_group(out, "stroke=\"" SVG_BLACK "\" fill=\"none\"");
    y_axis(out, z);
    x_axis(out, z);
    svg_rectangle(out, z->left, z->top, z->width, z->height, "");
    svg_end_group(out);
    svg_text(out, z->left + z->width / 2, z->top + z->height + 36, SVG_MIDDLE, z->x_label);
    svg_text_upwards(out, z->left - 52, z->top + z->height / 2, SVG_MIDDLE, z->y_label);
}

double plot_legend(buffer *out, double x, double y, svg_shape shape, const char *colour, const char *text)
{
    svg_mark(out, shape, x + 6, y - 4, 4, colour);
    svg_text(out, x + 16, y, SVG_START, text);
    return x + 34 + 6.8 * (double)strlen(text);
}
