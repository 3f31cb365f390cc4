/* spectrum_list.c: life of spectrum lists. */
#include "spectrum_list.h"

#include <stdlib.h>
#include <string.h>

void spectrum_list_init(spectrum_list *z)
{
    memset(z, 0, sizeof *z);
}

void spectrum_list_clear(spectrum_list *z)
{
    for (size_t i = 0; i < z->count; i++) {
        free(z->entry[i].re);
        free(z->entry[i].im);
    }
    free(z->entry);
    spectrum_list_init(z);
}

spectrum_entry *spectrum_list_add(spectrum_list *z)
{
    if (z->count == z->capacity) {
        size_t capacity = z->capacity ? 2 * z->capacity : 64;
        spectrum_entry *p = realloc(z->entry, capacity * sizeof *p);
        if (!p)
            return NULL;
        z->entry = p;
        z->capacity = capacity;
    }
    memset(&z->entry[z->count], 0, sizeof *z->entry);
    return &z->entry[z->count++];
}
