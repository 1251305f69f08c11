/* support_box.c: how far the projection goes along its coordinates; see support.h.
 *
 * An end is asked about like a facet, from the generator that was seen last: either its row stands,
 * or a point beyond is seen, which mostly is the end already.
 */
#include "hull/support/support_private.h"

/* x_j up to (sign 1) or down to (-1) where the point of s->g is, as a normal: v[k + 1]; z[k + 1] is
 * scratch, 0 between calls. */
static fmb_status write_end_as_normal(fmb_support *s, size_t j, int sign, mpz_t *z, fmb_vec *v)
{
    mpz_gcd(s->worker.t, s->g.z[0], s->g.z[j + 1]);
    mpz_divexact(z[0], s->g.z[j + 1], s->worker.t);
    mpz_divexact(z[j + 1], s->g.z[0], s->worker.t);
    mpz_neg(z[sign > 0 ? j + 1 : 0], z[sign > 0 ? j + 1 : 0]);
    fmb_status st = fmb_vec_set_z(v, s->k + 1, z, s->run->mem);
    mpz_set_ui(z[0], 0);
    mpz_set_ui(z[j + 1], 0);
    return st;
}

/* Until the end stands, or a ray is seen, so that there is none. */
static fmb_status find_end(fmb_support *s, size_t j, int sign, mpz_t *z, fmb_vec *v)
{
    fmb_support_row row = {.rel = FMB_LE};
    bool stands = false;
    fmb_status st = FMB_OK;
    for (size_t k = 0; k <= s->k; k++)
        fmb_vec_get(&s->hull.generator[0], k, s->g.z[k]);
    while (st == FMB_OK && !stands && mpz_sgn(s->g.z[0]) != 0) {
        st = write_end_as_normal(s, j, sign, z, v);
        if (st == FMB_OK)
            st = fmb_support_query(s, v, 0, 1, &row, &stands);
    }
    if (st == FMB_OK && stands)
        s->end[s->ends++] = row;
    else
        fmb_support_drop(&row, s->run->mem);
    return st;
}

fmb_status fmb_support_ask_about_end(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    size_t size = s->k + 1, at = s->ends_asked++;
    if (!s->end)
        s->end = fmb_mem_zero(mem, 2 * s->k, sizeof *s->end);
    mpz_t *z = fmb_vec_block(size, mem);
    fmb_vec v = {.s = fmb_mem_zero(mem, size, sizeof *v.s)};
    fmb_status st = s->end && z && v.s ? FMB_OK : fmb_mem_status(mem);
    if (st == FMB_OK)
        st = find_end(s, at / 2, at % 2 ? -1 : 1, z, &v);
    fmb_vec_block_free(z, size, mem);
    fmb_vec_clear(&v, size, mem);
    fmb_mem_put(mem, v.s, size, sizeof *v.s);
    return st;
}

fmb_status fmb_support_keep_ends(fmb_support *s)
{
    fmb_status st = FMB_OK;
    while (st == FMB_OK && s->ends > 0)
        st = fmb_support_keep(s, &s->end[--s->ends]);
    return st;
}

void fmb_support_forget_ends(fmb_support *s)
{
    while (s->ends > 0)
        fmb_support_drop(&s->end[--s->ends], s->run->mem);
    fmb_mem_put(s->run->mem, s->end, 2 * s->k, sizeof *s->end);
    s->end = NULL;
}
