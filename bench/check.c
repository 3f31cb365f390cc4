/* check.c: how long the checker takes in comparison with the prover, on doubles and on balls of 64 bits.

   usage: check [WORD]...         (only the lines that contain one of the words)

   Each line: processor time of smoothcert-check on a directory of certificates, of smoothcert prove --out none for the
   same valences, and of that with --precision 64; their ratios, which should be below 5 and below 1.  Start-up is
   included; the three take turns, and the medians count.  The programs are $SMOOTHCERT and $SMOOTHCERT_CHECK, or
   ./smoothcert and ./smoothcert-check; scheme files are looked for in $SRCDIR. */
#define _DEFAULT_SOURCE /* wait4 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

enum { RUNS = 7, MAX_WORDS = 24, PROGRAMS = 3 };

static const struct {
    const char *scheme, *setting, *valences;
} lines[] = {
    {"loop", NULL, "7"},           {"loop", NULL, "3..20"},        {"loop", NULL, "1000"},         {"modified-loop", NULL, "3..20"},
    {"butterfly", NULL, "5"},      {"butterfly", NULL, "4..7"},    {"modified-butterfly", NULL, "3..20"},
    {"catmull-clark", NULL, "5"},  {"catmull-clark", NULL, "3..20"}, {"doo-sabin", NULL, "3..20"},   {"kobbelt", NULL, "5"},
    {"kobbelt", NULL, "3..20"},    {"midpoint", "degree=9", "3..12"}, {"loop-spiral", NULL, "3..12"},
};

static double seconds(struct timeval t)
{
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

/* Processor time of a command, quietly; -1 if it does not end with status 0. */
static double run(char *const *words)
{
    struct rusage usage;
    int status = -1;
    pid_t child = fork();
    if (child == 0) {
        if (freopen("/dev/null", "w", stdout) && freopen("/dev/null", "w", stderr))
            execvp(words[0], words);
        _exit(127);
    }
    if (child < 0 || wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return -1;
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/* program WORD..., the words separated by blanks in text, which is cut up. */
static double run_text(char *text)
{
    char *words[MAX_WORDS + 1];
    int count = 0;
    for (char *w = strtok(text, " "); w && count < MAX_WORDS; w = strtok(NULL, " "))
        words[count++] = w;
    words[count] = NULL;
    return run(words);
}

static int by_size(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static const char *from_environment(const char *name, const char *otherwise)
{
    return getenv(name) ? getenv(name) : otherwise;
}

/* The commands of a line: 0 the checker, 1 the prover, 2 the prover at 64 bits, 3 the one that makes certificates. */
static void write_command(char *out, size_t size, size_t i, int which, const char *folder)
{
    const char *prover = from_environment("SMOOTHCERT", "./smoothcert"), *checker = from_environment("SMOOTHCERT_CHECK", "./smoothcert-check");
    char set[100] = "";
    if (lines[i].setting)
        snprintf(set, sizeof set, "--set %s", lines[i].setting);
    if (which == 0)
        snprintf(out, size, "%s --scheme %s/lib/catalogue/%s.scheme %s --valence %s --claim c1 %s", checker, from_environment("SRCDIR", "."), lines[i].scheme, set,
                 lines[i].valences, folder);
    else
        snprintf(out, size, "%s prove %s %s --valence %s --out %s %s", prover, lines[i].scheme, set, lines[i].valences, which == 3 ? folder : "none",
                 which == 2 ? "--precision 64" : "");
}

/* The medians of all three; false: one of them failed. */
static bool measure(double *median, size_t i, const char *folder)
{
    double taken[PROGRAMS][RUNS];
    char command[1000];
    bool good;
    write_command(command, sizeof command, i, 3, folder);
    good = run_text(command) >= 0;
    for (int r = 0; r < RUNS; r++) {
        for (int p = 0; p < PROGRAMS; p++) {
            write_command(command, sizeof command, i, p, folder);
            taken[p][r] = run_text(command);
            good = good && taken[p][r] >= 0;
        }
    }
    for (int p = 0; p < PROGRAMS; p++) {
        qsort(taken[p], RUNS, sizeof taken[p][0], by_size);
        median[p] = taken[p][RUNS / 2];
    }
    return good;
}

static bool is_wanted(size_t i, int argc, char **argv)
{
    for (int a = 1; a < argc; a++)
        if (strstr(lines[i].scheme, argv[a]))
            return true;
    return argc <= 1;
}

static void remove_folder(char *folder)
{
    char *words[] = {(char[]){"rm"}, (char[]){"-rf"}, folder, NULL};
    run(words);
}

int main(int argc, char **argv)
{
    int result = 0;
    printf("   check   prove  at 64 bits   check/prove  check/prove at 64 bits\n");
    fflush(stdout);
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char folder[] = "/tmp/smoothcert-bench-XXXXXX";
        double m[PROGRAMS];
        bool good;
        if (!is_wanted(i, argc, argv))
            continue;
        good = mkdtemp(folder) && measure(m, i, folder);
        if (good)
            printf("%6.4f s %6.4f s %8.4f s %12.2f %13.2f          %s %s %s\n", m[0], m[1], m[2], m[0] / m[1], m[0] / m[2], lines[i].scheme, lines[i].valences,
                   lines[i].setting ? lines[i].setting : "");
        else
            printf("%s %s: NOT ALL PROVED AND VERIFIED\n", lines[i].scheme, lines[i].valences);
        fflush(stdout);
        remove_folder(folder);
        result = result || !good;
    }
    return result;
}
