/* equations.c: see equations.h.
 *
 * The method is that of Bareiss (Mathematics of Computation 22, 1968): all that is left are minors.
 * With p_k on the diagonal when column k is eliminated and p_{-1} = 1, what stays below the
 * diagonal is L, what stays on it and above U, and the coefficients are L D^-1 U, D = diag(p_{k-1}
 * p_k).
 */
#include "study/reference/equations.h"

#include <limits.h>

void study_equations_init(study_equations *e)
{
    for (int i = 0; i < STUDY_EQUATIONS_MOST; i++) {
        for (int j = 0; j < STUDY_EQUATIONS_MOST; j++)
            mpz_init(e->a[i][j]);
        mpz_inits(e->x[i], e->turned[i], NULL);
    }
    mpz_init(e->divisor);
}

void study_equations_clear(study_equations *e)
{
    for (int i = 0; i < STUDY_EQUATIONS_MOST; i++) {
        for (int j = 0; j < STUDY_EQUATIONS_MOST; j++)
            mpz_clear(e->a[i][j]);
        mpz_clears(e->x[i], e->turned[i], NULL);
    }
    mpz_clear(e->divisor);
}

/* ---- factors --------------------------------------------------------------------------------- */

/* A row from k on whose entry of column k is the shortest but 0 comes to place k; false if there is
 * none. */
static bool take_pivot(study_equations *e, int k)
{
    int best = -1;
    for (int i = k; i < e->n; i++)
        if (mpz_sgn(e->a[i][k]) != 0 &&
            (best < 0 || mpz_size(e->a[i][k]) < mpz_size(e->a[best][k])))
            best = i;
    if (best <= k)
        return best == k;
    for (int j = 0; j < e->n; j++)
        mpz_swap(e->a[k][j], e->a[best][j]);
    int row = e->row[k];
    e->row[k] = e->row[best];
    e->row[best] = row;
    return true;
}

/* x = (pivot x - factor y) / previous, which is whole; previous may be NULL. */
static void reduce(mpz_t x, mpz_srcptr pivot, mpz_srcptr factor, mpz_srcptr y, mpz_srcptr previous)
{
    if (mpz_sgn(x) != 0)
        mpz_mul(x, x, pivot);
    if (mpz_sgn(factor) != 0 && mpz_sgn(y) != 0)
        mpz_submul(x, factor, y);
    if (previous && mpz_sgn(x) != 0)
        mpz_divexact(x, x, previous);
}

static mpz_srcptr previous_pivot(const study_equations *e, int k)
{
    return k > 0 ? e->a[k - 1][k - 1] : NULL;
}

/* The power of 2 that all numbers of column j (of row i) have in common, goes: numbers of frames of
 * very different size have such powers, which would be in all minors. Their exponent. */
static mp_bitcnt_t shorten(study_equations *e, int place, bool column)
{
    mp_bitcnt_t least = ULONG_MAX;
    for (int k = 0; k < e->n; k++) {
        mpz_srcptr x = column ? e->a[k][place] : e->a[place][k];
        if (mpz_sgn(x) != 0 && mpz_scan1(x, 0) < least)
            least = mpz_scan1(x, 0);
    }
    if (least == ULONG_MAX || least == 0)
        return 0;
    for (int k = 0; k < e->n; k++) {
        mpz_ptr x = column ? e->a[k][place] : e->a[place][k];
        mpz_tdiv_q_2exp(x, x, least);
    }
    return least;
}

bool study_equations_factor(study_equations *e, int n)
{
    e->n = n;
    for (int j = 0; j < n; j++)
        e->column_down[j] = shorten(e, j, true);
    for (int i = 0; i < n; i++) {
        e->row_down[i] = shorten(e, i, false);
        e->row[i] = i;
    }
    for (int k = 0; k < n; k++) {
        if (!take_pivot(e, k))
            return false;
        for (int i = k + 1; i < n; i++)
            for (int j = k + 1; j < n; j++)
                reduce(e->a[i][j], e->a[k][k], e->a[i][k], e->a[k][j], previous_pivot(e, k));
    }
    return true;
}

/* ---- solutions ------------------------------------------------------------------------------- */

static mp_bitcnt_t most_of(const mp_bitcnt_t *down, int n)
{
    mp_bitcnt_t most = 0;
    for (int i = 0; i < n; i++)
        most = down[i] > most ? down[i] : most;
    return most;
}

/* x / divisor in lower terms, as far as powers of 2 go, with a divisor that is not negative. */
static void shorten_solution(study_equations *e)
{
    mp_bitcnt_t least = mpz_scan1(e->divisor, 0);
    for (int i = 0; i < e->n; i++)
        if (mpz_sgn(e->x[i]) != 0 && mpz_scan1(e->x[i], 0) < least)
            least = mpz_scan1(e->x[i], 0);
    for (int i = 0; i < e->n; i++) {
        mpz_tdiv_q_2exp(e->x[i], e->x[i], least);
        if (mpz_sgn(e->divisor) < 0)
            mpz_neg(e->x[i], e->x[i]);
    }
    mpz_tdiv_q_2exp(e->divisor, e->divisor, least);
    mpz_abs(e->divisor, e->divisor);
}

/* Row i is 2^row_down[i] times what is factored, so the right sides become those of equal rows
 * 2^-most; column j 2^column_down[j] times, so x_j is found that many times too large. The right
 * side is one more column of the elimination. */
void study_equations_solve(study_equations *e)
{
    const mp_bitcnt_t rows = most_of(e->row_down, e->n), columns = most_of(e->column_down, e->n);
    const int last = e->n - 1;
    mpz_t *x = e->turned;
    for (int i = 0; i < e->n; i++)
        mpz_mul_2exp(x[i], e->x[e->row[i]], rows - e->row_down[e->row[i]]);
    for (int k = 0; k < last; k++)
        for (int i = k + 1; i < e->n; i++)
            reduce(x[i], e->a[k][k], e->a[i][k], x[k], previous_pivot(e, k));
    mpz_set(e->divisor, e->a[last][last]);
    for (int i = last; i >= 0; i--) {
        mpz_mul(e->x[i], e->divisor, x[i]);
        for (int j = i + 1; j < e->n; j++)
            mpz_submul(e->x[i], e->a[i][j], e->x[j]);
        mpz_divexact(e->x[i], e->x[i], e->a[i][i]);
    }
    for (int j = 0; j < e->n; j++)
        mpz_mul_2exp(e->x[j], e->x[j], columns - e->column_down[j]);
    mpz_mul_2exp(e->divisor, e->divisor, rows + columns);
    shorten_solution(e);
}

/* The right side is one more row c of the elimination, whose part of L, in its place, is l: c = l
 * D^-1 U, so the solution y of y L D^-1 U = c is that of y L = l. */
void study_equations_solve_transposed(study_equations *e)
{
    const mp_bitcnt_t rows = most_of(e->row_down, e->n), columns = most_of(e->column_down, e->n);
    const int last = e->n - 1;
    mpz_t *l = e->turned;
    for (int j = 0; j < e->n; j++)
        mpz_mul_2exp(e->x[j], e->x[j], columns - e->column_down[j]);
    for (int k = 0; k < last; k++)
        for (int j = k + 1; j < e->n; j++)
            reduce(e->x[j], e->a[k][k], e->x[k], e->a[k][j], previous_pivot(e, k));
    mpz_set(e->divisor, e->a[last][last]);
    for (int k = last; k >= 0; k--) {
        mpz_mul(l[k], e->divisor, e->x[k]);
        for (int i = k + 1; i < e->n; i++)
            mpz_submul(l[k], l[i], e->a[i][k]);
        mpz_divexact(l[k], l[k], e->a[k][k]);
    }
    for (int k = 0; k < e->n; k++)
        mpz_mul_2exp(e->x[e->row[k]], l[k], rows - e->row_down[e->row[k]]);
    mpz_mul_2exp(e->divisor, e->divisor, rows + columns);
    shorten_solution(e);
}
