/* The reader of scheme files, lib/scheme.h. */
#include "fuzz.h"

#include "lib/scheme.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    scheme s;
    diagnostic d = {0, 0, ""};
    status got;
    if (size > FUZZ_MAX_BYTES)
        return 0;
    scheme_init(&s);
    got = scheme_read(&s, (const char *)bytes, size, NULL, &d);
    if (got == STATUS_BAD_INPUT && d.text[0] == '\0')
        abort(); /* a complaint without words */
    scheme_clear(&s);
    return fuzz_result(got == STATUS_OK);
}
