/* findings.c: life of the findings. */
#include "findings.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void findings_init(findings *z)
{
    memset(z, 0, sizeof *z);
    z->eigenvalue_upper = z->runner_up = INFINITY;
    z->eigenvalue_lower = z->jacobian = -INFINITY;
}

void findings_clear(findings *z)
{
    free(z->eigenvalue);
    findings_init(z);
}

attempt *findings_begin(findings *z, const char *test, const char *system, long precision)
{
    attempt *a = &z->attempts[z->attempt_count < MAX_ATTEMPTS ? z->attempt_count++ : MAX_ATTEMPTS - 1];
    memset(a, 0, sizeof *a);
    a->test = test;
    a->system = system;
    a->precision = precision;
    a->bound = NAN;
    a->error = NAN;
    a->outcome = OUTCOME_TRUE;
    return a;
}

attempt *findings_last(findings *z)
{
    return &z->attempts[z->attempt_count ? z->attempt_count - 1 : 0];
}

outcome findings_explain(findings *z, outcome o, const char *format, ...)
{
    va_list arguments;
    attempt *a = findings_last(z);
    va_start(arguments, format);
    vsnprintf(a->reason, sizeof a->reason, format, arguments);
    va_end(arguments);
    return o;
}
