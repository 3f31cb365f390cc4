/* replay.c: tries the kept inputs of one target (tests/fuzz/inputs/TARGET) without libFuzzer.

   usage: t-fuzz-TARGET [FILE...].  With files, prints for each whether it is accepted. */
#include "fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static unsigned char bytes[FUZZ_MAX_BYTES + 1];

static bool try_file(const char *name)
{
    FILE *file = fopen(name, "rb");
    size_t size;
    if (!file)
        return false;
    size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    fuzz_result(false);
    LLVMFuzzerTestOneInput(bytes, size);
    return true;
}

static const char *target_of(const char *program)
{
    const char *slash = strrchr(program, '/'), *name = slash ? slash + 1 : program;
    return strncmp(name, "t-fuzz-", 7) == 0 ? name + 7 : name;
}

/* A crash names its input. */
static int try_folder(const char *folder, const char *target)
{
    DIR *list = opendir(folder);
    int inputs = 0, accepted = 0;
    if (!list) {
        printf("FAIL fuzz-%s: there are no inputs in %s\n", target, folder);
        return 1;
    }
    for (struct dirent *entry; (entry = readdir(list)) != NULL;) {
        char name[5000];
        if (entry->d_name[0] == '.')
            continue;
        snprintf(name, sizeof name, "%s/%s", folder, entry->d_name);
        fprintf(stderr, "input %s\n", name);
        if (!try_file(name)) {
            printf("FAIL fuzz-%s: %s cannot be read\n", target, name);
            closedir(list);
            return 1;
        }
        inputs++;
        accepted += fuzz_was_accepted();
    }
    closedir(list);
    if (inputs == 0 || accepted == 0 || accepted == inputs) {
        printf("FAIL fuzz-%s: %d inputs, %d accepted\n", target, inputs, accepted);
        return 1;
    }
    printf("PASS fuzz-%s\n", target);
    return 0;
}

int main(int count, char **arguments)
{
    const char *source = getenv("SRCDIR"), *target = target_of(arguments[0]);
    char folder[4096];
    for (int i = 1; i < count; i++) {
        if (!try_file(arguments[i]))
            return 2;
        printf("%s %s\n", fuzz_was_accepted() ? "accepted" : "refused", arguments[i]);
    }
    if (count > 1)
        return 0;
    snprintf(folder, sizeof folder, "%s/tests/fuzz/inputs/%s", source ? source : ".", target);
    return try_folder(folder, target);
}
