/* findings.c: life of the findings. */
#include "analysis.h"

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

outcome findings_explain(findings *f, outcome o, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(f->reason, sizeof f->reason, format, arguments);
    va_end(arguments);
    return o;
}
