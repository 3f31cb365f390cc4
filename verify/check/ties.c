/* Refutations by eigenvalues that are equal: exact.md. */

#include "ties.h"

#include "answer.h"
#include "characteristic.h"
#include "polynomial.h"

#include <string.h>

enum { MAX_ORDER = 64 };

static const int64_t MAX_ALL_WORK = 100000000;

/* What has been proved: of g, of lambda (sections 2 and 5) ... */
struct proof {
    const struct certificate *c;
    const struct valence *v;
    const struct mask *q;
    struct field field;
    struct polynomial factor;                      /* g */
    interval *quotient;                            /* r = g / (x - lambda), but its first 1 */
    interval lambda, s;
    int64_t work;
};

/* ... and of an exact block (section 4). */
struct exact_line {
    const struct exact_record *record;
    struct block block;
    struct exact_matrix matrix;
    struct polynomial g, h;                        /* g_s, and h = chi / g_s^a */
};

/* The eigenvalue: section 5
 * ------------------------- */

/* x - 1, or what the certificate says. */
static struct polynomial read_factor(const struct certificate *c, const struct field *k)
{
    const struct exact_choices *e = &c->exact;
    int degree = c->reason == REASON_MODULUS_ONE ? 1 : e->degree;
    struct polynomial out = polynomial_make(degree);

    if (c->reason == REASON_MODULUS_ONE)
        out.coefficient[0] = number_from_whole(-1);
    else
        for (int i = 0; i < degree; i++) {
            const integer *at = &e->coefficient[i * (k->degree + 1)];

            out.coefficient[i] = number_of(at + 1, at[0], k);
        }
    return out;
}

/* g at a thin x. */
static interval factor_at(const interval *g, int degree, interval x, int bits)
{
    interval z = grid_from(1, bits);

    for (int i = degree - 1; i >= 0; i--)
        z = interval_add(grid_mul(z, x, bits), g[i]);
    return z;
}

/* All roots of the monic polynomial are smaller than 1/s in modulus. */
static void prove_small_roots(const interval *p, int degree, const struct proof *proof,
                              const struct block_record *record, const char *name)
{
    int g = proof->c->grid;
    interval *c = allocate((size_t)degree * (size_t)degree, sizeof c[0]);

    for (int i = 0; i + 1 < degree; i++)
        c[(i + 1) * degree + i] = grid_from(1, g);
    for (int i = 0; i < degree; i++)
        c[i * degree + degree - 1] = interval_minus(p[i]);
    spectrum_prove_small(c, degree, g, proof->s, record, name, proof->c->file);
}

/* r_(e-1) = 1, r_(i-1) = g_i + X r_i; for g = x - lambda no coefficient is asked for */
static void divide_by_root(struct proof *p, const interval *factor)
{
    int e = p->factor.degree, g = p->c->grid;
    interval r = grid_from(1, g);

    p->quotient = allocate((size_t)e, sizeof p->quotient[0]);
    p->quotient[e - 1] = r;
    for (int i = e - 1; i >= 1; i--)
        p->quotient[i - 1] = r = interval_add(factor[i], grid_mul(p->lambda, r, g));
}

static void prove_root(struct proof *p)
{
    const struct exact_choices *e = &p->c->exact;
    interval *factor = polynomial_enclose(&p->factor, &p->field, p->c->grid), low, high;
    int g = p->c->grid;

    p->lambda = interval_of(integer_sub(e->eigenvalue, e->radius),
                            integer_add(e->eigenvalue, e->radius));
    if (p->lambda.lo.sign <= 0 || integer_compare(p->lambda.hi, grid_from(1, g).lo) >= 0)
        rejected(p->c->file, e->line_of_eigenvalue, "eigenvalue: its interval is not inside (0,1)");
    low = factor_at(factor, e->degree, interval_thin(p->lambda.lo), g);
    high = factor_at(factor, e->degree, interval_thin(p->lambda.hi), g);
    if (interval_contains_zero(low) || interval_contains_zero(high) || low.lo.sign == high.lo.sign)
        rejected(p->c->file, e->line_of_eigenvalue,
                 "eigenvalue: the factor is not proved to have a root there");
    p->s = spectrum_inverse_upper(p->lambda.lo, g);
    divide_by_root(p, factor);
    prove_small_roots(p->quotient, e->degree - 1, p, &e->others, "others");
}

/* Exact blocks: section 4
 * ----------------------- */

/* d^2 N^4 of all lines. */
static void count_work(struct proof *p, const struct exact_line *l)
{
    int64_t n = l->matrix.size, d = p->field.degree;

    if (n > MAX_ORDER)
        cannot_check_at(p->c->file, l->record->record.line, 0,
                        "exact: a block of %d unknowns", l->matrix.size);
    p->work += d * d * n * n * n * n;              /* at most 64 2^36 */
    if (p->work > MAX_ALL_WORK)
        cannot_check_at(p->c->file, l->record->record.line, 0,
                        "exact: the exact blocks are too large");
}

/* v := g_s(M)^power h(M) v */
static void apply_factors(struct number *v, const struct exact_line *l, int power,
                          const struct field *k)
{
    polynomial_apply(v, &l->h, &l->matrix, k);
    for (int i = 0; i < power; i++)
        polynomial_apply(v, &l->g, &l->matrix, k);
}

static struct number *unit_vector(int size, int j)
{
    struct number *out = allocate((size_t)size, sizeof out[0]);

    for (int i = 0; i < size; i++)
        out[i] = number_from_whole(i == j ? 1 : 0);
    return out;
}

/* g_s(M)^q h(M) = 0, column by column */
static void prove_chains(const struct proof *p, const struct exact_line *l)
{
    for (int j = 0; j < l->matrix.size; j++) {
        struct mark mark = scratch_mark();
        struct number *v = unit_vector(l->matrix.size, j);

        apply_factors(v, l, l->record->q, &p->field);
        for (int i = 0; i < l->matrix.size; i++)
            if (!number_is_zero(&v[i]))
                rejected(p->c->file, l->record->record.line, "exact: q is smaller than the "
                         "largest Jordan block");
        scratch_release(mark);
    }
}

static void prove_line(struct exact_line *out, struct proof *p, const struct exact_record *e)
{
    const struct certificate *c = p->c;
    bool one = c->reason == REASON_MODULUS_ONE;

    out->record = e;
    if (e->m > 0 && !p->v->scheme->mirrored)
        rejected(c->file, e->record.line, "exact: the scheme is not evidently mirror-symmetric");
    if (one && e->m == 0 && e->sign > 0)
        rejected(c->file, e->record.line, "exact: expected s = -1 for block 0");
    if (one && e->record.power != 0)
        rejected(c->file, e->record.line, "exact: expected the power 0");
    block_prepare(&out->block, p->v, true, span_of(e->m));
    out->matrix.size = out->block.n - (out->block.plain ? 1 : 0);
    count_work(p, out);
    out->matrix = exact_block(&out->block, &p->field, e->record.line);
    if (e->j > out->matrix.size)
        rejected(c->file, e->record.line, "exact: there are %d unknowns", out->matrix.size);
    out->g = polynomial_turn(&p->factor, e->sign);
    out->h = polynomial_characteristic(&out->matrix, &p->field);
    for (int i = 0; i < e->a; i++)
        if (!polynomial_divide(&out->h, &out->g, &p->field))
            rejected(c->file, e->record.line, "exact: the characteristic polynomial is not "
                     "divisible by the factor, %d times", e->a);
    if (e->q < e->a)
        prove_chains(p, out);
    if (!one)
        prove_small_roots(polynomial_enclose(&out->h, &p->field, c->grid), out->h.degree, p,
                          &e->record, "exact");
}

/* Eigenfunctions: section 7
 * ------------------------- */

/* z := M z + r w, all enclosures. */
static void step(interval *z, const interval *m, interval r, const interval *w, int size, int g)
{
    interval *new = allocate((size_t)size, sizeof new[0]);

    for (int i = 0; i < size; i++)
        new[i] = interval_add(grid_mul(r, w[i], g), spectrum_dot(&m[i * size], z, 1, size, g));
    memcpy(z, new, (size_t)size * sizeof z[0]);
}

static interval *enclose_all(const struct number *a, size_t count, const struct proof *p)
{
    interval *out = allocate(count, sizeof out[0]);

    for (size_t i = 0; i < count; i++)
        out[i] = number_enclose(&a[i], &p->field, p->c->grid);
    return out;
}

/* y = r_s(M) w, w = g_s(M)^(q-1) h(M) e_j */
static struct affine *eigenvector(const struct proof *p, const struct exact_line *l)
{
    int size = l->matrix.size, e = p->factor.degree, g = p->c->grid;
    size_t n = (size_t)size;
    struct number *exact = unit_vector(size, l->record->j - 1);
    interval *w, *z, *m = enclose_all(l->matrix.entry, n * n, p);
    struct affine *out = allocate(n, sizeof out[0]);

    apply_factors(exact, l, l->record->q - 1, &p->field);
    w = enclose_all(exact, n, p);
    z = allocate(n, sizeof z[0]);
    memcpy(z, w, n * sizeof z[0]);
    for (int i = e - 2; i >= 0; i--) {
        bool minus = l->record->sign < 0 && (e - 1 - i) % 2 != 0;

        step(z, m, minus ? interval_minus(p->quotient[i]) : p->quotient[i], w, size, g);
    }
    for (size_t i = 0; i < n; i++)
        out[i] = affine_from(z[i]);
    return out;
}

/* The net of the line, and what the reason needs of its limit. */
static void decide_line(const struct proof *p, const struct exact_line *l, int witness)
{
    struct characteristic *characteristic = allocate(1, sizeof *characteristic);
    struct certificate *own = allocate(1, sizeof *own);
    const struct block *block = &l->block;
    interval lambda = l->record->sign > 0 ? p->lambda : interval_minus(p->lambda);
    struct eigenpair pair = {
        .unknowns = eigenvector(p, l), .real = affine_from(lambda),
        .imaginary = affine_from_whole(0, p->c->grid), .s = p->s
    };

    if (block->plain)
        spectrum_add_constants(&pair, block_matrix(block), block->n, false, p->c);
    *own = *p->c;
    own->witness[0] = p->c->witness[witness];
    characteristic_prepare(characteristic, block, &pair, p->q, own);
    decide_claim(characteristic, own);
}

/* The claims: section 8
 * --------------------- */

static bool is_real_block(int64_t m, const struct certificate *c)
{
    return m == 0 || 2 * m == c->valence.first;
}

/* The lines that count: two of a tie, else one. */
static void find_counting(const struct exact_record *out[2], const struct certificate *c)
{
    const struct exact_choices *e = &c->exact;
    int longest = 0, count = 0, wanted = c->reason == REASON_TIE ? 2 : 1;

    for (int i = 0; i < e->count; i++)
        longest = e->line[i].q > longest ? e->line[i].q : longest;
    for (int i = 0; i < e->count; i++) {
        if (e->line[i].j == 0)
            continue;
        if (e->line[i].q != longest)
            rejected(c->file, e->line[i].record.line, "exact: a line with an unknown must "
                     "have the largest q");
        if (count == wanted)
            rejected(c->file, e->line[i].record.line, "exact: too many lines have an unknown");
        out[count++] = &e->line[i];
    }
    if (count != wanted)
        rejected(c->file, e->line[0].record.line, "exact: too few lines have an unknown");
}

static void check_counting(const struct exact_record *const line[2], const struct certificate *c)
{
    const struct exact_choices *e = &c->exact;

    if (c->reason == REASON_TIE && is_real_block(line[0]->m, c) && is_real_block(line[1]->m, c))
        rejected(c->file, e->line[0].record.line, "exact: two real functions do not suffice");
    if (c->reason != REASON_JORDAN)
        return;
    if (line[0]->m == 1 || 2 * line[0]->m == c->valence.first)
        rejected(c->file, line[0]->record.line, "exact: it must not be block 1 or k/2");
    if (line[0]->a >= 2 * line[0]->q)
        rejected(c->file, line[0]->record.line, "exact: it must be a < 2 q");
    for (int i = 0; i < e->count; i++)
        if (&e->line[i] != line[0] && e->line[i].q == line[0]->q)
            rejected(c->file, e->line[i].record.line, "exact: another line has as large a q");
}

struct tie tie_prove(const struct valence *v, const struct mask q[3], const struct certificate *c)
{
    struct proof *p = allocate(1, sizeof *p);
    const struct exact_record *counting[2] = { NULL, NULL };
    int witness = 0;

    find_counting(counting, c);
    check_counting(counting, c);
    p->c = c;
    p->v = v;
    p->q = q;
    field_make(&p->field, c->exact.field);
    p->factor = read_factor(c, &p->field);
    if (c->reason == REASON_MODULUS_ONE) {
        p->lambda = grid_from(1, c->grid);
        divide_by_root(p, NULL);
    } else {
        prove_root(p);
    }
    for (int i = 0; i < c->exact.count; i++) {
        struct mark mark = scratch_mark();
        struct exact_line line = { .record = NULL };

        prove_line(&line, p, &c->exact.line[i]);
        if (c->exact.line[i].j > 0)
            decide_line(p, &line, witness++);
        scratch_release(mark);
    }
    return (struct tie) { p->lambda, p->s, counting[0]->m };
}
