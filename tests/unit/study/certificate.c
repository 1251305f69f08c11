/* certificate.c: valid certificates of where two frames meet are accepted, others refused. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>

#include "study/reference/basis.h"
#include "study/reference/verdicts.h"
#include "support/must.h"
#include "support/pair_counts.h"

enum { MOST = STUDY_MEETING_MOST_COLUMNS };

static study_meeting meeting;
static mpz_t z[MOST], y[MOST], n, k;

static void open_numbers(void)
{
    study_meeting_init(&meeting);
    for (int j = 0; j < MOST; j++)
        mpz_inits(z[j], y[j], NULL);
    mpz_inits(n, k, NULL);
}

static void close_numbers(void)
{
    study_meeting_clear(&meeting);
    for (int j = 0; j < MOST; j++)
        mpz_clears(z[j], y[j], NULL);
    mpz_clears(n, k, NULL);
}

TestSuite(certificate, .init = open_numbers, .fini = close_numbers);

static void set(mpz_t *to, size_t count, const int *from)
{
    for (size_t j = 0; j < count; j++)
        mpz_set_si(to[j], from[j]);
}

static bool has_point(fmb_contact contact, int parts, const int *at)
{
    set(z, (size_t)meeting.columns, at);
    mpz_set_si(n, parts);
    return study_meeting_has_point(&meeting, contact, z, n);
}

static bool has_none(fmb_contact contact, int x, int across)
{
    set(y, 2, (const int[]){x, across});
    return study_meeting_has_none(&meeting, contact, y);
}

static const double ZERO[2], ONE[2] = {1, 0}, THREE[2] = {3, 0}, UNIT[4] = {1, 0, 0, 1};
static const fmb_frame SQUARE = {FMB_CUBOID, 2, 2, ZERO, UNIT, NULL},
                       BESIDE = {FMB_CUBOID, 2, 2, ONE, UNIT, NULL},
                       AWAY = {FMB_CUBOID, 2, 2, THREE, UNIT, NULL},
                       TRIANGLE = {FMB_SIMPLEX, 2, 2, ZERO, UNIT, NULL};

/* Squares that have an edge in common. */
Test(certificate, touching)
{
    cr_assert(study_meeting_load(&meeting, &SQUARE, &BESIDE));
    cr_expect(has_point(FMB_CONTACT_CLOSED, 2, (const int[]){2, 1, 0, 1}));
    cr_expect(!has_point(FMB_CONTACT_OPEN, 2, (const int[]){2, 1, 0, 1}));
    cr_expect(!has_point(FMB_CONTACT_CLOSED, 2, (const int[]){3, 1, 1, 1}), "outside of A");
    cr_expect(!has_point(FMB_CONTACT_CLOSED, 2, (const int[]){1, 1, -1, 1}), "outside of B");
    cr_expect(!has_point(FMB_CONTACT_CLOSED, 2, (const int[]){2, 1, 0, 0}), "no solution");
    cr_expect(!has_point(FMB_CONTACT_CLOSED, -2, (const int[]){-2, -1, 0, -1}), "parts");
    cr_expect(!has_point(FMB_CONTACT_CLOSED, 0, (const int[]){0, 0, 0, 0}), "parts");
    cr_expect(has_none(FMB_CONTACT_OPEN, 7, 0) && !has_none(FMB_CONTACT_CLOSED, 7, 0));
    cr_expect(!has_none(FMB_CONTACT_OPEN, -7, 0) && !has_none(FMB_CONTACT_OPEN, 7, 1));
    cr_expect(!has_none(FMB_CONTACT_OPEN, 0, 0), "it shows nothing");
}

Test(certificate, apart)
{
    cr_assert(study_meeting_load(&meeting, &SQUARE, &AWAY));
    cr_expect(has_none(FMB_CONTACT_CLOSED, 1, 1) && has_none(FMB_CONTACT_OPEN, 1, 1));
    cr_expect(!has_none(FMB_CONTACT_CLOSED, 1, -3) && !has_none(FMB_CONTACT_CLOSED, 0, 1));
}

/* The sum of a simplex's unknowns, and which of them the largest value is. */
Test(certificate, simplices)
{
    const double far[] = {0.75, 0.75};
    const fmb_frame point = {FMB_CUBOID, 2, 0, far, NULL, NULL};
    cr_assert(study_meeting_load(&meeting, &TRIANGLE, &SQUARE));
    cr_expect(has_point(FMB_CONTACT_OPEN, 3, (const int[]){1, 1, 1, 1}));
    cr_expect(has_point(FMB_CONTACT_CLOSED, 2, (const int[]){1, 1, 1, 1}));
    cr_expect(!has_point(FMB_CONTACT_OPEN, 2, (const int[]){1, 1, 1, 1}), "on the edge");
    cr_expect(!has_point(FMB_CONTACT_CLOSED, 3, (const int[]){2, 2, 2, 2}), "beyond it");
    cr_assert(study_meeting_load(&meeting, &TRIANGLE, &point));
    cr_expect(has_none(FMB_CONTACT_CLOSED, 1, 1) && !has_none(FMB_CONTACT_CLOSED, 1, 0));
}

/* Time goes from 0 to 1, its ends included even if frames are open. */
Test(certificate, time)
{
    const double speed[] = {3, 0}, slow[] = {0.5, 0};
    fmb_frame moving = SQUARE;
    moving.speed = speed;
    cr_assert(study_meeting_load(&meeting, &moving, &AWAY));
    cr_expect(has_point(FMB_CONTACT_OPEN, 2, (const int[]){1, 1, 1, 1, 2}));
    cr_expect(!has_none(FMB_CONTACT_OPEN, 1, 0));
    moving.speed = slow;
    cr_assert(study_meeting_load(&meeting, &moving, &AWAY));
    cr_expect(has_none(FMB_CONTACT_CLOSED, 1, 0));
    cr_expect(!has_point(FMB_CONTACT_CLOSED, 2, (const int[]){2, 1, 1, 1, 10}), "too late");
    cr_assert(study_meeting_load(&meeting, &AWAY, &moving));
    cr_expect(has_none(FMB_CONTACT_CLOSED, -1, 0));
    const double here[] = {0, 0}, there[] = {1, 0}, up[] = {0, 1};
    const fmb_frame p = {FMB_CUBOID, 2, 1, here, up, NULL}, q = {FMB_CUBOID, 2, 1, there, up, NULL};
    cr_assert(study_meeting_load(&meeting, &p, &q));
    cr_expect(has_none(FMB_CONTACT_CLOSED, 1, 0));
    cr_assert(study_meeting_load(&meeting, &p, &p));
    cr_expect(!has_none(FMB_CONTACT_OPEN, 1, 0), "in one line they meet");
}

/* Where the point of these squares at that time lies, and how near that is; no other counts. */
Test(certificate, near_points)
{
    const double speed[] = {3, 0}, at[] = {1.75, 0.5}, none[] = {1.75, NAN};
    fmb_frame moving = SQUARE;
    moving.speed = speed;
    cr_assert(study_meeting_load(&meeting, &moving, &BESIDE));
    /* c of A is (1/4, 1/2), of B (3/4, 1/2), t 1/2 */
    cr_assert(has_point(FMB_CONTACT_CLOSED, 4, (const int[]){1, 2, 3, 2, 2}));
    cr_expect(study_meeting_is_near(&meeting, z, n, at, 0));
    cr_expect(study_meeting_is_near(&meeting, z, n, (const double[]){1.5, 0.75}, 0.25));
    cr_expect(!study_meeting_is_near(&meeting, z, n, (const double[]){1.5, 0.5}, 0.125));
    cr_expect(!study_meeting_is_near(&meeting, z, n, (const double[]){1.75, 0.75}, 0.125));
    cr_expect(!study_meeting_is_near(&meeting, z, n, (const double[]){1.75, 0.25}, 0.125));
    cr_expect(!study_meeting_is_near(&meeting, z, n, none, 1), "no number");
    cr_assert(!has_point(FMB_CONTACT_CLOSED, 4, (const int[]){1, 2, 3, 3, 2}));
    cr_expect(!study_meeting_is_near(&meeting, z, n, at, 1), "no common point");
}

/* ---- ends ------------------------------------------------------------------------------------ */

/* The right end of what the triangle and a square from (1/3, 0) have in common, along x: 1; and its
 * left one, which is no double. Every end, point and price that is off is refused. */
static bool is_end(const study_form *f, int parts, const int *at, int whole, int x, double end)
{
    set(z, 4, at);
    set(y, 2, (const int[]){x, 0});
    mpz_set_si(n, parts);
    mpz_set_si(k, whole);
    return study_meeting_has_end(&meeting, f, z, n, y, k, end);
}

Test(certificate, ends)
{
    const double third[] = {1.0 / 3, 0}, three[] = {3, 0, 0, 3};
    const fmb_frame wide = {FMB_CUBOID, 2, 2, third, three, NULL};
    study_form f;
    study_form_init(&f);
    cr_assert(study_meeting_load(&meeting, &TRIANGLE, &wide));
    const int unit = meeting.unit[0];
    cr_assert_eq(ldexp(1, unit), 0x1p-54);
    study_form_of_unknown(&f, &meeting, 0, 1);
    cr_expect(!is_end(&f, 1, (const int[]){1, 0, 0, 0}, 1, 0, 1), "no common point");
    /* 1 = 1/3 + 3 c */
    set(z, 4, (const int[]){1, 0, 0, 0});
    mpz_set_ui(n, 3);
    mpz_mul_2exp(n, n, 54);
    mpz_mul(z[0], z[0], n);
    mpz_set_ui(z[2], 1);
    mpz_mul_2exp(z[2], z[2], 54);
    mpz_sub_ui(z[2], z[2], (unsigned long)ldexp(third[0], 54));
    mpz_set_ui(y[0], 0);
    mpz_set_ui(y[1], 0);
    mpz_set_ui(k, 1);
    cr_expect(study_meeting_has_end(&meeting, &f, z, n, y, k, 1));
    cr_expect(!study_meeting_has_end(&meeting, &f, z, n, y, k, nextafter(1, 2)));
    cr_expect(!study_meeting_has_end(&meeting, &f, z, n, y, k, nextafter(1, 0)));
    cr_expect(!study_meeting_has_end(&meeting, &f, z, n, y, k, NAN));
    cr_expect(!study_meeting_has_end(&meeting, &f, z, n, y, k, INFINITY));
    mpz_set_si(k, -1);
    cr_expect(!study_meeting_has_end(&meeting, &f, z, n, y, k, 1));
    mpz_set_ui(k, 1);
    mpz_set_si(y[0], 1);
    cr_expect(!study_meeting_has_end(&meeting, &f, z, n, y, k, 1), "these prices do not prove it");
    mpz_set_si(y[0], 0);
    study_form_of_coordinate(&f, &meeting, 0, 1);
    cr_expect(study_meeting_has_end(&meeting, &f, z, n, y, k, 1));
    cr_expect(!study_meeting_has_end(&meeting, &f, z, n, y, k, nextafter(1, 0)));
    study_form_clear(&f);
}

/* What the squares have in common reaches as far as B does: the row says so. */
Test(certificate, ends_by_prices)
{
    study_form f;
    study_form_init(&f);
    cr_assert(study_meeting_load(&meeting, &BESIDE, &SQUARE));
    study_form_of_coordinate(&f, &meeting, 0, 1);
    cr_expect(is_end(&f, 2, (const int[]){0, 1, 2, 1}, 1, 1, 1));
    cr_expect(is_end(&f, 2, (const int[]){0, 1, 2, 1}, 5, 5, 1));
    cr_expect(!is_end(&f, 2, (const int[]){0, 1, 2, 1}, 1, 0, 1));
    cr_expect(!is_end(&f, 2, (const int[]){0, 1, 2, 1}, 1, 1, 0));
    cr_expect(!is_end(&f, 2, (const int[]){0, 1, 2, 1}, 1, 0, 0));
    cr_expect(!is_end(&f, 2, (const int[]){0, 1, 2, 1}, 1, 2, 0));
    cr_expect(!is_end(&f, 2, (const int[]){0, 1, 2, 1}, 1, 1, 2));
    study_form_clear(&f);
}

/* Is every coordinate of the world proved to end there? */
static bool are_ends(study_proposer *w, const double *world)
{
    study_form f;
    bool good = study_start_ends(w, &meeting);
    study_form_init(&f);
    for (int i = 0; good && i < 2 * meeting.dim; i++) {
        study_form_of_coordinate(&f, &meeting, i / 2, i % 2 ? 1 : -1);
        good = study_prove_end(w, &meeting, &f, i % 2 ? world[i] : -world[i]);
    }
    study_form_clear(&f);
    return good;
}

/* Frames whose numbers are as far apart as doubles can be: their tightest boxes need no exact
 * query, and all but a few are proved. */
Test(certificate, ends_of_long_numbers)
{
    static const study_pair_family FAMILY[] = {STUDY_PAIR_DENORMAL, STUDY_PAIR_RAGGED,
                                               STUDY_PAIR_SPREAD, STUDY_PAIR_SCALED};
    int asked = 0, proved = 0;
    for (int i = 0; i < 240; i++) {
        study_pair_plan plan = {.family = FAMILY[i % 4], .dim = 2 + i / 4 % 4, .moves = i / 16 % 2};
        double world[2 * STUDY_PAIR_MOST_DIM];
        fmb_verdict said;
        fmb_pair_options o = {.size = sizeof o, .tightest = true};
        fmb_pair_answers out = {.size = sizeof out, .verdict = &said, .world = world};
        fmb_pair *pair = NULL;
        study_proposer *w = study_proposer_open(plan.dim);
        study_pair x;
        plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
        study_pair_draw(&plan, 11, (uint64_t)i, &x);
        must(fmb_pair_new(plan.dim, &o, NULL, &pair));
        must(fmb_pair_test(pair, 1, &x.p, &x.q, &out));
        cr_assert(w && study_meeting_load(&meeting, &x.p, &x.q));
        asked += said == FMB_FEASIBLE;
        proved += said == FMB_FEASIBLE && are_ends(w, world);
        cr_expect_eq(counts_of_pairs(pair).exact_boxes, 0u, "pair %d", i);
        fmb_pair_free(pair);
        study_proposer_close(w);
    }
    cr_expect(asked > 60 && proved > asked * 24 / 25, "%d of %d", proved, asked);
}

/* ---- what is accepted is true ---------------------------------------------------------------- */

static fmb_verdict ask(fmb_contact contact, const fmb_frame *p, const fmb_frame *q)
{
    fmb_verdict said;
    fmb_pair_options o = {.size = sizeof o, .contact = contact, .method = FMB_PAIR_EXACT};
    fmb_pair_answers out = {.size = sizeof out, .verdict = &said};
    fmb_pair *pair = NULL;
    must(fmb_pair_new(p->dim, &o, NULL, &pair));
    must(fmb_pair_test(pair, 1, p, q, &out));
    fmb_pair_free(pair);
    return said;
}

/* Every direction and every point of small numbers; how many were accepted. */
static int try_all(fmb_contact contact, fmb_verdict truth)
{
    int accepted = 0, at[5] = {0};
    for (int x = -3; x <= 3; x++)
        for (int across = -3; across <= 3; across++)
            if (has_none(contact, x, across)) {
                cr_assert_eq(truth, FMB_INFEASIBLE);
                accepted++;
            }
    for (int code = 0; code < 7 * 7 * 7 * 7 * (meeting.columns > 4 ? 7 : 1); code++) {
        for (int j = 0, rest = code; j < 5; j++, rest /= 7)
            at[j] = rest % 7 - 1;
        if (has_point(contact, 4, at)) {
            cr_assert_eq(truth, FMB_FEASIBLE);
            accepted++;
        }
    }
    return accepted;
}

Test(certificate, what_is_accepted_is_true)
{
    int accepted[2][2] = {{0}};
    for (uint64_t i = 0; i < 300; i++) {
        study_pair_plan plan = {.family = STUDY_PAIR_LATTICE, .dim = 2, .moves = i % 2};
        study_pair pair;
        plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
        plan.naxes[i / 2 % 2] = (int)(i / 4 % 3);
        study_pair_draw(&plan, 5, i, &pair);
        for (int contact = 0; contact < 2; contact++) {
            fmb_verdict truth = ask((fmb_contact)contact, &pair.p, &pair.q);
            cr_assert(study_meeting_load(&meeting, &pair.p, &pair.q));
            if (pair.p.naxes + pair.q.naxes == 4)
                accepted[contact][truth == FMB_FEASIBLE] += try_all((fmb_contact)contact, truth);
        }
    }
    for (int contact = 0; contact < 2; contact++)
        cr_expect(accepted[contact][0] > 10 && accepted[contact][1] > 10, "%d %d",
                  accepted[contact][0], accepted[contact][1]);
}

/* Doubles that are no numbers, or too large for whole ones, name no point: they count as 0. */
Test(certificate, doubles_that_name_no_point)
{
    const double wrong[] = {NAN, INFINITY, -INFINITY, 0x1p1000};
    study_proposer *w = study_proposer_open(2);
    cr_assert(w && study_meeting_load(&meeting, &SQUARE, &BESIDE));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        double at[MOST + 2];
        cr_assert(study_start_ends(w, &meeting));
        for (int j = 0; j < MOST + 2; j++)
            at[j] = wrong[i];
        cr_assert(study_basis_solve_point(w, &meeting, at));
        for (int j = 0; j < meeting.columns; j++)
            cr_expect(w->g->program.is_pivot[j] || mpz_sgn(w->z[j]) == 0);
        cr_expect(mpz_sgn(w->scale) > 0);
    }
    study_proposer_close(w);
}

/* Verdicts that are proved are those of the exact way, and few are left to it. */
Test(certificate, proposals)
{
    int asked = 0, proved = 0;
    for (int i = 0; i < 20 * STUDY_PAIR_FAMILIES; i++) {
        study_pair_plan plan = {.family = (study_pair_family)(i / 20), .dim = 1 + i % 5};
        study_pair pair;
        fmb_verdict said[2];
        study_proposer *w = study_proposer_open(plan.dim);
        cr_assert(w);
        plan.moves = i % 2;
        plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
        study_pair_draw(&plan, 9, (uint64_t)i, &pair);
        cr_assert(study_meeting_load(&meeting, &pair.p, &pair.q));
        study_prove_verdicts(w, &meeting, said);
        for (int contact = 0; contact < 2; contact++) {
            asked++;
            proved += said[contact] != FMB_UNKNOWN;
            cr_expect(said[contact] == FMB_UNKNOWN ||
                      said[contact] == ask((fmb_contact)contact, &pair.p, &pair.q));
        }
        study_proposer_close(w);
    }
    cr_expect(proved > asked * 24 / 25, "%d of %d", proved, asked);
}
