/* window_choice.h: the choices that prove that for m/k in a window some block dominates (verify/certificate-valences.md,
   section 6).  Exact, the same for all number systems; q = m/k in the units of lib/arc.h. */
#ifndef VERIFY_WINDOW_CHOICE_H
#define VERIFY_WINDOW_CHOICE_H

#include "tree.h"

#include "../lib/eigenpair_choice.h"

#include <stddef.h>
#include <stdint.h>

/* From the q of the wave before, or the window's start, to this one: an eigenpair, the power that bounds the rest of the blocks, and
   the trees that prove that the eigenfunctions have no zero. */
typedef struct {
    int64_t q;
    eigenpair_choice eigenpair;
    int power;
    tree_word boundary;
} window_wave;

typedef struct {
    int64_t start;
    integer bound; /* R 2^grid: all else is smaller, and somewhere in the window eigenvalues are not */
    window_wave *wave;
    size_t count, capacity;
} window_choice;

void window_choice_init(window_choice *z);
void window_choice_clear(window_choice *z);
/* A new last wave with nothing in it.  NULL: no memory. */
window_wave *window_choice_add(window_choice *z);
/* Takes the last one away. */
void window_choice_drop(window_choice *z);

static inline int64_t window_choice_end(const window_choice *z) { return z->count ? z->wave[z->count - 1].q : z->start; }

#endif
