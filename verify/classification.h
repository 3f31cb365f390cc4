/* classification.h: what a run has decided, valence by valence, put together in ranges. */
#ifndef VERIFY_CLASSIFICATION_H
#define VERIFY_CLASSIFICATION_H

#include "buffer.h"
#include "escalate.h"

typedef struct {
    valence_range k;
    verdict verdict;
    claim_kind claim; /* of a refutation */
    long frequency;
} classification_part;

typedef struct {
    classification_part *part; /* in order; neighbours differ in something */
    size_t count, capacity;
    long boxes;                /* how many decisions */
    int uniform_level;         /* of the uniform method, where it was used: the deepest level, */
    double uniform_width;      /* and the largest half-width of a net */
} classification;

void classification_init(classification *z);
void classification_clear(classification *z);
/* Decisions come in the order of their valences.  false: no memory. */
BIGFLOAT_MUST_USE bool classification_add(classification *z, const decision *d);

/* "C1: 4..7; not C1: 3, 8..inf (frequency)" */
void classification_print(buffer *text, const classification *z);
/* "c1":[[4,7]],"not_c1":[{"valences":[3,3],"reason":"frequency"}, ...],"undecided":[]; null is infinity. */
void classification_print_json(buffer *text, const classification *z);

#endif
