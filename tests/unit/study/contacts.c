/* contacts.c: the judge of depths and distances in four to eight dimensions accepts true answers,
 * and refuses false ones. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>

#include <fmb/proximity.h>
#include <fmb/solve.h>

#include "fmb-validate/boundary.h"
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

/* ---- depths the plain way -------------------------------------------------------------------- */

enum { MOST_CORNERS = 16, MOST_WAYS = 24 };

/* Corners of both frames, those of the second negated, directions of their edges, and the drift: in
 * four dimensions, as they are written. */
typedef struct plain {
    int corners[2], ways;
    mpq_t corner[2][MOST_CORNERS][4], way[MOST_WAYS][4], drift[4], n[4], s, t, most, least;
} plain;

static void for_each_of(size_t n, mpq_t (*vector)[4], void (*what)(mpq_ptr))
{
    for (size_t i = 0; i < n; i++)
        for (int j = 0; j < 4; j++)
            what(vector[i][j]);
}

static void for_all(plain *p, void (*what)(mpq_ptr))
{
    for_each_of(MOST_CORNERS, p->corner[0], what);
    for_each_of(MOST_CORNERS, p->corner[1], what);
    for_each_of(MOST_WAYS, p->way, what);
    for (int j = 0; j < 4; j++) {
        what(p->drift[j]);
        what(p->n[j]);
    }
    mpq_ptr const rest[] = {p->s, p->t, p->most, p->least};
    for (int i = 0; i < 4; i++)
        what(rest[i]);
}

static void start(mpq_ptr x)
{
    mpq_init(x);
}

static void end(mpq_ptr x)
{
    mpq_clear(x);
}

/* to += sign x */
static void add(plain *p, double x, int sign, mpq_t to)
{
    mpq_set_d(p->t, sign * x);
    mpq_add(to, to, p->t);
}

static void list_corners(plain *p, const fmb_frame *f, int k)
{
    int sign = k == 0 ? 1 : -1;
    p->corners[k] = f->shape == FMB_CUBOID ? 1 << f->naxes : f->naxes + 1;
    for (int c = 0; c < p->corners[k]; c++)
        for (int j = 0; j < 4; j++) {
            add(p, f->origin[j], sign, p->corner[k][c][j]);
            for (int i = 0; i < f->naxes; i++)
                if (f->shape == FMB_CUBOID ? c >> i & 1 : c == i + 1)
                    add(p, f->axes[i * 4 + j], sign, p->corner[k][c][j]);
        }
    for (int j = 0; j < 4 && f->speed; j++)
        add(p, f->speed[j], sign, p->drift[j]);
}

/* Between any two corners of a simplex, and along axes of a cuboid. */
static void list_ways(plain *p, const fmb_frame *f, int k)
{
    for (int a = 0; a < p->corners[k]; a++)
        for (int b = a + 1; b < p->corners[k]; b++) {
            if (f->shape == FMB_CUBOID && (a > 0 || (b & (b - 1)) != 0))
                continue;
            for (int j = 0; j < 4; j++)
                mpq_sub(p->way[p->ways][j], p->corner[k][b][j], p->corner[k][a][j]);
            p->ways++;
        }
}

/* Of three ways in three coordinates, all but j. */
static void find_minor(plain *p, const int *way, int j, mpq_t out)
{
    static const int TURN[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    mpq_set_ui(out, 0, 1);
    for (int i = 0; i < 6; i++) {
        mpq_set_si(p->t, i < 3 ? 1 : -1, 1);
        for (int k = 0; k < 3; k++)
            mpq_mul(p->t, p->t, p->way[way[k]][TURN[i][k] < j ? TURN[i][k] : TURN[i][k] + 1]);
        mpq_add(out, out, p->t);
    }
    if (j % 2)
        mpq_neg(out, out);
}

static void plain_dot(plain *p, mpq_t *a, mpq_t *b, mpq_t out)
{
    mpq_set_ui(out, 0, 1);
    for (int j = 0; j < 4; j++) {
        mpq_mul(p->t, a[j], b[j]);
        mpq_add(out, out, p->t);
    }
}

/* How far M reaches along sign times n, times |n|. */
static void find_reach(plain *p, int sign)
{
    plain_dot(p, p->n, p->drift, p->most);
    mpq_set_si(p->s, sign, 1);
    mpq_mul(p->most, p->most, p->s);
    if (mpq_sgn(p->most) < 0)
        mpq_set_ui(p->most, 0, 1);
    for (int k = 0; k < 2; k++) {
        mpq_t best;
        mpq_init(best);
        for (int c = 0; c < p->corners[k]; c++) {
            plain_dot(p, p->n, p->corner[k][c], p->s);
            if (sign < 0)
                mpq_neg(p->s, p->s);
            if (c == 0 || mpq_cmp(p->s, best) > 0)
                mpq_set(best, p->s);
        }
        mpq_add(p->most, p->most, best);
        mpq_clear(best);
    }
}

/* The square of the depth of frames that meet, to p->least. */
static void find_plain_depth(plain *p, const fmb_frame *f)
{
    bool any = false;
    for (int k = 0; k < 2; k++) {
        list_corners(p, &f[k], k);
        list_ways(p, &f[k], k);
    }
    for (int j = 0; j < 4; j++)
        mpq_set(p->way[p->ways][j], p->drift[j]);
    p->ways++;
    for (int a = 0; a < p->ways; a++)
        for (int b = 0; b < a; b++)
            for (int c = 0; c < b; c++)
                for (int sign = -1; sign < 2; sign += 2) {
                    for (int j = 0; j < 4; j++)
                        find_minor(p, (int[3]){a, b, c}, j, p->n[j]);
                    find_reach(p, sign);
                    plain_dot(p, p->n, p->n, p->s);
                    if (mpq_sgn(p->s) == 0)
                        continue;
                    mpq_mul(p->most, p->most, p->most);
                    mpq_div(p->most, p->most, p->s);
                    if (!any || mpq_cmp(p->most, p->least) < 0)
                        mpq_set(p->least, p->most);
                    any = true;
                }
}

/* Is a depth judged to be what it is, and is a little more or less refused? A unit is a power of 2
 * (difference.h). */
static void expect_depth(const fmb_frame *f, const char *family, uint64_t k)
{
    static plain p;
    validate_difference m;
    p = (plain){.ways = 0};
    for_all(&p, start);
    find_plain_depth(&p, f);
    validate_difference_init(&m);
    validate_difference_load(&m, &f[0], &f[1]);
    (m.unit > 0 ? mpq_div_2exp : mpq_mul_2exp)(p.least, p.least, 2 * (mp_bitcnt_t)abs(m.unit));
    cr_expect(validate_depth_is(&m, p.least), "%s %d", family, (int)k);
    for (int more = 0; more < 2 && mpq_sgn(p.least) > 0; more++) {
        mpq_set_d(p.t, more ? 1 + 0x1p-50 : 1 - 0x1p-50);
        mpq_mul(p.s, p.least, p.t);
        cr_expect_not(validate_depth_is(&m, p.s), "%s %d: %s", family, (int)k, more ? "+" : "-");
    }
    validate_difference_clear(&m);
    for_all(&p, end);
}

Test(contacts, depths_beside_the_plain_way)
{
    long deep = 0;
    must(fmb_solver_new(NULL, NULL, &solver));
    for (int family = 0; family < STUDY_PAIR_FAMILIES; family++)
        for (uint64_t k = 0; k < 6; k++) {
            study_pair pair;
            study_pair_plan plan = {
                .dim = 4, .moves = k % 2, .naxes = {3 + (int)k % 2, 2 + (int)k % 3}};
            plan.family = (study_pair_family)family;
            plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
            study_pair_draw(&plan, 20261126733, k, &pair);
            const fmb_frame f[2] = {pair.p, pair.q};
            fmb_proximity *d = NULL;
            must(fmb_depth(solver, f, FMB_NORM_EUCLIDEAN, &d, NULL));
            deep += d != NULL;
            if (d)
                expect_depth(f, study_pair_family_text(plan.family), k);
            fmb_proximity_free(d);
        }
    fmb_solver_free(solver);
    cr_expect(deep >= 30, "%ld", deep);
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
