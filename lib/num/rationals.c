/* rationals.c: vectors of rationals; see rationals.h. */
#include "num/rationals.h"

#include <math.h>

/* What malloc takes for the limb of a denominator 1. */
#define FIRST_LIMB ((size_t)32)

fmb_status fmb_rationals_new(mpq_t **out, size_t n, fmb_mem *mem)
{
    mpq_t *x = fmb_mem_get(mem, n, sizeof *x);
    if (!x)
        return fmb_mem_status(mem);
    if (!fmb_mem_charge(mem, n * FIRST_LIMB)) {
        fmb_mem_put(mem, x, n, sizeof *x);
        return fmb_mem_status(mem);
    }
    for (size_t j = 0; j < n; j++)
        mpq_init(x[j]);
    *out = x;
    return FMB_OK;
}

void fmb_rationals_free(mpq_t *x, size_t n, fmb_mem *mem)
{
    if (!x)
        return;
    for (size_t j = 0; j < n; j++)
        mpq_clear(x[j]);
    fmb_mem_refund(mem, n * FIRST_LIMB);
    fmb_mem_put(mem, x, n, sizeof *x);
}

/* The double nearest to q: mpq_get_d cuts towards zero, so the answer is that or the next one
 * outward, whichever lies on q's side of the middle (inward on the middle itself). */
double fmb_nearest_double(mpq_srcptr q)
{
    if (!q)
        return 0;
    double in = mpq_get_d(q), out = nextafter(in, mpq_sgn(q) < 0 ? -INFINITY : INFINITY);
    if (mpq_sgn(q) == 0 || isinf(out))
        return in;
    mpq_t middle, other;
    mpq_inits(middle, other, NULL);
    mpq_set_d(middle, in);
    mpq_set_d(other, out);
    mpq_add(middle, middle, other);
    mpq_div_2exp(middle, middle, 1);
    bool beyond = mpq_cmp(q, middle) * mpq_sgn(q) > 0;
    mpq_clears(middle, other, NULL);
    return beyond ? out : in;
}
