/* The three answers; see answer.h and section 11 of certificate.md. */

#include "answer.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

noreturn void answer(int status, const char *file, int line, int column, const char *format, ...)
{
    va_list arguments;

    fputs(status == ANSWER_REJECTED ? "rejected: " : "cannot check: ", stderr);
    if (file != NULL && column > 0)
        fprintf(stderr, "%s:%d:%d: ", file, line, column);
    else if (file != NULL)
        fprintf(stderr, "%s:%d: ", file, line);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(status);
}
