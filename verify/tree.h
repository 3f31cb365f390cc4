/* tree.h: refinement trees as words: a leaf is one letter, and TREE_SPLIT is followed by the trees of all children. */
#ifndef VERIFY_TREE_H
#define VERIFY_TREE_H

#include <stdbool.h>
#include <stddef.h>

/* Limits of certificates: verify/certificate.md, section 1. */
#define TREE_MAX_DEPTH 60
#define TREE_MAX_LETTERS 1000000

/* The letters: what decides about a leaf. */
#define TREE_BOXES '0'
#define TREE_SPLIT '1'
#define TREE_COEFFICIENTS '2'

typedef struct {
    char *letter; /* `length` of them, then NUL */
    size_t length, capacity;
    size_t at; /* where reading goes on */
} tree_word;

void tree_init(tree_word *z);
void tree_clear(tree_word *z);
void tree_reset(tree_word *z); /* empty again, for writing */
bool tree_put(tree_word *z, char letter); /* false: no memory */
char tree_get(tree_word *z);              /* the next letter, 0 at the end */
static inline bool tree_is_letter(char c) { return c == TREE_BOXES || c == TREE_SPLIT || c == TREE_COEFFICIENTS; }
static inline bool tree_at_end(const tree_word *z) { return z->at == z->length; }

#endif
