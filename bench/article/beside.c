/* beside.c: the article's program beside our reimplementation (study/rivals): the same pairs, the
 * same repetitions, in turns, processor time. Built by `beside` against a checkout of the original,
 * of which this file has no line. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmb2d.h"
#include "fmb2dt.h"
#include "fmb3d.h"
#include "fmb3dt.h"
#include "sat.h"

#include "study/clock/clock.h"
#include "study/draw/pairs.h"
#include "study/rivals/article.h"
#include "study/rivals/sat_plain.h"

enum {
    PAIRS = 3072, /* too many for the branch predictor to learn */
    REPEATED_PAIRS = 96,
    MOST_REPEATS = 1500,
    ROUNDS = 3, /* over all cells, of each process, */
    PASSES = 3, /* so many of a cell in each */
    WAYS = 4,
    KINDS = 4,
    CELLS = 8 * KINDS
};

typedef enum program { ORIGINAL, OURS } program;
typedef enum test { FMB, SAT } test;

/* The pairs of a cell, in the format of each program; and the answers to the last one. */
static union {
    Frame2D still_2[2][PAIRS];
    Frame3D still_3[2][PAIRS];
    Frame2DTime moving_2[2][PAIRS];
    Frame3DTime moving_3[2][PAIRS];
} theirs;
static study_pairs ours;
static study_sat_record records[2][PAIRS];
static study_article *work;
static study_sat_records_meet *our_sat;
static bool met[PAIRS];

/* ---- the ways -------------------------------------------------------------------------------- */

#define LOOP(name, call)                                                                           \
    static void name(size_t first, size_t n, int repeats)                                          \
    {                                                                                              \
        for (size_t i = first; i < first + n; i++)                                                 \
            for (int r = 0; r < repeats; r++)                                                      \
                met[i] = call;                                                                     \
    }
#define ORIGINALS(frames, fmb, sat)                                                                \
    LOOP(frames##_fmb, fmb(&theirs.frames[0][i], &theirs.frames[1][i], NULL))                      \
    LOOP(frames##_sat, sat(&theirs.frames[0][i], &theirs.frames[1][i]))
ORIGINALS(still_2, FMBTestIntersection2D, SATTestIntersection2D)
ORIGINALS(still_3, FMBTestIntersection3D, SATTestIntersection3D)
ORIGINALS(moving_2, FMBTestIntersection2DTime, SATTestIntersection2DTime)
ORIGINALS(moving_3, FMBTestIntersection3DTime, SATTestIntersection3DTime)

static bool our_fmb(size_t i)
{
    fmb_verdict verdict;
    study_article_test(work, &ours.p[i], &ours.q[i], STUDY_ARTICLE_PUBLISHED, NULL, &verdict);
    return verdict == FMB_FEASIBLE;
}
LOOP(ours_fmb, our_fmb(i))
LOOP(ours_sat, our_sat(&records[0][i], &records[1][i]))

typedef void way(size_t first, size_t n, int repeats);
static way *const ORIGINAL_WAY[2][2][2] = {
    {{still_2_fmb, still_2_sat}, {moving_2_fmb, moving_2_sat}},
    {{still_3_fmb, still_3_sat}, {moving_3_fmb, moving_3_sat}}};
static way *const OUR_WAY[2] = {ours_fmb, ours_sat};

/* ---- the pairs ------------------------------------------------------------------------------- */

typedef struct cell {
    int dim, shape[2];
    bool moves, meets;
} cell;

#define STILL(to, make, d)                                                                         \
    do {                                                                                           \
        double o[d], a[d][d];                                                                      \
        memcpy(o, f->origin, sizeof o);                                                            \
        memcpy(a, f->axes, sizeof a);                                                              \
        to = make(type, o, (const double(*)[d])a);                                                 \
    } while (0)
#define MOVING(to, make, d)                                                                        \
    do {                                                                                           \
        double o[d], a[d][d], v[d];                                                                \
        memcpy(o, f->origin, sizeof o);                                                            \
        memcpy(a, f->axes, sizeof a);                                                              \
        memcpy(v, f->speed, sizeof v);                                                             \
        to = make(type, o, v, (const double(*)[d])a);                                              \
    } while (0)

static void put_theirs(const cell *c, int side, size_t i, const fmb_frame *f)
{
    FrameType type = f->shape == FMB_CUBOID ? FrameCuboid : FrameTetrahedron;
    if (!c->moves && c->dim == 2)
        STILL(theirs.still_2[side][i], Frame2DCreateStatic, 2);
    else if (!c->moves)
        STILL(theirs.still_3[side][i], Frame3DCreateStatic, 3);
    else if (c->dim == 2)
        MOVING(theirs.moving_2[side][i], Frame2DTimeCreateStatic, 2);
    else
        MOVING(theirs.moving_3[side][i], Frame3DTimeCreateStatic, 3);
}

static bool is_of_cell(void *self, const fmb_frame *p, const fmb_frame *q)
{
    return study_sat_plain(p, q) == ((const cell *)self)->meets;
}

/* The number of pairs on which the programs differ. */
static size_t count_different(const cell *c)
{
    size_t different = 0;
    for (size_t i = 0; i < PAIRS; i++) {
        bool said[WAYS];
        for (int w = 0; w < WAYS; w++) {
            (w < 2 ? ORIGINAL_WAY[c->dim - 2][c->moves][w] : OUR_WAY[w - 2])(i, 1, 1);
            said[w] = met[i];
        }
        different += said[0] != said[2] || said[1] != said[3];
    }
    return different;
}

/* The first pairs of the article's generator in this cell, in the format of each program. */
static bool draw_cell(cell *c, uint64_t seed)
{
    study_pair_plan plan = {.family = STUDY_PAIR_ARTICLE, .dim = c->dim, .moves = c->moves};
    memcpy(plan.shape, c->shape, sizeof plan.shape);
    study_pairs_free(&ours);
    if (study_pairs_make(&plan, seed, PAIRS, is_of_cell, c, &ours) != FMB_OK)
        return false;
    for (size_t i = 0; i < PAIRS; i++) {
        study_sat_record_make(&ours.p[i], &records[0][i]);
        study_sat_record_make(&ours.q[i], &records[1][i]);
        put_theirs(c, 0, i, &ours.p[i]);
        put_theirs(c, 1, i, &ours.q[i]);
    }
    return true;
}

/* ---- measuring ------------------------------------------------------------------------------- */

/* The least times of a query [ns], of each of the four ways. Disturbances last for seconds and
 * affect programs differently: while the sibling hyperthread is busy, 15 ns of the original become
 * 21, and ours, with more instructions, a fifth more than that. So the rounds over all cells look
 * for a time at which each has the processor to itself. Others last for a process: depending on the
 * places of its stack and pages, the original took 32 ns in one of ten. */
typedef struct cell_times {
    double distinct[WAYS], repeated[WAYS][REPEATED_PAIRS];
    size_t different; /* answers */
} cell_times;

static void note_least(double *least, double seconds, double queries)
{
    *least = fmin(*least, 1e9 * seconds / queries);
}

/* So many repeats that reading the clock costs little in comparison. */
static int choose_repeats(double ns)
{
    double n = 5e4 / ns;
    return n < 1 ? 1 : n < MOST_REPEATS ? (int)n : MOST_REPEATS;
}

/* One round: distinct pairs, and each pair again and again, as in the article. */
static void measure(const cell *c, cell_times *t)
{
    way *run[WAYS] = {ORIGINAL_WAY[c->dim - 2][c->moves][FMB],
                      ORIGINAL_WAY[c->dim - 2][c->moves][SAT], OUR_WAY[FMB], OUR_WAY[SAT]};
    for (int pass = -1; pass < PASSES; pass++)
        for (int w = 0; w < WAYS; w++) {
            double then = study_thread_seconds();
            run[w](0, PAIRS, 1);
            if (pass >= 0)
                note_least(&t->distinct[w], study_thread_seconds() - then, PAIRS);
        }
    int repeats = choose_repeats(t->distinct[0] + t->distinct[1]);
    for (int pass = 0; pass < PASSES; pass++)
        for (size_t i = 0; i < REPEATED_PAIRS; i++)
            for (int w = 0; w < WAYS; w++) {
                double then = study_thread_seconds();
                run[w](i, 1, repeats);
                note_least(&t->repeated[w][i], study_thread_seconds() - then, repeats);
            }
}

static double mean_of_pairs(const double *x)
{
    double sum = 0;
    for (size_t i = 0; i < REPEATED_PAIRS; i++)
        sum += x[i] / REPEATED_PAIRS;
    return sum;
}

/* Is our reimplementation close enough to the program? */
static bool is_near(double ratio)
{
    return fabs(ratio - 1) <= 0.15;
}

static cell cell_of_number(int i)
{
    cell c = {.dim = 2 + i / (2 * KINDS) % 2, .moves = i / (4 * KINDS), .meets = i % 2 == 0};
    c.shape[0] = i / 2 % KINDS < 2 ? FMB_CUBOID : FMB_SIMPLEX;
    c.shape[1] = i / 2 % 2 == 0 ? FMB_CUBOID : FMB_SIMPLEX;
    return c;
}

static bool measure_all(uint64_t seed, cell_times *times)
{
    for (int i = 0; i < CELLS; i++) {
        cell c = cell_of_number(i);
        our_sat = study_sat_program(c.dim, c.moves);
        if (!draw_cell(&c, seed))
            return false;
        times[i].different = count_different(&c);
        measure(&c, &times[i]);
    }
    return true;
}

static bool report(const cell *c, const cell_times *t)
{
    static const char *const LETTER[] = {[FMB_CUBOID] = "C", [FMB_SIMPLEX] = "T"};
    const double *d = t->distinct;
    double r[WAYS];
    for (int w = 0; w < WAYS; w++)
        r[w] = mean_of_pairs(t->repeated[w]);
    bool good = is_near(r[2] / r[0]) && is_near(r[3] / r[1]) && is_near(d[2] / d[0]) &&
                is_near(d[3] / d[1]);
    printf("%d %-6s %s%s %-5s %7.1f %7.1f %6.2f %6.2f %9.1f %7.1f %6.2f %6.2f %8.2f %6.2f %3zu%s\n",
           c->dim, c->moves ? "moving" : "still", LETTER[c->shape[0]], LETTER[c->shape[1]],
           c->meets ? "meet" : "apart", r[0], r[1], r[2] / r[0], r[3] / r[1], d[0], d[1],
           d[2] / d[0], d[3] / d[1], r[0] / r[1], r[2] / r[3], t->different, good ? "" : " *");
    return good;
}

/* The least times of earlier processes, if any. */
static void read_times(const char *path, cell_times times[CELLS])
{
    FILE *f = fopen(path, "rb");
    bool seen = f && fread(times, sizeof *times, CELLS, f) == CELLS;
    for (int i = 0; i < CELLS && !seen; i++)
        for (int w = 0; w < WAYS; w++) {
            times[i].distinct[w] = INFINITY;
            for (int k = 0; k < REPEATED_PAIRS; k++)
                times[i].repeated[w][k] = INFINITY;
        }
    if (f)
        fclose(f);
}

static bool write_times(const char *path, const cell_times times[CELLS])
{
    FILE *f = fopen(path, "wb");
    bool written = f && fwrite(times, sizeof *times, CELLS, f) == CELLS;
    return (!f || fclose(f) == 0) && written;
}

/* beside SEED FILE: the file holds the least times so far, and those of this process then. */
int main(int argc, char **argv)
{
    static cell_times times[CELLS];
    int good = 0;
    if (argc != 3 || study_article_new(&work) != FMB_OK)
        return EXIT_FAILURE;
    read_times(argv[2], times);
    for (int round = 0; round < ROUNDS; round++)
        if (!measure_all(strtoull(argv[1], NULL, 10), times))
            return EXIT_FAILURE;
    if (!write_times(argv[2], times))
        return EXIT_FAILURE;
    printf("%20srepeated, as the article does     |      distinct pairs           | FMB/SAT, "
           "repeated\n"
           "%20sFMB ns  SAT ns  ours/original      FMB ns  SAT ns ours/original  original   ours  "
           "differ\n",
           "", "");
    for (int i = 0; i < CELLS; i++) {
        cell c = cell_of_number(i);
        good += report(&c, &times[i]);
    }
    printf("%d of %d cells within 15 %%\n", good, CELLS);
    study_article_free(work);
    study_pairs_free(&ours);
    return good == CELLS ? EXIT_SUCCESS : EXIT_FAILURE;
}
