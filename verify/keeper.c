/* keeper.c: one thread brings results, another keeps them. */
#define _POSIX_C_SOURCE 200809L
#include "keeper.h"

#include <string.h>

static void discard_all(keeper *z, void *const *results, int count)
{
    for (int i = 0; i < count; i++)
        z->discard(results[i]);
}

/* Takes what has come; 0: nothing will come any more. */
static int take(keeper *z, void **group)
{
    int count;
    pthread_mutex_lock(&z->lock);
    while (z->count == 0 && !z->ending)
        pthread_cond_wait(&z->moved, &z->lock);
    count = z->count;
    memcpy(group, z->waiting, (size_t)count * sizeof *group);
    z->count = 0;
    pthread_cond_broadcast(&z->moved);
    pthread_mutex_unlock(&z->lock);
    return count;
}

static void *run(void *data)
{
    keeper *z = data;
    void *group[KEEPER_GROUP_MAX];
    bool wanted = true;
    for (int count; (count = take(z, group)) > 0;) {
        if (!wanted)
            discard_all(z, group, count);
        else if (!z->keep(group, count, z->data)) {
            wanted = false;
            pthread_mutex_lock(&z->lock);
            z->stopped = true;
            pthread_mutex_unlock(&z->lock);
        }
    }
    return NULL;
}

void keeper_start(keeper *z)
{
    pthread_mutex_init(&z->lock, NULL);
    pthread_cond_init(&z->moved, NULL);
    z->count = 0;
    z->ending = z->stopped = false;
    z->has_thread = pthread_create(&z->thread, NULL, run, z) == 0;
}

bool keeper_put(keeper *z, void *result)
{
    bool stopped;
    if (!z->has_thread) {
        if (z->stopped)
            z->discard(result);
        else
            z->stopped = !z->keep(&result, 1, z->data);
        return !z->stopped;
    }
    pthread_mutex_lock(&z->lock);
    while (z->count == KEEPER_GROUP_MAX)
        pthread_cond_wait(&z->moved, &z->lock);
    z->waiting[z->count++] = result;
    stopped = z->stopped;
    pthread_cond_broadcast(&z->moved);
    pthread_mutex_unlock(&z->lock);
    return !stopped;
}

void keeper_finish(keeper *z)
{
    if (z->has_thread) {
        pthread_mutex_lock(&z->lock);
        z->ending = true;
        pthread_cond_broadcast(&z->moved);
        pthread_mutex_unlock(&z->lock);
        pthread_join(z->thread, NULL);
    }
    pthread_cond_destroy(&z->moved);
    pthread_mutex_destroy(&z->lock);
}
