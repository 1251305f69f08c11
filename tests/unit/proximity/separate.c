/* separate.c: separating rows of random disjoint pairs, checked by an evaluation of all corners;
 * and the same rows with an error. usage: separate PAIRS SEED
 *
 * Verdicts come from the kernels (<fmb/pair.h>): so the rows prove these, too. */
#include <stdlib.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>
#include <fmb/gmp.h>

#include "bodies.h"
#include "support/must.h"

static int faults;

static void expect(bool holds, const char *what, long pair)
{
    if (holds)
        return;
    fprintf(stderr, "pair %ld: %s\n", pair, what);
    faults++;
}

/* The row with its right side moved by so much times a power of two. */
static fmb_system *moved_row(const fmb_system *row, long by, mp_bitcnt_t power)
{
    size_t n = fmb_system_terms(row, 0);
    int var[BODIES_MOST_DIM + 1];
    mpq_t coef[BODIES_MOST_DIM + 1], b, d;
    fmb_system *out = NULL;
    must(fmb_system_new(fmb_system_dim(row), NULL, &out));
    mpq_inits(b, d, NULL);
    for (size_t k = 0; k < n; k++) {
        mpq_init(coef[k]);
        var[k] = fmb_system_term_q(row, 0, k, coef[k]);
    }
    fmb_system_rhs_q(row, 0, b);
    mpq_set_si(d, by, 1);
    mpq_mul_2exp(d, d, power);
    mpq_add(b, b, d);
    must(fmb_system_add_q(out, n, var, coef, FMB_LE, b));
    for (size_t k = 0; k < n; k++)
        mpq_clear(coef[k]);
    mpq_clears(b, d, NULL);
    return out;
}

/* The first frame reaches the row's right side, so it may not come nearer; nor may the frames
 * change places, unless they only touch. */
static void expect_spoilt_rejected(const fmb_frame *f, fmb_contact contact, const fmb_system *row,
                                   long pair)
{
    fmb_system *less = moved_row(row, -1, 0), *more = moved_row(row, 1, 4000);
    const fmb_frame swapped[2] = {f[1], f[0]};
    expect(!fmb_separates(f, contact, less), "a row that cuts the first frame was accepted", pair);
    expect(!fmb_separates(f, contact, more), "a row beyond the second was accepted", pair);
    if (contact == FMB_CONTACT_CLOSED)
        expect(!fmb_separates(swapped, contact, row), "frames may change places", pair);
    fmb_system_free(less);
    fmb_system_free(more);
}

static void separate_pair(fmb_solver *v, const fmb_frame *f, fmb_contact contact,
                          fmb_verdict verdict, long pair)
{
    fmb_system *row = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_separate(v, f, contact, &row, &r));
    expect(r.verdict == verdict, "verdicts differ", pair);
    expect((row != NULL) == (verdict == FMB_INFEASIBLE), "a row, or none", pair);
    if (!row)
        return;
    expect(fmb_separates(f, contact, row), "the row was rejected", pair);
    expect_spoilt_rejected(f, contact, row, pair);
    fmb_system_free(row);
}

int main(int argc, char **argv)
{
    long wanted = argc > 1 ? atol(argv[1]) : 1000, apart = 0, pair = 0;
    support_rng g = {argc > 2 ? strtoull(argv[2], NULL, 10) : 1};
    fmb_pair *kernel[BODIES_MOST_DIM + 1][2];
    fmb_solver *v = NULL;
    must(fmb_solver_new(NULL, NULL, &v));
    for (int dim = 1; dim <= BODIES_MOST_DIM; dim++)
        for (int open = 0; open < 2; open++) {
            fmb_pair_options o = {.size = sizeof o};
            o.contact = open ? FMB_CONTACT_OPEN : FMB_CONTACT_CLOSED;
            must(fmb_pair_new(dim, &o, NULL, &kernel[dim][open]));
        }
    for (; apart < wanted && faults == 0; pair++) {
        bodies b;
        fmb_verdict verdict;
        int dim = support_between(&g, 1, BODIES_MOST_DIM), open = support_between(&g, 0, 1);
        bodies_draw(&g, dim, support_chance(&g, 50), support_between(&g, 3, 12), &b);
        fmb_pair_answers answers = {.size = sizeof answers, .verdict = &verdict};
        must(fmb_pair_test(kernel[dim][open], 1, &b.f[0], &b.f[1], &answers));
        separate_pair(v, b.f, open ? FMB_CONTACT_OPEN : FMB_CONTACT_CLOSED, verdict, pair);
        apart += verdict == FMB_INFEASIBLE;
    }
    for (int dim = 1; dim <= BODIES_MOST_DIM; dim++)
        for (int open = 0; open < 2; open++)
            fmb_pair_free(kernel[dim][open]);
    fmb_solver_free(v);
    printf("%ld pairs, %ld apart, %d faults\n", pair, apart, faults);
    return faults > 0;
}
