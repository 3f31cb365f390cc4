/* tree.c: a growing word. */
#include "tree.h"

#include <stdlib.h>
#include <string.h>

void tree_init(tree_word *z)
{
    memset(z, 0, sizeof *z);
}

void tree_clear(tree_word *z)
{
    free(z->letter);
    tree_init(z);
}

void tree_reset(tree_word *z)
{
    z->length = z->at = 0;
}

bool tree_put(tree_word *z, char letter)
{
    if (z->length + 1 >= z->capacity) {
        size_t capacity = z->capacity ? 2 * z->capacity : 64;
        char *p = realloc(z->letter, capacity);
        if (!p)
            return false;
        z->letter = p;
        z->capacity = capacity;
    }
    z->letter[z->length++] = letter;
    z->letter[z->length] = '\0';
    return true;
}

char tree_get(tree_word *z)
{
    return z->at < z->length ? z->letter[z->at++] : '\0';
}
