/* command_show.c: what a certificate says, in words. */
#define _GNU_SOURCE /* getopt_long */
#include "command.h"

#include "command_certificates.h"
#include "command_scheme.h"
#include "examine.h"
#include "json.h"

#include "../bigfloat/ball.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char help[] =
    "Usage: smoothcert show [OPTION]... CERTIFICATE|DIRECTORY...\n"
    "Explains certificates in words: what they claim, by which choices, and whether these prove it.\n"
    "\n"
    "  --digits N   of the eigenvalue (1 to 3000; default 20)\n"
    "  --json       one JSON object per certificate and line\n"
    "  --help       this text\n"
    "\n"
    "Exit status: 0, 65 if a certificate is damaged or does not prove its claim.  Those of old formats are not\n"
    "followed here.  Whoever does not want to trust this program asks smoothcert-check.\n";

typedef struct {
    long digits;
    bool json;
    examine_subject subject;
    int result;
} show_run;

/* ---- figures ---- */

/* L with its enclosure, or |L| by its square: text to be freed, NULL: no memory. */
static char *print_number(const integer *middle, const eigenpair_choice *e, int digits)
{
    ball x, radius;
    char *text;
    ball_init(&x);
    ball_init(&radius);
    ball_set_integer_2exp(&x, middle, -e->grid, e->grid + 64);
    ball_set_integer_2exp(&radius, integer_sign(&e->range) > 0 ? &e->range : &e->radius, -e->grid, e->grid + 64); /* of all valences */
    ball_add_error(&x, &x, &radius, e->grid + 64);
    text = ball_get_decimal(&x, digits);
    ball_clear(&x);
    ball_clear(&radius);
    return text;
}

static void print_eigenvalue(buffer *text, const choices *c, int digits)
{
    const eigenpair_choice *e = &c->eigenpair;
    char *re = print_number(&e->approximation[e->n - 1 - e->complex_form], e, digits), *im = NULL, growth[CHOICES_GROWTH_TEXT];
    choices_print_growth(growth, c);
    if (e->complex_form)
        im = print_number(&e->approximation[e->n - 1], e, digits);
    if (!re || (e->complex_form && !im))
        text->failed = true;
    else if (e->complex_form)
        buffer_print(text, "(%s) + i (%s)", re, im);
    else if (*growth)
        buffer_print(text, "(%s) %s", re, growth);
    else
        buffer_print(text, "%s", re);
    free(re);
    free(im);
}

typedef struct {
    long leaves;
    int depth;
} tree_size;

/* All trees of the word, one after the other: each split has as many children as elements have. */
static tree_size measure(const tree_word *w, int children)
{
    tree_size z = {0, 0};
    int open[TREE_MAX_DEPTH + 2], depth = 0; /* children that are still to come, on each level */
    for (size_t i = 0; i < w->length; i++) {
        if (w->letter[i] == TREE_SPLIT && depth <= TREE_MAX_DEPTH) {
            open[depth++] = children;
            z.depth = depth > z.depth ? depth : z.depth;
            continue;
        }
        z.leaves++;
        while (depth && --open[depth - 1] == 0)
            depth--;
    }
    return z;
}

/* ---- in words ---- */

static void say_regular(const choices *c)
{
    printf("  regular mesh    C1: the powers %d, %d, %d of the second difference schemes have norms below 1\n", c->contraction[0], c->contraction[1], c->contraction[2]);
    if (c->plainly_regular) {
        printf("  vertex          regular, and no rule holds there: nothing else is to be proved\n");
        return;
    }
    printf("  stability       values and derivatives of limits are at most");
    for (int i = 0; i < 3; i++)
        printf("%s %.6g", i ? "," : "", (double)c->stability[i].bound / 1024);
    printf(" times the control values\n");
}

static void say_spectrum(const choices *c, const char *eigenvalue)
{
    const eigenpair_choice *e = &c->eigenpair;
    printf("  eigenvalue      L = %s\n", eigenvalue);
    printf("                  simple; of block %ld (%s form, order %d): its nets turn %ld time%s as one goes round once\n", c->frequency,
           c->claim == CLAIM_GRADED ? "graded" : e->complex_form ? "complex" : c->frequency == 0 ? "plain" : "real", e->n, c->frequency, c->frequency == 1 ? "" : "s");
    if (c->blocks.count == 0)
        return;
    printf("  the others      are smaller, by powers of the blocks (first..last: power):");
    for (size_t i = 0; i < c->blocks.count && i < 6; i++) {
        const cover_box *b = &c->blocks.box[i];
        if (b->m.first == b->m.last)
            printf("%s %ld: %d", i ? "," : "", b->m.first, b->power);
        else
            printf("%s %ld..%ld: %d", i ? "," : "", b->m.first, b->m.last, b->power);
    }
    printf("%s\n", c->blocks.count > 6 ? " ..." : "");
    if (c->has_limit)
        printf("                  block 0 tends to block 1 as the valence grows, and falls behind it\n");
    if (c->rise.count)
        printf("                  near m/k = 0 they rise with u = cos(pi m / k), on %zu arcs\n", c->rise.count);
    if (c->spans.count)
        printf("                  %s on %zu spans of m/k\n", c->frequency == 1 ? "blocks 2 and more" : "other blocks", c->spans.count);
}

static void say_tree(const char *what, const tree_word *w, int children, const char *why)
{
    tree_size size = measure(w, children);
    printf("  %-15s on %ld elements, subdivided at most %d time%s: %s\n", what, size.leaves, size.depth, size.depth == 1 ? "" : "s", why);
}

static void say_witness(const witness_choice *w, const char *what)
{
    printf("  witness         %s on element %d%s%s\n", what, w->element, w->depth ? ", descendant " : "", w->depth ? w->path : "");
}

/* Blocks that are computed exactly, and what they have in common. */
static void say_exact(const choices *c)
{
    const char *words = c->claim == CLAIM_TIE ? "eigenvalues of the largest modulus are equal: there is no tangent plane"
                        : c->claim == CLAIM_JORDAN ? "the eigenvalue of the largest modulus has a larger Jordan block than all others"
                                                   : "an eigenvalue has the modulus 1: there is no continuous limit";
    printf("  exactly         %s\n                 ", words);
    for (int i = 0; i < c->exact.count; i++)
        printf("%s block %ld: %d time%s, rows %d%s", i ? "," : "", c->exact.line[i].frequency, c->exact.line[i].multiplicity, c->exact.line[i].multiplicity == 1 ? "" : "s",
               c->exact.line[i].size, c->exact.line[i].sign < 0 ? " (negative)" : "");
    printf("\n");
}

static void say_evidence(const choices *c, const findings *f)
{
    switch (c->claim) {
    case CLAIM_C1:
        say_tree("regularity", &c->regularity, 4, "the Jacobian of the characteristic map is positive");
        say_tree("injectivity", &c->boundary, 2, "the outer curve of a sector stays in one half-plane");
        break;
    case CLAIM_WINDOW:
        printf("  window          m/k from %.6f to %.6f, in %zu parts: the eigenfunctions have no zero on the outer curve, and wind m times\n",
               ldexp((double)c->window.start, -ARC_BITS), ldexp((double)window_choice_end(&c->window), -ARC_BITS), c->window.count);
        break;
    case CLAIM_FREQUENCY:
        say_tree("no zero", &c->boundary, 2, "the eigenfunction has no zero on the outer curve, and another frequency than 1");
        break;
    case CLAIM_GRADED:
        printf("  growth          block 0 is scaled by powers of k; its eigenvalue is that of the scaled block times (k/%ld)^%d\n", c->graded.unit, c->graded.degree);
        /* fall through */
    case CLAIM_NOT_C0:
        say_witness(&c->witness[0], "the eigenfunction of an eigenvalue beyond 1 is not 0");
        break;
    case CLAIM_FOLD:
        say_witness(&c->witness[0], "the Jacobian is positive");
        say_witness(&c->witness[1], "the Jacobian is negative");
        break;
    case CLAIM_WINDING:
        say_tree("winding", &c->boundary, 2, "the characteristic map has no zero on the outer curve");
        printf("                  it winds %ld times round the extraordinary point\n", f->windings);
        break;
    case CLAIM_REAL:
        printf("  second          an eigenvalue of block %ld comes next: %s\n", c->second_frequency,
               c->second_frequency ? "the normals of the two functions have no limit" : "the map of the two functions folds");
        say_witness(&c->witness[0], "both Jacobians are other than 0");
        break;
    case CLAIM_TIE:
    case CLAIM_JORDAN:
    case CLAIM_MODULUS_ONE:
        say_exact(c);
        break;
    default:
        break;
    }
}

static void say_followed(const examination *x)
{
    const attempt *last = &x->findings.attempts[x->findings.attempt_count ? x->findings.attempt_count - 1 : 0];
    if (!x->readable && x->claim.version < STATEMENT_NEWEST_VERSION)
        printf("  followed        not here: %s\n", x->reason);
    else if (!x->readable)
        printf("  followed        no: line %ld: %s\n", x->line, x->reason);
    else if (x->followed == OUTCOME_TRUE)
        printf("  followed        yes: with these choices every step of the specification holds\n");
    else
        printf("  followed        no: %s: %s\n", last->test ? last->test : "start", last->reason);
}

static int say(const examination *x, const show_run *r, const char *file, const char *eigenvalue)
{
    char claim[160];
    const scheme *s = &r->subject.scheme;
    if (!x->claim.scheme) {
        printf("%s: line %ld: %s\n", file, x->line, x->reason);
        return 0;
    }
    examine_print_claim(claim, sizeof claim, x, r->subject.made ? s->name : "the scheme");
    printf("%s: %s%s\n", file, x->followed == OUTCOME_TRUE ? "" : "claims that ", claim);
    printf("  certificate     format %d, %zu bytes, SHA-256 %s\n", x->claim.version, x->bytes.length, x->digest);
    if (r->subject.made)
        printf("  scheme          %s, on a %s mesh; its text is in the certificate\n", s->name, mesh_name(s->mesh));
    printf("  arithmetic      exact, in units of 2^-%ld\n", x->claim.grid);
    if (x->followed == OUTCOME_TRUE) {
        say_regular(&x->choices);
        if (!x->choices.plainly_regular && eigenvalue)
            say_spectrum(&x->choices, eigenvalue);
        if (!x->choices.plainly_regular)
            say_evidence(&x->choices, &x->findings);
    }
    say_followed(x);
    return 0;
}

static int say_json(const examination *x, const show_run *r, const char *file, const char *eigenvalue)
{
    char valences[VALENCE_RANGE_TEXT] = "";
    buffer b;
    buffer_init(&b);
    buffer_print(&b, "{\"holds\":%s", x->followed == OUTCOME_TRUE ? "true" : "false");
    json_add_string(&b, "certificate", file);
    json_add_string(&b, "sha256", x->digest);
    if (x->claim.scheme) {
        valence_range_print(valences, x->claim.valences);
        json_add_string(&b, "scheme", r->subject.made ? r->subject.scheme.name : "");
        json_add_string(&b, "valence", valences);
        json_add_string(&b, "claim", x->claim.c1 ? "c1" : "not-c1");
        buffer_print(&b, ",\"format\":%d,\"grid\":%ld", x->claim.version, x->claim.grid);
    }
    if (x->followed == OUTCOME_TRUE && eigenvalue) {
        json_add_string(&b, "eigenvalue", eigenvalue);
        buffer_print(&b, ",\"frequency\":%ld", x->choices.frequency);
    }
    if (!x->readable)
        buffer_print(&b, ",\"line\":%ld", x->line);
    if (!x->readable)
        json_add_string(&b, "trouble", x->reason);
    buffer_print(&b, "}");
    return print_line(&b);
}

/* ---- one after the other ---- */

static int show_certificate(const char *file, void *data)
{
    show_run *r = data;
    examination x;
    buffer eigenvalue;
    int result = 0;
    examination_init(&x);
    buffer_init(&eigenvalue);
    if (!examine_read(&x, file)) {
        result = complain_of_file(file);
    } else if (!examine(&x, &r->subject, NULL)) {
        result = complain_of_memory();
    } else {
        if (x.readable && !x.choices.plainly_regular && x.choices.eigenpair.n > 0)
            print_eigenvalue(&eigenvalue, &x.choices, (int)r->digits);
        if (eigenvalue.failed)
            result = complain_of_memory();
        else
            result = (r->json ? say_json : say)(&x, r, file, eigenvalue.bytes);
        if (x.followed != OUTCOME_TRUE && (!x.claim.scheme || x.claim.version == STATEMENT_NEWEST_VERSION))
            r->result = EXIT_BAD_INPUT;
    }
    buffer_clear(&eigenvalue);
    examination_clear(&x);
    return result;
}

static int read_options(show_run *r, int argc, char **argv)
{
    static const struct option known[] = {{"digits", required_argument, NULL, 'd'}, {"json", no_argument, NULL, 'J'}, {"help", no_argument, NULL, 'h'}, {NULL, 0, NULL, 0}};
    opterr = 0;
    for (int option; (option = getopt_long(argc, argv, "", known, NULL)) != -1;) {
        switch (option) {
        case 'd':
            if (!read_long_option(&r->digits, optarg, 1, 3000))
                return complain(EXIT_USAGE, "--digits: expected a number from 1 to 3000, found '%s'", optarg);
            break;
        case 'J':
            r->json = true;
            break;
        case 'h':
            fputs(help, stdout);
            return finish_output(0);
        default:
            return complain(EXIT_USAGE, "show: unknown option or missing value at '%s'; see 'smoothcert show --help'", argv[optind - 1]);
        }
    }
    if (optind == argc)
        return complain(EXIT_USAGE, "show: no certificate given; see 'smoothcert show --help'");
    return -1;
}

int command_show(int argc, char **argv)
{
    show_run r = {.digits = 20};
    int result = read_options(&r, argc, argv);
    if (result >= 0)
        return result;
    examine_subject_init(&r.subject);
    result = 0;
    for (int i = optind; result == 0 && i < argc; i++)
        result = for_each_certificate(argv[i], show_certificate, &r);
    examine_subject_clear(&r.subject);
    return finish_output(result ? result : r.result);
}
