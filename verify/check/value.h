#ifndef CHECK_VALUE_H
#define CHECK_VALUE_H

/* Values of formulas
 * ==================
 *
 * lib/scheme.md, "Value of a formula": an exact rational q, an angle q pi (q not
 * 0), or an enclosure.  The variables m and k may stand for several frequencies or
 * valences at once ("Ranges of k and m"): then exact values are ranges from q to q_last
 * (or these times pi); infinite ends have den = 0, num = -1 or 1.  A formula that has no
 * value is undefined, which is an error only if the value is asked for.
 */

#include "formula.h"
#include "grid.h"
#include "span.h"

struct value {
    enum value_kind { RATIONAL, ANGLE, ENCLOSURE, UNDEFINED } kind;
    bool range;                                    /* RATIONAL, ANGLE: it varies */
    bool whole, divides;                           /* range: of whole ones? a divisor? */
    rational q, q_last;                            /* (q_last: range) */
    interval x;                                    /* ENCLOSURE */
    const struct node *at;                         /* UNDEFINED: where and why, */
    const char *fault;
    bool open;                                     /* and could a finer grid help? */
};

struct value value_from(rational q);
struct value value_enclosure(interval x);

/* A number or pi; k, j or m in a span.  Ranges are divided by only where k varies. */
void value_constant(struct value *out, const struct node *f);
void value_variable(struct value *out, struct span span, bool divides,
                    const struct node *at);
void value_undefine(struct value *out, const struct node *at, const char *fault,
                    bool open);

/* The enclosure that a value is turned into; an unbounded one has none. */
interval value_enclose(struct value v, int g);

/* Gives back the memory since the mark, but for the value. */
void value_keep(struct mark mark, struct value *v);

/* An undefined value ends the program: where it is open with "rejected" at that
 * line of the certificate (NULL: with "cannot check"), else with "cannot check".  An
 * unbounded one is rejected. */
bool value_is_bounded(const struct value *v);
void value_require(struct value v, const struct language *l, const char *certificate,
                   int line);

/* Operations
 * ----------
 *
 * In place; `at` is where a fault would be. */

/* a := a + b, a - b, a * b, a / b */
void value_apply(struct value *a, char operation, const struct value *b,
                 const struct node *at, int g);
void value_negate(struct value *v);

/* base := base ^ exponent, or base ^ -exponent */
void value_power(struct value *base, const struct value *exponent, bool minus,
                 const struct node *at, int g);

/* v := f(v), or f(v, b) for functions of several arguments */
void value_function(struct value *v, const struct value *b, const struct node *f, int g);

/* a := the hull of both */
void value_hull(struct value *a, const struct value *b, const struct node *at, int g);

enum truth { NO, YES, UNKNOWN };

/* a (comparison) b, as in formula.h */
enum truth value_compare(const struct value *a, char join, const struct value *b, int g);

#endif
