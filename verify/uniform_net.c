/* uniform_net.c: hexagons of labels, one subdivision after the other, and (4.26) to (4.28). */
#include "uniform_net.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void uniform_net_init(uniform_net *z)
{
    memset(z, 0, sizeof *z);
    for (int c = 0; c < 2; c++) {
        number_init(&z->error[c]);
        for (int m = 0; m <= UNIFORM_MAX_LEVEL; m++)
            number_init(&z->spread[c][m]);
    }
}

/* The labels and values of one level. */
static void free_level(uniform_net *z)
{
    free(z->row);
    z->row = NULL;
    for (int c = 0; c < 2; c++) {
        if (z->value[c])
            number_array_free(z->value[c], (size_t)z->count);
        z->value[c] = NULL;
    }
}

void uniform_net_clear(uniform_net *z)
{
    free_level(z);
    for (int c = 0; c < 2; c++) {
        number_clear(&z->error[c]);
        for (int m = 0; m <= UNIFORM_MAX_LEVEL; m++)
            number_clear(&z->spread[c][m]);
    }
    uniform_net_init(z);
}

/* ---- labels ---- */

/* The window of the whole sector of the ring: 0 <= a, b <= 2r, r <= a + b <= 2r in units of level 0. */
static void set_hexagon(uniform_net *z, int level)
{
    const laurent_extent *e = &z->bounds->extent[z->which];
    z->level = level;
    for (int f = 0; f < 3; f++) {
        int least = f < 2 ? 0 : z->ring->radius << level, greatest = 2 * z->ring->radius << level;
        z->low[f] = least - (int)e->high[f] + 1;
        z->high[f] = greatest - (int)e->low[f] - 1;
    }
}

static int first_in_row(const uniform_net *z, int a)
{
    return z->low[2] - a > z->low[1] ? z->low[2] - a : z->low[1];
}

static int last_in_row(const uniform_net *z, int a)
{
    return z->high[2] - a < z->high[1] ? z->high[2] - a : z->high[1];
}

static outcome make_level(uniform_net *z)
{
    long count = 0;
    z->row = malloc((size_t)(z->high[0] - z->low[0] + 1) * sizeof *z->row);
    if (!z->row)
        return OUTCOME_NO_MEMORY;
    for (int a = z->low[0]; a <= z->high[0]; a++) {
        int length = last_in_row(z, a) - first_in_row(z, a) + 1;
        z->row[a - z->low[0]] = (int)count;
        count += length > 0 ? length : 0;
        if (count > UNIFORM_MAX_POINTS)
            return OUTCOME_UNDEFINED;
    }
    z->count = (int)count;
    for (int c = 0; c < 2; c++) {
        z->value[c] = number_array_new((size_t)count);
        if (!z->value[c])
            return OUTCOME_NO_MEMORY;
    }
    return OUTCOME_TRUE;
}

/* ---- D, and the error ---- */

/* D(p) = the largest difference of two labels of the hexagon along the two directions. */
static void find_spread(uniform_net *z, long prec)
{
    number t;
    number_init(&t);
    for (int c = 0; c < 2; c++)
        number_zero(&z->spread[c][z->level]);
    for (int i = 0; i < 2; i++) {
        lattice u = z->bounds->direction[z->which][i];
        for (int a = z->low[0]; a <= z->high[0]; a++)
            for (int b = first_in_row(z, a); b <= last_in_row(z, a); b++) {
                int at, next;
                if (a + u.a > z->high[0] || b + u.b < first_in_row(z, a + u.a) || b + u.b > last_in_row(z, a + u.a))
                    continue;
                at = uniform_net_index(z, a, b);
                next = uniform_net_index(z, a + u.a, b + u.b);
                for (int c = 0; c < 2; c++) {
                    number_sub(&t, &z->value[c][next], &z->value[c][at], prec);
                    number_magnitude_upper(&t, &t, prec);
                    number_max(&z->spread[c][z->level], &z->spread[c][z->level], &t, prec);
                }
            }
    }
    number_clear(&t);
}

/* e = c / (1 - g) (g (D_(m-1) + ... + D_(m-N+1)) + D_m), g the norm of N steps, N <= m + 1. */
static void error_of_steps(number *e, const uniform_net *z, int component, int steps, long prec)
{
    const number *spread = z->spread[component];
    number g, rest, c;
    number_init(&g);
    number_init(&rest);
    number_init(&c);
    number_set_rational(&g, &z->bounds->contraction[z->which].norm[steps], prec);
    number_set_rational(&c, &z->bounds->constant[z->which], prec);
    number_zero(e);
    for (int q = 1; q < steps; q++)
        number_add(e, e, &spread[z->level - q], prec);
    number_mul(e, e, &g, prec);
    number_add(e, e, &spread[z->level], prec);
    number_one(&rest);
    number_sub(&rest, &rest, &g, prec);
    number_div(&c, &c, &rest, prec);
    number_mul(e, e, &c, prec);
    number_upper(e, e, prec);
    number_clear(&g);
    number_clear(&rest);
    number_clear(&c);
}

/* The best number of steps: each gives a bound. */
static void find_error(uniform_net *z, long prec)
{
    const norm_list *contraction = &z->bounds->contraction[z->which];
    number e;
    number_init(&e);
    for (int c = 0; c < 2; c++) {
        bool first = true;
        number_indeterminate(&z->error[c]);
        for (int n = 1; n <= contraction->count && n <= z->level + 1; n++) {
            if (rational_cmp_si(&contraction->norm[n], 1, 1) >= 0)
                continue;
            error_of_steps(&e, z, c, n, prec);
            if (first || number_upper_bound(&e) < number_upper_bound(&z->error[c]))
                number_set(&z->error[c], &e);
            first = false;
        }
    }
    number_clear(&e);
}

double uniform_net_width(const uniform_net *z, long prec)
{
    double width = 0;
    number t;
    number_init(&t);
    for (int c = 0; c < 2; c++)
        for (int i = 0; i < z->count; i++) {
            number_radius_upper(&t, &z->value[c][i], prec);
            width = fmax(width, number_upper_bound(&t));
        }
    number_clear(&t);
    return width;
}

/* ---- level 0 ---- */

static sector_status read_label(uniform_net *z, const sector_net *net, number *scratch, int a, int b, long prec)
{
    int i = uniform_net_index(z, a, b);
    number *x = &z->value[0][i], *y = &z->value[1][i];
    sector_status s;
    if (z->which == RING_VALUES)
        return sector_value(x, y, net, a, b, prec);
    s = sector_value(&scratch[0], &scratch[1], net, a, b, prec);
    if (s == SECTOR_OK)
        s = sector_value(x, y, net, a + (z->which == RING_FIRST), b + (z->which == RING_SECOND), prec);
    number_sub(x, x, &scratch[0], prec);
    number_sub(y, y, &scratch[1], prec);
    return s;
}

static bool lacks_memory(const uniform_net *z)
{
    return number_lacks_memory(&z->spread[0][z->level]) || number_lacks_memory(&z->spread[1][z->level]);
}

block_status uniform_net_make(uniform_net *z, const sector_net *net, const ring *r, int which, const mask_numbers *mask, const uniform_bounds *b, long prec)
{
    sector_status s = SECTOR_OK;
    number scratch[2];
    z->ring = r;
    z->bounds = b;
    z->mask = mask;
    z->which = which;
    set_hexagon(z, 0);
    if (make_level(z) != OUTCOME_TRUE)
        return BLOCK_NO_MEMORY;
    for (int c = 0; c < 2; c++)
        number_init(&scratch[c]);
    for (int i = z->low[0]; s == SECTOR_OK && i <= z->high[0]; i++)
        for (int j = first_in_row(z, i); s == SECTOR_OK && j <= last_in_row(z, i); j++)
            s = read_label(z, net, scratch, i, j, prec);
    for (int c = 0; c < 2; c++)
        number_clear(&scratch[c]);
    if (s != SECTOR_OK)
        return BLOCK_OPPOSITE;
    find_spread(z, prec);
    find_error(z, prec);
    return lacks_memory(z) ? BLOCK_NO_MEMORY : BLOCK_OK;
}

/* ---- subdivision ---- */

/* The points of the mask in one class of labels modulo 2. */
typedef struct {
    int count;
    struct {
        lattice point;
        const number *weight;
    } *term; /* room for all of the mask */
} mask_class;

static void list_class(mask_class *z, const mask_numbers *mask, int parity_a, int parity_b)
{
    const laurent *m = mask->mask;
    z->count = 0;
    for (long i = m->a0; i < m->a0 + m->na; i++)
        for (long j = m->b0; j < m->b0 + m->nb; j++) {
            if (((i ^ parity_a) & 1) || ((j ^ parity_b) & 1) || laurent_is_zero_at(m, i, j))
                continue;
            z->term[z->count].point = (lattice){(int)i, (int)j};
            z->term[z->count++].weight = mask_numbers_at(mask, i, j);
        }
}

/* new(x) = sum of mask(x - 2y) old(y). */
static void refine_label(uniform_net *z, const uniform_net *old, const mask_class *class, int a, int b, long prec)
{
    int at = uniform_net_index(z, a, b);
    for (int i = 0; i < class->count; i++) {
        lattice p = class->term[i].point;
        int from = uniform_net_index(old, (a - p.a) / 2, (b - p.b) / 2);
        for (int c = 0; c < 2; c++)
            number_addmul(&z->value[c][at], class->term[i].weight, &old->value[c][from], prec);
    }
}

static outcome refine_class(uniform_net *z, const uniform_net *old, const mask_class *class, int parity_a, int parity_b, const deadline *d, long prec)
{
    for (int a = z->low[0] + ((z->low[0] ^ parity_a) & 1); a <= z->high[0]; a += 2) {
        int b = first_in_row(z, a);
        if (deadline_passed(d))
            return OUTCOME_STOPPED;
        for (b += (b ^ parity_b) & 1; b <= last_in_row(z, a); b += 2)
            refine_label(z, old, class, a, b, prec);
    }
    return OUTCOME_TRUE;
}

static outcome refine_all(uniform_net *z, const uniform_net *old, const deadline *d, long prec)
{
    outcome o = OUTCOME_TRUE;
    mask_class class;
    class.term = malloc((size_t)(z->mask->mask->na * z->mask->mask->nb) * sizeof *class.term);
    if (!class.term)
        return OUTCOME_NO_MEMORY;
    for (int parity = 0; o == OUTCOME_TRUE && parity < 4; parity++) {
        list_class(&class, z->mask, parity >> 1, parity & 1);
        o = refine_class(z, old, &class, parity >> 1, parity & 1, d, prec);
    }
    free(class.term);
    return o;
}

outcome uniform_net_refine(uniform_net *z, const deadline *d, long prec)
{
    uniform_net old = *z; /* only its level's arrays are its own */
    outcome o;
    if (z->level >= UNIFORM_MAX_LEVEL)
        return OUTCOME_UNDEFINED;
    z->row = NULL;
    z->value[0] = z->value[1] = NULL;
    set_hexagon(z, old.level + 1);
    o = make_level(z);
    if (o == OUTCOME_UNDEFINED) { /* back to where we were */
        free_level(z);
        *z = old;
        return o;
    }
    if (o == OUTCOME_TRUE)
        o = refine_all(z, &old, d, prec);
    free_level(&old);
    if (o != OUTCOME_TRUE)
        return o;
    find_spread(z, prec);
    find_error(z, prec);
    return lacks_memory(z) ? OUTCOME_NO_MEMORY : OUTCOME_TRUE;
}
