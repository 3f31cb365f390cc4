/* common.h: schemes and decisions for the tests of verify/. */
#ifndef TESTS_VERIFY_COMMON_H
#define TESTS_VERIFY_COMMON_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lib/catalogue.h"
#include "tests/bigfloat/random.h"
#include "tests/harness.h"
#include "verify/certificate.h"
#include "verify/escalate.h"
#include "verify/problem.h"

/* A scheme with a mask and a weight of the centre; room for formulas with many digits. */
#define SCHEME_FORMAT "scheme made-up\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n%s" \
                      "end\nrule centre\ncentre %s\nall (1,0) rest\nend\n"
#define LOOP_MASK "(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\n"
#define LOOP_CENTRE "3/8 + (3/8 + cos(2*pi/k)/4)^2"

/* A scheme that is ready to be decided. */
typedef struct {
    scheme scheme;
    problem problem;
} subject;

static inline void subject_make(subject *z, const char *mask, const char *centre)
{
    char text[2048];
    diagnostic d = {0, 0, ""};
    scheme_init(&z->scheme);
    problem_init(&z->problem);
    snprintf(text, sizeof text, SCHEME_FORMAT, mask, centre);
    if (scheme_read(&z->scheme, text, strlen(text), NULL, &d) != STATUS_OK) {
        CHECK(false, "centre %s: %ld:%ld: %s", centre, d.line, d.column, d.text);
        test_end();
        exit(1);
    }
    MUST(problem_make(&z->problem, &z->scheme));
}

/* parameter: "name=value" or NULL. */
static inline void subject_from_catalogue(subject *z, const char *name, const char *parameter)
{
    const char *parameters[] = {parameter}, *text = "";
    scheme_settings settings = {parameters, parameter != NULL};
    diagnostic d = {0, 0, ""};
    for (const struct catalogue_entry *e = catalogue; e->name; e++)
        if (!strcmp(e->name, name))
            text = e->text;
    scheme_init(&z->scheme);
    problem_init(&z->problem);
    if (scheme_read(&z->scheme, text, strlen(text), &settings, &d) != STATUS_OK) {
        CHECK(false, "%s %s: %ld:%ld: %s", name, parameter ? parameter : "", d.line, d.column, d.text);
        test_end();
        exit(1);
    }
    MUST(problem_make(&z->problem, &z->scheme));
}

static inline void subject_clear(subject *z)
{
    problem_clear(&z->problem);
    scheme_clear(&z->scheme);
}

/* Escalation up to max_precision; max_precision 0: hardware intervals only. */
static inline limits escalation(long max_precision) { return (limits){.max_precision = max_precision}; }
/* Balls of one precision only. */
static inline limits balls(long precision) { return (limits){.precision = precision, .max_precision = precision}; }

static inline void decide(decision *z, const subject *s, long valence, limits l)
{
    decision_init(z);
    decide_valence(z, &s->problem, valence, NULL, &l);
    CHECK(z->outcome != OUTCOME_NO_MEMORY, "no memory at valence %ld", valence);
}

#endif
