/* rationals.c: fmb_pair_answer_q, against the system of the pair and its bounds. */
#include <criterion/criterion.h>

#include <fmb/gmp.h>
#include <pthread.h>

#include "rows.h"
#include "study/draw/pairs.h"

enum { MOST_DIM = 6, MOST = 2 * MOST_DIM + 1, NUMBERS = MOST_DIM * (MOST_DIM + 2) };

/* A frame over `denominator`; by its corners where by_corners. */
typedef struct rational_frame {
    fmb_frame_q frame;
    mpq_t number[NUMBERS];
} rational_frame;

static void fill(mpq_t *to, const double *from, int n, unsigned long denominator)
{
    mpq_t factor;
    mpq_init(factor);
    mpq_set_ui(factor, 1, denominator);
    for (int i = 0; i < n; i++) {
        mpq_set_d(to[i], from[i]);
        mpq_mul(to[i], to[i], factor);
    }
    mpq_clear(factor);
}

static void open_frame(rational_frame *r, const fmb_frame *f, unsigned long denominator,
                       bool by_corners)
{
    int d = f->dim, axes = f->naxes * d;
    for (int i = 0; i < NUMBERS; i++)
        mpq_init(r->number[i]);
    fill(r->number, f->origin, d, denominator);
    fill(r->number + d, f->axes, axes, denominator);
    if (f->speed)
        fill(r->number + d + axes, f->speed, d, denominator);
    for (int i = 0; by_corners && i < axes; i++)
        mpq_add(r->number[d + i], r->number[d + i], r->number[i % d]);
    r->frame = (fmb_frame_q){by_corners ? f->shape + FMB_CUBOID_BY_CORNERS : f->shape,
                             d,
                             f->naxes,
                             r->number,
                             r->number + d,
                             f->speed ? r->number + d + axes : NULL};
}

static void close_frame(rational_frame *r)
{
    for (int i = 0; i < NUMBERS; i++)
        mpq_clear(r->number[i]);
}

typedef struct places {
    mpq_t world[2 * MOST_DIM], inside[2 * MOST_DIM], time[2], witness[MOST];
    fmb_pair_answers_q out;
} places;

static void init_all(mpq_t *q, int n)
{
    for (int i = 0; i < n; i++)
        mpq_init(q[i]);
}

static void clear_all(mpq_t *q, int n)
{
    for (int i = 0; i < n; i++)
        mpq_clear(q[i]);
}

static void open_places(places *a)
{
    init_all(a->world, 2 * MOST_DIM);
    init_all(a->inside, 2 * MOST_DIM);
    init_all(a->time, 2);
    init_all(a->witness, MOST);
    a->out = (fmb_pair_answers_q){.size = sizeof(fmb_pair_answers_q),
                                  .world = a->world,
                                  .inside = a->inside,
                                  .time = a->time,
                                  .witness = a->witness};
}

static void close_places(places *a)
{
    clear_all(a->world, 2 * MOST_DIM);
    clear_all(a->inside, 2 * MOST_DIM);
    clear_all(a->time, 2);
    clear_all(a->witness, MOST);
}

static void expect_ends(const fmb_box *box, int first, int n, mpq_t *ends)
{
    mpq_t end;
    mpq_init(end);
    for (int i = 0; i < 2 * n; i++) {
        cr_assert(fmb_box_end_q(box, first + i / 2, i % 2 ? FMB_UPPER : FMB_LOWER, end));
        cr_assert(mpq_equal(end, ends[i]), "end %d of variable %d", i % 2, first + i / 2);
    }
    mpq_clear(end);
}

/* The system with x, c of the second frame and t fixed has a solution. */
static void expect_witness(fmb_solver *v, fmb_system *s, const rational_frame *q, int first,
                           mpq_t *at)
{
    int d = q->frame.dim, n = fmb_system_dim(s) - first;
    fmb_result r = {.size = sizeof r};
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    for (int i = 0; i < d + n; i++) {
        int var = i < d ? i : first + i - d;
        must(fmb_system_add_q(s, 1, &var, &one, FMB_EQ, at[i]));
    }
    must(fmb_solve(v, s, &r));
    cr_assert_eq(r.verdict, FMB_FEASIBLE);
    mpq_clear(one);
}

/* Returns whether it was answered. */
static bool compare_with_system(fmb_solver *v, const study_pair *pair, unsigned long denominator,
                                bool by_corners)
{
    rational_frame f[2];
    places a;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_system *s = NULL;
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    open_places(&a);
    open_frame(&f[0], &pair->p, denominator, false);
    open_frame(&f[1], &pair->q, denominator, by_corners);
    const fmb_frame_q both[2] = {f[0].frame, f[1].frame};
    int d = both[0].dim, first = d + both[0].naxes, inside = both[1].naxes;
    must(fmb_system_from_frames_q(both, 2, FMB_COORDINATES_ALL, FMB_CONTACT_CLOSED, NULL, &s));
    must(fmb_solve(v, s, &r));
    must(fmb_pair_answer_q(&both[0], &both[1], &a.out, &verdict));
    cr_assert(verdict == FMB_UNKNOWN || verdict == r.verdict);
    if (verdict == FMB_FEASIBLE) {
        must(fmb_bound(v, s, NULL, 0, &box, &r));
        expect_ends(box, 0, d, a.world);
        expect_ends(box, first, inside, a.inside);
        expect_ends(box, first + inside, both[0].speed || both[1].speed, a.time);
        expect_witness(v, s, &f[1], first, a.witness);
    }
    fmb_box_free(box);
    fmb_system_free(s);
    close_frame(&f[0]);
    close_frame(&f[1]);
    close_places(&a);
    return verdict != FMB_UNKNOWN;
}

static int compare_plan(const study_pair_plan *plan, int n)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    static study_pair pair;
    int answered = 0;
    o.evidence = FMB_EVIDENCE_NONE;
    must(fmb_solver_new(&o, NULL, &v));
    for (int i = 0; i < n; i++) {
        study_pair_draw(plan, 5, (uint64_t)i, &pair);
        answered += compare_with_system(v, &pair, i % 3 == 0 ? 1 : i % 3 == 1 ? 7 : 1000, i % 2);
    }
    fmb_solver_free(v);
    return answered;
}

/* Six pairs: all of them are told. */
static void expect_all_told(const study_pair_plan *plan)
{
    cr_expect_eq(compare_plan(plan, 6), 6, "%s in %d dimensions",
                 study_pair_family_text(plan->family), plan->dim);
}

Test(rationals, against_systems)
{
    static const study_pair_family family[] = {STUDY_PAIR_ARTICLE, STUDY_PAIR_LATTICE,
                                               STUDY_PAIR_TOUCHING, STUDY_PAIR_DEGENERATE};
    for (int kind = 0; kind < 6 * 2 * 4; kind++) {
        const study_pair_plan plan = {.family = family[kind % 4],
                                      .dim = 1 + kind / 4 % 6,
                                      .moves = kind / 24,
                                      .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
        expect_all_told(&plan);
    }
}

Test(rationals, faces_and_near_pairs)
{
    for (int kind = 0; kind < 16; kind++) {
        const study_pair_plan plan = {.family = kind % 2 ? STUDY_PAIR_NEAR : STUDY_PAIR_LATTICE,
                                      .dim = 3 + kind / 4 % 2,
                                      .moves = kind / 8,
                                      .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE},
                                      .naxes = {1 + kind % 3, 1 + kind / 2 % 3}};
        compare_plan(&plan, 6);
    }
}

/* Numbers of a thousand digits. */
Test(rationals, long_numbers)
{
    static const study_pair_family FAMILY[] = {STUDY_PAIR_RAGGED, STUDY_PAIR_DENORMAL,
                                               STUDY_PAIR_SCALED, STUDY_PAIR_SPREAD};
    for (int kind = 0; kind < 24; kind++) {
        const study_pair_plan plan = {.family = FAMILY[kind % 4],
                                      .dim = 2 + kind / 4 % 3,
                                      .moves = kind / 12,
                                      .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
        expect_all_told(&plan);
    }
}

/* ---- in a small thread ----------------------------------------------------------------------- */

/* What threads have where libc is musl. */
enum { SMALL_STACK = 128 << 10, LARGE_DIM = 8, LARGE = 2 * LARGE_DIM + 1 };

typedef struct question {
    const fmb_frame_q *p, *q;
    const fmb_pair_answers_q *out;
    fmb_verdict verdict;
} question;

static void *ask(void *asked)
{
    question *a = asked;
    must(fmb_pair_answer_q(a->p, a->q, a->out, &a->verdict));
    return NULL;
}

static void ask_in_small_thread(question *a)
{
    pthread_attr_t small;
    pthread_t thread;
    cr_assert_eq(pthread_attr_init(&small), 0);
    cr_assert_eq(pthread_attr_setstacksize(&small, SMALL_STACK), 0);
    cr_assert_eq(pthread_create(&thread, &small, ask, a), 0);
    cr_assert_eq(pthread_join(thread, NULL), 0);
    pthread_attr_destroy(&small);
}

/* Two cuboids in eight dimensions with a corner at 0, of which one is 2^1000 times as large. */
Test(rationals, long_numbers_in_a_small_thread)
{
    static mpq_t number[2][LARGE_DIM * (LARGE_DIM + 1)], end[4 * LARGE_DIM], at[LARGE];
    fmb_frame_q f[2];
    const fmb_pair_answers_q out = {
        .size = sizeof out, .world = end, .inside = end + 2 * LARGE_DIM, .witness = at};
    question a = {&f[0], &f[1], &out, FMB_UNKNOWN};
    init_all(end, 4 * LARGE_DIM);
    init_all(at, LARGE);
    for (int k = 0; k < 2; k++) {
        init_all(number[k], LARGE_DIM * (LARGE_DIM + 1));
        for (int i = 0; i < LARGE_DIM * (LARGE_DIM + 1); i++) {
            mpq_set_si(number[k][i], i < LARGE_DIM ? 0 : (i * i + k) % 7 - 3, 3);
            mpq_canonicalize(number[k][i]);
            if (k == 1)
                mpq_mul_2exp(number[k][i], number[k][i], 1000);
        }
        f[k] =
            (fmb_frame_q){FMB_CUBOID, LARGE_DIM, LARGE_DIM, number[k], number[k] + LARGE_DIM, NULL};
    }
    ask_in_small_thread(&a);
    cr_expect_eq(a.verdict, FMB_FEASIBLE);
    for (int k = 0; k < 2; k++)
        clear_all(number[k], LARGE_DIM * (LARGE_DIM + 1));
    clear_all(end, 4 * LARGE_DIM);
    clear_all(at, LARGE);
}

Test(rationals, what_is_not_asked_or_not_for_it)
{
    const study_pair_plan plan = {.family = STUDY_PAIR_LATTICE, .dim = 3};
    static study_pair pair;
    rational_frame f;
    fmb_verdict verdict = FMB_INFEASIBLE;
    const fmb_pair_answers_q nothing = {.size = sizeof nothing};
    study_pair_draw(&plan, 1, 1, &pair);
    open_frame(&f, &pair.p, 3, false);
    cr_expect_eq(fmb_pair_answer_q(&f.frame, &f.frame, &nothing, &verdict), FMB_OK);
    cr_expect_eq(verdict, FMB_FEASIBLE);
    cr_expect_eq(fmb_pair_answer_q(NULL, &f.frame, &nothing, &verdict), FMB_ERR_ARG);
    cr_expect_eq(fmb_pair_answer_q(&f.frame, &f.frame, NULL, &verdict), FMB_ERR_ARG);
    cr_expect_eq(fmb_pair_answer_q(&f.frame, &f.frame, &nothing, NULL), FMB_ERR_ARG);
    mpq_set_ui(f.number[0], 1, 1);
    mpq_div_2exp(f.number[0], f.number[0], 500);
    cr_expect_eq(fmb_pair_answer_q(&f.frame, &f.frame, &nothing, &verdict), FMB_OK);
    cr_expect_eq(verdict, FMB_FEASIBLE, "numbers that are long");
    mpq_div_2exp(f.number[0], f.number[0], 20000);
    cr_expect_eq(fmb_pair_answer_q(&f.frame, &f.frame, &nothing, &verdict), FMB_OK);
    cr_expect_eq(verdict, FMB_UNKNOWN, "numbers that are too long");
    f.frame.naxes = 4;
    cr_expect_eq(fmb_pair_answer_q(&f.frame, &f.frame, &nothing, &verdict), FMB_ERR_ARG);
    close_frame(&f);
}
