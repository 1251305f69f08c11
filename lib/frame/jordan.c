/* jordan.c: see jordan.h.
 *
 * Fraction-free: with pivot p in row c, and the previous pivot q (1 at first), every other row r
 * becomes (p r - r_c row_c) / q. By Cramer's rule all entries are then minors of order c + 1 of the
 * initial matrix, so the division is exact, and numbers are no longer than these minors. In earlier
 * pivot rows the pivot q becomes p.
 *
 * Source: E. H. Bareiss, Mathematics of Computation 22 (1968).
 */
#include "frame/jordan.h"

typedef struct table {
    mpz_t *cell;
    int rows, width;
    mpz_t t;
    fmb_run *run; /* or NULL */
} table;

static mpz_t *row_of_table(const table *a, int i)
{
    return a->cell + (size_t)i * (size_t)a->width;
}

static void swap_rows(const table *a, int i, int k)
{
    for (int j = 0; i != k && j < a->width; j++)
        mpz_swap(row_of_table(a, i)[j], row_of_table(a, k)[j]);
}

/* Update row i, which is not row c, for the pivot of column c. Before column c it is zero but for
 * its own pivot, which is updated, too. */
static void clear_column_in_row(table *a, int i, int c, const mpz_t before)
{
    mpz_t *r = row_of_table(a, i), *p = row_of_table(a, c);
    mpz_swap(a->t, r[c]);
    mpz_set_ui(r[c], 0);
    if (i < c)
        mpz_set(r[i], p[c]);
    for (int j = c + 1; j < a->width; j++) {
        mpz_mul(r[j], r[j], p[c]);
        mpz_submul(r[j], a->t, p[j]);
        mpz_divexact(r[j], r[j], before);
    }
}

static fmb_status pivot_on_column(table *a, int c, mpz_t det)
{
    int p = c;
    while (p < a->rows && mpz_sgn(row_of_table(a, p)[c]) == 0)
        p++;
    if (p == a->rows)
        return FMB_ERR_ARG;
    swap_rows(a, c, p);
    fmb_status st = FMB_OK;
    for (int i = 0; st == FMB_OK && i < a->rows; i++) {
        if (i != c)
            clear_column_in_row(a, i, c, det);
        st = fmb_poll_if_limited(a->run);
    }
    mpz_set(det, row_of_table(a, c)[c]);
    return st;
}

fmb_status fmb_jordan(mpz_t *cell, int rows, int width, int n, mpz_t det, fmb_run *run)
{
    table a = {.cell = cell, .rows = rows, .width = width, .run = run};
    fmb_status st = FMB_OK;
    mpz_set_ui(det, 1);
    mpz_init(a.t);
    for (int c = 0; st == FMB_OK && c < n; c++)
        st = pivot_on_column(&a, c, det);
    mpz_clear(a.t);
    for (int i = 0; st == FMB_OK && mpz_sgn(det) < 0 && i < rows * width; i++)
        mpz_neg(cell[i], cell[i]);
    mpz_abs(det, det);
    return st;
}
