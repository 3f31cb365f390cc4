/* harness.c: see harness.h. */
#include "harness.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static struct {
    const char *name;
    char reason[1024];
    bool failed, skipped, in_cases;
    long number, rounds, only;
    uint64_t seed, state;
    double until;
    int failures;
} now;

static double seconds(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double environment(const char *name, double otherwise)
{
    const char *text = getenv(name);
    return text && *text ? strtod(text, NULL) : otherwise;
}

static void reseed(long number)
{
    uint64_t h = now.seed * 0x9e3779b97f4a7c15u;
    for (const char *c = now.name; *c; c++)
        h = (h ^ (uint64_t)(unsigned char)*c) * 0x100000001b3u;
    now.state = h ^ ((uint64_t)number * 0xd1342543de82ef95u);
    random_word();
}

void test_begin(const char *name)
{
    const char *seed = getenv("SMOOTHCERT_SEED");
    now.name = name;
    now.reason[0] = 0;
    now.failed = now.skipped = now.in_cases = false;
    now.number = 0;
    now.seed = seed ? strtoull(seed, NULL, 0) : 1;
    now.only = (long)environment("SMOOTHCERT_CASE", -1);
    reseed(0);
}

void test_end(void)
{
    if (now.failed) {
        now.failures++;
        printf("FAIL %s: %s\n", now.name, now.reason);
    } else if (now.skipped)
        printf("SKIP %s: %s\n", now.name, now.reason);
    else
        printf("PASS %s\n", now.name);
    fflush(stdout);
}

void test_skip(const char *reason)
{
    if (now.failed)
        return;
    now.skipped = true;
    snprintf(now.reason, sizeof now.reason, "%s", reason);
}

int test_status(void) { return now.failures ? 1 : 0; }

void test_cases(long rounds)
{
    double budget = environment("SECONDS_PER_TEST", 0);
    now.rounds = (long)((double)rounds * environment("SMOOTHCERT_ROUNDS", 1));
    if (now.rounds < 1)
        now.rounds = 1;
    now.until = budget > 0 ? seconds() + budget : 0;
    now.number = now.only >= 0 ? now.only - 1 : -1;
    now.in_cases = true;
}

static bool time_is_left(void)
{
    return now.until > 0 ? seconds() < now.until : now.number < now.rounds;
}

bool test_next(void)
{
    now.number++;
    if (now.failed || (now.only >= 0 ? now.number > now.only : !time_is_left())) {
        now.in_cases = false;
        return false;
    }
    reseed(now.number);
    return true;
}

long test_case_number(void) { return now.number; }
bool test_failed(void) { return now.failed; }

void test_fail(const char *file, int line, const char *format, ...)
{
    if (now.failed)
        return;
    now.failed = true;
    const char *slash = strrchr(file, '/');
    size_t n = (size_t)snprintf(now.reason, sizeof now.reason, "%s:%d: ", slash ? slash + 1 : file, line);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(now.reason + n, sizeof now.reason - n, format, arguments);
    va_end(arguments);
    n = strlen(now.reason);
    if (now.in_cases)
        snprintf(now.reason + n, sizeof now.reason - n, " (SMOOTHCERT_SEED=%llu SMOOTHCERT_CASE=%ld)",
                 (unsigned long long)now.seed, now.number);
    for (char *c = now.reason; *c; c++)
        if (*c == '\n')
            *c = ' ';
}

uint64_t random_word(void)
{
    uint64_t z = now.state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

uint64_t random_below(uint64_t n) { return random_word() % n; }
long random_range(long a, long b) { return a + (long)random_below((uint64_t)(b - a) + 1); }
bool random_bool(void) { return random_word() >> 63; }

uint64_t random_corner(void)
{
    uint64_t w = random_word();
    switch (random_below(8)) {
    case 0: return 0;
    case 1: return ~(uint64_t)0;
    case 2: return (uint64_t)1 << (w % 64);
    case 3: return ((uint64_t)1 << (w % 64)) - 1;
    case 4: return ~(uint64_t)0 << (w % 64);
    case 5: return w >> (w % 64);
    case 6: return (w % 5) - 2;
    default: return w;
    }
}

void random_limbs(uint64_t *z, size_t n)
{
    bool corners = random_bool();
    for (size_t i = 0; i < n; i++)
        z[i] = corners ? random_corner() : random_word();
}
