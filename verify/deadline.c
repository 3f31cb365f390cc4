/* deadline.c: the clock, and the one flag that a signal may set. */
#define _POSIX_C_SOURCE 200809L
#include "deadline.h"

#include <stddef.h>
#include <stdatomic.h>
#include <time.h>

/* Set by a signal handler and read by all threads: an atomic int is both (volatile sig_atomic_t is for one thread). */
static atomic_int interrupted;

double deadline_now(void)
{
    struct timespec t;
    if (clock_gettime(CLOCK_MONOTONIC, &t) != 0)
        return 0;
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

bool deadline_passed(const deadline *d)
{
    return interrupted || (d && d->at > 0 && deadline_now() >= d->at);
}

static bool passed(const void *data)
{
    return deadline_passed(data);
}

stop_sign deadline_sign(const deadline *d)
{
    return (stop_sign){passed, d};
}

void deadline_interrupt(void)
{
    interrupted = 1;
}

bool deadline_interrupted(void)
{
    return interrupted != 0;
}
