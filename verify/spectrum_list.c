/* spectrum_list.c: life of spectrum lists. */
#include "spectrum_list.h"

#include "../lib/growing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void spectrum_list_init(spectrum_list *z)
{
    memset(z, 0, sizeof *z);
    z->top = -1;
}

void spectrum_list_clear(spectrum_list *z)
{
    for (size_t i = 0; i < z->count; i++) {
        free(z->entry[i].re);
        free(z->entry[i].im);
    }
    free(z->entry);
    free(z->range);
    spectrum_list_init(z);
}

spectrum_entry *spectrum_list_add(spectrum_list *z)
{
    spectrum_entry *p = growing_room(z->entry, z->count, &z->capacity, sizeof *p);
    if (!p)
        return NULL;
    z->entry = p;
    memset(&z->entry[z->count], 0, sizeof *z->entry);
    return &z->entry[z->count++];
}

bool spectrum_list_add_range(spectrum_list *z, frequencies m, double upper)
{
    spectrum_range *before = z->ranges ? &z->range[z->ranges - 1] : NULL, *p;
    if (before && before->m.last + 1 == m.first && (before->upper == upper || (isinf(before->upper) && isinf(upper)))) {
        before->m.last = m.last;
        return true;
    }
    p = growing_room(z->range, z->ranges, &z->range_capacity, sizeof *p);
    if (!p)
        return false;
    z->range = p;
    z->range[z->ranges++] = (spectrum_range){m, upper};
    return true;
}

static bool may_be_one(const spectrum_entry *e)
{
    return e->m == 0 && (!e->re || (e->lower[0] <= 1 && 1 <= e->upper[0] && e->lower[1] <= 0 && 0 <= e->upper[1]));
}

/* 1 is an eigenvalue of block 0, so if only one entry may contain it, that one does.  (Discs are disjoint, but the bounds
   of entries, which were rounded once more, may not be.) */
long spectrum_find_one(const spectrum_list *z)
{
    long found = -1;
    for (size_t i = 0; i < z->count; i++) {
        if (!may_be_one(&z->entry[i]))
            continue;
        if (found >= 0 || !z->entry[i].one)
            return -1;
        found = (long)i;
    }
    return found;
}

/* May the conjugate of a number near x be near y? */
static bool may_be_conjugates(const spectrum_entry *x, const spectrum_entry *y)
{
    return x->m == y->m && x->lower[0] <= y->upper[0] && y->lower[0] <= x->upper[0] && x->lower[1] <= -y->lower[1] && -y->upper[1] <= x->upper[1];
}

/* The conjugate of x, which is not real, is an eigenvalue and has an entry: y's if it can be in no other. */
bool spectrum_is_conjugate_pair(const spectrum_list *z, size_t i, size_t j)
{
    const spectrum_entry *x = &z->entry[i], *y = &z->entry[j];
    if (!x->real_block || !x->re || x->real || x->count != 1 || y->count != 1 || i == j || !y->re || !may_be_conjugates(x, y))
        return false;
    for (size_t l = 0; l < z->count; l++)
        if (l != j && z->entry[l].m == x->m && (!z->entry[l].re || may_be_conjugates(x, &z->entry[l])))
            return false;
    return true;
}
