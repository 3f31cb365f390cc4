/* t-valence_list.c: lists of valences. */
#include "verify/valence_list.h"

#include "common.h"

#include <limits.h>

#include "verify/choices.h"

/* The list as it is read, in the form "3 4 7"; a complaint as "!". */
static void describe(char *text, size_t size, const char *list)
{
    valence_list v;
    const char *complaint = valence_list_read(&v, list);
    size_t at = 0;
    text[0] = '\0';
    if (complaint) {
        CHECK(v.count == 0, "'%s' is refused, but %ld valences are left", list, v.count);
        CHECK(complaint[0] != '\0', "'%s' is refused without a reason", list);
        snprintf(text, size, "!");
    }
    for (long i = 0; i < v.count && at < size; i++)
        at += (size_t)snprintf(text + at, size - at, i ? " %ld" : "%ld", valence_list_get(&v, i));
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
    test_begin("valence-list-good");
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        describe(text, sizeof text, good[i][0]);
        CHECK(!strcmp(text, good[i][1]), "'%s' is read as '%s', not as '%s'", good[i][0], text, good[i][1]);
    }
    test_end();
}

/* Ranges after sorting and merging. */
static void test_ranges(void)
{
    static const struct {
        const char *list;
        long count;
        int ranges;
        long first, last; /* of the last range */
    } cases[] = {
        {"all", LONG_MAX, 1, 3, VALENCES_UNBOUNDED},
        {"3..inf", LONG_MAX, 1, 3, VALENCES_UNBOUNDED},
        {"8..inf,5", LONG_MAX, 2, 8, VALENCES_UNBOUNDED},
        {"8..inf,7", LONG_MAX, 1, 7, VALENCES_UNBOUNDED},
        {"8..inf,100..inf,200,7..9", LONG_MAX, 1, 7, VALENCES_UNBOUNDED},
        {"all,1000000000", LONG_MAX, 1, 3, VALENCES_UNBOUNDED},
        {"3..1000000000", 999999998, 1, 3, 1000000000},
    };
    test_begin("valence-list-ranges");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        valence_list v;
        const char *complaint = valence_list_read(&v, cases[i].list);
        CHECK(!complaint, "'%s': %s", cases[i].list, complaint);
        CHECK(v.count == cases[i].count && v.ranges == cases[i].ranges, "'%s': %ld valences in %d ranges", cases[i].list, v.count, v.ranges);
        CHECK(v.ranges > 0 && v.range[v.ranges - 1].first == cases[i].first && v.range[v.ranges - 1].last == cases[i].last, "'%s' ends with another range", cases[i].list);
    }
    test_end();
}

static void test_bad_lists(void)
{
    static const char *const bad[] = {
        "", " ", ",", "3,", ",3", "3,,4", "..", "3..", "..5", "3...5", "3.5", "3..5..7", "5..4", "2", "0", "1..3", "2..5", "-3", "+3",
        " 3", "3 ", "3, 4", "3 4", "3;4", "3-5", "3..5x", "x", "inf", "inf..8", "8..infx", "allx", "all..5", "8..all", "2..inf", "1000000001..inf", "All", "8..in", "0x10", "1e2", "1000000001", "3..1000000001", "99999999999999999999",
        "18446744073709551619", "4294967299", "3..18446744073709551619", "18446744073709551619..20", "3\n",
    };
    char text[128];
    test_begin("valence-list-bad");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        describe(text, sizeof text, bad[i]);
        CHECK(!strcmp(text, "!"), "'%s' is read as '%s'", bad[i], text);
    }
    test_end();
}

int main(void)
{
    test_lists();
    test_ranges();
    test_bad_lists();
    return test_status();
}
