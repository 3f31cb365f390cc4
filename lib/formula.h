/* formula.h: the formulas of scheme files, as trees (grammar in lib/scheme.md).

   A formula is a tree of numbers, k, pi, sums, products, powers, cos and sin.  Here it is read, and evaluated
   where its value is exact; formula_value.h evaluates it in enclosures. */
#ifndef LIB_FORMULA_H
#define LIB_FORMULA_H

#include "diagnostic.h"
#include "exact_value.h"

typedef enum { FORMULA_NUMBER, FORMULA_VALENCE, FORMULA_PI, FORMULA_NEGATE, FORMULA_BINARY, FORMULA_POWER, FORMULA_COS_SIN } formula_kind;

typedef struct formula formula;
struct formula {
    formula_kind kind;
    char op;         /* + - * / of FORMULA_BINARY, 'c' or 's' of FORMULA_COS_SIN */
    long exponent;   /* of FORMULA_POWER */
    rational number; /* of FORMULA_NUMBER */
    formula *left;   /* operand, argument, or left operand */
    formula *right;
    long line, column; /* of the operator, number or word, in the file */
};

void formula_free(formula *f); /* NULL is allowed */

/* Reads the formula that fills text[0..length); column[i], i <= length, says where text[i] stood in that line of the
   file.  *f is the caller's to free.  On STATUS_BAD_INPUT *d says where and what was expected. */
status formula_read(formula **f, const char *text, size_t length, long line, const long *column, diagnostic *d);

/* A formula contains k? */
bool formula_depends_on_valence(const formula *f);

/* The exact value of f at valence k (0 where f does not depend on it).  *known tells whether f has one; it may
   be false only with STATUS_OK. */
status formula_exact(exact_value *z, bool *known, const formula *f, long k, diagnostic *d);

/* The same where a rational is required. */
status formula_exact_rational(rational *z, const formula *f, long k, diagnostic *d);

/* The complaint that belongs to s (not EXACT_OK or EXACT_NONE) at the node f. */
status formula_complain(const formula *f, exact_status s, long k, diagnostic *d);

#endif
