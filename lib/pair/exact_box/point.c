/* point.c: see point.h.
 *
 * Errors of doubles, u = 2^-53, as shares of sizes: entries and costs are off by 4 u; relative ones
 * by 5 u; minors by 2 * 5 u + 2 u = 12 u; det by 12 u + 5 u + 3 u = 20 u; rest, a sum of at most
 * 10, by 13 u; x by 12 u + 13 u + 3 u = 28 u; what remains of a simplex by 31 u; y by 5 u + 12 u +
 * 3 u = 20 u; d by 20 u + 5 u + 4 u = 29 u. Sizes are sums and products of positive numbers, off by
 * less than 16 u of themselves. All of it is within 64 u = 2^-47. As all numbers are whole, and
 * less than 2^700, nothing overflows or underflows.
 */
#include "pair/exact_box/point.h"

enum { DIM = FMB_EXACT_BOX_DIM };

typedef fmb_exact_box_near near;

/* ---- columns and costs ----------------------------------------------------------------------- */

#define ZERO                                                                                       \
    {                                                                                              \
        {0, false, {0}}, 0, 0                                                                      \
    }
#define ONE                                                                                        \
    {                                                                                              \
        {1, false, {1}}, 1, 0                                                                      \
    }

const fmb_exact_box_number fmb_exact_box_zero = ZERO, fmb_exact_box_one = ONE;

static const fmb_exact_box_number ZERO_COLUMN[DIM] = {ZERO, ZERO, ZERO},
                                  UNIT_COLUMN[DIM][DIM] = {
                                      {ONE, ZERO, ZERO}, {ZERO, ONE, ZERO}, {ZERO, ZERO, ONE}};

/* Of the slacks, and of no unknown (-1), it is 0. */
static const fmb_exact_box_number *column_of_unknown(const fmb_exact_box_program *s, int j)
{
    if (j >= FMB_EXACT_BOX_ARTIFICIAL)
        return UNIT_COLUMN[j - FMB_EXACT_BOX_ARTIFICIAL];
    return j >= 0 && j < FMB_EXACT_BOX_COLUMNS ? s->m[j] : ZERO_COLUMN;
}

fmb_exact_box_relative fmb_exact_box_relative_entry(const fmb_exact_box *v, int j, int row)
{
    return (fmb_exact_box_relative){
        column_of_unknown(v->program, j) + row,
        column_of_unknown(v->program, fmb_exact_box_reference_of(v, j)) + row};
}

/* ---- in doubles ------------------------------------------------------------------------------ */

/* Of artificial unknowns only those that are basic are looked at. */
static void find_near_entries(fmb_exact_box *v)
{
    const fmb_exact_box_program *s = v->program;
    for (int j = 0; j < FMB_EXACT_BOX_UNKNOWNS; j++) {
        if (s->group[j] == FMB_EXACT_BOX_NONE ||
            (j >= FMB_EXACT_BOX_ARTIFICIAL && v->basis.place[j] != FMB_EXACT_BOX_BASIC))
            continue;
        const fmb_exact_box_number *a = column_of_unknown(s, j),
                                   *b = column_of_unknown(s, fmb_exact_box_reference_of(v, j));
        for (int row = 0; row < DIM; row++)
            v->near_entry[j][row] =
                fmb_exact_box_near_difference((fmb_exact_box_relative){&a[row], &b[row]});
    }
}

/* Row k of the adjugate is the cross product of the two other columns. */
static void find_near_adjugate(fmb_exact_box *v)
{
    for (int k = 0; k < DIM; k++) {
        const near *a = v->near_entry[v->basic[(k + 1) % DIM]],
                   *b = v->near_entry[v->basic[(k + 2) % DIM]];
        for (int row = 0; row < DIM; row++) {
            int i = (row + 1) % DIM, j = (row + 2) % DIM;
            v->near_adjugate[k][row] = (near){a[i].x * b[j].x - a[j].x * b[i].x,
                                              a[i].size * b[j].size + a[j].size * b[i].size};
        }
    }
    v->near_det = (near){0, 0};
    for (int row = 0; row < DIM; row++)
        fmb_exact_box_add_product(&v->near_det, v->near_adjugate[0][row],
                                  v->near_entry[v->basic[0]][row]);
}

static void find_near_values(fmb_exact_box *v)
{
    const fmb_exact_box_program *s = v->program;
    near rest[DIM];
    for (int row = 0; row < DIM; row++) {
        rest[row] = (near){s->h[row].near, fabs(s->h[row].near)};
        for (int j = 0; j < s->columns; j++)
            if (fmb_exact_box_is_one(v, j)) {
                rest[row].x -= s->m[j][row].near;
                rest[row].size += fabs(s->m[j][row].near);
            }
    }
    v->near_reference[0] = v->near_reference[1] = v->near_det;
    for (int k = 0; k < DIM; k++) {
        int group = s->group[v->basic[k]];
        v->near_x[k] = (near){0, 0};
        for (int row = 0; row < DIM; row++)
            fmb_exact_box_add_product(&v->near_x[k], v->near_adjugate[k][row], rest[row]);
        if (group <= FMB_EXACT_BOX_OF_B)
            fmb_exact_box_add_product(&v->near_reference[group], v->near_x[k], (near){-1, 1});
    }
}

/* ---- in integers ----------------------------------------------------------------------------- */

void fmb_exact_box_need_row(fmb_exact_box *v, int k)
{
    fmb_wide room[2][DIM];
    const fmb_wide *a[DIM], *b[DIM];
    if (v->has_row >> k & 1)
        return;
    for (int row = 0; row < DIM; row++) {
        a[row] = fmb_exact_box_difference(
            fmb_exact_box_relative_entry(v, v->basic[(k + 1) % DIM], row), &room[0][row]);
        b[row] = fmb_exact_box_difference(
            fmb_exact_box_relative_entry(v, v->basic[(k + 2) % DIM], row), &room[1][row]);
    }
    for (int row = 0; row < DIM; row++) {
        int i = (row + 1) % DIM, j = (row + 2) % DIM;
        fmb_wide_cross(&v->adjugate[k][row], a[i], b[j], a[j], b[i]);
    }
    v->has_row |= 1u << k;
}

/* Row k of the adjugate, as what fmb_wide_dot takes. */
static void list_row(const fmb_exact_box *v, int k, const fmb_wide *row[DIM])
{
    for (int j = 0; j < DIM; j++)
        row[j] = &v->adjugate[k][j];
}

void fmb_exact_box_need_det(fmb_exact_box *v)
{
    fmb_wide room[DIM];
    const fmb_wide *row[DIM], *column[DIM];
    int k = v->has_row == 0 ? 0 : __builtin_ctz(v->has_row);
    if (v->has_det)
        return;
    fmb_exact_box_need_row(v, k);
    list_row(v, k, row);
    for (int j = 0; j < DIM; j++)
        column[j] =
            fmb_exact_box_difference(fmb_exact_box_relative_entry(v, v->basic[k], j), &room[j]);
    fmb_wide_dot(&v->det, DIM, row, column, 0);
    v->has_det = true;
}

/* h less the columns that count once. */
static void need_rest(fmb_exact_box *v)
{
    const fmb_exact_box_program *s = v->program;
    for (int row = 0; row < DIM && !v->has_rest; row++) {
        fmb_wide_copy(&v->rest[row], &s->h[row].whole);
        for (int j = 0; j < s->columns; j++)
            if (fmb_exact_box_is_one(v, j))
                fmb_wide_subtract(&v->rest[row], &s->m[j][row].whole);
    }
    v->has_rest = true;
}

void fmb_exact_box_need_x(fmb_exact_box *v, int k)
{
    const fmb_wide *row[DIM];
    if (v->has_x >> k & 1)
        return;
    fmb_exact_box_need_row(v, k);
    need_rest(v);
    list_row(v, k, row);
    fmb_wide_dot(&v->x[k], DIM, row,
                 (const fmb_wide *const[]){&v->rest[0], &v->rest[1], &v->rest[2]}, 0);
    v->has_x |= 1u << k;
}

/* ---- signs ----------------------------------------------------------------------------------- */

int fmb_exact_box_sign_of_det(fmb_exact_box *v)
{
    if (fmb_exact_box_is_sign_known(v->near_det))
        return fmb_exact_box_sign_of_near(v->near_det);
    fmb_exact_box_need_det(v);
    return fmb_wide_sign(&v->det);
}

static int sign_of_x(fmb_exact_box *v, int k)
{
    if (fmb_exact_box_is_sign_known(v->near_x[k]))
        return fmb_exact_box_sign_of_near(v->near_x[k]);
    fmb_exact_box_need_x(v, k);
    return fmb_wide_sign(&v->x[k]);
}

/* Of det - the x in a group; in that of units, but one of them. */
static int sign_of_remainder(fmb_exact_box *v, near guess, int group, int only)
{
    fmb_wide sum;
    if (fmb_exact_box_is_sign_known(guess))
        return fmb_exact_box_sign_of_near(guess);
    fmb_exact_box_need_det(v);
    fmb_wide_copy(&sum, &v->det);
    for (int k = 0; k < DIM; k++)
        if (k == only || (only < 0 && v->program->group[v->basic[k]] == group)) {
            fmb_exact_box_need_x(v, k);
            fmb_wide_subtract(&sum, &v->x[k]);
        }
    return fmb_wide_sign(&sum);
}

/* sign: of det. */
static bool is_basic_in_place(fmb_exact_box *v, int k, int sign)
{
    int group = v->program->group[v->basic[k]], of_x = sign_of_x(v, k);
    near over = {v->near_det.x - v->near_x[k].x, v->near_det.size + v->near_x[k].size};
    if (group == FMB_EXACT_BOX_ZERO)
        return of_x == 0;
    return of_x != -sign &&
           (group != FMB_EXACT_BOX_UNIT || sign_of_remainder(v, over, group, k) != -sign);
}

static bool are_all_in_place(fmb_exact_box *v)
{
    int sign = fmb_exact_box_sign_of_det(v);
    bool good = sign != 0;
    for (int k = 0; good && k < DIM; k++)
        good = is_basic_in_place(v, k, sign);
    for (int group = 0; good && group < 2; group++)
        good = v->reference[group] < 0 ||
               sign_of_remainder(v, v->near_reference[group], group, -1) != -sign;
    return good;
}

/* ---- the basic solution ---------------------------------------------------------------------- */

/* The slack is the best reference: its column is 0. */
static bool list_basic_unknowns(fmb_exact_box *v)
{
    const fmb_exact_box_program *s = v->program;
    int n = 0, of[2] = {0, 0};
    v->reference[0] = v->reference[1] = -1;
    for (int j = FMB_EXACT_BOX_UNKNOWNS - 1; j >= 0; j--) {
        int group = s->group[j];
        if (v->basis.place[j] != FMB_EXACT_BOX_BASIC)
            continue;
        if (group <= FMB_EXACT_BOX_OF_B && v->reference[group] < 0) {
            v->reference[group] = j;
            continue;
        }
        if (n < DIM)
            v->basic[n] = j;
        n++;
        of[0] += j < s->first_of_b || j == FMB_EXACT_BOX_SLACK;
        of[1] +=
            (j >= s->first_of_b && j < s->columns && j != s->time) || j == FMB_EXACT_BOX_SLACK + 1;
    }
    v->side = of[1] < of[0];
    return n == DIM && s->is_simplex[0] == (v->reference[0] >= 0) &&
           s->is_simplex[1] == (v->reference[1] >= 0);
}

bool fmb_exact_box_take_basis(fmb_exact_box *v, const fmb_exact_box_program *s,
                              const fmb_exact_box_basis *basis)
{
    v->program = s;
    v->basis = *basis;
    v->has_row = v->has_x = v->has_close = 0;
    v->has_det = v->has_rest = false;
    return list_basic_unknowns(v);
}

bool fmb_exact_box_state(fmb_exact_box *v, const fmb_exact_box_program *s,
                         const fmb_exact_box_basis *basis)
{
    if (!fmb_exact_box_take_basis(v, s, basis))
        return false;
    find_near_entries(v);
    find_near_adjugate(v);
    find_near_values(v);
    return are_all_in_place(v);
}

/* The quotient. */
static double near_value(const fmb_exact_box *v, near x, bool *good)
{
    double det = fabs(v->near_det.x);
    *good = *good && x.size + v->near_det.size <= 0x1p5 * det;
    return x.x / v->near_det.x;
}

/* Every x is at most det, and off by 2^-47 of its size; det likewise. */
bool fmb_exact_box_near_values(const fmb_exact_box *v, double *z)
{
    bool good = true;
    for (int j = 0; j < v->program->columns; j++)
        z[j] = v->basis.place[j] == FMB_EXACT_BOX_HIGH;
    for (int group = 0; group < 2; group++)
        if (v->reference[group] >= 0 && v->reference[group] < FMB_EXACT_BOX_COLUMNS)
            z[v->reference[group]] = near_value(v, v->near_reference[group], &good);
    for (int k = 0; k < DIM; k++)
        if (v->basic[k] < FMB_EXACT_BOX_COLUMNS)
            z[v->basic[k]] = near_value(v, v->near_x[k], &good);
    return good;
}
