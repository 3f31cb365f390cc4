#ifndef CHECK_SHA256_H
#define CHECK_SHA256_H

/* SHA-256 (FIPS 180-4): 64 lower-case hexadecimal digits and a final 0. */

#include <stddef.h>

void sha256_hex(char out[65], const unsigned char *data, size_t size);

#endif
