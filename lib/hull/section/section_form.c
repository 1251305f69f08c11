/* section_form.c: the form w that is 1 on a section; see section.h.
 *
 * Numbers of the section are products of those of the rows and of w. So w is looked for among short
 * vectors near the mean of all rows, scaled to equal length: those with entries up to 1, 8, ... Let
 * b be the sum of as many independent rows as there are columns: b.x > 0 on the cone except at 0.
 * If N w.x >= b.x on the cone for some N > 0, as a linear program decides exactly, w is used, and
 * the section is a polytope; an unbounded one has larger intermediate hulls. Else b is used.
 */
#include <math.h>

#include "hull/facets/facets_private.h"
#include "hull/section/section.h"

/* Largest entries of the forms tried. */
static const double LARGEST[] = {1, 8, 64, 1024};
/* N for a b without entries beyond 1. */
#define CLOSENESS 1024

/* ---- short forms ----------------------------------------------------------------------------- */

/* mean[rank], at the pivots, with largest entry 1. All 0: there is no such mean in doubles. */
static void find_mean_direction(const fmb_section *c, double *mean, double *row)
{
    double most = 0;
    for (size_t k = 0; k < c->rank; k++)
        mean[k] = 0;
    for (size_t i = 0; i < c->m; i++) {
        double size = 0;
        fmb_facets_round(&c->row[i], c->d, row);
        for (size_t j = 0; j < c->d; j++)
            size = fmax(size, fabs(row[j]));
        for (size_t k = 0; size > 0 && k < c->rank; k++)
            mean[k] += row[c->pivot[k]] / size;
    }
    for (size_t k = 0; k < c->rank; k++)
        most = fmax(most, fabs(mean[k]));
    for (size_t k = 0; k < c->rank; k++)
        mean[k] = most > 0 && isfinite(most) ? mean[k] / most : 0;
}

static void round_mean(fmb_section *c, const double *mean, double largest)
{
    for (size_t k = 0; k < c->rank; k++)
        mpz_set_d(c->w.z[c->pivot[k]], rint(largest * mean[k]));
}

/* Write the cone in the pivot columns as a program. */
static fmb_status write_cone(const fmb_section *c, fmb_program *p)
{
    fmb_status st = FMB_OK;
    mpz_t *z = fmb_vec_block(c->rank + 1, c->run->mem);
    if (!z)
        return fmb_mem_status(c->run->mem);
    for (size_t i = 0; st == FMB_OK && i < c->m; i++) {
        for (size_t k = 0; k < c->rank; k++) {
            fmb_vec_get(&c->row[i], c->pivot[k], z[k]);
            mpz_neg(z[k], z[k]);
        }
        st = fmb_program_add_integers(p, z, FMB_LE);
        FMB_THEN(st, fmb_run_poll(c->run));
    }
    fmb_vec_block_free(z, c->rank + 1, c->run->mem);
    return st;
}

/* q = entry k of N w - b. */
static void write_entry_of_difference(fmb_section *c, size_t k, const fmb_integers *b, mpq_t q)
{
    mpz_set(c->num.t, b->z[0]);
    mpz_mul_ui(c->num.t, c->num.t, CLOSENESS);
    mpz_mul(c->num.t, c->num.t, c->w.z[c->pivot[k]]);
    mpz_sub(c->num.t, c->num.t, b->z[k + 1]);
    mpq_set_z(q, c->num.t);
}

/* Is N w.x at least b.x on the cone? b[0] is the largest of its entries, which follow. */
static fmb_status try_form(fmb_section *c, const fmb_integers *b, fmb_oracle *cone, bool *serves)
{
    fmb_weights cost = {0};
    fmb_oracle_end end = FMB_ORACLE_UNBOUNDED;
    bool attained;
    fmb_status st = FMB_OK;
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; st == FMB_OK && k < c->rank; k++) {
        write_entry_of_difference(c, k, b, q);
        mpq_neg(q, q);
        if (mpq_sgn(q) != 0)
            st = fmb_weights_add(&cost, (uint32_t)k, q, c->run->mem);
    }
    if (st == FMB_OK && cost.size > 0)
        st = fmb_oracle_maximize(cone, &cost, &end, &attained);
    mpq_clear(q);
    fmb_weights_clear(&cost, c->run->mem);
    *serves = st == FMB_OK && end == FMB_ORACLE_OPTIMUM;
    return st;
}

static fmb_status try_short_forms(fmb_section *c, const double *mean, const fmb_integers *b,
                                  bool *serves)
{
    fmb_program p;
    fmb_oracle *cone = NULL;
    bool feasible; /* 0 is a solution */
    fmb_program_init(&p, c->run->mem, (int)c->rank);
    fmb_status st = write_cone(c, &p);
    FMB_THEN(st, fmb_oracle_new(c->run, &p, &cone));
    FMB_THEN(st, fmb_oracle_feasible(cone, &feasible));
    for (size_t i = 0; st == FMB_OK && !*serves && i < sizeof LARGEST / sizeof *LARGEST; i++) {
        round_mean(c, mean, LARGEST[i]);
        st = try_form(c, b, cone, serves);
    }
    fmb_oracle_free(cone);
    fmb_program_clear(&p);
    return st;
}

/* ---- the form -------------------------------------------------------------------------------- */

/* b = its largest entry, then the sum of the independent rows at the pivots. */
static fmb_status add_base_up(fmb_section *c, fmb_integers *b)
{
    for (size_t k = 0; k < c->rank; k++) {
        mpz_ptr sum = b->z[k + 1];
        for (size_t i = 0; i < c->rank; i++) {
            fmb_vec_get(&c->row[c->chosen[i]], c->pivot[k], c->num.t);
            mpz_add(sum, sum, c->num.t);
        }
        if (mpz_cmpabs(sum, b->z[0]) > 0)
            mpz_abs(b->z[0], sum);
    }
    return fmb_integers_settle(b, c->run->mem);
}

static fmb_status choose_form(fmb_section *c, const fmb_integers *b, double *mean)
{
    bool serves = false;
    find_mean_direction(c, mean, mean + c->d);
    FMB_TRY(try_short_forms(c, mean, b, &serves));
    for (size_t k = 0; !serves && k < c->rank; k++)
        mpz_set(c->w.z[c->pivot[k]], b->z[k + 1]);
    for (size_t k = 0; k < c->rank; k++)
        if (mpz_sgn(c->w.z[c->pivot[k]]) != 0)
            c->gone = c->pivot[k];
    return fmb_integers_settle(&c->w, c->run->mem);
}

fmb_status fmb_section_choose_form(fmb_section *c)
{
    fmb_mem *mem = c->run->mem;
    fmb_integers b;
    fmb_status st = fmb_integers_init(&b, c->rank + 1, mem);
    double *mean = fmb_mem_get(mem, 2 * c->d, sizeof *mean);
    if (st == FMB_OK && !mean)
        st = fmb_mem_status(mem);
    FMB_THEN(st, add_base_up(c, &b));
    FMB_THEN(st, choose_form(c, &b, mean));
    fmb_mem_put(mem, mean, 2 * c->d, sizeof *mean);
    fmb_integers_clear(&b, mem);
    return st;
}
