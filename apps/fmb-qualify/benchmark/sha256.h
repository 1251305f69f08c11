/* sha256.h: digests of answers, as sha256sum(1) prints them. Source: FIPS 180-4, 2015; to check:
 * that of "abc" begins with ba7816bf. */
#ifndef QUALIFY_SHA256_H
#define QUALIFY_SHA256_H

#include <stddef.h>

enum { QUALIFY_SHA256_TEXT = 65 };

/* The digest of size bytes, in hexadecimal digits and a NUL. */
void qualify_sha256(const char *bytes, size_t size, char out[QUALIFY_SHA256_TEXT]);

#endif
