/* exact_box_value.c: see exact_box_value.h.
 *
 * In double-doubles x is refined once, by R (rest - P x) (point.c has the bound). A double-double
 * operation is off by at most a few LANE2_UNIT of sizes (docs/error-bounds.md, "Double-doubles"),
 * entries by one.
 */
#include "pair/exact_box/exact_box_value.h"

#include "pair/exact_box/outward.h"

#define DIM FMB_EXACT_BOX_DIM

#define CLOSE_UNIT LANE2_UNIT(true)

/* Added to the size of each number: CLOSE_UNIT of it exceeds FMB_WIDE_LEAST, the absolute error of
 * small numbers. */
#define LEAST_SIZE 0x1p-760

/* ---- costs ----------------------------------------------------------------------------------- */

/* 0 and 1, as columns of the program have them. */
static fmb_exact_box_cost nothing(const fmb_exact_box_program *s)
{
    return (fmb_exact_box_cost){&s->m[s->slack].whole[0], 0, 0};
}

static fmb_exact_box_cost one(const fmb_exact_box_program *s)
{
    return (fmb_exact_box_cost){&s->m[s->artificial].whole[0], 1, 0};
}

static fmb_exact_box_cost cost_of(const fmb_exact_box_vector *x, int row)
{
    return (fmb_exact_box_cost){&x->whole[row], x->near[row], x->rest[row]};
}

void fmb_exact_box_list_costs(const fmb_exact_box *v, const fmb_exact_box_goal *goal,
                              fmb_exact_box_cost *cost)
{
    const fmb_exact_box_program *s = v->program;
    int last = s->time < 0 ? s->columns : s->time, row = goal->number;
    int first = v->side == 0 ? 0 : s->first_of_b, end = v->side == 0 ? s->first_of_b : last;
    for (int j = 0; j < s->unknowns; j++)
        cost[j] = nothing(s);
    if (!goal->is_world) {
        cost[goal->number] = one(s);
        return;
    }
    for (int j = first; j < end; j++)
        cost[j] = cost_of(&s->m[j], row);
    if (s->time >= 0)
        cost[s->time] = cost_of(&s->speed[v->side], row);
    if (v->side == 1)
        cost[s->artificial + row] = one(s);
}

static fmb_exact_box_cost constant_of_goal(const fmb_exact_box *v, const fmb_exact_box_goal *goal)
{
    return goal->is_world ? cost_of(&v->program->origin[v->side], goal->number)
                          : nothing(v->program);
}

/* ---- in integers ----------------------------------------------------------------------------- */

void fmb_exact_box_value(fmb_exact_box *v, const fmb_exact_box_goal *goal, fmb_wide *numerator,
                         fmb_wide *denominator)
{
    const fmb_exact_box_program *s = v->program;
    fmb_wide constant, *room = v->whole->cost;
    fmb_exact_box_cost cost[FMB_EXACT_BOX_UNKNOWNS];
    const fmb_wide *a[DIM + 1], *b[DIM + 1];
    int n = 0;
    fmb_exact_box_list_costs(v, goal, cost);
    fmb_wide_copy(&constant, constant_of_goal(v, goal).whole);
    for (int j = 0; j < s->columns; j++)
        if (fmb_exact_box_is_one(v, j))
            fmb_exact_box_gather_end(s, j, &constant, cost[j].whole, false);
    for (int k = 0; k < s->dim; k++) {
        a[n] = fmb_exact_box_relative_cost(v, cost, v->basic[k], &room[k]);
        if (a[n]->n > 0)
            b[n++] = &v->whole->x[k];
    }
    fmb_wide_copy(denominator, n > 0 ? &fmb_exact_box_need_whole(v)->det : one(s).whole);
    a[n] = &constant;
    b[n] = denominator;
    fmb_wide_dot(numerator, n + 1, a, b, 0);
    if (s->has_ends && !goal->is_world) {
        fmb_wide_copy(&constant, denominator);
        denominator->n = 0;
        fmb_exact_box_gather_end(s, goal->number, denominator, &constant, false);
    }
    if (goal->is_world && v->side == 1)
        fmb_wide_negate(numerator);
}

/* ---- in double-doubles ----------------------------------------------------------------------- */

/* sum -= x */
static void take_close(lane2 *sum, double near, double rest)
{
    *sum = lane2_subtract(true, *sum, (lane2){near, rest});
}

/* Number `row` of the column of unknown j, relative to that of its reference. */
static lane2 close_entry(const fmb_exact_box *v, int j, int row)
{
    const fmb_exact_box_vector *m = v->program->m;
    int reference = fmb_exact_box_reference_of(v, j);
    lane2 x = {m[j].near[row], m[j].rest[row]};
    if (reference >= 0)
        take_close(&x, m[reference].near[row], m[reference].rest[row]);
    return x;
}

/* rest - P x, off by at most the result, which is the same for each row. */
static double find_close_rest(const fmb_exact_box *v, lane2 *rest)
{
    const fmb_exact_box_program *s = v->program;
    double size = 1;
    for (int row = 0; row < s->dim; row++)
        rest[row] = (lane2){s->h.near[row], s->h.rest[row]};
    for (int j = 0; j < s->columns; j++) {
        size += fmb_exact_box_is_one(v, j);
        for (int row = 0; fmb_exact_box_is_one(v, j) && row < s->dim; row++)
            take_close(&rest[row], s->m[j].near[row], s->m[j].rest[row]);
    }
    for (int k = 0; k < s->dim; k++) {
        size += 2 * fabs(v->x[k].x);
        for (int row = 0; row < s->dim; row++) {
            lane2 product =
                lane2_times(true, close_entry(v, v->basic[k], row), lane2_of(v->x[k].x));
            rest[row] = lane2_subtract(true, rest[row], product);
        }
    }
    return 4 * (s->columns + s->dim) * CLOSE_UNIT * size;
}

/* Correct x by way = R rest, rest being the residual in double-doubles with errors of at most
 * `off`; the error of R itself is bounded through `defect`. */
static void need_close(fmb_exact_box *v)
{
    int n = v->program->dim;
    lane2 rest[DIM];
    double off[DIM], way[DIM], most = 0;
    if (v->has_close)
        return;
    double error = find_close_rest(v, rest);
    for (int k = 0; k < n; k++) {
        double sum = 0, size = 0;
        for (int row = 0; row < n; row++) {
            sum += v->inverse[k][row] * rest[row].hi;
            size += fabs(v->inverse[k][row] * rest[row].hi);
        }
        way[k] = sum;
        most = size > most ? size : most;
    }
    for (int row = 0; row < n; row++)
        off[row] = error + (n + 4) * 0x1p-53 * fabs(rest[row].hi);
    fmb_exact_box_bound_way(v, off, v->close_error);
    for (int k = 0; k < n; k++) {
        v->close_x[k] = two_sum(v->x[k].x, way[k]);
        v->close_error[k] += 2 * v->defect[k] * (1 + 0x1p-40) * most;
    }
    v->has_close = true;
}

/* The value, scaled as its row is, and a bound of its error. False: it is a constant. */
static bool find_close_value(fmb_exact_box *v, const fmb_exact_box_goal *goal, lane2 *value,
                             double *error)
{
    const fmb_exact_box_program *s = v->program;
    fmb_exact_box_cost cost[FMB_EXACT_BOX_UNKNOWNS], c = constant_of_goal(v, goal);
    double size = fabs(c.near) + LEAST_SIZE, off = 0;
    bool varies = false;
    if (!v->is_near || s->has_ends)
        return false;
    fmb_exact_box_list_costs(v, goal, cost);
    *value = (lane2){c.near, c.rest};
    for (int j = 0; j < s->columns; j++)
        if (fmb_exact_box_is_one(v, j)) {
            take_close(value, -cost[j].near, -cost[j].rest);
            size += fabs(cost[j].near) + LEAST_SIZE;
        }
    for (int k = 0; k < s->dim; k++) {
        int reference = fmb_exact_box_reference_of(v, v->basic[k]);
        c = cost[v->basic[k]];
        lane2 close = {c.near, c.rest};
        double most = fabs(c.near);
        if (reference >= 0) {
            if (fmb_wide_compare(c.whole, cost[reference].whole) == 0)
                continue;
            take_close(&close, cost[reference].near, cost[reference].rest);
            most += fabs(cost[reference].near);
        }
        if (most == 0)
            continue;
        most += LEAST_SIZE;
        need_close(v);
        *value = lane2_add(true, *value, lane2_times(true, close, v->close_x[k]));
        size += most * fabs(v->close_x[k].hi);
        off += most * v->close_error[k];
        varies = true;
    }
    *error = (4 * (s->columns + s->dim) * CLOSE_UNIT * size + off) * (1 + 0x1p-40);
    if (goal->is_world && v->side == 1)
        *value = lane2_minus(*value);
    return varies && fabs(value->hi) < INFINITY && *error < INFINITY;
}

static int scale_of_goal(const fmb_exact_box *v, const fmb_exact_box_goal *goal)
{
    return goal->is_world ? v->program->scale[goal->number] : 0;
}

double fmb_exact_box_value_roughly(fmb_exact_box *v, const fmb_exact_box_goal *goal, int exponent)
{
    fmb_wide numerator, denominator;
    lane2 value;
    double error;
    if (find_close_value(v, goal, &value, &error) && error <= 0x1p-53 * fabs(value.hi))
        return ldexp(value.hi, scale_of_goal(v, goal) - exponent);
    fmb_exact_box_value(v, goal, &numerator, &denominator);
    return ldexp(fmb_wide_to_double(&numerator) / fmb_wide_to_double(&denominator),
                 64 * (numerator.n - denominator.n) - exponent);
}

/* ---- outward --------------------------------------------------------------------------------- */

/* The value lies within an error of hi + lo; |lo| is at most half of the way from hi to the next
 * double. Where the error is less than |lo|, hi and the double behind it on the side of lo are
 * those next to the value. */
static bool round_closely(fmb_exact_box *v, const fmb_exact_box_goal *goal, double *x,
                          int *exponent)
{
    lane2 value;
    double error;
    if (!find_close_value(v, goal, &value, &error) || !(fabs(value.lo) > error))
        return false;
    bool beyond = goal->greatest == (value.lo > 0);
    *x = beyond ? nextafter(value.hi, goal->greatest ? INFINITY : -INFINITY) : value.hi;
    *exponent = scale_of_goal(v, goal);
    return true;
}

static double round_exactly(fmb_exact_box *v, const fmb_exact_box_goal *goal, int *exponent)
{
    fmb_wide numerator, denominator;
    fmb_exact_box_value(v, goal, &numerator, &denominator);
    return fmb_exact_box_round_outward(&numerator, &denominator, goal->greatest, exponent);
}

/* The outermost double next to x 2^exponent. It is x with another exponent, unless that is below
 * the least normal double: there doubles are farther apart, and as x is the double next to the
 * value, and theirs are among the doubles that x was chosen from, the next one beyond x is the next
 * one beyond the value. */
static double scale_outward(double x, int exponent, bool up)
{
    double out = ldexp(x, exponent), back = ldexp(out, -exponent);
    bool is_inside = up ? back < x : back > x;
    return is_inside ? nextafter(out, up ? INFINITY : -INFINITY) : out;
}

bool fmb_exact_box_value_outward(fmb_exact_box *v, const fmb_exact_box_goal *goal, int exponent,
                                 double *out)
{
    double x;
    int more;
    if (!round_closely(v, goal, &x, &more))
        x = round_exactly(v, goal, &more);
    *out = scale_outward(x, more - exponent, goal->greatest);
    return isfinite(*out);
}
