/* What the checker's unit tests share: one line on stdout for each test, PASS or FAIL, and random numbers that are
 * the same in every run. */

#ifndef TESTS_CHECK_PROTOCOL_H
#define TESTS_CHECK_PROTOCOL_H

#include <stdint.h>
#include <stdio.h>

static const char *test_name;
static char reason[256];
static int failures;

static void begin(const char *name)
{
    test_name = name;
    reason[0] = '\0';
}

/* The first expectation that fails is the reason. */
#define EXPECT(condition)                                                      \
    do {                                                                       \
        if (!(condition) && reason[0] == '\0')                                 \
            snprintf(reason, sizeof reason, "line %d: %s", __LINE__, #condition); \
    } while (0)

static void end(void)
{
    if (reason[0] == '\0') {
        printf("PASS %s\n", test_name);
    } else {
        printf("FAIL %s: %s\n", test_name, reason);
        failures++;
    }
    fflush(stdout);
}

static uint64_t random_state = 88172645463325252u;

static inline uint32_t random_word(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (uint32_t)(random_state >> 32);
}

#endif
