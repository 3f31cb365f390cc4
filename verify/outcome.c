/* outcome.c: names for logs and messages. */
#include "outcome.h"

const char *outcome_name(outcome o)
{
    static const char *const names[] = {"true", "false", "undefined", "fail", "stopped", "bad input", "no memory"};
    return names[o];
}

const char *verdict_name(verdict v)
{
    static const char *const names[] = {"proved", "refuted", "undecided"};
    return names[v];
}
