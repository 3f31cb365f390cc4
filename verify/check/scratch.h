#ifndef CHECK_SCRATCH_H
#define CHECK_SCRATCH_H

/* Memory
 * ======
 *
 * All memory is one stack.  Who has used a part of it for intermediate results
 * gives it back with scratch_release(), down to a mark taken before; nothing is
 * freed otherwise.  Released memory is overwritten, so that a number which was
 * used after its time would be a wild one, and the same in every run.
 */

#include <stddef.h>

struct mark {
    int chunk;
    size_t used;
};

/* Zeroed memory for count objects of the given size; never NULL. */
void *allocate(size_t count, size_t size);

/* The same, not zeroed. */
void *scratch_new(size_t bytes);

struct mark scratch_mark(void);
void scratch_release(struct mark mark);

#endif
