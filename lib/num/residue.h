/* residue.h: residues modulo a prime of 29 bits, a cheap proof that a product is not 0.
 *
 * Products of two residues have less than 58 bits: 64 of them fit into a word together.
 */
#ifndef FMB_NUM_RESIDUE_H
#define FMB_NUM_RESIDUE_H

#include "num/vec.h"

#define FMB_RESIDUE_PRIME 536870909u
#define FMB_RESIDUE_TERMS 64

static inline uint32_t fmb_residue_of_integer(mpz_srcptr x)
{
    return (uint32_t)fmb_integer_modulo_u64(x, FMB_RESIDUE_PRIME);
}

/* The residue of entry j of v. */
static inline uint32_t fmb_residue_of_entry(const fmb_vec *v, size_t j)
{
    if (v->z)
        return fmb_residue_of_integer(v->z[j]);
    int64_t rest = v->s[j] % (int64_t)FMB_RESIDUE_PRIME;
    return (uint32_t)(rest < 0 ? rest + FMB_RESIDUE_PRIME : rest);
}

/* May a.b be 0? If the answer is no, a.b is certainly not 0. */
static inline bool fmb_residues_vanish(const uint32_t *a, const uint32_t *b, size_t n)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < n; k++) {
        sum += (uint64_t)a[k] * b[k];
        if (k % FMB_RESIDUE_TERMS == FMB_RESIDUE_TERMS - 1)
            sum %= FMB_RESIDUE_PRIME;
    }
    return sum % FMB_RESIDUE_PRIME == 0;
}

#endif
