/* active_test.c: redundancy tests on few rows at a time; see active_test.h.
 *
 * Most rows of a large system matter to few tests. So rows sleep, and a test looks at those awake:
 * if they imply the row, it is redundant; if not, there is a point that they let in and the row
 * does not. Should a sleeping row keep that point out, it is activated, and the test goes on; else
 * the point shows that the row is irredundant. Which row to wake is a guess in doubles (the first
 * that the way from a center to the point meets: it is irredundant itself, as a rule); that none is
 * violated is checked exactly. Source: Clarkson 1994, More output-sensitive geometric algorithms.
 */
#include "lp/redundancy/active_test.h"

#include "lp/dictionary/dictionary_read.h"

void fmb_lp_deactivate(fmb_lp *lp)
{
    for (size_t i = 0; i < lp->m; i++)
        if (lp->slack[i] == FMB_SLACK_ACTIVE && lp->where[(size_t)lp->n + i] < lp->m)
            lp->slack[i] = FMB_SLACK_INACTIVE;
}

void fmb_lp_add_point(const fmb_lp *lp, double *sum)
{
    for (size_t j = 0; j < (size_t)lp->n; j++)
        if (lp->where[j] < lp->m)
            sum[j] += fmb_lp_ratio(lp, lp->where[j], fmb_lp_place(lp, FMB_LP_K));
}

/* ---- waking ---------------------------------------------------------------------------------- */

/* z[0 .. n + 2] += factor * (x_v times the common denominator), from the dictionary row of x_v. */
static void add_multiple_of_x(const fmb_lp *lp, size_t v, const mpz_t factor, const mpz_t common,
                              mpz_t *z, mpz_t t)
{
    size_t n = (size_t)lp->n, r = lp->where[v];
    if (r >= lp->m) {
        mpz_addmul(z[r - lp->m], factor, common);
        return;
    }
    const fmb_vec *row = &lp->row[r];
    mpz_t share;
    mpz_init(share);
    fmb_vec_get(row, n + FMB_LP_OWN, t);
    mpz_neg(t, t);
    mpz_divexact(share, common, t);
    mpz_mul(share, share, factor);
    for (size_t j = 0; j < n + FMB_LP_SCRATCH; j++) {
        if (j == n + FMB_LP_OWN)
            continue;
        fmb_vec_get(row, j, t);
        mpz_addmul(z[j], share, t);
    }
    mpz_clear(share);
}

/* common = least common multiple of the denominators of the x that row i names. */
static void common_denominator(const fmb_lp *lp, size_t i, mpz_t common, mpz_t t)
{
    mpz_set_ui(common, 1);
    for (size_t v = 0; v < (size_t)lp->n; v++) {
        if (fmb_vec_sgn(lp->source[i].v, v) == 0 || lp->where[v] >= lp->m)
            continue;
        fmb_vec_get(&lp->row[lp->where[v]], fmb_lp_place(lp, FMB_LP_OWN), t);
        mpz_lcm(common, common, t);
    }
}

/* s_i = b - delta [strict] - a.x, with every x as the dictionary has it now. */
static fmb_status rebuild_dictionary_row(fmb_lp *lp, size_t i, mpz_t *z)
{
    size_t n = (size_t)lp->n;
    const fmb_vec *source = lp->source[i].v;
    mpz_t common, a, t;
    mpz_inits(common, a, t, NULL);
    common_denominator(lp, i, common, t);
    fmb_vec_get(source, n, z[n + FMB_LP_K]);
    mpz_mul(z[n + FMB_LP_K], z[n + FMB_LP_K], common);
    if (lp->strict[i])
        mpz_neg(z[n + FMB_LP_D], common);
    mpz_neg(z[n + FMB_LP_OWN], common);
    for (size_t v = 0; v < n; v++) {
        if (fmb_vec_sgn(source, v) == 0)
            continue;
        fmb_vec_get(source, v, a);
        mpz_neg(a, a);
        add_multiple_of_x(lp, v, a, common, z, t);
    }
    mpz_clears(common, a, t, NULL);
    fmb_vec *row = &lp->row[lp->where[n + i]];
    fmb_status st = fmb_vec_set_z(row, n + 4, z, lp->run->mem);
    return st == FMB_OK ? fmb_vec_reduce(row, n + 4, &lp->num) : st;
}

static fmb_status activate_inactive_row(fmb_lp *lp, size_t i)
{
    size_t width = fmb_lp_width(lp);
    mpz_t *z = fmb_mem_get(lp->run->mem, width, sizeof *z);
    if (!z)
        return fmb_mem_status(lp->run->mem);
    for (size_t j = 0; j < width; j++)
        mpz_init(z[j]);
    fmb_status st = rebuild_dictionary_row(lp, i, z);
    if (st == FMB_OK)
        lp->slack[i] = FMB_SLACK_ACTIVE;
    for (size_t j = 0; j < width; j++)
        mpz_clear(z[j]);
    fmb_mem_put(lp->run->mem, z, width, sizeof *z);
    return st;
}

/* ---- which row to wake ----------------------------------------------------------------------- */

/* a.x - b of row i, roughly. */
static double rough_excess(const fmb_lp *lp, size_t i, const double *x)
{
    const fmb_vec *v = lp->source[i].v;
    size_t n = (size_t)lp->n;
    double sum = v->z ? -mpz_get_d(v->z[n]) : -(double)v->s[n];
    for (size_t j = 0; j < n; j++)
        if (fmb_vec_sgn(v, j) != 0)
            sum += (v->z ? mpz_get_d(v->z[j]) : (double)v->s[j]) * x[j];
    return sum;
}

/* The sleeping row that the way from the center to x meets first, SIZE_MAX if none seems to be met.
 */
static size_t find_first_row_met(const fmb_lp *lp, const double *center, mpq_t *point, double *x)
{
    size_t best = SIZE_MAX;
    double best_time = 1;
    for (size_t j = 0; j < (size_t)lp->n; j++)
        x[j] = mpq_get_d(point[j]);
    for (size_t i = 0; i < lp->m; i++) {
        if (lp->slack[i] != FMB_SLACK_INACTIVE)
            continue;
        double from = rough_excess(lp, i, center), to = rough_excess(lp, i, x),
               time = from / (from - to);
        if (to > 0 && from < 0 && time < best_time) {
            best = i;
            best_time = time;
        }
    }
    return best;
}

/* Does x break row i? */
static bool does_point_break_row(const fmb_lp *lp, size_t i, mpq_t *x, mpq_t sum, mpq_t t)
{
    const fmb_vec *v = lp->source[i].v;
    mpq_set_ui(sum, 0, 1);
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        if (fmb_vec_sgn(v, j) == 0)
            continue;
        fmb_vec_get(v, j, mpq_numref(t));
        mpz_set_ui(mpq_denref(t), 1);
        mpq_mul(t, t, x[j]);
        mpq_add(sum, sum, t);
    }
    fmb_vec_get(v, (size_t)lp->n, mpq_numref(t));
    mpz_set_ui(mpq_denref(t), 1);
    int order = mpq_cmp(sum, t);
    return lp->strict[i] ? order >= 0 : order > 0;
}

/* Wake every sleeping row that x breaks; *count of them. */
static fmb_status activate_rows_broken(fmb_lp *lp, mpq_t *x, size_t *count)
{
    fmb_status st = FMB_OK;
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    *count = 0;
    for (size_t i = 0; st == FMB_OK && i < lp->m; i++) {
        if (lp->slack[i] != FMB_SLACK_INACTIVE || !does_point_break_row(lp, i, x, sum, t))
            continue;
        ++*count;
        st = activate_inactive_row(lp, i);
    }
    mpq_clears(sum, t, NULL);
    return st == FMB_OK ? fmb_run_poll(lp->run) : st;
}

/* Wake what keeps x out, if anything does; then make the dictionary feasible again. */
static fmb_status activate_what_keeps_out(fmb_lp *lp, const double *center, mpq_t *x, double *room,
                                          size_t *count)
{
    bool feasible;
    fmb_status st;
    size_t i = find_first_row_met(lp, center, x, room);
    *count = 1;
    if (i != SIZE_MAX)
        st = activate_inactive_row(lp, i);
    else
        st = activate_rows_broken(lp, x, count);
    if (st != FMB_OK || *count == 0)
        return st;
    return fmb_lp_make_feasible(lp, &feasible);
}

fmb_status fmb_lp_test_active(fmb_lp *lp, size_t i, const double *center, mpq_t *x, fmb_lp_end *end)
{
    size_t n = (size_t)lp->n, activated = 1;
    fmb_status st = FMB_OK;
    double *room = fmb_mem_get(lp->run->mem, n, sizeof *room);
    if (!room)
        return fmb_mem_status(lp->run->mem);
    if (lp->slack[i] == FMB_SLACK_INACTIVE)
        st = activate_inactive_row(lp, i);
    while (st == FMB_OK && activated > 0) {
        st = fmb_lp_test(lp, i, end);
        if (st != FMB_OK || *end != FMB_LP_VIOLATED)
            break;
        st = fmb_lp_violation(lp, x);
        if (st == FMB_OK)
            st = activate_what_keeps_out(lp, center, x, room, &activated);
    }
    fmb_mem_put(lp->run->mem, room, n, sizeof *room);
    return st;
}
