/* export.c: see export.h. */
#include <stdio.h> /* before GMP: it then declares gmp_fprintf */

#include "io/program/export.h"

#include <string.h>

#include "system/system_private.h"

/* Sides of this size and more are read as infinite (program_draft.h): 10 to this power. */
#define HUGE_POWER 30

/* ---- numbers --------------------------------------------------------------------------------- */

/* The power of ten that makes q an integer; -1 if the denominator has primes other than 2 and 5. */
static long decimal_places(mpq_srcptr q)
{
    mpz_t rest, five;
    mpz_init(rest);
    mpz_init_set_ui(five, 5);
    unsigned long twos = mpz_scan1(mpq_denref(q), 0);
    mpz_fdiv_q_2exp(rest, mpq_denref(q), twos);
    unsigned long fives = mpz_remove(rest, rest, five);
    long places = mpz_cmp_ui(rest, 1) == 0 ? (long)(twos > fives ? twos : fives) : -1;
    mpz_clears(rest, five, (mpz_ptr)NULL);
    return places;
}

void fmb_print_decimal(FILE *out, mpq_srcptr q)
{
    unsigned long places = (unsigned long)decimal_places(q);
    mpz_t whole, part, ten;
    mpz_inits(whole, part, ten, (mpz_ptr)NULL);
    mpz_ui_pow_ui(ten, 10, places);
    mpz_mul(whole, mpq_numref(q), ten);
    mpz_divexact(whole, whole, mpq_denref(q));
    mpz_abs(whole, whole);
    mpz_fdiv_qr(whole, part, whole, ten);
    gmp_fprintf(out, mpq_sgn(q) < 0 ? "-%Zd" : "%Zd", whole);
    if (places > 0)
        gmp_fprintf(out, ".%0*Zd", (int)places, part);
    mpz_clears(whole, part, ten, (mpz_ptr)NULL);
}

void fmb_export_print(fmb_export *e)
{
    mpq_mul(e->q, e->q, e->scale);
    fmb_print_decimal(e->out, e->q);
}

/* If q is no finite decimal, multiply scale so that scale times q is an integer. */
static void include_number(fmb_export *e, bool *all)
{
    mpz_lcm(mpq_numref(e->scale), mpq_numref(e->scale), mpq_denref(e->q));
    *all = *all && decimal_places(e->q) >= 0;
}

void fmb_export_scale(fmb_export *e, size_t i)
{
    bool decimal = true;
    mpq_set_ui(e->scale, 1, 1);
    for (size_t k = 0; k < fmb_system_terms(e->s, i); k++) {
        fmb_system_term_q(e->s, i, k, e->q);
        include_number(e, &decimal);
    }
    fmb_system_rhs_q(e->s, i, e->q);
    include_number(e, &decimal);
    if (decimal)
        mpq_set_ui(e->scale, 1, 1);
    mpq_mul(e->q, e->q, e->scale);
    mpz_tdiv_q(mpq_numref(e->q), mpq_numref(e->q), mpq_denref(e->q));
    size_t digits = mpz_sizeinbase(mpq_numref(e->q), 10); /* exact, or one too many */
    if (digits > HUGE_POWER) {
        mpz_ui_pow_ui(mpq_denref(e->scale), 10, digits - HUGE_POWER);
        mpq_canonicalize(e->scale);
    }
}

/* ---- names ----------------------------------------------------------------------------------- */

/* Add the name if the format can spell it and it is free, else the letter with the number k, and
 * underscores until that is free. */
static fmb_status add_spelling(fmb_export *e, fmb_names *names, const char *name, char letter,
                               size_t k, fmb_spells_fn *spells)
{
    enum { MOST = 64 };
    char made[MOST];
    if (name && spells(name) && fmb_names_find(names, name) < 0)
        return fmb_names_add(names, name, &e->mem);
    int n = snprintf(made, sizeof made - 1, "%c%zu", letter, k);
    while (fmb_names_find(names, made) >= 0 && n < MOST - 2) {
        made[n++] = '_';
        made[n] = '\0';
    }
    return fmb_names_add(names, made, &e->mem);
}

/* Names that can be spelled are added first, so that no made-up name takes one of them. */
static fmb_status spell_columns(fmb_export *e, fmb_spells_fn *spells)
{
    const fmb_system *s = e->s;
    for (int j = 0; j < fmb_system_dim(s); j++) {
        const char *name = fmb_system_name(s, j);
        char made[64];
        int n = 0;
        if (!spells(name)) {
            n = snprintf(made, sizeof made - 1, "x%d", j + 1);
            for (; n < 62 && fmb_system_find(s, made) >= 0; made[n] = '\0')
                made[n++] = '_';
            name = made;
        }
        FMB_TRY(fmb_names_find(&e->column, name) < 0
                    ? fmb_names_add(&e->column, name, &e->mem)
                    : add_spelling(e, &e->column, NULL, 'x', (size_t)j + 1, spells));
    }
    return FMB_OK;
}

static fmb_status spell_rows(fmb_export *e, fmb_spells_fn *spells)
{
    size_t m = fmb_system_rows(e->s);
    for (size_t i = 0; i < m; i++)
        FMB_TRY(add_spelling(e, &e->row, fmb_system_label(e->s, i), 'r', i + 1, spells));
    return add_spelling(e, &e->row, "obj", 'r', m + 1, spells);
}

/* ---- what cannot be written ------------------------------------------------------------------ */

static bool has_decimal_objective(fmb_export *e)
{
    fmb_system_objective_constant_q(e->s, e->q);
    bool decimal = decimal_places(e->q) >= 0;
    for (size_t k = 0; decimal && k < fmb_system_objective_terms(e->s); k++) {
        fmb_system_objective_term_q(e->s, k, e->q);
        decimal = decimal_places(e->q) >= 0;
    }
    return decimal;
}

fmb_status fmb_export_open(fmb_export *e, const fmb_system *s, fmb_spells_fn *spells, FILE *out)
{
    *e = (fmb_export){.s = s, .out = out};
    fmb_mem_init(&e->mem, &s->mem.alloc, 0);
    mpq_inits(e->q, e->scale, (mpq_ptr)NULL);
    if (fmb_system_dim(s) == 0 || !has_decimal_objective(e))
        return FMB_ERR_ARG;
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        if (fmb_system_rel(s, i) == FMB_LT)
            return FMB_ERR_ARG;
    FMB_TRY(spell_columns(e, spells));
    return spell_rows(e, spells);
}

void fmb_export_close(fmb_export *e)
{
    fmb_names_clear(&e->column, &e->mem);
    fmb_names_clear(&e->row, &e->mem);
    mpq_clears(e->q, e->scale, (mpq_ptr)NULL);
}
