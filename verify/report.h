/* report.h: figures and a page from what a run has left in its directory.

   The verdicts of a report are those of certificates that were followed once more while it was made; what comes from logs
   (times, precisions, why something stayed undecided) says what the run said. */
#ifndef VERIFY_REPORT_H
#define VERIFY_REPORT_H

#include "archive_view.h"
#include "outcome.h"
#include "picture.h"
#include "problem.h"
#include "svg.h"
#include "valence_list.h"

/* What the log says of an entry. */
typedef struct {
    char system[16];     /* of the last attempt: "exact", "interval", "ball"; "" if there is no log */
    long precision;
    double others;       /* every other eigenvalue is at most this large; NaN: not said */
    double error;        /* of the uniform method; NaN: not used */
    double seconds;
    char test[32], reason[256]; /* why it is undecided */
} report_log;

/* What there is about a valence, or a range of them. */
typedef struct {
    valence_range k;
    char name[VALENCE_RANGE_TEXT]; /* "7", as in the names of its files */
    verdict verdict;
    char digest[65];     /* of the certificate, "" if there is none */
    bool followed;       /* the certificate proves the verdict */
    claim_kind claim;
    long frequency, grid;
    bool plainly_regular;
    double eigenvalue_lower, eigenvalue_upper; /* |L| */
    double jacobian;     /* > 0, a lower bound; NaN: none */
    long windings;       /* of the curve of an eigenfunction round 0; the frequency, or what was found */
    double radius;       /* of the box round the approximate eigenpair */
    int level;           /* of subdivision */
    long elements;       /* in the certificate's trees */
    point witness[2];    /* of a fold, where the Jacobian is positive and negative */
    picture picture;
    double distance;     /* of the control net from that of the largest valence; NaN: not known */
    bool shown;          /* is it among those of which maps are drawn? */
    long at;             /* then at this valence, */
    char at_name[24];    /*   as text */
    report_log log;
} report_entry;

typedef struct {
    archive_view view;
    scheme scheme;
    problem problem;
    picture limit;       /* at the largest valence there is: nets are as good as at their limit there */
    report_entry *entry; /* by valences */
    size_t count;
    char complaint[512]; /* what is wrong, and where */
} report;

typedef enum { REPORT_OK, REPORT_BAD_INPUT, REPORT_IO_ERROR, REPORT_NO_MEMORY } report_status;

void report_init(report *z);
void report_clear(report *z);
/* The scheme, its regular part, what certificates there are, and the logs of the directory.  Unless REPORT_OK, z->complaint. */
report_status report_read(report *z, const char *path);
/* Chooses entries to be shown: those whose valence is in the list, or if it is NULL a few of each verdict. */
void report_choose(report *z, const valence_list *list);
/* Follows the certificate of an entry, and takes its picture. */
report_status report_follow(report *z, report_entry *e);
/* How far the nets of all entries are from their limit; after they were followed. */
report_status report_compare_with_limit(report *z);

const char *report_reason(const report_entry *e); /* of a refutation, in a few words */

/* ---- figures: SVG text into an empty buffer ---- */

/* The map of the entry's picture, which is with_net, on the ring. */
void report_map(buffer *z, const report *r, const report_entry *e);
/* The image of the outer curve. */
void report_curve(buffer *z, const report *r, const report_entry *e);
/* The moduli of eigenvalues by block.  REPORT_BAD_INPUT: there are none to be shown. */
report_status report_spectrum(buffer *z, const report *r, const report_entry *e);

typedef enum { REPORT_EIGENVALUES, REPORT_ELEMENTS, REPORT_LEVELS, REPORT_JACOBIAN, REPORT_ERRORS, REPORT_RADIUS, REPORT_DISTANCE, REPORT_PRECISION, REPORT_PLOTS } report_plot;
const char *report_plot_name(report_plot which);
const char *report_plot_caption(report_plot which);
/* Over all valences.  false: there is nothing to be seen. */
bool report_valences(buffer *z, const report *r, report_plot which);

/* ---- the page ---- */

typedef struct {
    char name[64];       /* of the file, without .svg */
    char caption[512];
    buffer svg;
} report_figure;

void report_page(buffer *z, const report *r, const report_figure *figure, size_t figures);

#endif
