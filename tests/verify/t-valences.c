/* t-valences.c: lists of valences. */
#include "verify/valences.h"

#include "common.h"
#include "verify/choices.h"

/* The list as it is read, in the form "3 4 7"; a complaint as "!". */
static void describe(char *text, size_t size, const char *list)
{
    valences v;
    const char *complaint = valences_read(&v, list);
    size_t at = 0;
    text[0] = '\0';
    if (complaint) {
        CHECK(v.count == 0, "'%s' is refused, but %ld valences are left", list, v.count);
        CHECK(complaint[0] != '\0', "'%s' is refused without a reason", list);
        snprintf(text, size, "!");
    }
    for (long i = 0; i < v.count && at < size; i++)
        at += (size_t)snprintf(text + at, size - at, i ? " %ld" : "%ld", valences_get(&v, i));
}

static void test_lists(void)
{
    static const char *const good[][2] = {
        {"7", "7"},
        {"3", "3"},
        {"4096", "4096"},
        {"3..5", "3 4 5"},
        {"3..3", "3"},
        {"3..5,50", "3 4 5 50"},
        {"50,3..5", "3 4 5 50"},
        {"5,4,3", "3 4 5"},
        {"5,5,5", "5"},
        {"3..6,5..8", "3 4 5 6 7 8"},
        {"4094..4096", "4094 4095 4096"},
        {"3..5,6..7", "3 4 5 6 7"},
        {"9,3..4,4..5", "3 4 5 9"},
        {"999999999..1000000000", "999999999 1000000000"},
    };
    char text[128];
    test_begin("valences-lists");
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        describe(text, sizeof text, good[i][0]);
        CHECK(!strcmp(text, good[i][1]), "'%s' is read as '%s', not as '%s'", good[i][0], text, good[i][1]);
    }
    test_end();
}

static void test_all(void)
{
    valences v;
    test_begin("valences-all");
    CHECK(!valences_read(&v, "3..100002"), "3..100002 is refused");
    CHECK(v.count == VALENCES_MAX, "3..100002 are %ld valences", v.count);
    for (long i = 0; i < v.count; i++)
        CHECK(valences_get(&v, i) == CHOICES_MIN_VALENCE + i, "valence %ld at place %ld", valences_get(&v, i), i);
    CHECK(valences_read(&v, "3..100003"), "too many valences are read");
    test_end();
}

static void test_bad_lists(void)
{
    static const char *const bad[] = {
        "", " ", ",", "3,", ",3", "3,,4", "..", "3..", "..5", "3...5", "3.5", "3..5..7", "5..4", "2", "0", "1..3", "2..5", "-3", "+3",
        " 3", "3 ", "3, 4", "3 4", "3;4", "3-5", "3..5x", "x", "all", "inf", "8..inf", "0x10", "1e2", "1000000001", "3..1000000001", "99999999999999999999",
        "18446744073709551619", "4294967299", "3..18446744073709551619", "18446744073709551619..20", "3\n",
    };
    char text[128];
    test_begin("valences-bad-lists");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        describe(text, sizeof text, bad[i]);
        CHECK(!strcmp(text, "!"), "'%s' is read as '%s'", bad[i], text);
    }
    test_end();
}

int main(void)
{
    test_lists();
    test_all();
    test_bad_lists();
    return test_status();
}
