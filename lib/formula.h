/* formula.h: the formulas of scheme files, as trees (grammar in lib/scheme.md).

   Here they are read, and evaluated where their value is exact; formula_value.h evaluates them in enclosures. */
#ifndef LIB_FORMULA_H
#define LIB_FORMULA_H

#include "diagnostic.h"
#include "exact_value.h"

#include <stddef.h>

typedef enum {
    FORMULA_NUMBER,
    FORMULA_INTERVAL,  /* [number, high]: only as the value of a parameter */
    FORMULA_PI,
    FORMULA_VARIABLE,  /* op: k, m or j */
    FORMULA_REFERENCE, /* to a definition */
    FORMULA_NEGATE,
    FORMULA_BINARY,    /* op: + - * / */
    FORMULA_POWER,     /* child[0] ^ child[1], which is a whole number */
    FORMULA_COS_SIN,   /* op: c or s */
    FORMULA_SQRT,
    FORMULA_ABS,
    FORMULA_MIN,
    FORMULA_MAX,
    FORMULA_MODULO,
    FORMULA_CASES,     /* condition, value, condition, value ...; an `else` is a condition that is NULL */
    FORMULA_COMPARE,   /* op: = ! < l (<=) > g (>=) */
    FORMULA_AND,
    FORMULA_OR
} formula_kind;

typedef struct formula formula;
struct formula {
    formula_kind kind;
    char op;
    rational number, high;
    formula **child;
    int children;
    const formula *definition; /* of FORMULA_REFERENCE: belongs to the definitions */
    unsigned depends;          /* on which variables, definitions included: FORMULA_ON_... */
    int size;                  /* number of nodes, definitions included each time they are used */
    long line, column;         /* of the operator, number or word, in the file */
};

/* A formula with more nodes, definitions written out, is refused. */
#define FORMULA_MAX_SIZE 10000

enum { FORMULA_ON_VALENCE = 1, FORMULA_ON_FREQUENCY = 2, FORMULA_ON_SECTOR = 4, FORMULA_ON_INTERVAL = 8 };

/* What names mean besides k, m, j and pi: parameters and abbreviations. */
enum { DEFINITION_MAX_NAME = 32, DEFINITIONS_MAX = 64 };
typedef struct {
    char name[DEFINITION_MAX_NAME + 1];
    formula *value;
    bool is_parameter;
} definition;

typedef struct {
    definition entry[DEFINITIONS_MAX];
    int count;
} definitions;

void formula_free(formula *f); /* NULL is allowed */

/* Reads the formula (or, by formula_read_condition, the condition) that fills text[0..length); column[i], i <= length,
   says where text[i] stood in that line of the file.  It may depend on the variables in `allowed`.  *f is the
   caller's to free, before `names`. */
status formula_read(formula **f, const char *text, size_t length, long line, const long *column, const definitions *names, unsigned allowed, diagnostic *d);
status formula_read_condition(formula **f, const char *text, size_t length, long line, const long *column, const definitions *names, unsigned allowed, diagnostic *d);

/* A formula that means any number between two rationals, low <= high, which it takes over.  false: no memory. */
BIGFLOAT_MUST_USE bool formula_make_interval(formula **f, rational *low, rational *high, long line, long column);

/* Is this a word that the language uses itself? */
bool formula_is_reserved(const char *word, size_t length);

/* Do both mean the same, evidently: are they the same trees, names written out?  (NULL is the same as NULL.) */
bool formula_is_same(const formula *f, const formula *g);
/* Does f evidently have the same value at j and k - j, for all k and 0 < j < k? */
bool formula_is_even_in_sector(const formula *f);

/* Where the variables stand.  Those that a formula does not depend on may have any value. */
typedef struct {
    long k, m, j;
} formula_point;

/* The exact value of f.  *known tells whether f has one; it may be false only with STATUS_OK. */
status formula_exact(exact_value *z, bool *known, const formula *f, const formula_point *at, diagnostic *d);

/* The same where a rational is required. */
status formula_exact_rational(rational *z, const formula *f, const formula_point *at, diagnostic *d);

/* The same of a condition: does it hold?  *known false: only enclosures may tell. */
status formula_exact_condition(bool *holds, bool *known, const formula *f, const formula_point *at, diagnostic *d);

/* The same where the answer must be exact (`when`). */
status formula_condition(bool *holds, const formula *f, const formula_point *at, diagnostic *d);

/* sign = sign of x - y for the comparison op: does it hold? */
bool formula_comparison_holds(char op, int sign);

/* The complaint that belongs to s (not EXACT_OK or EXACT_NONE) at the node f. */
status formula_complain(const formula *f, exact_status s, const formula_point *at, diagnostic *d);

#endif
