/* deadline.h: when to stop though nothing is decided: a limit of time, or an interrupt of the user. */
#ifndef VERIFY_DEADLINE_H
#define VERIFY_DEADLINE_H

#include "../lib/stop.h"

typedef struct {
    double at; /* on deadline_now's clock; 0: never */
} deadline;

/* Seconds on a clock that only goes forward. */
double deadline_now(void);
/* d = NULL: only interrupts count. */
bool deadline_passed(const deadline *d);

/* The same question for lib/stop.h.  The deadline is kept by the caller. */
stop_sign deadline_sign(const deadline *d);

/* From a signal handler: everything stops soon. */
void deadline_interrupt(void);
bool deadline_interrupted(void);

#endif
