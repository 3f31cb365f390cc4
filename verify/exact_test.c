/* exact_test.c: blocks that share an eigenvalue exactly (verify/exact.md, sections 4, 5 and 8).  Compiled once per number
   system; what is exact is the same in all. */
#include "exact_test.h"

#include "../lib/exact_block.h"
#include "../lib/spectrum.h"

#include <stdlib.h>
#include <string.h>

/* The width of the enclosure of the eigenvalue, as a part of the grid's digits. */
#define BRACKET_BITS(digits) ((digits) * 3 / 4)

void exact_enclose(number *z, const rational *x, const number_field *f, long prec)
{
    number t, q;
    rational angle;
    number_init(&t);
    number_init(&q);
    rational_init(&angle);
    if (rational_set_si(&angle, 1, f->n))
        number_cos_pi(&t, &angle, prec);
    else
        number_indeterminate(&t);
    number_add(&t, &t, &t, prec);
    number_set_rational(z, &x[f->degree - 1], prec);
    for (int i = f->degree - 2; i >= 0; i--) {
        number_mul(z, z, &t, prec);
        number_set_rational(&q, &x[i], prec);
        number_add(z, z, &q, prec);
    }
    number_clear(&t);
    number_clear(&q);
    rational_clear(&angle);
}

static outcome complain(analysis *a, const char *what)
{
    return findings_explain(a->findings, a->replay ? OUTCOME_FALSE : OUTCOME_FAIL, "%s", what);
}

static outcome complain_of_block(analysis *a, long m, const char *what)
{
    return findings_explain(a->findings, a->replay ? OUTCOME_FALSE : OUTCOME_FAIL, "block %ld %s", m, what);
}

/* ---- the exact part ---- */

/* g; of CLAIM_MODULUS_ONE x - 1. */
static void make_factor(struct exact_state *e, const exact_choice *c)
{
    number_field *f = &e->field;
    int degree = c->degree ? c->degree : 1;
    field_polynomial_make_room(&e->factor, degree);
    if (f->failed)
        return;
    field_set_si(f, field_polynomial_at(&e->factor, degree), 1);
    for (int i = 0; i < c->degree; i++)
        field_set(f, field_polynomial_at(&e->factor, i), &c->coefficient[i * c->field_degree]);
    if (!c->degree)
        field_set_si(f, field_polynomial_at(&e->factor, 0), -1);
}

/* rest = chi without the factor to the power `times`; false: it is no factor so often. */
static bool divide_out(field_polynomial *rest, const field_polynomial *factor, int times)
{
    bool exact = true;
    field_polynomial quotient, remainder;
    field_polynomial_init(&quotient, factor->field);
    field_polynomial_init(&remainder, factor->field);
    for (int i = 0; exact && i < times; i++) {
        exact = rest->degree >= factor->degree;
        if (exact)
            field_polynomial_divide(&quotient, &remainder, rest, factor);
        exact = exact && remainder.degree < 0 && !factor->field->failed;
        field_polynomial_swap(rest, &quotient);
    }
    field_polynomial_clear(&quotient);
    field_polynomial_clear(&remainder);
    return exact;
}

/* Is factor(M)^size rest(M) = 0? */
static bool is_annihilated(const field_matrix *m, const field_polynomial *factor, const field_polynomial *rest, int size)
{
    number_field *f = m->field;
    rational *v = field_new(f, (size_t)m->n);
    bool zero = true;
    for (int j = 0; zero && !f->failed && j < m->n; j++) {
        for (int i = 0; i < m->n; i++)
            field_set_si(f, field_at(f, v, (size_t)i), i == j);
        field_matrix_apply_polynomial(v, rest, m);
        for (int i = 0; i < size; i++)
            field_matrix_apply_polynomial(v, factor, m);
        zero = field_vector_is_zero(f, v, m->n);
    }
    field_free(f, v, (size_t)m->n);
    return zero && !f->failed;
}

static outcome make_line(analysis *a, int i)
{
    struct exact_state *e = a->exact;
    const exact_line *l = &a->choices->exact.line[i];
    field_polynomial factor;
    outcome o = OUTCOME_TRUE;
    exact_block_status made = exact_block_make(&e->matrix[i], &e->field, a->plan->problem->scheme, a->choices->k.first, l->frequency);
    field_polynomial_init(&e->rest[i], &e->field);
    e->lines++;
    if (made != EXACT_BLOCK_OK)
        return made == EXACT_BLOCK_NO_MEMORY ? OUTCOME_NO_MEMORY : complain_of_block(a, l->frequency, "has no exact value in the field");
    field_polynomial_init(&factor, &e->field);
    field_polynomial_reflect(&factor, &e->factor, l->sign);
    field_matrix_characteristic(&e->rest[i], &e->matrix[i]);
    if (!divide_out(&e->rest[i], &factor, l->multiplicity))
        o = complain_of_block(a, l->frequency, "does not have the exact factor");
    else if (l->size < l->multiplicity && !is_annihilated(&e->matrix[i], &factor, &e->rest[i], l->size))
        o = complain_of_block(a, l->frequency, "has larger Jordan blocks");
    field_polynomial_clear(&factor);
    return o;
}

/* ---- inequalities ---- */

/* Does p, monic, with these coefficients below its leading one, have only roots smaller than 1/scale?  By the power
   given, or, in a search, one that is found. */
static outcome contract(analysis *a, const number *coefficient, int degree, int *power)
{
    size_t size = (size_t)degree * (size_t)degree;
    number *companion = number_array_new(size);
    spectral_answer answer;
    if (!companion)
        return OUTCOME_NO_MEMORY;
    for (int i = 1; i < degree; i++)
        number_one(&companion[i * degree + i - 1]);
    for (int i = 0; i < degree; i++)
        number_neg(&companion[i * degree + degree - 1], &coefficient[i]);
    answer = a->replay ? spectral_contraction(companion, &a->scale, degree, *power, *power, a->prec) : spectral_contraction_sharp(companion, &a->scale, degree, EXACT_MAX_POWER, a->prec);
    number_array_free(companion, size);
    if (answer.contracts == TRUTH_TRUE)
        *power = answer.power;
    return answer.contracts == TRUTH_TRUE    ? OUTCOME_TRUE
           : answer.contracts == TRUTH_FALSE ? OUTCOME_NO_MEMORY
                                             : complain(a, "other eigenvalues of the exact blocks could not be shown to be smaller");
}

/* The enclosures of all coefficients but the leading 1. */
static number *enclose_polynomial(const field_polynomial *p, long prec)
{
    number *z = number_array_new(p->degree > 0 ? (size_t)p->degree : 1);
    for (int i = 0; z && i < p->degree; i++)
        exact_enclose(&z[i], field_polynomial_at(p, i), p->field, prec);
    return z;
}

/* The sign of g at the grid number x. */
static int sign_at(const number *g, int degree, const integer *x, const analysis *a)
{
    number z, at;
    int sign;
    number_init(&z);
    number_init(&at);
    number_set_integer_2exp(&at, x, -a->choices->grid, a->prec);
    number_one(&z);
    for (int i = degree - 1; i >= 0; i--) {
        number_mul(&z, &z, &at, a->prec);
        number_add(&z, &z, &g[i], a->prec);
    }
    sign = number_is_positive(&z) == TRUTH_TRUE ? 1 : number_is_negative(&z) == TRUTH_TRUE ? -1 : 0;
    number_clear(&z);
    number_clear(&at);
    return sign;
}

/* middle = low + about 5/11 of the way to high: a root is often half-way. */
static bool divide_bracket(integer *middle, const integer *low, const integer *high)
{
    integer eleven;
    bool ok;
    integer_init(&eleven);
    integer_set_si(&eleven, 11);
    ok = integer_sub(middle, high, low) && integer_mul_si(middle, middle, 5) && integer_fdiv_q(middle, middle, &eleven) && integer_add(middle, middle, low);
    integer_clear(&eleven);
    return ok;
}

/* From low and high in doubles, the bracket of the choices, as narrow as signs can tell. */
static bool choose_bracket(exact_choice *c, const number *g, int degree, const analysis *a)
{
    long digits = a->choices->grid;
    integer low, high, middle;
    int sign = 0, last = 1;
    bool ok;
    integer_init(&low);
    integer_init(&high);
    integer_init(&middle);
    number end;
    number_init(&end);
    number_set_double(&end, c->low, a->prec);
    ok = number_lower_grid(&low, &end, digits);
    number_set_double(&end, c->high, a->prec);
    ok = ok && number_upper_grid(&high, &end, digits);
    if (ok)
        sign = sign_at(g, degree, &low, a);
    while (ok && sign && last) {
        ok = integer_sub(&middle, &high, &low);
        if (!ok || integer_bits(&middle) <= (size_t)(digits - BRACKET_BITS(digits)))
            break;
        ok = divide_bracket(&middle, &low, &high);
        last = ok ? sign_at(g, degree, &middle, a) : 0;
        if (last)
            integer_swap(last == sign ? &low : &high, &middle);
    }
    ok = ok && integer_sub(&c->radius, &high, &low) && integer_add_si(&c->radius, &c->radius, 1) && integer_fdiv_2exp(&c->radius, &c->radius, 1)
         && integer_add(&c->eigenvalue, &low, &c->radius);
    number_clear(&end);
    integer_clear(&low);
    integer_clear(&high);
    integer_clear(&middle);
    return ok;
}

/* lambda = [low, high] of the choices, 0 < low, high < 1, and the scale 1/low. */
static outcome set_eigenvalue(analysis *a, const integer *low, const integer *high)
{
    number *lambda = &a->exact->eigenvalue, one, lower;
    outcome o = OUTCOME_TRUE;
    number_init(&one);
    number_init(&lower);
    number_one(&one);
    number_set_integer_2exp(&lower, low, -a->choices->grid, a->prec);
    number_set_integer_2exp(lambda, high, -a->choices->grid, a->prec);
    number_hull(lambda, lambda, &lower, a->prec);
    if (number_is_positive(lambda) != TRUTH_TRUE || number_less(lambda, &one) != TRUTH_TRUE)
        o = complain(a, "the exact eigenvalue could not be shown to lie between 0 and 1");
    number_inv(&a->scale, &lower, a->prec);
    number_upper(&a->scale, &a->scale, a->prec);
    number_clear(&one);
    number_clear(&lower);
    return o;
}

/* g changes its sign within the bracket, and its other roots are smaller. */
static outcome prove_root(analysis *a)
{
    struct exact_state *e = a->exact;
    exact_choice *c = &a->choices->exact;
    int degree = e->factor.degree;
    number *g = enclose_polynomial(&e->factor, a->prec);
    integer low, high;
    outcome o = OUTCOME_NO_MEMORY;
    integer_init(&low);
    integer_init(&high);
    e->quotient = number_array_new((size_t)degree);
    if (g && e->quotient && (a->replay || choose_bracket(c, g, degree, a)) && integer_sub(&low, &c->eigenvalue, &c->radius) && integer_add(&high, &c->eigenvalue, &c->radius)) {
        o = set_eigenvalue(a, &low, &high);
        if (o == OUTCOME_TRUE && sign_at(g, degree, &low, a) * sign_at(g, degree, &high, a) >= 0)
            o = complain(a, "the exact factor could not be shown to have a root near the eigenvalue");
        number_one(&e->quotient[degree - 1]);
        for (int i = degree - 1; i > 0; i--) {
            number_mul(&e->quotient[i - 1], &e->eigenvalue, &e->quotient[i], a->prec);
            number_add(&e->quotient[i - 1], &e->quotient[i - 1], &g[i], a->prec);
        }
        if (o == OUTCOME_TRUE)
            o = contract(a, e->quotient, degree - 1, &c->others);
    }
    if (g)
        number_array_free(g, degree > 0 ? (size_t)degree : 1);
    integer_clear(&low);
    integer_clear(&high);
    return o;
}

static outcome prove_rest(analysis *a, int i)
{
    const field_polynomial *h = &a->exact->rest[i];
    number *coefficient = enclose_polynomial(h, a->prec);
    outcome o = OUTCOME_NO_MEMORY;
    if (coefficient) {
        o = contract(a, coefficient, h->degree, &a->choices->exact.line[i].power);
        number_array_free(coefficient, h->degree > 0 ? (size_t)h->degree : 1);
    }
    return o;
}

/* 1 itself, which no enclosure has to find. */
static outcome set_modulus_one(analysis *a)
{
    number_one(&a->exact->eigenvalue);
    a->exact->quotient = number_array_new(1);
    if (!a->exact->quotient)
        return OUTCOME_NO_MEMORY;
    number_one(&a->exact->quotient[0]);
    return OUTCOME_TRUE;
}

/* ---- the claim ---- */

/* What verify/exact.md, section 8, wants of the lines, and that their frequencies rise. */
static bool are_lines_good(const choices *c)
{
    const exact_choice *e = &c->exact;
    int largest = 0, with_largest = 0, counting = 0, of_dimension_two = 0;
    for (int i = 0; i < e->count; i++)
        largest = e->line[i].size > largest ? e->line[i].size : largest;
    for (int i = 0; i < e->count; i++) {
        const exact_line *l = &e->line[i];
        bool counts = l->column > 0;
        if (l->frequency > c->k.first / 2 || (i && l->frequency <= e->line[i - 1].frequency) || (counts && l->size != largest))
            return false;
        with_largest += l->size == largest;
        counting += counts;
        of_dimension_two += counts && l->frequency > 0 && 2 * l->frequency != c->k.first;
        if (counts && c->claim == CLAIM_JORDAN && (l->frequency == 1 || 2 * l->frequency == c->k.first || l->multiplicity >= 2 * l->size))
            return false;
        if (c->claim == CLAIM_MODULUS_ONE && (l->power || (l->frequency == 0 && l->sign > 0)))
            return false;
    }
    if (c->claim == CLAIM_TIE)
        return counting == 2 && of_dimension_two > 0;
    return counting == 1 && with_largest == 1 && (c->claim == CLAIM_JORDAN || e->count == 1);
}

static outcome make_state(analysis *a)
{
    struct exact_state *e = calloc(1, sizeof *e);
    a->exact = e;
    if (!e)
        return OUTCOME_NO_MEMORY;
    number_init(&e->eigenvalue);
    if (!number_field_make(&e->field, a->choices->exact.n))
        return complain(a, "the field is too large");
    field_polynomial_init(&e->factor, &e->field);
    make_factor(e, &a->choices->exact);
    return OUTCOME_TRUE;
}

void exact_free(analysis *a)
{
    struct exact_state *e = a->exact;
    if (!e)
        return;
    for (int i = 0; i < e->lines; i++) {
        field_matrix_clear(&e->matrix[i]);
        field_polynomial_clear(&e->rest[i]);
    }
    if (e->quotient)
        number_array_free(e->quotient, (size_t)e->factor.degree);
    if (e->factor.field)
        field_polynomial_clear(&e->factor);
    number_clear(&e->eigenvalue);
    number_field_free(&e->field);
    free(e);
    a->exact = NULL;
}

static int first_counting(const exact_choice *c, int from)
{
    while (from < c->count && !c->line[from].column)
        from++;
    return from;
}

outcome test_exact(analysis *a)
{
    choices *c = a->choices;
    bool inequalities = c->claim != CLAIM_MODULUS_ONE;
    outcome o = make_state(a);
    if (o == OUTCOME_TRUE && !are_lines_good(c))
        o = complain(a, "the exact blocks do not prove the claim");
    for (int i = 0; o == OUTCOME_TRUE && i < c->exact.count; i++)
        o = make_line(a, i);
    if (o == OUTCOME_TRUE && a->exact->field.failed)
        o = findings_explain(a->findings, OUTCOME_FAIL, "exact numbers become too long");
    if (o == OUTCOME_TRUE)
        o = inequalities ? prove_root(a) : set_modulus_one(a);
    for (int i = 0; o == OUTCOME_TRUE && inequalities && i < c->exact.count; i++)
        o = prove_rest(a, i);
    if (o == OUTCOME_TRUE)
        o = exact_use_line(a, first_counting(&c->exact, 0));
    a->findings->eigenvalue_lower = a->exact ? number_lower_bound(&a->exact->eigenvalue) : 0;
    a->findings->eigenvalue_upper = a->exact ? number_upper_bound(&a->exact->eigenvalue) : 0;
    return o;
}

outcome test_exact_witnesses(analysis *a)
{
    choices *c = a->choices;
    int line = first_counting(&c->exact, 0);
    outcome o = OUTCOME_TRUE;
    for (int i = 0; o == OUTCOME_TRUE && i < claim_witnesses(c->claim); i++) {
        o = exact_use_line(a, line);
        if (o == OUTCOME_TRUE)
            o = analysis_seek_nonzero(a, &c->witness[i]);
        line = first_counting(&c->exact, line + 1);
    }
    return o;
}
