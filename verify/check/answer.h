#ifndef CHECK_ANSWER_H
#define CHECK_ANSWER_H

/* Answers
 * =======
 *
 * Section 11 of certificate.md.  There are three: verified, rejected, cannot check.  Only main()
 * gives the first, after everything else has returned.  The two others may be given anywhere; they
 * end the program at once, so no caller can forget to look at a result.  stdout has a line for each
 * certificate that is verified; the other answers go to stderr.
 */

#include <stddef.h>
#include <stdnoreturn.h>

enum { ANSWER_VERIFIED = 0, ANSWER_REJECTED = 1, ANSWER_CANNOT_CHECK = 2 };

/* "rejected: FILE:LINE: ..." (without a place if file is NULL) and exit status 1. */
#define rejected(file, line, ...) answer(ANSWER_REJECTED, file, line, 0, __VA_ARGS__)

/* "cannot check: ..." and exit status 2; or "cannot check: FILE:LINE: ..." (or
 * FILE:LINE:COLUMN if column > 0). */
#define cannot_check(...) answer(ANSWER_CANNOT_CHECK, NULL, 0, 0, __VA_ARGS__)
#define cannot_check_at(file, line, column, ...) \
    answer(ANSWER_CANNOT_CHECK, file, line, column, __VA_ARGS__)

noreturn void answer(int status, const char *file, int line, int column, const char *format, ...);

#endif
