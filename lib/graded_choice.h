/* graded_choice.h: by which powers of k block 0 is scaled where its eigenvalue grows without bound with k
   (verify/certificate-valences.md, section 6, "Growing without bound").  Exact, the same for all number systems. */
#ifndef LIB_GRADED_CHOICE_H
#define LIB_GRADED_CHOICE_H

#include "../bigfloat/integer.h"

#include <limits.h>
#include <stdbool.h>

/* The order of what is 0. */
enum { GRADED_ABSENT = INT_MAX };
enum { GRADED_MAX_DEGREE = 64, GRADED_MAX_UNIT = 1000000000 };

typedef struct {
    long unit;  /* valences are counted in these; */
    int degree; /* the eigenvalue is (k/unit)^degree times that of the scaled block */
    int n;      /* unknowns, the centre's first; */
    int *grade; /*   each is (unit/k)^grade times that of the scaled eigenvector */
} graded_choice;

void graded_choice_init(graded_choice *z);
void graded_choice_clear(graded_choice *z);
BIGFLOAT_MUST_USE bool graded_choice_make(graded_choice *z, int n); /* unit 1, all else 0; false: no memory */

/* The least degree up to GRADED_MAX_DEGREE, and grades, the least of them 0 and each as large as can be, with degree + grade[j] + order[i n + j]
   - grade[i] >= 0 wherever the order is not GRADED_ABSENT; if there are none, degree GRADED_MAX_DEGREE + 1.  unit 1.  false: no memory. */
BIGFLOAT_MUST_USE bool graded_choice_from_orders(graded_choice *z, const int *order, int n);

/* Are these from 1 to GRADED_MAX_UNIT, and from 0 to GRADED_MAX_DEGREE? */
bool graded_choice_is_within_limits(const graded_choice *z);

#endif
