/* keeper.h: results that are made durable in groups, by a thread of its own.

   While one group is being written, with a wait for the disk or two, the next one collects: the slower the disk, the larger
   the groups.  Nobody waits longer than for the group before. */
#ifndef VERIFY_KEEPER_H
#define VERIFY_KEEPER_H

#include <pthread.h>
#include <stdbool.h>

enum { KEEPER_GROUP_MAX = 32 };

typedef struct {
    /* Takes over 1 <= count <= KEEPER_GROUP_MAX results, in the order in which they came.  false: it wants no more. */
    bool (*keep)(void *const *results, int count, void *data);
    /* A result that nobody will take over. */
    void (*discard)(void *result);
    void *data;
    /* The rest is the keeper's. */
    pthread_mutex_t lock;
    pthread_cond_t moved;
    pthread_t thread;
    bool has_thread, ending, stopped;
    void *waiting[KEEPER_GROUP_MAX];
    int count;
} keeper;

/* keep, discard and data are set.  Without a thread, if none can be had, each result is kept at once. */
void keeper_start(keeper *z);
/* Hands a result over; may wait.  false: no more are wanted. */
bool keeper_put(keeper *z, void *result);
/* Returns when all is kept. */
void keeper_finish(keeper *z);

#endif
