/* t-text.c: balls, intervals and grids as text: decimals enclose in both directions, the exact form is exact. */
#include <stdlib.h>
#include <string.h>

#include "random.h"

/* What the text says contains x, by reading it back with many bits. */
static void check_encloses(const ball *x, char *text, const char *name)
{
    ball y;
    ball_init(&y);
    CHECK(text, "no memory");
    CHECK(ball_set_str(&y, text, strlen(text), 4000) == RATIONAL_TEXT_OK, "%s: cannot read '%s'", name, text);
    CHECK(ball_contains(&y, x), "%s: '%s' does not enclose", name, text);
    ball_clear(&y);
}

static void test_decimals(void)
{
    test_begin("text-decimals");
    for (test_cases(2000); test_next();) {
        ball x, y;
        ball_init(&x), ball_init(&y);
        random_ball(&x, random_below(10) ? 3 : 20);
        int digits = (int)random_range(-1, 60);
        char *text = ball_get_decimal(&x, digits);
        check_encloses(&x, text, "get_decimal");
        free(text);
        text = ball_get_str(&x);
        check_encloses(&x, text, "get_str");
        if (x.error == 0) {
            CHECK(!strstr(text, "+/-"), "exact: %s", text);
            CHECK(ball_set_str(&y, text, strlen(text), 8000) == RATIONAL_TEXT_OK && ball_contains(&x, &y), "exact: %s", text);
        } else if (strstr(text, "+/-")) { /* at most twice the error */
            CHECK(ball_set_str(&y, text, strlen(text), 4000) == RATIONAL_TEXT_OK, "%s", text);
            ball twice;
            ball_init(&twice);
            ball_set(&twice, &x);
            twice.error = 2 * x.error + 1;
            CHECK(ball_contains(&twice, &y), "'%s' is too wide", text);
            ball_clear(&twice);
        }
        free(text);
        ball_clear(&x), ball_clear(&y);
    }
    test_end();
}

static void test_exact_form(void)
{
    test_begin("text-exact-form");
    ball x, y;
    ball_init(&x), ball_init(&y);
    for (test_cases(2000); test_next();) {
        random_ball(&x, 6);
        ball_mul_2exp(&x, &x, random_bool() ? 0 : random_range(-1000000000, 1000000000), 10000);
        char *text = ball_get_hex(&x);
        CHECK(text && ball_set_hex(&y, text, strlen(text)) == RATIONAL_TEXT_OK && ball_identical(&x, &y), "%s", text);
        free(text);
        text = ball_get_decimal(&x, 20);
        CHECK(text, "decimal of a far exponent");
        free(text);
    }
    static const char *bad[] = {"", "0x1", "0x1 0x2", "0x1 0x2 3 ", "1 0x2 3", "0x1 -0x2 3", "0x1 0x80000000 0", "0x 0x1 0",
                                "0x1 0x1 x", "0x1  0x1 0", "0x1 0x1 99999999999999", "0x-1 0x0 0"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        CHECK(ball_set_hex(&y, bad[i], strlen(bad[i])) == RATIONAL_TEXT_MALFORMED, "accepted '%s'", bad[i]);
    ball_indeterminate(&x);
    char *text = ball_get_hex(&x), *decimal = ball_get_decimal(&x, 5), *shortest = ball_get_str(&x);
    CHECK(!strcmp(text, "indeterminate") && !strcmp(decimal, text) && !strcmp(shortest, text), "indeterminate");
    CHECK(ball_set_hex(&y, text, strlen(text)) == RATIONAL_TEXT_OK && !ball_is_finite(&y), "indeterminate");
    CHECK(ball_set_str(&y, text, strlen(text), 64) == RATIONAL_TEXT_OK && !ball_is_finite(&y), "indeterminate");
    free(text), free(decimal), free(shortest);
    ball_clear(&x), ball_clear(&y);
    test_end();
}

/* Decimals come in within one unit in the last place, and known texts go out as expected. */
static void test_known(void)
{
    test_begin("text-known");
    static const struct {
        const char *in, *out;
    } known[] = {{"0", "0"}, {"1.5", "1.5"}, {"-12e3", "-12000"}, {"0.25 +/- 0.125", "0.25 +/- 0.13"}, {"1e-10 +/- 0", "1e-10"},
                 {"123456789", "123456789"}};
    ball x;
    ball_init(&x);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        CHECK(ball_set_str(&x, known[i].in, strlen(known[i].in), 64) == RATIONAL_TEXT_OK, "%s", known[i].in);
    CHECK(ball_set_str(&x, "0.1", 3, 128) == RATIONAL_TEXT_OK && x.error == 1 && ball_accuracy_bits_approx(&x) >= 127, "0.1");
    CHECK(ball_set_str(&x, "1.5", 3, 64) == RATIONAL_TEXT_OK && ball_is_thin(&x), "1.5 is exact");
    char *text = ball_get_decimal(&x, 10);
    CHECK(!strcmp(text, "1.5"), "1.5 is '%s'", text);
    free(text);
    ball_pi(&x, 64);
    text = ball_get_decimal(&x, 6);
    CHECK(!strncmp(text, "3.14159 +/- 2.", 14), "pi is '%s'", text);
    free(text);
    static const char *bad[] = {"", "1 +/- ", "+/- 1", "1 +/- 2 +/- 3", "x", "1 +- 2"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        CHECK(ball_set_str(&x, bad[i], strlen(bad[i]), 64) == RATIONAL_TEXT_MALFORMED, "accepted '%s'", bad[i]);
    ball_clear(&x);
    test_end();
}

static void test_others(void)
{
    test_begin("text-other-systems");
    for (test_cases(500); test_next();) {
        interval u;
        grid g;
        ball x, y;
        grid_init(&g);
        ball_init(&x), ball_init(&y);
        random_interval(&u);
        char *text = interval_get_decimal(&u, 17);
        if (interval_is_finite(&u)) {
            ball_set_double(&x, interval_lower_bound(&u), 64), ball_set_double(&y, interval_upper_bound(&u), 64);
            check_encloses(&x, text, "interval");
            check_encloses(&y, text, "interval");
        } else
            CHECK(!strcmp(text, "indeterminate"), "%s", text);
        free(text);
        random_grid(&g, 2, random_range(-20, 100));
        text = grid_get_decimal(&g, 30);
        ball_set_integer_2exp(&x, &g.lower, -g.exponent, 1000), ball_set_integer_2exp(&y, &g.upper, -g.exponent, 1000);
        check_encloses(&x, text, "grid");
        check_encloses(&y, text, "grid");
        free(text);
        grid_clear(&g);
        ball_clear(&x), ball_clear(&y);
    }
    test_end();
}

int main(void)
{
    test_decimals();
    test_exact_form();
    test_known();
    test_others();
    return test_status();
}
