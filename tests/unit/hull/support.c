/* support.c: support queries by themselves: at any moment all rows are proved and all points lie
 * inside, and queries in slices end like those in one go. */
#include <criterion/criterion.h>

#include "hull/support/support.h"
#include "shadows.h"

typedef struct bench {
    dense d; /* integers */
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_program p;
    fmb_oracle *o;
    fmb_support s;
    bool feasible;
} bench;

static void open_bench(bench *b, dense (*make)(support_rng *g), uint64_t seed, const int *kept,
                       size_t k)
{
    fmb_options o = {.size = sizeof o};
    support_rng g = {seed};
    *b = (bench){.d = make(&g)};
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    fmb_program_init(&b->p, &b->mem, b->d.dim);
    for (int i = 0; i < b->d.rows; i++) {
        mpz_t z[8];
        for (int j = 0; j <= b->d.dim; j++)
            mpz_init_set(z[j], mpq_numref(dense_row(&b->d, i)[j]));
        cr_assert_eq(fmb_program_add_integers(&b->p, z, b->d.rel[i]), FMB_OK);
        for (int j = 0; j <= b->d.dim; j++)
            mpz_clear(z[j]);
    }
    cr_assert_eq(fmb_oracle_new(&b->run, &b->p, &b->o), FMB_OK);
    cr_assert_eq(fmb_oracle_feasible(b->o, &b->feasible), FMB_OK);
    cr_assert_eq(fmb_support_init(&b->s, &b->run, b->o, (size_t)b->d.dim, kept, k, false, true),
                 FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_support_clear(&b->s);
    fmb_oracle_free(b->o);
    fmb_program_clear(&b->p);
    cr_assert_eq(b->mem.used, 0);
    dense_free(&b->d);
}

/* The multipliers are >= 0 except on equalities, and give sign times the row. */
static void check_weights(const bench *b, const fmb_support_row *r, const fmb_weights *w, int sign)
{
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (int j = 0; j <= b->d.dim; j++) {
        mpq_set_ui(sum, 0, 1);
        for (size_t i = 0; i < w->size; i++) {
            cr_assert(mpq_sgn(w->value[i]) >= 0 || b->d.rel[w->index[i]] == FMB_EQ);
            mpq_mul(t, w->value[i], dense_row(&b->d, (int)w->index[i])[j]);
            mpq_add(sum, sum, t);
        }
        for (size_t k = 0; k <= b->s.k; k++)
            if (k == b->s.k ? j == b->d.dim : j == b->s.kept[k]) {
                mpq_set_z(t, r->z.z[k]);
                if (sign > 0)
                    mpq_sub(sum, sum, t);
                else
                    mpq_add(sum, sum, t);
            }
        cr_assert_eq(mpq_sgn(sum), 0, "column %d", j);
    }
    mpq_clears(sum, t, NULL);
}

/* Every generator of the hull satisfies the row. */
static void check_generators(const bench *b, const fmb_support_row *r)
{
    mpz_t sum, t;
    mpz_inits(sum, t, NULL);
    for (size_t i = 0; i < b->s.hull.generators; i++) {
        const fmb_vec *g = &b->s.hull.generator[i];
        fmb_vec_get(g, 0, sum);
        mpz_mul(sum, sum, r->z.z[b->s.k]);
        for (size_t k = 0; k < b->s.k; k++) {
            fmb_vec_get(g, k + 1, t);
            mpz_submul(sum, t, r->z.z[k]);
        }
        cr_assert(r->rel == FMB_EQ ? mpz_sgn(sum) == 0 : mpz_sgn(sum) >= 0);
    }
    mpz_clears(sum, t, NULL);
}

static void check_state(const bench *b)
{
    for (size_t i = 0; i < b->s.rows; i++) {
        const fmb_support_row *r = &b->s.row[i];
        check_weights(b, r, &r->proof, 1);
        if (r->rel == FMB_EQ)
            check_weights(b, r, &r->reverse, -1);
        check_generators(b, r);
    }
}

static void check_same_rows(const bench *a, const bench *b)
{
    cr_assert_eq(a->s.rows, b->s.rows);
    for (size_t i = 0; i < a->s.rows; i++)
        for (size_t k = 0; k <= a->s.k; k++)
            cr_assert_eq(mpz_cmp(a->s.row[i].z.z[k], b->s.row[i].z.z[k]), 0);
}

static void check_portions(dense (*make)(support_rng *g), int count)
{
    static const int kept[] = {0, 1, 2};
    for (int seed = 0; seed < count; seed++) {
        bench a, b;
        bool done = false;
        support_rng g = {(uint64_t)seed};
        dense d = make(&g);
        size_t k = d.dim < 3 ? (size_t)d.dim : 3;
        dense_free(&d);
        open_bench(&a, make, (uint64_t)seed, kept, k);
        open_bench(&b, make, (uint64_t)seed, kept, k);
        while (a.feasible && !done) {
            cr_assert_eq(fmb_support_ask(&a.s, 1, &done), FMB_OK);
            check_state(&a);
        }
        if (b.feasible) {
            cr_assert_eq(fmb_support_ask(&b.s, 0, &done), FMB_OK);
            cr_assert(done);
            check_same_rows(&a, &b);
        }
        close_bench(&a);
        close_bench(&b);
    }
}

Test(support, portions)
{
    check_portions(shadow_dense_rows, 30);
    check_portions(shadow_bounded, 20);
    check_portions(shadow_through_a_point, 30);
    check_portions(shadow_cone, 30);
    check_portions(shadow_with_equalities, 30);
    check_portions(shadow_flat, 30);
    check_portions(shadow_wide, 30);
}
