/* command_schemes.c: the catalogue. */
#include "command.h"

#include "../lib/catalogue.h"

#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: smoothcert schemes [NAME]\n"
    "Lists the names of the built-in schemes, or prints the file of one: a model for one's own.\n";

int command_schemes(int argc, char **argv)
{
    const struct catalogue_entry *e = catalogue;
    if (argc > 2)
        return complain(EXIT_USAGE, "schemes: one name at most");
    if (argc == 2 && !strcmp(argv[1], "--help")) {
        fputs(help, stdout);
        return finish_output(0);
    }
    if (argc == 2 && argv[1][0] == '-')
        return complain(EXIT_USAGE, "schemes: unknown option '%s'; see 'smoothcert schemes --help'", argv[1]);
    for (; e->name; e++) {
        if (argc == 1)
            puts(e->name);
        else if (!strcmp(argv[1], e->name))
            break;
    }
    if (argc == 1)
        return finish_output(0);
    if (!e->name)
        return complain(EXIT_BAD_INPUT, "there is no scheme '%s' in the catalogue; 'smoothcert schemes' lists it", argv[1]);
    fputs(e->text, stdout);
    return finish_output(0);
}
