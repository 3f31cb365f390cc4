/* workers.c: threads take the next piece; whoever completes the next one in order reports it and those waiting behind. */
#define _POSIX_C_SOURCE 200809L
#include "workers.h"

#include <pthread.h>
#include <stdlib.h>

/* How far a thread may be ahead of the oldest unfinished piece: bounds the memory of results that wait. */
enum { MAX_AHEAD = 256, MAX_THREADS = 256 };

typedef struct {
    const workers *w;
    pthread_mutex_t lock;
    pthread_cond_t moved;
    long next, reported;       /* the next piece to take; all before `reported` have been reported */
    void *waiting[MAX_AHEAD];  /* result of piece i at i % MAX_AHEAD */
    bool ready[MAX_AHEAD];
    bool stopped, reporting;
} crew;

static bool take(crew *c, long *piece)
{
    bool taken;
    pthread_mutex_lock(&c->lock);
    while (!c->stopped && c->next < c->w->count && c->next >= c->reported + MAX_AHEAD)
        pthread_cond_wait(&c->moved, &c->lock);
    taken = !c->stopped && c->next < c->w->count;
    if (taken)
        *piece = c->next++;
    pthread_mutex_unlock(&c->lock);
    return taken;
}

/* Whoever finds nobody reporting does it for all that is ready. */
static void deliver(crew *c, long piece, void *result)
{
    pthread_mutex_lock(&c->lock);
    c->waiting[piece % MAX_AHEAD] = result;
    c->ready[piece % MAX_AHEAD] = true;
    while (!c->reporting && c->reported < c->w->count && c->ready[c->reported % MAX_AHEAD]) {
        long i = c->reported;
        bool go_on;
        void *r = c->waiting[i % MAX_AHEAD];
        c->ready[i % MAX_AHEAD] = false;
        if (c->stopped) {
            c->w->discard(r);
        } else {
            c->reporting = true;
            pthread_mutex_unlock(&c->lock);
            go_on = c->w->finish(i, r, c->w->data);
            pthread_mutex_lock(&c->lock);
            c->reporting = false;
            c->stopped = c->stopped || !go_on;
        }
        c->reported++;
        pthread_cond_broadcast(&c->moved);
    }
    pthread_mutex_unlock(&c->lock);
}

static void *run(void *data)
{
    crew *c = data;
    long piece;
    while (take(c, &piece))
        deliver(c, piece, c->w->work(piece, c->w->data));
    return NULL;
}

bool workers_run(const workers *w)
{
    crew *c = calloc(1, sizeof *c);
    pthread_t thread[MAX_THREADS];
    int threads = 0;
    if (!c)
        return false;
    c->w = w;
    pthread_mutex_init(&c->lock, NULL);
    pthread_cond_init(&c->moved, NULL);
    while (threads < w->threads - 1 && threads < MAX_THREADS && threads < w->count - 1 && pthread_create(&thread[threads], NULL, run, c) == 0)
        threads++;
    run(c); /* this thread works, too: alone if there are no others */
    for (int i = 0; i < threads; i++)
        pthread_join(thread[i], NULL);
    for (int i = 0; i < MAX_AHEAD; i++)
        if (c->ready[i])
            w->discard(c->waiting[i]);
    pthread_cond_destroy(&c->moved);
    pthread_mutex_destroy(&c->lock);
    free(c);
    return true;
}
