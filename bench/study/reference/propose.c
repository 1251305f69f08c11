/* propose.c: see propose.h. */
#include "study/reference/propose.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "study/reference/basis.h"

enum { MOST_STEPS = 4 * COLUMNS };

/* ---- life ------------------------------------------------------------------------------------ */

static void init_numbers(study_proposer *w)
{
    study_equations_init(&w->e);
    for (int i = 0; i < ROWS; i++)
        mpz_init(w->y[i]);
    for (int j = 0; j < COLUMNS; j++)
        mpz_inits(w->z[j], w->entry[j], w->gain[j], NULL);
    mpz_inits(w->scale, w->part, NULL);
}

study_proposer *study_proposer_open(int dim)
{
    study_proposer *w = calloc(1, sizeof *w);
    if (!w)
        return NULL;
    fmb_mem_init(&w->mem, NULL, 0);
    init_numbers(w);
    w->g = fmb_general_new(dim, FMB_SIMD_AUTO, &w->mem);
    if (w->g)
        return w;
    study_proposer_close(w);
    return NULL;
}

void study_proposer_close(study_proposer *w)
{
    if (!w)
        return;
    study_equations_clear(&w->e);
    for (int i = 0; i < ROWS; i++)
        mpz_clear(w->y[i]);
    for (int j = 0; j < COLUMNS; j++)
        mpz_clears(w->z[j], w->entry[j], w->gain[j], NULL);
    mpz_clears(w->scale, w->part, NULL);
    fmb_general_free(w->g, &w->mem);
    free(w);
}

/* ---- the pair in doubles -----------------------------------------------------------------------
 */

enum { NO_BITS = INT_MIN / 2 };

static int bits(const mpz_t x)
{
    return mpz_sgn(x) == 0 ? NO_BITS : (int)mpz_sizeinbase(x, 2);
}

/* Frame A, frame B or time. */
static int group_of(const study_meeting *s, int column)
{
    return (column >= s->from[1]) + (column >= s->from[2]);
}

/* Where one frame is far larger than both the other one and their distance, their common points are
 * near its corner: it is made a thousand times as large as these, or doubles would see nothing of
 * them. In the same way time. */
static void find_group_bits(study_proposer *w, const study_meeting *s)
{
    enum { THOUSAND = 10 };
    int size[3] = {NO_BITS, NO_BITS, NO_BITS}, near = NO_BITS;
    for (int i = 0; i < s->dim; i++) {
        int most = bits(s->h[i]);
        for (int j = 0; j < s->columns; j++)
            most = bits(s->m[i][j]) > most ? bits(s->m[i][j]) : most;
        near = bits(s->h[i]) - most > near ? bits(s->h[i]) - most : near;
        for (int j = 0; j < s->columns; j++) {
            int *of = &size[group_of(s, j)], here = bits(s->m[i][j]) - most;
            *of = here > *of ? here : *of;
        }
    }
    int smaller = size[0] < size[1] ? size[0] : size[1];
    near = smaller > near ? smaller : near;
    for (int k = 0; k < 3; k++) {
        int down = size[k] - near - THOUSAND;
        w->group_bits[k] = near > NO_BITS / 2 && size[k] > NO_BITS / 2 && down > 0 ? down : 0;
    }
}

/* Bits of the largest number of row i of M, or of h where M has none. */
static int bits_of_row(const study_proposer *w, const study_meeting *s, int i)
{
    int most = NO_BITS;
    for (int j = 0; j < s->columns; j++) {
        int here = bits(s->m[i][j]) - w->group_bits[group_of(s, j)];
        most = here > most ? here : most;
    }
    if (most < NO_BITS / 2)
        most = bits(s->h[i]);
    return most < NO_BITS / 2 ? 0 : most;
}

/* x 2^-down */
static double in_doubles(const mpz_t x, int down)
{
    long exponent;
    double part = mpz_get_d_2exp(&exponent, x);
    return part == 0 ? 0 : ldexp(part, (int)exponent - down);
}

/* Rows are scaled so that their largest number is about 1. False: a distance is beyond doubles. */
static bool load_in_doubles(study_proposer *w, const study_meeting *s)
{
    fmb_general_system *pair = &w->g->pair;
    bool good = true;
    w->factored[0] = -1;
    find_group_bits(w, s);
    pair->rows = s->dim;
    pair->columns = s->columns;
    for (int j = 0; j < s->columns; j++) {
        int group = group_of(s, j);
        pair->kind[j] = group == 2 || s->shape[group] == FMB_CUBOID ? FMB_GENERAL_UNIT
                        : group == 0                                ? FMB_GENERAL_OF_A
                                                                    : FMB_GENERAL_OF_B;
        w->column_bits[j] = w->group_bits[group];
    }
    for (int i = 0; i < s->dim; i++) {
        w->row_bits[i] = bits_of_row(w, s, i);
        pair->h[i] = in_doubles(s->h[i], w->row_bits[i]);
        good &= (bool)isfinite(pair->h[i]);
        for (int j = 0; j < s->columns; j++)
            pair->m[j * s->dim + i] = in_doubles(s->m[i][j], w->row_bits[i] + w->column_bits[j]);
    }
    return good;
}

/* ---- directions ------------------------------------------------------------------------------ */

/* y := a direction in doubles, of rows scaled so, times a power of 2. */
static void set_direction(study_proposer *w, const study_meeting *s, const double *direction)
{
    int exponent[STUDY_PAIR_MOST_DIM], least = INT_MAX;
    double part[STUDY_PAIR_MOST_DIM];
    for (int i = 0; i < s->dim; i++) {
        exponent[i] = 0;
        part[i] = isfinite(direction[i]) ? frexp(direction[i], &exponent[i]) : 0;
        exponent[i] -= w->row_bits[i];
        if (part[i] != 0 && exponent[i] < least)
            least = exponent[i];
    }
    for (int i = 0; i < s->dim; i++) {
        mpz_set_d(w->y[i], ldexp(part[i], DBL_MANT_DIG));
        if (part[i] != 0)
            mpz_mul_2exp(w->y[i], w->y[i], (mp_bitcnt_t)(exponent[i] - least));
    }
}

static bool prove_point(study_proposer *w, study_meeting *s, fmb_contact contact, const double *at)
{
    return study_basis_solve_point(w, s, at) && study_meeting_has_point(s, contact, w->z, w->scale);
}

/* What y, or its opposite, shows. */
static bool prove_by_direction(study_proposer *w, study_meeting *s, fmb_verdict verdict[2])
{
    for (int side = 0; side < 2 && verdict[FMB_CONTACT_OPEN] == FMB_UNKNOWN; side++) {
        for (int i = 0; side > 0 && i < s->dim; i++)
            mpz_neg(w->y[i], w->y[i]);
        for (int contact = 0; contact < 2; contact++)
            if (study_meeting_has_none(s, (fmb_contact)contact, w->y))
                verdict[contact] = FMB_INFEASIBLE;
    }
    return verdict[FMB_CONTACT_OPEN] == FMB_INFEASIBLE;
}

/* The same of the edge of the basis along which that pivot alone changes: its end may be out of
 * reach. */
static bool prove_by_edge(study_proposer *w, study_meeting *s, int pivot, fmb_verdict verdict[2])
{
    const int rows = w->g->program.rows;
    for (int k = 0; k < rows; k++)
        mpz_set_ui(w->e.x[k], k == pivot);
    return study_basis_solve_prices(w, s) && prove_by_direction(w, s, verdict);
}

/* The pivot that is worth something in that direction, which is an edge of the basis. */
static int find_pivot_of_direction(const study_proposer *w, const double *y)
{
    const fmb_general_system *g = &w->g->program;
    double most = -1;
    int best = 0;
    for (int k = 0; k < g->rows; k++) {
        double worth = 0;
        for (int i = 0; i < g->rows; i++)
            worth += y[i] * g->m[g->pivot[k] * g->rows + i];
        if (fabs(worth) > most) {
            most = fabs(worth);
            best = k;
        }
    }
    return best;
}

/* Steps from the basis that doubles name, until its point is common or a direction shows that there
 * is none. */
static void prove_by_steps(study_proposer *w, study_meeting *s, fmb_verdict verdict[2])
{
    for (int step = 0; step < MOST_STEPS && study_basis_solve_point(w, s, w->g->vertex); step++) {
        bool high;
        int place = study_basis_place_outside(w, &high);
        if (place < 0 && study_meeting_has_point(s, FMB_CONTACT_CLOSED, w->z, w->scale))
            verdict[FMB_CONTACT_CLOSED] = FMB_FEASIBLE;
        if (place < 0)
            return;
        study_basis_find_gains(w, s, NULL);
        if (!study_basis_step_into_range(w, s, place, high)) {
            prove_by_direction(w, s, verdict);
            return;
        }
    }
}

/* The method says that they are apart. Where that is rounding alone they touch. */
static void prove_apart(study_proposer *w, study_meeting *s, fmb_verdict verdict[2])
{
    set_direction(w, s, w->g->direction);
    if (prove_by_direction(w, s, verdict) && verdict[FMB_CONTACT_CLOSED] == FMB_INFEASIBLE)
        return;
    verdict[FMB_CONTACT_OPEN] = FMB_UNKNOWN;
    prove_by_edge(w, s, find_pivot_of_direction(w, w->g->basis.normal), verdict);
    if (verdict[FMB_CONTACT_CLOSED] == FMB_UNKNOWN)
        prove_by_steps(w, s, verdict);
}

/* The frames lie in parallel flats: a place of the basis that no column takes. */
static void prove_apart_by_flats(study_proposer *w, study_meeting *s, fmb_verdict verdict[2])
{
    double edge[FMB_GENERAL_MOST_ROWS];
    const fmb_basis *b = &w->g->basis;
    for (size_t r = 0; r < b->d && verdict[FMB_CONTACT_CLOSED] == FMB_UNKNOWN; r++) {
        if (b->basic[r] != SIZE_MAX)
            continue;
        fmb_dense_inverse_edge(&b->inverse, r, edge);
        set_direction(w, s, edge);
        prove_by_direction(w, s, verdict);
    }
}

/* ---- frames that meet ------------------------------------------------------------------------ */

/* Of a vertex where an unknown is as far from an end as can be, and that is 0: its prices are the
 * direction in which the frames touch. */
static bool prove_touching(study_proposer *w, study_meeting *s, int unknown, fmb_verdict verdict[2])
{
    const fmb_general_system *g = &w->g->program;
    int pivot = 0;
    while (pivot < g->rows && g->pivot[pivot] != unknown)
        pivot++;
    return pivot < g->rows && prove_by_edge(w, s, pivot, verdict);
}

/* The unknown, but time, that is closest to an end. */
static int find_tightest(const study_proposer *w, const study_meeting *s, const double *z)
{
    int tightest = -1;
    for (int j = 0; j < w->g->program.columns; j++)
        if ((j < s->from[2] || j >= s->columns) &&
            (tightest < 0 || fmin(z[j], 1 - z[j]) < fmin(z[tightest], 1 - z[tightest])))
            tightest = j;
    return tightest;
}

/* From a vertex. The mean of vertices, each the farthest from the end that the mean of those before
 * is closest to, until it is inside; or nothing leads away from that end. */
static void prove_open(study_proposer *w, study_meeting *s, fmb_verdict verdict[2])
{
    fmb_general *g = w->g;
    const int columns = g->program.columns;
    double z[COLUMNS], sum[COLUMNS], y[ROWS];
    for (int j = 0; j < columns; j++)
        z[j] = sum[j] = g->vertex[j];
    for (int n = 2; n < 2 * columns + 2; n++) {
        double cost[COLUMNS] = {0};
        int j = find_tightest(w, s, z);
        if (j < 0)
            break;
        double room = fmin(z[j], 1 - z[j]);
        if (room > 1.0 / 64)
            break;
        cost[j] = z[j] < 0.5 ? 1 : -1;
        if (!fmb_general_maximize(g, cost, y))
            return;
        double gain = fabs(g->vertex[j] - z[j]);
        if (room + gain < TINY && prove_touching(w, s, j, verdict))
            return;
        if (gain <= room / 4)
            break;
        for (int k = 0; k < columns; k++) {
            sum[k] += g->vertex[k];
            z[k] = sum[k] / n;
        }
    }
    if (prove_point(w, s, FMB_CONTACT_OPEN, z))
        verdict[FMB_CONTACT_OPEN] = FMB_FEASIBLE;
}

void study_prove_verdicts(study_proposer *w, study_meeting *s, fmb_verdict verdict[2])
{
    fmb_general *g = w->g;
    verdict[FMB_CONTACT_CLOSED] = verdict[FMB_CONTACT_OPEN] = FMB_UNKNOWN;
    if (!load_in_doubles(w, s))
        return;
    fmb_general_step step = fmb_general_find_vertex(g);
    if (step == FMB_GENERAL_CLASH)
        prove_apart(w, s, verdict);
    if (step == FMB_GENERAL_LOST)
        prove_apart_by_flats(w, s, verdict);
    if (step != FMB_GENERAL_GO)
        return;
    prove_open(w, s, verdict);
    if (verdict[FMB_CONTACT_OPEN] == FMB_FEASIBLE)
        verdict[FMB_CONTACT_CLOSED] = FMB_FEASIBLE;
    if (verdict[FMB_CONTACT_CLOSED] == FMB_UNKNOWN)
        prove_by_steps(w, s, verdict);
}

/* ---- ends ------------------------------------------------------------------------------------ */

/* Forms in doubles, scaled to about 1. */
static void set_cost(const study_proposer *w, const study_meeting *s, const study_form *f,
                     double *cost)
{
    long most = LONG_MIN, exponent[COLUMNS];
    for (int j = 0; j < s->columns; j++) {
        cost[j] = mpz_get_d_2exp(&exponent[j], f->w[j]);
        exponent[j] -= w->column_bits[j];
        if (cost[j] != 0 && exponent[j] > most)
            most = exponent[j];
    }
    for (int j = 0; j < w->g->program.columns; j++)
        cost[j] = j < s->columns && cost[j] != 0 ? ldexp(cost[j], (int)(exponent[j] - most)) : 0;
}

bool study_start_ends(study_proposer *w, const study_meeting *s)
{
    w->has_end = false;
    return load_in_doubles(w, s) && fmb_general_find_vertex(w->g) != FMB_GENERAL_LOST;
}

/* Steps from the basis that doubles name, until its point is common and nothing gains; prices are
 * those of the basis then. */
static bool walk_to_end(study_proposer *w, study_meeting *s, const study_form *f)
{
    for (int step = 0; step < MOST_STEPS; step++) {
        bool high;
        if (!study_basis_solve_point(w, s, w->g->vertex))
            return false;
        int place = study_basis_place_outside(w, &high);
        if (!study_basis_solve_form(w, s, f))
            return false;
        study_basis_find_gains(w, s, f);
        if (!(place < 0 ? study_basis_step_to_end(w, s)
                        : study_basis_step_into_range(w, s, place, high)))
            return place < 0;
    }
    return false;
}

static void keep_end(study_proposer *w)
{
    const fmb_general_system *g = &w->g->program;
    w->has_end = true;
    for (int k = 0; k < g->rows; k++)
        w->end_pivot[k] = g->pivot[k];
    for (int j = 0; j < g->columns; j++)
        w->end_vertex[j] = w->g->vertex[j] == 1;
}

/* Back to the last end; false if there is none. */
static bool return_to_end(study_proposer *w)
{
    fmb_general_system *g = &w->g->program;
    for (int j = 0; w->has_end && j < g->columns; j++) {
        g->is_pivot[j] = false;
        w->g->vertex[j] = w->end_vertex[j];
    }
    for (int k = 0; w->has_end && k < g->rows; k++) {
        g->pivot[k] = w->end_pivot[k];
        g->is_pivot[g->pivot[k]] = true;
    }
    return w->has_end;
}

/* Where the basis that doubles name is none, or leads nowhere, the last end is one to start from.
 */
bool study_prove_end(study_proposer *w, study_meeting *s, const study_form *f, double end)
{
    double cost[COLUMNS], y[ROWS];
    set_cost(w, s, f, cost);
    (void)fmb_general_maximize(w->g, cost, y);
    if (!walk_to_end(w, s, f) && !(return_to_end(w) && walk_to_end(w, s, f)))
        return false;
    keep_end(w);
    return study_meeting_has_end(s, f, w->z, w->scale, w->y, w->e.divisor, end);
}
