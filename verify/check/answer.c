/* The three answers; see answer.h and section 10 of certificate.md. */

#include "answer.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static void print(const char *answer, const char *file, int line, int column,
                  const char *format, va_list arguments)
{
    fputs(answer, stderr);
    if (file != NULL && column > 0)
        fprintf(stderr, "%s:%d:%d: ", file, line, column);
    else if (file != NULL)
        fprintf(stderr, "%s:%d: ", file, line);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
}

noreturn void rejected(const char *file, int line, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    print("rejected: ", file, line, 0, format, arguments);
    va_end(arguments);
    exit(ANSWER_REJECTED);
}

noreturn void cannot_check(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    print("cannot check: ", NULL, 0, 0, format, arguments);
    va_end(arguments);
    exit(ANSWER_CANNOT_CHECK);
}

noreturn void cannot_check_at(const char *file, int line, int column,
                              const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    print("cannot check: ", file, line, column, format, arguments);
    va_end(arguments);
    exit(ANSWER_CANNOT_CHECK);
}
