/* judge.c: which way of a projection is tried, and for how long; see judge.h. */
#include "solve/project/judge.h"

/* Cones with so few dimensions, or rows beyond them, never had very many rays; and what a second
 * try may make in three kept variables, which takes as long as support queries. */
#define FEW_FREEDOMS       10
#define RAYS_OF_SECOND_TRY 1000
/* A cone with so few of them has hardly more rays than rows; so few have few even of long numbers,
 * in the plane and above; and one with so many is not tried. */
#define LEAST_FREEDOMS      2
#define LONG_FREEDOMS(kept) ((kept) > 2 ? 8 : 6)
#define MANY_FREEDOMS       32
/* A steep elimination ends, if it does, where rows are hardly more than dimensions. */
#define STEEP_FREEDOMS 4
/* Cones of more have very many rays, but for such with bounds on many variables, as disjunctions.
 */
#define CROWDED_FREEDOMS 12

/* An elimination of rows that name so few variables, and few of all, goes on as one of such, if it
 * is pruned; cones over rows that name no more than so many have more rays than others. */
#define SPARSE                2.25
#define SPARSE_BETWEEN_BOUNDS 3.25
#define DENSE                 4
#define SMALL_CONE            8
/* So few dimensions, or variables that go, and rays are few however many the rows. */
#define FLAT_CONE 5
#define FEW_TO_GO 3
/* Elimination makes few rows at a time of so many variables, and queries do without. */
#define MANY_COLUMNS 32
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

/* Longer than a word: guesses in doubles are of no use, and queries solve for each vertex afresh.
 */
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

/* Where rows name most variables, and these are not very few, queries are quicker. */
static bool is_dictionary_quick(const fmb_lift *lift)
{
    return fmb_lift_columns(lift) <= SMALL_DICTIONARY || !are_most_coefficients_there(lift);
}

bool fmb_judge_walks(const fmb_lift *lift, const fmb_part *p, int kept)
{
    bool many = 4 * p->m > 9 * (size_t)p->n && is_dictionary_quick(lift);
    return kept <= 2 && p->n <= WALKED_COLUMNS && (many || has_wide_rows(p)) && !has_strict_rows(p);
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

/* Three of six variables stay: rays to the end are as quick as queries, but where very many rows
 * name all variables. */
static bool are_rays_few(const fmb_lift *lift, const fmb_part *p, int kept)
{
    bool many = p->m > MANY_ROWS(p) && are_nearly_all_coefficients_there(lift);
    return kept == 3 && do_few_go(p, kept) && !many;
}

/* Rays of a first try: half as many where a few queries take as long; none where rows are many,
 * but name few variables. */
uint64_t fmb_judge_first_rays(const fmb_lift *lift, const fmb_part *p, int kept)
{
    if (fmb_lift_freedom(lift) > MANY_FREEDOMS)
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

/* In the plane, queries are quicker, but where the box refuses most pairs. */
bool fmb_judge_prunes(const fmb_lift *lift, int kept)
{
    double named = named_by_row(lift);
    bool bounded = has_bounds(lift, 0.6);
    if (kept < FMB_SHORT_QUERIES && fmb_lift_columns(lift) > MANY_COLUMNS)
        return false;
    return (kept > 2 || bounded) && named <= (bounded ? SPARSE_BETWEEN_BOUNDS : SPARSE) &&
           3 * named <= (double)fmb_lift_columns(lift);
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
    if (fmb_lift_freedom(lift) > FEW_FREEDOMS)
        return 0;
    if (has_strict_rows(p) || kept > FMB_SHORT_QUERIES)
        return 16 * RAYS_OF_SECOND_TRY;
    if (kept > 1 && fmb_lift_is_long(lift) && fmb_lift_freedom(lift) <= LONG_FREEDOMS(kept))
        return 8 * RAYS_OF_SECOND_TRY;
    if (are_rays_few(lift, p, kept))
        return 8 * RAYS_OF_SECOND_TRY;
    if (p->m > MANY_ROWS(p))
        return 0;
    if (kept == 3 && is_cone_dense_or_small(lift))
        return RAYS_OF_SECOND_TRY;
    return kept == 4 ? 8 * RAYS_OF_SECOND_TRY : 0;
}

/* To find out which of many rows are irredundant takes as long as some queries, where few variables
 * are kept. */
size_t fmb_judge_rows_to_thin(int kept)
{
    return kept < FMB_SHORT_QUERIES ? (size_t)kept : 0;
}
