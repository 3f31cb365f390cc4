/* progress.c: one line on stderr that is written over. */
#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include "deadline.h"

#include <stdio.h>
#include <unistd.h>

/* Seconds between two updates. */
#define INTERVAL 0.2

void progress_begin(progress *z, long total)
{
    *z = (progress){isatty(STDERR_FILENO) && total > 1, false, total, deadline_now(), 0};
    z->last = z->start;
}

void progress_show(progress *z, long done)
{
    double now;
    if (!z->shown || done >= z->total)
        return;
    now = deadline_now();
    if (now - z->last < INTERVAL)
        return;
    z->last = now;
    fprintf(stderr, "\r%ld of %ld valences, %.3g per second, %.0f s left\033[K", done, z->total, (double)done / (now - z->start),
            (double)(z->total - done) * (now - z->start) / (double)done);
    fflush(stderr);
    z->visible = true;
}

void progress_clear(progress *z)
{
    if (z->visible)
        fputs("\r\033[K", stderr);
    z->visible = false;
}
