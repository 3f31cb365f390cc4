/* t-numbers.c: good certificates with one number edited, or all numbers of a line (numbers.h), given to the checker as a
   program, with the right count of records and the right hash and with the claim of the good one.

   The checker must answer, and what it accepts must be true (judge.h).  Here a sample is tried, another one for each seed: each
   edit of the lines `contraction` and `stability`, whose proofs the checker remembers, once for each such line that some certificate
   has; and of the lines of each name, somewhere, each kind of edit, twice.  After the argument --all all edits are tried.  More
   arguments are parts of names: of such certificates only.

   SMOOTHCERT_CHECK is the checker, SRCDIR the sources.  The certificate of a failure stays in ./edited. */
#include "tests/certificates/judge.h"
#include "tests/certificates/numbers.h"
#include "tests/verify/common.h"

enum { OF_EACH_SORT = 2 };

static corpus bases;
static choice_of_bases chosen;
static opinion opinions[MAX_BASES]; /* of the claims of those that are chosen */

/* ---- all edits ---- */

typedef struct {
    int base;        /* of those that are chosen */
    number_edit edit;
    bool always;     /* in the sample */
} candidate;

static struct {
    candidate *at;
    int count;
    int always;      /* how many are always in the sample: the first ones */
    int *sort;       /* where each sort of the others begins (a name of lines, a kind of edit, whether of whole lines), and the end */
    int sorts;
} all;

static const char *line_of(const candidate *c)
{
    return chosen.base[c->base]->body.line[c->edit.line];
}

static int compare_names(const char *x, const char *y)
{
    int length[2] = {(int)strcspn(x, " "), (int)strcspn(y, " ")};
    int by_letters = memcmp(x, y, (size_t)(length[0] < length[1] ? length[0] : length[1]));
    return by_letters ? by_letters : length[0] - length[1];
}

static int compare_sorts(const candidate *x, const candidate *y)
{
    int by_always = y->always - x->always, by_kind = (int)x->edit.kind - (int)y->edit.kind;
    int by_place = (x->edit.place == WHOLE_LINE) - (y->edit.place == WHOLE_LINE);
    int by_name = compare_names(line_of(x), line_of(y));
    return by_always ? by_always : by_name ? by_name : by_kind ? by_kind : by_place;
}

static int compare_candidates(const void *a, const void *b)
{
    const candidate *x = a, *y = b;
    int by_sort = compare_sorts(x, y), by_base = x->base - y->base, by_line = x->edit.line - y->edit.line;
    return by_sort ? by_sort : by_base ? by_base : by_line ? by_line : x->edit.place - y->edit.place;
}

static void *more_memory(void *old, size_t count, size_t size)
{
    void *more = realloc(old, (count + 1) * size);
    if (!more)
        abort();
    return more;
}

/* A line of the regular part that no certificate before this one has. */
static bool is_new_regular_part(int from, const char *line)
{
    bool is_new = line_has_name(line, "contraction") || line_has_name(line, "stability");
    for (int i = 0; is_new && i < from; i++)
        for (int j = 0; is_new && j < chosen.base[i]->body.count; j++)
            is_new = strcmp(chosen.base[i]->body.line[j], line) != 0;
    return is_new;
}

static void collect_edits_of(int from)
{
    number_edits e;
    number_edits_make(&e, &chosen.base[from]->body);
    all.at = more_memory(all.at, (size_t)(all.count + e.count), sizeof *all.at);
    for (int i = 0; i < e.count; i++) {
        candidate *c = &all.at[all.count++];
        *c = (candidate){from, e.edit[i], false};
        c->always = is_new_regular_part(from, line_of(c));
    }
    number_edits_clear(&e);
}

static void collect_edits(void)
{
    for (int i = 0; i < chosen.count; i++) {
        collect_edits_of(i);
        opinion_init(&opinions[i], chosen.base[i]->k);
    }
    qsort(all.at, (size_t)all.count, sizeof *all.at, compare_candidates);
    while (all.always < all.count && all.at[all.always].always)
        all.always++;
}

static void find_sorts(void)
{
    for (int i = all.always; i <= all.count; i++)
        if (i == all.always || i == all.count || compare_sorts(&all.at[i - 1], &all.at[i]) != 0) {
            all.sort = more_memory(all.sort, (size_t)all.sorts, sizeof *all.sort);
            all.sort[all.sorts++] = i;
        }
    all.sorts--;
}

static void forget_edits(void)
{
    for (int i = 0; i < chosen.count; i++)
        opinion_clear(&opinions[i]);
    free(all.at);
    free(all.sort);
}

/* First those that always are in it, then a random one of each sort in turn. */
static const candidate *sample(long number)
{
    long sort = (number - all.always) % all.sorts;
    if (number < all.always)
        return &all.at[number];
    return &all.at[random_range(all.sort[sort], all.sort[sort + 1] - 1)];
}

/* ---- one of them ---- */

static void make_certificate(buffer *z, const base *b, number_edit e, const char *line)
{
    lines edited;
    lines_read(&edited, b->whole, "records ");
    lines_replace(&edited, e.line, line);
    lines_write(z, &edited);
    lines_clear(&edited);
    seal(z);
    write_file("edited", z->bytes, z->length);
}

static void try_edit(const candidate *c, long answers[3])
{
    static char line[1 << 16];
    const base *b = chosen.base[c->base];
    trial t = {.from = b, .k = b->k};
    buffer_init(&t.certificate);
    number_edit_apply(line, sizeof line, line_of(c), c->edit);
    make_certificate(&t.certificate, b, c->edit, line);
    ask_checker(&t.answer, b, NULL, t.k, "edited");
    judge_answer(&t);
    if (t.answer.status >= 0 && t.answer.status <= 2)
        answers[t.answer.status]++;
    if (t.answer.status == 0 && !test_failed())
        judge_accepted(&t, &opinions[c->base]);
    if (test_failed())
        printf("%s: %.300s\n   edited: %.300s\n", b->name, line_of(c), line);
    buffer_clear(&t.certificate);
}

int main(int argc, char **argv)
{
    bool whole = argc > 1 && strcmp(argv[1], "--all") == 0;
    long answers[3] = {0, 0, 0};
    test_begin(whole ? "numbers, all of them" : "numbers");
    corpus_read_all(&bases);
    corpus_choose(&chosen, &bases, (const char *const *)argv + 1 + whole);
    collect_edits();
    find_sorts();
    for (test_cases(whole ? all.count : all.always + OF_EACH_SORT * all.sorts); all.count > 0 && test_next();)
        try_edit(whole ? &all.at[test_case_number() % all.count] : sample(test_case_number()), answers);
    printf("%ld edits, of %d: %ld accepted, %ld rejected, %ld cannot be checked\n", answers[0] + answers[1] + answers[2], all.count, answers[0], answers[1], answers[2]);
    if (argc == 1 && !getenv("SMOOTHCERT_CASE"))
        CHECK(answers[0] && answers[1] && answers[2], "the edits do not reach every answer");
    test_end();
    forget_edits();
    return test_status();
}
