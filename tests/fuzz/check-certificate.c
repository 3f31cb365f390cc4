/* The checker on certificates, from the first byte to the answer.  The claim is what the certificate itself says, so
   that no mutant fails there; where its last two lines are missing they are added, so that some get farther. */
#include "checker.h"
#include "fuzz.h"

#include "verify/check/check.h"
#include "verify/check/sha256.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_POWERS = 2000, MAX_PRODUCTS = 400000 };

struct input {
    char *text;
    size_t size;
};

/* The line that begins with the word, or NULL. */
static const char *find_line(const char *text, const char *word)
{
    const char *line = text, *end;

    while (strncmp(line, word, strlen(word)) != 0) {
        end = strchr(line, '\n');
        if (!end)
            return NULL;
        line = end + 1;
    }
    return line;
}

static void seal(struct input *in)
{
    char digest[65];
    int lines = 0;

    for (size_t i = 0; i < in->size; i++)
        lines += in->text[i] == '\n';
    in->size += (size_t)sprintf(in->text + in->size, "records %d\n", lines);
    sha256_hex(digest, (const unsigned char *)in->text, in->size);
    in->size += (size_t)sprintf(in->text + in->size, "sha256 %.64s\n", digest);
}

/* The powers of matrices that are asked for: the last numbers of these lines. */
static long sum_of_powers(const char *text)
{
    static const char *const names[] = {"block ", "cover ", "rise ", "limit ", "wave ", "others "};
    long sum = 0, power;

    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (const char *line = text; (line = find_line(line, names[i])) != NULL; line++) {
            const char *last = line + strcspn(line, "\n");

            while (last[-1] != ' ')
                last--;
            power = strtol(last, NULL, 10);
            sum += 0 <= power && power <= MAX_POWERS ? power : MAX_POWERS + 1;
        }
    return sum;
}

/* The unknowns of the first eigenvector: the order of most matrices. */
static long count_unknowns(const char *text)
{
    const char *line = find_line(text, "eigenvector ");
    long count = 0;

    for (const char *end = line ? line + strcspn(line, "\n") : line; line != end; line++)
        count += *line == ' ';
    return count + 1;
}

/* The only schemes known to have windows of frequencies have masks that need long powers. */
enum { MAX_STABILITY_POWER = 3, MAX_STABILITY_POWER_OF_WINDOWS = 7 };

/* A check that takes long is not a bug: these limits keep mutants fast. */
static bool is_small(const char *text)
{
    int most = find_line(text, "window ") ? MAX_STABILITY_POWER_OF_WINDOWS : MAX_STABILITY_POWER;
    const char *grid = find_line(text, "grid "), *valence = find_line(text, "valence ");
    const char *rest = find_line(text, "stability ");
    long power, order;

    if (!grid || strtol(grid + 5, NULL, 10) > 256 || !valence || strtol(valence + 8, NULL, 10) > 100000)
        return false;
    for (int i = 0; rest && i < 3; i++) {
        power = strtol(rest + (i == 0 ? 10 : 0), (char **)&rest, 10);
        strtol(rest, (char **)&rest, 10);
        if (power > most)
            return false;
    }
    power = sum_of_powers(text);
    order = count_unknowns(text);
    return power <= MAX_POWERS && order < 40 && power * order * order * order <= MAX_PRODUCTS;
}

static void check(void *argument)
{
    const struct input *in = argument;
    const char *scheme = find_line(in->text, "scheme "), *claim = find_line(in->text, "claim ");

    scheme = scheme ? strchr(scheme, '\n') : NULL;
    checker_set_file("scheme", scheme ? scheme + 1 : NULL, scheme && claim > scheme ? (size_t)(claim - scheme - 1) : 0);
    checker_set_file("certificate", in->text, in->size);
    check_certificate(statement_new("scheme", NULL, 0, claim && strncmp(claim, "claim not", 9) == 0),
                      check_valences("certificate"), "certificate");
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct input in = {malloc(size + 200), size};
    int status = 2;

    if (!in.text)
        return 0;
    memcpy(in.text, bytes, size);
    in.text[size] = '\0';
    if (size > 0 && !find_line(in.text, "records ") && in.text[size - 1] == '\n')
        seal(&in);
    if (size <= FUZZ_MAX_BYTES && is_small(in.text))
        status = checker_try(check, &in);
    free(in.text);
    return fuzz_result(status == -1);
}
