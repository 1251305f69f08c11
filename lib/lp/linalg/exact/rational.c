/* rational.c: rational reconstruction; see rational.h. */
#include "lp/linalg/exact/rational.h"

#include <stdint.h>

#include "num/gcd.h"
#include "num/word.h"

void fmb_rational_init(fmb_rational *w)
{
    mpz_inits(w->r, w->s, w->x, w->y, w->t, w->u, NULL);
}

void fmb_rational_clear(fmb_rational *w)
{
    mpz_clears(w->r, w->s, w->x, w->y, w->t, w->u, NULL);
}

/* ---- quotients from leading bits ------------------------------------------------------------- */

/* Leading bits of r and s that are used; their combinations have half as many. */
#define LEAD_BITS 62
#define HALF      ((int64_t)1 << 31)

/* Some steps of Euclid's algorithm: r, s become u[0] r + v[0] s, u[1] r + v[1] s. */
typedef struct steps {
    int64_t u[2], v[2];
} steps;

/* The steps that the leading bits of r and s determine: Jebelean 1993, A generalization of the
 * binary GCD algorithm, theorem 1: a quotient is that of r and s if its remainder is at least
 * |v_1|, and less than the divisor by at least |v_0| + |v_1|. (|u| <= |v|, as r > s.) */
static steps find_sure_steps(int64_t r, int64_t s)
{
    steps h = {{1, 0}, {0, 1}};
    while (s >= 2 * HALF) {
        int64_t q = r / s, rest = r - q * s;
        if (q >= HALF || rest < 2 * HALF || s - rest < 2 * HALF)
            return h;
        int64_t u = h.u[0] - q * h.u[1], v = h.v[0] - q * h.v[1];
        if (v >= HALF || v <= -HALF)
            return h;
        h = (steps){{h.u[1], u}, {h.v[1], v}};
        r = s;
        s = rest;
    }
    return h;
}

/* out = p a + q b. */
static void combine_integers(mpz_t out, const mpz_t a, int64_t p, const mpz_t b, int64_t q)
{
    fmb_integer_times_i64(out, a, p);
    fmb_integer_add_product_i64(out, b, q);
}

static void combine_pair(fmb_rational *w, mpz_t a, mpz_t b, const steps *h)
{
    combine_integers(w->t, a, h->u[0], b, h->v[0]);
    combine_integers(w->u, a, h->u[1], b, h->v[1]);
    mpz_swap(a, w->t);
    mpz_swap(b, w->u);
}

/* Several steps at once, after which s is still longer than a_bits: its leading bits are at least
 * twice HALF, and the omitted bits make less than |v| of that. */
static bool take_sure_steps(fmb_rational *w, size_t a_bits)
{
    size_t bits = mpz_sizeinbase(w->r, 2);
    if (bits < LEAD_BITS || bits - LEAD_BITS + 30 <= a_bits)
        return false;
    mpz_tdiv_q_2exp(w->t, w->r, bits - LEAD_BITS);
    mpz_tdiv_q_2exp(w->u, w->s, bits - LEAD_BITS);
    steps h = find_sure_steps(fmb_integer_get_i64(w->t), fmb_integer_get_i64(w->u));
    if (h.u[1] == 0)
        return false;
    combine_pair(w, w->r, w->s, &h);
    combine_pair(w, w->x, w->y, &h);
    return true;
}

/* ---- fractions ------------------------------------------------------------------------------- */

static void take_step(fmb_rational *w)
{
    mpz_tdiv_qr(w->t, w->r, w->r, w->s);
    mpz_submul(w->x, w->t, w->y);
    mpz_swap(w->r, w->s);
    mpz_swap(w->x, w->y);
}

/* One poll for this many steps, which take at most milliseconds. */
#define ASKING_STEPS 64

/* r = x y0 and s = y y0 modulo m, always; the first remainder that is short enough gives the
 * fraction, if there is one. */
bool fmb_rational_find(fmb_rational *w, const mpz_t y0, const mpz_t m, size_t a_bits, size_t b_bits,
                       mpz_t a, mpz_t b, const fmb_poll *poll)
{
    mpz_set(w->r, m);
    mpz_set(w->s, y0);
    mpz_set_ui(w->x, 0);
    mpz_set_ui(w->y, 1);
    for (size_t step = 1; mpz_sizeinbase(w->s, 2) > a_bits; step++) {
        if (!take_sure_steps(w, a_bits))
            take_step(w);
        if (step % ASKING_STEPS == 0 && fmb_poll_ask(poll) != FMB_OK)
            return false;
    }
    if (mpz_sizeinbase(w->y, 2) > b_bits)
        return false;
    if (fmb_long_gcd(w->t, w->s, w->y, poll) != FMB_OK || mpz_cmp_ui(w->t, 1) != 0)
        return false;
    mpz_set(a, w->s);
    mpz_set(b, w->y);
    if (mpz_sgn(b) < 0) {
        mpz_neg(a, a);
        mpz_neg(b, b);
    }
    return true;
}
