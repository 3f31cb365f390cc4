/* choices.h: what a certificate contains beside its claim (verify/certificate.md, section 1).

   Whoever has the scheme, the valence and the choices can redo the whole proof: the same tests that search for
   choices also follow them. */
#ifndef VERIFY_CHOICES_H
#define VERIFY_CHOICES_H

#include "../lib/cover_list.h"
#include "../lib/eigenpair_choice.h"
#include "../lib/graded_choice.h"
#include "../lib/range_choices.h"
#include "exact_choice.h"
#include "tree.h"
#include "window_choice.h"

#include <stdint.h>

/* Limits of version 1. */
#define CHOICES_MIN_VALENCE 3
#define CHOICES_MAX_VALENCE 1000000000
#define CHOICES_MIN_GRID 64
#define CHOICES_MAX_GRID 8192
#define CHOICES_NORMAL_BITS 32
#define CHOICES_MAX_ORDER 1024
#define CHOICES_MAX_POWER 10000
#define CHOICES_MAX_BLOCKS 10000
#define CHOICES_MAX_RISES 1000
#define CHOICES_MAX_TOTAL_POWER 200000
#define CHOICES_MAX_INVERSE_INTEGERS (1L << 21)

/* K <= bound / 1024, by the windows of the power's mask; power 0: no weight is negative (lib/stability.h). */
typedef struct {
    int power;
    int64_t bound;
} stability_choice;

/* What a certificate proves: C1, or why not (verify/certificate.md, section 10; those behind CLAIM_REAL verify/exact.md;
   CLAIM_WINDOW and CLAIM_GRADED, of several valences only, verify/certificate-valences.md, section 6). */
typedef enum { CLAIM_C1, CLAIM_FREQUENCY, CLAIM_NOT_C0, CLAIM_FOLD, CLAIM_WINDING, CLAIM_REAL, CLAIM_TIE, CLAIM_JORDAN, CLAIM_MODULUS_ONE, CLAIM_WINDOW, CLAIM_GRADED, CLAIMS } claim_kind;

/* Does it rest on numbers being equal? */
static inline bool claim_is_exact(claim_kind c) { return c == CLAIM_TIE || c == CLAIM_JORDAN || c == CLAIM_MODULUS_ONE; }
/* How many witnesses it has. */
static inline int claim_witnesses(claim_kind c) { return c == CLAIM_FOLD || c == CLAIM_TIE ? 2 : c == CLAIM_NOT_C0 || c == CLAIM_GRADED || c == CLAIM_REAL || c == CLAIM_MODULUS_ONE ? 1 : 0; }
/* Does it need a curve without a zero, or of some winding number? */
static inline bool claim_has_boundary(claim_kind c) { return c == CLAIM_C1 || c == CLAIM_FREQUENCY || c == CLAIM_WINDING || c == CLAIM_JORDAN; }

/* A descendant of an element of the ring: one child after the other. */
typedef struct {
    int element;
    int depth;
    char path[TREE_MAX_DEPTH + 1]; /* digits */
} witness_choice;

typedef struct {
    claim_kind claim;
    long frequency;       /* of the eigenvalue: 1 for C1, folds and windings */
    bool pair;            /* it is one of a pair that is not real, of block 0 or k/2, in the complex form */
    valence_range k;
    long grid;            /* g: units of 2^-g */
    int contraction[3];   /* N_1 N_2 N_3 */
    bool plainly_regular; /* nothing else is needed */
    stability_choice stability[3]; /* of values and both differences */
    eigenpair_choice eigenpair;
    long second_frequency; /* of CLAIM_REAL: the block of the next eigenvalue, */
    eigenpair_choice second; /* and its eigenpair */
    exact_choice exact;   /* of claims that are exact, in place of the eigenpair */
    integer modulus;      /* ell < |L|, in the complex form */
    cover_list blocks;    /* the frequencies 0, 1 ... k/2 in order, 0 and 1 by themselves, and their powers; of several valences
                             only 0 and that of the eigenvalue */
    bool has_limit;       /* of infinitely many valences: block 0 falls behind as they grow, and is not in `blocks`; */
    rise_box limit;       /*   then its pair and power (lib/limit.h), q having no meaning */
    rise_list rise;       /* of several valences: near m/k = 0, where the largest eigenvalue rises, */
    span_list spans;      /*   and all other blocks (verify/certificate-valences.md, 4) */
    window_choice window; /* of CLAIM_WINDOW, in place of the eigenpair */
    graded_choice graded; /* of CLAIM_GRADED: how its block is scaled */
    long normal[2];       /* of the half-plane that holds one sector's outer curve */
    tree_word regularity;
    tree_word boundary;
    witness_choice witness[2]; /* claim_witnesses of them */
} choices;

const char *claim_name(claim_kind c); /* as certificates call it */

/* What the eigenvalue of the pair is to be multiplied by, for people: "(k/16)^2", or nothing. */
enum { CHOICES_GROWTH_TEXT = 32 };
void choices_print_growth(char text[CHOICES_GROWTH_TEXT], const choices *c);

void choices_init(choices *z); /* of C1 */
void choices_clear(choices *z);

#endif
