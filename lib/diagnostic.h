/* diagnostic.h: how the functions of lib/ and verify/ say what went wrong.

   Three kinds of trouble are kept apart: bad input (the user's text), lack of memory, and mathematical doubt.
   Doubt is a value (truth, outcome), never a status.  A status other than STATUS_OK means that the outputs are
   unspecified but valid to clear. */
#ifndef LIB_DIAGNOSTIC_H
#define LIB_DIAGNOSTIC_H

#include <stdbool.h>

typedef enum {
    STATUS_OK,
    STATUS_BAD_INPUT, /* the diagnostic says where and what was expected */
    STATUS_NO_MEMORY
} status;

/* One complaint about a text: line and column count from 1, 0 = not about one place. */
typedef struct {
    long line;
    long column;
    char text[400];
} diagnostic;

/* Fills *d (which may be NULL) and returns STATUS_BAD_INPUT. */
status diagnostic_set(diagnostic *d, long line, long column, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 4, 5)))
#endif
    ;

#endif
