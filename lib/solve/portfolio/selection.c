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
/* 1998 problems of 48 families, seeds 1 to 62103, ways as of commit 768b760f.
 * Time over that of the best method alone: 1.126 on families seen, 1.249 on others. */
static const short WEIGHT[PIPELINE_COUNT][1 + FMB_FEATURE_COUNT] = {
    {2754, 3657, 642, -1341, -463, -527, -1757, 1064, -1569, -418, 3855, -53, -436, -18, 568,
     16593},
    {13327, -1005, -655, 133, -170, -347, -1280, -2219, 3077, -4629, -2725, -384, 380, -2014,
     -1321, -4234},
    {6079, -3368, -603, 1354, 632, 1011, -984, -1589, 4922, -2384, -309, -580, 285, -2316,
     -1376, 9081},
    {-2548, 1619, 1370, -1547, -548, 1729, -1885, 2034, -3544, -1998, -607, 408, 461, -103,
     -1301, -4696},
    {4748, -1855, 883, -631, -690, -788, 1078, 1426, -3370, 2886, 4047, 742, -383, -1415, -623,
     -7833},
    {7458, 277, 770, -962, -755, -543, -355, -1895, -2568, 363, -2357, 410, -211, -1604, -791,
     5013},
    {1472, 2154, -244, -5, -994, -912, 690, -2051, -10134, -1891, 753, 200, 372, 1730, 227, -8266},
    {-7590, -402, -1297, 2024, 779, 327, -59, -3720, 5930, -56, -2092, -150, 595, 2070, 1102,
     10412},
    {-1257, 85, -17, -134, 305, -524, 56, 300, -2272, 1404, 827, 275, 14, 615, 431, -2741},
    {-3700, -2859, 736, 388, 217, -1225, 1254, 2519, -4549, 2623, 1685, 748, -228, 1480, 662,
     -8583},
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
