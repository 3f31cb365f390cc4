/* numbers.c: see numbers.h. */
#include "tests/certificates/numbers.h"

#include "tests/harness.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_LINE = 1 << 16, MAX_NUMBER = 4096 };

/* ---- one edit ---- */

/* `-`, `inf` and names of forms and reasons are none. */
static bool is_number(const char *line, int place, const char *word)
{
    const char *digits = word + (*word == '-');
    return *digits && strspn(digits, number_is_decimal(line, place) ? "0123456789" : "0123456789abcdef") == strlen(digits);
}

static void edit_number(char *out, size_t size, const char *number, bool decimal, edit_kind kind)
{
    switch (kind) {
    case TO_ZERO:
    case TO_ONE:
        snprintf(out, size, kind == TO_ZERO ? "0" : "1");
        break;
    case NEGATED:
        number_negate(out, size, number);
        break;
    default:
        number_next(out, size, number, decimal, kind == ONE_LESS);
    }
}

void number_edit_apply(char *out, size_t size, const char *line, number_edit e)
{
    static char copy[MAX_LINE], changed[MAX_NUMBER];
    char *word[MAX_TOKENS];
    size_t used = 0;
    int count;
    snprintf(copy, sizeof copy, "%s", line);
    count = split_line(word, copy);
    for (int i = 0; i < count && used < size; i++) {
        bool chosen = i > 0 && (e.place == WHOLE_LINE || i == e.place) && is_number(line, i, word[i]);
        if (chosen)
            edit_number(changed, sizeof changed, word[i], number_is_decimal(line, i), e.kind);
        used += (size_t)snprintf(out + used, size - used, "%s%s", i ? " " : "", chosen ? changed : word[i]);
    }
}

/* ---- all edits ---- */

static void append_edit(number_edits *z, number_edit e)
{
    if ((z->count & (z->count - 1)) == 0) {
        number_edit *more = realloc(z->edit, (size_t)(z->count ? 2 * z->count : 1) * sizeof *more);
        if (!more)
            abort();
        z->edit = more;
    }
    z->edit[z->count++] = e;
}

/* Unless the line stays the same, or becomes what another edit of this place has made of it. */
static void try_kinds(number_edits *z, const char *line, int at, int place, edit_kind end)
{
    static char made[EDIT_KINDS][MAX_LINE];
    for (edit_kind kind = TO_ZERO; kind < end; kind++) {
        number_edit e = {at, place, kind};
        bool is_new;
        number_edit_apply(made[kind], MAX_LINE, line, e);
        is_new = strcmp(made[kind], line) != 0;
        for (edit_kind earlier = TO_ZERO; earlier < kind; earlier++)
            is_new = is_new && strcmp(made[kind], made[earlier]) != 0;
        if (is_new)
            append_edit(z, e);
    }
}

/* Which of n things is the i-th of those that are chosen: the first, the last, and one in each of as many equal parts of the
   others as are still wanted. */
static int choose(int i, int n)
{
    long begin = 1 + (long)(i - 1) * (n - 2) / (MOST - 2), end = 1 + (long)i * (n - 2) / (MOST - 2);
    if (n <= MOST || i == 0)
        return i;
    return i == MOST - 1 ? n - 1 : (int)random_range(begin, end - 1);
}

static int chosen_count(int n)
{
    return n < MOST ? n : MOST;
}

static void edit_one_line(number_edits *z, const char *line, int at)
{
    static char copy[MAX_LINE];
    char *word[MAX_TOKENS];
    int place[MAX_TOKENS], count, numbers = 0;
    snprintf(copy, sizeof copy, "%s", line);
    count = split_line(word, copy);
    for (int i = 1; i < count; i++)
        if (is_number(line, i, word[i]))
            place[numbers++] = i;
    if (numbers > 1)
        try_kinds(z, line, at, WHOLE_LINE, NEGATED);
    for (int i = 0; i < chosen_count(numbers); i++)
        try_kinds(z, line, at, place[choose(i, numbers)], EDIT_KINDS);
}

static bool is_edited(const char *line) /* trees are not */
{
    static const char *const names[] = {"regularity", "boundary"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (line_has_name(line, names[i]))
            return false;
    return true;
}

/* How many lines from `at` on have the same name. */
static int run_length(const lines *x, int at)
{
    char name[64];
    int end = at;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(x->line[at], " "), x->line[at]);
    while (end < x->count && line_has_name(x->line[end], name))
        end++;
    return end - at;
}

void number_edits_make(number_edits *z, const lines *certificate)
{
    int run;
    z->edit = NULL;
    z->count = 0;
    for (int at = lines_find(certificate, "valence") + 1; at < certificate->count; at += run) {
        run = run_length(certificate, at);
        for (int i = 0; i < chosen_count(run) && is_edited(certificate->line[at]); i++) {
            int chosen = at + choose(i, run);
            edit_one_line(z, certificate->line[chosen], chosen);
        }
    }
}

void number_edits_clear(number_edits *z)
{
    free(z->edit);
    z->edit = NULL;
    z->count = 0;
}
