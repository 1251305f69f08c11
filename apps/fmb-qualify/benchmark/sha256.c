/* sha256.c: see sha256.h. Names are those of FIPS 180-4, sections 4.1.2, 5.1.1 and 6.2.
 *
 * Its constants are the first 32 bits of the fractions of roots of the first primes: cube roots in
 * K, square roots in H. They are computed here as whole numbers: the largest r with r^3 <= p 2^96,
 * and the same for squares.
 */
#include "fmb-qualify/benchmark/sha256.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <gmp.h>

enum { BLOCK = 64, ROUNDS = 64, WORDS = 8 };

/* The first 32 bits of the fraction of the root of p of that degree, 2 or 3. */
static uint32_t root_fraction(unsigned long p, unsigned long degree)
{
    mpz_t x;
    mpz_init_set_ui(x, p);
    mpz_mul_2exp(x, x, 32 * degree);
    mpz_root(x, x, degree);
    mpz_fdiv_r_2exp(x, x, 32);
    uint32_t bits = (uint32_t)mpz_get_ui(x);
    mpz_clear(x);
    return bits;
}

static unsigned long prime_after(unsigned long p)
{
    mpz_t x;
    mpz_init_set_ui(x, p);
    mpz_nextprime(x, x);
    p = mpz_get_ui(x);
    mpz_clear(x);
    return p;
}

static uint32_t rotr(uint32_t x, int n)
{
    return x >> n | x << (32 - n);
}

static void message_schedule(const uint8_t block[BLOCK], uint32_t w[ROUNDS])
{
    for (int t = 0; t < 16; t++)
        w[t] = (uint32_t)block[4 * t] << 24 | (uint32_t)block[4 * t + 1] << 16 |
               (uint32_t)block[4 * t + 2] << 8 | block[4 * t + 3];
    for (int t = 16; t < ROUNDS; t++) {
        uint32_t x = w[t - 2], y = w[t - 15];
        w[t] = (rotr(x, 17) ^ rotr(x, 19) ^ x >> 10) + w[t - 7] +
               (rotr(y, 7) ^ rotr(y, 18) ^ y >> 3) + w[t - 16];
    }
}

static void compress(uint32_t h[WORDS], const uint32_t k[ROUNDS], const uint8_t block[BLOCK])
{
    uint32_t w[ROUNDS], v[WORDS];
    message_schedule(block, w);
    memcpy(v, h, sizeof v);
    for (int t = 0; t < ROUNDS; t++) {
        uint32_t a = v[0], e = v[4];
        uint32_t t1 = v[7] + (rotr(e, 6) ^ rotr(e, 11) ^ rotr(e, 25)) + ((e & v[5]) ^ (~e & v[6])) +
                      k[t] + w[t];
        uint32_t t2 =
            (rotr(a, 2) ^ rotr(a, 13) ^ rotr(a, 22)) + ((a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]));
        memmove(v + 1, v, (WORDS - 1) * sizeof *v);
        v[4] += t1;
        v[0] = t1 + t2;
    }
    for (int i = 0; i < WORDS; i++)
        h[i] += v[i];
}

/* The last bytes, a one, zeros, and the length in bits. */
static size_t pad(const char *rest, size_t n, size_t size, uint8_t out[2 * BLOCK])
{
    size_t whole = n + 9 <= BLOCK ? BLOCK : 2 * BLOCK;
    uint64_t bits = 8 * (uint64_t)size;
    memset(out, 0, 2 * BLOCK);
    memcpy(out, rest, n);
    out[n] = 0x80;
    for (size_t i = 0; i < 8; i++)
        out[whole - 1 - i] = (uint8_t)(bits >> 8 * i);
    return whole;
}

void qualify_sha256(const char *bytes, size_t size, char out[QUALIFY_SHA256_TEXT])
{
    uint32_t h[WORDS], k[ROUNDS];
    uint8_t block[2 * BLOCK];
    unsigned long p = 1;
    for (int t = 0; t < ROUNDS; t++) {
        p = prime_after(p);
        k[t] = root_fraction(p, 3);
        if (t < WORDS)
            h[t] = root_fraction(p, 2);
    }
    size_t at = 0;
    for (; size - at >= BLOCK; at += BLOCK) {
        memcpy(block, bytes + at, BLOCK);
        compress(h, k, block);
    }
    size_t whole = pad(bytes + at, size - at, size, block);
    for (size_t i = 0; i < whole; i += BLOCK)
        compress(h, k, block + i);
    for (int i = 0; i < WORDS; i++)
        snprintf(out + 8 * i, 9, "%08x", (unsigned)h[i]);
}
