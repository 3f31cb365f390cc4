/* statement.h: what a certificate claims, read from its first lines; the same for certificates of all versions. */
#ifndef VERIFY_STATEMENT_H
#define VERIFY_STATEMENT_H

#include "valence_range.h"

#include <stddef.h>

/* The newest version, which certificate_write writes. */
enum { STATEMENT_NEWEST_VERSION = 1 };

typedef struct {
    int version;
    const char *scheme; /* its text, scheme_length bytes, within the certificate */
    size_t scheme_length;
    bool c1;            /* the claim: else not C1 */
    valence_range valences;
    long grid;          /* bits; 0: not to be seen */
} statement;

/* NULL: well; else what is wrong with line *line (a sentence; static storage).  Nothing is proved by this. */
const char *statement_read(statement *z, long *line, const char *bytes, size_t length);

/* Does it claim something about this scheme (canonical text)? */
bool statement_is_about(const statement *z, const char *scheme, size_t length);

#endif
