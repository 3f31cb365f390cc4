/* harness.h: what every test program shares.

   A program is a list of test functions.  Each prints one line on stdout, `PASS name`, `FAIL name: reason` or
   `SKIP name: reason`, and the program exits 0 iff no line says FAIL.  Random tests repeat their body
   test_rounds() times; the generator is seeded anew for every case from (seed, test name, case number), so that
   the reason of a failure names what repeats it:

       SMOOTHCERT_SEED=s SMOOTHCERT_CASE=c ./program

   Environment: SMOOTHCERT_SEED (default 1), SMOOTHCERT_ROUNDS (a factor for the number of rounds, default 1),
   SECONDS_PER_TEST (if set, random tests run that long instead), SMOOTHCERT_CASE (only that case). */
#ifndef TESTS_HARNESS_H
#define TESTS_HARNESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

void test_begin(const char *name);
void test_end(void);
/* The current test is skipped unless it has failed already. */
void test_skip(const char *reason);
/* At the end of main: return test_status(); */
int test_status(void);

/* for (test_cases(1000); test_next();) { ... }  runs the body for each case, until the first failure. */
void test_cases(long rounds);
bool test_next(void);
long test_case_number(void);
bool test_failed(void);

void test_fail(const char *file, int line, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Records the first failure of the current test; later ones are ignored. */
#define CHECK(condition, ...)                                     \
    do {                                                          \
        if (!(condition))                                         \
            test_fail(__FILE__, __LINE__, __VA_ARGS__);           \
    } while (0)

/* ---- random numbers (splitmix64) ---- */

uint64_t random_word(void);
uint64_t random_below(uint64_t n);       /* 0 .. n - 1; n > 0 */
long random_range(long a, long b);       /* a .. b */
bool random_bool(void);
/* A word with corners: often 0, 1, all ones, a power of two, long runs of equal bits. */
uint64_t random_corner(void);
/* n such words. */
void random_limbs(uint64_t *z, size_t n);

#endif
