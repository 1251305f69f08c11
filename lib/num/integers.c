/* integers.c: vectors of integers; see integers.h. */
#include "num/integers.h"

#include "num/gcd.h"
#include "num/vec.h"

fmb_status fmb_integers_init(fmb_integers *v, size_t n, fmb_mem *mem)
{
    *v = (fmb_integers){.z = fmb_vec_block(n, mem)};
    v->size = v->z ? n : 0;
    return v->z ? FMB_OK : fmb_mem_status(mem);
}

void fmb_integers_clear(fmb_integers *v, fmb_mem *mem)
{
    fmb_vec_block_free(v->z, v->size, mem);
    fmb_mem_refund(mem, v->limbs * sizeof(mp_limb_t));
    *v = (fmb_integers){0};
}

fmb_status fmb_integers_settle(fmb_integers *v, fmb_mem *mem)
{
    size_t limbs = 0;
    for (size_t i = 0; i < v->size; i++)
        limbs += (size_t)v->z[i]->_mp_alloc;
    fmb_mem_refund(mem, v->limbs * sizeof(mp_limb_t));
    v->limbs = 0;
    if (!fmb_mem_charge(mem, limbs * sizeof(mp_limb_t)))
        return fmb_mem_status(mem);
    v->limbs = limbs;
    return FMB_OK;
}

fmb_status fmb_integers_cancel(mpz_t *x, size_t n, mpz_t den, const fmb_poll *poll)
{
    mpz_t common;
    fmb_status st = FMB_OK;
    mpz_init_set(common, den);
    for (size_t k = 0; st == FMB_OK && k < n && mpz_cmp_ui(common, 1) != 0; k++)
        if (mpz_sgn(x[k]) != 0)
            st = fmb_long_gcd(common, common, x[k], poll);
    if (st == FMB_OK && mpz_cmp_ui(common, 1) != 0) {
        for (size_t k = 0; k < n; k++)
            mpz_divexact(x[k], x[k], common);
        mpz_divexact(den, den, common);
    }
    mpz_clear(common);
    return st;
}

fmb_status fmb_integers_reduce(mpz_t *z, size_t n, mpz_t divisor, const fmb_poll *poll)
{
    mpz_set_ui(divisor, 0);
    for (size_t j = 0; j < n && mpz_cmp_ui(divisor, 1) != 0; j++)
        if (mpz_sgn(z[j]) != 0)
            FMB_TRY(fmb_long_gcd(divisor, divisor, z[j], poll));
    if (mpz_sgn(divisor) == 0)
        mpz_set_ui(divisor, 1);
    for (size_t j = 0; j < n && mpz_cmp_ui(divisor, 1) != 0; j++)
        if (mpz_sgn(z[j]) != 0)
            mpz_divexact(z[j], z[j], divisor);
    return FMB_OK;
}
