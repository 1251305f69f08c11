/* certify.c: see certify.h.
 *
 * With y = c P^-1, c the relative costs of the basic unknowns, the goal is constant + sum d_j z_j
 * over the nonbasic unknowns, with reduced costs d_j = cost_j - y m_j. If each z_j is at its better
 * end by the sign of d_j, no z within its places is better. Artificial unknowns have only one end.
 * (Dantzig 1951.)
 *
 * In doubles (point.c): any y' is y - r P^-1 with r = c - y' P, so d_j computed with y' has an
 * error of r P^-1 m_j. No entry of P^-1 m_j = (I - E)^-1 R m_j is larger than twice the largest of
 * R m_j; as relative entries are at most 2, none is larger than 4 norm.
 */
#include "pair/exact_box/certify.h"

#include "pair/exact_box/exact_box_value.h"

#define DIM FMB_EXACT_BOX_DIM

#define UNIT 0x1p-53
#define SMALL                                                                                      \
    (8 * FMB_WIDE_LEAST) /* more than the absolute errors of costs and products that are small */

/* ---- apart -----------------------------------------------------------------------------------
 *
 * For any w, over all z in their places w M z lies between the sums of least and of greatest w m_j
 * z_j; where w h does not, M z = h is impossible.
 */

/* Is w h certainly greater than any w M z? */
static bool is_beyond_all(const fmb_exact_box_program *s, const double *w)
{
    double most[2] = {0, 0}, left = 0, size = 0, far = 1;
    for (int row = 0; row < s->dim; row++) {
        left += w[row] * s->h.near[row];
        size += fabs(w[row]);
    }
    for (int j = 0; j < s->columns; j++) {
        double part = 0;
        int group = s->group[j];
        const double end = s->near_end[fmb_exact_box_end_of(s, j)];
        far = end > far ? end : far;
        for (int row = 0; row < s->dim; row++)
            part += w[row] * s->m[j].near[row];
        part *= end;
        if (part > 0 && group > FMB_EXACT_BOX_OF_B)
            left -= part;
        else if (group <= FMB_EXACT_BOX_OF_B && part > most[group])
            most[group] = part;
    }
    left -= most[0] + most[1];
    return left > far * ((s->dim + s->columns + 10) * (s->columns + 1) * UNIT * size + SMALL);
}

bool fmb_exact_box_are_apart(const fmb_exact_box *v, const double *weight)
{
    const fmb_exact_box_program *s = v->program;
    double w[DIM] = {0}, less[DIM];
    for (int k = 0; v->is_near && k < s->dim; k++)
        for (int row = 0; v->basic[k] >= s->artificial && row < s->dim; row++)
            w[row] += weight[v->basic[k] - s->artificial] * v->inverse[k][row];
    for (int row = 0; row < s->dim; row++)
        less[row] = -w[row];
    return is_beyond_all(s, w) || is_beyond_all(s, less);
}

/* ---- in integers ----------------------------------------------------------------------------- */

void fmb_exact_box_find_prices(fmb_exact_box *v, const fmb_wide *const *cost, fmb_wide *y)
{
    fmb_exact_box_whole *w = v->whole;
    const fmb_wide *column[DIM];
    if (w->adjugate_of != v) {
        for (int k = 0; k < v->program->dim; k++)
            fmb_wide_copy(&w->fall[k], cost[k]);
        fmb_exact_box_solve_transposed(v, w->fall, y);
        return;
    }
    for (int row = 0; row < v->program->dim; row++) {
        for (int k = 0; k < v->program->dim; k++)
            column[k] = &w->adjugate[k][row];
        fmb_wide_dot(&y[row], v->program->dim, cost, column, 0);
    }
}

void fmb_exact_box_find_loss(fmb_exact_box *v, const fmb_wide *y, const fmb_wide *cost, int j,
                             fmb_wide *out)
{
    int n = v->program->dim;
    const fmb_wide *a[DIM + 1], *b[DIM + 1];
    fmb_exact_box_list_column(v, j, b, v->whole->column);
    for (int row = 0; row < n; row++)
        a[row] = &y[row];
    a[n] = &v->whole->det;
    b[n] = cost;
    fmb_wide_dot(out, n + 1, a, b, 1u << n);
}

/* ---- is it the end? -------------------------------------------------------------------------- */

/* Costs and prices of a goal; in integers once they are needed. */
typedef struct priced_goal {
    fmb_exact_box_cost cost[FMB_EXACT_BOX_UNKNOWNS];
    double y[DIM], size, off; /* size: the sum of |y|; off: of |r| */
    bool is_exact;            /* prices in integers are known, in v->whole */
} priced_goal;

/* cost - y m_j, not relative to a reference; its terms are the cost and others of at most size. */
static double absolute_gain(const fmb_exact_box *v, const priced_goal *g, int j)
{
    const double *m = v->program->m[j].near;
    double gain = g->cost[j].near;
    for (int row = 0; row < v->program->dim; row++)
        gain -= g->y[row] * m[row];
    return gain;
}

/* That gain relative to the reference; *error: its error bound for this y. */
static double near_gain(const fmb_exact_box *v, const priced_goal *g, int j, double *error)
{
    int reference = fmb_exact_box_reference_of(v, j);
    double gain = absolute_gain(v, g, j), size = fabs(g->cost[j].near) + g->size;
    if (reference >= 0) {
        gain -= absolute_gain(v, g, reference);
        size += fabs(g->cost[reference].near) + g->size;
    }
    *error = size > 0 ? (v->program->dim + 8) * UNIT * size + SMALL : 0;
    return gain;
}

static void find_near_prices(const fmb_exact_box *v, priced_goal *g)
{
    int n = v->program->dim;
    double error;
    for (int row = 0; row < n; row++)
        g->y[row] = 0;
    for (int k = 0; k < n; k++) {
        int j = v->basic[k], reference = fmb_exact_box_reference_of(v, j);
        double cost = g->cost[j].near - (reference < 0 ? 0 : g->cost[reference].near);
        for (int row = 0; cost != 0 && row < n; row++)
            g->y[row] += cost * v->inverse[k][row];
    }
    g->off = g->size = 0;
    for (int row = 0; row < n; row++)
        g->size += fabs(g->y[row]);
    for (int k = 0; k < n; k++)
        g->off += fabs(near_gain(v, g, v->basic[k], &error)) + error;
}

static int exact_sign_of_loss(fmb_exact_box *v, priced_goal *g, int j)
{
    fmb_wide loss, *room = v->whole->cost;
    const fmb_wide *cost[DIM];
    for (int k = 0; !g->is_exact && k < v->program->dim; k++)
        cost[k] = fmb_exact_box_relative_cost(v, g->cost, v->basic[k], &room[k]);
    if (!g->is_exact)
        fmb_exact_box_find_prices(v, cost, v->whole->price);
    g->is_exact = true;
    fmb_exact_box_find_loss(v, v->whole->price,
                            fmb_exact_box_relative_cost(v, g->cost, j, &room[0]), j, &loss);
    return fmb_wide_sign(&loss);
}

static int sign_of_loss(fmb_exact_box *v, priced_goal *g, int j)
{
    double error, gain;
    if (v->is_near) {
        gain = near_gain(v, g, j, &error);
        error = (error + 4 * v->norm * g->off) * (1 + 0x1p-40);
        if (fabs(gain) > error || error == 0)
            return (gain < 0) - (gain > 0);
    }
    return exact_sign_of_loss(v, g, j);
}

bool fmb_exact_box_is_farthest(fmb_exact_box *v, const fmb_exact_box_goal *goal)
{
    priced_goal g;
    bool turned = goal->is_world && v->side == 1;
    int upward = goal->greatest != turned ? 1 : -1;
    g.is_exact = false;
    fmb_exact_box_list_costs(v, goal, g.cost);
    if (v->is_near)
        find_near_prices(v, &g);
    for (int j = 0; j < v->program->artificial; j++) {
        int place = v->basis.place[j];
        if (place == FMB_EXACT_BOX_BASIC || v->program->group[j] == FMB_EXACT_BOX_NONE)
            continue;
        if (sign_of_loss(v, &g, j) == (place == FMB_EXACT_BOX_HIGH ? upward : -upward))
            return false;
    }
    return true;
}
