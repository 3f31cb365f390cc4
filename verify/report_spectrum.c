/* report_spectrum.c: how large the eigenvalues of each block are. */
#include "plot.h"
#include "report.h"

#include "spectrum_list.h"

#include "../bigfloat/interval.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Up to this valence all blocks are enclosed, beyond it a few, and bounds of the others. */
#define ALL_BLOCKS 100
#define MOST_PRECISION 512

static bool is_complete(const spectrum_list *l)
{
    for (size_t i = 0; i < l->count; i++)
        if (!l->entry[i].re)
            return false;
    return true;
}

/* precision 0: double intervals. */
static status make_list(spectrum_list *l, const scheme *s, long k, long precision)
{
    diagnostic d;
    spectrum_list_init(l);
    if (k > ALL_BLOCKS)
        return precision ? spectrum_survey_ball(l, s, k, 6, precision, true, &d) : spectrum_survey_interval(l, s, k, 6, 53, true, &d);
    return precision ? spectrum_list_make_ball(l, s, k, 6, precision, &d) : spectrum_list_make_interval(l, s, k, 6, 53, &d);
}

/* With as much precision as it takes to enclose every eigenvalue. */
static report_status enclose(spectrum_list *l, const scheme *s, long k)
{
    long precision = interval_self_test() ? 0 : 64;
    status made = make_list(l, s, k, precision);
    while (made == STATUS_OK && !is_complete(l) && precision < MOST_PRECISION) {
        spectrum_list_clear(l);
        precision = precision ? 2 * precision : 64;
        made = make_list(l, s, k, precision);
    }
    return made == STATUS_OK ? REPORT_OK : made == STATUS_BAD_INPUT ? REPORT_BAD_INPUT : REPORT_NO_MEMORY;
}

/* ---- the drawing ---- */

static void choose_scales(plot *p, const spectrum_list *l, long k)
{
    p->x = plot_empty_scale(false, true);
    p->y = plot_empty_scale(false, false);
    plot_hold(&p->x, -0.5);
    plot_hold(&p->x, (double)(k / 2) + 0.5);
    plot_hold(&p->y, 0);
    plot_hold(&p->y, 1);
    for (size_t i = 0; i < l->count; i++)
        plot_hold(&p->y, l->entry[i].modulus_upper);
    plot_finish_scale(&p->y);
    p->y.low = 0;
}

/* A bar up to each eigenvalue, its enclosure at the top; the entry's own frequency in another colour and shape. */
static void entry(buffer *z, const plot *p, const spectrum_entry *s, const report_entry *e, double bar)
{
    double x = plot_x(p, (double)s->m), top = plot_y(p, fmin(s->modulus_upper, p->y.high)), bottom = p->top + p->height;
    bool own = s->m == 1, culprit = e->verdict == VERDICT_REFUTED && e->followed && s->m == e->frequency && e->frequency != 1;
    const char *colour = s->one ? SVG_GREY : culprit ? SVG_VERMILION : own ? SVG_BLUE : SVG_SKY;
    char attributes[64];
    snprintf(attributes, sizeof attributes, "fill=\"%s\" fill-opacity=\"0.35\" stroke=\"none\"", colour);
    svg_rectangle(z, x - bar / 2, top, bar, bottom - top, attributes);
    svg_mark(z, s->one ? SVG_RING : culprit ? SVG_DIAMOND : own ? SVG_SQUARE : SVG_DISC, x, plot_y(p, (s->modulus_lower + fmin(s->modulus_upper, p->y.high)) / 2), 3.2, colour);
    if (s->count > 1 && s->modulus_upper > 0.03 * p->y.high) {
        char text[16];
        snprintf(text, sizeof text, "%d", s->count);
        svg_text(z, x + 6, top + 4, SVG_START, text);
    }
}

static void range(buffer *z, const plot *p, const spectrum_range *s)
{
    double y = plot_y(p, s->upper);
    if (!isfinite(y))
        return;
    svg_group(z, "stroke=\"" SVG_BLACK "\" stroke-width=\"1.2\"");
    svg_line(z, plot_x(p, fmax((double)s->m.first - 0.5, p->x.low)), y, plot_x(p, fmin((double)s->m.last + 0.5, p->x.high)), y);
    svg_end_group(z);
}

/* |L| of frequency 1, across the figure: what is above it is too tall. */
static void threshold(buffer *z, const plot *p, const spectrum_list *l)
{
    double most = NAN;
    for (size_t i = 0; i < l->count; i++)
        if (l->entry[i].m == 1)
            most = fmax(most, l->entry[i].modulus_upper);
    if (!isfinite(plot_y(p, most)))
        return;
    svg_group(z, "stroke=\"" SVG_BLUE "\" stroke-dasharray=\"6 3\"");
    svg_line(z, p->left, plot_y(p, most), p->left + p->width, plot_y(p, most));
    svg_end_group(z);
}

static void legend(buffer *z, const plot *p, const report_entry *e, const spectrum_list *l)
{
    double x = p->left, y = p->top - 14;
    char text[48];
    x = plot_legend(z, x, y, SVG_RING, SVG_GREY, "1");
    x = plot_legend(z, x, y, SVG_SQUARE, SVG_BLUE, "block 1, dashed: its largest");
    if (e->verdict == VERDICT_REFUTED && e->followed && e->frequency != 1) {
        snprintf(text, sizeof text, "block %ld, too large", e->frequency);
        x = plot_legend(z, x, y, SVG_DIAMOND, SVG_VERMILION, text);
    }
    x = plot_legend(z, x, y, SVG_DISC, SVG_SKY, "others");
    if (l->ranges)
        svg_text(z, x, y, SVG_START, "lines: bounds");
}

static void draw(buffer *z, const report *r, const report_entry *e, const spectrum_list *l)
{
    plot p = {.left = 74, .top = 56, .width = 600, .height = 260, .x_label = "block m (nets that turn m times round the vertex)", .y_label = "modulus of eigenvalues"};
    char title[160];
    double bar;
    snprintf(title, sizeof title, "Eigenvalues of %s at valence %s, by block", r->scheme.name, e->at_name);
    choose_scales(&p, l, e->at);
    bar = fmin(22, fmax(1.5, 0.7 * p.width / ((double)(e->at / 2) + 1)));
    svg_begin(z, 700, 370, title);
    svg_group(z, "font-size=\"14\" font-weight=\"bold\"");
    svg_text(z, 14, 20, SVG_START, title);
    svg_end_group(z);
    plot_axes(z, &p);
    for (size_t i = 0; i < l->ranges; i++)
        range(z, &p, &l->range[i]);
    for (size_t i = 0; i < l->count; i++)
        entry(z, &p, &l->entry[i], e, bar);
    threshold(z, &p, l);
    legend(z, &p, e, l);
    svg_end(z);
}

report_status report_spectrum(buffer *z, const report *r, const report_entry *e)
{
    spectrum_list l;
    report_status result = enclose(&l, &r->scheme, e->at);
    if (result == REPORT_OK)
        draw(z, r, e, &l);
    spectrum_list_clear(&l);
    return result;
}
