/* spectrum.c: how long spectra take, for `make bench`: all blocks of k = 1000, and what the spectrum command does at
   k = 1000 and k = 10^9 without enumerating them.  The least of several runs, in milliseconds of the processor. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "lib/catalogue.h"
#include "verify/spectrum_list.h"

enum { DIGITS = 15 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static void fail(const char *what)
{
    fprintf(stderr, "bench/spectrum: %s\n", what);
    exit(1);
}

static status run(spectrum_list *l, const scheme *s, long k, long precision, bool all)
{
    diagnostic d;
    if (all)
        return precision ? spectrum_list_make_ball(l, s, k, DIGITS, precision, &d) : spectrum_list_make_interval(l, s, k, DIGITS, 53, &d);
    return precision ? spectrum_survey_ball(l, s, k, DIGITS, precision, true, &d) : spectrum_survey_interval(l, s, k, DIGITS, 53, true, &d);
}

/* *settled: a survey has put all blocks in order. */
static double measure(bool *settled, const scheme *s, long k, long precision, bool all)
{
    double best = 0;
    for (int i = 0; i < (precision ? 3 : 15); i++) {
        spectrum_list l;
        double start = now(), time;
        spectrum_list_init(&l);
        if (run(&l, s, k, precision, all) != STATUS_OK)
            fail("no spectrum");
        time = now() - start;
        best = i == 0 || time < best ? time : best;
        *settled = all || l.ordered;
        spectrum_list_clear(&l);
    }
    return best;
}

static void read_catalogue(scheme *s, const char *name)
{
    diagnostic d;
    scheme_init(s);
    for (const struct catalogue_entry *e = catalogue; e->name; e++)
        if (!strcmp(e->name, name) && scheme_read(s, e->text, strlen(e->text), NULL, &d) == STATUS_OK)
            return;
    fail(name);
}

static void read_file(scheme *s, const char *name)
{
    static char text[65536];
    char path[4096];
    const char *folder = getenv("SRCDIR");
    diagnostic d;
    FILE *f;
    size_t length;
    snprintf(path, sizeof path, "%s/bench/%s", folder ? folder : ".", name);
    f = fopen(path, "rb");
    if (!f)
        fail(path);
    length = fread(text, 1, sizeof text, f);
    fclose(f);
    scheme_init(s);
    if (scheme_read(s, text, length, NULL, &d) != STATUS_OK)
        fail(d.text);
}

static void print_row(const scheme *s)
{
    static const long precisions[] = {0, 256};
    for (int i = 0; i < 2; i++) {
        bool settled;
        printf("%-10s %-8s", s->name, precisions[i] ? "256 bits" : "doubles");
        printf(" %14.1f", measure(&settled, s, 1000, precisions[i], true));
        for (long k = 1000; k <= 1000000000; k *= 1000000) {
            double time = measure(&settled, s, k, precisions[i], false);
            printf(" %14.1f%s", time, settled ? " " : "*");
        }
        printf("\n");
    }
}

int main(void)
{
    scheme s;
    printf("Spectra, ms of processor time (* dominance not proved at this precision)\n");
    printf("%-10s %-8s %14s %14s  %14s\n", "", "", "1000, all", "1000, ranges", "10^9, ranges");
    read_catalogue(&s, "loop");
    print_row(&s);
    scheme_clear(&s);
    read_catalogue(&s, "butterfly");
    print_row(&s);
    scheme_clear(&s);
    read_file(&s, "twelve.scheme");
    print_row(&s);
    scheme_clear(&s);
    return 0;
}
