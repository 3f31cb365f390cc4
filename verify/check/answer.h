#ifndef CHECK_ANSWER_H
#define CHECK_ANSWER_H

/* Answers
 * =======
 *
 * Section 10 of certificate.md.  There are three: verified, rejected, cannot
 * check.  Only main() gives the first, after everything else has returned.
 * The two others may be given anywhere; they end the program at once, so no
 * caller can forget to look at a result.  stdout has a line for each certificate that
 * is verified; the other answers go to stderr.
 */

#include <stddef.h>
#include <stdnoreturn.h>

enum { ANSWER_VERIFIED = 0, ANSWER_REJECTED = 1, ANSWER_CANNOT_CHECK = 2 };

/* "rejected: FILE:LINE: ..." and exit status 1. */
noreturn void rejected(const char *file, int line, const char *format, ...);

/* "cannot check: ..." and exit status 2. */
noreturn void cannot_check(const char *format, ...);

/* "cannot check: FILE:LINE: ..." (or FILE:LINE:COLUMN if column > 0). */
noreturn void cannot_check_at(const char *file, int line, int column,
                              const char *format, ...);

#endif
