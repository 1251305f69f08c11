/* selection.c: which way of a projection is tried, and for how long; see selection.h. */
#include "solve/portfolio/selection.h"

/* Cones with so few dimensions, or rows beyond them, never had very many rays; and what a second
 * try may make in three kept variables, which takes as long as support queries. */
#define FEW_FREEDOMS       10
#define RAYS_OF_SECOND_TRY 1000
/* A cone with so few of them has hardly more rays than rows; so few have few even of long numbers;
 * and one with so many is not tried. */
#define LEAST_FREEDOMS 2
#define LONG_FREEDOMS  8
#define MANY_FREEDOMS  32
/* An elimination that makes many rows ends, if it does, where rows are hardly more than dimensions.
 */
#define GROWING_FREEDOMS 4
/* In the plane, rays end sooner than queries only in so few of them; with variables, if rows name
 * nearly all of these. */
#define FREEDOMS_IN_PLANE 9
#define SIZE_IN_PLANE     13
/* Cones of more have very many rays, but for such with bounds on many variables, as disjunctions.
 */
#define CROWDED_FREEDOMS 12

/* An elimination of rows that name so few variables, and few of all, goes on as one of such, if it
 * is pruned; cones over rows that name no more than so many have more rays than others. */
#define SPARSE                2.25
#define SPARSE_BETWEEN_BOUNDS 3.25
#define UNLIKE_SPARSE         2.75
#define DENSE                 4
#define SMALL_CONE            8
/* So few dimensions, or variables that go, and rays are few however many the rows. */
#define FLAT_CONE 5
#define FEW_TO_GO 3
/* Elimination makes few rows at a time of so many variables, and queries do without. */
#define MANY_COLUMNS 32
/* Of fewer variables, no rows are too many. */
#define LEAST_CROWD 4
/* In so many, an elimination that is pruned mostly ends sooner than a hull of more than four
 * dimensions. */
#define FREEDOMS_BEFORE_HULL 5
/* So many coefficients, most of them there: that there is no solution a linear program finds sooner
 * than rays do. */
#define MANY_ENTRIES 100
/* So many rows mean many rays, but not many queries where few variables are kept. */
#define MANY_ROWS(p) (4 * (size_t)(p)->n)

int fmb_selection_kept(const fmb_part *p, const int *place)
{
    int kept = 0;
    for (int j = 0; j < p->n; j++)
        kept += place[p->var[j]] >= 0;
    return kept;
}

static bool has_strict_rows(const fmb_part *p)
{
    for (size_t i = 0; i < p->m; i++)
        if (p->rel[i] == FMB_LT)
            return true;
    return false;
}

/* Longer than a word: what a dictionary or a query works on is far longer still. */
static bool has_wide_rows(const fmb_part *p)
{
    for (size_t i = 0; i < p->m; i++)
        if (fmb_vec_is_wide(&p->row[i]))
            return true;
    return false;
}

bool fmb_selection_asks_ends(const fmb_reduced_part *reduced, const fmb_part *p, int kept)
{
    return kept <= 1 && !has_strict_rows(p) && fmb_features_freedom(reduced) > LEAST_FREEDOMS;
}

static double nonzeros_by_row(const fmb_reduced_part *reduced)
{
    return (double)fmb_features_entries(reduced) / (double)fmb_features_rows(reduced);
}

static bool are_most_coefficients_there(const fmb_reduced_part *reduced)
{
    return 2 * nonzeros_by_row(reduced) >= (double)fmb_features_columns(reduced);
}

static bool are_nearly_all_coefficients_there(const fmb_reduced_part *reduced)
{
    return 4 * nonzeros_by_row(reduced) >= 3 * (double)fmb_features_columns(reduced);
}

bool fmb_selection_tries_recession(const fmb_reduced_part *reduced)
{
    return are_nearly_all_coefficients_there(reduced) && fmb_features_bounds(reduced) == 0;
}

bool fmb_selection_doubts_solution(const fmb_reduced_part *reduced)
{
    return fmb_features_entries(reduced) >= MANY_ENTRIES && are_most_coefficients_there(reduced) &&
           !fmb_features_has_origin(reduced);
}

/* Is that share of the rows bounds on one variable? */
static bool has_bounds(const fmb_reduced_part *reduced, double share)
{
    return (double)fmb_features_bounds(reduced) >= share * (double)fmb_features_rows(reduced);
}

static bool do_few_go(const fmb_part *p, int kept)
{
    return p->n <= kept + FEW_TO_GO;
}

/* Rows are many for the variables that are left. */
static bool is_crowded(const fmb_reduced_part *reduced)
{
    size_t columns = fmb_features_columns(reduced);
    return columns >= LEAST_CROWD && fmb_features_rows(reduced) >= 4 * columns;
}

/* Three of six variables stay: rays to the end are as quick as queries, but where very many rows
 * name all variables. */
static bool are_rays_few(const fmb_reduced_part *reduced, const fmb_part *p, int kept)
{
    bool many = p->m > MANY_ROWS(p) && are_nearly_all_coefficients_there(reduced);
    return kept == 3 && do_few_go(p, kept) && !many;
}

/* In the plane, queries are so quick that rays only delay them, but where these are few: of small
 * cones, and of such that are hardly more than a simplex. */
static bool do_rays_delay_queries(const fmb_reduced_part *reduced, int kept)
{
    size_t freedom = fmb_features_freedom(reduced), columns = fmb_features_columns(reduced);
    if (kept != 2 || freedom <= GROWING_FREEDOMS)
        return false;
    if (are_nearly_all_coefficients_there(reduced))
        return columns + freedom + fmb_features_is_long(reduced) > SIZE_IN_PLANE;
    bool between_bounds = columns > LEAST_CROWD && is_crowded(reduced) && has_bounds(reduced, 0.33);
    bool few_rows = fmb_features_rows(reduced) < 3 * columns; /* unlike disjunctions */
    return between_bounds || (freedom > FREEDOMS_IN_PLANE && few_rows);
}

/* Rays of a first try: half as many where a few queries take as long; none where rows are many,
 * but name few variables. */
uint64_t fmb_selection_first_rays(const fmb_reduced_part *reduced, const fmb_part *p, int kept)
{
    if (fmb_features_freedom(reduced) > MANY_FREEDOMS || do_rays_delay_queries(reduced, kept))
        return 0;
    bool full = are_nearly_all_coefficients_there(reduced);
    bool flat = full && fmb_features_columns(reduced) <= FLAT_CONE;
    uint64_t rays = kept <= 2 && !flat ? FMB_TRIAL_BUDGET(p->m) / 2 : FMB_TRIAL_BUDGET(p->m);
    if (kept < FMB_SHORT_QUERIES && p->m > MANY_ROWS(p) && !full && !do_few_go(p, kept))
        return 0;
    if (fmb_features_freedom(reduced) > CROWDED_FREEDOMS &&
        !(kept > 2 && has_bounds(reduced, 0.25)))
        return 0;
    if (fmb_features_freedom(reduced) > FEW_FREEDOMS && kept <= 2 &&
        nonzeros_by_row(reduced) <= SPARSE)
        return 0;
    bool short_queries = kept > 2 && kept <= FMB_SHORT_QUERIES && !are_rays_few(reduced, p, kept);
    return short_queries && p->m > MANY_ROWS(p) ? rays / 4 : rays;
}

/* What makes few more rows is eliminated: not where rows name many of the variables, or are many
 * for these, nor where variables are very many, as rays or a few queries are quicker, unless
 * numbers are long. */
bool fmb_selection_bounds_growth(const fmb_reduced_part *reduced, int kept)
{
    double nonzero = nonzeros_by_row(reduced), columns = (double)fmb_features_columns(reduced);
    bool full = nonzero > UNLIKE_SPARSE && 3 * nonzero > columns;
    bool many = columns > MANY_COLUMNS || is_crowded(reduced);
    bool long_queries =
        columns <= MANY_COLUMNS && fmb_features_minor_bits(reduced) > FMB_LONG_MINOR;
    return kept >= FMB_SHORT_QUERIES || !(full || many) || long_queries;
}

/* A box in other coordinates, as of zonotopes: it has twice as many rows as variables. */
static bool is_box(const fmb_reduced_part *reduced)
{
    return fmb_features_rows(reduced) == 2 * fmb_features_columns(reduced) &&
           has_bounds(reduced, 0.33);
}

/* Its projection has few more facets than it has rows, while hulls in many dimensions, which rays
 * and queries end with, take longer than rows to be pruned. */
static bool is_hull_expensive(const fmb_reduced_part *reduced, int kept)
{
    return kept > FMB_SHORT_QUERIES && are_nearly_all_coefficients_there(reduced) &&
           fmb_features_freedom(reduced) <= FREEDOMS_BEFORE_HULL && !fmb_features_is_long(reduced);
}

/* In the plane, queries are quicker, but where the box refuses most pairs. */
static bool is_sparse(const fmb_reduced_part *reduced, int kept)
{
    double nonzero = nonzeros_by_row(reduced);
    bool bounded = has_bounds(reduced, 0.6);
    return (kept > 2 || bounded) && nonzero <= (bounded ? SPARSE_BETWEEN_BOUNDS : SPARSE) &&
           3 * nonzero <= (double)fmb_features_columns(reduced);
}

size_t fmb_selection_pruned_rows(const fmb_reduced_part *reduced, const fmb_part *p, int kept)
{
    if (kept < FMB_SHORT_QUERIES && fmb_features_columns(reduced) > MANY_COLUMNS)
        return 0;
    if (is_box(reduced) || (is_hull_expensive(reduced, kept) && kept > FMB_SHORT_QUERIES + 1))
        return 100 * p->m;
    if (is_hull_expensive(reduced, kept))
        return 20 * p->m;
    if (is_sparse(reduced, kept))
        return (kept > FMB_SHORT_QUERIES ? 10 : 6) * p->m;
    return 0;
}

static bool is_cone_dense_or_small(const fmb_reduced_part *reduced)
{
    return nonzeros_by_row(reduced) >= DENSE || fmb_features_columns(reduced) <= SMALL_CONE ||
           fmb_features_freedom(reduced) < SMALL_CONE;
}

/* Where the first variable tells, or other ways are long. */
bool fmb_selection_raises_bound(const fmb_reduced_part *reduced, int kept)
{
    bool few = fmb_features_freedom(reduced) <= GROWING_FREEDOMS || kept > FMB_SHORT_QUERIES;
    return few && !fmb_features_is_long(reduced) && are_most_coefficients_there(reduced);
}

/* Rays that a second try may make, before the oracle is asked: none where cones tend to have very
 * many, or rows are many for three kept variables; more where the oracle has more to do, or numbers
 * are too long for its guesses. */
uint64_t fmb_selection_second_rays(const fmb_reduced_part *reduced, const fmb_part *p, int kept)
{
    if (fmb_features_freedom(reduced) > FEW_FREEDOMS || do_rays_delay_queries(reduced, kept))
        return 0;
    if (kept == 4 && has_wide_rows(p))
        return 64 * RAYS_OF_SECOND_TRY;
    if (has_strict_rows(p) || kept > FMB_SHORT_QUERIES)
        return 16 * RAYS_OF_SECOND_TRY;
    if (kept > 2 && fmb_features_is_long(reduced) && fmb_features_freedom(reduced) <= LONG_FREEDOMS)
        return 8 * RAYS_OF_SECOND_TRY;
    if (are_rays_few(reduced, p, kept))
        return 8 * RAYS_OF_SECOND_TRY;
    if (p->m > MANY_ROWS(p))
        return 0;
    if (kept == 3 && has_bounds(reduced, 0.25) &&
        fmb_features_rows(reduced) <= 3 * fmb_features_columns(reduced))
        return 8 * RAYS_OF_SECOND_TRY; /* as of rectifiers */
    if (kept == 3 && is_cone_dense_or_small(reduced))
        return RAYS_OF_SECOND_TRY;
    return kept == 4 ? 8 * RAYS_OF_SECOND_TRY : 0;
}

/* To find out which of many rows are irredundant takes as long as some queries, where few variables
 * are kept; of long numbers, so it does of fewer rows. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept)
{
    size_t most = fmb_elim_minor_bits(e) > FMB_LONG_MINOR ? before : before * (size_t)kept;
    return kept >= FMB_SHORT_QUERIES || e->live.size <= most;
}
