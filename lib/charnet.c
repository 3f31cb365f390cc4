/* charnet.c: an eigenvector of the block extends to the whole complex, ring by ring. */
#include "charnet.h"

#include <string.h>

static block_status from_sector(sector_status s)
{
    return s == SECTOR_OK ? BLOCK_OK : BLOCK_OPPOSITE;
}

static void copy_point(sector_net *to, const sector_net *from, int a, int b)
{
    number_set(&to->x[sector_index(to, a, b)], &from->x[sector_index(from, a, b)]);
    number_set(&to->y[sector_index(to, a, b)], &from->y[sector_index(from, a, b)]);
}

/* (x + i y) / (re + i im) = ((x re + y im) + i (y re - x im)) / (re^2 + im^2). */
void charnet_divide(number *x, number *y, const number *re, const number *im, long prec)
{
    number p, q, square;
    if (!im) {
        number_div(x, x, re, prec);
        number_div(y, y, re, prec);
        return;
    }
    number_init(&p);
    number_init(&q);
    number_init(&square);
    number_mul(&square, re, re, prec);
    number_addmul(&square, im, im, prec);
    number_mul(&p, x, re, prec);
    number_addmul(&p, y, im, prec);
    number_mul(&q, y, re, prec);
    number_submul(&q, x, im, prec);
    number_div(x, &p, &square, prec);
    number_div(y, &q, &square, prec);
    number_clear(&p);
    number_clear(&q);
    number_clear(&square);
}

/* wide = the rings 1..known of net, and beyond them, up to `upto`, S net / (re + i im). */
static block_status extend(sector_net *wide, const sector_net *net, int known, int upto, const number *re, const number *im, const scheme_numbers *numbers)
{
    subdivide_status s = scheme_subdivide(wide, net, numbers, upto);
    if (s != SUBDIVIDE_OK)
        return block_from_subdivide(s);
    number_set(&wide->centre, &net->centre);
    number_set(&wide->centre_y, &net->centre_y);
    for (int a = 1; a <= upto; a++)
        for (int b = 0; b <= upto; b++) {
            number *x = &wide->x[sector_index(wide, a, b)], *y = &wide->y[sector_index(wide, a, b)];
            if (!mesh_in_sector(net->mesh, a, b) || mesh_ring(net->mesh, a, b) > upto)
                continue;
            if (mesh_ring(net->mesh, a, b) <= known)
                copy_point(wide, net, a, b);
            else
                charnet_divide(x, y, re, im, numbers->prec);
            if (number_lacks_memory(x) || number_lacks_memory(y))
                return BLOCK_NO_MEMORY;
        }
    return BLOCK_OK;
}

block_status charnet_make(sector_net *net, const block *b, const number *box, bool is_complex, const scheme_numbers *numbers, int rings)
{
    const number *eigenvalue = &box[is_complex ? 2 * b->n : b->n];
    block_status s = BLOCK_OK;
    int known = b->rings;
    if (!sector_net_make(net, b->mesh, block_is_planar(b), known, b->m ? &b->twist : NULL))
        return BLOCK_NO_MEMORY;
    block_net(net, b, box, is_complex ? &box[b->n] : NULL, numbers->prec);
    while (s == BLOCK_OK && known < rings) {
        int upto = scheme_rings_reached(numbers->scheme, known, rings);
        sector_net wide;
        s = extend(&wide, net, known, upto, eigenvalue, is_complex ? eigenvalue + 1 : NULL, numbers);
        sector_net_free(net);
        *net = wide;
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
