/* spectrum_blocks.c: all eigenvalues of all blocks of one valence.  Compiled once per number system. */
#include "spectrum_blocks.h"

#include <math.h>
#include <stdlib.h>

#define list_blocks NUMBER_NAME(list_blocks)
status list_blocks(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d);

void disc_modulus(number *modulus, const eigenvalue_disc *d, long prec)
{
    number t;
    number_init(&t);
    number_sqr(modulus, &d->re, prec);
    number_sqr(&t, &d->im, prec);
    number_add(modulus, modulus, &t, prec);
    number_sqrt(modulus, modulus, prec);
    number_add_error(modulus, modulus, &d->radius, prec);
    number_clear(&t);
}

/* [lower, upper] contains the moduli of all points of the disc. */
static void bound_modulus(double *lower, double *upper, const eigenvalue_disc *d, long prec)
{
    number modulus;
    number_init(&modulus);
    disc_modulus(&modulus, d, prec);
    *upper = number_upper_bound(&modulus);
    *lower = fmax(0, number_lower_bound(&modulus));
    number_clear(&modulus);
}

/* part = all real (i = 0) or imaginary parts of the disc. */
static void bound_part(number *part, spectrum_entry *e, int i, const eigenvalue_disc *d, long prec)
{
    number_add_error(part, i ? &d->im : &d->re, &d->radius, prec);
    e->lower[i] = number_lower_bound(part);
    e->upper[i] = number_upper_bound(part);
}

static bool add_disc(spectrum_list *z, const eigenvalue_disc *d, const block *b, int digits, long prec)
{
    spectrum_entry *e = spectrum_list_add(z);
    number part, one;
    if (!e)
        return false;
    number_init(&part);
    number_init(&one);
    number_one(&one);
    e->m = b->m;
    e->count = d->count;
    e->real = d->real;
    e->real_block = b->imaginary == NULL;
    bound_modulus(&e->modulus_lower, &e->modulus_upper, d, prec);
    bound_part(&part, e, 0, d, prec);
    e->re = number_get_decimal(&part, digits);
    e->one = b->m == 0 && d->real && d->count == 1 && number_contains(&part, &one);
    if (!d->real) {
        bound_part(&part, e, 1, d, prec);
        e->im = number_get_decimal(&part, digits);
    }
    number_clear(&part);
    number_clear(&one);
    return e->re && (d->real || e->im);
}

/* No enclosure: the sum of a row bounds all. */
static bool add_bound(spectrum_list *z, const block *b, long prec)
{
    spectrum_entry *e = spectrum_list_add(z);
    number sum, size;
    if (!e)
        return false;
    number_init(&sum);
    number_init(&size);
    e->m = b->m;
    e->count = b->n;
    for (int i = 0; i < b->n; i++) {
        number_zero(&sum);
        for (int j = 0; j < b->n; j++) {
            number_magnitude_upper(&size, &b->entry[i * b->n + j], prec);
            number_add(&sum, &sum, &size, prec);
            if (b->imaginary) {
                number_magnitude_upper(&size, &b->imaginary[i * b->n + j], prec);
                number_add(&sum, &sum, &size, prec);
            }
        }
        e->modulus_upper = fmax(e->modulus_upper, number_upper_bound(&sum));
    }
    number_clear(&sum);
    number_clear(&size);
    return true;
}

status block_complaint(block_status s, diagnostic *d)
{
    switch (s) {
    case BLOCK_OK:
        return STATUS_OK;
    case BLOCK_OPPOSITE:
        return diagnostic_set(d, 0, 0, "a rule reaches behind the extraordinary vertex, where its sheet is ambiguous");
    case BLOCK_NO_CENTRE_RULE:
        return diagnostic_set(d, 0, 0, "the scheme has no rule for the extraordinary vertex, and the mask is none");
    case BLOCK_BAD_INPUT:
        return STATUS_BAD_INPUT;
    default:
        return STATUS_NO_MEMORY;
    }
}

status spectrum_list_block(spectrum_list *z, scheme_numbers *numbers, long m, int digits, diagnostic *d)
{
    block b;
    eigenvalues e;
    status result = block_complaint(block_make(&b, numbers, m, numbers->scheme->mirror_symmetric, d), d);
    bool ok = true;
    if (result == STATUS_OK) {
        switch (eigenvalues_enclose(&e, b.entry, b.imaginary, b.n, numbers->prec)) {
        case TRUTH_TRUE:
            for (int i = 0; ok && i < e.count; i++)
                ok = add_disc(z, &e.disc[i], &b, digits, numbers->prec);
            break;
        case TRUTH_UNKNOWN:
            ok = add_bound(z, &b, numbers->prec);
            break;
        default:
            ok = false;
        }
        eigenvalues_free(&e);
    }
    block_free(&b);
    return ok ? result : STATUS_NO_MEMORY;
}

status list_blocks(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d)
{
    scheme_numbers numbers;
    status result = scheme_numbers_make(&numbers, s, k, prec, d);
    numbers.any_mask = true;
    for (long m = 0; result == STATUS_OK && m <= k / 2; m++)
        result = spectrum_list_block(z, &numbers, m, digits, d);
    scheme_numbers_free(&numbers);
    return result;
}

/* The rounding mode is set round calls that contain no arithmetic of their own (bigfloat/number.h). */
status NUMBER_NAME(spectrum_list_make)(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d)
{
    number_mode mode = number_enter();
    status result = list_blocks(z, s, k, digits, prec, d);
    number_leave(mode);
    return result;
}
