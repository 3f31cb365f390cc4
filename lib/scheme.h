/* scheme.h: a subdivision scheme as its file says it, exact and ready to use (lib/scheme.md).

   A `scheme` denotes stationary subdivision rules on all meshes of its kind: one subdivision is one *step* with a
   mask and special rules, or several (refine, smooth ..., average).  What always holds after scheme_read: every
   step's mask sums to 1 on each class of points; the composed regular mask is invariant under the rotations of
   the regular complex. */
#ifndef LIB_SCHEME_H
#define LIB_SCHEME_H

#include "exact_range.h"
#include "laurent.h"
#include "mesh.h"
#include "text.h"

#define SCHEME_NAME_MAX 64
/* The largest distance that a point of a mask may have from 0, along each axis. */
#define SCHEME_MAX_REACH 8
#define SCHEME_MAX_STEPS 34
#define SCHEME_MAX_RULES 16
#define SCHEME_MAX_SOURCES 32
/* The operations of all formulas together, definitions written out, repetitions counted: exact arithmetic does
   that many in about a second, on the longest rationals. */
#define SCHEME_MAX_OPERATIONS 20000

typedef enum {
    SOURCE_CENTRE,   /* the extraordinary vertex */
    SOURCE_ALL,      /* the points of that label in all sectors, equal shares of the weight */
    SOURCE_POINT,    /* the point of that label in the sector `offset` further on */
    SOURCE_SECTORS,  /* the points of that label in the sectors j = 0..k-1 further on, weights depending on j */
    SOURCE_SPECTRUM  /* the same by their discrete Fourier transform: sum of weight_j exp(2 pi i m j / k) */
} source_kind;

typedef struct {
    source_kind kind;
    lattice point;
    int offset;
    formula *weight;    /* NULL: the rest to 1 */
    formula *imaginary; /* of SOURCE_SPECTRUM: NULL = real */
} source;

/* What the new value at one point is, in place of the mask. */
typedef struct {
    bool at_centre;
    lattice point;      /* if not at_centre: a label of the sector; the same rule holds in every sector */
    formula *condition; /* NULL: always; else when it holds (depends on k) */
    source sources[SCHEME_MAX_SOURCES];
    int count;
    bool spectrum_takes_rest; /* no weight is the rest: the spectrum's value at m = 0 is, whatever its formula says */
    long line;
} rule;

/* new(x) = sum of mask(x - dilation y) old(y) on labels, unless a rule says otherwise. */
typedef struct {
    mesh_kind from, to;
    int dilation;
    laurent mask;
    int reach;     /* new points on ring j use old rings up to floor((j + reach) / dilation) */
    rule *rules;   /* the first whose condition holds counts */
    int rule_count;
} scheme_step;

typedef struct {
    char name[SCHEME_NAME_MAX + 1];
    source_text source;
    char *text;            /* canonical, with the values that settings gave to parameters: what certificates contain */
    size_t text_length;
    definitions definitions;
    mesh_kind mesh;
    scheme_step steps[SCHEME_MAX_STEPS];
    int step_count;
    laurent mask;          /* of all steps together */
    bool mirror_symmetric; /* mask and rules are evidently invariant under reflection: the real form applies */
} scheme;

/* A parameter's value from the command line: "NAME=VALUE". */
typedef struct {
    const char *const *settings;
    int count;
} scheme_settings;

void scheme_init(scheme *z);
void scheme_clear(scheme *z);

/* Reads the `length` bytes of a scheme file; settings (NULL = none) replace values of its parameters. */
status scheme_read(scheme *z, const char *bytes, size_t length, const scheme_settings *settings, diagnostic *d);

/* Does the rule's condition hold at all valences of the range, or at none (TRUTH_FALSE), by exact values?  TRUTH_UNKNOWN, with
   a complaint in *d: that is not known.  At one valence it is, or the answer STATUS_BAD_INPUT. */
status scheme_rule_holds(truth *holds, const rule *r, valence_range k, diagnostic *d);

/* The rule that holds for a new point at valence k, or at all valences of a range; NULL = the mask.  STATUS_BAD_INPUT: whether
   it holds is not decided (by exact values), or not the same at all of them. */
status scheme_find_rule_range(const rule **z, const scheme_step *s, bool at_centre, lattice p, valence_range k, diagnostic *d);
static inline status scheme_find_rule(const rule **z, const scheme_step *s, bool at_centre, lattice p, long k, diagnostic *d)
{
    return scheme_find_rule_range(z, s, at_centre, p, one_valence(k), d);
}

/* How many old rings new values on rings up to `ring` (and at the centre) need: in one step, and over all steps. */
int scheme_step_rings_needed(const scheme_step *s, int ring);
int scheme_rings_needed(const scheme *s, int ring);
/* From values on the rings up to `known` (and at the centre) new ones follow up to that ring, or `wanted` if that is less.  More than are known, if
   these are scheme_closed_rings at least. */
int scheme_rings_reached(const scheme *s, int known, int wanted);
/* The least number of rings that are closed under subdivision such that farther ones only add eigenvalues 0. */
int scheme_closed_rings(const scheme *s);

#endif
