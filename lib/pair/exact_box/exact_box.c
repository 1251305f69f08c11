/* exact_box.c: see exact_box.h. */
#include "pair/exact_box/exact_box.h"

#include <math.h>
#include <string.h>

#include "frame/frame_private.h"
#include "pair/exact_box/exact_box_value.h"
#include "pair/exact_box/exact_walk.h"
#include "pair/exact_box/vertex_walk.h"

enum { MOST_GOALS = 2 * (2 * FMB_EXACT_BOX_DIM + 1), MOST_POINTS = MOST_GOALS + 1 };

/* Visited vertices are kept, as many ends are attained at one that was found before. There is room:
 * the first search adds at most one, and so does each end, as is_end_reached forgets a vertex that
 * is not that end. */
struct fmb_exact_boxer {
    fmb_exact_box_program program;
    fmb_exact_box_walk walk;
    fmb_exact_box_whole whole;
    fmb_exact_box point[MOST_POINTS + 1]; /* visited so far; the next one */
    double near[MOST_POINTS][FMB_EXACT_BOX_COLUMNS + 2];
    bool is_near[MOST_POINTS]; /* its doubles are good enough for a witness */
    int points, at;            /* at: one of them */
    fmb_exact_box_goal goal[MOST_GOALS];
    int goals, end[MOST_GOALS]; /* the point where each goal is optimal */
};

/* ---- ends ------------------------------------------------------------------------------------ */

/* Visit that basic solution, if it is a vertex; the witness is the mean of visited vertices. */
static bool take_state_of_basis(fmb_exact_boxer *b, const fmb_exact_box_basis *basis)
{
    int k = 0;
    while (k < b->points && memcmp(basis, &b->point[k].basis, sizeof *basis) != 0)
        k++;
    b->at = k;
    if (k < b->points)
        return true;
    if (!fmb_exact_box_state(&b->point[k], &b->program, basis))
        return false;
    b->is_near[k] = fmb_exact_box_near_values(&b->point[k], b->near[k]);
    b->points++;
    return true;
}

/* Continue the walk in integers from where doubles ended. */
static fmb_verdict go_on_exactly(fmb_exact_boxer *b, const fmb_exact_box_goal *goal)
{
    fmb_exact_box *v = &b->point[b->points];
    if (!fmb_exact_box_take_basis(v, &b->program, &b->walk.basis))
        return FMB_UNKNOWN;
    fmb_verdict verdict = fmb_exact_box_walk_exactly(v, goal);
    fmb_exact_box_basis basis = v->basis;
    return verdict == FMB_FEASIBLE && !take_state_of_basis(b, &basis) ? FMB_UNKNOWN : verdict;
}

static void forget_points(fmb_exact_boxer *b)
{
    b->points = 0;
    b->whole.of = b->whole.adjugate_of = b->whole.low_of = NULL;
    for (int k = 0; k <= MOST_POINTS; k++)
        b->point[k].whole = &b->whole;
}

/* Walk to a first vertex; unless prove is set, it may be unproved. */
static fmb_verdict find_vertex(fmb_exact_boxer *b, bool prove)
{
    forget_points(b);
    if (fmb_exact_box_walk_start(&b->walk, &b->program)) {
        if (!prove || take_state_of_basis(b, &b->walk.basis))
            return FMB_FEASIBLE;
    } else if (fmb_exact_box_take_basis(&b->point[0], &b->program, &b->walk.basis) &&
               fmb_exact_box_are_apart(&b->point[0], b->walk.weight)) {
        return FMB_INFEASIBLE;
    }
    return go_on_exactly(b, NULL);
}

/* The approximate value of the goal at visited point k. */
static double near_value_of_goal(const fmb_exact_boxer *b, const fmb_exact_box_goal *goal, int k)
{
    double value = goal->is_world ? 0 : b->near[k][goal->number];
    for (int j = 0; goal->is_world && j < b->program.columns; j++)
        value += b->walk.world[goal->number][j] * b->near[k][j];
    return goal->greatest ? value : -value;
}

static bool is_end_visited(fmb_exact_boxer *b, const fmb_exact_box_goal *goal)
{
    double most = -INFINITY;
    b->at = 0;
    for (int k = 0; k < b->points; k++) {
        double value = near_value_of_goal(b, goal, k);
        if (value > most) {
            most = value;
            b->at = k;
        }
    }
    return b->points > 0 && fmb_exact_box_is_farthest(&b->point[b->at], goal);
}

/* Doubles may end at a vertex that is not the end: the walk in integers goes on from its basis. */
static bool is_end_reached(fmb_exact_boxer *b, const fmb_exact_box_goal *goal)
{
    int visited = b->points;
    if (!fmb_exact_box_walk_to(&b->walk, goal) || !take_state_of_basis(b, &b->walk.basis))
        return false;
    if (fmb_exact_box_is_farthest(&b->point[b->at], goal))
        return true;
    b->points = visited;
    return false;
}

static bool take_state_at_end(fmb_exact_boxer *b, const fmb_exact_box_goal *goal)
{
    return is_end_visited(b, goal) || is_end_reached(b, goal) ||
           go_on_exactly(b, goal) == FMB_FEASIBLE;
}

/* Add goals for both ends of n coordinates, or unknowns, from the first on: least ends, then
 * greatest ones, as consecutive optima are then near each other. */
static int add_goals(fmb_exact_box_goal *goal, int goals, bool is_world, int first, int n)
{
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < n; i++)
            goal[goals++] = (fmb_exact_box_goal){is_world, first + i, side == 1};
    return goals;
}

static void list_goals(fmb_exact_boxer *b, bool world, bool inside, bool time)
{
    const fmb_exact_box_program *s = &b->program;
    int last = s->time < 0 ? s->columns : s->time;
    int n = add_goals(b->goal, 0, true, 0, world ? s->dim : 0);
    n = add_goals(b->goal, n, false, s->first_of_b, inside ? last - s->first_of_b : 0);
    b->goals = add_goals(b->goal, n, false, s->time, time && s->time >= 0);
}

static bool find_ends(fmb_exact_boxer *b)
{
    for (int i = 0; i < b->goals; i++) {
        if (fmb_poll_ask(b->whole.poll) != FMB_OK || !take_state_at_end(b, &b->goal[i]))
            return false;
        b->end[i] = b->at;
    }
    return true;
}

/* A callback for one goal, at the point where it is optimal. */
typedef bool write_end(fmb_exact_boxer *b, const fmb_exact_box_goal *goal, void *to);

/* Write the ends point after point, as goals at one point share its exact numbers. */
static bool write_wanted_ends(fmb_exact_boxer *b, write_end *write, void *to)
{
    bool good = true;
    for (int k = 0; k < b->points; k++)
        for (int i = 0; good && i < b->goals; i++)
            if (b->end[i] == k) {
                b->at = k;
                good = write(b, &b->goal[i], to);
            }
    return good;
}

/* The index of an end among those of its group: of the world, of B, of time. */
static size_t place_of_goal(const fmb_exact_box_program *s, const fmb_exact_box_goal *goal,
                            int *group)
{
    bool is_time = !goal->is_world && goal->number == s->time;
    int first = goal->is_world ? 0 : is_time ? s->time : s->first_of_b;
    *group = goal->is_world ? 0 : is_time ? 2 : 1;
    return 2 * (size_t)(goal->number - first) + goal->greatest;
}

/* ---- in doubles ------------------------------------------------------------------------------ */

enum { WORLD, INSIDE, TIME, GROUPS };

/* Ends by group; the caller's are written only when all is known. */
typedef struct box_answer {
    double end[GROUPS][2 * FMB_EXACT_BOX_DIM];
} box_answer;

static bool write_rounded_end(fmb_exact_boxer *b, const fmb_exact_box_goal *goal, void *self)
{
    box_answer *to = self;
    int group, exponent = goal->is_world ? b->program.exponent[goal->number] : 0;
    size_t place = place_of_goal(&b->program, goal, &group);
    return fmb_exact_box_value_outward(&b->point[b->at], goal, exponent, &to->end[group][place]);
}

/* Coordinate i of visited point k. */
static double coordinate_of_point(fmb_exact_boxer *b, const fmb_frame *p, int k, int i)
{
    const double *z = b->near[k];
    bool by_corners = fmb_frame_is_by_corners(p->shape);
    if (!b->is_near[k])
        return fmb_exact_box_value_roughly(&b->point[k], &(fmb_exact_box_goal){true, i, false},
                                           b->program.exponent[i]);
    double x = p->origin[i] + (p->speed ? z[b->program.time] * p->speed[i] : 0);
    for (int l = 0; l < p->naxes; l++)
        x += z[l] * (p->axes[l * p->dim + i] - (by_corners ? p->origin[i] : 0));
    return x;
}

/* If numbers are so large that sums overflow, shares are added instead. Point after point, as all
 * coordinates of a point share its exact numbers. */
static void write_mean_of_extreme_points(fmb_exact_boxer *b, const fmb_frame *p, double *x)
{
    double sum[FMB_EXACT_BOX_DIM] = {0}, shares[FMB_EXACT_BOX_DIM] = {0};
    for (int k = 0; k < b->points; k++)
        for (int i = 0; i < p->dim; i++) {
            double at = coordinate_of_point(b, p, k, i);
            sum[i] += at;
            shares[i] += at / b->points;
        }
    for (int i = 0; i < p->dim; i++)
        x[i] = isfinite(sum[i]) ? sum[i] / b->points : shares[i];
}

static void copy_ends(double *to, const double *from, int n)
{
    for (int i = 0; to && i < 2 * n; i++)
        to[i] = from[i];
}

static bool answer(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                   const fmb_pair_answers *out)
{
    box_answer found = {.end[TIME] = {0, 1}};
    if (!fmb_exact_box_load(&b->program, p, q) || find_vertex(b, false) != FMB_FEASIBLE)
        return false;
    list_goals(b, out->world, out->inside, out->time);
    if (!find_ends(b) || !write_wanted_ends(b, write_rounded_end, &found) ||
        (b->points == 0 && !take_state_of_basis(b, &b->walk.basis)))
        return false;
    copy_ends(out->world, found.end[WORLD], p->dim);
    copy_ends(out->inside, found.end[INSIDE], q->naxes);
    copy_ends(out->time, found.end[TIME], 1);
    if (out->witness)
        write_mean_of_extreme_points(b, p, out->witness);
    return true;
}

/* ---- in rationals ---------------------------------------------------------------------------- */

static void write_fraction(const fmb_wide *numerator, const fmb_wide *denominator, mpq_srcptr unit,
                           mpq_t out)
{
    mpz_import(mpq_numref(out), (size_t)numerator->n, -1, sizeof(uint64_t), 0, 0, numerator->word);
    mpz_import(mpq_denref(out), (size_t)denominator->n, -1, sizeof(uint64_t), 0, 0,
               denominator->word);
    if (numerator->minus)
        mpz_neg(mpq_numref(out), mpq_numref(out));
    mpq_canonicalize(out);
    if (unit)
        mpq_mul(out, out, unit);
}

static mpq_srcptr unit_of_goal(mpq_t *unit, const fmb_exact_box_goal *goal)
{
    return goal->is_world ? unit[goal->number] : NULL;
}

static void write_value_here(fmb_exact_boxer *b, mpq_t *unit, const fmb_exact_box_goal *goal,
                             mpq_t out)
{
    fmb_wide numerator, denominator;
    fmb_exact_box_value(&b->point[b->at], goal, &numerator, &denominator);
    write_fraction(&numerator, &denominator, unit_of_goal(unit, goal), out);
}

/* The caller's arrays of rationals, and the units of rows. */
typedef struct exact_answer {
    const fmb_pair_answers_q *out;
    mpq_t *unit;
} exact_answer;

static bool write_exact_end(fmb_exact_boxer *b, const fmb_exact_box_goal *goal, void *self)
{
    const exact_answer *a = self;
    mpq_t *const to[GROUPS] = {a->out->world, a->out->inside, a->out->time};
    int group;
    size_t place = place_of_goal(&b->program, goal, &group);
    write_value_here(b, a->unit, goal, to[group][place]);
    return true;
}

/* The vertex at which b stands: in the world, in B, its time. */
static void write_extreme_point(fmb_exact_boxer *b, mpq_t *unit, mpq_t *out)
{
    const fmb_exact_box_program *s = &b->program;
    for (int i = 0; i < s->dim; i++)
        write_value_here(b, unit, &(fmb_exact_box_goal){true, i, false}, out[i]);
    for (int j = s->first_of_b; j < s->columns; j++)
        write_value_here(b, unit, &(fmb_exact_box_goal){false, j, false},
                         out[s->dim + j - s->first_of_b]);
}

static fmb_verdict answer_in_units(fmb_exact_boxer *b, mpq_t *unit, const fmb_frame_q *p,
                                   const fmb_frame_q *q, const fmb_pair_answers_q *out)
{
    exact_answer to = {out, unit};
    if (!fmb_exact_box_load_q(&b->program, p, q, unit))
        return FMB_UNKNOWN;
    fmb_verdict verdict = find_vertex(b, true);
    if (verdict != FMB_FEASIBLE)
        return verdict;
    if (out->witness)
        write_extreme_point(b, unit, out->witness);
    list_goals(b, out->world, out->inside, out->time);
    return find_ends(b) && write_wanted_ends(b, write_exact_end, &to) ? FMB_FEASIBLE : FMB_UNKNOWN;
}

static fmb_verdict answer_q(fmb_exact_boxer *b, const fmb_frame_q *p, const fmb_frame_q *q,
                            const fmb_pair_answers_q *out)
{
    mpq_t unit[FMB_EXACT_BOX_DIM];
    for (int i = 0; i < FMB_EXACT_BOX_DIM; i++)
        mpq_init(unit[i]);
    fmb_verdict verdict = answer_in_units(b, unit, p, q, out);
    for (int i = 0; i < FMB_EXACT_BOX_DIM; i++)
        mpq_clear(unit[i]);
    return verdict;
}

/* ---- all of it ------------------------------------------------------------------------------- */

fmb_exact_boxer *fmb_exact_boxer_new(fmb_mem *mem, const fmb_poll *poll)
{
    fmb_exact_boxer *b = fmb_mem_get(mem, 1, sizeof *b);
    if (b)
        b->whole.poll = poll;
    return b;
}

void fmb_exact_boxer_free(fmb_exact_boxer *b, fmb_mem *mem)
{
    fmb_mem_put(mem, b, 1, sizeof *b);
}

bool fmb_exact_box_answer(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                          const fmb_pair_answers *out)
{
    return b && answer(b, p, q, out);
}

fmb_verdict fmb_exact_box_answer_q(const fmb_frame_q *p, const fmb_frame_q *q,
                                   const fmb_pair_answers_q *out, fmb_mem *mem)
{
    fmb_exact_boxer *b = fmb_exact_boxer_new(mem, NULL);
    fmb_verdict verdict = b ? answer_q(b, p, q, out) : FMB_UNKNOWN;
    fmb_exact_boxer_free(b, mem);
    return verdict;
}

/* ---- verdicts -------------------------------------------------------------------------------- */

/* Is there a common point away from that end of unknown j's place? UNKNOWN: not proved. */
static fmb_verdict find_point_off_end(fmb_exact_boxer *b, int j, bool high)
{
    for (int k = 0; k < b->points; k++)
        if (fmb_exact_box_is_off_end(&b->point[k], j, high))
            return FMB_FEASIBLE;
    if (!take_state_at_end(b, &(fmb_exact_box_goal){false, j, !high}))
        return FMB_UNKNOWN;
    return fmb_exact_box_is_off_end(&b->point[b->at], j, high) ? FMB_FEASIBLE : FMB_INFEASIBLE;
}

/* Find a common inner point: if for each end of each place, except those of time, some common point
 * is away from it, the mean of these points is inside both frames. */
static fmb_verdict find_inner_point(fmb_exact_boxer *b)
{
    const fmb_exact_box_program *s = &b->program;
    fmb_verdict verdict = FMB_FEASIBLE;
    for (int j = 0; verdict == FMB_FEASIBLE && j < s->artificial; j++) {
        if (s->group[j] == FMB_EXACT_BOX_NONE || j == s->time)
            continue;
        verdict = find_point_off_end(b, j, false);
        if (verdict == FMB_FEASIBLE && s->group[j] == FMB_EXACT_BOX_UNIT)
            verdict = find_point_off_end(b, j, true);
    }
    return verdict;
}

fmb_verdict fmb_exact_box_decide(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                                 fmb_contact contact)
{
    if (!b || !fmb_exact_box_load(&b->program, p, q))
        return FMB_UNKNOWN;
    fmb_verdict verdict = find_vertex(b, true);
    return verdict == FMB_FEASIBLE && contact == FMB_CONTACT_OPEN ? find_inner_point(b) : verdict;
}

#ifndef FMB_WIDE_LONG
bool fmb_exact_box_meet(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q)
{
    if (!b || !fmb_exact_box_load(&b->program, p, q))
        return false;
    forget_points(b);
    return fmb_exact_box_walk_start(&b->walk, &b->program) &&
           take_state_of_basis(b, &b->walk.basis);
}
#endif
