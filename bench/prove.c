/* prove.c: how long the program takes to prove whole lists of valences: start-up included, nothing stored, one thread.

   usage: prove [WORD]...         (only the lines whose command contains one of the words)

   Each line: the median and the least time of the runs (of the whole process, by the clock), what the processor
   worked in the fastest (a busy machine shows in the difference), the number of elements examined for all valences
   together, the goal, the command.  The program is $SMOOTHCERT, or ./smoothcert. */
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

static const struct {
    const char *arguments;
    double goal; /* seconds, 0: none */
} lines[] = {
    {"loop --valence 3..100", 0.05},
    {"loop --valence 3..100 --precision 256", 0},
    {"modified-butterfly --valence 3..100", 1},
    {"modified-butterfly --valence 3..100 --precision 256", 0},
    {"modified-loop --valence 3..100", 0},
    {"butterfly --valence 4..7", 0},
    {"doo-sabin --valence 3..100", 0},
    {"catmull-clark --valence 3..100", 0},
    {"catmull-clark --valence 3..100 --precision 256", 0},
    {"kobbelt --valence 3..50", 0},
    {"kobbelt --valence 1000", 0},
    {"midpoint --set degree=9 --valence 3..20", 0},
    {"midpoint --set degree=9 --valence 1000", 0},
    {"loop-spiral --valence 3..30", 0},
    {"loop --valence 3 --set", 0}, /* a usage error: starting and ending alone */
};

typedef struct {
    double wall, processor;
    long elements;
    bool ok;
} measurement;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double seconds(struct timeval t) { return (double)t.tv_sec + 1e-6 * (double)t.tv_usec; }

/* The sum of what stands behind "elements": in the lines of --json. */
static long count_elements(FILE *from, long *proved)
{
    static char line[8192];
    long sum = 0;
    *proved = 0;
    while (fgets(line, sizeof line, from)) {
        const char *at = strstr(line, "\"elements\":");
        sum += at ? strtol(at + strlen("\"elements\":"), NULL, 10) : 0;
        *proved += strstr(line, "\"verdict\":\"proved\"") != NULL;
    }
    return sum;
}

static measurement run(const char *program, const char *arguments)
{
    char text[512];
    const char *word[MAX_WORDS + 8];
    int count = 0, out[2], status = -1;
    long proved = 0;
    measurement m = {0, 0, 0, false};
    struct rusage usage;
    double start;
    pid_t child;
    word[count++] = program;
    word[count++] = "prove";
    snprintf(text, sizeof text, "%s", arguments);
    for (char *w = strtok(text, " "); w && count < MAX_WORDS; w = strtok(NULL, " "))
        word[count++] = w;
    if (strcmp(word[count - 1], "--set")) {
        word[count++] = "--out";
        word[count++] = "none";
        word[count++] = "--json";
    }
    word[count] = NULL;
    if (pipe(out) != 0)
        return m;
    start = now();
    child = fork();
    if (child < 0)
        return m;
    if (child == 0) {
        dup2(out[1], 1);
        close(out[0]);
        close(out[1]);
        if (!freopen("/dev/null", "w", stderr))
            _exit(126);
        execvp(program, (char *const *)word);
        _exit(127);
    }
    close(out[1]);
    FILE *from = fdopen(out[0], "r");
    m.elements = from ? count_elements(from, &proved) : 0;
    if (from)
        fclose(from);
    if (wait4(child, &status, 0, &usage) != child)
        return m;
    m.wall = now() - start;
    m.processor = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    m.ok = WIFEXITED(status) && (proved > 0 ? WEXITSTATUS(status) == 0 : WEXITSTATUS(status) == 64);
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

int main(int argc, char **argv)
{
    const char *program = getenv("SMOOTHCERT") ? getenv("SMOOTHCERT") : "./smoothcert";
    int result = 0;
    printf("   median    least  processor  elements     goal  smoothcert prove ... --out none\n");
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        measurement m[MAX_RUNS];
        int runs = 0;
        double begin = now();
        bool ok = true;
        char goal[32] = "";
        if (!is_wanted(lines[i].arguments, argc, argv))
            continue;
        run(program, lines[i].arguments); /* reads the file into memory */
        while (runs < MAX_RUNS && (runs < 3 || now() - begin < SECONDS_PER_LINE))
            m[runs++] = run(program, lines[i].arguments);
        for (int r = 0; r < runs; r++)
            ok = ok && m[r].ok;
        qsort(m, (size_t)runs, sizeof *m, by_wall);
        if (lines[i].goal > 0)
            snprintf(goal, sizeof goal, "%.2f s", lines[i].goal);
        printf("%7.4f s %7.4f s %8.4f s %9ld %8s  %s%s\n", m[runs / 2].wall, m[0].wall, m[0].processor, m[0].elements, goal, lines[i].arguments,
               ok ? "" : "   NOT ALL PROVED");
        fflush(stdout);
        result = result || !ok;
    }
    return result;
}
