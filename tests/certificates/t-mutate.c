/* t-mutate.c: random mutants of good certificates, given to the checker as a program.

   None may crash it or keep it busy for long, and whatever it accepts must be true: the prover must come to the same
   verdict by itself, with an eigenvalue in what the checker printed, and follow the mutant's own choices on its grid as
   well as on a finer one; of several valences the verdict is asked for at some of them.  Four in five mutants get a right count of records and a right hash; one in eight is given
   with its own claim (its scheme's text, its valence), so that the lie is not in the claim, and the others with that
   of the certificate that they come from.

   SMOOTHCERT_CHECK is the checker, SRCDIR the sources.  Arguments are parts of names: of such certificates only.  The
   mutant of a failure stays in ./mutant (and ./text). */
#include "tests/certificates/judge.h"
#include "tests/verify/common.h"

enum { MUTANTS = 1000 };

static corpus bases;
static choice_of_bases chosen; /* which mutants are made of; lines are borrowed from any */

/* ---- mutants ---- */

static valence_range random_valences(bool several)
{
    valence_range k = one_valence(3 + (long)random_below(random_bool() ? 8 : 40));
    if (several)
        k.last = random_below(3) == 0 ? VALENCES_UNBOUNDED : k.first + 1 + (long)random_below(random_bool() ? 8 : 100);
    return k;
}

/* "valence 7", "valence 7 9" or "valence 7 inf" */
static void write_valences(char *out, size_t size, valence_range k)
{
    int used = snprintf(out, size, "valence %ld", k.first);
    if (k.last == VALENCES_UNBOUNDED)
        snprintf(out + used, size - (size_t)used, " inf");
    else if (!is_one_valence(k))
        snprintf(out + used, size - (size_t)used, " %ld", k.last);
}

/* The scheme or the valences change, and the claim with them. */
static void drift(trial *t, lines *z, int first, int claim)
{
    char line[64];
    t->own_text = true;
    if (random_below(3)) {
        mutate_scheme(z, first, claim - 1);
        return;
    }
    t->k = random_valences(!is_one_valence(t->from->k));
    write_valences(line, sizeof line, t->k);
    lines_replace(z, claim + 1, line);
}

static void make_mutant(trial *t)
{
    const base *b = chosen.base[random_below((uint64_t)chosen.count)], *other = &bases.base[random_below((uint64_t)bases.count)];
    lines z;
    int claim, edits = 1 + (random_below(3) == 0 ? (int)random_below(4) : 0);
    bool sealed = random_below(5) > 0;
    lines_read(&z, b->whole, sealed ? "records " : NULL);
    claim = lines_find(&z, "claim");
    t->from = b;
    t->k = b->k;
    if (random_below(8) == 0) {
        drift(t, &z, 2, claim);
        edits -= random_bool();
    }
    while (edits-- > 0)
        mutate_lines(&z, !t->own_text && random_below(6) == 0 ? 0 : claim + 2, &other->body);
    lines_write(&t->certificate, &z);
    if (sealed)
        seal(&t->certificate);
    write_file("mutant", t->certificate.bytes, t->certificate.length);
    if (t->own_text) {
        buffer text;
        int all = z.count;
        for (int i = 0; i < 2 && claim > 0; i++)
            lines_replace(&z, i, "");
        z.count = claim;
        buffer_init(&text);
        lines_write(&text, &z);
        write_file("text", text.bytes, text.length);
        buffer_clear(&text);
        z.count = all;
    }
    lines_clear(&z);
}

/* ---- all of it ---- */

typedef struct {
    long accepted, rejected, cannot, unchanged, drifted;
} counts;

static void examine(const trial *t, counts *n)
{
    bool unchanged = t->certificate.length == strlen(t->from->whole) && memcmp(t->certificate.bytes, t->from->whole, t->certificate.length) == 0;
    judge_answer(t);
    if (test_failed())
        return;
    CHECK(t->answer.status == 0 || !unchanged || t->own_text, "%s: unchanged, but not accepted: %s", t->from->name, t->answer.err);
    n->unchanged += unchanged;
    n->accepted += t->answer.status == 0 && !unchanged;
    n->rejected += t->answer.status == 1;
    n->cannot += t->answer.status == 2;
    n->drifted += t->answer.status == 0 && t->own_text;
    if (t->answer.status == 0 && !unchanged) {
        opinion o;
        opinion_init(&o, t->k);
        judge_accepted(t, &o);
        opinion_clear(&o);
    }
}

int main(int argc, char **argv)
{
    (void)argc;
    counts n = {0, 0, 0, 0, 0};
    test_begin("mutants");
    corpus_read_all(&bases);
    corpus_choose(&chosen, &bases, (const char *const *)argv + 1);
    for (test_cases(MUTANTS); chosen.count > 0 && test_next();) {
        trial t = {.from = NULL};
        buffer_init(&t.certificate);
        make_mutant(&t);
        ask_checker(&t.answer, t.from, t.own_text ? "text" : NULL, t.k, "mutant");
        examine(&t, &n);
        buffer_clear(&t.certificate);
    }
    printf("%ld accepted (%ld with another claim), %ld rejected, %ld cannot be checked, %ld unchanged\n", n.accepted, n.drifted, n.rejected, n.cannot, n.unchanged);
    if (n.accepted + n.rejected >= MUTANTS / 2)
        CHECK(n.accepted && n.rejected && n.cannot, "the mutants do not reach every answer");
    test_end();
    return test_status();
}
