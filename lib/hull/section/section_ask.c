/* section_ask.c: a section of a cone, and its vertices as rays; see section.h. */
#include "hull/section/section.h"

/* ---- independent rows ------------------------------------------------------------------------ */

/* The last column where v is not 0; d: it is 0. */
static size_t find_last_entry(const fmb_vec *v, size_t d)
{
    for (size_t j = d; j-- > 0;)
        if (fmb_vec_sgn(v, j) != 0)
            return j;
    return d;
}

/* Add row i to the base if it is independent of it. */
static fmb_status try_row_for_base(fmb_section *c, size_t i)
{
    fmb_vec *v = &c->base[c->rank];
    FMB_TRY(fmb_vec_copy(v, &c->row[i], c->d, c->run->mem));
    for (size_t k = 0; k < c->rank; k++)
        if (fmb_vec_sgn(v, c->pivot[k]) != 0)
            FMB_TRY(fmb_vec_cancel(v, v, &c->base[k], c->d, c->pivot[k], &c->num));
    size_t pivot = find_last_entry(v, c->d);
    if (pivot == c->d)
        return FMB_OK;
    c->pivot[c->rank] = pivot;
    c->chosen[c->rank++] = i;
    return FMB_OK;
}

static fmb_status find_base(fmb_section *c)
{
    for (size_t i = 0; i < c->m && c->rank < c->d; i++) {
        FMB_TRY(try_row_for_base(c, i));
        FMB_TRY(fmb_run_poll_step(c->run, fmb_vec_is_wide(&c->row[i])));
    }
    return FMB_OK;
}

/* ---- the program ----------------------------------------------------------------------------- */

static void list_columns(fmb_section *c)
{
    int n = 0;
    for (size_t i = 0; i < c->rank; i++)
        if (c->pivot[i] != c->gone) {
            c->kept[n] = n;
            c->column[n++] = (int)c->pivot[i];
        }
}

/* g.x >= 0 with x_gone = (1 - the others of w.x) / w_gone, times |w_gone|, as z.x <= z[n]. */
static void write_row_of_section(const fmb_section *c, const fmb_vec *g, mpz_t *z, mpz_t size)
{
    size_t n = c->rank - 1;
    fmb_vec_get(g, c->gone, z[n]);
    if (mpz_sgn(c->w.z[c->gone]) < 0)
        mpz_neg(z[n], z[n]);
    mpz_abs(size, c->w.z[c->gone]);
    for (size_t k = 0; k < n; k++) {
        fmb_vec_get(g, (size_t)c->column[k], z[k]);
        mpz_mul(z[k], z[k], size);
        mpz_neg(z[k], z[k]);
        mpz_addmul(z[k], z[n], c->w.z[c->column[k]]);
    }
}

/* A row without coefficients is trivial, or shows that there is no point. */
static fmb_status add_row_of_section(fmb_section *c, size_t i, mpz_t *z, mpz_t gcd)
{
    size_t n = c->rank - 1;
    write_row_of_section(c, &c->row[i], z, gcd);
    mpz_set_ui(gcd, 0);
    for (size_t k = 0; k < n; k++)
        mpz_gcd(gcd, gcd, z[k]);
    if (mpz_sgn(gcd) == 0) {
        c->empty |= mpz_sgn(z[n]) < 0;
        return FMB_OK;
    }
    mpz_gcd(gcd, gcd, z[n]);
    for (size_t k = 0; k <= n; k++)
        mpz_divexact(z[k], z[k], gcd);
    FMB_TRY(fmb_program_add_integers(&c->program, z, FMB_LE));
    return fmb_run_poll(c->run);
}

static fmb_status write_program(fmb_section *c)
{
    fmb_status st = FMB_OK;
    mpz_t *z = fmb_vec_block(c->rank, c->run->mem);
    if (!z)
        return fmb_mem_status(c->run->mem);
    for (size_t i = 0; st == FMB_OK && i < c->m; i++)
        st = add_row_of_section(c, i, z, c->num.t);
    fmb_vec_block_free(z, c->rank, c->run->mem);
    return st;
}

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status make_room_for_section(fmb_section *c)
{
    size_t d = c->d;
    FMB_TRY(FMB_ARENA_GET(&c->arena, c->base, d));
    FMB_TRY(FMB_ARENA_GET(&c->arena, c->pivot, d));
    FMB_TRY(FMB_ARENA_GET(&c->arena, c->chosen, d));
    FMB_TRY(FMB_ARENA_GET(&c->arena, c->column, d));
    FMB_TRY(FMB_ARENA_GET(&c->arena, c->kept, d));
    for (size_t i = 0; i < d; i++)
        c->base[i] = (fmb_vec){0};
    for (size_t i = 0; i < d; i++)
        FMB_TRY(FMB_ARENA_GET(&c->arena, c->base[i].s, d));
    return fmb_integers_init(&c->w, d, c->run->mem);
}

static fmb_status begin_queries(fmb_section *c)
{
    bool feasible;
    FMB_TRY(fmb_oracle_new(c->run, &c->program, &c->oracle));
    FMB_TRY(fmb_oracle_feasible(c->oracle, &feasible));
    c->empty = !feasible;
    if (c->empty)
        return FMB_OK;
    c->begun = true;
    size_t n = c->rank - 1;
    FMB_TRY(fmb_support_init(&c->support, c->run, c->oracle, n, c->kept, n, false, false));
    return fmb_support_know_rows(&c->support, &c->program);
}

fmb_status fmb_section_open(fmb_section *c, fmb_run *run, const fmb_vec *row, size_t m, size_t d)
{
    *c = (fmb_section){.run = run, .d = d, .m = m, .row = row};
    fmb_arena_init(&c->arena, run->mem);
    fmb_program_init(&c->program, run->mem, 0);
    FMB_TRY(fmb_run_open_num(run, &c->num, d, false));
    FMB_TRY(make_room_for_section(c));
    FMB_TRY(find_base(c));
    if (c->rank > 0)
        FMB_TRY(fmb_section_choose_form(c));
    if (c->rank == 0)
        return FMB_OK;
    list_columns(c);
    fmb_program_init(&c->program, run->mem, (int)c->rank - 1);
    FMB_TRY(write_program(c));
    return !c->empty && c->rank > 1 ? begin_queries(c) : FMB_OK;
}

void fmb_section_close(fmb_section *c)
{
    if (!c->run)
        return;
    fmb_mem *mem = c->run->mem;
    if (c->begun)
        fmb_support_clear(&c->support);
    fmb_oracle_free(c->oracle);
    fmb_program_clear(&c->program);
    fmb_integers_clear(&c->w, mem);
    for (size_t i = 0; c->base && i < c->d; i++)
        fmb_vec_clear(&c->base[i], c->d, mem);
    fmb_arena_clear(&c->arena);
    fmb_num_clear(&c->num);
    c->run = NULL;
}

size_t fmb_section_found(const fmb_section *c)
{
    return c->begun ? c->support.hull.generators : 0;
}

fmb_status fmb_section_ask(fmb_section *c, size_t most, uint64_t pairs, bool *done)
{
    *done = !c->begun;
    if (*done)
        return FMB_OK;
    c->support.most = most;
    return fmb_support_ask(&c->support, pairs, done);
}
