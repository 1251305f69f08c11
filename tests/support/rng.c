/* rng.c: random numbers; see support.h. */
#include "support.h"

uint64_t support_next(support_rng *g)
{
    uint64_t z = (g->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

int support_between(support_rng *g, int lo, int hi)
{
    return lo + (int)(support_next(g) % (uint64_t)(hi - lo + 1));
}

bool support_chance(support_rng *g, int percent)
{
    return support_between(g, 1, 100) <= percent;
}

void support_integer(support_rng *g, int bits, mpz_t out)
{
    mpz_set_si(out, support_between(g, -9, 9));
    if (bits == 0 || support_chance(g, 40))
        return;
    mpz_set_ui(out, 1);
    mpz_mul_2exp(out, out, (mp_bitcnt_t)bits);
    int near = support_between(g, -2, 2);
    if (near < 0)
        mpz_sub_ui(out, out, (unsigned)-near);
    else
        mpz_add_ui(out, out, (unsigned)near);
    if (support_chance(g, 50))
        mpz_neg(out, out);
}
