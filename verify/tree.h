/* tree.h: refinement trees as words over {0,1}: 0 is a leaf, 1 is followed by the trees of all children. */
#ifndef VERIFY_TREE_H
#define VERIFY_TREE_H

#include <stdbool.h>
#include <stddef.h>

/* Limits of certificates: verify/certificate.md, section 1. */
#define TREE_MAX_DEPTH 60
#define TREE_MAX_LETTERS 1000000

typedef struct {
    char *letter; /* `length` of them, then NUL */
    size_t length, capacity;
    size_t at; /* where reading goes on */
} tree_word;

void tree_init(tree_word *z);
void tree_clear(tree_word *z);
void tree_reset(tree_word *z); /* empty again, for writing */
bool tree_put(tree_word *z, char letter); /* '0' or '1'; false: no memory */
char tree_get(tree_word *z);              /* the next letter, 0 at the end */
static inline bool tree_at_end(const tree_word *z) { return z->at == z->length; }

#endif
