/* command_report.c: a page with figures of what a run has left. */
#define _GNU_SOURCE /* getopt_long */
#include "command.h"

#include "report.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char help[] =
    "Usage: smoothcert report DIR [OPTION]...\n"
    "Makes a page with figures of what prove has left in the directory: characteristic maps,\n"
    "eigenvalues by block, elements, Jacobians, errors, levels and precision over the valences, and\n"
    "why the scheme is not C1 where it is not.  Every certificate is followed once more.\n"
    "\n"
    "  --out FILE      one HTML file, without network or scripts (default DIR/report.html)\n"
    "  --svg DIR       each figure as a file of its own, too\n"
    "  --valence LIST  the valences whose maps and eigenvalues are drawn (default: a few)\n"
    "  --help          this text\n";

typedef struct {
    const char *directory, *out, *svg;
    valence_list list;
    bool listed;
} options;

/* -1: go on; else the exit status. */
static int read_option(options *o, int option, const char *value)
{
    const char *complaint;
    switch (option) {
    case 'o':
        o->out = value;
        return -1;
    case 's':
        o->svg = value;
        return -1;
    case 'v':
        complaint = valence_list_read(&o->list, value);
        o->listed = true;
        return complaint ? complain(EXIT_USAGE, "--valence: %s", complaint) : -1;
    default:
        fputs(help, stdout);
        return finish_output(0);
    }
}

static int read_options(options *o, int argc, char **argv)
{
    static const struct option known[] = {
        {"out", required_argument, NULL, 'o'}, {"svg", required_argument, NULL, 's'}, {"valence", required_argument, NULL, 'v'}, {"help", no_argument, NULL, 'h'}, {NULL, 0, NULL, 0},
    };
    int option;
    o->directory = o->out = o->svg = NULL;
    o->listed = false;
    opterr = 0;
    while ((option = getopt_long(argc, argv, "", known, NULL)) != -1) {
        int result = option == '?' ? complain(EXIT_USAGE, "report: unknown option or missing value at '%s'; see 'smoothcert report --help'", argv[optind - 1]) : read_option(o, option, optarg);
        if (result >= 0)
            return result;
    }
    if (optind != argc - 1)
        return complain(EXIT_USAGE, "report: expected one directory; see 'smoothcert report --help'");
    o->directory = argv[optind];
    return -1;
}

/* ---- the figures ---- */

typedef struct {
    report_figure *figure;
    size_t count;
} gallery;

/* A new figure, to be drawn; NULL: no memory. */
static report_figure *hang(gallery *g, const char *name, const char *which)
{
    report_figure *p = realloc(g->figure, (g->count + 1) * sizeof *p);
    if (!p)
        return NULL;
    g->figure = p;
    p += g->count++;
    buffer_init(&p->svg);
    snprintf(p->name, sizeof p->name, which ? "%s-%.40s" : "%s", name, which);
    p->caption[0] = '\0';
    return p;
}

static void take_down(gallery *g)
{
    buffer_clear(&g->figure[--g->count].svg);
}

static void clear(gallery *g)
{
    while (g->count)
        take_down(g);
    free(g->figure);
}

static const char *caption_of_map(const report_entry *e)
{
    if (e->verdict == VERDICT_PROVED)
        return "The characteristic map on one ring round the vertex: its control net, and the elements on which the certificate decides that the map keeps its orientation. Nearer rings are smaller copies.";
    if (e->verdict == VERDICT_UNDECIDED)
        return "The characteristic map, as far as it is known: where the sign of the Jacobian stays open at this level, elements are marked.";
    if (e->claim == CLAIM_FOLD)
        return "The characteristic map folds: where the Jacobian is negative it is turned over. At the two marks the certificate proves both signs.";
    return "The map that dominates. The surface near the vertex looks like this, seen along the normal of the plane in which it would have to be smooth.";
}

static bool draw_map(gallery *g, const report *r, const report_entry *e)
{
    report_figure *f = hang(g, "map", e->at_name);
    if (!f)
        return false;
    report_map(&f->svg, r, e);
    if (is_one_valence(e->k))
        snprintf(f->caption, sizeof f->caption, "Valence %s. %s", e->at_name, caption_of_map(e));
    else
        snprintf(f->caption, sizeof f->caption, "Valence %s, one of %s, as double intervals show it. %s", e->at_name, e->name, caption_of_map(e));
    return true;
}

static bool draw_curve(gallery *g, const report *r, const report_entry *e)
{
    report_figure *f = hang(g, "curve", e->at_name);
    if (!f)
        return false;
    report_curve(&f->svg, r, e);
    snprintf(f->caption, sizeof f->caption, "Valence %s. Why it is not C1: going once round the vertex, the dominant map goes %ld times round its centre, so no plane can be covered once.", e->at_name, e->windings);
    return true;
}

static bool draw_spectrum(gallery *g, const report *r, const report_entry *e)
{
    report_figure *f = hang(g, "spectrum", e->at_name);
    report_status drawn = f ? report_spectrum(&f->svg, r, e) : REPORT_NO_MEMORY;
    if (drawn == REPORT_BAD_INPUT)
        take_down(g);
    else if (drawn == REPORT_OK)
        snprintf(f->caption, sizeof f->caption, "Valence %s: how large the eigenvalues are, proved. For a C1 surface the largest after 1 has to come from block 1, and alone.", e->at_name);
    return drawn != REPORT_NO_MEMORY;
}

static bool draw_entry(gallery *g, const report *r, const report_entry *e)
{
    bool ok = true;
    if (!e->shown || e->plainly_regular)
        return true;
    if (e->picture.taken && (e->claim == CLAIM_WINDING || (e->claim == CLAIM_FREQUENCY && e->frequency > 1)))
        ok = draw_curve(g, r, e);
    if (ok && e->picture.taken && e->claim != CLAIM_NOT_C0)
        ok = draw_map(g, r, e);
    return ok && draw_spectrum(g, r, e);
}

static bool draw_plots(gallery *g, const report *r)
{
    for (int which = 0; which < REPORT_PLOTS; which++) {
        report_figure *f = hang(g, report_plot_name((report_plot)which), NULL);
        if (!f)
            return false;
        if (report_valences(&f->svg, r, (report_plot)which))
            snprintf(f->caption, sizeof f->caption, "%s", report_plot_caption((report_plot)which));
        else
            take_down(g);
    }
    return true;
}

static bool draw_all(gallery *g, const report *r)
{
    bool ok = true;
    for (size_t i = 0; ok && i < r->count; i++)
        ok = draw_entry(g, r, &r->entry[i]);
    return ok && draw_plots(g, r);
}

/* ---- the files ---- */

static int write_file(const char *path, const buffer *text)
{
    FILE *f = fopen(path, "w");
    bool ok = f && fwrite(text->bytes, 1, text->length, f) == text->length;
    if (f && fclose(f) != 0)
        ok = false;
    return ok ? 0 : complain(EXIT_IO, "%s: %s", path, strerror(errno));
}

static int write_figures(const gallery *g, const char *directory)
{
    char path[4096];
    if (mkdir(directory, 0777) != 0 && errno != EEXIST)
        return complain(EXIT_IO, "%s: %s", directory, strerror(errno));
    for (size_t i = 0; i < g->count; i++) {
        int result;
        snprintf(path, sizeof path, "%.4000s/%s.svg", directory, g->figure[i].name);
        result = write_file(path, &g->figure[i].svg);
        if (result)
            return result;
    }
    return 0;
}

static int write_page(const options *o, const report *r, const gallery *g)
{
    char path[4096];
    buffer page;
    int result;
    buffer_init(&page);
    report_page(&page, r, g->figure, g->count);
    snprintf(path, sizeof path, o->out ? "%.4000s" : "%.4000s/report.html", o->out ? o->out : o->directory);
    result = page.failed ? complain(EXIT_NO_MEMORY, "no memory") : write_file(path, &page);
    buffer_clear(&page);
    if (result == 0)
        printf("%s: %zu figures\n", path, g->count);
    return result;
}

static int complain_of(const report *r, report_status s)
{
    if (s == REPORT_NO_MEMORY)
        return complain(EXIT_NO_MEMORY, "no memory");
    return complain(s == REPORT_IO_ERROR ? EXIT_IO : EXIT_BAD_INPUT, "%s", r->complaint);
}

static int make(const options *o, report *r, gallery *g)
{
    report_status s = report_read(r, o->directory);
    int result = 0;
    if (s == REPORT_OK)
        report_choose(r, o->listed ? &o->list : NULL);
    for (size_t i = 0; s == REPORT_OK && i < r->count; i++)
        s = report_follow(r, &r->entry[i]);
    if (s == REPORT_OK)
        s = report_compare_with_limit(r);
    if (s == REPORT_OK && !draw_all(g, r))
        s = REPORT_NO_MEMORY;
    for (size_t i = 0; s == REPORT_OK && i < g->count; i++)
        if (g->figure[i].svg.failed)
            s = REPORT_NO_MEMORY;
    if (s != REPORT_OK)
        return complain_of(r, s);
    if (o->svg)
        result = write_figures(g, o->svg);
    return result ? result : write_page(o, r, g);
}

int command_report(int argc, char **argv)
{
    options o;
    report r;
    gallery g = {NULL, 0};
    int result = read_options(&o, argc, argv);
    if (result >= 0)
        return result;
    report_init(&r);
    result = make(&o, &r, &g);
    clear(&g);
    report_clear(&r);
    return finish_output(result);
}
