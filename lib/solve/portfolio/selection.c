/* selection.c: which way of a projection is tried, and for how long; see selection.h. */
#include "solve/portfolio/selection.h"

#ifdef FMB_ABLATE
int fmb_selection_forced = -1;
#endif

/* Cones with so few dimensions, or rows beyond them, never had very many rays. */
#define FEW_FREEDOMS 10
/* A cone with so few of them has hardly more rays than rows; and one with so many is not tried. */
#define LEAST_FREEDOMS 2
#define MANY_FREEDOMS  32
/* Cones of more have very many rays, but for such with bounds on many variables, as disjunctions.
 */
#define CROWDED_FREEDOMS 12

/* An elimination of rows that name so few variables, and few of all, goes on as one of such, if it
 * is pruned; cones over rows that name no more than so many have more rays than others. */
#define SPARSE                2.25
#define SPARSE_BETWEEN_BOUNDS 3.25
/* The same for long numbers, where FMB_SHORT_QUERIES variables or more stay, however many there
 * are: rays and hulls take longer. */
#define SPARSE_BEFORE_HULL 3
#define DENSE              4
#define SMALL_CONE         8
/* So few variables that go, and rays are few however many the rows. */
#define FEW_TO_GO 3
/* Elimination makes few rows at a time of so many variables, and queries do without. */
#define MANY_COLUMNS 32
/* Of fewer variables, no rows are too many. */
#define LEAST_CROWD 4
/* In so many, an elimination that is pruned mostly ends sooner than a hull of more than four
 * dimensions. */
#define FREEDOMS_BEFORE_HULL 5
/* So it does where more variables stay than FMB_SHORT_QUERIES and so few go, once rays have not
 * answered at once (docs/experiments.md). */
#define FEW_TO_ELIMINATE 12
/* So many rows mean many rays, but not many queries where few variables are kept. */
#define MANY_ROWS(f) (4 * (size_t)(f)->variables)

static bool asks_ends(const fmb_features *f)
{
    return f->kept <= 1 && !f->is_strict && f->freedom > LEAST_FREEDOMS;
}

static double nonzeros_by_row(const fmb_features *f)
{
    return (double)f->entries / (double)f->rows;
}

static bool are_nearly_all_coefficients_there(const fmb_features *f)
{
    return 4 * nonzeros_by_row(f) >= 3 * (double)f->columns;
}

static bool tries_recession(const fmb_features *f)
{
    return are_nearly_all_coefficients_there(f) && f->bounds == 0;
}

/* Is that share of the rows bounds on one variable? */
static bool has_bounds(const fmb_features *f, double share)
{
    return (double)f->bounds >= share * (double)f->rows;
}

static bool do_few_go(const fmb_features *f)
{
    return f->variables <= f->kept + FEW_TO_GO;
}

/* Units of work for a first try of rays: none where cones tend to have very many, or rows are many,
 * but name few variables. */
static uint64_t first_rays(const fmb_features *f)
{
    bool full = are_nearly_all_coefficients_there(f);
    bool few_rays = f->kept > 2 && has_bounds(f, 0.25);
    if (f->freedom > MANY_FREEDOMS || (f->freedom > CROWDED_FREEDOMS && !few_rays))
        return 0;
    if (f->kept < FMB_SHORT_QUERIES && f->given > MANY_ROWS(f) && !full && !do_few_go(f))
        return 0;
    if (f->freedom > FEW_FREEDOMS && f->kept <= 2 && nonzeros_by_row(f) <= SPARSE)
        return 0;
    return 1;
}

/* What makes few more rows is eliminated: not where rows are many for the variables that are left,
 * nor where these are very many, as rays or a few queries are quicker; nor of long numbers where
 * more than two stay and rays are tried first. */
static bool bounds_growth(const fmb_features *f, bool rays_first)
{
    if (rays_first && f->kept > 2 && f->is_long)
        return false;
    bool crowded = f->columns >= LEAST_CROWD && f->rows >= 4 * f->columns;
    return f->kept >= FMB_SHORT_QUERIES || !(crowded || f->columns > MANY_COLUMNS);
}

/* A box in other coordinates, as of zonotopes: it has twice as many rows as variables. */
static bool is_box(const fmb_features *f)
{
    return f->rows == 2 * f->columns && has_bounds(f, 0.33);
}

/* Its projection has few more facets than it has rows, while hulls in many dimensions, which rays
 * and queries end with, take longer than rows to be pruned. */
static bool is_hull_expensive(const fmb_features *f)
{
    return f->kept > FMB_SHORT_QUERIES && are_nearly_all_coefficients_there(f) &&
           f->freedom <= FREEDOMS_BEFORE_HULL && !f->is_long;
}

/* In the plane, queries are quicker, but where the box refuses most pairs. */
static bool is_sparse(const fmb_features *f)
{
    double nonzero = nonzeros_by_row(f);
    bool bounded = has_bounds(f, 0.6);
    return (f->kept > 2 || bounded) && nonzero <= (bounded ? SPARSE_BETWEEN_BOUNDS : SPARSE) &&
           3 * nonzero <= (double)f->columns;
}

/* Units of work for an elimination that is pruned. */
static uint64_t pruned_units(const fmb_features *f)
{
    if (f->kept < FMB_SHORT_QUERIES && f->columns > MANY_COLUMNS)
        return 0;
    if (is_box(f) || is_hull_expensive(f))
        return 8;
    bool before_hull = f->kept >= FMB_SHORT_QUERIES && f->is_long;
    return before_hull && nonzeros_by_row(f) <= SPARSE_BEFORE_HULL ? 4 : is_sparse(f);
}

/* The same, once first rays have not answered. */
static uint64_t more_units_of_elimination(const fmb_features *f)
{
    bool few_go = f->columns <= (size_t)f->kept + FEW_TO_ELIMINATE;
    return f->kept > FMB_SHORT_QUERIES && few_go ? 8 : 0;
}

/* Three of six variables stay: rays to the end are as quick as queries, but where very many rows
 * name all variables. */
static bool are_rays_few(const fmb_features *f)
{
    bool many = f->given > MANY_ROWS(f) && are_nearly_all_coefficients_there(f);
    return f->kept == 3 && do_few_go(f) && !many;
}

static bool is_cone_dense_or_small(const fmb_features *f)
{
    return nonzeros_by_row(f) >= DENSE || f->columns <= SMALL_CONE || f->freedom < SMALL_CONE;
}

/* Units of work that rays may go on for, before the oracle is asked: none where cones tend to have
 * very many, or rows are many for three kept variables. */
static uint64_t more_units_of_rays(const fmb_features *f)
{
    if (f->freedom > FEW_FREEDOMS)
        return 0;
    if (f->is_strict || f->kept > FMB_SHORT_QUERIES || are_rays_few(f) ||
        (f->kept == 4 && f->is_wide))
        return 16;
    if (f->given > MANY_ROWS(f))
        return 0;
    if (f->kept == 3 && is_cone_dense_or_small(f))
        return 4;
    return f->kept == 4 ? 16 : 0;
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

/* What is nearly cheap is eliminated; then what rows are like tells the way; then the oracle is
 * asked. */
static fmb_pipeline pipeline_of_shape(const fmb_features *f)
{
    fmb_pipeline p = {.step = {{FMB_STEP_NONE, 0}}};
    int n = 0;
    bool more = !asks_ends(f);
    uint64_t unit = unit_of_work(f), pruned = pruned_units(f), rays = first_rays(f);
    uint64_t more_pruned = more_units_of_elimination(f), more_rays = more_units_of_rays(f);
    add_step_if(tries_recession(f), &p, &n, FMB_STEP_RECESSION, 0);
    add_step_if(more && bounds_growth(f, pruned == 0 && rays > 0), &p, &n, FMB_STEP_BOUNDED, 2);
    add_step_if(more && pruned > 0, &p, &n, FMB_STEP_PRUNED, pruned * unit);
    add_step_if(more && rays > 0, &p, &n, FMB_STEP_FIRST_RAYS, rays * unit);
    add_step_if(more && more_pruned > 0, &p, &n, FMB_STEP_PRUNED, more_pruned * unit);
    add_step_if(more && more_rays > 0, &p, &n, FMB_STEP_SECOND_RAYS, more_rays * unit);
    add_step_if(true, &p, &n, FMB_STEP_QUERIES, 64 * unit);
    return p;
}

/* ---- the table ------------------------------------------------------------------------------- */

/* Identifier, name in data and reports, trials of bounded elimination, units of work of rays, of
 * pruned elimination, and of queries, in this order. */
#define PIPELINES(P)                                                                               \
    P(OF_SHAPE, "as its shape tells", 0, 0, 0, 0)                                                  \
    P(QUERIES, "queries", 0, 0, 0, 64)                                                             \
    P(PRUNED, "pruned elimination", 0, 0, 1, 64)                                                   \
    P(MANY_RAYS, "many rays", 0, 64, 0, 64)                                                        \
    P(BOUNDED, "bounded elimination", 2, 0, 0, 64)                                                 \
    P(BOUNDED_RAYS, "bounded elimination, rays", 2, 8, 0, 64)                                      \
    P(RAYS_QUERIES, "bounded elimination, few rays, queries", 2, 1, 0, 16)                         \
    P(RAYS_PRUNED, "bounded elimination, few rays, pruned elimination", 2, 1, 32, 0)

#define PIPELINE_IDENTIFIER(id, ...) PIPELINE_##id,
enum { PIPELINES(PIPELINE_IDENTIFIER) PIPELINE_COUNT };
#undef PIPELINE_IDENTIFIER

static const struct named_pipeline {
    const char *name;
    unsigned bounded, rays, pruned, queries;
} PIPELINE[] = {
#define PIPELINE_TRIALS(id, ...) [PIPELINE_##id] = {__VA_ARGS__},
    PIPELINES(PIPELINE_TRIALS)
#undef PIPELINE_TRIALS
};

#define ASK(feature, most, otherwise)                                                              \
    {                                                                                              \
        FMB_FEATURE_##feature, most, otherwise, 0                                                  \
    }
#define TAKE(pipeline)                                                                             \
    {                                                                                              \
        FMB_FEATURE_COUNT, 0, 0, PIPELINE_##pipeline                                               \
    }

/* clang-format off */
/* Made by `ninja fit-selection`; do not edit from here. */
/* 318 problems of 36 families, seeds 101 to 2003, ways as of commit 428a040.
 * Time over that of the best pipeline: 1.321 on families seen, 1.349 on others. */
static const fmb_selection_line TABLE[] = {
    /*   0 */ ASK(MINOR_BITS, 100, 2),
    /*   1 */   TAKE(OF_SHAPE),
    /*   2 */ ASK(KEPT, 1, 4),
    /*   3 */   TAKE(OF_SHAPE),
    /*   4 */ ASK(KEPT, 3, 8),
    /*   5 */   ASK(ENTRIES, 38, 7),
    /*   6 */     TAKE(PRUNED),
    /*   7 */     TAKE(QUERIES),
    /*   8 */   TAKE(OF_SHAPE),
};
/* To here. */
/* clang-format on */

const char *fmb_selection_name(int pipeline)
{
    return pipeline < PIPELINE_COUNT ? PIPELINE[pipeline].name : NULL;
}

const fmb_selection_line *fmb_selection_line_at(int index)
{
    return &TABLE[index];
}

static fmb_pipeline pipeline_of_name(const fmb_features *f, const struct named_pipeline *named)
{
    fmb_pipeline p = {.step = {{FMB_STEP_NONE, 0}}};
    int n = 0;
    uint64_t unit = unit_of_work(f);
    add_step_if(tries_recession(f), &p, &n, FMB_STEP_RECESSION, 0);
    add_step_if(named->bounded > 0, &p, &n, FMB_STEP_BOUNDED, named->bounded);
    add_step_if(named->rays > 0, &p, &n, FMB_STEP_FIRST_RAYS, named->rays * unit);
    add_step_if(named->pruned > 0, &p, &n, FMB_STEP_PRUNED, named->pruned * unit);
    add_step_if(named->queries > 0, &p, &n, FMB_STEP_QUERIES, named->queries * unit);
    return p;
}

static int look_up(const fmb_features *f)
{
    int at = 0;
    while (TABLE[at].asks != FMB_FEATURE_COUNT)
        at = fmb_features_value(f, TABLE[at].asks) <= TABLE[at].most ? at + 1 : TABLE[at].otherwise;
    return TABLE[at].pipeline;
}

fmb_pipeline fmb_selection_pipeline(const fmb_features *f)
{
    int pipeline = look_up(f);
#ifdef FMB_ABLATE
    if (fmb_selection_forced >= 0)
        pipeline = fmb_selection_forced;
#endif
    return pipeline == PIPELINE_OF_SHAPE ? pipeline_of_shape(f)
                                         : pipeline_of_name(f, &PIPELINE[pipeline]);
}

/* To find out which of many rows are irredundant takes as long as some queries, where few variables
 * are kept; of long numbers, so it does of fewer rows. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept)
{
    size_t most = fmb_elim_minor_bits(e) > FMB_LONG_MINOR ? before : before * (size_t)kept;
    return kept >= FMB_SHORT_QUERIES || e->live.size <= most;
}
