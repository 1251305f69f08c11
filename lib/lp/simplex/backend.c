/* backend.c: see backend.h. */
#include "lp/simplex/backend.h"

#include <math.h>

#include "lp/simplex/backend_methods.h"

struct fmb_door {
    fmb_reals reals;
    const fmb_door_side *side; /* who answers */
    void *self;                /* of the side */
    double *cost;              /* [n] scaled as the columns are */
    fmb_status late;           /* of a call that has none */
    bool behind;               /* there are rows that the side has yet to take in */
};

void fmb_door_close(fmb_door *d)
{
    if (!d)
        return;
    if (d->self)
        d->side->close(d->self);
    fmb_mem *mem = d->reals.run->mem;
    fmb_mem_put(mem, d->cost, d->reals.n, sizeof *d->cost);
    fmb_reals_clear(&d->reals);
    fmb_mem_put(mem, d, 1, sizeof *d);
}

fmb_status fmb_door_open_side(fmb_run *run, const fmb_program *p, const fmb_door_side *side,
                              fmb_door **out)
{
    *out = NULL;
    fmb_door *d = fmb_mem_zero(run->mem, 1, sizeof *d);
    if (!d)
        return fmb_mem_status(run->mem);
    d->side = side;
    fmb_status st = fmb_reals_init(&d->reals, run, p);
    d->cost = fmb_mem_get(run->mem, d->reals.n, sizeof *d->cost);
    if (st == FMB_OK && !d->cost)
        st = fmb_mem_status(run->mem);
    if (st == FMB_OK)
        st = side->open(&d->reals, &d->self);
    if (st == FMB_OK && d->self)
        *out = d;
    else
        fmb_door_close(d);
    return st;
}

fmb_status fmb_door_open(fmb_run *run, const fmb_program *p, fmb_door **out)
{
    return fmb_door_open_side(run, p, &fmb_door_side_own, out);
}

static fmb_status ask_door(fmb_door *d, const double *cost, fmb_hint *h)
{
    fmb_status st = d->late == FMB_OK ? fmb_door_grow(d) : d->late;
    d->late = FMB_OK;
    h->kind = FMB_HINT_NONE;
    if (st != FMB_OK)
        return st;
    return cost ? d->side->maximize(d->self, cost, h) : d->side->search(d->self, h);
}

fmb_status fmb_door_search(fmb_door *d, fmb_hint *h)
{
    return ask_door(d, NULL, h);
}

fmb_status fmb_door_maximize(fmb_door *d, const double *cost, fmb_hint *h)
{
    bool is_finite = fmb_reals_scale_cost(&d->reals, cost, d->cost);
    fmb_status st = ask_door(d, is_finite ? d->cost : NULL, h);
    h->kind = is_finite ? h->kind : FMB_HINT_NONE;
    return st;
}

fmb_status fmb_door_grow(fmb_door *d)
{
    d->behind = d->behind || d->reals.m < d->reals.p->m;
    fmb_status st = d->behind ? fmb_reals_grow(&d->reals) : FMB_OK;
    if (st == FMB_OK && d->behind)
        st = d->side->grow(d->self);
    d->behind = st != FMB_OK;
    return st;
}

void fmb_door_switch(fmb_door *d, size_t i, bool on)
{
    if (d->reals.off[i] != on)
        return;
    d->reals.off[i] = !on;
    fmb_status st = d->side->switch_row(d->self, i);
    d->late = d->late == FMB_OK ? st : d->late;
}

void fmb_door_place(fmb_door *d, const size_t *basis)
{
    fmb_status st = fmb_door_grow(d);
    if (st == FMB_OK)
        st = d->side->place(d->self, basis);
    d->late = d->late == FMB_OK ? st : d->late;
}

void fmb_door_shift(fmb_door *d, const double *right)
{
    fmb_reals_shift(&d->reals, right);
    d->side->shift(d->self);
}

void fmb_door_move_in(fmb_door *d, double by)
{
    fmb_reals_move_in(&d->reals, by);
    d->side->shift(d->self);
}

bool fmb_door_point(fmb_door *d, int fine, mpz_t *x, mpz_t den)
{
    const int *exponent = d->reals.column_exponent;
    double *scaled = d->cost;
    int places = 0;
    d->side->point(d->self, scaled);
    for (size_t j = 0; j < d->reals.n; j++) {
        places = fine + exponent[j] > places ? fine + exponent[j] : places;
        if (!isfinite(ldexp(scaled[j], fine)))
            return false;
    }
    for (size_t j = 0; j < d->reals.n; j++) {
        mpz_set_d(x[j], nearbyint(ldexp(scaled[j], fine)));
        mpz_mul_2exp(x[j], x[j], (mp_bitcnt_t)(places - fine - exponent[j]));
    }
    mpz_set_ui(den, 0);
    mpz_setbit(den, (mp_bitcnt_t)places);
    return true;
}

void fmb_door_sharpen(fmb_door *d)
{
    d->reals.sharp = true;
}
