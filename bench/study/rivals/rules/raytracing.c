/* raytracing.c: redundancy by rays from an interior point, then by small linear programs.
 *
 * If a ray from an interior point leaves the polyhedron through a single row, this row is
 * irredundant: points just behind it violate that row and no other. A ray is shot along each row's
 * normal; the rows hit are known. An undecided row i is tested by a linear program against the
 * known rows alone: if all their solutions satisfy i, it follows from kept rows and is dropped.
 * Else it returns a violating point p, and the ray to p leaves through a row: i itself, which
 * becomes known, or a new known row (p satisfies the old ones), and i is tested again. A ray
 * through two rows at once decides nothing; then i is tested against all present rows, and is
 * dropped or known. So every dropped row follows from kept rows, none of which is redundant.
 *
 * Without an interior point nothing is dropped, nor where numbers are too long. (Then a redundant
 * row may be marked `known`, which only costs time.) Source: Marechal, Perin 2017; Marechal,
 * Monniaux, Perin 2017 use it in projections.
 *
 * A number to check: of |x1| + ... + |x4| <= 1, written as 16 rows, k rounds leave 2^(4 - k) rows.
 */
#include "study/rivals/rules/rivals.h"

#include <fmb/gmp.h>

/* The known rows of a round, and an interior point x / denominator. */
typedef struct tracing {
    const fmb_view *w;
    int n;
    bool *drop, *known;
    mpz_t *x;     /* [n + 1]: the denominator last */
    mpz_t *to;    /* [n + 1]: likewise, another point, and then a direction */
    mpz_t *slack; /* [rows]: b - a.x, times the denominator */
    fmb_solver *solver;
} tracing;

static const int64_t *entries(const tracing *t, size_t i)
{
    return fmb_view_int64(t->w, fmb_view_row(t->w, i));
}

static fmb_rel relation(const tracing *t, size_t i)
{
    return fmb_view_rel(t->w, fmb_view_row(t->w, i));
}

static bool are_plain_inequalities(const tracing *t)
{
    for (size_t i = 0; i < fmb_view_rows(t->w); i++) {
        const int64_t *u = entries(t, i);
        for (int j = 0; u && j <= t->n; j++)
            if (u[j] == INT64_MIN)
                return false;
        if (!u || relation(t, i) == FMB_EQ)
            return false;
    }
    return true;
}

static void add_multiple(mpz_t sum, const mpz_t by, int64_t factor)
{
    if (factor >= 0)
        mpz_addmul_ui(sum, by, (unsigned long)factor);
    else
        mpz_submul_ui(sum, by, 0 - (unsigned long)factor);
}

/* a.d for the n coordinates of d. */
static void multiply(const tracing *t, const int64_t *a, mpz_t *d, mpz_t sum)
{
    mpz_set_ui(sum, 0);
    for (int j = 0; j < t->n; j++)
        add_multiple(sum, d[j], a[j]);
}

/* The row through which the ray from x along `to` leaves; the number of rows if there is none, or
 * several at once. Row i is reached after slack[i] / a.to, if a.to > 0. */
static size_t shoot(tracing *t)
{
    size_t rows = fmb_view_rows(t->w), nearest = rows;
    bool is_alone = true;
    mpz_t speed, best, left, right;
    mpz_inits(speed, best, left, right, NULL);
    for (size_t i = 0; i < rows; i++) {
        multiply(t, entries(t, i), t->to, speed);
        if (t->drop[i] || mpz_sgn(speed) <= 0)
            continue;
        int order = -1;
        if (nearest < rows) {
            mpz_mul(left, t->slack[i], best);
            mpz_mul(right, t->slack[nearest], speed);
            order = mpz_cmp(left, right);
        }
        if (order < 0) {
            nearest = i;
            mpz_set(best, speed);
        }
        if (order <= 0)
            is_alone = order < 0;
    }
    mpz_clears(speed, best, left, right, NULL);
    return is_alone ? nearest : rows;
}

/* The point of the last answer, over a common denominator; false if its numbers are too long. */
static bool read_point(const tracing *t, mpz_t *x)
{
    char text[4096];
    mpq_t q;
    mpq_init(q);
    mpz_set_ui(x[t->n], 1);
    for (int pass = 0; pass < 2; pass++)
        for (int j = 0; j < t->n; j++) {
            size_t size = fmb_solver_point_text(t->solver, j, text, sizeof text);
            if (size >= sizeof text || mpq_set_str(q, text, 10) != 0) {
                mpq_clear(q);
                return false;
            }
            if (pass == 0) {
                mpz_lcm(x[t->n], x[t->n], mpq_denref(q));
            } else {
                mpz_divexact(x[j], x[t->n], mpq_denref(q));
                mpz_mul(x[j], x[j], mpq_numref(q));
            }
        }
    mpq_clear(q);
    return true;
}

/* The negation of row i. */
static fmb_status add_reverse(const tracing *t, fmb_system *s, size_t i)
{
    int64_t *a = fmb_view_scratch(t->w, ((size_t)t->n + 1) * sizeof *a);
    if (!a)
        return FMB_ERR_MEMORY;
    for (int j = 0; j <= t->n; j++)
        a[j] = -entries(t, i)[j];
    return fmb_system_add_int(s, a, relation(t, i) == FMB_LT ? FMB_LE : FMB_LT, a[t->n]);
}

/* Does a point satisfy the known rows, or all present ones, and violate row `reverse`? `reverse`
 * past the end: is there a point strictly inside all rows? */
static fmb_status ask(const tracing *t, size_t reverse, bool of_all, bool *is_there)
{
    size_t rows = fmb_view_rows(t->w);
    fmb_result res = {.size = sizeof res};
    fmb_system *s = NULL;
    fmb_status st = fmb_system_new(t->n, NULL, &s);
    for (size_t k = 0; st == FMB_OK && k < rows; k++)
        if (k != reverse && !t->drop[k] && (of_all || t->known[k]))
            st = fmb_system_add_int(s, entries(t, k), reverse < rows ? relation(t, k) : FMB_LT,
                                    entries(t, k)[t->n]);
    if (st == FMB_OK && reverse < rows)
        st = add_reverse(t, s, reverse);
    if (st == FMB_OK)
        st = fmb_solve(t->solver, s, &res);
    *is_there = res.verdict == FMB_FEASIBLE;
    fmb_system_free(s);
    return st;
}

/* `to` becomes the direction from x to the point in it. */
static void aim(tracing *t)
{
    mpz_t back;
    mpz_init(back);
    for (int j = 0; j < t->n; j++) {
        mpz_mul(back, t->x[j], t->to[t->n]);
        mpz_mul(t->to[j], t->to[j], t->x[t->n]);
        mpz_sub(t->to[j], t->to[j], back);
    }
    mpz_clear(back);
}

/* Decide row i: dropped or known. */
static fmb_status decide(tracing *t, size_t i)
{
    bool is_there = false;
    fmb_status st = FMB_OK;
    while (st == FMB_OK && !t->known[i] && !t->drop[i]) {
        st = ask(t, i, false, &is_there);
        if (st != FMB_OK)
            return st;
        t->drop[i] = !is_there;
        t->known[i] = is_there && !read_point(t, t->to);
        if (t->drop[i] || t->known[i])
            return FMB_OK;
        aim(t);
        size_t hit = shoot(t);
        if (hit < fmb_view_rows(t->w) && !t->known[hit]) {
            t->known[hit] = true;
        } else {
            st = ask(t, i, true, &is_there);
            *(is_there ? &t->known[i] : &t->drop[i]) = true;
        }
    }
    return st;
}

/* Shoot the rays along the normals. */
static void shoot_normals(tracing *t)
{
    for (size_t i = 0; i < fmb_view_rows(t->w) && !fmb_view_stop(t->w); i++) {
        for (int j = 0; j < t->n; j++)
            mpz_set_si(t->to[j], entries(t, i)[j]);
        size_t hit = shoot(t);
        if (hit < fmb_view_rows(t->w))
            t->known[hit] = true;
    }
}

static fmb_status trace(tracing *t)
{
    size_t rows = fmb_view_rows(t->w);
    bool is_there;
    fmb_status st = ask(t, rows, true, &is_there);
    if (st != FMB_OK || !is_there || !read_point(t, t->x))
        return st;
    for (size_t i = 0; i < rows; i++) {
        multiply(t, entries(t, i), t->x, t->slack[i]);
        mpz_neg(t->slack[i], t->slack[i]);
        add_multiple(t->slack[i], t->x[t->n], entries(t, i)[t->n]);
    }
    shoot_normals(t);
    for (size_t i = 0; st == FMB_OK && i < rows && !fmb_view_stop(t->w); i++)
        st = decide(t, i);
    return st;
}

static mpz_t *numbers(const fmb_view *w, size_t n)
{
    mpz_t *x = fmb_view_scratch(w, n * sizeof *x);
    for (size_t i = 0; x && i < n; i++)
        mpz_init(x[i]);
    return x;
}

static void clear_numbers(mpz_t *x, size_t n)
{
    for (size_t i = 0; x && i < n; i++)
        mpz_clear(x[i]);
}

static fmb_status drop_redundant_rows(void *state, const fmb_view *w, bool *drop)
{
    size_t rows = fmb_view_rows(w);
    tracing t = {.w = w, .n = fmb_view_dim(w), .drop = drop};
    (void)state;
    if (rows == 0 || !are_plain_inequalities(&t))
        return FMB_OK;
    fmb_status st = fmb_solver_new(NULL, NULL, &t.solver);
    t.known = fmb_view_scratch(w, rows * sizeof *t.known);
    t.x = numbers(w, (size_t)t.n + 1);
    t.to = numbers(w, (size_t)t.n + 1);
    t.slack = numbers(w, rows);
    if (st == FMB_OK && !(t.known && t.x && t.to && t.slack))
        st = FMB_ERR_MEMORY;
    for (size_t i = 0; st == FMB_OK && i < rows; i++)
        t.known[i] = false;
    if (st == FMB_OK)
        st = trace(&t);
    clear_numbers(t.slack, rows);
    clear_numbers(t.to, (size_t)t.n + 1);
    clear_numbers(t.x, (size_t)t.n + 1);
    fmb_solver_free(t.solver);
    return st;
}

const fmb_rule rival_raytracing = {
    .name = "raytracing",
    .source = "MarechalPerin2017",
    .flags = FMB_RULE_BREAKS_HISTORY,
    .end_round = drop_redundant_rows,
};
