#ifndef CHECK_EXACT_FORMULA_H
#define CHECK_EXACT_FORMULA_H

/* Exact values of formulas
 * ========================
 *
 * Section 3 of exact.md has numbers of a field for values, section 4 of certificate-valences.md
 * Laurent polynomials in k.  Sums, products, powers, names and `cases` are the same in both.
 */

#include "value.h"
#include "field.h"

/* What the values are. */
struct ring {
    size_t size;                                   /* of a value */
    int64_t least, most;                           /* exponents; x^-n is 1/x^n */
    const void *field;                             /* for the functions below */

    /* The value of a formula that is not made from others; false if it has none. */
    bool (*simple)(void *out, const struct node *f, const struct environment *e, const void *field);

    void (*set)(void *out, rational q);

    /* a := a + b, a - b, a * b, a / b; false if there is no such value.  Division may
     * change b. */
    bool (*apply)(void *a, char operation, void *b, const void *field);
};

/* False if the formula has no value in the ring. */
bool ring_value(void *out, const struct node *formula, const struct environment *e,
                const struct ring *ring);

/* The value in a field; false if it has none. */
bool exact_value(struct number *out, const struct node *formula,
                 const struct environment *e, const struct field *k);

#endif
