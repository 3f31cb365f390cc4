/* report_page.c: one HTML file: what is proved, the table, the figures, the scheme, and how to check it all. */
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char style[] =
    "body { font: 16px/1.5 Georgia, 'DejaVu Serif', serif; max-width: 62em; margin: 2em auto; padding: 0 1em; color: #000; background: #fff }\n"
    "h1, h2, th, figcaption { font-family: Helvetica, Arial, 'DejaVu Sans', sans-serif }\n"
    "h1 { font-size: 1.6em; margin-bottom: 0.2em } h2 { font-size: 1.15em; margin-top: 2em }\n"
    "table { border-collapse: collapse; font-size: 0.85em; font-family: Helvetica, Arial, 'DejaVu Sans', sans-serif }\n"
    "th, td { padding: 0.15em 0.7em; text-align: right; border-bottom: 1px solid #ddd; white-space: nowrap }\n"
    "td.text, th.text { text-align: left; white-space: normal } td.remark:not(:empty) { min-width: 14em }\n"
    "td.proved { border-left: 4px solid #0072b2 } td.refuted { border-left: 4px solid #d55e00 } td.undecided { border-left: 4px solid #f0e442 }\n"
    "pre { background: #f4f4f4; padding: 0.8em 1em; overflow-x: auto; font-size: 0.8em }\n"
    "figure { margin: 1.5em 0; break-inside: avoid } figcaption { font-size: 0.85em; max-width: 50em }\n"
    "svg { max-width: 100%; height: auto }\n"
    "@media print { body { font-size: 11px; margin: 0; max-width: none } }\n";

static void heading(buffer *z, const char *text)
{
    buffer_print(z, "<h2>");
    svg_escape(z, text);
    buffer_print(z, "</h2>\n");
}

static void paragraph(buffer *z, const char *text)
{
    buffer_print(z, "<p>");
    svg_escape(z, text);
    buffer_print(z, "</p>\n");
}

/* ---- what is proved ---- */

static size_t count_of(const report *r, verdict v)
{
    size_t count = 0;
    for (size_t i = 0; i < r->count; i++)
        count += r->entry[i].verdict == v;
    return count;
}

static bool has_no_end(const report *r, verdict v)
{
    const report_entry *last = r->count ? &r->entry[r->count - 1] : NULL;
    return last && last->verdict == v && last->k.last == VALENCES_UNBOUNDED;
}

static void summary(buffer *z, const report *r)
{
    static const struct {
        verdict verdict;
        const char *before, *behind;
    } sentences[] = {
        {VERDICT_PROVED, "<b>Proved:</b> the scheme is C1 at valence ", "."},
        {VERDICT_REFUTED, "<b>Refuted:</b> it is not C1 at valence ", "."},
        {VERDICT_UNDECIDED, "<b>Undecided:</b> nothing is known at valence ", "; the table says what was missing."},
    };
    for (size_t i = 0; i < sizeof sentences / sizeof *sentences; i++) {
        if (count_of(r, sentences[i].verdict) == 0)
            continue;
        buffer_print(z, "<p>%s", sentences[i].before);
        archive_view_list(z, &r->view, sentences[i].verdict);
        buffer_print(z, "%s%s</p>\n", has_no_end(r, sentences[i].verdict) ? " (without end)" : "", sentences[i].behind);
    }
    paragraph(z, "C1 means that for all control meshes, but a nowhere dense set of them, the limit surface near an extraordinary vertex of that "
                 "valence is a continuously differentiable surface. Every certificate named here was followed once more when this page was made.");
}

/* ---- the table ---- */

static void cell(buffer *z, const char *format, double v)
{
    buffer_print(z, "<td>");
    if (isfinite(v))
        buffer_print(z, format, v);
    buffer_print(z, "</td>");
}

/* Bounds, rounded so that they stay bounds: for nine and four places as on the lines of prove. */
static void figures(buffer *z, const report_entry *e)
{
    bool usual = e->followed && !e->plainly_regular;
    cell(z, "%.9f", usual ? (e->eigenvalue_lower + e->eigenvalue_upper) / 2 : NAN);
    cell(z, "%.1e", usual ? (e->eigenvalue_upper - e->eigenvalue_lower) * 0.55 + 5e-10 : NAN);
    cell(z, "%.9f", usual ? e->log.others + 0.501e-9 : NAN);
    cell(z, "%.4g", usual ? e->jacobian * (1 - 0.000501) : NAN);
    cell(z, "%.0f", usual ? (double)e->level : NAN);
    cell(z, "%.0f", usual ? (double)e->elements : NAN);
}

static void remark(buffer *z, const report_entry *e)
{
    buffer_print(z, "<td class=\"text remark\">");
    if (e->verdict == VERDICT_UNDECIDED) {
        svg_escape(z, e->log.test);
        buffer_print(z, "%s", e->log.test[0] ? ": " : "");
        svg_escape(z, e->log.reason[0] ? e->log.reason : "there is no log");
    } else if (e->verdict == VERDICT_REFUTED) {
        svg_escape(z, report_reason(e));
        if (e->claim == CLAIM_FREQUENCY || e->claim == CLAIM_WINDING)
            buffer_print(z, ": %ld", e->windings);
    } else if (e->plainly_regular)
        buffer_print(z, "no rule holds there: the regular complex");
    buffer_print(z, "</td>");
}

static void row(buffer *z, const report_entry *e)
{
    buffer_print(z, "<tr><td class=\"%s\">%s</td><td class=\"text\">%s</td>", verdict_name(e->verdict), e->name, verdict_name(e->verdict));
    figures(z, e);
    buffer_print(z, "<td>%ld</td>", e->log.precision);
    remark(z, e);
    if (e->digest[0])
        buffer_print(z, "<td class=\"text\"><code title=\"%s\">%.12s</code></td></tr>\n", e->digest, e->digest);
    else
        buffer_print(z, "<td></td></tr>\n");
}

static void table(buffer *z, const report *r)
{
    heading(z, "Valence by valence");
    buffer_print(z, "<table><tr><th>valence</th><th class=\"text\">verdict</th><th>|L|</th><th>&plusmn;</th><th>others &lt;</th><th>Jacobian &gt;</th><th>level</th>"
                    "<th>elements</th><th>bits</th><th class=\"text\">remark</th><th class=\"text\">SHA-256</th></tr>\n");
    for (size_t i = 0; i < r->count; i++)
        row(z, &r->entry[i]);
    buffer_print(z, "</table>\n");
    paragraph(z, "L is the dominant eigenvalue; all others but 1 are smaller in modulus than the next figure. The Jacobian is that of the characteristic map on one ring. "
                 "Bits: of the numbers with which the last attempt was made, 53 being hardware intervals and 0 exact arithmetic; the certificate itself is exact integers.");
}

/* ---- the rest ---- */

static void show_figures(buffer *z, const report_figure *figure, size_t figures)
{
    if (figures)
        heading(z, "Figures");
    for (size_t i = 0; i < figures; i++) {
        buffer_print(z, "<figure id=\"%s\">\n", figure[i].name);
        buffer_append(z, figure[i].svg.bytes, figure[i].svg.length);
        buffer_print(z, "<figcaption>");
        svg_escape(z, figure[i].caption);
        buffer_print(z, "</figcaption></figure>\n");
    }
}

static void show_scheme(buffer *z, const report *r)
{
    heading(z, "The scheme");
    buffer_print(z, "<pre>");
    svg_escape(z, r->scheme.text);
    buffer_print(z, "</pre>\n");
    paragraph(z, "This is the text, with all parameters as they were set, that the certificates are about.");
}

static void how_to_check(buffer *z, const report *r)
{
    static const struct {
        verdict verdict;
        const char *claim;
    } claims[] = {{VERDICT_PROVED, "c1"}, {VERDICT_REFUTED, "not-c1"}};
    heading(z, "To check it without trusting this page");
    paragraph(z, "The checker shares no source with the program that found the proofs, and needs nothing but a C compiler. In the directory of this run:");
    buffer_print(z, "<pre>");
    for (size_t i = 0; i < sizeof claims / sizeof *claims; i++) {
        if (count_of(r, claims[i].verdict) == 0)
            continue;
        buffer_print(z, "smoothcert-check --scheme scheme.scheme --claim %s --valence ", claims[i].claim);
        for (size_t e = 0, some = 0; e < r->count; e++)
            if (r->entry[e].verdict == claims[i].verdict)
                buffer_print(z, "%s%s", some++ ? "," : "", r->entry[e].name);
        buffer_print(z, " .\n");
    }
    buffer_print(z, "</pre>\n");
    paragraph(z, "Or, which is the same: sh verify.sh");
}

void report_page(buffer *z, const report *r, const report_figure *figure, size_t figures)
{
    buffer_print(z, "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>");
    svg_escape(z, r->scheme.name);
    buffer_print(z, ": smoothness at extraordinary vertices</title>\n<style>\n");
    buffer_append(z, style, strlen(style));
    buffer_print(z, "</style></head>\n<body>\n<h1>");
    svg_escape(z, r->scheme.name);
    buffer_print(z, ": smoothness at extraordinary vertices</h1>\n");
    summary(z, r);
    table(z, r);
    show_figures(z, figure, figures);
    show_scheme(z, r);
    how_to_check(z, r);
    buffer_print(z, "</body></html>\n");
}
