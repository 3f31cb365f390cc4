/* certificate.h: certificates as text (verify/certificate.md, section 1). */
#ifndef VERIFY_CERTIFICATE_H
#define VERIFY_CERTIFICATE_H

#include "../lib/scheme.h"
#include "buffer.h"
#include "choices.h"

/* Appends the certificate that states: `s` is C1 at the valences c->k, because of the choices c. */
void certificate_write(buffer *z, const scheme *s, const choices *c);

/* Reads a certificate for the scheme `s` back.  The text must be exactly what certificate_write makes of the
   choices: *line then is 0, else the first line that differs or cannot be read.  false: no memory. */
BIGFLOAT_MUST_USE bool certificate_read(choices *c, long *line, const scheme *s, const char *bytes, size_t length);

#endif
