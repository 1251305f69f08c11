/* backend_ask.c: see backend.h. */
#include "lp/simplex/backend.h"

#include <math.h>

#include "lp/simplex/backend_methods.h"

struct fmb_backend {
    fmb_scaled_program scaled;
    const fmb_backend_methods *side; /* who answers */
    void *self;                      /* of the method */
    double *cost;                    /* [n] scaled as the columns are */
    fmb_status late;                 /* of a call that has none */
    bool behind;                     /* there are rows that the method has yet to take in */
};

void fmb_backend_close(fmb_backend *d)
{
    if (!d)
        return;
    if (d->self)
        d->side->close(d->self);
    fmb_mem *mem = d->scaled.run->mem;
    fmb_mem_put(mem, d->cost, d->scaled.n, sizeof *d->cost);
    fmb_scaled_program_clear(&d->scaled);
    fmb_mem_put(mem, d, 1, sizeof *d);
}

fmb_status fmb_backend_open_with(fmb_run *run, const fmb_program *p,
                                 const fmb_backend_methods *side, fmb_backend **out)
{
    *out = NULL;
    fmb_backend *d = fmb_mem_zero(run->mem, 1, sizeof *d);
    if (!d)
        return fmb_mem_status(run->mem);
    d->side = side;
    fmb_status st = fmb_scaled_program_init(&d->scaled, run, p);
    d->cost = fmb_mem_get(run->mem, d->scaled.n, sizeof *d->cost);
    if (st == FMB_OK && !d->cost)
        st = fmb_mem_status(run->mem);
    if (st == FMB_OK)
        st = side->open(&d->scaled, &d->self);
    if (st == FMB_OK && d->self)
        *out = d;
    else
        fmb_backend_close(d);
    return st;
}

fmb_status fmb_backend_open(fmb_run *run, const fmb_program *p, fmb_backend **out)
{
    return fmb_backend_open_with(run, p, &fmb_backend_revised_simplex, out);
}

/* What is late, and rows that are new. */
static fmb_status catch_up(fmb_backend *d, fmb_hint *h)
{
    fmb_status st = d->late == FMB_OK ? fmb_backend_grow(d) : d->late;
    d->late = FMB_OK;
    h->kind = FMB_HINT_NONE;
    return st;
}

fmb_status fmb_backend_search(fmb_backend *d, const double *lean, fmb_hint *h)
{
    bool leans = lean && fmb_scaled_program_scale_cost(&d->scaled, lean, d->cost);
    fmb_status st = catch_up(d, h);
    return st == FMB_OK ? d->side->search(d->self, leans ? d->cost : NULL, h) : st;
}

fmb_status fmb_backend_maximize(fmb_backend *d, const double *cost, fmb_hint *h)
{
    bool is_finite = fmb_scaled_program_scale_cost(&d->scaled, cost, d->cost);
    fmb_status st = is_finite ? catch_up(d, h) : fmb_backend_search(d, NULL, h);
    if (st == FMB_OK && is_finite)
        return d->side->maximize(d->self, d->cost, h);
    h->kind = FMB_HINT_NONE;
    return st;
}

fmb_status fmb_backend_grow(fmb_backend *d)
{
    d->behind = d->behind || d->scaled.m < d->scaled.p->m;
    fmb_status st = d->behind ? fmb_scaled_program_grow(&d->scaled) : FMB_OK;
    if (st == FMB_OK && d->behind)
        st = d->side->grow(d->self);
    d->behind = st != FMB_OK;
    return st;
}

void fmb_backend_switch(fmb_backend *d, size_t i, bool on)
{
    if (d->scaled.off[i] != on)
        return;
    d->scaled.off[i] = !on;
    fmb_status st = d->side->switch_row(d->self, i);
    d->late = d->late == FMB_OK ? st : d->late;
}

void fmb_backend_place(fmb_backend *d, const size_t *basis)
{
    fmb_status st = fmb_backend_grow(d);
    if (st == FMB_OK)
        st = d->side->place(d->self, basis);
    d->late = d->late == FMB_OK ? st : d->late;
}

void fmb_backend_shift(fmb_backend *d, const double *right)
{
    fmb_scaled_program_shift(&d->scaled, right);
    d->side->shift(d->self);
}

void fmb_backend_shift_row(fmb_backend *d, size_t i)
{
    fmb_scaled_program_shift_row(&d->scaled, i);
    d->side->shift_row(d->self, i);
}

void fmb_backend_move_in(fmb_backend *d, double by)
{
    fmb_scaled_program_move_in(&d->scaled, by);
    d->side->shift(d->self);
}

bool fmb_backend_point(fmb_backend *d, int fine, mpz_t *x, mpz_t den)
{
    const int *exponent = d->scaled.column_exponent;
    double *scaled = d->cost;
    int places = 0;
    d->side->point(d->self, scaled);
    for (size_t j = 0; j < d->scaled.n; j++) {
        places = fine + exponent[j] > places ? fine + exponent[j] : places;
        if (!isfinite(ldexp(scaled[j], fine)))
            return false;
    }
    for (size_t j = 0; j < d->scaled.n; j++) {
        mpz_set_d(x[j], nearbyint(ldexp(scaled[j], fine)));
        mpz_mul_2exp(x[j], x[j], (mp_bitcnt_t)(places - fine - exponent[j]));
    }
    mpz_set_ui(den, 0);
    mpz_setbit(den, (mp_bitcnt_t)places);
    return true;
}

void fmb_backend_sharpen(fmb_backend *d)
{
    d->scaled.sharp = true;
}
