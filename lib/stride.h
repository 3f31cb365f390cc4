/* stride.h: how wide the next box of a cover is tried.

   Boxes grow faster and faster as long as that succeeds; once it has failed they grow more carefully, for what the gap allows
   changes slowly. */
#ifndef LIB_STRIDE_H
#define LIB_STRIDE_H

#include <math.h>
#include <stdbool.h>

typedef struct {
    double width, growth;
    bool failed;
} stride;

#define STRIDE_CAREFUL 1.25

static inline stride stride_start(double width) { return (stride){width, 2, false}; }

/* The box that was proved, or was not, had this width. */
static inline void stride_after_success(stride *s, double width)
{
    s->width = fmax(width * s->growth, width + 1);
    s->growth = s->failed ? fmin(s->growth * 1.1, 2) : fmin(s->growth * 1.5, 16);
}

static inline void stride_after_failure(stride *s, double width)
{
    s->width = width / fmax(s->growth, 1.5);
    s->growth = STRIDE_CAREFUL;
    s->failed = true;
}

/* A whole width from 1 to most. */
static inline long stride_width(const stride *s, long most)
{
    return s->width < 1 ? 1 : s->width < (double)most ? (long)s->width : most;
}

#endif
