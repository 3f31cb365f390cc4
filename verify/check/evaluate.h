#ifndef CHECK_EVALUATE_H
#define CHECK_EVALUATE_H

/* The value of a formula: lib/scheme.md. */

#include "value.h"

/* What formulas are evaluated with. */
struct environment {
    const struct language *language;
    int64_t k, first, last, j;                     /* m = first..last; < 0: none */
    int g;
    struct value *definition;                      /* their values, in order */
};

/* An environment in which the definitions have been evaluated. */
struct environment environment_make(const struct language *l, int64_t k, int64_t first,
                                    int64_t last, int64_t j, int g);

struct value evaluate(const struct node *formula, const struct environment *e);

/* Whether the condition holds, exactly; if that is not known: cannot check. */
bool condition_holds(const struct node *condition, const struct environment *e);

#endif
