/* left-out.h: the checker with some check left out, for disable-checks. */
#ifndef TESTS_CHECK_LEFT_OUT_H
#define TESTS_CHECK_LEFT_OUT_H

/* Whether the check of this number is the one to be left out (LEFT_OUT in the environment). */
_Bool left_out(int check);

/* A call of a function that rejects something. */
#define unless_left_out(check, call, ...) (left_out(check) ? (void)0 : call(__VA_ARGS__))

#endif
