/* The checker's reader of scheme files. */
#include "checker.h"
#include "fuzz.h"

#include "verify/check/scheme.h"

#include <stdlib.h>
#include <string.h>

struct input {
    char *text;
    size_t size;
};

static void read_scheme(void *argument)
{
    const struct input *in = argument;
    struct scheme *s = allocate(1, sizeof *s);
    size_t size;

    text_canonical("scheme", in->text, in->size, &size);
    scheme_read(s, "scheme", in->text, in->size);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct input in = {malloc(size + 1), size};
    int status;

    if (size > FUZZ_MAX_BYTES || !in.text) {
        free(in.text);
        return 0;
    }
    memcpy(in.text, bytes, size);
    in.text[size] = '\0';
    status = checker_try(read_scheme, &in);
    free(in.text);
    return fuzz_result(status == -1);
}
