/* warm.c: brings the oracle of a session up to date with its system; see session_private.h and
 * session_state.h. */
#include "solve/session/session_state.h"

/* The program is built anew once its slots exceed twice the rows by so many. */
#define SPARE_SLOTS 64

static bool is_constant_row(const fmb_session *c, size_t i)
{
    return c->s->row[i].nnz == 0;
}

void fmb_session_forget(fmb_session *c)
{
    fmb_mem_put(c->mem, c->source, c->source_room, sizeof *c->source);
    c->source = NULL;
    c->source_room = 0;
    if (!c->oracle)
        return;
    fmb_oracle_free(c->oracle);
    fmb_program_clear(&c->program);
    c->oracle = NULL;
    for (size_t i = 0; i < fmb_system_rows(c->s); i++)
        c->row[i].slot = FMB_NO_SLOT;
    for (size_t k = 0; k < c->changes; k++)
        c->journal[k].place.slot = FMB_NO_SLOT;
}

fmb_oracle *fmb_session_oracle(const fmb_session *c)
{
    return c->oracle;
}

static fmb_status open_session_oracle(fmb_session *c)
{
    if (c->oracle)
        return FMB_OK;
    fmb_program_init(&c->program, c->mem, fmb_system_dim(c->s));
    return fmb_oracle_new(&c->run, &c->program, &c->oracle);
}

/* Set c->source for the slots in use, SIZE_MAX for the others. New rows have no slots yet. */
static fmb_status find_sources(fmb_session *c)
{
    FMB_TRY(FMB_RESERVE(c->mem, &c->source, &c->source_room, c->program.m));
    for (size_t k = 0; k < c->program.m; k++)
        c->source[k] = SIZE_MAX;
    for (size_t i = 0; i < fmb_system_rows(c->s); i++)
        if (c->row[i].slot != FMB_NO_SLOT)
            c->source[c->row[i].slot] = i;
    return FMB_OK;
}

/* The slot of row i has the coefficients c_k, the row has the integers a_k and b: the slot's right
 * side must be b c_0 / a_0. If that is no integer, the row takes a new slot. */
static fmb_status shift_slot(fmb_session *c, size_t i)
{
    const fmb_sysrow *r = fmb_system_row(c->s, i);
    size_t slot = c->row[i].slot;
    fmb_status st = FMB_OK;
    mpz_t a, b;
    mpz_inits(a, b, NULL);
    fmb_program_get(&c->program, slot, 0, a);
    fmb_vec_get(&r->val, r->nnz, b);
    mpz_mul(b, b, a);
    fmb_vec_get(&r->val, 0, a);
    if (mpz_divisible_p(b, a)) {
        mpz_divexact(b, b, a);
        st = fmb_program_set_right(&c->program, slot, b);
    } else {
        c->row[i].slot = FMB_NO_SLOT;
    }
    mpz_clears(a, b, NULL);
    return st;
}

static fmb_status shift_slots(fmb_session *c)
{
    fmb_status st = FMB_OK;
    bool any = false;
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(c->s); i++) {
        if (c->row[i].shifted && c->row[i].slot != FMB_NO_SLOT) {
            st = shift_slot(c, i);
            any = true;
        }
        c->row[i].shifted = false;
    }
    if (st == FMB_OK && any)
        fmb_oracle_shift(c->oracle);
    return st;
}

static void switch_slots(fmb_session *c)
{
    for (size_t k = 0; k < c->program.m; k++) {
        bool on = c->source[k] != SIZE_MAX;
        if (c->program.row[k].off != on)
            continue;
        c->program.row[k].off = !on;
        fmb_oracle_switch(c->oracle, k, on);
    }
}

static fmb_status append_slots(fmb_session *c)
{
    size_t before = c->program.m;
    for (size_t i = 0; i < fmb_system_rows(c->s); i++) {
        const fmb_sysrow *r = fmb_system_row(c->s, i);
        if (c->row[i].slot != FMB_NO_SLOT || is_constant_row(c, i))
            continue;
        FMB_TRY(fmb_program_add_copy(&c->program, r->nnz, r->var, &r->val, r->rel));
        c->row[i].slot = c->program.m - 1;
    }
    return c->program.m > before ? fmb_oracle_grow(c->oracle) : FMB_OK;
}

/* Do most slots belong to removed rows? */
static bool has_many_spare_slots(const fmb_session *c)
{
    size_t rows = fmb_system_rows(c->s);
    return c->oracle && c->program.m > 2 * rows + SPARE_SLOTS;
}

/* Has the number of variables changed? Columns of the program are variables by number. */
static bool has_other_variables(const fmb_session *c)
{
    return c->oracle && c->program.n != fmb_system_dim(c->s);
}

fmb_status fmb_session_enter(fmb_session *c, const fmb_run *run)
{
    if (has_many_spare_slots(c) || has_other_variables(c))
        fmb_session_forget(c);
    c->run = *run;
    c->run.stats = (fmb_stats){0};
    FMB_TRY(open_session_oracle(c));
    FMB_TRY(shift_slots(c));
    FMB_TRY(find_sources(c));
    switch_slots(c);
    FMB_TRY(append_slots(c));
    return find_sources(c);
}

void fmb_session_leave(fmb_session *c, fmb_run *run)
{
    run->stats.lps += c->run.stats.lps;
    run->stats.pivots += c->run.stats.pivots;
    if (run->stop == FMB_STOP_DONE)
        run->stop = c->run.stop;
}

void fmb_session_take_weights(const fmb_session *c, fmb_weights *w)
{
    mpq_t scale;
    mpq_init(scale);
    for (size_t k = 0; k < w->size; k++) {
        size_t slot = w->index[k], i = c->source[slot];
        fmb_program_get(&c->program, slot, 0, mpq_numref(scale));
        fmb_vec_get(&fmb_system_row(c->s, i)->val, 0, mpq_denref(scale));
        mpq_canonicalize(scale);
        mpq_mul(w->value[k], w->value[k], scale);
        w->index[k] = (uint32_t)i;
    }
    mpq_clear(scale);
}
