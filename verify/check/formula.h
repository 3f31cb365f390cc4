#ifndef CHECK_FORMULA_H
#define CHECK_FORMULA_H

/* Formulas and definitions
 * ========================
 *
 * lib/scheme.md, "Grammar": formulas and conditions are read into trees, once,
 * and evaluated as often as needed (value.h).
 */

#include "rational.h"
#include "text.h"

/* What a formula depends on; bits. */
enum { MEANS_K = 1, MEANS_M = 2, MEANS_J = 4 };

struct node {
    enum node_kind {
        NODE_NUMBER, NODE_PI, NODE_K, NODE_M, NODE_J,
        NODE_NAME,                                 /* a definition */
        NODE_SUM, NODE_PRODUCT,                    /* operands by `join` */
        NODE_POWER,                                /* base, exponent (join - : ^ -) */
        NODE_COS, NODE_SIN, NODE_SQRT, NODE_ABS, NODE_MIN, NODE_MAX, NODE_MOD,
        NODE_CASES,                                /* condition, formula ... else */
        NODE_AND, NODE_OR,                         /* of comparisons */
        NODE_COMPARISON                            /* two operands, by `join` of
                                                      the second: = ! < l > g */
    } kind;
    char join;                                     /* + - * / : to what is before */
    struct node *first, *next;                     /* operand; next of the same */
    rational number;                               /* NODE_NUMBER */
    int name;                                      /* NODE_NAME */
    int meaning;                                   /* what it depends on */
    int operations;                                /* definitions written out */
    int line, column;
};

enum { MAX_DEFINITIONS = 64, MAX_WORD = 32 };

/* A `let` has a formula; a parameter has its exact ends, or one value for both. */
struct definition {
    char name[MAX_WORD + 1];
    const struct node *formula;                    /* NULL: a parameter */
    bool interval;
    rational low, high;
};

/* What formulas may name, and whether one of them goes beyond verify/scheme-0.md. */
struct language {
    const char *file;
    int count;
    struct definition definition[MAX_DEFINITIONS];
    bool beyond_0;
};

/* Reads a formula that may depend on what `allowed` says (MEANS_...). */
const struct node *formula_read(struct cursor *c, struct language *l, int allowed);

/* Reads conditions joined by `and` or `or`. */
const struct node *condition_read(struct cursor *c, struct language *l, int allowed);

/* Is it a word of the language? */
bool word_is_reserved(const char *word);

#endif
