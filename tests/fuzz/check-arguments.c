/* The checker's command line: options, settings and lists of valences, one argument in each line. */
int checker_main(int count, char **arguments);
#define main checker_main
#include "verify/check/main.c"
#undef main

#include "checker.h"
#include "fuzz.h"

enum { MAX_ARGUMENTS = 100 };

struct input {
    char *argument[MAX_ARGUMENTS + 1];
    int count;
};

static void read_them(void *argument)
{
    struct input *in = argument;
    struct arguments *a = allocate(1, sizeof *a);
    struct claim *claim = allocate(1, sizeof *claim);

    read_arguments(a, in->count, in->argument);
    claim_read(claim, a->value[VALENCE]);
    for (int i = 0; i < claim->count; i++)
        if (claim->span[i].first < 3 || claim->span[i].last < claim->span[i].first ||
            (i > 0 && claim->span[i].first <= claim->span[i - 1].last))
            abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *text = malloc(size + 1), *line = text;
    struct input in = {{(char *)"smoothcert-check"}, 1};
    int status;

    if (size > FUZZ_MAX_BYTES || text == NULL) {
        free(text);
        return 0;
    }
    memcpy(text, bytes, size);
    text[size] = '\0';
    while (line != NULL && in.count < MAX_ARGUMENTS) {
        in.argument[in.count++] = line;
        line = strchr(line, '\n');
        if (line != NULL)
            *line++ = '\0';
    }
    status = checker_try(read_them, &in);
    free(text);
    return fuzz_result(status == -1);
}
