/* consistency.h: our verdict beside other criteria of C1 (other_criteria.h), at one valence. */
#ifndef VERIFY_CONSISTENCY_H
#define VERIFY_CONSISTENCY_H

#include "buffer.h"
#include "other_criteria.h"
#include "outcome.h"

/* Beyond this valence it would take too long to be said by the way. */
enum { CONSISTENCY_MAX_VALENCE = 100 };

typedef struct {
    verdict verdict;
    char reason[512];  /* of a refutation, or of being undecided */
    long dominant;     /* the block of the simple dominant eigenvalue; -1: not known */
    criterion signs, waves;
} consistency;

/* l and dominant as in other_criteria.h.  STATUS_BAD_INPUT: our verdict is none. */
status consistency_make(consistency *z, const scheme *s, long k, const spectrum_list *l, long dominant, bool no_intervals);

/* Do two statements that both claim to be proved contradict each other?  That is a fault of the program. */
bool consistency_is_broken(const consistency *z);

void consistency_print(const consistency *z);
/* The same as members of a JSON object, with a comma in front. */
void consistency_print_json(const consistency *z);

#endif
