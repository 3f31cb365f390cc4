/* certificate_exact.h: the records of exact eigenvalues (verify/exact.md, section 1). */
#ifndef VERIFY_CERTIFICATE_EXACT_H
#define VERIFY_CERTIFICATE_EXACT_H

#include "buffer.h"
#include "choices.h"

/* The lines from `field` to `exact`. */
void certificate_write_exact(buffer *z, const choices *c);

typedef enum { CERTIFICATE_READ, CERTIFICATE_MALFORMED, CERTIFICATE_NO_MEMORY } certificate_status;

/* Reads these lines and moves *at behind them.  Whatever the words leave open is settled by comparing with what would be
   written. */
certificate_status certificate_read_exact(choices *c, const char **at, const char *end);

#endif
