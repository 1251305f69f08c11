/* equations.c: see equations.h. */
#include "study/reference/equations.h"

#include <limits.h>

void study_equations_init(study_equations *e)
{
    for (int i = 0; i < STUDY_EQUATIONS_MOST; i++) {
        for (int j = 0; j <= STUDY_EQUATIONS_MOST; j++)
            mpz_init(e->a[i][j]);
        mpz_init(e->x[i]);
    }
    mpz_init(e->divisor);
}

void study_equations_clear(study_equations *e)
{
    for (int i = 0; i < STUDY_EQUATIONS_MOST; i++) {
        for (int j = 0; j <= STUDY_EQUATIONS_MOST; j++)
            mpz_clear(e->a[i][j]);
        mpz_clear(e->x[i]);
    }
    mpz_clear(e->divisor);
}

/* A row from k on whose entry of column k is the shortest but 0 comes to place k; false if there is
 * none. */
static bool take_pivot(study_equations *e, int n, int k)
{
    int best = -1;
    for (int i = k; i < n; i++)
        if (mpz_sgn(e->a[i][k]) != 0 &&
            (best < 0 || mpz_size(e->a[i][k]) < mpz_size(e->a[best][k])))
            best = i;
    for (int j = k; best > k && j <= n; j++)
        mpz_swap(e->a[k][j], e->a[best][j]);
    return best >= 0;
}

/* Row i less its multiple of row k, without fractions. */
static void eliminate(study_equations *e, int n, int i, int k)
{
    for (int j = k + 1; j <= n; j++) {
        mpz_mul(e->a[i][j], e->a[i][j], e->a[k][k]);
        mpz_submul(e->a[i][j], e->a[i][k], e->a[k][j]);
        if (k > 0)
            mpz_divexact(e->a[i][j], e->a[i][j], e->a[k - 1][k - 1]);
    }
}

/* The power of 2 that all numbers of column j, or of row i, have in common, goes; their exponent.
 */
static mp_bitcnt_t shorten_column(study_equations *e, int n, int j)
{
    mp_bitcnt_t least = ULONG_MAX;
    for (int i = 0; i < n; i++)
        if (mpz_sgn(e->a[i][j]) != 0 && mpz_scan1(e->a[i][j], 0) < least)
            least = mpz_scan1(e->a[i][j], 0);
    for (int i = 0; least != ULONG_MAX && i < n; i++)
        mpz_tdiv_q_2exp(e->a[i][j], e->a[i][j], least);
    return least == ULONG_MAX ? 0 : least;
}

static void shorten_row(study_equations *e, int n, int i)
{
    mp_bitcnt_t least = ULONG_MAX;
    for (int j = 0; j <= n; j++)
        if (mpz_sgn(e->a[i][j]) != 0 && mpz_scan1(e->a[i][j], 0) < least)
            least = mpz_scan1(e->a[i][j], 0);
    for (int j = 0; least != ULONG_MAX && j <= n; j++)
        mpz_tdiv_q_2exp(e->a[i][j], e->a[i][j], least);
}

/* Column j was 2^down[j] times what it is: x_j is 2^-down[j] times what was found. */
static void lengthen_solution(study_equations *e, int n, const mp_bitcnt_t *down)
{
    mp_bitcnt_t most = 0;
    for (int j = 0; j < n; j++)
        most = down[j] > most ? down[j] : most;
    for (int j = 0; j < n; j++)
        mpz_mul_2exp(e->x[j], e->x[j], most - down[j]);
    mpz_mul_2exp(e->divisor, e->divisor, most);
}

/* The method is that of Bareiss (Mathematics of Computation 22, 1968): all that is left are minors.
 * Numbers of frames of very different size have powers of 2 in common, which would be in all of
 * them. */
bool study_equations_solve(study_equations *e, int n)
{
    mp_bitcnt_t down[STUDY_EQUATIONS_MOST];
    for (int j = 0; j < n; j++)
        down[j] = shorten_column(e, n, j);
    for (int i = 0; i < n; i++)
        shorten_row(e, n, i);
    for (int k = 0; k < n; k++) {
        if (!take_pivot(e, n, k))
            return false;
        for (int i = k + 1; i < n; i++)
            eliminate(e, n, i, k);
    }
    mpz_set(e->divisor, e->a[n - 1][n - 1]);
    for (int i = n - 1; i >= 0; i--) {
        mpz_mul(e->x[i], e->divisor, e->a[i][n]);
        for (int j = i + 1; j < n; j++)
            mpz_submul(e->x[i], e->a[i][j], e->x[j]);
        mpz_divexact(e->x[i], e->x[i], e->a[i][i]);
    }
    for (int i = 0; mpz_sgn(e->divisor) < 0 && i < n; i++)
        mpz_neg(e->x[i], e->x[i]);
    mpz_abs(e->divisor, e->divisor);
    lengthen_solution(e, n, down);
    return true;
}
