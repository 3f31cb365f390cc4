/* t-survey.c: what is proved of ranges of blocks against the list of all blocks. */
#include "verify/spectrum_list.h"

#include <math.h>

#include "bigfloat/interval.h"
#include "tests/lib/common.h"

typedef status lister(spectrum_list *, const scheme *, long, int, long, diagnostic *);
typedef status surveyor(spectrum_list *, const scheme *, long, int, long, bool, diagnostic *);

static bool has_entries(const spectrum_list *l, long m)
{
    for (size_t i = 0; i < l->count; i++)
        if (l->entry[i].m == m)
            return true;
    return false;
}

static double range_of(const spectrum_list *l, long m)
{
    for (size_t i = 0; i < l->ranges; i++)
        if (l->range[i].m.first <= m && m <= l->range[i].m.last)
            return l->range[i].upper;
    return -1;
}

/* The largest modulus of block m, at most; without 1 in block 0. */
static double largest_upper(const spectrum_list *l, long m)
{
    double largest = 0;
    long one = spectrum_find_one(l);
    for (size_t i = 0; i < l->count; i++)
        if (l->entry[i].m == m && (long)i != one)
            largest = fmax(largest, l->entry[i].modulus_upper);
    return largest;
}

static void compare(const spectrum_list *survey, const spectrum_list *all, const char *name, long k, bool order)
{
    double top = largest_upper(survey, survey->top);
    CHECK(survey->top >= 0 && survey->ordered == order, "%s, k = %ld: ordered %d, top %ld, open %ld to %ld", name, k, survey->ordered, survey->top, survey->open.first, survey->open.last);
    for (long m = 0; m <= k / 2; m++)
        CHECK(has_entries(survey, m) != (range_of(survey, m) >= 0), "%s, k = %ld: block %ld has not either entries or a range", name, k, m);
    for (size_t i = 0; i < all->count; i++) {
        const spectrum_entry *e = &all->entry[i];
        if ((long)i == spectrum_find_one(all))
            continue;
        if (e->m != 0 && survey->ordered && e->m != survey->top)
            CHECK(e->modulus_lower <= top, "%s, k = %ld: block %ld beats the top, %ld", name, k, e->m, survey->top);
        if (has_entries(survey, e->m))
            continue;
        CHECK(e->modulus_lower <= range_of(survey, e->m), "%s, k = %ld: block %ld, %.12g, exceeds its range", name, k, e->m, e->modulus_lower);
        if (survey->ordered)
            CHECK(e->modulus_lower <= fmax(survey->rest_upper, fmax(largest_upper(survey, survey->top + 1), fmax(0, survey->top > 1 ? largest_upper(survey, survey->top - 1) : 0))),
                  "%s, k = %ld: block %ld, %.12g, exceeds the bound of the rest", name, k, e->m, e->modulus_lower);
    }
}

static void check(const char *name, long k, bool order, lister *list, surveyor *survey, long prec)
{
    scheme s;
    spectrum_list all, some;
    diagnostic d = {0, 0, ""};
    spectrum_list_init(&all);
    spectrum_list_init(&some);
    read_scheme(&s, catalogue_text(name));
    CHECK(list(&all, &s, k, 15, prec, &d) == STATUS_OK, "%s: %s", name, d.text);
    CHECK(survey(&some, &s, k, 15, prec, true, &d) == STATUS_OK, "%s: %s", name, d.text);
    compare(&some, &all, name, k, order);
    spectrum_list_clear(&all);
    spectrum_list_clear(&some);
    scheme_clear(&s);
}

static void test_survey(void)
{
    static const char *const names[] = {"loop", "loop-warren", "loop-ring", "loop-spiral", "butterfly", "modified-butterfly", "catmull-clark", "doo-sabin", "doo-sabin-spectrum", "midpoint", "wave", "wave-valence"};
    test_begin("survey-and-list");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (long k = 30; k <= 200; k = k * 2 + 1)
            check(names[i], k, true, spectrum_list_make_interval, spectrum_survey_interval, 53);
    check("modified-loop", 61, true, spectrum_list_make_interval, spectrum_survey_interval, 53);
    check("kobbelt", 40, true, spectrum_list_make_interval, spectrum_survey_interval, 53);
    test_end();
    test_begin("survey-and-list-balls");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        check(names[i], 61, true, spectrum_list_make_ball, spectrum_survey_ball, 128);
    test_end();
}

/* Two blocks share the largest eigenvalue: nothing can be in order. */
static void test_tie(void)
{
    static const char text[] = "scheme tie\nmesh quad-dual\ndilation 2\nvertices interior\nmask symmetric\n(1/2,1/2) 9/16\n(1/2,3/2) 3/16\n(3/2,3/2) 1/16\nend\n"
                               "rule (1/2,1/2)\n(1/2,1/2) spectrum cases(m = 0: 1; m = 1 or m = 9: 1/2; else: 1/4)\nend\n";
    scheme s;
    spectrum_list l, all;
    diagnostic d;
    test_begin("survey-tie");
    spectrum_list_init(&l);
    spectrum_list_init(&all);
    read_scheme(&s, text);
    CHECK(spectrum_survey_ball(&l, &s, 40, 15, 128, true, &d) == STATUS_OK, "status");
    CHECK(!l.ordered && (l.top == 1 || l.top == 9), "ordered %d, top %ld", l.ordered, l.top);
    CHECK(l.top != 1 || (l.open.first <= 9 && l.open.last >= 9), "open %ld to %ld", l.open.first, l.open.last);
    CHECK(spectrum_list_make_ball(&all, &s, 40, 15, 128, &d) == STATUS_OK, "list");
    compare(&l, &all, "tie", 40, false);
    spectrum_list_clear(&l);
    spectrum_list_clear(&all);
    scheme_clear(&s);
    test_end();
}

/* The largest eigenvalue, near block k / 5.19, and the next differ by 10^-18: doubles cannot tell. */
static void test_close(void)
{
    scheme s;
    spectrum_list l;
    diagnostic d;
    test_begin("survey-too-close");
    spectrum_list_init(&l);
    read_scheme(&s, catalogue_text("butterfly"));
    CHECK(spectrum_survey_interval(&l, &s, 1000000000, 15, 53, false, &d) == STATUS_OK, "status");
    CHECK(!l.ordered && l.open.first <= l.top + 1 && l.open.last >= l.top - 1, "ordered %d, open %ld to %ld", l.ordered, l.open.first, l.open.last);
    spectrum_list_clear(&l);
    scheme_clear(&s);
    test_end();
}

int main(void)
{
    test_survey();
    test_tie();
    test_close();
    return test_status();
}
