/* command_scheme.h: what all commands do with their SCHEME argument. */
#ifndef VERIFY_COMMAND_SCHEME_H
#define VERIFY_COMMAND_SCHEME_H

#include "../lib/scheme.h"
#include "deadline.h"

enum { SCHEME_OPTIONS_MAX = 64 };

typedef struct {
    const char *name; /* of the catalogue, or a file */
    const char *settings[SCHEME_OPTIONS_MAX];
    int count;
} scheme_options;

/* Adds NAME=VALUE.  false: there are too many. */
bool scheme_options_set(scheme_options *o, const char *setting);

/* Takes the one argument that is left behind a command's options as the scheme.  -1: well; else it has complained, and
   this is the exit status. */
int scheme_options_name(scheme_options *o, const char *command, int argc, char **argv, int next);

/* Reads the scheme.  -1: well; else it has complained, and this is the exit status. */
int scheme_options_load(scheme *s, const scheme_options *o);

/* Complains about the scheme; returns the exit status. */
int complain_of_scheme(const char *name, const diagnostic *d);

/* A decimal option value in the range given. */
bool read_long_option(long *value, const char *text, long low, long high);
/* A time limit in seconds, from now on. */
bool read_seconds_option(deadline *d, const char *text);

#endif
