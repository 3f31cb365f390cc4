#ifndef CHECK_VALUE_H
#define CHECK_VALUE_H

/* Values of formulas
 * ==================
 *
 * lib/scheme.md, "Value of a formula": an exact rational q, an angle q pi (q not
 * 0), or an enclosure.  The variables m and k may stand for several frequencies or
 * valences at once ("Ranges of k and m"): then exact values are ranges from q to q_last, else
 * the same, (or these times pi); infinite ends have den = 0, num = -1 or 1.  A formula that has no
 * value is undefined, which is an error only if the value is asked for.
 */

#include "formula.h"
#include "grid.h"
#include "span.h"

struct value {
    enum value_kind { RATIONAL, ANGLE, ENCLOSURE, UNDEFINED } kind;
    bool range;                                    /* RATIONAL, ANGLE: it varies */
    bool whole, divides;                           /* range: of whole ones? a divisor? */
    rational q, q_last;
    interval x;                                    /* ENCLOSURE */
    const struct node *at;                         /* UNDEFINED: where and why, */
    const char *fault;
    bool open;                                     /* and could a finer grid help? */
};

struct value value_from(rational q);
struct value value_enclosure(interval x);

/* k, j or m in a span.  Ranges are divided by only where k varies. */
struct value value_variable(struct span span, bool divides, const struct node *at);

/* No value; open: a finer grid might help. */
struct value value_undefined(const struct node *at, const char *fault, bool open);

/* The enclosure that a value is turned into; an unbounded one has none. */
interval value_enclose(struct value v, int g);

/* Gives back the memory since the mark, but for the value. */
void value_keep(struct mark mark, struct value *v);

/* Has it no enclosure for no other reason than that it is unbounded? */
bool value_is_only_unbounded(const struct value *v);

/* An undefined value ends the program: where it is open with "rejected" at that
 * line of the certificate (NULL: with "cannot check"), else with "cannot check".  An
 * unbounded one is rejected. */
void value_require(struct value v, const struct language *l, const char *certificate, int line);

/* Operations
 * ----------
 *
 * `at` is where a fault would be. */

/* a + b, a - b, a * b, a / b */
struct value value_apply(struct value a, char operation, struct value b,
                         const struct node *at, int g);
struct value value_negate(struct value v);

/* base ^ exponent, or base ^ -exponent */
struct value value_power(struct value base, struct value exponent, bool minus,
                         const struct node *at, int g);

/* f(a), or f(a, b) for functions of several arguments */
struct value value_function(struct value a, struct value b, const struct node *f, int g);

/* The hull of both */
struct value value_hull(struct value a, struct value b, const struct node *at, int g);

enum truth { NO, YES, UNKNOWN };

/* a (comparison) b, as in formula.h */
enum truth value_compare(struct value a, char join, struct value b, int g);

/* Formulas evaluated
 * ------------------ */

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
