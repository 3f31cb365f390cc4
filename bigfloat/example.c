/* example.c: how to use the number layer from a program of one's own.

       cc -o example example.c $(pkg-config --cflags --libs bigfloat)

   Rump's polynomial at a = 77617, b = 33096:

       f = 333.75 b^6 + a^2 (11 a^2 b^2 - b^6 - 121 b^4 - 2) + 5.5 b^8 + a / (2 b)

   Doubles give anything from -1e21 to 1e21 for it, and nothing warns of that.  A ball says how far it can be trusted: more
   precision is used until its sign is proved, and as many digits as were asked for. */
#include <bigfloat/ball.h>

#include <stdio.h>
#include <stdlib.h>

/* f encloses Rump's number: the numerators over 4 are whole, so nothing is lost on the way in. */
static void rump(ball *f, long precision)
{
    ball a, b, square, power, term;
    ball_init(&a), ball_init(&b), ball_init(&square), ball_init(&power), ball_init(&term);
    ball_set_si(&a, 77617, precision);
    ball_set_si(&b, 33096, precision);
    ball_sqr(&square, &b, precision);

    ball_pow_ui(&power, &b, 6, precision);
    ball_mul_si(&term, &power, 1335, precision);
    ball_mul_2exp(f, &term, -2, precision); /* 333.75 b^6 */

    ball_sqr(&term, &a, precision);
    ball_mul(&term, &term, &square, precision);
    ball_mul_si(&term, &term, 11, precision);
    ball_sub(&term, &term, &power, precision);
    ball_sqr(&power, &square, precision);
    ball_mul_si(&power, &power, 121, precision);
    ball_sub(&term, &term, &power, precision);
    ball_set_si(&power, 2, precision);
    ball_sub(&term, &term, &power, precision);
    ball_mul(&term, &term, &a, precision);
    ball_addmul(f, &term, &a, precision); /* a^2 (...) */

    ball_pow_ui(&power, &b, 8, precision);
    ball_mul_si(&power, &power, 11, precision);
    ball_mul_2exp(&power, &power, -1, precision);
    ball_add(f, f, &power, precision); /* 5.5 b^8 */

    ball_mul_2exp(&b, &b, 1, precision);
    ball_div(&term, &a, &b, precision);
    ball_add(f, f, &term, precision); /* a / (2 b) */

    ball_clear(&a), ball_clear(&b), ball_clear(&square), ball_clear(&power), ball_clear(&term);
}

/* Prints a ball; false: no memory. */
static bool print(const ball *x, long precision)
{
    char *text = ball_get_decimal(x, 25);
    if (!text)
        return false;
    printf("%4ld bits: %s\n", precision, text);
    free(text);
    return true;
}

int main(void)
{
    bool printed = true, known = false;
    ball f;
    ball_init(&f);
    /* Balls never fail: what cannot be said, for lack of precision or of memory, is an enclosure that says less. */
    for (long precision = 64; printed && !known && precision <= 4096; precision *= 2) {
        rump(&f, precision);
        printed = print(&f, precision);
        known = ball_is_negative(&f) != TRUTH_UNKNOWN && ball_accuracy_bits_approx(&f) > 80;
    }
    if (known)
        printf("proved: %s\n", ball_is_negative(&f) == TRUTH_TRUE ? "negative" : "not negative");
    ball_clear(&f);
    return known ? EXIT_SUCCESS : EXIT_FAILURE;
}
