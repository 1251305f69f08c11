/* exact_box_value.c: see exact_box_value.h.
 *
 * In double-doubles every number is computed as in point.c, with LANE2_UNIT in place of u
 * (docs/error-bounds.md, "Double-doubles"): entries are off by a unit, so x and det, and a sum of
 * four products with them, are within 64 units of the same sizes.
 */
#include "pair/exact_box/exact_box_value.h"

#include "pair/exact_box/outward.h"

enum { DIM = FMB_EXACT_BOX_DIM };

/* ---- costs ----------------------------------------------------------------------------------- */

void fmb_exact_box_list_costs(const fmb_exact_box *v, const fmb_exact_box_goal *goal,
                              const fmb_exact_box_number *cost[FMB_EXACT_BOX_UNKNOWNS])
{
    const fmb_exact_box_program *s = v->program;
    int last = s->time < 0 ? s->columns : s->time, row = goal->number;
    int first = v->side == 0 ? 0 : s->first_of_b, end = v->side == 0 ? s->first_of_b : last;
    for (int j = 0; j < FMB_EXACT_BOX_UNKNOWNS; j++)
        cost[j] = &fmb_exact_box_zero;
    if (!goal->is_world) {
        cost[goal->number] = &fmb_exact_box_one;
        return;
    }
    for (int j = first; j < end; j++)
        cost[j] = &s->m[j][row];
    if (s->time >= 0)
        cost[s->time] = &s->speed[v->side][row];
    if (v->side == 1)
        cost[FMB_EXACT_BOX_ARTIFICIAL + row] = &fmb_exact_box_one;
}

/* ---- in integers ----------------------------------------------------------------------------- */

static void find_constant(const fmb_exact_box *v, const fmb_exact_box_goal *goal,
                          const fmb_exact_box_number *const *cost, fmb_wide *out)
{
    const fmb_exact_box_program *s = v->program;
    fmb_wide_copy(
        out, &(goal->is_world ? &s->origin[v->side][goal->number] : &fmb_exact_box_zero)->whole);
    for (int j = 0; j < s->columns; j++)
        if (fmb_exact_box_is_one(v, j))
            fmb_wide_add(out, &cost[j]->whole);
}

void fmb_exact_box_value(fmb_exact_box *v, const fmb_exact_box_goal *goal, fmb_wide *numerator,
                         fmb_wide *denominator)
{
    fmb_wide constant, room[DIM];
    const fmb_exact_box_number *cost[FMB_EXACT_BOX_UNKNOWNS];
    const fmb_wide *a[DIM + 1], *b[DIM + 1];
    int n = 0;
    fmb_exact_box_list_costs(v, goal, cost);
    find_constant(v, goal, cost, &constant);
    for (int k = 0; k < DIM; k++) {
        a[n] =
            fmb_exact_box_difference(fmb_exact_box_relative_cost(v, cost, v->basic[k]), &room[k]);
        if (a[n]->n == 0)
            continue;
        fmb_exact_box_need_x(v, k);
        b[n++] = &v->x[k];
    }
    if (n > 0)
        fmb_exact_box_need_det(v);
    fmb_wide_copy(denominator, n > 0 ? &v->det : &fmb_exact_box_one.whole);
    a[n] = &constant;
    b[n] = denominator;
    fmb_wide_dot(numerator, n + 1, a, b, 0);
    if (goal->is_world && v->side == 1)
        fmb_wide_negate(numerator);
    if (denominator->minus) {
        fmb_wide_negate(denominator);
        fmb_wide_negate(numerator);
    }
}

/* ---- in double-doubles ----------------------------------------------------------------------- */

/* Bits of what is there, besides those of x_k. */
enum { CLOSE_COMMON = 1 << DIM };

static lane2 close_number(const fmb_exact_box_number *x)
{
    return (lane2){x->near, x->rest};
}

static lane2 close_difference(fmb_exact_box_relative x)
{
    if (x.b->near == 0)
        return close_number(x.a);
    return lane2_subtract(true, close_number(x.a), close_number(x.b));
}

/* sum of a_i b_i */
static lane2 close_dot(const lane2 *a, const lane2 *b)
{
    lane2 sum = lane2_times(true, a[0], b[0]);
    for (int i = 1; i < DIM; i++)
        sum = lane2_add(true, sum, lane2_times(true, a[i], b[i]));
    return sum;
}

static void close_cross(const lane2 *a, const lane2 *b, lane2 *out)
{
    for (int row = 0; row < DIM; row++) {
        int i = (row + 1) % DIM, j = (row + 2) % DIM;
        out[row] =
            lane2_subtract(true, lane2_times(true, a[i], b[j]), lane2_times(true, a[j], b[i]));
    }
}

/* sum += sign x */
static void add_close(lane2 *sum, const fmb_exact_box_number *x, double sign)
{
    if (x->near != 0)
        *sum = lane2_add(true, *sum, (lane2){sign * x->near, sign * x->rest});
}

/* As need_rest. */
static void find_close_rest(fmb_exact_box *v)
{
    const fmb_exact_box_program *s = v->program;
    for (int row = 0; row < DIM; row++)
        v->close_rest[row] = close_number(&s->h[row]);
    for (int j = 0; j < s->columns; j++)
        for (int row = 0; fmb_exact_box_is_one(v, j) && row < DIM; row++)
            add_close(&v->close_rest[row], &s->m[j][row], -1);
}

static void find_close_basic(fmb_exact_box *v)
{
    for (int k = 0; k < DIM; k++)
        for (int row = 0; row < DIM; row++)
            v->close_basic[k][row] =
                close_difference(fmb_exact_box_relative_entry(v, v->basic[k], row));
}

/* x_k, and with the first one what all have in common: columns, rest, det. */
static void need_close_x(fmb_exact_box *v, int k)
{
    lane2 row_of_adjugate[DIM];
    bool is_first = !(v->has_close & CLOSE_COMMON);
    if (v->has_close >> k & 1)
        return;
    if (is_first) {
        find_close_rest(v);
        find_close_basic(v);
    }
    close_cross(v->close_basic[(k + 1) % DIM], v->close_basic[(k + 2) % DIM], row_of_adjugate);
    if (is_first)
        v->close_det = close_dot(row_of_adjugate, v->close_basic[k]);
    v->close_x[k] = close_dot(row_of_adjugate, v->close_rest);
    v->has_close |= 1u << k | CLOSE_COMMON;
}

/* As find_constant; returns its size. */
static double find_close_constant(const fmb_exact_box *v, const fmb_exact_box_goal *goal,
                                  const fmb_exact_box_number *const *cost, lane2 *sum)
{
    const fmb_exact_box_number *first =
        goal->is_world ? &v->program->origin[v->side][goal->number] : &fmb_exact_box_zero;
    double size = fabs(first->near);
    *sum = close_number(first);
    for (int j = 0; j < v->program->columns; j++)
        if (fmb_exact_box_is_one(v, j)) {
            add_close(sum, cost[j], 1);
            size += fabs(cost[j]->near);
        }
    return size;
}

/* det times the value, and what its error is in units of. False: it is a constant. */
static bool find_close_numerator(fmb_exact_box *v, const fmb_exact_box_goal *goal, lane2 *out,
                                 double *size)
{
    const fmb_exact_box_number *cost[FMB_EXACT_BOX_UNKNOWNS];
    bool varies = false;
    lane2 constant;
    *size = 0;
    fmb_exact_box_list_costs(v, goal, cost);
    for (int k = 0; k < DIM; k++) {
        fmb_exact_box_relative c = fmb_exact_box_relative_cost(v, cost, v->basic[k]);
        lane2 close = close_difference(c);
        if (close.hi == 0)
            continue;
        need_close_x(v, k);
        close = lane2_times(true, close, v->close_x[k]);
        *out = varies ? lane2_add(true, *out, close) : close;
        *size += fmb_exact_box_near_difference(c).size * v->near_x[k].size;
        varies = true;
    }
    if (!varies)
        return false;
    *size += v->near_det.size * find_close_constant(v, goal, cost, &constant);
    if (constant.hi != 0)
        *out = lane2_add(true, *out, lane2_times(true, constant, v->close_det));
    return true;
}

/* The value, and what it is off by at most. */
static bool find_close_value(fmb_exact_box *v, const fmb_exact_box_goal *goal, lane2 *value,
                             double *error)
{
    lane2 numerator;
    double size;
    if (!fmb_exact_box_is_sign_known(v->near_det) ||
        !find_close_numerator(v, goal, &numerator, &size))
        return false;
    double det = v->close_det.hi;
    *value = lane2_over(true, numerator, v->close_det, 1 / det);
    *error = 80 * LANE2_UNIT(true) * ((size + fabs(value->hi) * v->near_det.size) / fabs(det));
    if (goal->is_world && v->side == 1)
        *value = lane2_minus(*value);
    return true;
}

double fmb_exact_box_value_roughly(fmb_exact_box *v, const fmb_exact_box_goal *goal)
{
    fmb_wide numerator, denominator;
    lane2 value;
    double error;
    if (find_close_value(v, goal, &value, &error) && error <= 0x1p-53 * fabs(value.hi))
        return value.hi;
    fmb_exact_box_value(v, goal, &numerator, &denominator);
    return fmb_wide_to_double(&numerator) / fmb_wide_to_double(&denominator);
}

/* ---- outward --------------------------------------------------------------------------------- */

/* The value lies within an error of hi + lo; |lo| is at most half of the way from hi to the next
 * double. Where the error is less than |lo|, hi and the double behind it on the side of lo are
 * those next to the value. */
static bool round_closely(fmb_exact_box *v, const fmb_exact_box_goal *goal, double *out)
{
    lane2 value;
    double error;
    if (!find_close_value(v, goal, &value, &error) || !(fabs(value.lo) > error))
        return false;
    bool beyond = goal->greatest == (value.lo > 0);
    *out = beyond ? nextafter(value.hi, goal->greatest ? INFINITY : -INFINITY) : value.hi;
    return true;
}

static bool round_exactly(fmb_exact_box *v, const fmb_exact_box_goal *goal, double *out)
{
    fmb_wide numerator, denominator;
    fmb_exact_box_value(v, goal, &numerator, &denominator);
    return fmb_exact_box_round_outward(&numerator, &denominator, goal->greatest, out);
}

bool fmb_exact_box_value_outward(fmb_exact_box *v, const fmb_exact_box_goal *goal, int exponent,
                                 double *out)
{
    double x;
    if (!round_closely(v, goal, &x) && !round_exactly(v, goal, &x))
        return false;
    *out = ldexp(x, -exponent);
    return x == 0 || (fabs(*out) > 0x1p-960 && fabs(*out) < 0x1p960);
}
