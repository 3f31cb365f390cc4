/* charnet.c: an eigenvector of the block extends to the whole complex, ring by ring. */
#include "charnet.h"

#include <string.h>

static block_status from_sector(sector_status s)
{
    return s == SECTOR_OK ? BLOCK_OK : BLOCK_OPPOSITE;
}

/* Computes the rings known + 1 .. upto of the net, which must need no other rings than 1 .. known. */
static block_status extend(sector_net *net, const mask_numbers *mask, const number *eigenvalue, int known, int upto, long prec)
{
    for (int j = known + 1; j <= upto; j++)
        for (int b = 0; b < j; b++) {
            int at = sector_index(j - b, b);
            sector_status s = sector_refined_value(&net->x[at], &net->y[at], net, mask, j - b, b, prec);
            if (s != SECTOR_OK)
                return from_sector(s);
            number_div(&net->x[at], &net->x[at], eigenvalue, prec);
            number_div(&net->y[at], &net->y[at], eigenvalue, prec);
            if (number_lacks_memory(&net->x[at]) || number_lacks_memory(&net->y[at]))
                return BLOCK_NO_MEMORY;
        }
    return BLOCK_OK;
}

/* New values on ring j use old rings up to floor((j + reach) / 2) <= known, if j <= 2 known + 1 - reach. */
block_status charnet_make(sector_net *net, const block *b, const number *box, const mask_numbers *mask, int reach, int rings, long prec)
{
    block_status s = BLOCK_OK;
    int known = b->rings;
    if (!sector_net_make(net, rings > known ? rings : known, &b->twist))
        return BLOCK_NO_MEMORY;
    block_net(net, b, box, prec);
    while (s == BLOCK_OK && known < rings) {
        int upto = 2 * known + 1 - reach < rings ? 2 * known + 1 - reach : rings;
        s = extend(net, mask, &box[b->n], known, upto, prec);
        known = upto;
    }
    return s;
}

/* (x, y) = the value, or the difference in the direction of the net `which`, at (a,b). */
static sector_status point_of(number *x, number *y, number *scratch, const sector_net *net, int which, int a, int b, long prec)
{
    sector_status s;
    if (which == RING_VALUES)
        return sector_value(x, y, net, a, b, prec);
    s = sector_value(&scratch[0], &scratch[1], net, a, b, prec);
    if (s == SECTOR_OK)
        s = sector_value(x, y, net, a + (which == RING_FIRST), b + (which == RING_SECOND), prec);
    number_sub(x, x, &scratch[0], prec);
    number_sub(y, y, &scratch[1], prec);
    return s;
}

/* Replaces x by its midpoint and notes its radius. */
static void make_thin(number *x, number *radius, number *scratch, long prec)
{
    number_radius_upper(scratch, x, prec);
    number_max(radius, radius, scratch, prec);
    number_midpoint(x, x, prec);
}

block_status charnet_windows_make(charnet_windows *z, const sector_net *net, const ring *r, int which, const element *elements, int count, long prec)
{
    const element_stencil *stencil = &r->stencil[which];
    sector_status s = SECTOR_OK;
    number scratch[2];
    memset(z, 0, sizeof *z);
    z->count = count;
    for (int t = 0; t < ELEMENT_TYPES; t++) {
        z->window[t] = stencil->window[t].count;
        z->stride = z->window[t] > z->stride ? z->window[t] : z->stride;
    }
    for (int c = 0; c < 2; c++) {
        number_init(&z->radius[c]);
        number_init(&scratch[c]);
    }
    z->x = number_array_new((size_t)count * (size_t)z->stride);
    z->y = number_array_new((size_t)count * (size_t)z->stride);
    for (int i = 0; z->x && z->y && s == SECTOR_OK && i < count; i++)
        for (int j = 0; s == SECTOR_OK && j < z->window[elements[i].type]; j++) {
            lattice p = stencil->window[elements[i].type].point[j];
            number *x = &z->x[i * z->stride + j], *y = &z->y[i * z->stride + j];
            s = point_of(x, y, scratch, net, which, elements[i].a + p.a, elements[i].b + p.b, prec);
            make_thin(x, &z->radius[0], &scratch[0], prec);
            make_thin(y, &z->radius[1], &scratch[0], prec);
        }
    for (int c = 0; c < 2; c++)
        number_clear(&scratch[c]);
    if (!z->x || !z->y || number_lacks_memory(&z->radius[0]) || number_lacks_memory(&z->radius[1]))
        return BLOCK_NO_MEMORY;
    return from_sector(s);
}

void charnet_windows_free(charnet_windows *z)
{
    size_t n = (size_t)z->count * (size_t)z->stride;
    if (z->x)
        number_array_free(z->x, n);
    if (z->y)
        number_array_free(z->y, n);
    number_clear(&z->radius[0]);
    number_clear(&z->radius[1]);
    memset(z, 0, sizeof *z);
}
