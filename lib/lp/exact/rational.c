/* rational.c: fractions from residues; see rational.h. */
#include "lp/exact/rational.h"

#include <stdint.h>

void fmb_rational_init(fmb_rational *w)
{
    mpz_inits(w->r, w->s, w->x, w->y, w->t, w->u, NULL);
}

void fmb_rational_clear(fmb_rational *w)
{
    mpz_clears(w->r, w->s, w->x, w->y, w->t, w->u, NULL);
}

/* r = x y0 and s = y y0 modulo m, all along; the first remainder that is short enough has the
 * fraction, if any has. */
bool fmb_rational_find(fmb_rational *w, const mpz_t y0, const mpz_t m, size_t a_bits, size_t b_bits,
                       mpz_t a, mpz_t b)
{
    mpz_set(w->r, m);
    mpz_set(w->s, y0);
    mpz_set_ui(w->x, 0);
    mpz_set_ui(w->y, 1);
    while (mpz_sizeinbase(w->s, 2) > a_bits) {
        mpz_tdiv_qr(w->t, w->r, w->r, w->s);
        mpz_submul(w->x, w->t, w->y);
        mpz_swap(w->r, w->s);
        mpz_swap(w->x, w->y);
    }
    if (mpz_sizeinbase(w->y, 2) > b_bits)
        return false;
    mpz_gcd(w->t, w->s, w->y);
    if (mpz_cmp_ui(w->t, 1) != 0)
        return false;
    mpz_set(a, w->s);
    mpz_set(b, w->y);
    if (mpz_sgn(b) < 0) {
        mpz_neg(a, a);
        mpz_neg(b, b);
    }
    return true;
}
