/* contacts.c: the judge of depths and distances in four to eight dimensions accepts what is true,
 * and refuses what is not. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>

#include <fmb/proximity.h>
#include <fmb/solve.h>

#include "fmb-validate/contacts.h"
#include "support/must.h"

enum { MOST = VALIDATE_MOST_DIM };

static validate_contacts *judge;
static validate_claim claim;
static fmb_solver *solver;

static void open_judge(int dim)
{
    study_validation v = {.plan = {.dim = dim}};
    must(validate_contacts_open(&v, &judge));
    must(fmb_solver_new(NULL, NULL, &solver));
    validate_claim_init(&claim);
}

static void close_judge(void)
{
    validate_contacts_close(judge);
    fmb_solver_free(solver);
    validate_claim_clear(&claim);
}

static bool is_accepted(const fmb_frame *f)
{
    bool good;
    must(validate_judge(judge, f, &claim, &good));
    return good;
}

/* ---- two unit cubes, one `away` along the first axis ----------------------------------------- */

typedef struct cubes {
    double axes[MOST * MOST], here[MOST], there[MOST], speed[MOST];
    fmb_frame f[2];
} cubes;

static void make_cubes(cubes *c, int dim, double away)
{
    *c = (cubes){.there = {away}};
    for (int i = 0; i < dim; i++)
        c->axes[i * dim + i] = 1;
    c->f[0] = (fmb_frame){FMB_CUBOID, dim, dim, c->here, c->axes, NULL};
    c->f[1] = (fmb_frame){FMB_CUBOID, dim, dim, c->there, c->axes, NULL};
}

/* A shift of `length` along axis j, and the points where cubes are that far apart along it. */
static void claim_shift(bool deep, double length, int j)
{
    claim.deep = deep;
    claim.length = fabs(length);
    mpq_set_d(claim.square, length * length);
    mpq_set_ui(claim.time, 0, 1);
    for (int i = 0; i < MOST; i++) {
        mpq_set_d(claim.shift[i], i == j ? length : 0);
        mpq_set_ui(claim.point[0][i], i == j, 1);
        mpq_set_d(claim.point[1][i], i == j ? 1 - length : 0);
    }
}

Test(contacts, depths_of_cubes)
{
    for (int dim = VALIDATE_LEAST_DIM; dim <= MOST; dim++) {
        cubes c;
        open_judge(dim);
        make_cubes(&c, dim, 0.75);
        claim_shift(true, 0.25, 0);
        cr_expect(is_accepted(c.f), "%dD", dim);
        claim.length = nextafter(nextafter(0.25, 1), 1);
        cr_expect_not(is_accepted(c.f), "%dD: another length", dim);
        claim_shift(true, -0.25, 0);
        cr_expect_not(is_accepted(c.f), "%dD: the way in", dim);
        claim_shift(true, 0.25, 1);
        cr_expect_not(is_accepted(c.f), "%dD: along an axis where more overlaps", dim);
        claim_shift(true, 1, 1);
        cr_expect_not(is_accepted(c.f), "%dD: a way out, but a longer one", dim);
        claim_shift(true, 0.125, 0);
        cr_expect_not(is_accepted(c.f), "%dD: too short a way", dim);
        claim_shift(true, 0, 0);
        cr_expect_not(is_accepted(c.f), "%dD: they do more than touch", dim);
        claim_shift(false, -0.25, 0);
        cr_expect_not(is_accepted(c.f), "%dD: they are not apart", dim);
        make_cubes(&c, dim, 1);
        cr_expect(is_accepted(c.f) == false);
        claim_shift(true, 0, 0);
        cr_expect(is_accepted(c.f), "%dD: they touch", dim);
        close_judge();
    }
}

Test(contacts, distances_of_cubes)
{
    for (int dim = VALIDATE_LEAST_DIM; dim <= MOST; dim++) {
        cubes c;
        open_judge(dim);
        make_cubes(&c, dim, 3);
        claim_shift(false, -2, 0);
        cr_expect(is_accepted(c.f), "%dD", dim);
        mpq_set_ui(claim.time, 1, 2);
        cr_expect_not(is_accepted(c.f), "%dD: nothing moves", dim);
        claim_shift(false, -2, 0);
        mpq_set_ui(claim.point[0][0], 2, 1);
        mpq_set_ui(claim.point[1][0], 4, 1);
        cr_expect_not(is_accepted(c.f), "%dD: a point outside", dim);
        claim_shift(false, -3, 0);
        mpq_set_ui(claim.point[0][0], 0, 1);
        cr_expect_not(is_accepted(c.f), "%dD: points that are farther apart", dim);
        claim_shift(true, 0, 0);
        cr_expect_not(is_accepted(c.f), "%dD: they do not meet", dim);
        c.speed[0] = -1;
        c.f[1].speed = c.speed;
        claim_shift(false, -2, 0);
        cr_expect_not(is_accepted(c.f), "%dD: they come nearer", dim);
        claim_shift(false, -1, 0);
        mpq_set_ui(claim.time, 1, 1);
        cr_expect(is_accepted(c.f), "%dD: when it has moved", dim);
        close_judge();
    }
}

/* A square of two axes in a plane of its own has no interior: it is 0 deep wherever it is. */
Test(contacts, frames_without_interior)
{
    cubes c;
    open_judge(5);
    make_cubes(&c, 5, 0.5);
    c.f[0].naxes = c.f[1].naxes = 2;
    claim_shift(true, 0, 0);
    cr_expect(is_accepted(c.f));
    claim_shift(true, 0.5, 0);
    cr_expect_not(is_accepted(c.f));
    close_judge();
}

/* ---- what the library says ------------------------------------------------------------------- */

/* Random pairs of all families: what is said is true, and a little more or less is not. */
Test(contacts, answers_of_the_library)
{
    long deep = 0, apart = 0;
    for (int family = 0; family < STUDY_PAIR_FAMILIES; family++)
        for (uint64_t k = 0; k < 12; k++) {
            study_pair pair;
            study_pair_plan plan = {.dim = 4 + (int)k % 2, .moves = k % 3 == 0};
            plan.family = (study_pair_family)family;
            plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
            plan.naxes[k % 2] = k % 4 < 2 ? plan.dim - 1 - (int)k % 3 : 0;
            study_pair_draw(&plan, 41, k, &pair);
            const fmb_frame f[2] = {pair.p, pair.q};
            open_judge(plan.dim);
            bool said;
            must(validate_claim_ask(solver, f, &claim, &said));
            cr_expect(said && is_accepted(f), "%s %d", study_pair_family_text(plan.family), (int)k);
            *(claim.deep ? &deep : &apart) += 1;
            mpq_t more;
            mpq_init(more);
            mpq_set_d(more, 1 + 0x1p-50);
            for (int j = 0; j < plan.dim; j++)
                mpq_mul(claim.shift[j], claim.shift[j], more);
            mpq_mul(more, more, more);
            mpq_mul(claim.square, claim.square, more);
            claim.length *= 1 + 0x1p-50;
            cr_expect(is_accepted(f) == (mpq_sgn(claim.square) == 0));
            mpq_clear(more);
            close_judge();
        }
    cr_expect(deep >= 50 && apart >= 50, "%ld deep, %ld apart", deep, apart);
}

/* Pairs whose least normals have squares that doubles cannot hold, as coordinates differ by 2^300
 * and more; one of them had a depth that was too large by 2e-7. */
Test(contacts, depths_where_squares_are_lost)
{
    static const uint64_t SEED = 20261126117, K[] = {24521, 24522, 24523, 24524, 24525};
    const study_pair_plan plan = {.family = STUDY_PAIR_SPREAD,
                                  .dim = 4,
                                  .moves = true,
                                  .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
    open_judge(4);
    for (size_t i = 0; i < sizeof K / sizeof *K; i++) {
        study_pair pair;
        bool said;
        study_pair_draw(&plan, SEED, K[i], &pair);
        const fmb_frame f[2] = {pair.q, pair.p};
        must(validate_claim_ask(solver, f, &claim, &said));
        cr_expect(said && is_accepted(f), "pair %d", (int)K[i]);
    }
    close_judge();
}
