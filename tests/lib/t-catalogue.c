/* t-catalogue: every block of every scheme of the catalogue against eigenvalues that were computed without lib/
   (tests/lib/catalogue-golden.txt says how): each lies in a disc, and each disc holds as many as it says. */
#include "region.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "lib/block.h"
#include "lib/eigenvalues.h"

#define TOLERANCE 2e-12
#define MAX_VALUES 200

#ifdef NUMBER_INTERVAL
#define PREC 53
#else
#define PREC 96
#endif

/* One line of the file. */
typedef struct {
    char scheme[200];
    long k, m;
    double re[MAX_VALUES], im[MAX_VALUES];
    int count;
} golden;

static bool read_line(golden *z, char *line)
{
    char *word = strtok(line, " \n");
    if (!word || *word == '#')
        return false;
    snprintf(z->scheme, sizeof z->scheme, "%s", word);
    z->k = atol(strtok(NULL, " \n"));
    z->m = atol(strtok(NULL, " \n"));
    for (z->count = 0; z->count < MAX_VALUES && (word = strtok(NULL, " \n")) != NULL; z->count++) {
        char *comma = strchr(word, ',');
        z->re[z->count] = atof(word);
        z->im[z->count] = comma ? atof(comma + 1) : 0;
    }
    return true;
}

/* "name,parameter=value,..." */
static bool load(scheme *s, const char *description)
{
    char copy[200];
    const char *settings[8];
    scheme_settings set = {settings, 0};
    diagnostic d = {0, 0, ""};
    snprintf(copy, sizeof copy, "%s", description);
    char *name = strtok(copy, ","), *word;
    while ((word = strtok(NULL, ",")) != NULL && set.count < 8)
        settings[set.count++] = word;
    const char *text = catalogue_text(name);
    scheme_init(s);
    CHECK(scheme_read(s, text, strlen(text), &set, &d) == STATUS_OK, "%s: %ld:%ld: %s", description, d.line, d.column, d.text);
    return !test_failed();
}

static bool lies_in(const eigenvalue_disc *d, double re, double im)
{
    return hypot(number_mid_approx(&d->re) - re, number_mid_approx(&d->im) - im) <= number_upper_bound(&d->radius) + TOLERANCE;
}

static void compare(const golden *g, const eigenvalues *e)
{
    for (int i = 0; i < g->count; i++) {
        bool found = false;
        for (int j = 0; j < e->count; j++)
            found = found || lies_in(&e->disc[j], g->re[i], g->im[i]);
        CHECK(found, "%s, k = %ld, m = %ld: no disc holds %.12g + %.12g i", g->scheme, g->k, g->m, g->re[i], g->im[i]);
    }
    for (int j = 0; j < e->count; j++) {
        int inside = 0;
        if (lies_in(&e->disc[j], 0, 0))
            continue; /* zeros are not listed */
        for (int i = 0; i < g->count; i++)
            inside += lies_in(&e->disc[j], g->re[i], g->im[i]);
        CHECK(inside == e->disc[j].count, "%s, k = %ld, m = %ld: a disc at %.12g says %d and holds %d", g->scheme, g->k, g->m,
              number_mid_approx(&e->disc[j].re), e->disc[j].count, inside);
    }
}

static void check_form(const golden *g, const scheme *s, bool real)
{
    scheme_numbers numbers;
    block b;
    eigenvalues e;
    diagnostic d = {0, 0, ""};
    CHECK(scheme_numbers_make(&numbers, s, g->k, PREC, &d) == STATUS_OK, "%s: %s", g->scheme, d.text);
    CHECK(block_make(&b, &numbers, g->m, real, &d) == BLOCK_OK, "%s, k = %ld, m = %ld: %s", g->scheme, g->k, g->m, d.text);
    if (!test_failed()) {
        CHECK(eigenvalues_enclose(&e, b.entry, b.imaginary, b.n, PREC) == TRUTH_TRUE, "%s, k = %ld, m = %ld: no enclosures", g->scheme, g->k, g->m);
        compare(g, &e);
        eigenvalues_free(&e);
    }
    block_free(&b);
    scheme_numbers_free(&numbers);
}

/* Both forms where there are two, of the scheme whose rules have the most to do with sectors and of small blocks. */
static void check_block(const golden *g)
{
    scheme s;
    if (load(&s, g->scheme)) {
        check_form(g, &s, s.mirror_symmetric);
        if (s.mirror_symmetric && g->m > 0 && (!strncmp(g->scheme, "kobbelt", 7) || g->count < 12))
            check_form(g, &s, false);
        CHECK(s.mirror_symmetric == (strncmp(g->scheme, "loop-spiral", 11) != 0), "%s: symmetric %d", g->scheme, s.mirror_symmetric);
    }
    scheme_clear(&s);
}

/* On grids and balls every seventh line will do: the code is the same. */
static void tests(void)
{
    char path[1000], line[4000];
    const char *directory = getenv("SRCDIR");
    FILE *f;
    long lines = 0, blocks = 0;
    snprintf(path, sizeof path, "%s/tests/lib/catalogue-golden.txt", directory ? directory : ".");
    test_begin("catalogue-golden");
    f = fopen(path, "r");
    CHECK(f, "%s cannot be read", path);
    while (f && !test_failed() && fgets(line, sizeof line, f)) {
        static golden g;
        if (!read_line(&g, line) || (PREC != 53 && lines++ % 7 != 0))
            continue;
        check_block(&g);
        blocks++;
    }
    CHECK(blocks > 100, "only %ld blocks", blocks);
    if (f)
        fclose(f);
    test_end();
}
MAIN(tests);
