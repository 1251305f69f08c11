/* derive.c: multipliers from derivations.
 *
 * A derived row r satisfies content * r = alpha p + beta q, where alpha = |q_c| / g > 0 and |beta|
 * = |p_c| / g, g = gcd(p_c, q_c), make variable c vanish, and content is the divisor that made r
 * primitive. Parents have lower numbers, so one sweep from the highest row down pushes all weight
 * onto the base rows.
 */
#include "elim/store/derive.h"

/* The sweep: slot[row] is 1 + the place of the row's weight in `all`, 0 if it has none. */
typedef struct sweep {
    fmb_weights all;
    uint32_t *slot;
    mpz_t alpha, beta, t, u;
    mpq_t content, share;
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
    mpz_set(mpq_numref(s->content), s->t);
    mpz_set(mpq_denref(s->content), s->u);
    mpq_canonicalize(s->content);
}

/* Give a parent factor / content times the weight of its child. */
static fmb_status give_parent_its_share(sweep *s, uint32_t parent, const mpz_t factor,
                                        const mpq_t weight, fmb_mem *mem)
{
    mpq_set_z(s->share, factor);
    mpq_mul(s->share, s->share, weight);
    mpq_div(s->share, s->share, s->content);
    if (s->slot[parent] != 0) {
        mpq_ptr sum = s->all.value[s->slot[parent] - 1];
        mpq_add(sum, sum, s->share);
        return FMB_OK;
    }
    fmb_status st = fmb_weights_add(&s->all, parent, s->share, mem);
    if (st == FMB_OK)
        s->slot[parent] = (uint32_t)s->all.size;
    return st;
}

static fmb_status sweep_down_to_base(const fmb_elim *e, sweep *s, uint32_t top, fmb_weights *base)
{
    fmb_mem *mem = e->run->mem;
    fmb_status st = FMB_OK;
    mpq_t weight;
    mpq_init(weight);
    for (uint32_t i = top + 1; st == FMB_OK && i-- > 0;) {
        if (s->slot[i] == 0)
            continue;
        const fmb_derived *r = &e->row[i];
        mpq_set(weight, s->all.value[s->slot[i] - 1]);
        if (mpq_sgn(weight) == 0)
            continue;
        if (r->p == FMB_NO_ROW) {
            st = fmb_weights_add(base, i, weight, mem);
            continue;
        }
        if (r->q == FMB_NO_ROW) { /* the reverse of row p */
            mpq_neg(weight, weight);
            mpz_set_ui(s->alpha, 1);
            mpq_set_ui(s->content, 1, 1);
            st = give_parent_its_share(s, r->p, s->alpha, weight, mem);
            continue;
        }
        find_factors(e, r, s);
        st = give_parent_its_share(s, r->p, s->alpha, weight, mem);
        if (st == FMB_OK)
            st = give_parent_its_share(s, r->q, s->beta, weight, mem);
    }
    mpq_clear(weight);
    return st;
}

/* Start the sweep with the rows of w: rows named twice are added up. */
static fmb_status start_sweep(sweep *s, const fmb_weights *w, fmb_mem *mem)
{
    mpz_t one;
    fmb_status st = FMB_OK;
    mpz_init_set_ui(one, 1);
    mpq_set_ui(s->content, 1, 1);
    for (size_t i = 0; st == FMB_OK && i < w->size; i++)
        st = give_parent_its_share(s, w->index[i], one, w->value[i], mem);
    mpz_clear(one);
    return st;
}

fmb_status fmb_elim_derive(const fmb_elim *e, fmb_weights *w)
{
    fmb_mem *mem = e->run->mem;
    fmb_weights base = {0};
    sweep s = {0};
    uint32_t top = 0;
    for (size_t i = 0; i < w->size; i++)
        top = w->index[i] > top ? w->index[i] : top;
    s.slot = fmb_mem_zero(mem, (size_t)top + 1, sizeof *s.slot);
    if (!s.slot)
        return fmb_mem_status(mem);
    mpz_inits(s.alpha, s.beta, s.t, s.u, NULL);
    mpq_inits(s.content, s.share, NULL);
    fmb_status st = start_sweep(&s, w, mem);
    if (st == FMB_OK)
        st = sweep_down_to_base(e, &s, top, &base);
    mpz_clears(s.alpha, s.beta, s.t, s.u, NULL);
    mpq_clears(s.content, s.share, NULL);
    fmb_weights_clear(&s.all, mem);
    fmb_mem_put(mem, s.slot, (size_t)top + 1, sizeof *s.slot);
    fmb_weights_clear(st == FMB_OK ? w : &base, mem);
    if (st == FMB_OK)
        *w = base;
    return st;
}
