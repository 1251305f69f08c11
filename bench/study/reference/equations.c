/* equations.c: see equations.h. */
#include "study/reference/equations.h"

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

/* The method is that of Bareiss (Mathematics of Computation 22, 1968): all that is left are minors.
 */
bool study_equations_solve(study_equations *e, int n)
{
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
    return true;
}
