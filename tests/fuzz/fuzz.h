/* fuzz.h: what the fuzz targets share.

   A target is a file with one function LLVMFuzzerTestOneInput, libFuzzer's name for "try these bytes": it returns
   fuzz_result() of what its parser said, and every other end is a bug.  `make fuzz` links it with libFuzzer and
   the sanitizers, `make check` with replay.c, which tries the kept inputs of tests/fuzz/inputs/. */
#ifndef TESTS_FUZZ_FUZZ_H
#define TESTS_FUZZ_FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Longer inputs are left out: they say nothing that shorter ones do not. */
enum { FUZZ_MAX_BYTES = 60000 };

/* 0, always.  Remembers whether the input was accepted, for replay.c. */
int fuzz_result(bool accepted);

/* Whether the last input was accepted. */
bool fuzz_was_accepted(void);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

#endif
