/* glpk_side.c: see glpk_side.h. */
#include "glpk_side.h"

#include <stdlib.h>

typedef struct glpk_state {
    const fmb_reals *f;
} glpk_state;

static fmb_status ask_from_units(const glpk_state *g, const double *cost, fmb_hint *h)
{
    for (size_t j = 0; j < g->f->n; j++)
        h->basis[j] = g->f->m + j;
    return fmb_glpk_ask(g->f, cost, h);
}

static void close_state(void *self)
{
    free(self);
}

/* A first question shows whether anyone is there. */
static fmb_status open_state(const fmb_reals *f, void **out)
{
    glpk_state *g = malloc(sizeof *g);
    size_t *basis = calloc(f->n + 1, sizeof *basis);
    fmb_hint h = {.basis = basis};
    *g = (glpk_state){f};
    fmb_status st = ask_from_units(g, NULL, &h);
    *out = st == FMB_OK && h.kind != FMB_HINT_NONE ? g : NULL;
    if (!*out)
        close_state(g);
    free(basis);
    return st;
}

static fmb_status search_with_glpk(void *self, fmb_hint *h)
{
    return ask_from_units(self, NULL, h);
}

static fmb_status maximize_with_glpk(void *self, const double *cost, fmb_hint *h)
{
    return ask_from_units(self, cost, h);
}

/* What changes is read anew by each question. */

static fmb_status note_nothing(void *self)
{
    (void)self;
    return FMB_OK;
}

static fmb_status note_no_row(void *self, size_t i)
{
    (void)self, (void)i;
    return FMB_OK;
}

static fmb_status note_no_basis(void *self, const size_t *basis)
{
    (void)self, (void)basis;
    return FMB_OK;
}

static void note_no_shift(void *self)
{
    (void)self;
}

const fmb_door_side glpk_side = {open_state,         close_state,   search_with_glpk,
                                 maximize_with_glpk, note_nothing,  note_no_row,
                                 note_no_basis,      note_no_shift, NULL};
