/* workers.h: many independent pieces of work on several threads, reported in order. */
#ifndef VERIFY_WORKERS_H
#define VERIFY_WORKERS_H

#include <stdbool.h>

typedef struct {
    long count;
    int threads;
    /* The result of piece i, 0 <= i < count; runs on any thread, several at a time. */
    void *(*work)(long i, void *data);
    /* Takes the results over, in order of i, one at a time; runs on any thread.  false: start nothing more. */
    bool (*finish)(long i, void *result, void *data);
    /* A result that nobody will take over. */
    void (*discard)(void *result);
    void *data;
} workers;

/* Runs all of it.  false: not even one thread could be used (no memory). */
bool workers_run(const workers *w);

#endif
