/* Lists of valences, verify/valences.h. */
#include "fuzz.h"

#include "verify/valences.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static valences list;
    char *text = malloc(size + 1);
    const char *complaint;
    if (!text)
        return 0;
    memcpy(text, bytes, size);
    text[size] = '\0';
    complaint = valences_read(&list, text);
    if (complaint ? list.count != 0 || *complaint == '\0' : list.count < 1 || list.count > VALENCES_MAX)
        abort();
    for (long i = 0; i < list.count; i++)
        if (valences_get(&list, i) < CHOICES_MIN_VALENCE || valences_get(&list, i) > CHOICES_MAX_VALENCE)
            abort();
    free(text);
    return fuzz_result(!complaint);
}
