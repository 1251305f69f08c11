/* draft.c: rows under construction; see draft.h. */
#include <string.h>

#include "io/core/draft.h"

void fmb_draft_init(fmb_draft *d, fmb_mem *mem)
{
    *d = (fmb_draft){.mem = mem};
    mpq_init(d->rhs);
}

void fmb_draft_clear(fmb_draft *d)
{
    for (size_t k = 0; k < d->capacity; k++)
        mpq_clear(d->coef[k]);
    fmb_mem_put(d->mem, d->coef, d->capacity, sizeof *d->coef);
    fmb_mem_put(d->mem, d->var, d->capacity, sizeof *d->var);
    mpq_clear(d->rhs);
}

void fmb_draft_reset(fmb_draft *d)
{
    d->n = 0;
    mpq_set_ui(d->rhs, 0, 1);
}

/* Grow by half. The coefficients are allocated first, as growing var cannot be undone. */
static fmb_status grow_draft_by_half(fmb_draft *d)
{
    size_t capacity = d->capacity + d->capacity / 2 + 8;
    mpq_t *coef;
    FMB_TRY(FMB_GET(d->mem, coef, capacity));
    int *var = fmb_mem_grow(d->mem, d->var, d->capacity, capacity, sizeof *var);
    if (!var) {
        fmb_mem_put(d->mem, coef, capacity, sizeof *coef);
        return fmb_mem_status(d->mem);
    }
    if (d->capacity > 0)
        memcpy(coef, d->coef, d->capacity * sizeof *coef);
    fmb_mem_put(d->mem, d->coef, d->capacity, sizeof *coef);
    for (size_t k = d->capacity; k < capacity; k++)
        mpq_init(coef[k]);
    d->coef = coef;
    d->var = var;
    d->capacity = capacity;
    return FMB_OK;
}

fmb_status fmb_draft_term(fmb_draft *d, int var, mpq_ptr *slot)
{
    FMB_TRY(d->n < d->capacity ? FMB_OK : grow_draft_by_half(d));
    d->var[d->n] = var;
    *slot = d->coef[d->n++];
    return FMB_OK;
}

fmb_status fmb_draft_add(fmb_draft *d, int var, mpq_srcptr coef)
{
    mpq_ptr slot;
    FMB_TRY(fmb_draft_term(d, var, &slot));
    mpq_set(slot, coef);
    return FMB_OK;
}

void fmb_draft_negate(fmb_draft *d)
{
    for (size_t k = 0; k < d->n; k++)
        mpq_neg(d->coef[k], d->coef[k]);
    mpq_neg(d->rhs, d->rhs);
}

/* Charge the digits that the common denominator adds, as it multiplies every entry. The computation
 * of the denominator stops as soon as it is too long. */
static fmb_status charge_denominator(fmb_cursor *c, const char *p, const fmb_draft *d)
{
    fmb_status st = FMB_OK;
    mpz_t den;
    mpz_init_set(den, mpq_denref(d->rhs));
    size_t digits = mpz_sizeinbase(den, 10);
    for (size_t k = 0; k < d->n && digits <= c->budget / (d->n + 2); k++) {
        if (mpz_cmp_ui(mpq_denref(d->coef[k]), 1) == 0)
            continue;
        mpz_lcm(den, den, mpq_denref(d->coef[k]));
        digits = mpz_sizeinbase(den, 10);
    }
    if (digits > c->budget / (d->n + 2))
        st = fmb_io_charge(c, p, SIZE_MAX);
    else if (digits > 1)
        st = fmb_io_charge(c, p, digits * (d->n + 2));
    mpz_clear(den);
    return st;
}

fmb_status fmb_draft_append(fmb_cursor *c, const char *p, const fmb_draft *d, fmb_rel rel,
                            fmb_system *s)
{
    FMB_TRY(charge_denominator(c, p, d));
    return fmb_system_add_q(s, d->n, d->var, d->coef, rel, d->rhs);
}

fmb_status fmb_draft_set_objective(fmb_cursor *c, const char *p, const fmb_draft *d,
                                   fmb_sense sense, fmb_system *s)
{
    fmb_status st = charge_denominator(c, p, d);
    mpq_t constant;
    mpq_init(constant);
    mpq_neg(constant, d->rhs);
    fmb_objective_q form = {sense, d->n, d->var, d->coef, constant};
    FMB_THEN(st, fmb_system_set_objective_q(s, &form));
    mpq_clear(constant);
    return st;
}

/* ---- names ----------------------------------------------------------------------------------- */

/* The span as a string: in buf if it is short. */
static char *copy_span_to_string(fmb_span w, char buf[64], fmb_mem *mem)
{
    char *text = w.n < 64 ? buf : fmb_mem_get(mem, w.n + 1, 1);
    if (text) {
        memcpy(text, w.p, w.n);
        text[w.n] = '\0';
    }
    return text;
}

static void free_span_string(char *text, fmb_span w, const char *buf, fmb_mem *mem)
{
    if (text != buf)
        fmb_mem_put(mem, text, w.n + 1, 1);
}

fmb_status fmb_span_find(fmb_cursor *c, fmb_span name, const fmb_system *s, int *index)
{
    char buf[64], *text = copy_span_to_string(name, buf, c->mem);
    if (!text)
        return fmb_mem_status(c->mem);
    *index = fmb_system_find(s, text);
    free_span_string(text, name, buf, c->mem);
    return FMB_OK;
}

fmb_status fmb_span_variable(fmb_cursor *c, fmb_span name, fmb_system *s, int *index)
{
    char buf[64], *text = copy_span_to_string(name, buf, c->mem);
    if (!text)
        return fmb_mem_status(c->mem);
    fmb_status st = FMB_OK;
    int j = fmb_system_find(s, text);
    if (j < 0)
        st = fmb_system_add_variable(s, text, &j);
    if (st == FMB_OK)
        *index = j;
    free_span_string(text, name, buf, c->mem);
    return st;
}

fmb_status fmb_span_label(fmb_cursor *c, fmb_span label, fmb_system *s, size_t i)
{
    char buf[64], *text = copy_span_to_string(label, buf, c->mem);
    if (!text)
        return fmb_mem_status(c->mem);
    fmb_status st = fmb_system_set_label(s, i, text);
    free_span_string(text, label, buf, c->mem);
    return st;
}

fmb_status fmb_io_declare(fmb_cursor *c, const char *p, size_t n, fmb_system *s)
{
    if (n > FMB_IO_FREE_VARIABLES + (size_t)(c->end - c->begin))
        return fmb_io_fail(c, p,
                           "expected fewer variables: %zu are declared, and the text is too "
                           "short to use them",
                           n);
    for (size_t j = 0; j < n; j++)
        FMB_TRY(fmb_system_add_variable(s, NULL, NULL));
    return FMB_OK;
}
