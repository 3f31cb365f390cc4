/* gap.c: the difference of two proved moduli.  Compiled once per number system. */
#include "gap.h"

#include "block_matrix.h"

#include "../lib/eigenpair.h"

#define gap NUMBER_NAME(gap_of_moduli)
truth gap(long *bits, const scheme *s, long k, const long m[2], long prec);

/* z = the modulus of the dominant eigenvalue of block m. */
static truth modulus_of_block(number *z, scheme_numbers *numbers, long m, long prec)
{
    diagnostic unused;
    status made;
    int n;
    bool complex_form;
    eigenpair_choice choice;
    truth found = TRUTH_FALSE;
    number *matrix = block_matrix_make(&n, &complex_form, &made, numbers, m, &unused), *box;
    if (!matrix)
        return made == STATUS_NO_MEMORY ? TRUTH_FALSE : TRUTH_UNKNOWN;
    eigenpair_choice_init(&choice);
    box = number_array_new(eigenpair_box_size(n, complex_form));
    if (box)
        found = eigenpair_choose(&choice, matrix, n, complex_form, prec, prec);
    if (found == TRUTH_TRUE)
        found = eigenpair_prove(box, &choice, matrix, prec);
    if (found == TRUTH_TRUE)
        eigenpair_modulus(z, box, n, complex_form, prec);
    if (box)
        number_array_free(box, eigenpair_box_size(n, complex_form));
    eigenpair_choice_clear(&choice);
    number_array_free(matrix, (size_t)n * (size_t)n);
    return found;
}

/* Units of 2^-(2 prec) are small enough. */
static bool bits_of(long *bits, number *difference, long prec)
{
    integer upper;
    bool ok;
    integer_init(&upper);
    number_magnitude_upper(difference, difference, prec);
    ok = number_upper_grid(&upper, difference, 2 * prec);
    *bits = 2 * prec - (long)integer_bits(&upper);
    integer_clear(&upper);
    return ok;
}

truth gap(long *bits, const scheme *s, long k, const long m[2], long prec)
{
    scheme_numbers numbers;
    diagnostic unused;
    truth found = TRUTH_UNKNOWN;
    number modulus[2];
    number_init(&modulus[0]);
    number_init(&modulus[1]);
    status made = scheme_numbers_make(&numbers, s, k, prec, &unused);
    if (made == STATUS_OK)
        found = modulus_of_block(&modulus[0], &numbers, m[0], prec);
    if (found == TRUTH_TRUE)
        found = modulus_of_block(&modulus[1], &numbers, m[1], prec);
    number_sub(&modulus[0], &modulus[0], &modulus[1], prec);
    if (found == TRUTH_TRUE && !bits_of(bits, &modulus[0], prec))
        found = TRUTH_UNKNOWN;
    scheme_numbers_free(&numbers);
    number_clear(&modulus[0]);
    number_clear(&modulus[1]);
    return made == STATUS_NO_MEMORY ? TRUTH_FALSE : found;
}

/* The rounding mode is set round calls that contain no arithmetic of their own (bigfloat/number.h). */
truth NUMBER_NAME(gap_between)(long *bits, const scheme *s, long k, const long m[2], long prec)
{
    number_mode mode = number_enter();
    truth found = gap(bits, s, k, m, prec);
    number_leave(mode);
    return found;
}
