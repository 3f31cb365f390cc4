#ifndef CHECK_EVALUATE_H
#define CHECK_EVALUATE_H

/* The value of a formula: lib/scheme.md. */

#include "value.h"

/* What formulas are evaluated with. */
struct environment {
    const struct language *language;
    struct span k, m, j;
    int g;
    struct value *definition;                      /* their values, in order */
};

/* An environment in which the definitions have been evaluated. */
struct environment environment_make(const struct language *l, struct span k, struct span m,
                                    struct span j, int g);

/* The same without k, m and j. */
struct environment environment_plain(const struct language *l, int g);

struct value evaluate(const struct node *formula, const struct environment *e);

/* Whether the condition holds, exactly (at every valence). */
enum truth condition_truth(const struct node *condition, const struct environment *e);

/* The same; if it is not known: cannot check. */
bool condition_holds(const struct node *condition, const struct environment *e);

#endif
