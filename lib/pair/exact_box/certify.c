/* certify.c: see certify.h.
 *
 * With y = c P^-1, c the relative costs of the basic unknowns, the goal is constant + sum d_j z_j
 * over the unknowns that are not basic, d_j = cost_j - y m_j. Where each d_j is such that z_j is at
 * its better end, no z in its places is better. Artificial unknowns have but one end. (Dantzig
 * 1951.)
 */
#include "pair/exact_box/certify.h"

#include "pair/exact_box/exact_box_value.h"

enum { DIM = FMB_EXACT_BOX_DIM };

typedef fmb_exact_box_near near;

/* ---- apart -----------------------------------------------------------------------------------
 *
 * For any w, over all z in their places w M z lies between the sums of least and of greatest w m_j
 * z_j; where w h does not, M z = h is impossible.
 */

/* The least exponent of a weight. */
static int find_least_exponent(const double *weight)
{
    int least = INT32_MAX;
    for (int row = 0; row < DIM; row++)
        if (weight[row] != 0 && ilogb(weight[row]) < least)
            least = ilogb(weight[row]);
    return least;
}

/* The rows of the adjugate are, but for det, what artificial unknowns are made of. */
static void find_direction(fmb_exact_box *v, const double *weight, fmb_wide *w)
{
    int least = find_least_exponent(weight);
    fmb_wide part;
    for (int row = 0; row < DIM; row++)
        fmb_wide_set_word(&w[row], 0);
    for (int k = 0; k < DIM; k++) {
        int j = v->basic[k] - FMB_EXACT_BOX_ARTIFICIAL;
        if (j < 0 || weight[j] == 0)
            continue;
        fmb_exact_box_need_row(v, k);
        for (int row = 0; row < DIM; row++) {
            fmb_wide_copy(&part, &v->adjugate[k][row]);
            fmb_wide_shift(&part, ilogb(weight[j]) - least);
            fmb_wide_gather(&w[row], &part, weight[j] < 0);
        }
    }
}

/* *most = max(*most, x) */
static void raise_to(fmb_wide *most, const fmb_wide *x)
{
    if (fmb_wide_compare(x, most) > 0)
        fmb_wide_copy(most, x);
}

static void list_numbers(const fmb_exact_box_number x[DIM], const fmb_wide *out[DIM])
{
    for (int row = 0; row < DIM; row++)
        out[row] = &x[row].whole;
}

/* Is w h greater than any w M z? */
static bool is_beyond_all(const fmb_exact_box_program *s, const fmb_wide *w)
{
    fmb_wide most[2], sum, part;
    const fmb_wide *const of_w[DIM] = {&w[0], &w[1], &w[2]}, *factor[DIM];
    fmb_wide_set_word(&most[0], 0);
    fmb_wide_set_word(&most[1], 0);
    list_numbers(s->h, factor);
    fmb_wide_dot(&sum, DIM, of_w, factor, (1 << DIM) - 1);
    for (int j = 0; j < s->columns; j++) {
        int group = s->group[j];
        list_numbers(s->m[j], factor);
        fmb_wide_dot(&part, DIM, of_w, factor, 0);
        if (group <= FMB_EXACT_BOX_OF_B)
            raise_to(&most[group], &part);
        else if (!part.minus)
            fmb_wide_add(&sum, &part);
    }
    fmb_wide_add(&sum, &most[0]);
    fmb_wide_add(&sum, &most[1]);
    return fmb_wide_sign(&sum) < 0;
}

bool fmb_exact_box_are_apart(fmb_exact_box *v, const fmb_exact_box_program *s,
                             const fmb_exact_box_basis *basis, const double *weight)
{
    fmb_wide w[DIM];
    if (!fmb_exact_box_take_basis(v, s, basis))
        return false;
    find_direction(v, weight, w);
    bool apart = is_beyond_all(s, w);
    for (int row = 0; row < DIM; row++)
        fmb_wide_negate(&w[row]);
    return apart || is_beyond_all(s, w);
}

/* ---- is it the end? -------------------------------------------------------------------------- */

static near find_near_cost(const fmb_exact_box *v, const fmb_exact_box_number *const *cost, int j)
{
    return fmb_exact_box_near_difference(fmb_exact_box_relative_cost(v, cost, j));
}

/* y det */
static void find_near_prices(const fmb_exact_box *v, const fmb_exact_box_number *const *cost,
                             near *y)
{
    for (int row = 0; row < DIM; row++)
        y[row] = (near){0, 0};
    for (int k = 0; k < DIM; k++) {
        near of_basic = find_near_cost(v, cost, v->basic[k]);
        for (int row = 0; of_basic.size != 0 && row < DIM; row++)
            fmb_exact_box_add_product(&y[row], of_basic, v->near_adjugate[k][row]);
    }
}

/* - d_j det */
static near find_near_loss(const fmb_exact_box *v, near cost, const near *y, int j)
{
    near loss = {0, 0};
    fmb_exact_box_add_product(&loss, v->near_det, (near){-cost.x, cost.size});
    for (int row = 0; row < DIM; row++)
        fmb_exact_box_add_product(&loss, y[row], v->near_entry[j][row]);
    return loss;
}

static void find_prices(fmb_exact_box *v, const fmb_exact_box_number *const *cost, fmb_wide *y)
{
    fmb_wide room[DIM];
    const fmb_wide *factor[DIM];
    for (int k = 0; k < DIM; k++) {
        factor[k] =
            fmb_exact_box_difference(fmb_exact_box_relative_cost(v, cost, v->basic[k]), &room[k]);
        fmb_exact_box_need_row(v, k);
    }
    for (int row = 0; row < DIM; row++)
        fmb_wide_dot(&y[row], DIM, factor,
                     (const fmb_wide *const[]){&v->adjugate[0][row], &v->adjugate[1][row],
                                               &v->adjugate[2][row]},
                     0);
}

static int exact_sign_of_loss(fmb_exact_box *v, const fmb_exact_box_number *const *cost, int j)
{
    fmb_wide y[DIM], loss, room[DIM + 1];
    const fmb_wide *a[DIM + 1], *b[DIM + 1];
    find_prices(v, cost, y);
    fmb_exact_box_need_det(v);
    for (int row = 0; row < DIM; row++) {
        a[row] = &y[row];
        b[row] = fmb_exact_box_difference(fmb_exact_box_relative_entry(v, j, row), &room[row]);
    }
    a[DIM] = &v->det;
    b[DIM] = fmb_exact_box_difference(fmb_exact_box_relative_cost(v, cost, j), &room[DIM]);
    fmb_wide_dot(&loss, DIM + 1, a, b, 1 << DIM);
    return fmb_wide_sign(&loss);
}

bool fmb_exact_box_is_farthest(fmb_exact_box *v, const fmb_exact_box_goal *goal)
{
    const fmb_exact_box_number *cost[FMB_EXACT_BOX_UNKNOWNS];
    near y[DIM];
    bool turned = goal->is_world && v->side == 1;
    int sign_det = fmb_exact_box_sign_of_det(v),
        upward = (goal->greatest != turned ? 1 : -1) * sign_det;
    fmb_exact_box_list_costs(v, goal, cost);
    find_near_prices(v, cost, y);
    for (int j = 0; j < FMB_EXACT_BOX_ARTIFICIAL; j++) {
        int place = v->basis.place[j];
        if (place == FMB_EXACT_BOX_BASIC || v->program->group[j] == FMB_EXACT_BOX_NONE)
            continue;
        near loss = find_near_loss(v, find_near_cost(v, cost, j), y, j);
        int sign = fmb_exact_box_is_sign_known(loss) ? fmb_exact_box_sign_of_near(loss)
                                                     : exact_sign_of_loss(v, cost, j);
        if (sign == (place == FMB_EXACT_BOX_HIGH ? upward : -upward))
            return false;
    }
    return true;
}
