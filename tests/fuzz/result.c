/* result.c: what the last input came to. */
#include "fuzz.h"

static bool last;

int fuzz_result(bool accepted)
{
    last = accepted;
    return 0;
}

bool fuzz_was_accepted(void)
{
    return last;
}
