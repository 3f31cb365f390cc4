/* exact_search.c: characteristic polynomials of the candidates' blocks, their factors by multiplicity, and what these have
   in common. */
#include "exact_search.h"

#include "../lib/exact_block.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Multiplications of rationals that all characteristic polynomials may cost. */
#define MAX_COST 5e6
/* Candidates taken for the largest block in turn. */
#define MAX_TARGETS 3
/* A modulus this near to 1 may be 1. */
#define NEARLY_ONE (1 - 1e-2)

typedef struct {
    const scheme *scheme;
    long k;
    number_field field;
    int count;                                  /* of blocks that have exact values */
    long frequency[CANDIDATES_MAX];
    double radius[CANDIDATES_MAX];
    field_matrix matrix[CANDIDATES_MAX];
    field_polynomial characteristic[CANDIDATES_MAX];
} blocks;

/* ---- the blocks ---- */

static long gcd(long a, long b)
{
    return b ? gcd(b, a % b) : a;
}

static long lcm(long a, long b)
{
    return a / gcd(a, b) * b;
}

static void clear_blocks(blocks *z)
{
    for (int i = 0; i < z->count; i++) {
        field_matrix_clear(&z->matrix[i]);
        field_polynomial_clear(&z->characteristic[i]);
    }
    number_field_free(&z->field);
    z->count = 0;
}

static double cost_of(const field_matrix *m)
{
    double n = m->n, d = m->field->degree;
    return n * n * n * n * d * d;
}

/* All candidates' blocks over Q(2 cos(pi/n)); *missing: one has no value there. */
static truth make_blocks(blocks *z, bool *missing, long n, const candidates *c)
{
    truth result = TRUTH_TRUE;
    double cost = 0;
    *missing = false;
    z->count = 0;
    if (n > NUMBER_FIELD_MAX_N || !number_field_make(&z->field, n))
        return z->field.failed ? TRUTH_FALSE : TRUTH_UNKNOWN;
    for (int i = 0; result == TRUTH_TRUE && i < c->count; i++) {
        int at = z->count;
        exact_block_status made = exact_block_make(&z->matrix[at], &z->field, z->scheme, z->k, c->frequency[i]);
        if (made == EXACT_BLOCK_NO_MEMORY)
            result = TRUTH_FALSE;
        if (made == EXACT_BLOCK_OK)
            cost += cost_of(&z->matrix[at]);
        if (made == EXACT_BLOCK_OK && cost <= MAX_COST) {
            field_polynomial_init(&z->characteristic[at], &z->field);
            field_matrix_characteristic(&z->characteristic[at], &z->matrix[at]);
            z->frequency[at] = c->frequency[i];
            z->radius[at] = c->radius[i];
            z->count++;
        } else {
            field_matrix_clear(&z->matrix[at]);
            *missing = true;
        }
    }
    return result == TRUTH_TRUE && z->field.failed ? TRUTH_UNKNOWN : result;
}

/* In the smallest field that has the twists, or in one that has all cosines of multiples of 2 pi/k, or pi/k and sines. */
static truth find_field(blocks *z, const candidates *c)
{
    long least = 1;
    truth result = TRUTH_UNKNOWN;
    for (int i = 0; i < c->count && least <= NUMBER_FIELD_MAX_N; i++)
        least = lcm(least, z->k / gcd(c->frequency[i], z->k)); /* of frequency 0: 1 */
    least = least > 1 ? least : 2; /* both are Q */
    const long n[3] = {least, lcm(least, z->k), lcm(least, 2 * z->k)};
    for (int i = 0; i < 3; i++) {
        bool missing;
        if (i && n[i] == n[i - 1])
            continue;
        clear_blocks(z);
        result = make_blocks(z, &missing, n[i], c);
        if (result == TRUTH_FALSE || (result == TRUTH_TRUE && !missing))
            break;
    }
    return result == TRUTH_TRUE && z->count ? TRUTH_TRUE : result == TRUTH_FALSE ? TRUTH_FALSE : TRUTH_UNKNOWN;
}

/* ---- factors ---- */

/* p = the product of all factors of chi of this multiplicity, each once (Yun). */
static void factor_of_multiplicity(field_polynomial *p, const field_polynomial *chi, int multiplicity)
{
    number_field *f = chi->field;
    field_polynomial repeated, once, next, rest;
    field_polynomial_init(&repeated, f);
    field_polynomial_init(&once, f);
    field_polynomial_init(&next, f);
    field_polynomial_init(&rest, f);
    field_polynomial_derivative(&rest, chi);
    field_polynomial_gcd(&repeated, chi, &rest);           /* every factor once less */
    field_polynomial_divide(&once, &rest, chi, &repeated); /* every factor once */
    for (int i = 1; i <= multiplicity && !f->failed && once.degree > 0; i++) {
        field_polynomial_gcd(&next, &once, &repeated);     /* those of higher multiplicity */
        field_polynomial_divide(p, &rest, &once, &next);
        field_polynomial_swap(&once, &next);
        field_polynomial_divide(&next, &rest, &repeated, &once);
        field_polynomial_swap(&repeated, &next);
    }
    field_polynomial_clear(&repeated);
    field_polynomial_clear(&once);
    field_polynomial_clear(&next);
    field_polynomial_clear(&rest);
}

static double value_approx(const field_polynomial *p, double x)
{
    double theta = 2 * cos(acos(-1.) / (double)p->field->n), sum = 0;
    for (int i = p->degree; i >= 0; i--) {
        const rational *c = field_polynomial_at(p, i);
        double value = 0;
        for (int j = p->field->degree - 1; j >= 0; j--)
            value = value * theta + rational_get_double_approx(&c[j]);
        sum = sum * x + value;
    }
    return sum;
}

static bool has_root_between(const field_polynomial *p, double low, double high)
{
    return p->degree > 0 && value_approx(p, low) * value_approx(p, high) < 0;
}

/* A narrow bracket of the root near `radius`: the double of the largest modulus is bad where it is multiple. */
static bool find_bracket(double *low, double *high, const field_polynomial *p, double radius)
{
    bool found = false;
    for (double width = 1e-9; !found && width < 0.1; width *= 10) {
        *low = radius * (1 - width);
        *high = radius * (1 + width);
        found = has_root_between(p, *low, *high);
    }
    for (int i = 0; found && i < 40 && *high - *low > 1e-11; i++) {
        double middle = *low + (*high - *low) * 5 / 11;
        *(has_root_between(p, *low, middle) ? high : low) = middle;
    }
    *low -= 1e-10;
    *high += 1e-10;
    return found && has_root_between(p, *low, *high);
}

/* The factor of block i, reflected by `sign`, that has a root near the bracket (or, if there is none, near the block's
   radius); its multiplicity, or 0. */
static int find_factor(field_polynomial *p, double *low, double *high, const blocks *z, int i, int sign)
{
    const field_polynomial *chi = &z->characteristic[i];
    field_polynomial factor;
    int found = 0;
    field_polynomial_init(&factor, chi->field);
    for (int multiplicity = 1; !found && !chi->field->failed && multiplicity <= chi->degree; multiplicity++) {
        field_polynomial_make_room(&factor, -1);
        factor_of_multiplicity(&factor, chi, multiplicity);
        field_polynomial_reflect(p, &factor, sign);
        if (*high > 0 ? has_root_between(p, *low, *high) : find_bracket(low, high, p, z->radius[i]))
            found = multiplicity;
        else if (*high > 0 && factor.degree > 0)
            continue;
        if (!found)
            *high = 0;
    }
    field_polynomial_clear(&factor);
    return found;
}

/* ---- Jordan blocks ---- */

/* rest = chi / factor^multiplicity */
static void divide_out(field_polynomial *rest, const field_polynomial *chi, const field_polynomial *factor, int multiplicity)
{
    field_polynomial quotient, remainder;
    field_polynomial_init(&quotient, chi->field);
    field_polynomial_init(&remainder, chi->field);
    field_polynomial_set(rest, chi);
    for (int i = 0; i < multiplicity; i++) {
        field_polynomial_divide(&quotient, &remainder, rest, factor);
        field_polynomial_swap(rest, &quotient);
    }
    field_polynomial_clear(&quotient);
    field_polynomial_clear(&remainder);
}

/* The least q with factor(M)^q rest(M) = 0: no more than the multiplicity. */
static int jordan_size(const field_matrix *m, const field_polynomial *factor, const field_polynomial *rest)
{
    number_field *f = m->field;
    rational *v = field_new(f, (size_t)m->n);
    int size = 1;
    for (int j = 0; !f->failed && j < m->n; j++) {
        for (int i = 0; i < m->n; i++)
            field_set_si(f, field_at(f, v, (size_t)i), i == j);
        field_matrix_apply_polynomial(v, rest, m);
        for (int q = 0; !f->failed && !field_vector_is_zero(f, v, m->n); q++) {
            field_matrix_apply_polynomial(v, factor, m);
            size = q + 1 > size ? q + 1 : size;
        }
    }
    field_free(f, v, (size_t)m->n);
    return size;
}

static void find_size(exact_line *l, const blocks *z, int i, const field_polynomial *g)
{
    field_polynomial factor, rest;
    field_polynomial_init(&factor, g->field);
    field_polynomial_init(&rest, g->field);
    field_polynomial_reflect(&factor, g, l->sign);
    divide_out(&rest, &z->characteristic[i], &factor, l->multiplicity);
    l->size = l->multiplicity == 1 ? 1 : jordan_size(&z->matrix[i], &factor, &rest);
    field_polynomial_clear(&factor);
    field_polynomial_clear(&rest);
}

/* ---- what they have in common ---- */

/* g = what block i shares with it, if that still has the root: then a line for the block. */
static void share(exact_choice *x, int index[], field_polynomial *g, const blocks *z, int i)
{
    field_polynomial p, common;
    field_polynomial_init(&p, g->field);
    field_polynomial_init(&common, g->field);
    for (int sign = 1; sign >= -1; sign -= 2) {
        double low = x->low, high = x->high;
        int multiplicity = find_factor(&p, &low, &high, z, i, sign);
        if (multiplicity)
            field_polynomial_gcd(&common, g, &p);
        if (!multiplicity || !has_root_between(&common, x->low, x->high) || x->count == EXACT_MAX_LINES)
            continue;
        field_polynomial_swap(g, &common);
        index[x->count] = i;
        x->line[x->count++] = (exact_line){.frequency = z->frequency[i], .sign = sign, .multiplicity = multiplicity};
        break;
    }
    field_polynomial_clear(&p);
    field_polynomial_clear(&common);
}

/* Lines and indices by rising frequency. */
static void sort_lines(exact_choice *x, int index[])
{
    for (int i = 1; i < x->count; i++)
        for (int j = i; j > 0 && x->line[j - 1].frequency > x->line[j].frequency; j--) {
            exact_line l = x->line[j];
            int t = index[j];
            x->line[j] = x->line[j - 1];
            x->line[j - 1] = l;
            index[j] = index[j - 1];
            index[j - 1] = t;
        }
}

static bool has_dimension_two(const exact_line *l, long k)
{
    return l->frequency > 0 && 2 * l->frequency != k;
}

/* The claim that the lines prove, if there is one (verify/exact.md, section 8), and which of them count. */
static bool choose_claim(exact_choice *x, claim_kind *claim, long k)
{
    int largest = 0, with_largest = 0, counting = 0;
    for (int i = 0; i < x->count; i++)
        if (x->line[i].size > largest) {
            largest = x->line[i].size;
            with_largest = 1;
        } else
            with_largest += x->line[i].size == largest;
    for (int wanted = 2; wanted >= 1; wanted--) /* pairs of blocks first */
        for (int i = 0; counting < 2 && i < x->count; i++)
            if (x->line[i].size == largest && has_dimension_two(&x->line[i], k) == (wanted == 2)) {
                x->line[i].column = 1;
                counting++;
                if (with_largest == 1) {
                    *claim = CLAIM_JORDAN;
                    return x->line[i].frequency != 1 && 2 * x->line[i].frequency != k && x->line[i].multiplicity < 2 * x->line[i].size;
                }
            }
    *claim = CLAIM_TIE;
    for (int i = 0; i < x->count; i++)
        if (x->line[i].column && has_dimension_two(&x->line[i], k))
            return true;
    return false;
}

/* The choices take over g. */
static bool take_factor(exact_choice *x, const field_polynomial *g)
{
    int d = g->field->degree;
    bool ok = g->degree <= EXACT_MAX_FACTOR && exact_choice_make_factor(x, g->degree, d);
    for (int i = 0; ok && i < g->degree * d; i++)
        ok = rational_set(&x->coefficient[i], &g->c[i]);
    return ok;
}

/* With the largest eigenvalue of this block. */
static truth search_from(exact_choice *x, claim_kind *claim, const blocks *z, int target)
{
    field_polynomial g;
    int index[EXACT_MAX_LINES];
    truth result = TRUTH_UNKNOWN;
    exact_choice_clear(x);
    field_polynomial_init(&g, z->matrix[0].field);
    for (int sign = 1; sign >= -1 && !x->count; sign -= 2) {
        x->low = x->high = 0;
        int multiplicity = find_factor(&g, &x->low, &x->high, z, target, sign);
        if (multiplicity) {
            index[0] = target;
            x->line[x->count++] = (exact_line){.frequency = z->frequency[target], .sign = sign, .multiplicity = multiplicity};
        }
    }
    for (int i = 0; x->count && i < z->count; i++)
        if (i != target)
            share(x, index, &g, z, i);
    sort_lines(x, index);
    for (int i = 0; i < x->count; i++)
        find_size(&x->line[i], z, index[i], &g);
    x->n = z->field.n;
    if (x->count && !z->field.failed && choose_claim(x, claim, z->k))
        result = take_factor(x, &g) ? TRUTH_TRUE : TRUTH_FALSE;
    field_polynomial_clear(&g);
    return result;
}

/* How often x - sign divides chi. */
static int multiplicity_of_one(const field_polynomial *chi, int sign)
{
    field_polynomial factor, rest, quotient, remainder;
    int times = 0;
    field_polynomial_init(&factor, chi->field);
    field_polynomial_init(&rest, chi->field);
    field_polynomial_init(&quotient, chi->field);
    field_polynomial_init(&remainder, chi->field);
    field_polynomial_make_room(&factor, 1);
    if (!chi->field->failed) {
        field_set_si(chi->field, field_polynomial_at(&factor, 1), 1);
        field_set_si(chi->field, field_polynomial_at(&factor, 0), -sign);
    }
    field_polynomial_set(&rest, chi);
    while (!chi->field->failed && rest.degree > 0) {
        field_polynomial_divide(&quotient, &remainder, &rest, &factor);
        if (remainder.degree >= 0)
            break;
        field_polynomial_swap(&rest, &quotient);
        times++;
    }
    field_polynomial_clear(&factor);
    field_polynomial_clear(&rest);
    field_polynomial_clear(&quotient);
    field_polynomial_clear(&remainder);
    return times;
}

/* An eigenvalue 1 or -1 besides that of the constant nets. */
static truth search_modulus_one(exact_choice *x, const blocks *z)
{
    field_polynomial g;
    truth result = TRUTH_UNKNOWN;
    exact_choice_clear(x);
    field_polynomial_init(&g, z->matrix[0].field);
    field_polynomial_make_room(&g, 1);
    if (!g.field->failed) {
        field_set_si(g.field, field_polynomial_at(&g, 1), 1);
        field_set_si(g.field, field_polynomial_at(&g, 0), -1);
    }
    x->n = z->field.n;
    for (int i = 0; !x->count && !g.field->failed && i < z->count; i++)
        for (int sign = z->frequency[i] ? 1 : -1; !x->count && sign >= -1; sign -= 2) {
            exact_line l = {.frequency = z->frequency[i], .sign = sign, .multiplicity = multiplicity_of_one(&z->characteristic[i], sign), .column = 1};
            if (z->radius[i] > NEARLY_ONE && l.multiplicity) {
                find_size(&l, z, i, &g);
                x->line[x->count++] = l;
                result = TRUTH_TRUE;
            }
        }
    field_polynomial_clear(&g);
    return result;
}

/* An eigenvalue of modulus 1 first, then what candidates share. */
static truth search(exact_choice *z, claim_kind *claim, blocks *b, const candidates *c)
{
    truth result = find_field(b, c);
    if (result == TRUTH_TRUE && b->radius[0] > NEARLY_ONE) {
        *claim = CLAIM_MODULUS_ONE;
        result = search_modulus_one(z, b);
        if (result != TRUTH_UNKNOWN)
            return result;
        result = TRUTH_TRUE;
    }
    if (result == TRUTH_TRUE) {
        result = TRUTH_UNKNOWN;
        for (int i = 0; result == TRUTH_UNKNOWN && i < b->count && i < MAX_TARGETS; i++)
            result = search_from(z, claim, b, i);
    }
    return result;
}

truth exact_search(exact_choice *z, claim_kind *claim, const scheme *s, long k, const candidates *c)
{
    blocks *b = calloc(1, sizeof *b);
    truth result = TRUTH_FALSE;
    if (b) {
        b->scheme = s;
        b->k = k;
        result = search(z, claim, b, c);
        clear_blocks(b);
    }
    free(b);
    return result;
}
