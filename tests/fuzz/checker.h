/* checker.h: the checker's functions inside a test.

   The checker ends the program where it rejects something, and reads files.  Here it is compiled with other names
   for exit and fopen (tests/local.mk), which come back to the caller and read from memory. */
#ifndef TESTS_FUZZ_CHECKER_H
#define TESTS_FUZZ_CHECKER_H

#include <stddef.h>
#include <stdio.h>

/* Runs run(argument) and gives back all memory.  The exit status that the checker would have ended with, or -1 if it
   went on to the end. */
int checker_try(void (*run)(void *), void *argument);

/* What the next files with these names contain, until it is said anew; any other file does not exist. */
void checker_set_file(const char *name, const char *bytes, size_t size);

#endif
