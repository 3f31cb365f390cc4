#ifndef CHECK_EXACT_FORMULA_H
#define CHECK_EXACT_FORMULA_H

/* Exact values of formulas: section 3 of exact.md. */

#include "evaluate.h"
#include "field.h"

/* False if the formula has no exact value in the field. */
bool exact_value(struct number *out, const struct node *formula,
                 const struct environment *e, const struct field *k);

#endif
