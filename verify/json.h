/* json.h: members of JSON objects, each with a comma in front. */
#ifndef VERIFY_JSON_H
#define VERIFY_JSON_H

#include "buffer.h"

/* "text" as a JSON string, in ASCII. */
void json_string(buffer *b, const char *text);
void json_add_string(buffer *b, const char *name, const char *text);
/* Numbers that JSON does not have become null. */
void json_add_number(buffer *b, const char *name, double value);

#endif
