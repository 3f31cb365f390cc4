/* block.c: unknowns, the nets they stand for, and the matrix, column by column. */
#include "block.h"

#include "stop.h"

#include <stdlib.h>
#include <string.h>

typedef enum { FORM_PLAIN, FORM_REAL, FORM_COMPLEX } form;

/* The unknowns of one point, of which (b,a) is the mirror image. */
static int list_point(unknown *list, form f, int a, int b)
{
    if (f == FORM_PLAIN)
        list[0] = (unknown){UNKNOWN_PLAIN, a, b};
    else if (f == FORM_COMPLEX)
        list[0] = (unknown){UNKNOWN_COMPLEX, a, b};
    else if (b == 0)
        list[0] = (unknown){UNKNOWN_SPOKE, a, b};
    else if (a == b)
        list[0] = (unknown){UNKNOWN_BISECTOR, a, b};
    else if (a > b) {
        list[0] = (unknown){UNKNOWN_X, a, b};
        list[1] = (unknown){UNKNOWN_Y, a, b};
        return 2;
    } else
        return 0;
    return 1;
}

/* Ring by ring, then by b, then by falling a: for triangles in the order of b alone. */
static int list_unknowns(unknown *list, mesh_kind mesh, int rings, form f)
{
    int n = 0;
    if (f == FORM_PLAIN && mesh != MESH_DUAL)
        list[n++] = (unknown){UNKNOWN_CENTRE, 0, 0};
    for (int j = 1; j <= rings; j++)
        for (int b = mesh == MESH_DUAL; b <= j; b++)
            for (int a = j; a >= 1; a--)
                if (mesh_ring(mesh, a, b) == j)
                    n += list_point(list + n, f, a, b);
    return n;
}

/* Sets V(a,b) = (x, y) and its mirror image V(b,a) = t conj V(a,b). */
static void set_pair(sector_net *net, const unknown *p, const number *x, const number *y, long prec)
{
    int here = sector_index(net, p->a, p->b), there = sector_index(net, p->b, p->a);
    number_set(&net->x[here], x);
    number_set(&net->y[here], y);
    number_set(&net->x[there], x);
    number_neg(&net->y[there], y);
    twist_apply(&net->x[there], &net->y[there], net->twist, 1, prec);
}

void block_net(sector_net *net, const block *z, const number *values, const number *imaginary, long prec)
{
    for (int i = 0; i < z->n; i++) {
        const unknown *p = &z->unknowns[i];
        int at = p->kind == UNKNOWN_CENTRE ? 0 : sector_index(net, p->a, p->b);
        switch (p->kind) {
        case UNKNOWN_CENTRE:
            number_set(&net->centre, &values[i]);
            if (imaginary)
                number_set(&net->centre_y, &imaginary[i]);
            break;
        case UNKNOWN_PLAIN:
        case UNKNOWN_SPOKE:
            number_set(&net->x[at], &values[i]);
            if (imaginary)
                number_set(&net->y[at], &imaginary[i]);
            else
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
        case UNKNOWN_COMPLEX:
            number_set(&net->x[at], &values[i]);
            number_set(&net->y[at], &imaginary[i]);
            break;
        }
    }
}

/* Reads the unknowns of a net into column j of the matrix. */
static void read_column(block *z, int j, const sector_net *net)
{
    for (int i = 0; i < z->n; i++) {
        const unknown *p = &z->unknowns[i];
        number *entry = &z->entry[i * z->n + j];
        int at = p->kind == UNKNOWN_CENTRE ? 0 : sector_index(net, p->a, p->b);
        if (p->kind == UNKNOWN_CENTRE)
            number_set(entry, &net->centre);
        else
            number_set(entry, p->kind == UNKNOWN_BISECTOR || p->kind == UNKNOWN_Y ? &net->y[at] : &net->x[at]);
        if (z->imaginary)
            number_set(&z->imaginary[i * z->n + j], &net->y[at]);
    }
}

block_status block_from_subdivide(subdivide_status s)
{
    static const block_status same[] = {BLOCK_OK, BLOCK_OPPOSITE, BLOCK_NO_CENTRE_RULE, BLOCK_NO_MEMORY};
    return same[s];
}

static block_status fill(block *z, sector_net *net, number *unit, const number *zero, const scheme_numbers *numbers)
{
    subdivision once;
    subdivide_status s = subdivision_make(&once, numbers, net->regular, net->rings, z->rings);
    bool stopped = false;
    for (int j = 0; s == SUBDIVIDE_OK && !stopped && j < z->n; j++) {
        sector_net image;
        for (int i = 0; i < z->n; i++)
            number_set_si(&unit[i], i == j, numbers->prec);
        block_net(net, z, unit, zero, numbers->prec);
        s = subdivision_apply(&image, net, &once);
        if (s == SUBDIVIDE_OK)
            read_column(z, j, &image);
        sector_net_free(&image);
        stopped = stop_now();
    }
    subdivision_free(&once);
    return stopped ? BLOCK_STOPPED : block_from_subdivide(s);
}

/* u = NULL: as the frequencies say. */
static bool set_twist(block *z, form f, const number *u, long prec)
{
    frequencies m = {z->m, z->last};
    if (f == FORM_PLAIN)
        return true;
    if (f == FORM_COMPLEX)
        return twist_set_complex_range(&z->twist, m, z->k.first, prec);
    return u ? twist_set_u(&z->twist, u, prec) : twist_set_real_range(&z->twist, m, z->k.first, prec);
}

static block_status make(block *z, scheme_numbers *numbers, frequencies m, const number *u, bool real, diagnostic *d)
{
    form f = m.last == 0 ? FORM_PLAIN : real ? FORM_REAL : FORM_COMPLEX;
    bool plain = f == FORM_PLAIN;
    block_status result = BLOCK_NO_MEMORY;
    number *unit = NULL, *zero = NULL;
    sector_net net;
    memset(z, 0, sizeof *z);
    z->m = m.first;
    z->last = m.last;
    z->k = numbers->k;
    z->mesh = numbers->scheme->mesh;
    z->rings = numbers->rings;
    twist_init(&z->twist);
    z->unknowns = malloc((size_t)(sector_size(z->rings) + 1) * sizeof *z->unknowns);
    if (z->unknowns)
        z->n = list_unknowns(z->unknowns, z->mesh, z->rings, f);
    if (!sector_net_make(&net, z->mesh, block_is_planar(z), z->rings, plain ? NULL : &z->twist) || !z->unknowns || !set_twist(z, f, u, numbers->prec))
        goto done;
    z->entry = number_array_new((size_t)z->n * (size_t)z->n);
    if (f == FORM_COMPLEX)
        z->imaginary = number_array_new((size_t)z->n * (size_t)z->n);
    unit = number_array_new((size_t)z->n);
    zero = number_array_new((size_t)z->n);
    if (z->entry && unit && zero && (f != FORM_COMPLEX || z->imaginary)) {
        status s = scheme_numbers_set_frequencies(numbers, m, plain ? NULL : &z->twist, d);
        result = s == STATUS_OK ? fill(z, &net, unit, zero, numbers) : s == STATUS_BAD_INPUT ? BLOCK_BAD_INPUT : BLOCK_NO_MEMORY;
    }
done:
    if (unit)
        number_array_free(unit, (size_t)z->n);
    if (zero)
        number_array_free(zero, (size_t)z->n);
    sector_net_free(&net);
    return result;
}

block_status block_make(block *z, scheme_numbers *numbers, long m, bool real, diagnostic *d)
{
    return make(z, numbers, one_frequency(m), NULL, real, d);
}

block_status block_make_range(block *z, scheme_numbers *numbers, frequencies m, bool real, diagnostic *d)
{
    return make(z, numbers, m, NULL, real, d);
}

block_status block_make_at(block *z, scheme_numbers *numbers, frequencies m, const number *u, diagnostic *d)
{
    return make(z, numbers, m, u, true, d);
}

/* (re, -im; im, re) for each entry, so that a real vector (x, y) stands for x + i y. */
number *block_real_matrix(int *size, const block *z)
{
    int parts = z->imaginary ? 2 : 1, n = z->n, all = parts * n;
    number *matrix = number_array_new((size_t)all * (size_t)all);
    *size = all;
    for (int i = 0; matrix && i < all; i++)
        for (int j = 0; j < all; j++) {
            number *to = &matrix[i * all + j];
            int from = i % n * n + j % n;
            number_set(to, i / n == j / n ? &z->entry[from] : &z->imaginary[from]);
            if (i / n < j / n)
                number_neg(to, to);
        }
    return matrix;
}

void block_free(block *z)
{
    if (z->entry)
        number_array_free(z->entry, (size_t)z->n * (size_t)z->n);
    if (z->imaginary)
        number_array_free(z->imaginary, (size_t)z->n * (size_t)z->n);
    free(z->unknowns);
    twist_clear(&z->twist);
    memset(z, 0, sizeof *z);
    twist_init(&z->twist);
}
