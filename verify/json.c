/* json.c: strings and numbers of JSON. */
#include "json.h"

#include <math.h>

void json_string(buffer *b, const char *text)
{
    buffer_print(b, "\"");
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            buffer_print(b, "\\%c", *text);
        else if ((unsigned char)*text < ' ' || (unsigned char)*text > '~')
            buffer_print(b, "\\u%04x", (unsigned char)*text);
        else
            buffer_append(b, text, 1);
    }
    buffer_print(b, "\"");
}

void json_add_string(buffer *b, const char *name, const char *text)
{
    buffer_print(b, ",\"%s\":", name);
    json_string(b, text);
}

void json_add_number(buffer *b, const char *name, double value)
{
    if (isfinite(value))
        buffer_print(b, ",\"%s\":%.17g", name, value);
    else
        buffer_print(b, ",\"%s\":null", name);
}
