/* plot.h: axes for figures: scales, ticks, labels. */
#ifndef VERIFY_PLOT_H
#define VERIFY_PLOT_H

#include "svg.h"

typedef struct {
    double low, high;
    bool logarithmic; /* then positive */
    bool whole;       /* ticks at whole numbers only */
} plot_scale;

typedef struct {
    double left, top, width, height; /* of the frame */
    plot_scale x, y;
    const char *x_label, *y_label;
} plot;

/* A scale without a value yet. */
plot_scale plot_empty_scale(bool logarithmic, bool whole);
/* Makes it hold v; ignores what is not finite, or not positive on a logarithmic scale. */
void plot_hold(plot_scale *z, double v);
/* After the last value: some room at the ends, and a width above 0. */
void plot_finish_scale(plot_scale *z);

/* Pixels; NaN for values that the scale does not hold. */
double plot_x(const plot *z, double v);
double plot_y(const plot *z, double v);

/* Frame, ticks, grid lines and labels. */
void plot_axes(buffer *out, const plot *z);

/* A mark and its name, from x to the right; returns the x for the next entry. */
double plot_legend(buffer *out, double x, double y, svg_shape shape, const char *colour, const char *text);

#endif
