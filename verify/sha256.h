/* sha256.h: the digest that ends a certificate (FIPS 180-4). */
#ifndef VERIFY_SHA256_H
#define VERIFY_SHA256_H

#include <stddef.h>

/* hex = the SHA-256 digest of the bytes as 64 lower-case hexadecimal digits and NUL. */
void sha256_hex(char hex[65], const char *bytes, size_t length);

#endif
