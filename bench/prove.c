/* prove.c: how long the program takes to prove lists of valences, and all of them: start-up included, nothing stored,
   one thread.

   usage: prove [WORD]...         (only the lines whose command contains one of the words)

   Each line: the median and the least time of the runs (of the whole process, by the clock), what the processor
   worked in the fastest (a busy machine shows in the difference), the number of elements examined for all valences
   together, the goal, the command.  For all valences also the boxes that they are decided in, beside the valences that
   Zorin's thesis (1997, figures 6.17 and 6.22, section 6.4.3) tested for the same purpose; these took about 30 s for Modified
   Butterfly.  The program is $SMOOTHCERT, or ./smoothcert. */
#define _DEFAULT_SOURCE /* wait4 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define MAX_RUNS 15
#define MAX_WORDS 24
#define SECONDS_PER_LINE 4.0 /* as long as this there is another run, but 3 at least */

typedef struct {
    const char *arguments;
    double goal; /* seconds, 0: none */
    long thesis; /* valences tested there, 0: not a scheme of the thesis, or not all valences */
} line;

static const line lists[] = {
    {"loop --valence 3..100", 0.05, 0},
    {"loop --valence 3..100 --precision 256", 0, 0},
    {"modified-butterfly --valence 3..100", 1, 0},
    {"modified-butterfly --valence 3..100 --precision 256", 0, 0},
    {"modified-loop --valence 3..100", 0, 0},
    {"butterfly --valence 4..7", 0, 0},
    {"doo-sabin --valence 3..100", 0, 0},
    {"catmull-clark --valence 3..100", 0, 0},
    {"catmull-clark --valence 3..100 --precision 256", 0, 0},
    {"kobbelt --valence 3..50", 0, 0},
    {"kobbelt --valence 1000", 0, 0},
    {"midpoint --set degree=9 --valence 3..20", 0, 0},
    {"midpoint --set degree=9 --valence 1000", 0, 0},
    {"loop-spiral --valence 3..30", 0, 0},
    {"loop --valence 3 --set", 0, 0}, /* a usage error: starting and ending alone */
};

static const line all_valences[] = {
    {"loop --valence all", 0.02, 55},
    {"modified-butterfly --valence all", 0.3, 440},
    {"modified-loop --valence all", 2, 60},
    {"butterfly --valence all", 2, 0},
    {"loop-warren --valence all", 2, 0},
    {"loop-ring --valence all", 2, 0},
    {"catmull-clark --valence all", 2, 0},
    {"catmull-clark-weights --valence all", 2, 0},
    {"doo-sabin --valence all", 2, 0},
    {"doo-sabin-spectrum --valence all", 2, 0},
    {"kobbelt --valence all", 2, 0},
    {"midpoint --valence all", 2, 0},
    {"midpoint --set degree=9 --valence all", 2, 0},
    {"wave --valence all", 2, 0},
    {"wave-valence --valence all", 2, 0},
};

typedef struct {
    double wall, processor;
    long elements;
    long boxes;   /* of all valences; 0: one by one */
    long proved;  /* lines that say so */
    bool is_open; /* some valence stayed undecided */
    bool ok;
} measurement;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double seconds(struct timeval t) { return (double)t.tv_sec + 1e-6 * (double)t.tv_usec; }

/* The whole number behind a name in a line of --json, 0 if it is not there. */
static long number_behind(const char *text, const char *name)
{
    const char *at = strstr(text, name);
    return at ? strtol(at + strlen(name), NULL, 10) : 0;
}

static void read_answers(measurement *m, FILE *from)
{
    static char text[8192];
    while (fgets(text, sizeof text, from)) {
        m->elements += number_behind(text, "\"elements\":");
        m->boxes += number_behind(text, "\"boxes\":");
        m->proved += strstr(text, "\"verdict\":\"proved\"") != NULL;
        m->is_open = m->is_open || strstr(text, "\"verdict\":\"undecided\"");
    }
}

/* Lists are to be proved, of all valences each is to be decided; without any answer it is the usage error. */
static bool is_as_wanted(const measurement *m, int status)
{
    if (!WIFEXITED(status) || m->is_open)
        return false;
    if (m->boxes > 0)
        return WEXITSTATUS(status) <= 1;
    return WEXITSTATUS(status) == (m->proved > 0 ? 0 : 64);
}

/* program prove ARGUMENTS --out none --json; text is cut up. */
static void split_command(const char **word, const char *program, char *text)
{
    int count = 0;
    word[count++] = program;
    word[count++] = "prove";
    for (char *w = strtok(text, " "); w && count < MAX_WORDS; w = strtok(NULL, " "))
        word[count++] = w;
    if (strcmp(word[count - 1], "--set")) {
        word[count++] = "--out";
        word[count++] = "none";
        word[count++] = "--json";
    }
    word[count] = NULL;
}

/* In the child: never returns. */
static void become(const char *const *word, const int out[2])
{
    dup2(out[1], 1);
    close(out[0]);
    close(out[1]);
    if (!freopen("/dev/null", "w", stderr))
        _exit(126);
    execvp(word[0], (char *const *)word);
    _exit(127);
}

static measurement run(const char *program, const char *arguments)
{
    char text[512];
    const char *word[MAX_WORDS + 8];
    int out[2], status = -1;
    measurement m = {0, 0, 0, 0, 0, false, false};
    struct rusage usage;
    double start;
    pid_t child;
    FILE *from;
    snprintf(text, sizeof text, "%s", arguments);
    split_command(word, program, text);
    if (pipe(out) != 0)
        return m;
    start = now();
    child = fork();
    if (child < 0)
        return m;
    if (child == 0)
        become(word, out);
    close(out[1]);
    from = fdopen(out[0], "r");
    if (from) {
        read_answers(&m, from);
        fclose(from);
    }
    if (wait4(child, &status, 0, &usage) != child)
        return m;
    m.wall = now() - start;
    m.processor = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    m.ok = is_as_wanted(&m, status);
    return m;
}

static int by_wall(const void *a, const void *b)
{
    const measurement *x = a, *y = b;
    return (x->wall > y->wall) - (x->wall < y->wall);
}

static bool is_wanted(const char *arguments, int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        if (strstr(arguments, argv[i]))
            return true;
    return argc <= 1;
}

/* All runs of one line: the median, the fastest, and whether each was as wanted. */
static bool measure(measurement *median, measurement *fastest, const char *program, const char *arguments)
{
    measurement m[MAX_RUNS];
    int runs = 0;
    double begin = now();
    bool ok = true;
    run(program, arguments); /* reads the file into memory */
    while (runs < MAX_RUNS && (runs < 3 || now() - begin < SECONDS_PER_LINE)) {
        m[runs] = run(program, arguments);
        ok = ok && m[runs++].ok;
    }
    qsort(m, (size_t)runs, sizeof *m, by_wall);
    *median = m[runs / 2];
    *fastest = m[0];
    return ok;
}

static bool print_line(const char *program, const line *l)
{
    measurement median, fastest;
    bool ok = measure(&median, &fastest, program, l->arguments);
    char goal[32] = "", boxes[32] = "", thesis[32] = "";
    if (l->goal > 0)
        snprintf(goal, sizeof goal, "%.2f s", l->goal);
    if (fastest.boxes > 0)
        snprintf(boxes, sizeof boxes, "%ld", fastest.boxes);
    if (l->thesis > 0)
        snprintf(thesis, sizeof thesis, "%ld", l->thesis);
    printf("%7.4f s %7.4f s %8.4f s %9ld %8s %6s %6s  %s%s\n", median.wall, fastest.wall, fastest.processor, fastest.elements, goal, boxes, thesis, l->arguments,
           ok ? "" : "   NOT AS WANTED");
    fflush(stdout);
    return ok;
}

static bool print_table(const line *lines, size_t count, int argc, char **argv)
{
    const char *program = getenv("SMOOTHCERT") ? getenv("SMOOTHCERT") : "./smoothcert";
    bool ok = true;
    printf("   median    least  processor  elements     goal  boxes thesis  smoothcert prove ... --out none\n");
    for (size_t i = 0; i < count; i++)
        if (is_wanted(lines[i].arguments, argc, argv))
            ok = print_line(program, &lines[i]) && ok;
    return ok;
}

int main(int argc, char **argv)
{
    bool ok = print_table(lists, sizeof lists / sizeof *lists, argc, argv);
    printf("\nall valences:\n");
    ok = print_table(all_valences, sizeof all_valences / sizeof *all_valences, argc, argv) && ok;
    return !ok;
}
