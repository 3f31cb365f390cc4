/* report_valences.c: what can be seen over all valences of a run. */
#include "plot.h"
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* From this ratio of the largest to the smallest valence on the axis is logarithmic. */
#define LOGARITHMIC_FROM 40

enum { MOST_SERIES = 6 };

/* A quantity of an entry, as bounds: equal ones are a mark, others a mark with a bar.  NaN: it has none. */
typedef struct {
    double lower, upper;
} span;

typedef struct {
    const char *name;
    svg_shape shape;
    const char *colour;
    span (*get)(const report_entry *e);
} series;

typedef struct {
    const char *name, *title, *y_label, *caption;
    bool logarithmic, whole;
    int count;
    series series[MOST_SERIES];
} plot_kind;

static span single(double v)
{
    return (span){v, v};
}

static span nothing(void)
{
    return single(NAN);
}

static bool is_usual(const report_entry *e)
{
    return e->followed && !e->plainly_regular;
}

/* ---- quantities ---- */

static span dominant(const report_entry *e)
{
    return is_usual(e) && e->claim == CLAIM_C1 ? (span){e->eigenvalue_lower, e->eigenvalue_upper} : nothing();
}

static span dominant_of_refuted(const report_entry *e)
{
    return is_usual(e) && e->claim != CLAIM_C1 ? (span){e->eigenvalue_lower, e->eigenvalue_upper} : nothing();
}

static span others(const report_entry *e)
{
    return is_usual(e) ? single(e->log.others) : nothing();
}

static span elements(const report_entry *e)
{
    return is_usual(e) && e->verdict == VERDICT_PROVED ? single((double)e->elements) : nothing();
}

static span elements_of_refuted(const report_entry *e)
{
    return is_usual(e) && e->verdict == VERDICT_REFUTED ? single((double)e->elements) : nothing();
}

static bool is_measured(const report_entry *e)
{
    return is_usual(e) && e->picture.taken && e->claim == CLAIM_C1 && is_one_valence(e->k);
}

static span least(const report_entry *e)
{
    return is_measured(e) ? (span){fmax(e->picture.least[0], e->jacobian), e->picture.least[1]} : nothing();
}

static span most(const report_entry *e)
{
    return is_measured(e) ? (span){e->picture.most[0], e->picture.most[1]} : nothing();
}

static span error(const report_entry *e, int which)
{
    return is_measured(e) ? single(fmax(e->picture.error[2 * which], e->picture.error[2 * which + 1])) : nothing();
}

static span error_of_values(const report_entry *e) { return error(e, 0); }
static span error_of_first(const report_entry *e) { return error(e, 1); }
static span error_of_second(const report_entry *e) { return error(e, 2); }

static span eigenpair_radius(const report_entry *e)
{
    return is_usual(e) ? single(e->radius) : nothing();
}

static span distance(const report_entry *e)
{
    return is_usual(e) ? single(e->distance) : nothing();
}

static span uniform_error(const report_entry *e)
{
    return single(e->log.error);
}

static span level(const report_entry *e)
{
    return is_usual(e) ? single(e->level) : nothing();
}

static span precision(const report_entry *e)
{
    return e->log.precision > 0 && e->verdict != VERDICT_UNDECIDED ? single((double)e->log.precision) : nothing();
}

static span precision_of_undecided(const report_entry *e)
{
    return e->log.precision > 0 && e->verdict == VERDICT_UNDECIDED ? single((double)e->log.precision) : nothing();
}

static const plot_kind kinds[REPORT_PLOTS] = {
    [REPORT_EIGENVALUES] = {"eigenvalues", "The dominant eigenvalue and the others", "modulus",
        "The eigenvalue on which everything depends, and a bound of all others but 1. A scheme can be C1 only where the first is larger and comes from frequency 1.",
        false, false, 3,
        {{"|L|, proved", SVG_SQUARE, SVG_BLUE, dominant}, {"dominant, refuted", SVG_DIAMOND, SVG_VERMILION, dominant_of_refuted}, {"all others are at most", SVG_RING, SVG_BLACK, others}}},
    [REPORT_ELEMENTS] = {"elements", "Elements examined", "elements",
        "How many elements of the ring and of its outer curve the certificate's proof looks at, those that are split included.", true, true, 2,
        {{"proved", SVG_SQUARE, SVG_BLUE, elements}, {"refuted", SVG_DIAMOND, SVG_VERMILION, elements_of_refuted}}},
    [REPORT_LEVELS] = {"levels", "Levels of subdivision", "level", "How often an element of the ring, or of its outer curve, had to be subdivided at most.", false, true, 1,
        {{"deepest level", SVG_TRIANGLE, SVG_ORANGE, level}}},
    [REPORT_JACOBIAN] = {"jacobian", "The Jacobian of the characteristic map", "Jacobian on the ring",
        "Its minimum and its maximum on one ring, in the coordinates of the certificate; each lies within its bar. The lower end of the lower bar is what the certificate proves; a bar is short where elements were small.",
        true, false, 2,
        {{"maximum", SVG_TRIANGLE, SVG_ORANGE, most}, {"minimum", SVG_SQUARE, SVG_BLUE, least}}},
    [REPORT_ERRORS] = {"errors", "Errors of approximation", "error",
        "How far the limit can be, on a deciding element, from the middle of the net there: the largest such error of the trees, for values of the map on the outer curve and for its two derivatives. "
        "The uniform method, where it was used, bounds the error of the whole net.", true, false, 4,
        {{"values", SVG_SQUARE, SVG_BLUE, error_of_values}, {"derivative 1", SVG_TRIANGLE, SVG_ORANGE, error_of_first}, {"derivative 2", SVG_DIAMOND, SVG_GREEN, error_of_second},
         {"uniform method", SVG_CROSS, SVG_VERMILION, uniform_error}}},
    [REPORT_RADIUS] = {"eigenpair", "The box of the eigenvector and its eigenvalue", "radius",
        "How exactly the certificate gives the dominant eigenvector, one component being 1, and its eigenvalue.", true, false, 1,
        {{"radius", SVG_SQUARE, SVG_BLUE, eigenpair_radius}}},
    [REPORT_DISTANCE] = {"limit", "Distance to the limit net", "distance",
        "How far the control net of the characteristic map is from that of infinite valence: the largest difference of a coordinate of the certificate, the first point having x = 1. (Of each valence by itself; drawn from valence 10^9, and not proved.)",
        true, false, 1, {{"distance", SVG_SQUARE, SVG_BLUE, distance}}},
    [REPORT_PRECISION] = {"precision", "Precision", "bits",
        "The bits of the numbers that found the proof (53: hardware intervals), or with which the last attempt was made.", false, true, 2,
        {{"decided", SVG_SQUARE, SVG_BLUE, precision}, {"undecided", SVG_CROSS, SVG_VERMILION, precision_of_undecided}}},
};

const char *report_plot_name(report_plot which) { return kinds[which].name; }
const char *report_plot_caption(report_plot which) { return kinds[which].caption; }

/* ---- the drawing ---- */

static bool is_seen(const plot_kind *kind, span s)
{
    return isfinite(s.upper) && (!kind->logarithmic || s.upper > 0);
}

/* Where an entry ends on the axis. */
static double last_of(const plot *p, const report_entry *e)
{
    return e->k.last == VALENCES_UNBOUNDED ? p->x.high : (double)e->k.last;
}

static void draw_span(buffer *z, const plot *p, const series *s, const report_entry *e, span v)
{
    double low = fmax(v.lower, p->y.low), x = plot_x(p, (double)e->k.first), y = plot_y(p, v.upper), below = plot_y(p, low);
    if (isfinite(below) && fabs(below - y) > 1) {
        char attributes[48];
        snprintf(attributes, sizeof attributes, "stroke=\"%s\" stroke-width=\"1.2\"", s->colour);
        svg_group(z, attributes);
        svg_line(z, x, y, x, below);
        svg_line(z, x - 3, y, x + 3, y);
        svg_line(z, x - 3, below, x + 3, below);
        svg_end_group(z);
        y = (y + below) / 2;
    }
    if (!is_one_valence(e->k)) {
        char attributes[48];
        snprintf(attributes, sizeof attributes, "stroke=\"%s\" stroke-width=\"2\"", s->colour);
        svg_group(z, attributes);
        svg_line(z, x, y, plot_x(p, last_of(p, e)), y);
        svg_end_group(z);
    }
    svg_mark(z, s->shape, x, y, 3, s->colour);
}

static int choose_scales(plot *p, const report *r, const plot_kind *kind)
{
    int seen = 0;
    double ratio = (double)r->entry[r->count - 1].k.first / (double)r->entry[0].k.first; /* the last may have no end */
    p->x = plot_empty_scale(ratio > LOGARITHMIC_FROM, true);
    p->y = plot_empty_scale(kind->logarithmic, kind->whole);
    for (size_t i = 0; i < r->count; i++)
        for (int j = 0; j < kind->count; j++) {
            span v = kind->series[j].get(&r->entry[i]);
            if (!is_seen(kind, v))
                continue;
            seen++;
            plot_hold(&p->x, (double)r->entry[i].k.first);
            plot_hold(&p->x, r->entry[i].k.last == VALENCES_UNBOUNDED ? 2 * (double)r->entry[i].k.first : (double)r->entry[i].k.last);
            plot_hold(&p->y, v.upper);
            plot_hold(&p->y, v.lower);
        }
    plot_finish_scale(&p->x);
    plot_finish_scale(&p->y);
    return seen;
}

static void draw_series(buffer *z, const plot *p, const report *r, const plot_kind *kind, const series *s, double *legend)
{
    bool seen = false;
    for (size_t i = 0; i < r->count; i++) {
        span v = s->get(&r->entry[i]);
        if (!is_seen(kind, v))
            continue;
        draw_span(z, p, s, &r->entry[i], v);
        seen = true;
    }
    if (seen)
        *legend = plot_legend(z, *legend, p->top - 14, s->shape, s->colour, s->name);
}

bool report_valences(buffer *z, const report *r, report_plot which)
{
    const plot_kind *kind = &kinds[which];
    plot p = {.left = 74, .top = 56, .width = 600, .height = 260, .x_label = "valence", .y_label = kind->y_label};
    char title[160];
    double legend = p.left;
    if (r->count == 0 || choose_scales(&p, r, kind) == 0)
        return false;
    snprintf(title, sizeof title, "%s: %s", r->scheme.name, kind->title);
    svg_begin(z, 700, 370, title);
    svg_group(z, "font-size=\"14\" font-weight=\"bold\"");
    svg_text(z, 14, 20, SVG_START, title);
    svg_end_group(z);
    plot_axes(z, &p);
    for (int j = 0; j < kind->count; j++)
        draw_series(z, &p, r, kind, &kind->series[j], &legend);
    svg_end(z);
    return true;
}
