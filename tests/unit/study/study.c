/* study.c: the room of studies: reproducible draws, wrong answers that are detected, statistics
 * checked by hand. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/io.h>

#include "study/grid/digest.h"
#include "support/must.h"

static const study_class PLAIN = {
    .dim = 3, .moves = true, .shape = {FMB_CUBOID, FMB_SIMPLEX}, .meets = true};

/* The text of the first draws of a class. */
static char *draws(const study_class *c, unsigned long seed, int n)
{
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    gsl_rng *rng = study_draw_begin(c, seed);
    for (int k = 0; k < n; k++) {
        fmb_system *s = NULL;
        must(study_draw_pair(rng, c, &s));
        must(fmb_system_write(s, FMB_FORMAT_TEXT, f));
        fmb_system_free(s);
    }
    gsl_rng_free(rng);
    fclose(f);
    return text;
}

static bool draw_alike(const study_class *a, unsigned long x, const study_class *b, unsigned long y)
{
    char *s = draws(a, x, 3), *t = draws(b, y, 3);
    bool alike = strcmp(s, t) == 0;
    free(s);
    free(t);
    return alike;
}

Test(study, draws)
{
    study_class apart = PLAIN, other = PLAIN, floats = PLAIN;
    apart.meets = false;
    other.shape[1] = FMB_CUBOID;
    floats.family = STUDY_FLOAT;
    cr_expect(draw_alike(&PLAIN, 1, &PLAIN, 1));
    cr_expect(draw_alike(&PLAIN, 1, &apart, 1), "the answer is looked at after the draw");
    cr_expect_not(draw_alike(&PLAIN, 1, &PLAIN, 2));
    cr_expect_not(draw_alike(&PLAIN, 1, &other, 1));
    cr_expect_not(draw_alike(&PLAIN, 1, &floats, 1));
}

Test(study, words)
{
    study_family f = STUDY_SMALL;
    cr_expect(study_family_parse("float", &f) && f == STUDY_FLOAT);
    cr_expect_not(study_family_parse("huge", &f));
    cr_expect_str_eq(study_family_text(STUDY_SMALL), "small");
}

/* ---- a whole study --------------------------------------------------------------------------- */

static study_way ways[] = {{.rules = "none"}, {.rules = "kohler"}, {.rules = "no such rule"}};

static study_grid small_grid(bool meets)
{
    study_grid g = {.seed = 3, .per_class = 5, .way = ways, .ways = 3, .passes = 1};
    study_sample sample = {.class = PLAIN};
    sample.class.meets = meets;
    g.limits = (study_limits){.max_rows = 5000, .presolve = "bounds"};
    must(study_grid_add(&g, &sample));
    return g;
}

static bool everything(const void *self, const study_sample *sample)
{
    (void)sample;
    return self == NULL;
}

Test(study, grid)
{
    for (int meets = 0; meets < 2; meets++) {
        study_grid g = small_grid(meets);
        study_digest d;
        must(study_grid_run(&g));
        cr_expect(g.complete == 1 && g.rejected == 0);
        cr_expect(g.known[0] && g.known[1] && !g.known[2]);
        for (size_t i = 0; i < 5; i++) {
            const study_run *none = study_grid_at(&g, 0, i, 0);
            const study_run *kohler = study_grid_at(&g, 0, i, 1);
            cr_expect_eq(g.sample[0].item[i].truth, meets ? FMB_FEASIBLE : FMB_INFEASIBLE);
            cr_expect(none->outcome == STUDY_DECIDED && none->solved == STUDY_DECIDED);
            cr_expect(none->kept <= none->made && none->made <= none->pairs);
            cr_expect(none->peak > 0);
            cr_expect(none->held >= none->peak);
            cr_expect(!meets || kohler->kept <= none->kept);
            cr_expect_eq(study_grid_at(&g, 0, i, 2)->outcome, STUDY_NOT_RUN);
        }
        must(study_digest_make(&g, 1, 0, everything, NULL, &d));
        cr_expect(d.systems == 5 && d.decided == 5 && d.wrong == 0 && d.both == 5 && d.timed == 5);
        must(study_digest_make(&g, 1, 0, everything, &d, &d));
        cr_expect_eq(d.systems, 0);
        study_grid_clear(&g);
    }
}

/* In as many passes as there are ways, of an odd number in twice as many: each stands at each
 * place, and follows each other one, equally often. */
Test(study, everyone_begins_as_often)
{
    enum { MOST = 7 };
    for (size_t n = 1; n <= MOST; n++)
        for (size_t turn = 0; turn < 2 * n; turn += n) {
            study_grid g = {.ways = n, .turn = turn};
            size_t squares = 1 + n % 2;
            int stands[MOST][MOST] = {{0}}, follows[MOST][MOST] = {{0}};
            for (size_t i = 0; i < squares * n; i++)
                for (size_t place = 0; place < n; place++) {
                    size_t way = study_grid_turn(&g, i / 2, i - i / 2, place);
                    stands[way][place]++;
                    if (place > 0)
                        follows[way][study_grid_turn(&g, 0, i, place - 1)]++;
                }
            for (size_t a = 0; a < n; a++)
                for (size_t b = 0; b < n; b++) {
                    cr_expect_eq(stands[a][b], (int)squares);
                    cr_expect_eq(follows[a][b], a == b ? 0 : (int)squares);
                }
        }
}

/* Who is at work at each step. */
typedef struct diary {
    fmb_solver *volatile running;
    fmb_solver *at[64];
    size_t size;
} diary;

static bool note(void *self, size_t done, size_t all)
{
    diary *d = self;
    (void)done, (void)all;
    if (d->size < sizeof d->at / sizeof *d->at)
        d->at[d->size++] = d->running;
    return true;
}

/* The passes of the clock, as the diary has them: one that does not count, in which the first way
 * begins, and then by turns. */
Test(study, the_clock_takes_turns)
{
    enum { ITEMS = 3, WAYS = 2, BEFORE = 1 + ITEMS * WAYS };
    static const size_t BEGINS[] = {0, 1, 0};
    study_grid g = small_grid(1);
    diary d = {0};
    g.per_class = ITEMS;
    g.ways = WAYS;
    g.passes = 2;
    g.step = note;
    g.self = &d;
    g.running = &d.running;
    must(study_grid_run(&g));
    cr_assert_eq(d.size, BEFORE + 3 * WAYS * ITEMS);
    fmb_solver *way[WAYS] = {d.at[BEFORE], d.at[BEFORE + ITEMS]};
    cr_expect_neq(way[0], way[1]);
    for (size_t k = 0; k < 3 * WAYS * ITEMS; k++) {
        size_t pass = k / (WAYS * ITEMS), place = k / ITEMS % WAYS;
        cr_expect_eq(d.at[BEFORE + k], way[(BEGINS[pass] + place) % WAYS]);
    }
    study_grid_clear(&g);
}

/* FMplex decides the same systems; of its rows there is nothing to count. */
Test(study, fmplex)
{
    for (int meets = 0; meets < 2; meets++) {
        study_way pair[] = {{.rules = "none"}, {.rules = "fmplex"}};
        study_grid g = small_grid(meets);
        study_digest d;
        g.way = pair;
        g.ways = 2;
        must(study_grid_run(&g));
        for (size_t i = 0; i < 5; i++) {
            const study_run *run = study_grid_at(&g, 0, i, 1);
            cr_expect(run->outcome == STUDY_REFUSED && run->solved == STUDY_DECIDED);
        }
        must(study_digest_make(&g, 1, 0, everything, NULL, &d));
        cr_expect(d.refused == 5 && d.wrong == 0 && d.timed == 5);
        study_grid_clear(&g);
    }
}

/* A system with a lie about its answer. */
static void put_lie(study_sample *sample, fmb_verdict truth, const char *projection)
{
    const int64_t row[] = {1, 1};
    fmb_system *s = NULL;
    int *keep = malloc(sizeof *keep);
    *keep = 1;
    must(fmb_system_new(2, NULL, &s));
    must(fmb_system_add_int(s, row, FMB_LE, 1));
    must(study_sample_put(sample, s, keep, 1));
    sample->item[sample->size - 1].truth = truth;
    sample->item[sample->size - 1].projection = projection ? strdup(projection) : NULL;
}

Test(study, wrong_answers_are_found)
{
    study_grid g = {.way = ways, .ways = 1, .passes = 1};
    study_sample sample = {.file = "lies"};
    study_digest d;
    g.limits = (study_limits){.max_rows = 100, .presolve = "none"};
    put_lie(&sample, FMB_UNKNOWN, NULL);
    put_lie(&sample, FMB_INFEASIBLE, NULL);
    put_lie(&sample, FMB_FEASIBLE, "0 attained 1 attained ");
    must(study_grid_add(&g, &sample));
    must(study_grid_run(&g));
    cr_expect_eq(study_grid_at(&g, 0, 0, 0)->outcome, STUDY_DECIDED);
    cr_expect_eq(study_grid_at(&g, 0, 1, 0)->outcome, STUDY_WRONG);
    cr_expect_eq(study_grid_at(&g, 0, 1, 0)->solved, STUDY_WRONG);
    cr_expect_eq(study_grid_at(&g, 0, 2, 0)->outcome, STUDY_WRONG);
    must(study_digest_make(&g, 0, 0, everything, NULL, &d));
    cr_expect(d.systems == 3 && d.wrong == 2);
    study_grid_clear(&g);
}

/* Projections on two variables: equal ones share their words, others do not. */
Test(study, words_of_projections)
{
    static const int64_t row[][3] = {{2, 0, 0}, {-1, 0, 0}, {0, 3, 0}, {0, -1, 0}};
    const int keep[] = {0, 1};
    char *words[3] = {NULL, NULL, NULL};
    study_reference j;
    must(study_reference_open(&j, 0));
    for (int k = 0; k < 3; k++) {
        fmb_system *s = NULL;
        must(fmb_system_new(3, NULL, &s));
        for (int i = 0; i < 4; i++)
            must(fmb_system_add_int(s, row[k == 1 ? 3 - i : i], FMB_LE, k == 2 ? 6 : 3));
        must(study_reference_projection(&j, s, keep, 2, &words[k]));
        fmb_system_free(s);
    }
    cr_expect_str_eq(words[0], words[1]);
    cr_expect_str_neq(words[0], words[2]);
    cr_expect_eq(j.rejected, 0);
    for (int k = 0; k < 3; k++)
        free(words[k]);
    study_reference_close(&j);
}

static bool never(void *self, size_t done, size_t steps)
{
    (void)done;
    (void)steps;
    return --*(int *)self > 0;
}

/* Ended at any step, what is complete is told apart from the rest, and nothing leaks. */
Test(study, ended_early)
{
    for (int steps = 1; steps < 60; steps += 3) {
        study_grid g = small_grid(true);
        study_sample more = {.class = PLAIN};
        int left = steps;
        must(study_grid_add(&g, &more));
        g.step = never;
        g.self = &left;
        must(study_grid_run(&g));
        cr_expect(g.complete <= g.prepared && g.prepared <= g.samples);
        cr_expect(g.complete == 2 || left <= 0);
        study_grid_clear(&g);
    }
}

/* ---- statistics by hand ---------------------------------------------------------------------- */

/* Four systems; the base takes 1, 2, 4 s and gives up after 8 s. */
Test(study, digest)
{
    study_run run[8] = {0};
    bool known[2] = {true, true};
    study_case items[4] = {{0}};
    study_sample sample = {.file = "by hand", .item = items, .size = 4};
    study_grid g = {.way = ways,
                    .ways = 2,
                    .sample = &sample,
                    .samples = 1,
                    .complete = 1,
                    .most = 4,
                    .run = run,
                    .known = known};
    const double base[] = {1, 2, 4, 8}, mine[] = {0.5, 0.5, 8, 4};
    for (size_t i = 0; i < 4; i++) {
        study_outcome plain = i < 3 ? STUDY_DECIDED : STUDY_STOPPED;
        run[2 * i] = (study_run){
            .outcome = plain, .solved = plain, .seconds = base[i], .kept = 10, .lived = 20};
        run[2 * i + 1] = (study_run){.outcome = STUDY_DECIDED,
                                     .solved = STUDY_DECIDED,
                                     .seconds = mine[i],
                                     .kept = i + 1,
                                     .lived = 5};
    }
    study_digest d;
    must(study_digest_make(&g, 1, 0, everything, NULL, &d));
    cr_expect(d.systems == 4 && d.decided == 4 && d.both == 3 && d.only == 1);
    cr_expect_float_eq(d.kept, 2.5, 1e-12);
    cr_expect_float_eq(d.kept_ratio, 6.0 / 30, 1e-12);
    cr_expect_float_eq(d.lived_ratio, 0.25, 1e-12);
    cr_expect(d.timed == 4 && d.base_gave_up == 1 && d.gave_up == 0);
    cr_expect_float_eq(d.total.ratio, 13.0 / 15, 1e-12);
    cr_expect_float_eq(d.median.ratio, 0.5, 1e-12); /* of 1/4, 1/2, 1/2, 2 */
    cr_expect_float_eq(d.chance, 5.0 / 16, 1e-12);  /* 3 or 4 gains of 4 */
    must(study_digest_make(&g, 0, 1, everything, NULL, &d));
    cr_expect(d.stopped == 1 && d.gave_up == 1 && d.base_gave_up == 0 && d.only == 0);
    cr_expect_float_eq(d.chance, 15.0 / 16, 1e-12); /* it gains once; giving up is a loss */
}
