/* block.c: unknowns, the nets they stand for, and the matrix, column by column. */
#include "block.h"

#include <stdlib.h>
#include <string.h>

static int list_unknowns(unknown *list, int rings, bool plain)
{
    int n = 0;
    if (plain)
        list[n++] = (unknown){UNKNOWN_CENTRE, 0, 0};
    for (int j = 1; j <= rings; j++)
        for (int b = 0; b < j; b++) {
            int a = j - b;
            if (plain) {
                list[n++] = (unknown){UNKNOWN_PLAIN, a, b};
            } else if (b == 0) {
                list[n++] = (unknown){UNKNOWN_SPOKE, a, b};
            } else if (a == b) {
                list[n++] = (unknown){UNKNOWN_BISECTOR, a, b};
            } else if (a > b) {
                list[n++] = (unknown){UNKNOWN_X, a, b};
                list[n++] = (unknown){UNKNOWN_Y, a, b};
            }
        }
    return n;
}

/* Sets V(a,b) = (x, y) and its mirror image V(b,a) = t conj V(a,b). */
static void set_pair(sector_net *net, const unknown *p, const number *x, const number *y, long prec)
{
    int here = sector_index(p->a, p->b), there = sector_index(p->b, p->a);
    number_set(&net->x[here], x);
    number_set(&net->y[here], y);
    number_set(&net->x[there], x);
    number_neg(&net->y[there], y);
    twist_apply(&net->x[there], &net->y[there], net->twist, 1, prec);
}

void block_net(sector_net *net, const block *z, const number *values, long prec)
{
    for (int i = 0; i < z->n; i++) {
        const unknown *p = &z->unknowns[i];
        int at = sector_index(p->a, p->b);
        switch (p->kind) {
        case UNKNOWN_CENTRE:
            number_set(&net->centre, &values[i]);
            break;
        case UNKNOWN_PLAIN:
        case UNKNOWN_SPOKE:
            number_set(&net->x[at], &values[i]);
            number_zero(&net->y[at]);
            break;
        case UNKNOWN_BISECTOR:
            number_mul(&net->x[at], &net->twist->u, &values[i], prec);
            number_set(&net->y[at], &values[i]);
            break;
        case UNKNOWN_X: /* its UNKNOWN_Y is next */
            set_pair(net, p, &values[i], &values[i + 1], prec);
            break;
        case UNKNOWN_Y:
            break;
        }
    }
}

/* z = the unknown p of the net after one subdivision. */
static sector_status refined_unknown(number *z, const unknown *p, const sector_net *net, const mask_numbers *mask, const number *centre,
                                     const number *ring, long prec)
{
    number x, y;
    sector_status s = SECTOR_OK;
    number_init(&x);
    number_init(&y);
    if (p->kind == UNKNOWN_CENTRE) {
        number_mul(&x, centre, &net->centre, prec);
        number_addmul(&x, ring, &net->x[sector_index(1, 0)], prec);
    } else {
        s = sector_refined_value(&x, &y, net, mask, p->a, p->b, prec);
    }
    number_swap(z, p->kind == UNKNOWN_BISECTOR || p->kind == UNKNOWN_Y ? &y : &x);
    number_clear(&x);
    number_clear(&y);
    return s;
}

static block_status fill(block *z, sector_net *net, number *unit, const mask_numbers *mask, const number *centre, const number *ring, long prec)
{
    for (int j = 0; j < z->n; j++) {
        for (int i = 0; i < z->n; i++)
            number_set_si(&unit[i], i == j, prec);
        block_net(net, z, unit, prec);
        for (int i = 0; i < z->n; i++) {
            number *entry = &z->entry[i * z->n + j];
            if (refined_unknown(entry, &z->unknowns[i], net, mask, centre, ring, prec) != SECTOR_OK)
                return BLOCK_OPPOSITE;
            if (number_lacks_memory(entry))
                return BLOCK_NO_MEMORY;
        }
    }
    return BLOCK_OK;
}

block_status block_make(block *z, const scheme *s, const mask_numbers *mask, const number *centre, const number *ring, long m, long k, long prec)
{
    block_status result = BLOCK_NO_MEMORY;
    number *unit = NULL;
    sector_net net;
    memset(z, 0, sizeof *z);
    z->m = m;
    z->k = k;
    z->rings = block_rings(s);
    twist_init(&z->twist);
    z->unknowns = malloc((size_t)(sector_size(z->rings) + 1) * sizeof *z->unknowns);
    if (z->unknowns)
        z->n = list_unknowns(z->unknowns, z->rings, m == 0);
    if (!sector_net_make(&net, z->rings, m ? &z->twist : NULL) || !z->unknowns)
        goto done;
    z->entry = number_array_new((size_t)z->n * (size_t)z->n);
    unit = number_array_new((size_t)z->n);
    if (z->entry && unit && (m == 0 || twist_set(&z->twist, m, k, prec)))
        result = fill(z, &net, unit, mask, centre, ring, prec);
done:
    if (unit)
        number_array_free(unit, (size_t)z->n);
    sector_net_free(&net);
    return result;
}

void block_free(block *z)
{
    if (z->entry)
        number_array_free(z->entry, (size_t)z->n * (size_t)z->n);
    free(z->unknowns);
    twist_clear(&z->twist);
    memset(z, 0, sizeof *z);
    twist_init(&z->twist);
}
