/* Lists of valences, verify/valence_list.h. */
#include "fuzz.h"

#include "verify/valence_list.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static valence_list list;
    char *text = malloc(size + 1);
    const char *complaint;
    if (!text)
        return 0;
    memcpy(text, bytes, size);
    text[size] = '\0';
    complaint = valence_list_read(&list, text);
    if (complaint ? list.count != 0 || *complaint == '\0' : list.count < 1 || list.ranges < 1)
        abort();
    for (long i = 0; i < list.count && i < 1000; i++)
        if (valence_list_get(&list, i) < CHOICES_MIN_VALENCE)
            abort();
    free(text);
    return fuzz_result(!complaint);
}
