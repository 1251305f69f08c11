/* certify.c: see certify.h.
 *
 * With y = c P^-1, c the relative costs of the basic unknowns, the goal is constant + sum d_j z_j
 * over the unknowns that are not basic, d_j = cost_j - y m_j. Where each d_j is such that z_j is at
 * its better end, no z in its places is better. Artificial unknowns have but one end. (Dantzig
 * 1951.)
 *
 * Errors of doubles, u = 2^-53, as shares of sizes: entries and costs are off by 4 u; relative ones
 * by 5 u; minors by 2 * 5 u + 2 u = 12 u; det by 12 u + 5 u + 3 u = 20 u; rest, a sum of at most
 * 10, by 13 u; x by 12 u + 13 u + 3 u = 28 u; what remains of a simplex by 31 u; y by 5 u + 12 u +
 * 3 u = 20 u; d by 20 u + 5 u + 4 u = 29 u. Sizes are sums and products of positive numbers, off by
 * less than 16 u of themselves. All of it is within 64 u = 2^-47. As all numbers are whole, and
 * less than 2^700, nothing overflows or underflows.
 */
#include "pair/extreme/certify.h"

#include <string.h>

enum { DIM = FMB_EXTREME_DIM };

typedef fmb_extreme_near near;

/* ---- columns and costs ----------------------------------------------------------------------- */

/* The reference that unknown j is relative to, or -1. */
static int reference_of(const fmb_extreme *v, int j)
{
    int group = j < 0 ? FMB_EXTREME_NONE : v->program->group[j];
    return group <= FMB_EXTREME_OF_B ? v->reference[group] : -1;
}

typedef fmb_extreme_number number;

static const number zero = {{0, false, {0}}, 0}, one = {{1, false, {1}}, 1};

/* Of the slacks, and of no unknown (-1), they are 0. */
static const number *entry_of_column(const fmb_extreme_program *s, int j, int row)
{
    if (j >= FMB_EXTREME_ARTIFICIAL)
        return j - FMB_EXTREME_ARTIFICIAL == row ? &one : &zero;
    return j >= 0 && j < FMB_EXTREME_COLUMNS ? &s->m[j][row] : &zero;
}

/* What one unit of unknown j adds to the goal. In coordinates of B goals of the world have the
 * other sign: - x_i = - origin of B + (- axes of B, - speed of B) z + the artificial unknown of row
 * i, which tells how far the two are apart. */
static const number *cost_of_unknown(const fmb_extreme *v, const fmb_extreme_goal *goal, int j)
{
    const fmb_extreme_program *s = v->program;
    if (!goal->is_world)
        return j == goal->number ? &one : &zero;
    if (v->side == 1 && j == FMB_EXTREME_ARTIFICIAL + goal->number)
        return &one;
    if (j < 0 || j >= s->columns)
        return &zero;
    if (j == s->time)
        return &s->speed[v->side][goal->number];
    return (j < s->first_of_b) == (v->side == 0) ? &s->m[j][goal->number] : &zero;
}

/* a - b */
typedef struct relative {
    const number *a, *b;
} relative;

static relative relative_entry(const fmb_extreme *v, int j, int row)
{
    return (relative){entry_of_column(v->program, j, row),
                      entry_of_column(v->program, reference_of(v, j), row)};
}

static relative relative_cost(const fmb_extreme *v, const fmb_extreme_goal *goal, int j)
{
    return (relative){cost_of_unknown(v, goal, j), cost_of_unknown(v, goal, reference_of(v, j))};
}

/* It lies at x->a, or in *room. */
static const fmb_wide *exact_difference(relative x, fmb_wide *room)
{
    if (x.b->whole.n == 0)
        return &x.a->whole;
    fmb_wide_copy(room, &x.a->whole);
    fmb_wide_subtract(room, &x.b->whole);
    return room;
}

/* ---- in doubles ------------------------------------------------------------------------------ */

static near near_difference(relative x)
{
    return (near){x.a->near - x.b->near, fabs(x.a->near) + fabs(x.b->near)};
}

/* sum += a b */
static void add_near_product(near *sum, near a, near b)
{
    sum->x += a.x * b.x;
    sum->size += a.size * b.size;
}

/* What has no size is 0. */
static bool is_sign_known(near a)
{
    return fabs(a.x) > 0x1p-47 * a.size || a.size == 0;
}

static int sign_of_near(near a)
{
    return (a.x > 0) - (a.x < 0);
}

/* Row k of the adjugate is the cross product of the two other columns. */
static void find_near_adjugate(fmb_extreme *v)
{
    for (int k = 0; k < DIM; k++)
        for (int row = 0; row < DIM; row++)
            v->near_column[k][row] = near_difference(relative_entry(v, v->basic[k], row));
    for (int k = 0; k < DIM; k++) {
        const near *a = v->near_column[(k + 1) % DIM], *b = v->near_column[(k + 2) % DIM];
        for (int row = 0; row < DIM; row++) {
            int i = (row + 1) % DIM, j = (row + 2) % DIM;
            v->near_adjugate[k][row] = (near){a[i].x * b[j].x - a[j].x * b[i].x,
                                              a[i].size * b[j].size + a[j].size * b[i].size};
        }
    }
    v->near_det = (near){0, 0};
    for (int row = 0; row < DIM; row++)
        add_near_product(&v->near_det, v->near_adjugate[0][row], v->near_column[0][row]);
}

/* Does the column of unknown j stand in the equations once, whatever the basic unknowns are? */
static bool is_one(const fmb_extreme *v, int j)
{
    return v->basis.place[j] == FMB_EXTREME_HIGH || j == v->reference[0] || j == v->reference[1];
}

static void find_near_values(fmb_extreme *v)
{
    const fmb_extreme_program *s = v->program;
    near rest[DIM];
    for (int row = 0; row < DIM; row++) {
        rest[row] = (near){s->h[row].near, fabs(s->h[row].near)};
        for (int j = 0; j < s->columns; j++)
            if (is_one(v, j)) {
                rest[row].x -= s->m[j][row].near;
                rest[row].size += fabs(s->m[j][row].near);
            }
    }
    v->near_reference[0] = v->near_reference[1] = v->near_det;
    for (int k = 0; k < DIM; k++) {
        int group = s->group[v->basic[k]];
        v->near_x[k] = (near){0, 0};
        for (int row = 0; row < DIM; row++)
            add_near_product(&v->near_x[k], v->near_adjugate[k][row], rest[row]);
        if (group <= FMB_EXTREME_OF_B)
            add_near_product(&v->near_reference[group], v->near_x[k], (near){-1, 1});
    }
}

/* ---- in integers ----------------------------------------------------------------------------- */

static void need_row_of_adjugate(fmb_extreme *v, int k)
{
    fmb_wide room[2][DIM];
    const fmb_wide *a[DIM], *b[DIM];
    if (v->has_row >> k & 1)
        return;
    for (int row = 0; row < DIM; row++) {
        a[row] = exact_difference(relative_entry(v, v->basic[(k + 1) % DIM], row), &room[0][row]);
        b[row] = exact_difference(relative_entry(v, v->basic[(k + 2) % DIM], row), &room[1][row]);
    }
    for (int row = 0; row < DIM; row++) {
        int i = (row + 1) % DIM, j = (row + 2) % DIM;
        fmb_wide_multiply(&v->adjugate[k][row], a[i], b[j]);
        fmb_wide_subtract_product(&v->adjugate[k][row], a[j], b[i]);
    }
    v->has_row |= 1u << k;
}

static void need_det(fmb_extreme *v)
{
    fmb_wide room;
    int k = v->has_row == 0 ? 0 : __builtin_ctz(v->has_row);
    if (v->has_det)
        return;
    need_row_of_adjugate(v, k);
    fmb_wide_set_word(&v->det, 0);
    for (int row = 0; row < DIM; row++)
        fmb_wide_add_product(&v->det, &v->adjugate[k][row],
                             exact_difference(relative_entry(v, v->basic[k], row), &room));
    v->has_det = true;
}

/* h less the columns that count once. */
static void need_rest(fmb_extreme *v)
{
    const fmb_extreme_program *s = v->program;
    for (int row = 0; row < DIM && !v->has_rest; row++) {
        fmb_wide_copy(&v->rest[row], &s->h[row].whole);
        for (int j = 0; j < s->columns; j++)
            if (is_one(v, j))
                fmb_wide_subtract(&v->rest[row], &s->m[j][row].whole);
    }
    v->has_rest = true;
}

static void need_x(fmb_extreme *v, int k)
{
    if (v->has_x >> k & 1)
        return;
    need_row_of_adjugate(v, k);
    need_rest(v);
    fmb_wide_set_word(&v->x[k], 0);
    for (int row = 0; row < DIM; row++)
        fmb_wide_add_product(&v->x[k], &v->adjugate[k][row], &v->rest[row]);
    v->has_x |= 1u << k;
}

/* ---- signs ----------------------------------------------------------------------------------- */

static int sign_of_det(fmb_extreme *v)
{
    if (is_sign_known(v->near_det))
        return sign_of_near(v->near_det);
    need_det(v);
    return fmb_wide_sign(&v->det);
}

static int sign_of_x(fmb_extreme *v, int k)
{
    if (is_sign_known(v->near_x[k]))
        return sign_of_near(v->near_x[k]);
    need_x(v, k);
    return fmb_wide_sign(&v->x[k]);
}

/* Of det - the x in a group; in that of units, but one of them. */
static int sign_of_remainder(fmb_extreme *v, near guess, int group, int only)
{
    fmb_wide sum;
    if (is_sign_known(guess))
        return sign_of_near(guess);
    need_det(v);
    fmb_wide_copy(&sum, &v->det);
    for (int k = 0; k < DIM; k++)
        if (k == only || (only < 0 && v->program->group[v->basic[k]] == group)) {
            need_x(v, k);
            fmb_wide_subtract(&sum, &v->x[k]);
        }
    return fmb_wide_sign(&sum);
}

/* sign: of det. */
static bool is_basic_in_place(fmb_extreme *v, int k, int sign)
{
    int group = v->program->group[v->basic[k]], of_x = sign_of_x(v, k);
    near over = {v->near_det.x - v->near_x[k].x, v->near_det.size + v->near_x[k].size};
    if (group == FMB_EXTREME_ZERO)
        return of_x == 0;
    return of_x != -sign &&
           (group != FMB_EXTREME_UNIT || sign_of_remainder(v, over, group, k) != -sign);
}

static bool are_all_in_place(fmb_extreme *v)
{
    int sign = sign_of_det(v);
    bool good = sign != 0;
    for (int k = 0; good && k < DIM; k++)
        good = is_basic_in_place(v, k, sign);
    for (int group = 0; good && group < 2; group++)
        good = v->reference[group] < 0 ||
               sign_of_remainder(v, v->near_reference[group], group, -1) != -sign;
    return good;
}

/* ---- the basic solution ---------------------------------------------------------------------- */

/* The slack is the best reference: its column is 0. False: not as many as there are equations. */
static bool list_basic_unknowns(fmb_extreme *v)
{
    const fmb_extreme_program *s = v->program;
    int n = 0, of[2] = {0, 0};
    v->reference[0] = v->reference[1] = -1;
    for (int j = FMB_EXTREME_UNKNOWNS - 1; j >= 0; j--) {
        int group = s->group[j];
        if (v->basis.place[j] != FMB_EXTREME_BASIC)
            continue;
        if (group <= FMB_EXTREME_OF_B && v->reference[group] < 0) {
            v->reference[group] = j;
            continue;
        }
        if (n < DIM)
            v->basic[n] = j;
        n++;
        of[0] += j < s->first_of_b || j == FMB_EXTREME_SLACK;
        of[1] +=
            (j >= s->first_of_b && j < s->columns && j != s->time) || j == FMB_EXTREME_SLACK + 1;
    }
    v->side = of[1] < of[0];
    return n == DIM && s->is_simplex[0] == (v->reference[0] >= 0) &&
           s->is_simplex[1] == (v->reference[1] >= 0);
}

bool fmb_extreme_stand(fmb_extreme *v, const fmb_extreme_program *s, const fmb_extreme_basis *basis)
{
    v->program = s;
    v->basis = *basis;
    v->has_row = v->has_x = 0;
    v->has_det = v->has_rest = false;
    if (!list_basic_unknowns(v))
        return false;
    find_near_adjugate(v);
    find_near_values(v);
    return are_all_in_place(v);
}

void fmb_extreme_near_values(const fmb_extreme *v, double *z)
{
    for (int j = 0; j < v->program->columns; j++)
        z[j] = v->basis.place[j] == FMB_EXTREME_HIGH;
    for (int group = 0; group < 2; group++)
        if (v->reference[group] >= 0 && v->reference[group] < FMB_EXTREME_COLUMNS)
            z[v->reference[group]] = v->near_reference[group].x / v->near_det.x;
    for (int k = 0; k < DIM; k++)
        if (v->basic[k] < FMB_EXTREME_COLUMNS)
            z[v->basic[k]] = v->near_x[k].x / v->near_det.x;
}

/* ---- is it the end? -------------------------------------------------------------------------- */

/* y det */
static void find_near_prices(const fmb_extreme *v, const fmb_extreme_goal *goal, near *y)
{
    for (int row = 0; row < DIM; row++)
        y[row] = (near){0, 0};
    for (int k = 0; k < DIM; k++) {
        near c = near_difference(relative_cost(v, goal, v->basic[k]));
        for (int row = 0; c.size != 0 && row < DIM; row++)
            add_near_product(&y[row], c, v->near_adjugate[k][row]);
    }
}

/* - d_j det */
static near find_near_loss(const fmb_extreme *v, const fmb_extreme_goal *goal, const near *y, int j)
{
    near cost = near_difference(relative_cost(v, goal, j)), loss = {0, 0};
    add_near_product(&loss, v->near_det, (near){-cost.x, cost.size});
    for (int row = 0; row < DIM; row++)
        add_near_product(&loss, y[row], near_difference(relative_entry(v, j, row)));
    return loss;
}

static void find_prices(fmb_extreme *v, const fmb_extreme_goal *goal, fmb_wide *y)
{
    fmb_wide room;
    for (int row = 0; row < DIM; row++)
        fmb_wide_set_word(&y[row], 0);
    for (int k = 0; k < DIM; k++) {
        const fmb_wide *cost = exact_difference(relative_cost(v, goal, v->basic[k]), &room);
        need_row_of_adjugate(v, k);
        for (int row = 0; row < DIM; row++)
            fmb_wide_add_product(&y[row], cost, &v->adjugate[k][row]);
    }
}

static int exact_sign_of_loss(fmb_extreme *v, const fmb_extreme_goal *goal, int j)
{
    fmb_wide y[DIM], loss, room;
    find_prices(v, goal, y);
    need_det(v);
    fmb_wide_multiply(&loss, exact_difference(relative_cost(v, goal, j), &room), &v->det);
    fmb_wide_negate(&loss);
    for (int row = 0; row < DIM; row++)
        fmb_wide_add_product(&loss, &y[row], exact_difference(relative_entry(v, j, row), &room));
    return fmb_wide_sign(&loss);
}

bool fmb_extreme_is_farthest(fmb_extreme *v, const fmb_extreme_goal *goal)
{
    near y[DIM];
    bool turned = goal->is_world && v->side == 1;
    int sign_det = sign_of_det(v), upward = (goal->greatest != turned ? 1 : -1) * sign_det;
    find_near_prices(v, goal, y);
    for (int j = 0; j < FMB_EXTREME_ARTIFICIAL; j++) {
        int place = v->basis.place[j];
        if (place == FMB_EXTREME_BASIC || v->program->group[j] == FMB_EXTREME_NONE)
            continue;
        near loss = find_near_loss(v, goal, y, j);
        int sign = is_sign_known(loss) ? sign_of_near(loss) : exact_sign_of_loss(v, goal, j);
        if (sign == (place == FMB_EXTREME_HIGH ? upward : -upward))
            return false;
    }
    return true;
}

/* ---- values ---------------------------------------------------------------------------------- */

static void find_constant(const fmb_extreme *v, const fmb_extreme_goal *goal, fmb_wide *out)
{
    const fmb_extreme_program *s = v->program;
    fmb_wide_copy(out, &(goal->is_world ? &s->origin[v->side][goal->number] : &zero)->whole);
    for (int j = 0; j < s->columns; j++)
        if (is_one(v, j))
            fmb_wide_add(out, &cost_of_unknown(v, goal, j)->whole);
}

void fmb_extreme_value(fmb_extreme *v, const fmb_extreme_goal *goal, fmb_wide *numerator,
                       fmb_wide *denominator)
{
    fmb_wide constant, room[DIM];
    const fmb_wide *cost[DIM];
    bool is_whole = true;
    find_constant(v, goal, &constant);
    for (int k = 0; k < DIM; k++) {
        cost[k] = exact_difference(relative_cost(v, goal, v->basic[k]), &room[k]);
        is_whole = is_whole && cost[k]->n == 0;
        if (cost[k]->n != 0)
            need_x(v, k);
    }
    if (!is_whole)
        need_det(v);
    fmb_wide_copy(denominator, is_whole ? &one.whole : &v->det);
    fmb_wide_multiply(numerator, &constant, denominator);
    for (int k = 0; k < DIM; k++)
        if (cost[k]->n != 0)
            fmb_wide_add_product(numerator, cost[k], &v->x[k]);
    if (goal->is_world && v->side == 1)
        fmb_wide_negate(numerator);
    if (denominator->minus) {
        fmb_wide_negate(denominator);
        fmb_wide_negate(numerator);
    }
}
