/* choices.c: life of the choices. */
#include "choices.h"

#include <stdlib.h>
#include <string.h>

void choices_init(choices *z)
{
    memset(z, 0, sizeof *z);
    eigenpair_choice_init(&z->eigenpair);
    integer_init(&z->modulus);
    tree_init(&z->regularity);
    tree_init(&z->boundary);
}

void choices_clear(choices *z)
{
    eigenpair_choice_clear(&z->eigenpair);
    integer_clear(&z->modulus);
    free(z->blocks);
    tree_clear(&z->regularity);
    tree_clear(&z->boundary);
    choices_init(z);
}

bool choices_add_block(choices *z, block_choice b)
{
    if (z->block_count == z->block_capacity) {
        int capacity = z->block_capacity ? 2 * z->block_capacity : 16;
        block_choice *p = realloc(z->blocks, (size_t)capacity * sizeof *p);
        if (!p)
            return false;
        z->blocks = p;
        z->block_capacity = capacity;
    }
    z->blocks[z->block_count++] = b;
    return true;
}
