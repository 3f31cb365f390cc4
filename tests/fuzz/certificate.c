/* The reader of certificates, verify/certificate.h; what it accepts is what it would write. */
#include "fuzz.h"

#include "verify/certificate.h"

#include <stdlib.h>
#include <string.h>

/* Where the text of the scheme begins and ends, by the lines `scheme` and `claim`. */
static bool find_scheme(const char **text, size_t *length, const char *bytes)
{
    const char *begin = strstr(bytes, "\nscheme "), *end = strstr(bytes, "\nclaim ");
    begin = begin ? strchr(begin + 1, '\n') : NULL;
    if (!begin || !end || end < begin)
        return false;
    *text = begin + 1;
    *length = (size_t)(end - begin);
    return true;
}

static bool read_back(const scheme *s, const char *bytes, size_t size)
{
    choices c;
    buffer again;
    long line;
    bool good;
    choices_init(&c);
    buffer_init(&again);
    good = certificate_read(&c, &line, s, bytes, size) && line == 0;
    if (good) {
        certificate_write(&again, s, &c);
        if (again.failed || again.length != size || memcmp(again.bytes, bytes, size) != 0)
            abort();
    }
    buffer_clear(&again);
    choices_clear(&c);
    return good;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *copy = malloc(size + 1);
    const char *text;
    size_t length;
    scheme s;
    bool good = false;
    if (!copy || size > FUZZ_MAX_BYTES) {
        free(copy);
        return 0;
    }
    memcpy(copy, bytes, size);
    copy[size] = '\0';
    scheme_init(&s);
    if (find_scheme(&text, &length, copy) && scheme_read(&s, text, length, NULL, NULL) == STATUS_OK)
        good = read_back(&s, copy, size);
    scheme_clear(&s);
    free(copy);
    return fuzz_result(good);
}
