/* command_scheme.c: catalogue names, files, settings. */
#include "command_scheme.h"

#include "buffer.h"
#include "command.h"

#include "../lib/catalogue.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* Anything much longer than a scheme may be is refused by scheme_read with a better message. */
#define MAX_FILE_BYTES (1 << 20)

bool scheme_options_set(scheme_options *o, const char *setting)
{
    if (o->count == SCHEME_OPTIONS_MAX)
        return false;
    o->settings[o->count++] = setting;
    return true;
}

int scheme_options_name(scheme_options *o, const char *command, int argc, char **argv, int next)
{
    if (next >= argc)
        return complain(EXIT_USAGE, "%s: no scheme given; see 'smoothcert %s --help'", command, command);
    if (next != argc - 1)
        return complain(EXIT_USAGE, "%s: more than one scheme given (options are written with two dashes)", command);
    o->name = argv[next];
    return -1;
}

bool read_long_option(long *value, const char *text, long low, long high)
{
    char *end;
    errno = 0;
    *value = strtol(text, &end, 10);
    return errno == 0 && end != text && *end == '\0' && *value >= low && *value <= high;
}

bool read_seconds_option(deadline *d, const char *text)
{
    char *end;
    double seconds = strtod(text, &end);
    d->at = deadline_now() + seconds;
    return end != text && *end == '\0' && seconds > 0 && seconds <= 1e9;
}

static const char *find_in_catalogue(const char *name)
{
    for (const struct catalogue_entry *e = catalogue; e->name; e++)
        if (!strcmp(e->name, name))
            return e->text;
    return NULL;
}

int complain_of_scheme(const char *name, const diagnostic *d)
{
    if (d->line > 0)
        return complain(EXIT_BAD_INPUT, "%s:%ld:%ld: %s", name, d->line, d->column, d->text);
    return complain(EXIT_BAD_INPUT, "%s: %s", name, d->text);
}

int scheme_options_load(scheme *s, const scheme_options *o)
{
    const char *text = find_in_catalogue(o->name);
    scheme_settings settings = {o->settings, o->count};
    diagnostic d;
    status result;
    buffer file;
    buffer_init(&file);
    if (!text && !buffer_read_file(&file, o->name, MAX_FILE_BYTES)) {
        int error = errno;
        buffer_clear(&file);
        if (error == ENOENT && !strpbrk(o->name, "/."))
            return complain(EXIT_BAD_INPUT, "there is no scheme '%s': neither in the catalogue ('smoothcert schemes' lists it) nor as a file", o->name);
        return complain(error == ENOMEM ? EXIT_NO_MEMORY : EXIT_IO, "%s: %s", o->name, strerror(error));
    }
    result = text ? scheme_read(s, text, strlen(text), &settings, &d) : scheme_read(s, file.bytes ? file.bytes : "", file.length, &settings, &d);
    buffer_clear(&file);
    if (result == STATUS_BAD_INPUT)
        return complain_of_scheme(o->name, &d);
    return result == STATUS_OK ? -1 : complain(EXIT_NO_MEMORY, "no memory");
}
