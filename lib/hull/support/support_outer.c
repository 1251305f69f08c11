/* support_outer.c: rows that hold on the projection, and may touch it, but are no facets; see
 * support.h.
 *
 * To maximize in a direction is a query like that of a facet, starting from the last point found:
 * either its row is proved, or a point beyond is found, which mostly is optimal already.
 */
#include "hull/support/support_private.h"

/* v[k + 1] = h with the first entry that makes it 0 at the point of s->g; z[k + 1] is scratch, 0
 * between calls. */
static fmb_status move_to_point(fmb_support *s, const fmb_vec *h, mpz_t *z, fmb_vec *v)
{
    mpz_t content;
    fmb_poll poll = fmb_run_asked(s->run);
    mpz_init(content);
    for (size_t j = 1; j <= s->k; j++) {
        fmb_vec_get(h, j, z[j]);
        mpz_submul(z[0], z[j], s->g.z[j]);
        mpz_mul(z[j], z[j], s->g.z[0]);
    }
    fmb_status st = fmb_integers_reduce(z, s->k + 1, content, &poll);
    FMB_THEN(st, fmb_vec_set_z(v, s->k + 1, z, s->run->mem));
    for (size_t j = 0; j <= s->k; j++)
        mpz_set_ui(z[j], 0);
    mpz_clear(content);
    return st;
}

static fmb_status keep_outer_row(fmb_support *s, fmb_support_row *row)
{
    fmb_status st = FMB_RESERVE(s->run->mem, &s->outer, &s->outer_capacity, s->outers + 1);
    if (st == FMB_OK)
        s->outer[s->outers++] = *row;
    else
        fmb_support_drop(row, s->run->mem);
    return st;
}

/* Query until the row is proved, or a ray is found, so that there is none. */
static fmb_status find_outer_row(fmb_support *s, const fmb_vec *h, mpz_t *z, fmb_vec *v)
{
    fmb_support_row row = {.rel = FMB_LE};
    bool stands = false;
    fmb_status st = FMB_OK;
    while (st == FMB_OK && !stands && mpz_sgn(s->g.z[0]) != 0) {
        st = move_to_point(s, h, z, v);
        FMB_THEN(st, fmb_support_query(s, v, 1, &row, &stands));
    }
    if (st == FMB_OK && stands)
        return keep_outer_row(s, &row);
    fmb_support_drop(&row, s->run->mem);
    return st;
}

fmb_status fmb_support_look_along(fmb_support *s, const fmb_vec *h)
{
    fmb_mem *mem = s->run->mem;
    size_t size = s->k + 1;
    mpz_t *z = fmb_vec_block(size, mem);
    fmb_vec v = {.s = fmb_mem_zero(mem, size, sizeof *v.s)};
    fmb_status st = z && v.s ? FMB_OK : fmb_mem_status(mem);
    FMB_THEN(st, find_outer_row(s, h, z, &v));
    fmb_vec_block_free(z, size, mem);
    fmb_vec_clear(&v, size, mem);
    fmb_mem_put(mem, v.s, size, sizeof *v.s);
    return st;
}

fmb_status fmb_support_ask_about_end(fmb_support *s)
{
    size_t at = s->ends_asked++, size = s->k + 1;
    fmb_vec h = {.s = fmb_mem_zero(s->run->mem, size, sizeof *h.s), .bits = 1};
    if (!h.s)
        return fmb_mem_status(s->run->mem);
    h.s[at / 2 + 1] = at % 2 ? 1 : -1;
    for (size_t j = 0; j <= s->k; j++)
        fmb_vec_get(&s->hull.generator[0], j, s->g.z[j]);
    fmb_status st = fmb_support_look_along(s, &h);
    fmb_mem_put(s->run->mem, h.s, size, sizeof *h.s);
    return st;
}

fmb_status fmb_support_keep_outer_rows(fmb_support *s)
{
    while (s->outers > 0)
        FMB_TRY(fmb_support_keep(s, &s->outer[--s->outers]));
    return FMB_OK;
}

void fmb_support_forget_outer_rows(fmb_support *s)
{
    while (s->outers > 0)
        fmb_support_drop(&s->outer[--s->outers], s->run->mem);
    fmb_mem_put(s->run->mem, s->outer, s->outer_capacity, sizeof *s->outer);
    s->outer = NULL;
}
