/* examine.c: certificates read by those who did not write them. */
#include "examine.h"

#include "certificate.h"
#include "sha256.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_BYTES (64 << 20)

void examine_subject_init(examine_subject *z)
{
    scheme_init(&z->scheme);
    problem_init(&z->problem);
    z->made = false;
}

void examine_subject_clear(examine_subject *z)
{
    problem_clear(&z->problem);
    scheme_clear(&z->scheme);
    z->made = false;
}

void examination_init(examination *z)
{
    memset(z, 0, sizeof *z);
    buffer_init(&z->bytes);
    choices_init(&z->choices);
    findings_init(&z->findings);
    z->followed = OUTCOME_FAIL;
}

void examination_clear(examination *z)
{
    buffer_clear(&z->bytes);
    choices_clear(&z->choices);
    findings_clear(&z->findings);
}

bool examine_read(examination *z, const char *path)
{
    return buffer_read_file(&z->bytes, path, MAX_BYTES);
}

static bool is_about(const examine_subject *s, const statement *claim)
{
    return s->made && statement_is_about(claim, s->scheme.text, s->scheme.text_length);
}

/* STATUS_BAD_INPUT: the text is no scheme, or not its own canonical text. */
static status make_subject(examine_subject *s, const statement *claim, diagnostic *d)
{
    status result;
    if (is_about(s, claim))
        return STATUS_OK;
    examine_subject_clear(s);
    result = scheme_read(&s->scheme, claim->scheme, claim->scheme_length, NULL, d);
    if (result != STATUS_OK)
        return result;
    if (!problem_make(&s->problem, &s->scheme))
        return STATUS_NO_MEMORY;
    s->made = true;
    if (is_about(s, claim))
        return STATUS_OK;
    snprintf(d->text, sizeof d->text, "the scheme's text is not in its canonical form");
    d->line = 1;
    return STATUS_BAD_INPUT;
}

static void blame(examination *z, long line, const char *reason)
{
    z->line = line;
    snprintf(z->reason, sizeof z->reason, "%s", reason);
}

/* Its choices, if it is of the version that is written now. */
static bool read_choices(examination *z, const examine_subject *s)
{
    long line = 0;
    if (z->claim.version < STATEMENT_NEWEST_VERSION) {
        blame(z, 1, "an old format, which only smoothcert-check follows");
        return true;
    }
    if (!certificate_read(&z->choices, &line, &s->scheme, z->bytes.bytes, z->bytes.length))
        return false;
    z->readable = line == 0;
    if (line)
        blame(z, line, "this line is not what the specification allows here, or the file was changed");
    return true;
}

static bool follow(examination *z, const examine_subject *s, const deadline *d)
{
    analysis_plan plan = {.problem = &s->problem, .deadline = d, .system = "grid"};
    z->followed = analysis_replay(&z->findings, &z->choices, &plan);
    return z->followed != OUTCOME_NO_MEMORY;
}

bool examine(examination *z, examine_subject *s, const deadline *d)
{
    diagnostic trouble = {0, 0, ""};
    const char *complaint;
    long line;
    const char *bytes = z->bytes.bytes ? z->bytes.bytes : "";
    sha256_hex(z->digest, bytes, z->bytes.length);
    complaint = statement_read(&z->claim, &line, bytes, z->bytes.length);
    if (complaint) {
        blame(z, line, complaint);
        return true;
    }
    switch (make_subject(s, &z->claim, &trouble)) {
    case STATUS_OK:
        break;
    case STATUS_BAD_INPUT:
        blame(z, trouble.line + 2, trouble.text);
        return true;
    default:
        return false;
    }
    return read_choices(z, s) && (!z->readable || follow(z, s, d));
}

void examine_print_claim(char *text, size_t size, const examination *z, const char *name)
{
    char valences[VALENCE_RANGE_TEXT];
    valence_range_print(valences, z->claim.valences);
    snprintf(text, size, "%s is %sC1 at valence%s %s", name, z->claim.c1 ? "" : "not ", z->claim.valences.first < z->claim.valences.last ? "s" : "", valences);
}

void examine_print_radius(char text[EXAMINE_RADIUS_TEXT], const eigenpair_choice *e)
{
    /* log10 of the radius: of its first 64 bits at most, and of the rest of the exponent; the error is far below 1e-9. */
    const integer *radius = integer_sign(&e->range) > 0 ? &e->range : &e->radius; /* of all valences */
    size_t bits = integer_bits(radius), shift = bits > 64 ? bits - 64 : 0;
    double log, mantissa;
    integer head;
    integer_init(&head);
    if (!integer_cdiv_2exp(&head, radius, shift)) {
        snprintf(text, EXAMINE_RADIUS_TEXT, "?");
        return;
    }
    log = log10(integer_get_double_approx(&head)) + ((double)shift - (double)e->grid) * log10(2) + 1e-9;
    mantissa = ceil(pow(10, log - floor(log)) * 10) / 10;
    snprintf(text, EXAMINE_RADIUS_TEXT, "%.1fe%.0f", mantissa < 10 ? mantissa : mantissa / 10, floor(log) + (mantissa >= 10));
    integer_clear(&head);
}
