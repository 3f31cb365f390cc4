/* common.h: schemes for the tests of lib/, and short ways to say usual things. */
#ifndef TESTS_LIB_COMMON_H
#define TESTS_LIB_COMMON_H

#include <stdio.h>
#include <string.h>

#include "lib/catalogue.h"
#include "lib/scheme.h"
#include "tests/bigfloat/random.h"
#include "tests/harness.h"

/* A scheme file with the mask and the rule given. */
#define SCHEME_TEXT(mask, centre)                                                                \
    "scheme made-up\nmesh triangle\ndilation 2\nvertices interior\nmask symmetric\n" mask        \
    "end\nrule centre\ncentre " centre "\nall (1,0) rest\nend\n"

#define LOOP_CENTRE "3/8 + (3/8 + cos(2*pi/k)/4)^2"
#define LOOP_TEXT SCHEME_TEXT("(0,0) 5/8\n(1,0) 3/8\n(1,1) 1/8\n(2,0) 1/16\n", LOOP_CENTRE)
#define BUTTERFLY_TEXT SCHEME_TEXT("(0,0) 1\n(1,0) 1/2\n(1,1) 1/8\n(1,2) -1/16\n", "1")

/* A scheme of reach 3 that nobody would use: every kind of weight is there, some are negative, and the weights sum
   to 1 in each class: 7/10 + 6/20 and 2 (2/5) + 2 (1/5) - 4/20. */
#define ODD_TEXT SCHEME_TEXT("(0,0) 7/10\n(2,0) 1/20\n(1,0) 2/5\n(1,1) 1/5\n(1,2) -1/20\n", "2/3 + sin(pi/k)/7")
static const double odd_edge[3] = {0.4, 0.2, -0.05}; /* ends, opposite, wings */

static inline void read_scheme(scheme *z, const char *text)
{
    diagnostic d = {0, 0, ""};
    scheme_init(z);
    CHECK(scheme_read(z, text, strlen(text), NULL, &d) == STATUS_OK, "%ld:%ld: %s", d.line, d.column, d.text);
}

static inline const char *catalogue_text(const char *name)
{
    for (const struct catalogue_entry *e = catalogue; e->name; e++)
        if (!strcmp(e->name, name))
            return e->text;
    test_fail(__FILE__, __LINE__, "the catalogue has no %s", name);
    return "";
}

static inline double random_unit(void) /* in [-1, 1] */
{
    return (double)random_range(-(1L << 40), 1L << 40) / (double)(1L << 40);
}

#endif
