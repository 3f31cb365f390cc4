/* left-out.c: see left-out.h.  Appends the number of each check that is reached, once, to the file REACHED. */
#include "left-out.h"

#include <stdio.h>
#include <stdlib.h>

enum { MAX_CHECKS = 10000 };

static _Bool seen[MAX_CHECKS];

static void say_reached(int check)
{
    const char *name = getenv("REACHED");
    FILE *file = name ? fopen(name, "a") : NULL;

    seen[check] = 1;
    if (file) {
        fprintf(file, "%d\n", check);
        fclose(file);
    }
}

_Bool left_out(int check)
{
    static int chosen = -1;

    if (chosen < 0) {
        const char *number = getenv("LEFT_OUT");
        chosen = number ? atoi(number) : 0;
    }
    if (check < MAX_CHECKS && !seen[check])
        say_reached(check);
    return check == chosen;
}
