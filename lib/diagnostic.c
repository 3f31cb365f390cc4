/* diagnostic.c: one complaint, formatted. */
#include "diagnostic.h"

#include <stdarg.h>
#include <stdio.h>

status diagnostic_set(diagnostic *d, long line, long column, const char *format, ...)
{
    if (d) {
        va_list arguments;
        d->line = line;
        d->column = column;
        va_start(arguments, format);
        vsnprintf(d->text, sizeof d->text, format, arguments);
        va_end(arguments);
    }
    return STATUS_BAD_INPUT;
}
