/* derive.c: multipliers from derivations.
 *
 * A derived row r satisfies content * r = alpha p + beta q, where alpha = |q_c| / g > 0 and |beta|
 * = |p_c| / g, g = gcd(p_c, q_c), make variable c vanish, and content is the divisor that made r
 * primitive. Parents have lower numbers, so one sweep from the highest row down pushes all weight
 * onto the base rows.
 */
#include "elim/store/derive.h"

/* The sweep: slot[row] is 1 + the place of the row's weight in `all`, 0 if it has none. Weights are
 * integers, over one denominator: so they rarely need a greatest common divisor. */
typedef struct sweep {
    fmb_weights all;
    uint32_t *slot;
    mpz_t alpha, beta, t, u, denominator, share;
    mpq_t content, weight;
} sweep;

/* alpha, beta and content of a derived row. A row of zeros may have any positive content. */
static void find_factors(const fmb_elim *e, const fmb_derived *r, sweep *s)
{
    const fmb_vec *p = &e->row[r->p].v, *q = &e->row[r->q].v;
    size_t c = (size_t)r->var, k = 0, n = (size_t)e->n;
    fmb_vec_get(p, c, s->beta);
    fmb_vec_get(q, c, s->alpha);
    mpz_gcd(s->t, s->alpha, s->beta);
    mpz_divexact(s->alpha, s->alpha, s->t);
    mpz_divexact(s->beta, s->beta, s->t);
    if (mpz_sgn(s->alpha) < 0)
        mpz_neg(s->alpha, s->alpha);
    else
        mpz_neg(s->beta, s->beta);
    mpq_set_ui(s->content, 1, 1);
    while (k <= n && fmb_vec_sgn(&r->v, k) == 0)
        k++;
    if (k > n)
        return;
    fmb_vec_get(p, k, s->t);
    mpz_mul(s->t, s->t, s->alpha);
    fmb_vec_get(q, k, s->u);
    mpz_addmul(s->t, s->u, s->beta);
    fmb_vec_get(&r->v, k, s->u);
    if (mpz_divisible_p(s->t, s->u)) { /* else a parent was divided since */
        mpz_divexact(mpq_numref(s->content), s->t, s->u);
        return;
    }
    mpz_set(mpq_numref(s->content), s->t);
    mpz_set(mpq_denref(s->content), s->u);
    mpq_canonicalize(s->content);
}

/* share = the weight at that place over the content, and the weight becomes 0; if the division is
 * not exact, all weights are multiplied by the missing factor first. */
static void take_weight(sweep *s, size_t place)
{
    mpz_ptr weight = mpq_numref(s->all.value[place]), of = mpq_numref(s->content);
    if (!mpz_divisible_p(weight, of)) {
        mpz_gcd(s->t, weight, of);
        mpz_divexact(s->t, of, s->t);
        mpz_mul(s->denominator, s->denominator, s->t);
        for (size_t k = 0; k < s->all.size; k++)
            mpz_mul(mpq_numref(s->all.value[k]), mpq_numref(s->all.value[k]), s->t);
    }
    mpz_divexact(s->share, weight, of);
    mpz_mul(s->share, s->share, mpq_denref(s->content));
    mpz_set_ui(weight, 0);
}

/* Give a parent factor times the share of its child. */
static fmb_status give_parent_its_share(sweep *s, uint32_t parent, const mpz_t factor, fmb_mem *mem)
{
    if (s->slot[parent] != 0) {
        mpz_addmul(mpq_numref(s->all.value[s->slot[parent] - 1]), s->share, factor);
        return FMB_OK;
    }
    mpz_mul(s->u, s->share, factor);
    mpq_set_z(s->weight, s->u);
    FMB_TRY(fmb_weights_add(&s->all, parent, s->weight, mem));
    s->slot[parent] = (uint32_t)s->all.size;
    return FMB_OK;
}

static fmb_status give_weight_to_parents(const fmb_elim *e, sweep *s, uint32_t row)
{
    const fmb_derived *r = &e->row[row];
    if (r->q != FMB_NO_ROW) {
        find_factors(e, r, s);
    } else { /* the reverse of row p */
        mpz_set_si(s->alpha, -1);
        mpq_set_ui(s->content, 1, 1);
    }
    take_weight(s, s->slot[row] - 1);
    FMB_TRY(give_parent_its_share(s, r->p, s->alpha, e->run->mem));
    return r->q != FMB_NO_ROW ? give_parent_its_share(s, r->q, s->beta, e->run->mem) : FMB_OK;
}

static bool has_weight(const sweep *s, uint32_t row)
{
    return s->slot[row] != 0 && mpq_sgn(s->all.value[s->slot[row] - 1]) != 0;
}

/* The remaining weights are those of base rows, last ones first. */
static fmb_status sweep_down_to_base(const fmb_elim *e, sweep *s, uint32_t top, fmb_weights *base)
{
    for (uint32_t i = top + 1; i-- > 0;)
        if (has_weight(s, i) && e->row[i].p != FMB_NO_ROW)
            FMB_TRY(give_weight_to_parents(e, s, i));
    for (uint32_t i = top + 1; i-- > 0;) {
        if (!has_weight(s, i))
            continue;
        mpq_set_num(s->weight, mpq_numref(s->all.value[s->slot[i] - 1]));
        mpq_set_den(s->weight, s->denominator);
        mpq_canonicalize(s->weight);
        FMB_TRY(fmb_weights_add(base, i, s->weight, e->run->mem));
    }
    return FMB_OK;
}

/* Start the sweep with the rows of w; weights of the same row are added. */
static fmb_status start_sweep(sweep *s, const fmb_weights *w, fmb_mem *mem)
{
    mpz_set_ui(s->denominator, 1);
    mpz_set_ui(s->alpha, 1);
    for (size_t i = 0; i < w->size; i++)
        mpz_lcm(s->denominator, s->denominator, mpq_denref(w->value[i]));
    for (size_t i = 0; i < w->size; i++) {
        mpz_divexact(s->u, s->denominator, mpq_denref(w->value[i]));
        mpz_mul(s->share, s->u, mpq_numref(w->value[i]));
        FMB_TRY(give_parent_its_share(s, w->index[i], s->alpha, mem));
    }
    return FMB_OK;
}

fmb_status fmb_elim_derive(const fmb_elim *e, fmb_weights *w)
{
    fmb_mem *mem = e->run->mem;
    fmb_weights base = {0};
    sweep s = {0};
    uint32_t top = 0;
    for (size_t i = 0; i < w->size; i++)
        top = w->index[i] > top ? w->index[i] : top;
    FMB_TRY(FMB_GET_ZERO(mem, s.slot, (size_t)top + 1));
    mpz_inits(s.alpha, s.beta, s.t, s.u, s.denominator, s.share, NULL);
    mpq_inits(s.content, s.weight, NULL);
    fmb_status st = start_sweep(&s, w, mem);
    FMB_THEN(st, sweep_down_to_base(e, &s, top, &base));
    mpz_clears(s.alpha, s.beta, s.t, s.u, s.denominator, s.share, NULL);
    mpq_clears(s.content, s.weight, NULL);
    fmb_weights_clear(&s.all, mem);
    fmb_mem_put(mem, s.slot, (size_t)top + 1, sizeof *s.slot);
    fmb_weights_clear(st == FMB_OK ? w : &base, mem);
    if (st == FMB_OK)
        *w = base;
    return st;
}
