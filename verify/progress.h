/* progress.h: how far a long run is, on a terminal only. */
#ifndef VERIFY_PROGRESS_H
#define VERIFY_PROGRESS_H

#include <stdbool.h>

typedef struct {
    bool shown;    /* is stderr a terminal? */
    bool visible;  /* there is a line to be cleared */
    long total;
    double start, last;
} progress;

void progress_begin(progress *z, long total);
/* `done` of them are finished: says so, with the rate and the time left, now and then. */
void progress_show(progress *z, long done);
/* Clears the line, before anything else is printed. */
void progress_clear(progress *z);

#endif
