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
/* A steep elimination ends, if it does, where rows are hardly more than dimensions. */
#define STEEP_FREEDOMS 4
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

/* The walk around a shadow is on a dictionary, which becomes dense; it is quick if it has no more
 * columns, and worth it where rows are many for those, as edges are then; small ones may be dense
 * from the beginning. */
#define WALKED_COLUMNS   24
#define SMALL_DICTIONARY 6
/* [bits] What queries find modulo a prime (lp/linalg/modular/modular_kernel.h). */
#define SHORT_MINOR 60

int fmb_judge_kept(const fmb_part *p, const int *place)
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

bool fmb_judge_asks_ends(const fmb_lift *lift, const fmb_part *p, int kept)
{
    return kept <= 1 && !has_strict_rows(p) && fmb_lift_freedom(lift) > LEAST_FREEDOMS;
}

static double named_by_row(const fmb_lift *lift)
{
    return (double)fmb_lift_entries(lift) / (double)fmb_lift_rows(lift);
}

static bool are_most_coefficients_there(const fmb_lift *lift)
{
    return 2 * named_by_row(lift) >= (double)fmb_lift_columns(lift);
}

static bool are_nearly_all_coefficients_there(const fmb_lift *lift)
{
    return 4 * named_by_row(lift) >= 3 * (double)fmb_lift_columns(lift);
}

bool fmb_judge_escapes(const fmb_lift *lift)
{
    return are_nearly_all_coefficients_there(lift) && fmb_lift_bounds(lift) == 0;
}

/* Queries are quicker where rows name most variables, or where numbers of more than a few columns
 * would become long, and where they are answered by minors that are short; the only question of one
 * variable is how far it goes. */
static bool is_dictionary_quick(const fmb_lift *lift, int kept)
{
    size_t bits = fmb_lift_minor_bits(lift);
    if (fmb_lift_columns(lift) <= SMALL_DICTIONARY)
        return kept != 2 || bits > SHORT_MINOR;
    return !are_most_coefficients_there(lift) && bits <= FMB_LONG_MINOR;
}

bool fmb_judge_walks(const fmb_lift *lift, const fmb_part *p, int kept)
{
    bool many = 4 * p->m > 9 * (size_t)p->n && is_dictionary_quick(lift, kept);
    return kept <= 2 && p->n <= WALKED_COLUMNS && many && !has_wide_rows(p) && !has_strict_rows(p);
}

bool fmb_judge_doubts_solution(const fmb_lift *lift)
{
    return fmb_lift_entries(lift) >= MANY_ENTRIES && are_most_coefficients_there(lift) &&
           !fmb_lift_has_origin(lift);
}

/* Is that share of the rows bounds on one variable? */
static bool has_bounds(const fmb_lift *lift, double share)
{
    return (double)fmb_lift_bounds(lift) >= share * (double)fmb_lift_rows(lift);
}

static bool do_few_go(const fmb_part *p, int kept)
{
    return p->n <= kept + FEW_TO_GO;
}

/* Rows are many for the variables that are left. */
static bool is_crowded(const fmb_lift *lift)
{
    size_t columns = fmb_lift_columns(lift);
    return columns >= LEAST_CROWD && fmb_lift_rows(lift) >= 4 * columns;
}

/* Three of six variables stay: rays to the end are as quick as queries, but where very many rows
 * name all variables. */
static bool are_rays_few(const fmb_lift *lift, const fmb_part *p, int kept)
{
    bool many = p->m > MANY_ROWS(p) && are_nearly_all_coefficients_there(lift);
    return kept == 3 && do_few_go(p, kept) && !many;
}

/* In the plane, queries are so quick that rays only delay them, but where these are few: of small
 * cones, and of such that are hardly more than a simplex. */
static bool do_rays_delay_queries(const fmb_lift *lift, int kept)
{
    size_t freedom = fmb_lift_freedom(lift), columns = fmb_lift_columns(lift);
    if (kept != 2 || freedom <= STEEP_FREEDOMS)
        return false;
    if (are_nearly_all_coefficients_there(lift))
        return columns + freedom + fmb_lift_is_long(lift) > SIZE_IN_PLANE;
    bool between_bounds = columns > LEAST_CROWD && is_crowded(lift) && has_bounds(lift, 0.33);
    bool few_rows = fmb_lift_rows(lift) < 3 * columns; /* unlike disjunctions */
    return between_bounds || (freedom > FREEDOMS_IN_PLANE && few_rows);
}

/* Rays of a first try: half as many where a few queries take as long; none where rows are many,
 * but name few variables. */
uint64_t fmb_judge_first_rays(const fmb_lift *lift, const fmb_part *p, int kept)
{
    if (fmb_lift_freedom(lift) > MANY_FREEDOMS || do_rays_delay_queries(lift, kept))
        return 0;
    bool full = are_nearly_all_coefficients_there(lift);
    bool flat = full && fmb_lift_columns(lift) <= FLAT_CONE;
    uint64_t rays = kept <= 2 && !flat ? FMB_TRIAL_BUDGET(p->m) / 2 : FMB_TRIAL_BUDGET(p->m);
    if (kept < FMB_SHORT_QUERIES && p->m > MANY_ROWS(p) && !full && !do_few_go(p, kept))
        return 0;
    if (fmb_lift_freedom(lift) > CROWDED_FREEDOMS && !(kept > 2 && has_bounds(lift, 0.25)))
        return 0;
    if (fmb_lift_freedom(lift) > FEW_FREEDOMS && kept <= 2 && named_by_row(lift) <= SPARSE)
        return 0;
    bool short_queries = kept > 2 && kept <= FMB_SHORT_QUERIES && !are_rays_few(lift, p, kept);
    return short_queries && p->m > MANY_ROWS(p) ? rays / 4 : rays;
}

/* What makes few more rows is eliminated: not where rows name many of the variables, or are many
 * for these, nor where variables are very many, as rays or a few queries are quicker, unless
 * numbers are long. */
bool fmb_judge_goes_gently(const fmb_lift *lift, int kept)
{
    double named = named_by_row(lift), columns = (double)fmb_lift_columns(lift);
    bool full = named > UNLIKE_SPARSE && 3 * named > columns;
    bool many = columns > MANY_COLUMNS || is_crowded(lift);
    bool long_queries = columns <= MANY_COLUMNS && fmb_lift_minor_bits(lift) > FMB_LONG_MINOR;
    return kept >= FMB_SHORT_QUERIES || !(full || many) || long_queries;
}

/* A box in other coordinates, as of zonotopes: it has twice as many rows as variables. */
static bool is_box(const fmb_lift *lift)
{
    return fmb_lift_rows(lift) == 2 * fmb_lift_columns(lift) && has_bounds(lift, 0.33);
}

/* Its projection has few more facets than it has rows, while hulls in many dimensions, which rays
 * and queries end with, take longer than rows to be pruned. */
static bool is_hull_dear(const fmb_lift *lift, int kept)
{
    return kept > FMB_SHORT_QUERIES && are_nearly_all_coefficients_there(lift) &&
           fmb_lift_freedom(lift) <= FREEDOMS_BEFORE_HULL && !fmb_lift_is_long(lift);
}

/* In the plane, queries are quicker, but where the box refuses most pairs. */
static bool is_sparse(const fmb_lift *lift, int kept)
{
    double named = named_by_row(lift);
    bool bounded = has_bounds(lift, 0.6);
    return (kept > 2 || bounded) && named <= (bounded ? SPARSE_BETWEEN_BOUNDS : SPARSE) &&
           3 * named <= (double)fmb_lift_columns(lift);
}

size_t fmb_judge_pruned_rows(const fmb_lift *lift, const fmb_part *p, int kept)
{
    if (kept < FMB_SHORT_QUERIES && fmb_lift_columns(lift) > MANY_COLUMNS)
        return 0;
    if (is_box(lift) || (is_hull_dear(lift, kept) && kept > FMB_SHORT_QUERIES + 1))
        return 100 * p->m;
    if (is_hull_dear(lift, kept))
        return 20 * p->m;
    if (is_sparse(lift, kept))
        return (kept > FMB_SHORT_QUERIES ? 10 : 6) * p->m;
    return 0;
}

static bool is_cone_dense_or_small(const fmb_lift *lift)
{
    return named_by_row(lift) >= DENSE || fmb_lift_columns(lift) <= SMALL_CONE ||
           fmb_lift_freedom(lift) < SMALL_CONE;
}

/* Where the first variable tells, or other ways are long. */
bool fmb_judge_goes_steeper(const fmb_lift *lift, int kept)
{
    bool few = fmb_lift_freedom(lift) <= STEEP_FREEDOMS || kept > FMB_SHORT_QUERIES;
    return few && !fmb_lift_is_long(lift) && are_most_coefficients_there(lift);
}

/* Rays that a second try may make, before the oracle is asked: none where cones tend to have very
 * many, or rows are many for three kept variables; more where the oracle has more to do, or numbers
 * are too long for its guesses. */
uint64_t fmb_judge_second_rays(const fmb_lift *lift, const fmb_part *p, int kept)
{
    if (fmb_lift_freedom(lift) > FEW_FREEDOMS || do_rays_delay_queries(lift, kept))
        return 0;
    if (kept == 4 && has_wide_rows(p))
        return 64 * RAYS_OF_SECOND_TRY;
    if (has_strict_rows(p) || kept > FMB_SHORT_QUERIES)
        return 16 * RAYS_OF_SECOND_TRY;
    if (kept > 2 && fmb_lift_is_long(lift) && fmb_lift_freedom(lift) <= LONG_FREEDOMS)
        return 8 * RAYS_OF_SECOND_TRY;
    if (are_rays_few(lift, p, kept))
        return 8 * RAYS_OF_SECOND_TRY;
    if (p->m > MANY_ROWS(p))
        return 0;
    if (kept == 3 && has_bounds(lift, 0.25) && fmb_lift_rows(lift) <= 3 * fmb_lift_columns(lift))
        return 8 * RAYS_OF_SECOND_TRY; /* as of rectifiers */
    if (kept == 3 && is_cone_dense_or_small(lift))
        return RAYS_OF_SECOND_TRY;
    return kept == 4 ? 8 * RAYS_OF_SECOND_TRY : 0;
}

/* To find out which of many rows are irredundant takes as long as some queries, where few variables
 * are kept; of long numbers, so it does of fewer rows. */
bool fmb_judge_thins(const fmb_elim *e, size_t before, int kept)
{
    size_t most = fmb_elim_minor_bits(e) > FMB_LONG_MINOR ? before : before * (size_t)kept;
    return kept >= FMB_SHORT_QUERIES || e->live.size <= most;
}
