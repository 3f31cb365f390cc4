#ifndef CHECK_SPAN_H
#define CHECK_SPAN_H

/* Valences and frequencies from a first to a last one. */

#include <stdbool.h>
#include <stdint.h>

/* The whole numbers first..last; last = ENDLESS: all from first on; NOTHING: none. */
struct span {
    int64_t first, last;
};

#define ENDLESS INT64_MAX
#define NOTHING ((struct span) { -1, -1 })

static inline struct span span_of(int64_t n)
{
    return (struct span) { n, n };
}

static inline bool span_is_several(struct span s)
{
    return s.first < s.last;
}

/* `7`, `8..20` or `21..inf` */
const char *span_text(struct span s);

#endif
