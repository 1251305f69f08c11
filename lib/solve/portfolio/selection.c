/* selection.c: which way of a projection is tried, and for how long; see selection.h. */
#include "solve/portfolio/selection.h"

#include <math.h>

#ifdef FMB_ABLATE
int fmb_selection_forced = -1;
#endif

/* ---- pipelines ------------------------------------------------------------------------------- */

/* Identifier, name in data and reports, trials of bounded elimination, and units of work of rays,
 * of pruned elimination, and of queries, in this order. */
#define PIPELINES(P)                                                                               \
    P(QUERIES, "queries", 0, 0, 0, 64)                                                             \
    P(RAYS, "rays", 0, 1, 0, 64)                                                                   \
    P(MORE_RAYS, "more rays", 0, 8, 0, 64)                                                         \
    P(PRUNED, "pruned elimination", 0, 0, 1, 64)                                                   \
    P(MORE_PRUNED, "more pruned elimination", 0, 0, 8, 64)                                         \
    P(BOUNDED, "bounded elimination", 2, 0, 0, 64)                                                 \
    P(BOUNDED_RAYS, "bounded elimination, rays", 2, 1, 0, 64)                                      \
    P(BOUNDED_MORE_RAYS, "bounded elimination, more rays", 2, 8, 0, 64)                            \
    P(BOUNDED_PRUNED, "bounded and pruned elimination", 2, 0, 1, 64)                               \
    P(BOUNDED_MORE_PRUNED, "bounded and more pruned elimination", 2, 0, 8, 64)

#define PIPELINE_IDENTIFIER(id, ...) PIPELINE_##id,
enum { PIPELINES(PIPELINE_IDENTIFIER) PIPELINE_COUNT };
#undef PIPELINE_IDENTIFIER

static const struct named_pipeline {
    const char *name;
    unsigned bounded, rays, pruned, queries;
} PIPELINE[] = {
#define PIPELINE_STEPS(id, ...) [PIPELINE_##id] = {__VA_ARGS__},
    PIPELINES(PIPELINE_STEPS)
#undef PIPELINE_STEPS
};

const char *fmb_selection_name(int pipeline)
{
    return pipeline < PIPELINE_COUNT ? PIPELINE[pipeline].name : NULL;
}

/* A bound, or a row that names few variables, holds up most directions. */
static bool tries_recession(const fmb_features *f)
{
    return fmb_features_are_dense(f) && f->bounds == 0;
}

/* About as many steps as 128 rays take, and four for each row: entries of a row, and the bits of
 * its numbers, tell what one does; long ones are divided by what they have in common. */
static uint64_t unit_of_work(const fmb_features *f)
{
    uint64_t bits = f->minor_bits;
    return 16 * (uint64_t)f->entries * (f->is_long ? 128 + 16 * bits : 64 + bits);
}

static void add_step_if(bool suits, fmb_pipeline *p, int *steps, fmb_step_kind kind,
                        uint64_t budget)
{
    if (suits)
        p->step[(*steps)++] = (fmb_pipeline_step){kind, budget};
}

static fmb_pipeline pipeline_of_name(const fmb_features *f, const struct named_pipeline *named)
{
    fmb_pipeline p = {.step = {{FMB_STEP_NONE, 0}}};
    int n = 0;
    uint64_t unit = unit_of_work(f);
    add_step_if(tries_recession(f), &p, &n, FMB_STEP_RECESSION, 0);
    add_step_if(named->bounded > 0, &p, &n, FMB_STEP_BOUNDED, named->bounded);
    add_step_if(named->rays > 0, &p, &n, FMB_STEP_RAYS, named->rays * unit);
    add_step_if(named->pruned > 0, &p, &n, FMB_STEP_PRUNED, named->pruned * unit);
    add_step_if(named->queries > 0, &p, &n, FMB_STEP_QUERIES, named->queries * unit);
    return p;
}

/* ---- the table ------------------------------------------------------------------------------- */

/* clang-format off */
/* Made by `ninja fit-selection`; do not edit from here. */
/* 1922 problems of 44 families, seeds 34000 to 62103, ways as of commit 5c0a1d2d.
 * Time over that of the best method alone: 1.128 on families seen, 1.286 on others. */
static const short WEIGHT[PIPELINE_COUNT][1 + FMB_FEATURE_COUNT] = {
    {2886, 3159, 843, -1122, -550, -634, -1325, 811, 1154, 245, 1391, -82, -367, -196, -394,
     12544},
    {7139, 254, -982, 1582, 66, -939, -1267, -1086, 2335, -3816, -1857, -411, 185, -811, -854,
     -3175},
    {2140, -2349, -342, 1396, 473, 397, -669, -1974, 4127, -2015, 1774, -467, 407, -1527, -1167,
     9624},
    {-1606, -990, 966, -922, 54, 262, -910, 1340, -443, 783, -424, 588, 335, 105, -622, -1296},
    {4746, -1593, 435, -99, -456, -1333, 958, 279, -1812, 1641, 2991, 703, -317, -1099, -452,
     -5683},
    {4986, 770, 119, -141, -488, -998, -408, 1708, -5561, -255, -1602, 83, -83, -698, 78, -4008},
    {4068, 768, -477, 289, -657, -1014, 329, -1591, -5564, -1415, 509, -3, 296, 1078, 122, -4068},
    {-5428, -1197, -1160, 1467, 771, 921, -394, -3562, 4270, -685, -616, 291, 394, 1333, 967,
     5345},
    {-5667, -1132, 310, -55, 1017, 373, 96, 981, -3524, 922, -322, 437, -67, 444, 1137, -2337},
    {-4690, -2221, 338, 533, 130, -1304, 1011, 2011, -4055, 2371, 1330, 668, 136, 1078, 841,
     -6024},
};
/* To here. */
/* clang-format on */

/* log2(1 + x), by a straight line between powers of two: the same on every machine. */
static double rough_logarithm(double x)
{
    int exponent;
    double mantissa = frexp(1 + x, &exponent);
    return exponent - 2 + 2 * mantissa;
}

double fmb_selection_term(const fmb_features *f, int pipeline, fmb_feature_id k)
{
    return WEIGHT[pipeline][1 + k] * rough_logarithm(fmb_features_value(f, k));
}

double fmb_selection_score(const fmb_features *f, int pipeline)
{
    double sum = WEIGHT[pipeline][0];
    for (int k = 0; k < FMB_FEATURE_COUNT; k++)
        sum += fmb_selection_term(f, pipeline, (fmb_feature_id)k);
    return sum;
}

int fmb_selection_best(const fmb_features *f)
{
    int best = 0;
    for (int k = 1; k < PIPELINE_COUNT; k++)
        if (fmb_selection_score(f, k) < fmb_selection_score(f, best))
            best = k;
    return best;
}

fmb_pipeline fmb_selection_pipeline(const fmb_features *f)
{
    int pipeline = fmb_selection_best(f);
#ifdef FMB_ABLATE
    if (fmb_selection_forced >= 0)
        pipeline = fmb_selection_forced;
#endif
    return pipeline_of_name(f, &PIPELINE[pipeline]);
}

/* ---- bounded elimination --------------------------------------------------------------------- */

/* In so many dimensions a hull takes longer than to find out which of many rows are irredundant. */
#define SHORT_QUERIES 4

/* To find out which of many rows are irredundant takes as long as some queries, where few variables
 * are kept; of long numbers, so it does of fewer rows. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept)
{
    size_t most = fmb_elim_minor_bits(e) > FMB_LONG_MINOR ? before : before * (size_t)kept;
    return kept >= SHORT_QUERIES || e->live.size <= most;
}
