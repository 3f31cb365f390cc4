#ifndef CHECK_VALUE_H
#define CHECK_VALUE_H

/* The value of a formula
 * ======================
 *
 * lib/scheme.md, "Value of a formula": an exact rational q, an angle q pi (q not
 * 0), or an enclosure.  The variable m may stand for several frequencies at once
 * (certificate.md, section 5); a formula that has no value is undefined, which
 * is an error only if the value is asked for.
 */

#include "formula.h"
#include "grid.h"

struct value {
    enum { RATIONAL, ANGLE, ENCLOSURE, FREQUENCIES, UNDEFINED } kind;
    rational q;                                    /* RATIONAL, ANGLE */
    interval x;                                    /* ENCLOSURE */
    int64_t first, last;                           /* FREQUENCIES */
    const struct node *at;                         /* UNDEFINED: where and why, */
    const char *fault;
    bool open;                                     /* and could a finer grid help? */
};

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

struct value value_from(rational q);
struct value value_add(struct value a, struct value b, int g);
struct value value_sub(struct value a, struct value b, int g);

/* The enclosure that a value is turned into. */
interval value_enclose(struct value v, int g);

/* Gives back the memory since the mark, but for the value. */
void value_keep(struct mark mark, struct value *v);

/* An undefined value ends the program: where it is open with "rejected" at that
 * line of the certificate (NULL: with "cannot check"), else with "cannot check". */
void value_require(struct value v, const struct language *l, const char *certificate,
                   int line);

#endif
