/* point.c: see point.h.
 *
 * In doubles, u = 2^-53, the numbers of M and h are at most 1, with errors of at most u; so the
 * relative entries of P are at most 2, with relative errors of at most 2 u. A sum of n products has
 * an error of at most n u times the sum of their absolute values, which is rounded up enough to
 * cover terms of higher order.
 *
 * With R = inverse and E = I - R P, all sums of |E| of a row less than 1/2, P has an inverse, which
 * is (I - E)^-1 R. So P x = rest for one x alone; and with z = R (rest - P x'), for any x', x - x'
 * = z + E (I - E)^-1 z, of which no number is off z_k by more than twice defect_k max |z|.
 */
#include "pair/exact_box/point.h"

#include "frame/near_jordan.h"

typedef fmb_exact_box_near near;

#define DIM FMB_EXACT_BOX_DIM

#define UNIT     0x1p-53
#define A_LITTLE (1 + 0x1p-40) /* exceeds the rounding of sums of bounds */

/* ---- columns --------------------------------------------------------------------------------- */

static const fmb_exact_box_vector *reference_column(const fmb_exact_box *v, int j)
{
    int reference = fmb_exact_box_reference_of(v, j);
    return reference < 0 ? NULL : &v->program->m[reference];
}

void fmb_exact_box_list_column(const fmb_exact_box *v, int j, const fmb_wide **out, fmb_wide *room)
{
    const fmb_exact_box_vector *a = &v->program->m[j], *b = reference_column(v, j);
    for (int row = 0; row < v->program->dim; row++)
        out[row] = fmb_exact_box_difference(&a->whole[row], b ? &b->whole[row] : NULL, &room[row]);
}

/* ---- in doubles ------------------------------------------------------------------------------ */

/* P, column by column. */
static void list_near_columns(const fmb_exact_box *v, double (*p)[DIM])
{
    for (int k = 0; k < v->program->dim; k++) {
        const fmb_exact_box_vector *a = &v->program->m[v->basic[k]],
                                   *b = reference_column(v, v->basic[k]);
        for (int row = 0; row < v->program->dim; row++)
            p[k][row] = b ? a->near[row] - b->near[row] : a->near[row];
    }
}

/* The defects; false: one is too large, or no number. */
static bool find_defects(fmb_exact_box *v, const double (*p)[DIM])
{
    int n = v->program->dim;
    bool good = true;
    v->norm = 0;
    for (int k = 0; k < n; k++) {
        const double *r = v->inverse[k];
        double sum = 0, norm = 0;
        for (int j = 0; j < n; j++) {
            double e = j == k ? -1 : 0;
            for (int i = 0; i < n; i++)
                e += r[i] * p[j][i];
            sum += fabs(e);
        }
        for (int i = 0; i < n; i++)
            norm += fabs(r[i]);
        v->defect[k] = (sum + (n + 8) * UNIT * (2 * n * norm + 1)) * A_LITTLE;
        v->norm = norm > v->norm ? norm : v->norm;
        good &= v->defect[k] < 0.5 && norm < 0x1p200;
    }
    v->norm *= A_LITTLE;
    return good;
}

/* Returns a bound of the sum of absolute terms of each entry, as numbers of M and h are at most 1.
 */
static double find_near_rest(const fmb_exact_box *v, double *rest)
{
    const fmb_exact_box_program *s = v->program;
    double size = 1;
    for (int row = 0; row < s->dim; row++)
        rest[row] = s->h.near[row];
    for (int j = 0; j < s->columns; j++) {
        if (!fmb_exact_box_is_one(v, j))
            continue;
        const double end = s->near_end[fmb_exact_box_end_of(s, j)];
        size += end;
        for (int row = 0; row < s->dim; row++)
            rest[row] -= end * s->m[j].near[row];
    }
    return size;
}

void fmb_exact_box_bound_way(const fmb_exact_box *v, const double *rest, double *error)
{
    int n = v->program->dim;
    double most = 0;
    for (int k = 0; k < n; k++) {
        error[k] = 0;
        for (int row = 0; row < n; row++)
            error[k] += fabs(v->inverse[k][row]) * rest[row];
        most = error[k] > most ? error[k] : most;
    }
    for (int k = 0; k < n; k++)
        error[k] = (error[k] + 2 * v->defect[k] * most) * A_LITTLE;
}

static void find_near_values(fmb_exact_box *v, const double (*p)[DIM])
{
    int n = v->program->dim;
    double rest[DIM] = {0}, error[DIM], size = find_near_rest(v, rest);
    for (int k = 0; k < n; k++) {
        v->x[k].x = 0;
        for (int row = 0; row < n; row++)
            v->x[k].x += v->inverse[k][row] * rest[row];
        size += 2 * fabs(v->x[k].x);
    }
    for (int k = 0; k < n; k++)
        for (int row = 0; row < n; row++)
            rest[row] -= p[k][row] * v->x[k].x;
    for (int row = 0; row < n; row++)
        rest[row] = fabs(rest[row]) + (v->program->columns + n + 10) * UNIT * size;
    fmb_exact_box_bound_way(v, rest, error);
    for (int k = 0; k < n; k++)
        v->x[k].error = error[k];
}

/* The unknown whose place a remainder refers to: basic unknown `only`, or if that is -1 the
 * reference of a group. */
static int owner_of_place(const fmb_exact_box *v, int group, int only)
{
    return only < 0 ? v->reference[group] : v->basic[only];
}

/* Is x_k subtracted in the remainder: only number `only`, or all of the group if that is -1?
 */
static bool counts_in_rest(const fmb_exact_box *v, int k, int group, int only)
{
    return only < 0 ? v->program->group[v->basic[k]] == group : k == only;
}

static near near_remainder(const fmb_exact_box *v, int group, int only)
{
    const fmb_exact_box_program *s = v->program;
    int owner = owner_of_place(v, group, only);
    double size = owner < 0 ? 1 : s->near_end[fmb_exact_box_end_of(s, owner)];
    near left = {size, 0};
    for (int k = 0; k < v->program->dim; k++)
        if (counts_in_rest(v, k, group, only)) {
            left.x -= v->x[k].x;
            left.error += v->x[k].error;
            size += fabs(v->x[k].x);
        }
    left.error = left.error * A_LITTLE + (s->dim + 2) * UNIT * size;
    return left;
}

static void find_near(fmb_exact_box *v)
{
    double p[DIM][DIM];
    int n = v->program->dim;
    list_near_columns(v, p);
    for (int k = 0; k < n; k++)
        for (int row = 0; row < n; row++)
            v->inverse[row][k] = p[k][row];
    v->is_near = fmb_near_invert(n, v->inverse) && find_defects(v, (const double(*)[DIM])p);
    if (v->is_near)
        find_near_values(v, (const double(*)[DIM])p);
    for (int k = 0; !v->is_near && k < n; k++)
        v->x[k] = (near){0, INFINITY};
    for (int group = 0; group < 2; group++)
        v->of_reference[group] = near_remainder(v, group, -1);
}

/* ---- in integers -----------------------------------------------------------------------------
 *
 * Fraction-free elimination (Bareiss 1968, Sylvester's identity and multistep integer-preserving
 * Gaussian elimination): with the pivots p_k on the diagonal, p_-1 = 1, all entries not yet
 * eliminated are minors of P and the remaining columns. The entries below the diagonal are L, those
 * on and above it U, and P, with its rows in the order of `row`, is L D^-1 U, D = diag(p_{k-1}
 * p_k). The last p_k is det up to its sign.
 */

/* a[k][k - 1], or NULL. */
static const fmb_wide *previous_pivot(const fmb_exact_box_whole *w, int k)
{
    return k > 0 ? &w->factor[k - 1][k - 1] : NULL;
}

/* a = (pivot a - b c) / previous, which is an integer. */
static void eliminate(fmb_wide *a, const fmb_wide *pivot, const fmb_wide *b, const fmb_wide *c,
                      const fmb_wide *previous)
{
    if (a->n == 0 && (b->n == 0 || c->n == 0))
        return;
    fmb_wide_dot(a, 2, (const fmb_wide *const[]){pivot, b}, (const fmb_wide *const[]){a, c}, 2);
    if (previous)
        fmb_wide_divide_exactly(a, previous);
}

/* List the columns of P, then h minus the columns of unknowns that are 1, row by row. */
static void list_whole_entries(fmb_exact_box *v)
{
    const fmb_exact_box_program *s = v->program;
    for (int row = 0; row < s->dim; row++) {
        fmb_wide *to = v->whole->factor[row], *rest = &to[s->dim];
        for (int k = 0; k < s->dim; k++) {
            const fmb_exact_box_vector *less = reference_column(v, v->basic[k]);
            fmb_wide_copy(&to[k], &s->m[v->basic[k]].whole[row]);
            if (less)
                fmb_wide_subtract(&to[k], &less->whole[row]);
        }
        fmb_wide_copy(rest, &s->h.whole[row]);
        for (int j = 0; j < s->columns; j++)
            if (fmb_exact_box_is_one(v, j))
                fmb_exact_box_gather_end(s, j, rest, &s->m[j].whole[row], true);
        v->whole->row[row] = row;
    }
}

/* Move to place k the row, from k on, whose number in column k has the fewest words. False: all are
 * 0. */
static bool take_pivot_row(fmb_exact_box_whole *w, int n, int k)
{
    int best = -1, row;
    for (int i = k; i < n; i++)
        if (w->factor[i][k].n > 0 && (best < 0 || w->factor[i][k].n < w->factor[best][k].n))
            best = i;
    if (best <= k)
        return best == k;
    for (int j = 0; j <= n; j++)
        fmb_wide_swap(&w->factor[k][j], &w->factor[best][j]);
    row = w->row[k];
    w->row[k] = w->row[best];
    w->row[best] = row;
    return true;
}

/* False: P has no inverse. */
static bool factor_basis(fmb_exact_box *v)
{
    fmb_exact_box_whole *w = v->whole;
    const int n = v->program->dim;
    list_whole_entries(v);
    for (int k = 0; k < n; k++) {
        if (!take_pivot_row(w, n, k))
            return false;
        for (int i = k + 1; i < n; i++)
            for (int j = k + 1; j <= n; j++)
                eliminate(&w->factor[i][j], &w->factor[k][k], &w->factor[i][k], &w->factor[k][j],
                          previous_pivot(w, k));
    }
    return true;
}

/* out = (det first - the sum of a[i] b[i]) / pivot, i < n < DIM; where n is 0 the pivot is det.
 */
static void substitute(const fmb_wide *det, const fmb_wide *first, int n, const fmb_wide **a,
                       const fmb_wide **b, const fmb_wide *pivot, fmb_wide *out)
{
    if (n == 0) {
        fmb_wide_copy(out, first);
        return;
    }
    a[n] = det;
    b[n] = first;
    fmb_wide_dot(out, n + 1, a, b, (1u << n) - 1);
    fmb_wide_divide_exactly(out, pivot);
}

const fmb_exact_box_whole *fmb_exact_box_need_whole(fmb_exact_box *v)
{
    fmb_exact_box_whole *w = v->whole;
    const int n = v->program->dim;
    const fmb_wide *a[DIM], *b[DIM];
    if (w->of == v)
        return w;
    w->of = v;
    w->adjugate_of = w->adjugate_of == v ? v : NULL;
    w->det.n = 0;
    if (!factor_basis(v))
        return w;
    fmb_wide_copy(&w->det, &w->factor[n - 1][n - 1]);
    for (int k = n; k-- > 0;) {
        for (int j = k + 1; j < n; j++) {
            a[j - k - 1] = &w->factor[k][j];
            b[j - k - 1] = &w->x[j];
        }
        substitute(&w->det, &w->factor[k][n], n - k - 1, a, b, &w->factor[k][k], &w->x[k]);
    }
    for (int k = 0; w->det.minus && k < n; k++)
        fmb_wide_negate(&w->x[k]);
    w->det.minus = false;
    return w;
}

/* c is one more row of the elimination, whose part of L takes its place: c = l D^-1 U, so the y of
 * y L D^-1 U = c is that of y L = l. */
void fmb_exact_box_solve_transposed(fmb_exact_box *v, fmb_wide *c, fmb_wide *y)
{
    const fmb_exact_box_whole *w = fmb_exact_box_need_whole(v);
    const int n = v->program->dim;
    const fmb_wide *det = &w->factor[n - 1][n - 1], *a[DIM], *b[DIM];
    for (int k = 0; k < n; k++)
        for (int j = k + 1; j < n; j++)
            eliminate(&c[j], &w->factor[k][k], &c[k], &w->factor[k][j], previous_pivot(w, k));
    for (int k = n; k-- > 0;) {
        for (int i = k + 1; i < n; i++) {
            a[i - k - 1] = &w->factor[i][k];
            b[i - k - 1] = &y[w->row[i]];
        }
        substitute(det, &c[k], n - k - 1, a, b, &w->factor[k][k], &y[w->row[k]]);
    }
    for (int k = 0; det->minus && k < n; k++)
        fmb_wide_negate(&y[k]);
}

/* Its rows are det times the prices of unit costs. */
fmb_exact_box_whole *fmb_exact_box_need_adjugate(fmb_exact_box *v)
{
    fmb_exact_box_whole *w = v->whole;
    const int n = v->program->dim;
    if (w->adjugate_of == v || fmb_exact_box_need_whole(v)->det.n == 0)
        return w;
    w->adjugate_of = v;
    for (int k = 0; k < n; k++) {
        for (int j = 0; j < n; j++)
            fmb_wide_set_word(&w->fall[j], j == k);
        fmb_exact_box_solve_transposed(v, w->fall, w->adjugate[k]);
    }
    return w;
}

void fmb_exact_box_remainder(fmb_exact_box *v, int group, int only, fmb_wide *out)
{
    const fmb_exact_box_whole *w = fmb_exact_box_need_whole(v);
    out->n = 0;
    fmb_exact_box_gather_end(v->program, owner_of_place(v, group, only), out, &w->det, false);
    for (int k = 0; k < v->program->dim; k++)
        if (counts_in_rest(v, k, group, only))
            fmb_wide_subtract(out, &w->x[k]);
}

/* ---- signs ----------------------------------------------------------------------------------- */

const fmb_exact_box_low *fmb_exact_box_need_low(fmb_exact_box *v)
{
    const fmb_exact_box_program *s = v->program;
    bool is_one[FMB_EXACT_BOX_COLUMNS];
    int reference[DIM];
    if (v->whole->low_of == v)
        return &v->whole->low;
    v->whole->low_of = v;
    for (int k = 0; k < s->dim; k++)
        reference[k] = fmb_exact_box_reference_of(v, v->basic[k]);
    for (int j = 0; j < s->columns; j++)
        is_one[j] = fmb_exact_box_is_one(v, j);
    fmb_exact_box_find_low(s, v->basic, reference, is_one, &v->whole->low);
    return &v->whole->low;
}

/* Given x near x_k, is x_k exactly 0? False: the lowest words do not prove it. */
static bool is_x_zero(fmb_exact_box *v, int k, near x)
{
    if (!v->is_near || v->program->has_ends)
        return false;
    const fmb_exact_box_low *low = fmb_exact_box_need_low(v);
    return fmb_exact_box_is_low_zero(low, low->x[k], fabs(x.x) + x.error);
}

/* Is a remainder exactly 0? False: the lowest words do not prove it. */
static bool is_remainder_zero(fmb_exact_box *v, int group, int only, near left)
{
    if (!v->is_near || v->program->has_ends)
        return false;
    const fmb_exact_box_low *low = fmb_exact_box_need_low(v);
    fmb_u128 bits = low->det;
    for (int k = 0; k < v->program->dim; k++)
        if (counts_in_rest(v, k, group, only))
            bits = fmb_u128_minus(bits, low->x[k]);
    return fmb_exact_box_is_low_zero(low, bits, fabs(left.x) + left.error);
}

static int sign_of_x(fmb_exact_box *v, int k)
{
    if (fmb_exact_box_is_sign_known(v->x[k]))
        return fmb_exact_box_sign_of_near(v->x[k]);
    return is_x_zero(v, k, v->x[k]) ? 0 : fmb_wide_sign(&fmb_exact_box_need_whole(v)->x[k]);
}

static int sign_of_remainder(fmb_exact_box *v, int group, int only)
{
    near guess = only < 0 ? v->of_reference[group] : near_remainder(v, group, only);
    fmb_wide left;
    if (fmb_exact_box_is_sign_known(guess))
        return fmb_exact_box_sign_of_near(guess);
    if (is_remainder_zero(v, group, only, guess))
        return 0;
    fmb_exact_box_remainder(v, group, only, &left);
    return fmb_wide_sign(&left);
}

static bool is_basic_in_place(fmb_exact_box *v, int k)
{
    int group = v->program->group[v->basic[k]], sign = sign_of_x(v, k);
    if (group == FMB_EXACT_BOX_ZERO)
        return sign == 0;
    return sign >= 0 && (group != FMB_EXACT_BOX_UNIT || sign_of_remainder(v, group, k) >= 0);
}

bool fmb_exact_box_is_off_end(fmb_exact_box *v, int j, bool high)
{
    int group = v->program->group[j], k = 0;
    if (v->basis.place[j] != FMB_EXACT_BOX_BASIC)
        return (v->basis.place[j] == FMB_EXACT_BOX_HIGH) != high;
    while (k < v->program->dim && v->basic[k] != j)
        k++;
    if (k == v->program->dim)
        return sign_of_remainder(v, group, -1) > 0;
    return (high ? sign_of_remainder(v, group, k) : sign_of_x(v, k)) > 0;
}

static bool are_all_in_place(fmb_exact_box *v)
{
    bool good = v->is_near || fmb_exact_box_need_whole(v)->det.n > 0;
    for (int k = 0; good && k < v->program->dim; k++)
        good = is_basic_in_place(v, k);
    for (int group = 0; good && group < 2; group++)
        good = v->reference[group] < 0 || sign_of_remainder(v, group, -1) >= 0;
    return good;
}

/* ---- the basic solution ---------------------------------------------------------------------- */

/* The slack is the best reference: its column is 0. */
static bool list_basic_unknowns(fmb_exact_box *v)
{
    const fmb_exact_box_program *s = v->program;
    int n = 0, of[2] = {0, 0};
    v->reference[0] = v->reference[1] = -1;
    for (int j = s->unknowns - 1; j >= 0; j--) {
        int group = s->group[j];
        if (v->basis.place[j] != FMB_EXACT_BOX_BASIC)
            continue;
        if (group <= FMB_EXACT_BOX_OF_B && v->reference[group] < 0) {
            v->reference[group] = j;
            continue;
        }
        if (n < s->dim)
            v->basic[n] = j;
        n++;
        of[0] += j < s->first_of_b || j == s->slack;
        of[1] += (j >= s->first_of_b && j < s->columns && j != s->time) || j == s->slack + 1;
    }
    v->side = of[1] < of[0];
    return n == s->dim && s->is_simplex[0] == (v->reference[0] >= 0) &&
           s->is_simplex[1] == (v->reference[1] >= 0);
}

bool fmb_exact_box_take_basis(fmb_exact_box *v, const fmb_exact_box_program *s,
                              const fmb_exact_box_basis *basis)
{
    v->program = s;
    v->basis = *basis;
    v->has_close = false;
    fmb_exact_box_forget_whole(v->whole, v);
    if (!list_basic_unknowns(v))
        return false;
    find_near(v);
    return true;
}

bool fmb_exact_box_state(fmb_exact_box *v, const fmb_exact_box_program *s,
                         const fmb_exact_box_basis *basis)
{
    return fmb_exact_box_take_basis(v, s, basis) && are_all_in_place(v);
}

static double near_value(near x, bool *good)
{
    *good = *good && x.error <= 0x1p-42;
    return x.x;
}

bool fmb_exact_box_near_values(const fmb_exact_box *v, double *z)
{
    const fmb_exact_box_program *s = v->program;
    bool good = !s->has_ends;
    for (int j = 0; j < s->artificial; j++)
        z[j] =
            v->basis.place[j] == FMB_EXACT_BOX_HIGH ? s->near_end[fmb_exact_box_end_of(s, j)] : 0;
    for (int group = 0; group < 2; group++)
        if (v->reference[group] >= 0)
            z[v->reference[group]] = near_value(v->of_reference[group], &good);
    for (int k = 0; k < s->dim; k++)
        if (v->basic[k] < s->artificial)
            z[v->basic[k]] = near_value(v->x[k], &good);
    return good;
}
