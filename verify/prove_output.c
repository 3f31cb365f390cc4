/* prove_output.c: figures as bounds, sentences as JSON strings. */
#include "prove_output.h"

#include "advice.h"
#include "json.h"
#include "valence_range.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Bounds are printed so that the decimals still are bounds.  Printing moves a number by at most half a unit of the
   last digit, so it is moved by a little more than that before: for nine places behind the point 0.5e-9 (the
   excess is far above a rounding error of numbers below 1), for four significant digits of v at most v / 2000. */
static double round_up(double v)
{
    return v + 0.5e-9 * (1 + 1e-3);
}

static double round_down(double v)
{
    return v * (1 - 0.000501);
}

/* "double intervals", "balls of 128 bits" */
static void describe_system(char *text, size_t size, const char *system, long precision)
{
    if (!strcmp(system, "interval"))
        snprintf(text, size, "double intervals");
    else if (!strcmp(system, "ball"))
        snprintf(text, size, "balls of %ld bits", precision);
    else
        snprintf(text, size, "exact arithmetic");
}

/* "valence 7", "valences 8..20" */
static void describe_valences(char *text, size_t size, valence_range k)
{
    char range[VALENCE_RANGE_TEXT];
    valence_range_print(range, k);
    snprintf(text, size, "valence%s %s", is_one_valence(k) ? "" : "s", range);
}

static void print_figures(const decision *d)
{
    const findings *f = &d->findings;
    char others[32] = "|L|", where[32] = "";
    if (f->runner_up < f->eigenvalue_lower)
        snprintf(others, sizeof others, "%.9f", round_up(f->runner_up));
    if (is_one_valence(d->k))
        snprintf(where, sizeof where, " (block %ld)", f->runner_up_block);
    printf("L = %s, others < %s%s, Jacobian > %.4g, ", f->eigenvalue, others, where, round_down(f->jacobian));
    if (f->uniform)
        printf("uniform level %d, %ld elements (adaptive: level %d, %ld elements), ", f->uniform_level, f->uniform_elements, f->level, f->elements);
    else
        printf("level %d, %ld elements, ", f->level, f->elements);
}

void prove_print_line(const char *name, const decision *d, const char *certificate)
{
    char system[64], valences[64];
    describe_valences(valences, sizeof valences, d->k);
    if (d->verdict == VERDICT_PROVED) {
        printf("proved: %s is C1 at %s; ", name, valences);
        describe_system(system, sizeof system, d->plainly_regular || d->kept_before ? "exact" : d->system, d->precision);
        if (d->kept_before)
            printf("by the certificate of an earlier run, followed once more");
        else if (d->plainly_regular)
            printf("no rule holds there, and the regular complex is C1; %s", system);
        else {
            print_figures(d);
            printf("%s", system);
        }
    } else if (d->verdict == VERDICT_REFUTED) {
        printf("refuted: %s is not C1 at %s; ", name, valences);
        describe_system(system, sizeof system, d->kept_before ? "exact" : d->system, d->precision);
        if (d->kept_before)
            printf("by the certificate of an earlier run, followed once more");
        else
            printf("%s; %s%s%s%s", d->reason, d->findings.eigenvalue ? "L = " : "", d->findings.eigenvalue ? d->findings.eigenvalue : "", d->findings.eigenvalue ? ", " : "", system);
    } else {
        const attempt *a = decision_obstacle(d);
        char advice[256];
        describe_system(system, sizeof system, a->system, a->precision);
        advise(advice, sizeof advice, d);
        printf("undecided: %s at %s; %s: %s; last tried with %s; %s", name, valences, a->test, a->reason, system, advice);
    }
    printf(", %.3g s", d->seconds);
    if (certificate)
        printf("; %s", certificate);
    printf("\n");
}

/* ---- JSON ---- */

/* Of one valence the number, of several the first and the last one, which is null if there is none. */
static void write_valences(buffer *b, valence_range k)
{
    if (is_one_valence(k))
        buffer_print(b, "\"valence\":%ld", k.first);
    else if (k.last == VALENCES_UNBOUNDED)
        buffer_print(b, "\"valences\":[%ld,null]", k.first);
    else
        buffer_print(b, "\"valences\":[%ld,%ld]", k.first, k.last);
}

/* Of the trees of the certificate, and of the uniform method. */
static void write_levels(buffer *b, const findings *f)
{
    buffer_print(b, ",\"level\":%d,\"elements\":%ld", f->level, f->elements);
    if (f->uniform)
        buffer_print(b, ",\"uniform_level\":%d,\"uniform_elements\":%ld", f->uniform_level, f->uniform_elements);
}

/* Of several valences the others are below L at each; a number only if it is below all of these. */
static void write_findings(buffer *b, const findings *f, bool one)
{
    json_add_string(b, "eigenvalue", f->eigenvalue);
    json_add_number(b, "modulus_lower", f->eigenvalue_lower);
    json_add_number(b, "modulus_upper", f->eigenvalue_upper);
    if (f->runner_up < f->eigenvalue_lower || one)
        json_add_number(b, "others_upper", fmin(f->runner_up, f->eigenvalue_lower));
    if (one)
        buffer_print(b, ",\"others_block\":%ld", f->runner_up_block);
    json_add_number(b, "jacobian_lower", f->jacobian);
    buffer_print(b, ",\"method\":\"%s\"", f->uniform ? "uniform" : "adaptive");
    write_levels(b, f);
}

void prove_print_json(const char *name, const decision *d, const char *certificate)
{
    const attempt *a = decision_obstacle(d);
    buffer b;
    buffer_init(&b);
    buffer_print(&b, "{\"scheme\":\"%s\",", name);
    write_valences(&b, d->k);
    buffer_print(&b, ",\"verdict\":\"%s\"", verdict_name(d->verdict));
    if (d->verdict == VERDICT_PROVED && !d->plainly_regular && !d->kept_before)
        write_findings(&b, &d->findings, is_one_valence(d->k));
    if (d->kept_before) {
        buffer_print(&b, ",\"kept_before\":true");
    } else if (d->verdict != VERDICT_UNDECIDED) {
        if (d->verdict == VERDICT_REFUTED) {
            json_add_string(&b, "reason", d->reason);
            if (d->findings.eigenvalue)
                json_add_string(&b, "eigenvalue", d->findings.eigenvalue);
            if (d->claim != CLAIM_WINDOW) /* there it is another one at each valence */
                buffer_print(&b, ",\"frequency\":%ld", d->frequency);
        }
        json_add_string(&b, "system", d->plainly_regular ? "exact" : d->system);
        buffer_print(&b, ",\"precision\":%ld", d->plainly_regular ? 0 : d->precision);
    } else {
        char advice[256];
        advise(advice, sizeof advice, d);
        json_add_string(&b, "test", a->test);
        json_add_string(&b, "reason", a->reason);
        json_add_string(&b, "advice", advice);
        json_add_string(&b, "system", a->system);
        buffer_print(&b, ",\"precision\":%ld", a->precision);
    }
    json_add_number(&b, "seconds", d->seconds);
    if (certificate)
        json_add_string(&b, "certificate", certificate);
    buffer_print(&b, "}");
    puts(b.failed ? "{}" : b.bytes);
    buffer_clear(&b);
}

void prove_write_log(buffer *b, const decision *d)
{
    for (int i = 0; i < d->findings.attempt_count; i++) {
        const attempt *a = &d->findings.attempts[i];
        buffer_print(b, "{");
        write_valences(b, d->k);
        json_add_string(b, "test", a->test);
        json_add_string(b, "system", a->system);
        buffer_print(b, ",\"precision\":%ld,\"max_level\":%d,\"level\":%d,\"elements\":%ld", a->precision, a->max_level, a->level, a->elements);
        json_add_string(b, "outcome", outcome_name(a->outcome));
        json_add_number(b, "bound", a->bound);
        if (!isnan(a->error))
            json_add_number(b, "error", a->error);
        json_add_number(b, "seconds", a->seconds);
        json_add_string(b, "reason", a->reason);
        buffer_print(b, "}\n");
    }
    if (d->findings.uniform) {
        buffer_print(b, "{");
        write_valences(b, d->k);
        json_add_string(b, "test", "both methods");
        write_levels(b, &d->findings);
        json_add_string(b, "outcome", verdict_name(d->verdict));
        buffer_print(b, "}\n");
    }
}
