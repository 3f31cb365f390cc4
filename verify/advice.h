/* advice.h: what a user may try where a verdict is missing. */
#ifndef VERIFY_ADVICE_H
#define VERIFY_ADVICE_H

#include "escalate.h"

/* The option that is most likely to decide an undecided valence, or where to look: a clause such as "try --max-level 24". */
void advise(char *text, size_t size, const decision *d);

#endif
