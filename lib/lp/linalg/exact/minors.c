/* minors.c: see minors.h.
 *
 * Step k makes of entry (i, j), i, j > k, the minor of rows 0..k, i and columns 0..k, j:
 *
 *     a_ij := (p_k a_ij - a_ik a_kj) / p_{k-1},    p_k = a_kk,   p_{-1} = 1,
 *
 * and that division is exact (Sylvester 1851). So B = L D^-1 U, with L the columns a_ik, i >= k,
 * U the rows a_kj, j >= k, and D = diag(p_{k-1} p_k); and B^T = U^T D^-1 L^T is of the same form.
 */
#include "lp/linalg/exact/minors.h"

/* Elimination takes n^3 products of growing numbers; lifting takes, for each right side, as many
 * digits as numerator and denominator of the solution have together, each with n^2 products, of
 * words if entries are words, otherwise of twice the cost. */
#define MOST_UNKNOWNS      12
#define MOST_UNKNOWNS_LONG 24

bool fmb_minors_suit(const fmb_sparse *b)
{
    return b->n > 0 && b->n <= (b->big ? MOST_UNKNOWNS_LONG : MOST_UNKNOWNS);
}

void fmb_minors_clear(fmb_minors *f, fmb_mem *mem)
{
    fmb_integers_clear(&f->at, mem);
    fmb_integers_clear(&f->y, mem);
}

static fmb_status make_room(fmb_minors *f, size_t n, fmb_mem *mem)
{
    f->n = n;
    if (f->y.size > n)
        return FMB_OK;
    fmb_minors_clear(f, mem);
    *f = (fmb_minors){.n = n};
    fmb_status st = fmb_integers_init(&f->at, n * n, mem);
    return st == FMB_OK ? fmb_integers_init(&f->y, n + 1, mem) : st;
}

static void copy_entries(fmb_minors *f, const fmb_sparse *b)
{
    for (size_t k = 0; k < f->n * f->n; k++)
        mpz_set_ui(f->at.z[k], 0);
    for (size_t i = 0; i < f->n; i++)
        for (size_t t = b->start[i]; t < b->start[i + 1]; t++) {
            mpz_ptr to = f->at.z[i * f->n + (size_t)b->index[t]];
            if (b->big && b->big[t])
                mpz_set(to, b->big[t]);
            else
                fmb_integer_set_i64(to, b->value[t]);
        }
}

/* to = (p to - a b) / last; unchanged if a b = 0 and p = last. */
static void clear_entry(mpz_t to, const mpz_t p, const mpz_t a, const mpz_t b, const mpz_t last)
{
    bool is_product = mpz_sgn(a) != 0 && mpz_sgn(b) != 0;
    if (mpz_sgn(to) == 0 && !is_product)
        return;
    if (!is_product && mpz_cmp(p, last) == 0)
        return;
    mpz_mul(to, to, p);
    if (is_product)
        mpz_submul(to, a, b);
    if (mpz_cmp_ui(last, 1) != 0)
        mpz_divexact(to, to, last);
}

/* Poll after step k of one row. */
static fmb_status poll_row(fmb_run *run, const fmb_minors *f, size_t k)
{
    return fmb_run_poll_step(run, !mpz_fits_slong_p(f->at.z[k * f->n + k]));
}

fmb_status fmb_minors_factor(fmb_minors *f, const fmb_sparse *b, fmb_run *run)
{
    size_t n = b->n;
    fmb_mem *mem = run->mem;
    fmb_status st = make_room(f, n, mem);
    if (st != FMB_OK)
        return st;
    copy_entries(f, b);
    mpz_t *a = f->at.z;
    mpz_set_ui(f->y.z[n], 1);
    mpz_ptr last = f->y.z[n];
    for (size_t k = 0; st == FMB_OK && k < n; k++) {
        for (size_t i = k + 1; st == FMB_OK && i < n; i++) {
            for (size_t j = k + 1; st == FMB_OK && j < n; j++) {
                clear_entry(a[i * n + j], a[k * n + k], a[i * n + k], a[k * n + j], last);
                st = fmb_run_poll_long(run, a[i * n + j]);
            }
            fmb_run_count(run, (n - k) * fmb_limbs_work(mpz_size(a[k * n + k])) / 2);
            FMB_THEN(st, poll_row(run, f, k));
        }
        last = a[k * n + k];
    }
    FMB_THEN(st, fmb_integers_settle(&f->at, mem));
    return st == FMB_OK ? fmb_integers_settle(&f->y, mem) : st;
}

/* Entry (i, j) of the factors, or of those of the transposed matrix. */
static mpz_srcptr factor_at(const fmb_minors *f, bool transposed, size_t i, size_t j)
{
    return transposed ? f->at.z[j * f->n + i] : f->at.z[i * f->n + j];
}

/* Apply the steps to y as a last column of the matrix. */
static fmb_status go_forwards(fmb_minors *f, fmb_run *run, bool transposed)
{
    fmb_status st = FMB_OK;
    mpz_t *y = f->y.z;
    mpz_set_ui(y[f->n], 1);
    mpz_srcptr last = y[f->n];
    for (size_t k = 0; st == FMB_OK && k < f->n; k++) {
        mpz_srcptr p = factor_at(f, false, k, k);
        for (size_t i = k + 1; st == FMB_OK && i < f->n; i++) {
            clear_entry(y[i], p, factor_at(f, transposed, i, k), y[k], last);
            st = fmb_run_poll_long(run, y[i]);
        }
        last = p;
        fmb_run_count(run, (f->n - k) * fmb_limbs_work((mpz_size(p) + mpz_size(y[k])) / 2));
        FMB_THEN(st, poll_row(run, f, k));
    }
    return st;
}

/* y becomes det x: sum_{j >= i} u_ij x_j = y_i, and each det x_j is an integer (Cramer). */
static fmb_status go_backwards(fmb_minors *f, fmb_run *run, bool transposed, const mpz_t det)
{
    fmb_status st = FMB_OK;
    mpz_t *y = f->y.z;
    for (size_t i = f->n; st == FMB_OK && i-- > 0;) {
        if (i + 1 < f->n)
            mpz_mul(y[i], y[i], det);
        for (size_t j = i + 1; st == FMB_OK && j < f->n; j++) {
            mpz_submul(y[i], factor_at(f, transposed, i, j), y[j]);
            st = fmb_run_poll_long(run, y[i]);
        }
        if (i + 1 < f->n)
            mpz_divexact(y[i], y[i], factor_at(f, false, i, i));
        size_t limbs = mpz_size(y[i]), factor = mpz_size(factor_at(f, false, i, i));
        fmb_run_count(run, (f->n - i) * (20 + limbs * factor / 3) + fmb_limbs_work(limbs));
        FMB_THEN(st, poll_row(run, f, i));
    }
    return st;
}

fmb_status fmb_minors_solve(fmb_minors *f, fmb_run *run, bool transposed, mpz_t *right,
                            const int *right_at, const int *at, mpz_t *x, mpz_t den)
{
    for (size_t k = 0; k < f->n; k++)
        mpz_set(f->y.z[k], right[right_at[k]]);
    mpz_srcptr det = factor_at(f, false, f->n - 1, f->n - 1);
    FMB_TRY(go_forwards(f, run, transposed));
    FMB_TRY(go_backwards(f, run, transposed, det));
    mpz_abs(den, det);
    for (size_t k = 0; k < f->n; k++)
        if (mpz_sgn(det) < 0)
            mpz_neg(x[at[k]], f->y.z[k]);
        else
            mpz_set(x[at[k]], f->y.z[k]);
    size_t limbs = mpz_size(den);
    fmb_run_count(run, (f->n * fmb_limbs_work(limbs) + 3 * fmb_gcd_work(limbs)) / 2);
    const fmb_poll poll = fmb_run_asked(run);
    return fmb_integers_cancel(x, f->n, den, &poll);
}
