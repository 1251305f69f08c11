/* packed.c: verdicts on frames in sets (<fmb/frames.h>): is elimination as fast as separating axes
 * where no pointer is followed, how fast are frames with fewer axes, and do threads help?
 *
 * Pairs by index: frame i of one set and frame i of another, 65,536 distinct pairs of the article's
 * generator of one verdict. With --large, half a million pairs of frames drawn at random from sets
 * of as many, far larger than caches. All against all: 256 frames and 256 others. Ways take turns;
 * times are this thread's CPU time, medians over the passes, the least in brackets. In four to
 * eight dimensions fewer frames: those of which about half meet (axes are longer), the article's,
 * of which a few do, some of which none do, and some with parallel edges; the ratio is to two
 * cuboids in space, taken in turns with them. Then pairs that touch, and those of small whole
 * numbers. See README.md.
 */
#include <string.h>

#include <fmb/frames.h>

#include "base/clock.h"
#include "cells.h"
#include "machine.h"
#include "study/clock/clock.h"
#include "study/draw/draft.h"
#include "study/sat/sat.h"

enum { PAIRS = 65536, LARGE = 8 * PAIRS, SIDE = 256, PASSES = 15 };

/* ---- ways ------------------------------------------------------------------------------------ */

typedef struct way {
    fmb_pair *k;
    const fmb_frames *a, *b;
    const fmb_frames_pair *pair;
    fmb_verdict *verdict;
    size_t meeting; /* all against all */
} way;

static fmb_status ask_pairs(void *self, size_t first, size_t n)
{
    way *w = self;
    return fmb_frames_test(
        w->k, w->a, w->b, n, w->pair + first,
        &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = w->verdict + first});
}

static bool count_pairs_told(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair)
{
    way *w = self;
    (void)pair;
    w->meeting += verdict == FMB_FEASIBLE ? n : 0;
    return true;
}

static fmb_status ask_all(void *self, size_t first, size_t n)
{
    way *w = self;
    (void)first;
    (void)n;
    w->meeting = 0;
    return fmb_frames_meet(w->k, w->a, w->b, count_pairs_told, w);
}

/* ---- duels ----------------------------------------------------------------------------------- */

typedef struct duel {
    way w[2]; /* elimination, separating axes */
    size_t queries;
    study_clock clock;
} duel;

static void run_duel(duel *d, fmb_status (*run)(void *, size_t, size_t), int ways)
{
    study_timed timed[2];
    for (int i = 0; i < ways; i++)
        timed[i] = (study_timed){run, &d->w[i]};
    d->clock = (study_clock){
        .way = timed, .ways = (size_t)ways, .queries = d->queries, .groups = 1, .passes = PASSES};
    must(study_clock_run(&d->clock));
    d->clock.way = NULL;
}

static void print_duel(const char *what, const study_pair_plan *plan, duel *d)
{
    study_spread fmb = study_clock_ns(&d->clock, 0), sat = study_clock_ns(&d->clock, 1);
    printf("%s %-5s  %6.2f [%5.2f]  %6.2f [%5.2f]  %6.3f\n", cell_text(plan), what, fmb.median,
           fmb.least, sat.median, sat.least, study_clock_ratio(&d->clock, 0, 1).ratio);
    study_clock_clear(&d->clock);
}

static void open_duel(const study_pair_plan *plan, fmb_simd simd, duel *d)
{
    static fmb_frames_pair pair[PAIRS];
    static fmb_verdict verdict[2][PAIRS];
    fmb_pair_options o = {.size = sizeof o};
    o.simd = simd;
    for (uint32_t i = 0; i < PAIRS; i++)
        pair[i] = (fmb_frames_pair){i, i};
    d->queries = PAIRS;
    for (int i = 0; i < 2; i++)
        d->w[i] = (way){.pair = pair, .verdict = verdict[i]};
    must(fmb_pair_new(plan->dim, &o, NULL, &d->w[0].k));
    must(study_sat_new(plan->dim, &o, &d->w[1].k));
}

static void set_frames(duel *d, const fmb_frames *a, const fmb_frames *b)
{
    for (int i = 0; i < 2; i++) {
        d->w[i].a = a;
        d->w[i].b = b;
    }
}

static void measure_pairs(const study_pair_plan *plan, fmb_simd simd, fmb_verdict verdict)
{
    duel d;
    fmb_frames *a = NULL, *b = NULL;
    open_duel(plan, simd, &d);
    study_pairs pairs = cell_pairs(plan, PAIRS, d.w[0].k, verdict);
    must(fmb_frames_new(plan->dim, PAIRS, pairs.p, NULL, &a));
    must(fmb_frames_new(plan->dim, PAIRS, pairs.q, NULL, &b));
    set_frames(&d, a, b);
    run_duel(&d, ask_pairs, 2);
    print_duel(verdict == FMB_FEASIBLE ? "meet" : "apart", plan, &d);
    if (memcmp(d.w[0].verdict, d.w[1].verdict, PAIRS * sizeof(fmb_verdict)) != 0)
        printf("the two differ\n");
    study_pairs_free(&pairs);
    fmb_frames_free(a);
    fmb_frames_free(b);
    fmb_pair_free(d.w[0].k);
    fmb_pair_free(d.w[1].k);
}

/* Pairs as drawn, of sets that no cache holds, in no order. */
static void measure_large(const study_pair_plan *plan, fmb_simd simd)
{
    static fmb_frames_pair pair[LARGE];
    static fmb_verdict verdict[2][LARGE];
    duel d;
    study_pairs pairs;
    uint64_t state;
    fmb_frames *a = NULL, *b = NULL;
    open_duel(plan, simd, &d);
    d.queries = LARGE;
    must(study_pairs_make(plan, 7, LARGE, NULL, NULL, &pairs));
    must(fmb_frames_new(plan->dim, LARGE, pairs.p, NULL, &a));
    must(fmb_frames_new(plan->dim, LARGE, pairs.q, NULL, &b));
    study_pairs_free(&pairs);
    study_splitmix.set(&state, 8);
    for (size_t i = 0; i < LARGE; i++)
        pair[i] = (fmb_frames_pair){(uint32_t)(LARGE * study_splitmix.get_double(&state)),
                                    (uint32_t)(LARGE * study_splitmix.get_double(&state))};
    for (int i = 0; i < 2; i++) {
        d.w[i].pair = pair;
        d.w[i].verdict = verdict[i];
    }
    set_frames(&d, a, b);
    run_duel(&d, ask_pairs, 2);
    print_duel("large", plan, &d);
    if (memcmp(verdict[0], verdict[1], sizeof verdict[0]) != 0)
        printf("the two differ\n");
    fmb_frames_free(a);
    fmb_frames_free(b);
    fmb_pair_free(d.w[0].k);
    fmb_pair_free(d.w[1].k);
}

/* Two sets of SIDE frames of a plan, with so many axes (0: all). */
static void make_sides(const study_pair_plan *plan, const int naxes[2], fmb_frames **a,
                       fmb_frames **b)
{
    study_pairs pairs;
    must(study_pairs_make(plan, 2, SIDE, NULL, NULL, &pairs));
    for (int i = 0; i < SIDE; i++) {
        pairs.p[i].naxes = naxes[0] > 0 ? naxes[0] : plan->dim;
        pairs.q[i].naxes = naxes[1] > 0 ? naxes[1] : plan->dim;
    }
    must(fmb_frames_new(plan->dim, SIDE, pairs.p, NULL, a));
    must(fmb_frames_new(plan->dim, SIDE, pairs.q, NULL, b));
    study_pairs_free(&pairs);
}

static void measure_all(const study_pair_plan *plan, fmb_simd simd)
{
    const int all[2] = {0, 0};
    duel d;
    fmb_frames *a = NULL, *b = NULL;
    open_duel(plan, simd, &d);
    make_sides(plan, all, &a, &b);
    set_frames(&d, a, b);
    run_duel(&d, ask_all, 2);
    print_duel("all", plan, &d);
    if (d.w[0].meeting != d.w[1].meeting)
        printf("the two differ\n");
    fmb_frames_free(a);
    fmb_frames_free(b);
    fmb_pair_free(d.w[0].k);
    fmb_pair_free(d.w[1].k);
}

/* ---- depths ---------------------------------------------------------------------------------- */

static fmb_status ask_contacts(void *self, size_t first, size_t n)
{
    static double depth[PAIRS], normal[3 * PAIRS];
    way *w = self;
    fmb_pair_answers out = {.size = sizeof out, .verdict = w->verdict + first};
    out.depth = depth + first;
    out.normal = normal + 3 * first;
    return fmb_frames_test(w->k, w->a, w->b, n, w->pair + first, &out);
}

/* Depth and normal against the verdict alone, on pairs as drawn. */
static void measure_contacts(const study_pair_plan *plan, fmb_simd simd)
{
    duel d;
    study_pairs pairs;
    fmb_frames *a = NULL, *b = NULL;
    fmb_pair_counts counts = {.size = sizeof counts};
    size_t meet = 0;
    open_duel(plan, simd, &d);
    must(study_pairs_make(plan, 5, PAIRS, NULL, NULL, &pairs));
    must(fmb_frames_new(plan->dim, PAIRS, pairs.p, NULL, &a));
    must(fmb_frames_new(plan->dim, PAIRS, pairs.q, NULL, &b));
    set_frames(&d, a, b);
    fmb_pair_free(d.w[1].k);
    must(fmb_pair_new(plan->dim,
                      &(fmb_pair_options){.size = sizeof(fmb_pair_options), .simd = simd}, NULL,
                      &d.w[1].k));
    study_timed timed[2] = {{ask_contacts, &d.w[0]}, {ask_pairs, &d.w[1]}};
    d.clock =
        (study_clock){.way = timed, .ways = 2, .queries = PAIRS, .groups = 1, .passes = PASSES};
    must(study_clock_run(&d.clock));
    d.clock.way = NULL;
    must(fmb_pair_count(d.w[0].k, &counts));
    for (int i = 0; i < PAIRS; i++)
        meet += d.w[0].verdict[i] == FMB_FEASIBLE;
    print_duel("depth", plan, &d);
    printf("    %.1f %% meet, exact: %.3f %% of asked\n", 100.0 * (double)meet / PAIRS,
           100.0 * (double)counts.exact_boxes / (double)counts.pairs);
    study_pairs_free(&pairs);
    fmb_frames_free(a);
    fmb_frames_free(b);
    fmb_pair_free(d.w[0].k);
    fmb_pair_free(d.w[1].k);
}

/* ---- fewer axes ------------------------------------------------------------------------------ */

static void measure_flat(const char *what, const int naxes[2], bool moves, fmb_simd simd)
{
    const study_pair_plan plan = {
        .family = STUDY_PAIR_ARTICLE, .dim = 3, .moves = moves, .shape = {1, 1}};
    duel d;
    fmb_frames *a = NULL, *b = NULL;
    open_duel(&plan, simd, &d);
    make_sides(&plan, naxes, &a, &b);
    set_frames(&d, a, b);
    run_duel(&d, ask_all, 1);
    fmb_pair_counts counts = {.size = sizeof counts};
    must(fmb_pair_count(d.w[0].k, &counts));
    study_spread ns = study_clock_ns(&d.clock, 0);
    printf("%-24s %-6s  %6.2f [%5.2f]  %5.1f %% meet, %llu exact\n", what,
           moves ? "moving" : "still", ns.median, ns.least, 100.0 * (double)d.w[0].meeting / PAIRS,
           (unsigned long long)counts.exact_verdicts);
    study_clock_clear(&d.clock);
    fmb_frames_free(a);
    fmb_frames_free(b);
    fmb_pair_free(d.w[0].k);
    fmb_pair_free(d.w[1].k);
}

/* ---- more dimensions ------------------------------------------------------------------------- */

enum { MOST_NUMBERS = 8 * (8 + 2) };

typedef struct many_cell {
    const char *what;
    int dim;
    bool moves;
    double far;   /* bound of origins over the bound of axes */
    bool aligned; /* axis-aligned frames */
    fmb_shape shape[2];
} many_cell;

static fmb_frame some_frame(const many_cell *c, fmb_shape shape, uint64_t *state, double *number)
{
    const int dim = c->dim, axes = dim * dim;
    for (int j = 0; j < dim * (dim + 2); j++)
        number[j] = 2 * study_splitmix.get_double(state) - 1;
    for (int j = 0; j < dim; j++)
        number[j] *= c->far;
    for (int j = 0; c->aligned && j < axes; j++)
        number[dim + j] *= j % dim == j / dim;
    for (int j = 0; shape == FMB_SIMPLEX && j < axes; j++) /* the middle is where it was */
        number[j % dim] -= number[dim + j] / (dim + 1);
    return (fmb_frame){.shape = shape,
                       .dim = dim,
                       .naxes = dim,
                       .origin = number,
                       .axes = number + dim,
                       .speed = c->moves ? number + dim + axes : NULL};
}

static fmb_frames *some_frames(const many_cell *c, int side, size_t n, uint64_t *state)
{
    static double number[SIDE][MOST_NUMBERS];
    fmb_frame f[SIDE];
    fmb_frames *out = NULL;
    for (size_t i = 0; i < n; i++)
        f[i] = some_frame(c, c->shape[side], state, number[i]);
    must(fmb_frames_new(c->dim, n, f, NULL, &out));
    return out;
}

static const char *text_of_shapes(const fmb_shape shape[2])
{
    return shape[0] != shape[1] ? "mixed" : shape[0] == FMB_SIMPLEX ? "simplices" : "cuboids";
}

/* All against all, n frames each; relative to as many frames in space. */
static void measure_many(const many_cell *c, fmb_simd simd)
{
    const many_cell space = {.dim = 3, .far = 0.75};
    const many_cell *cell[2] = {c, &space};
    const size_t n = c->dim < 6 ? SIDE : 64;
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair_counts counts = {.size = sizeof counts};
    fmb_frames *set[2][2];
    way w[2];
    uint64_t state;
    o.simd = simd;
    study_splitmix.set(&state, 4);
    for (int i = 0; i < 2; i++) {
        w[i] = (way){.pair = NULL};
        must(fmb_pair_new(cell[i]->dim, &o, NULL, &w[i].k));
        w[i].a = set[i][0] = some_frames(cell[i], 0, n, &state);
        w[i].b = set[i][1] = some_frames(cell[i], 1, n, &state);
    }
    study_timed timed[2] = {{ask_all, &w[0]}, {ask_all, &w[1]}};
    study_clock clock = {.way = timed, .ways = 2, .queries = n * n, .groups = 1, .passes = PASSES};
    must(study_clock_run(&clock));
    must(fmb_pair_count(w[0].k, &counts));
    study_spread ns = study_clock_ns(&clock, 0);
    printf("%dD %-9s %-6s %-8s  %8.1f [%8.1f]  %8.2f  %5.1f %% meet, %5.2f %% exact\n", c->dim,
           text_of_shapes(c->shape), c->moves ? "moving" : "still", c->what, ns.median, ns.least,
           study_clock_ratio(&clock, 0, 1).ratio, 100.0 * (double)w[0].meeting / (double)(n * n),
           100.0 * (double)counts.exact_verdicts / (double)counts.pairs);
    study_clock_clear(&clock);
    for (int i = 0; i < 2; i++) {
        fmb_frames_free(set[i][0]);
        fmb_frames_free(set[i][1]);
        fmb_pair_free(w[i].k);
    }
}

/* `far` for which half of the pairs meet: cuboids, one of each, simplices, from 4D on. */
static const double HALF[3][5] = {
    {0.35, 0.3, 0.2, 0.15, 0.1}, {0.4, 0.35, 0.27}, {0.45, 0.4, 0.35}};

static void measure_kinds(int dim, int simplices, bool moves, fmb_simd simd)
{
    const fmb_shape shape[2] = {simplices == 2, simplices > 0};
    many_cell cell[4] = {{"half", dim, moves, HALF[simplices][dim - 4], false, {0}},
                         {"few", dim, moves, 1, false, {0}},
                         {"apart", dim, moves, 8, false, {0}},
                         {"parallel", dim, moves, HALF[simplices][dim - 4], true, {0}}};
    for (int i = 0; i < (simplices ? 3 : 4); i++) {
        memcpy(cell[i].shape, shape, sizeof shape);
        measure_many(&cell[i], simd);
    }
}

/* Pairs that doubles cannot decide, by index. */
static void measure_family(study_pair_family family, int dim, int simplices, fmb_simd simd)
{
    enum { SOME = 4096 };
    const study_pair_plan plan = {
        .family = family, .dim = dim, .shape = {simplices == 2, simplices > 0}};
    duel d;
    study_pairs pairs;
    fmb_frames *a = NULL, *b = NULL;
    fmb_pair_counts counts = {.size = sizeof counts};
    open_duel(&plan, simd, &d);
    must(study_pairs_make(&plan, 6, SOME, NULL, NULL, &pairs));
    must(fmb_frames_new(dim, SOME, pairs.p, NULL, &a));
    must(fmb_frames_new(dim, SOME, pairs.q, NULL, &b));
    set_frames(&d, a, b);
    study_timed timed = {ask_pairs, &d.w[0]};
    study_clock clock = {.way = &timed, .ways = 1, .queries = SOME, .groups = 1, .passes = PASSES};
    must(study_clock_run(&clock));
    must(fmb_pair_count(d.w[0].k, &counts));
    study_spread ns = study_clock_ns(&clock, 0);
    printf("%dD %-9s %-15s  %8.1f [%8.1f]  %5.2f %% exact\n", dim,
           text_of_shapes((const fmb_shape[2]){simplices == 2, simplices > 0}),
           study_pair_family_text(family), ns.median, ns.least,
           100.0 * (double)counts.exact_verdicts / (double)counts.pairs);
    study_clock_clear(&clock);
    study_pairs_free(&pairs);
    fmb_frames_free(a);
    fmb_frames_free(b);
    fmb_pair_free(d.w[0].k);
    fmb_pair_free(d.w[1].k);
}

static void measure_more_dimensions(fmb_simd simd)
{
    printf("four and more dimensions, ns [least], ratio to space\n");
    for (int simplices = 0; simplices < 3; simplices++)
        for (int dim = 4; dim <= (simplices ? 6 : 8); dim++)
            for (int moves = 0; moves < 2 && dim + moves <= (simplices == 1 ? 6 : 8); moves++)
                measure_kinds(dim, simplices, moves, simd);
    for (int dim = 4; dim <= 6; dim++)
        for (int simplices = 0; simplices < 3; simplices++)
            for (int i = 0; i < 2; i++)
                measure_family(i ? STUDY_PAIR_LATTICE : STUDY_PAIR_TOUCHING, dim, simplices, simd);
}

/* ---- threads --------------------------------------------------------------------------------- */

/* The least wall-clock time of PASSES passes. */
static double measure_threads(size_t threads)
{
    const study_pair_plan plan = {.family = STUDY_PAIR_ARTICLE, .dim = 3};
    fmb_pair_options o = {.size = sizeof o};
    way w = {.k = NULL};
    study_pairs pairs;
    fmb_frames *set = NULL;
    double least = 1e9;
    o.threads = threads;
    must(study_pairs_make(&plan, 3, 2048, NULL, NULL, &pairs));
    must(fmb_frames_new(3, 2048, pairs.p, NULL, &set));
    must(fmb_pair_new(3, &o, NULL, &w.k));
    w.a = w.b = set;
    for (int i = 0; i < PASSES; i++) {
        double start = fmb_monotonic_seconds();
        must(ask_all(&w, 0, 0));
        double took = fmb_monotonic_seconds() - start;
        least = took < least ? took : least;
    }
    study_pairs_free(&pairs);
    fmb_frames_free(set);
    fmb_pair_free(w.k);
    return least;
}

/* ---- the program ----------------------------------------------------------------------------- */

int main(int argc, char **argv)
{
    static const struct {
        const char *what;
        int naxes[2];
    } flat[] = {{"two triangles", {2, 2}},
                {"segment, triangle", {1, 2}},
                {"triangle, tetrahedron", {2, 3}},
                {"segment, tetrahedron", {1, 3}},
                {"two segments", {1, 1}}};
    fmb_simd simd = FMB_SIMD_AUTO;
    bool many = false, large = false;
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--many") == 0) {
            many = true;
        } else if (strcmp(argv[i], "--large") == 0) {
            large = true;
        } else if (!parse_simd(argv[i], &simd)) {
            fprintf(stderr, "usage: bench-packed [--simd=plain|avx2|avx512] [--many | --large]\n");
            return 64;
        }
    printf("{");
    print_machine_json(stdout);
    printf("}\n");
    if (many) {
        measure_more_dimensions(simd);
        return 0;
    }
    printf("%-20s  %14s  %14s  %6s\n", "ns [least]", "fmb", "sat", "ratio");
    for (int i = 0; large && i < CELLS; i++) {
        study_pair_plan plan = cell_plan(i);
        measure_large(&plan, simd);
    }
    if (large)
        return 0;
    for (int i = 0; i < 3 * CELLS; i++) {
        study_pair_plan plan = cell_plan(i / 3);
        if (i % 3 < 2)
            measure_pairs(&plan, simd, i % 3 ? FMB_INFEASIBLE : FMB_FEASIBLE);
        else
            measure_all(&plan, simd);
    }
    printf("%-20s  %14s  %14s  %6s\n", "ns [least]", "depth, normal", "verdict", "ratio");
    for (int i = 0; i < CELLS; i++) {
        study_pair_plan plan = cell_plan(i);
        measure_contacts(&plan, simd);
    }
    for (int i = 0; i < 10; i++)
        measure_flat(flat[i / 2].what, flat[i / 2].naxes, i % 2, simd);
    measure_more_dimensions(simd);
    double one = measure_threads(1), two = measure_threads(2);
    printf("two threads: %.2f times as fast\n", one / two);
    return 0;
}
