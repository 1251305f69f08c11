/* implied.c: redundancy by guessed multipliers; see implied.h.
 *
 * A row (a, b) is implied by others if it is a nonnegative combination of them and of (0, 1). Which
 * rows, and with which multipliers, is guessed in doubles (simplex.h); multipliers that look like
 * simple fractions are taken for those, and then the combination is checked in integers. Only rows
 * that are awake are looked at: a row that they do not imply gives a hyperplane, the row that lies
 * farthest beyond it is woken, and the search goes on (Clarkson 1994). At last the rows awake are
 * tried themselves. A row that goes was implied by rows that were there: so all go in one order.
 */
#include "lp/redundancy/implied.h"

#include <math.h>

#include "lp/exact/simplex.h"
#include "lp/float/simplex.h"
#include "lp/redundancy/inside.h"
#include "lp/redundancy/named.h"
#include "num/gcd.h"

/* Denominators of multipliers, and of all of them together. */
#define MOST_ONE 4096
#define MOST_ALL ((int64_t)1 << 31)
/* Numbers below these are taken for rounding errors, in multipliers and in pivots: inputs are about
 * 1. */
#define ROUNDING    1e-9
#define LEAST_PIVOT 1e-7
/* Rows shot at before the search: each shot looks at all rows. */
#define MOST_SHOTS 1024

typedef struct search {
    fmb_run *run;
    fmb_named named;
    size_t n, m, d;               /* columns, rows, columns with the right side */
    const fmb_lp_row *row;        /* the named ones */
    double *at;                   /* [d][m] rows, scaled */
    int *exponent;                /* [m] row = 2^exponent times what is in at */
    double *target, *price, *way; /* [d], [m], [n] */
    size_t *number;               /* [m] of the row's generator, SIZE_MAX: asleep */
    size_t *source; /* [m + 1] row of a generator; m: the unit vector of the right side */
    size_t generators;
    fmb_basis cone;
    bool *gone;
    fmb_sorting *out;
    fmb_inside inside; /* used if out->inner */
} search;

/* ---- proof ----------------------------------------------------------------------------------- */

/* The fraction p / q, q <= MOST_ONE, next to v by continued fractions; false if none is near. */
static bool find_simple_fraction(double v, int64_t *p, int64_t *q)
{
    int64_t p0 = 0, q0 = 1, p1 = 1, q1 = 0;
    double rest = fabs(v), size = 1e-7 * (1 + rest);
    if (!(rest < 1e6))
        return false;
    for (;;) {
        double whole = floor(rest + 1e-9);
        int64_t a = (int64_t)whole, p2 = a * p1 + p0, q2 = a * q1 + q0;
        if (q2 > MOST_ONE || p2 >= MOST_ALL)
            return false;
        p0 = p1, q0 = q1, p1 = p2, q1 = q2;
        if (fabs((double)p1 / (double)q1 - fabs(v)) <= size)
            break;
        rest = 1 / (rest - whole);
    }
    *p = v < 0 ? -p1 : p1;
    *q = q1;
    return true;
}

/* A combination being proved: multipliers part[i] / all of rows index[i]. */
typedef struct claim {
    size_t *index;
    int64_t *part, *unit; /* unit: own denominators */
    size_t size;
    int64_t all;
} claim;

/* Round the multipliers of the basis for target i; false if they are not simple. */
static bool round_multipliers(const search *s, size_t i, claim *c)
{
    c->size = 0;
    c->all = 1;
    for (size_t r = 0; r < s->d; r++) {
        size_t g = s->cone.basic[r], j = g == SIZE_MAX ? s->m : s->source[g];
        if (g == SIZE_MAX || j == s->m || fabs(s->cone.value[r]) < ROUNDING)
            continue;
        double v = ldexp(s->cone.value[r], s->exponent[i] - s->exponent[j]);
        if (!find_simple_fraction(v, &c->part[c->size], &c->unit[c->size]))
            return false;
        int64_t unit = c->unit[c->size];
        c->index[c->size++] = j;
        c->all *= unit / (int64_t)fmb_gcd64((uint64_t)c->all, (uint64_t)unit);
        if (c->all >= MOST_ALL)
            return false;
    }
    for (size_t k = 0; k < c->size; k++)
        if (__builtin_mul_overflow(c->part[k], c->all / c->unit[k], &c->part[k]) ||
            fmb_bits64(fmb_abs64(c->part[k])) > 54)
            return false;
    return true;
}

/* all (row i) - sum part_k row_k, at entry j. Fewer than 2^8 products of 54 + 62 bits. */
static fmb_i128 claim_difference_at(const search *s, size_t i, const claim *c, size_t j)
{
    fmb_i128 sum = (fmb_i128)c->all * s->row[i].v->s[j];
    for (size_t k = 0; k < c->size; k++)
        sum -= (fmb_i128)c->part[k] * s->row[c->index[k]].v->s[j];
    return sum;
}

/* Does the claim prove row i: the same coefficients, and no larger a right side? A strict row needs
 * a smaller one, or a strict row among the parts. */
static bool proves_row_implied(const search *s, size_t i, const claim *c)
{
    bool strict = false;
    for (size_t k = 0; k < c->size; k++) {
        if (c->part[k] < 0 && s->row[c->index[k]].rel != FMB_EQ)
            return false;
        strict |= s->row[c->index[k]].rel == FMB_LT && c->part[k] > 0;
    }
    for (size_t j = 0; j < s->n; j++)
        if (claim_difference_at(s, i, c, j) != 0)
            return false;
    fmb_i128 slack = claim_difference_at(s, i, c, s->n);
    return slack > 0 || (slack == 0 && (strict || s->row[i].rel != FMB_LT));
}

/* The cone says that row i is implied: prove it, and let it go. */
static fmb_status drop_row_if_proved(search *s, size_t i)
{
    fmb_mem *mem = s->run->mem;
    claim c = {0};
    c.index = fmb_mem_get(mem, s->d, sizeof *c.index);
    c.part = fmb_mem_get(mem, s->d, sizeof *c.part);
    c.unit = fmb_mem_get(mem, s->d, sizeof *c.unit);
    fmb_status st = c.index && c.part && c.unit ? FMB_OK : fmb_mem_status(mem);
    if (st == FMB_OK && round_multipliers(s, i, &c) && proves_row_implied(s, i, &c)) {
        s->gone[i] = true;
        if (s->number[i] != SIZE_MAX)
            s->cone.range[s->number[i]] = FMB_RANGE_ZERO;
    } else if (st == FMB_OK) {
        s->out->doubtful++;
    }
    fmb_mem_put(mem, c.index, s->d, sizeof *c.index);
    fmb_mem_put(mem, c.part, s->d, sizeof *c.part);
    fmb_mem_put(mem, c.unit, s->d, sizeof *c.unit);
    return st;
}

/* ---- guess ----------------------------------------------------------------------------------- */

static void aim_at_row(search *s, size_t i)
{
    for (size_t k = 0; k < s->d; k++)
        s->target[k] = s->at[k * s->m + i];
}

static fmb_status add_row_to_cone(search *s, size_t i)
{
    aim_at_row(s, i);
    s->number[i] = s->generators;
    s->source[s->generators++] = i;
    return fmb_basis_add(&s->cone, s->target,
                         s->row[i].rel == FMB_EQ ? FMB_RANGE_FREE : FMB_RANGE_UP);
}

/* The sleeping row farthest beyond the hyperplane. */
static size_t find_farthest_asleep(search *s)
{
    size_t best = SIZE_MAX;
    double least = 0;
    for (size_t i = 0; i < s->m; i++)
        s->price[i] = 0;
    for (size_t k = 0; k < s->d; k++)
        s->run->kernels->accumulate(s->price, &s->at[k * s->m], s->m, s->cone.normal[k]);
    for (size_t i = 0; i < s->m; i++)
        if (s->number[i] == SIZE_MAX && !s->gone[i] && s->price[i] < least) {
            least = s->price[i];
            best = i;
        }
    return best;
}

/* Wake rows until those awake imply row i, or it is awake itself. */
static fmb_status test_row_asleep(search *s, size_t i)
{
    fmb_status st = FMB_OK;
    while (st == FMB_OK && s->number[i] == SIZE_MAX) {
        aim_at_row(s, i);
        fmb_guess guess;
        st = fmb_simplex_search(&s->cone, s->target, SIZE_MAX, s->run, &guess);
        if (st == FMB_OK && guess == FMB_GUESS_INSIDE)
            st = drop_row_if_proved(s, i);
        if (guess == FMB_GUESS_INSIDE && s->gone[i])
            return st;
        size_t j = guess == FMB_GUESS_OUTSIDE ? find_farthest_asleep(s) : i;
        if (st == FMB_OK)
            st = add_row_to_cone(s, j == SIZE_MAX ? i : j);
        if (st == FMB_OK)
            st = fmb_run_poll(s->run);
    }
    return st;
}

/* Behind the hyperplane lies a point that breaks row i and no other row awake: shoot there. */
static void shoot_beyond_normal(search *s)
{
    const double *normal = s->cone.normal;
    double *way = s->way, depth = normal[s->d - 1];
    if (!s->out->inner)
        return;
    for (size_t j = 0; j < s->n; j++) /* at the scale of the point, 1 / depth */
        way[j] = -normal[j] - depth * s->inside.x[j];
    size_t hit = fmb_inside_shoot(&s->inside, way, s->gone);
    if (hit != SIZE_MAX)
        s->out->kept[hit] = true;
}

static fmb_status test_row_awake(search *s, size_t i)
{
    fmb_guess guess;
    aim_at_row(s, i);
    fmb_status st = fmb_simplex_search(&s->cone, s->target, s->number[i], s->run, &guess);
    if (st == FMB_OK && guess == FMB_GUESS_INSIDE)
        st = drop_row_if_proved(s, i);
    else if (st == FMB_OK && guess == FMB_GUESS_OUTSIDE)
        shoot_beyond_normal(s);
    return st == FMB_OK ? fmb_run_poll(s->run) : st;
}

/* Shoot at every row: what is hit needs no search. */
static fmb_status shoot_at_every_row(search *s)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && s->out->inner && i < s->m && i < MOST_SHOTS; i++) {
        for (size_t j = 0; j < s->n; j++)
            s->way[j] = (double)s->row[i].v->s[j];
        size_t hit = fmb_inside_shoot(&s->inside, s->way, s->gone);
        if (hit != SIZE_MAX)
            s->out->kept[hit] = true;
        st = fmb_run_poll(s->run);
    }
    return st;
}

static bool is_row_settled(const search *s, size_t i)
{
    return s->gone[i] || s->row[i].rel == FMB_EQ || (s->out->kept && s->out->kept[i]);
}

static fmb_status test_all_rows(search *s)
{
    fmb_status st = shoot_at_every_row(s);
    for (size_t i = 0; st == FMB_OK && i < s->m; i++)
        if (is_row_settled(s, i) && s->number[i] == SIZE_MAX)
            st = add_row_to_cone(s, i);
    for (size_t i = 0; st == FMB_OK && i < s->m; i++)
        if (s->number[i] == SIZE_MAX)
            st = test_row_asleep(s, i);
    s->out->doubtful = 0; /* they were woken, and are tried again */
    for (size_t i = 0; st == FMB_OK && i < s->m; i++)
        if (!is_row_settled(s, i))
            st = test_row_awake(s, i);
    return st;
}

/* ---- frame ----------------------------------------------------------------------------------- */

/* The right side as generator 0, and rows until they span what they can. */
static fmb_status span_cone_by_rows(search *s)
{
    for (size_t k = 0; k < s->d; k++)
        s->target[k] = k + 1 == s->d;
    s->source[s->generators++] = s->m;
    fmb_status st = fmb_basis_add(&s->cone, s->target, FMB_RANGE_UP);
    if (st == FMB_OK)
        fmb_basis_span(&s->cone, 0);
    for (size_t i = 0; st == FMB_OK && i < s->m && s->cone.pivots < s->d; i++) {
        st = add_row_to_cone(s, i);
        if (st == FMB_OK)
            fmb_basis_span(&s->cone, s->number[i]);
        if (st == FMB_OK)
            st = fmb_run_poll(s->run);
    }
    return st;
}

static void scale_row_to_unit(search *s, size_t i)
{
    const fmb_vec *v = s->row[i].v;
    s->exponent[i] = v->bits;
    for (size_t k = 0; k < s->d; k++)
        s->at[k * s->m + i] = ldexp((double)v->s[k], -v->bits);
}

static fmb_status open_cone_search(search *s)
{
    fmb_mem *mem = s->run->mem;
    s->at = fmb_mem_get(mem, s->d * s->m, sizeof *s->at);
    s->exponent = fmb_mem_get(mem, s->m, sizeof *s->exponent);
    s->target = fmb_mem_get(mem, s->d, sizeof *s->target);
    s->price = fmb_mem_get(mem, s->m, sizeof *s->price);
    s->way = fmb_mem_get(mem, s->n, sizeof *s->way);
    s->number = fmb_mem_get(mem, s->m, sizeof *s->number);
    s->source = fmb_mem_get(mem, s->m + 1, sizeof *s->source);
    if (!s->at || !s->exponent || !s->target || !s->price || !s->way || !s->number || !s->source)
        return fmb_mem_status(mem);
    for (size_t i = 0; i < s->m; i++) {
        scale_row_to_unit(s, i);
        s->number[i] = SIZE_MAX;
    }
    fmb_status st = fmb_basis_init(&s->cone, s->run->mem, s->run->kernels, s->d);
    s->cone.value_zero = ROUNDING;
    s->cone.entry_zero = LEAST_PIVOT;
    return st;
}

static void close_cone_search(search *s)
{
    fmb_mem *mem = s->run->mem;
    fmb_basis_clear(&s->cone);
    if (s->inside.run)
        fmb_inside_clear(&s->inside);
    fmb_mem_put(mem, s->at, s->d * s->m, sizeof *s->at);
    fmb_mem_put(mem, s->exponent, s->m, sizeof *s->exponent);
    fmb_mem_put(mem, s->target, s->d, sizeof *s->target);
    fmb_mem_put(mem, s->price, s->m, sizeof *s->price);
    fmb_mem_put(mem, s->way, s->n, sizeof *s->way);
    fmb_mem_put(mem, s->number, s->m, sizeof *s->number);
    fmb_mem_put(mem, s->source, s->m + 1, sizeof *s->source);
}

static bool are_rows_small(size_t m, const fmb_lp_row *row)
{
    for (size_t i = 0; i < m; i++)
        if (row[i].v->z)
            return false;
    return true;
}

static fmb_status ask_oracle_if_feasible(search *s)
{
    fmb_lp lp;
    fmb_status st = fmb_lp_init(&lp, s->run, (int)s->n, s->m, s->row, false);
    if (st == FMB_OK)
        st = fmb_lp_feasible(&lp, &s->out->feasible);
    fmb_lp_clear(&lp);
    return st;
}

/* Where there is no solution, the search goes on to its end: so unless one is known, a glance comes
 * first, and then the oracle, which is not asked about most systems that have one. */
static fmb_status look_for_inner_point(search *s)
{
    bool possible, known = s->out->known, *inner = &s->out->inner;
    fmb_status st = fmb_inside_open(&s->inside, s->run, s->n, s->m, s->row, &possible);
    if (st == FMB_OK && possible && !known)
        st = fmb_inside_glance(&s->inside, inner);
    if (st == FMB_OK && !known && !*inner)
        st = ask_oracle_if_feasible(s);
    if (st == FMB_OK && possible && !*inner && s->out->feasible)
        st = fmb_inside_find(&s->inside, inner);
    return st;
}

static fmb_status sort_named_rows(search *s)
{
    fmb_status st = open_cone_search(s);
    if (st == FMB_OK && s->out->kept)
        st = look_for_inner_point(s);
    if (st == FMB_OK && s->out->feasible)
        st = span_cone_by_rows(s);
    if (st == FMB_OK && s->out->feasible)
        st = test_all_rows(s);
    close_cone_search(s);
    return st;
}

/* Differences of products have to fit: see there. */
#define MOST_COLUMNS 200

fmb_status fmb_lp_sort_rows(fmb_run *run, int n, size_t m, const fmb_lp_row *row, fmb_sorting *out)
{
    search s = {.run = run, .m = m, .gone = out->gone, .out = out};
    fmb_status st = FMB_OK;
    bool small = are_rows_small(m, row);
    out->doubtful = 0;
    out->inner = false;
    out->feasible = true;
    if (small)
        st = fmb_named_open(&s.named, run->mem, (size_t)n, m, row);
    s.n = s.named.n;
    s.d = s.n + 1;
    s.row = s.named.row;
    if (small && s.n <= MOST_COLUMNS)
        st = st == FMB_OK ? sort_named_rows(&s) : st;
    else
        out->doubtful = m;
    if (small)
        fmb_named_clear(&s.named);
    return st;
}
