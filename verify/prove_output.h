/* prove_output.h: what `prove` says of one valence: a line for people, or a JSON object. */
#ifndef VERIFY_PROVE_OUTPUT_H
#define VERIFY_PROVE_OUTPUT_H

#include "escalate.h"

/* certificate: where it was kept, NULL if nowhere. */
void prove_print_line(const char *name, const decision *d, const char *certificate);
void prove_print_json(const char *name, const decision *d, const char *certificate);

/* The log of a decision, one JSON object per attempt and line. */
void prove_write_log(buffer *b, const decision *d);

#endif
