/* boundary.c: see boundary.h.
 *
 * A facet of M is the sum of a face of S0, one of S1 and, perhaps, the drift: its normal is at
 * right angles to D - 1 independent directions of edges of these faces and the drift. So of all
 * choices of D - 1 edges the normals are those of all facets, and others, which tell no less. In
 * four dimensions all choices are looked at. In more those edges of a face of a simplex are enough
 * that begin at its first corner: they span what all its edges span.
 *
 * Doubles (farther.h) tell of most normals that they reach farther than what is claimed, and where
 * they do not long doubles, by minors. Integers are as good as their first 53 bits: within 2^-52.
 * Let size be the sum of the products of a minor without signs. Of less than eight factors, whose
 * sums have at most eight terms, a minor is off by less than 2^-44 of its size, and so is what is
 * made of its products with the frames (40 terms). A number that is too large for them is none, and
 * then they tell nothing.
 */
#include "fmb-validate/boundary.h"

#include <math.h>

#include "fmb-validate/farther.h"

#define SHARE 0x1p-44L

enum { MOST = VALIDATE_MOST_DIM };

/* ---- normals --------------------------------------------------------------------------------- */

typedef struct search {
    validate_difference *m;
    mpq_srcptr square; /* the claim */
    long double length;
    int chosen[MOST], set[1 << MOST], from[MOST + 2];
    long double away[MOST], axis[2][MOST][MOST], drift[MOST], weight[MOST];
    long double edge[VALIDATE_MOST_EDGES][MOST];
    long double minor[1 << MOST], size[1 << MOST]; /* of the edges chosen, by sets of coordinates */
    int minors;                                    /* those of how many edges are there */
    validate_farther rough;
    mpz_t table[MOST][MOST]; /* [rows][dim] of the edges chosen first, in whole numbers */
    int rows, pivot[MOST],
        is_pivot[MOST]; /* columns; the row whose pivot is there, from 1 on, or 0 */
    mpz_t normal[MOST], reach, norm, part;
    int coarsest;
    bool any, equal, less; /* normals: that are not 0; that reach as far as is claimed; less far */
    bool told;             /* nothing more is to be learnt */
} search;

static long double nearly(const mpz_t z)
{
    long exponent;
    double x = mpz_get_d_2exp(&exponent, z);
    return ldexpl(x, (int)exponent);
}

static void read_long_doubles(search *s)
{
    validate_difference *m = s->m;
    for (int j = 0; j < m->dim; j++) {
        s->away[j] = nearly(m->away[j]);
        s->drift[j] = nearly(m->drift[j]);
        s->weight[j] = fabsl(s->away[j]) + fabsl(s->drift[j]);
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < m->naxes[k]; i++) {
                s->axis[k][i][j] = nearly(m->axis[k][i][j]);
                s->weight[j] += fabsl(s->axis[k][i][j]);
            }
        for (int i = 0; i < m->edges; i++)
            s->edge[i][j] = nearly(m->edge[i].x[j]);
    }
    s->length = sqrtl(nearly(mpq_numref(s->square)) / nearly(mpq_denref(s->square))) * (1 + SHARE);
}

/* Sets of coordinates by their number: those of k begin at from[k]. */
static void list_sets(search *s)
{
    int n = 0;
    for (int k = 0; k <= s->m->dim; k++) {
        s->from[k] = n;
        for (int set = 0; set < 1 << s->m->dim; set++)
            if (__builtin_popcount((unsigned)set) == k)
                s->set[n++] = set;
    }
    s->from[s->m->dim + 1] = n;
}

/* The minors of one edge more, from those before it. */
static void expand(search *s, int level)
{
    const long double *x = s->edge[s->chosen[level]];
    for (int i = s->from[level + 1]; i < s->from[level + 2]; i++) {
        int set = s->set[i], sign = 1;
        long double minor = 0, size = 0;
        for (int rest = set; rest != 0; rest &= rest - 1, sign = -sign) {
            int j = __builtin_ctz((unsigned)rest), less = set ^ 1 << j;
            minor += sign * x[j] * s->minor[less];
            size += fabsl(x[j]) * s->size[less];
        }
        s->minor[set] = minor;
        s->size[set] = size;
    }
}

static long double along(const search *s, const long double *n, const long double *x)
{
    long double sum = 0;
    for (int j = 0; j < s->m->dim; j++)
        sum += n[j] * x[j];
    return sum;
}

/* The least and the largest value of n.m on M. */
static void find_ends(const search *s, const long double *n, long double end[2])
{
    long double drift = along(s, n, s->drift);
    end[0] = end[1] = along(s, n, s->away);
    end[drift > 0] += drift;
    for (int k = 0; k < 2; k++) {
        long double sum[2] = {0, 0}, most[2] = {0, 0};
        for (int i = 0; i < s->m->naxes[k]; i++) {
            long double part = along(s, n, s->axis[k][i]);
            int up = part > 0;
            sum[up] += part;
            most[up] = fabsl(part) > fabsl(most[up]) ? part : most[up];
        }
        for (int up = 0; up < 2; up++)
            end[up] += s->m->simplex[k] ? most[up] : sum[up];
    }
}

/* Does M surely reach farther than claimed along the normal of the edges chosen, and back? */
static bool reaches_farther(search *s)
{
    int all = (1 << s->m->dim) - 1;
    long double n[MOST], end[2], norm = 0, off = 0;
    for (; s->minors < s->m->dim - 1; s->minors++)
        expand(s, s->minors);
    for (int j = 0; j < s->m->dim; j++) {
        long double fuzz = SHARE * s->size[all ^ 1 << j];
        n[j] = (j % 2 ? -1 : 1) * s->minor[all ^ 1 << j];
        long double length = ldexpl(fabsl(n[j]) + fuzz, -s->m->finer[j]);
        norm += length * length;
        off += 2 * fuzz * s->weight[j];
    }
    find_ends(s, n, end);
    long double beyond = off + (1 + SHARE) * s->length * sqrtl(norm);
    return end[1] > beyond && -end[0] > beyond;
}

/* ---- the same in whole numbers --------------------------------------------------------------- */

/* Row `level` of the table: the edge chosen there without what the rows before it have in their
 * pivots' columns; what it has in common with them then, the pivot before, goes out of it (E. H.
 * Bareiss). Its pivot is the first number that is left; false if none is: edges are dependent. */
static bool add_row(search *s, int level)
{
    int dim = s->m->dim, column = 0;
    mpz_t *row = s->table[level];
    for (int j = 0; j < dim; j++)
        mpz_set(row[j], s->m->edge[s->chosen[level]].x[j]);
    for (int i = 0; i < level; i++) {
        mpz_set(s->part, row[s->pivot[i]]);
        for (int j = 0; j < dim; j++) {
            if (s->is_pivot[j] && s->is_pivot[j] <= i + 1)
                continue;
            mpz_mul(row[j], row[j], s->table[i][s->pivot[i]]);
            mpz_submul(row[j], s->part, s->table[i][j]);
            if (i > 0)
                mpz_divexact(row[j], row[j], s->table[i - 1][s->pivot[i - 1]]);
        }
    }
    while (column < dim && (s->is_pivot[column] || mpz_sgn(row[column]) == 0))
        column++;
    if (column == dim)
        return false;
    s->pivot[level] = column;
    s->is_pivot[column] = level + 1;
    return true;
}

/* The rows of edges that are no longer chosen are none. */
static void forget_rows(search *s, int level)
{
    while (s->rows > level)
        s->is_pivot[s->pivot[--s->rows]] = 0;
}

/* Where no pivot is the normal is the last pivot, a minor; so all its numbers are whole, and follow
 * from the rows, the last one first. False if edges are dependent. */
static bool find_normal(search *s)
{
    int dim = s->m->dim, last = dim - 2, without = 0;
    for (; s->rows <= last; s->rows++)
        if (!add_row(s, s->rows))
            return false;
    while (s->is_pivot[without])
        without++;
    mpz_set(s->normal[without], s->table[last][s->pivot[last]]);
    for (int i = last; i >= 0; i--) {
        mpz_ptr x = s->normal[s->pivot[i]];
        mpz_set_ui(s->part, 0);
        for (int j = 0; j < dim; j++)
            if (!s->is_pivot[j] || s->is_pivot[j] > i + 1)
                mpz_submul(s->part, s->table[i][j], s->normal[j]);
        mpz_divexact(x, s->part, s->table[i][s->pivot[i]]);
    }
    return true;
}

/* The square of the length of the normal, in one unit and times 4^coarsest. */
static void measure_normal(search *s)
{
    mpz_set_ui(s->norm, 0);
    for (int j = 0; j < s->m->dim; j++) {
        mpz_mul(s->part, s->normal[j], s->normal[j]);
        mpz_mul_2exp(s->part, s->part, 2 * (mp_bitcnt_t)(s->coarsest - s->m->finer[j]));
        mpz_add(s->norm, s->norm, s->part);
    }
}

/* reach / |n|, there or back, beside what is claimed. */
static void compare_reach(search *s)
{
    validate_ends(s->m, s->normal, s->part, s->reach);
    mpz_neg(s->part, s->part);
    if (mpz_cmp(s->part, s->reach) < 0)
        mpz_swap(s->part, s->reach);
    int order = mpz_sgn(s->reach);
    if (order > 0) {
        mpz_mul(s->reach, s->reach, s->reach);
        mpz_mul_2exp(s->reach, s->reach, 2 * (mp_bitcnt_t)s->coarsest);
        mpz_mul(s->reach, s->reach, mpq_denref(s->square));
        measure_normal(s);
        mpz_mul(s->norm, s->norm, mpq_numref(s->square));
        order = mpz_cmp(s->reach, s->norm);
    } else if (order == 0) {
        order = -mpq_sgn(s->square);
    }
    s->equal |= order == 0;
    s->less |= order < 0;
}

/* As 0 is in M no normal reaches less far than 0: if that is claimed then one that does is enough.
 * `told`: doubles tell that the edges are independent. */
static void look_at_normal(search *s, bool told)
{
    if ((told && validate_is_farther(&s->rough)) || reaches_farther(s)) {
        s->any = true;
        return;
    }
    if (!find_normal(s))
        return;
    s->any = true;
    compare_reach(s);
    s->told = s->less || (s->equal && mpq_sgn(s->square) == 0);
}

/* Is the edge chosen last independent of those before it? As long as doubles tell, of rows in whole
 * numbers otherwise. */
static bool is_independent(search *s, int level, bool *told)
{
    forget_rows(s, level);
    s->minors = s->minors < level ? s->minors : level;
    *told = *told && validate_farther_choose(&s->rough, level, &s->m->edge[s->chosen[level]]);
    if (*told)
        return true;
    for (; s->rows <= level; s->rows++)
        if (!add_row(s, s->rows))
            return false;
    return true;
}

/* So many at most can be chosen behind that one. */
static int edges_after(const validate_difference *m, int i)
{
    const validate_edge *e = &m->edge[i];
    if (m->dim <= 4 || e->side == 2)
        return m->edges - 1 - i;
    return m->naxes[e->side] - e->to + (e->side == 0 ? m->naxes[1] : 0) + m->moves;
}

/* All choices that go on from the first `level`, which are independent; told: doubles tell so. */
static void choose(search *s, int level, int from, bool told)
{
    if (level == s->m->dim - 1) {
        look_at_normal(s, told);
        return;
    }
    const validate_edge *last = level > 0 ? &s->m->edge[s->chosen[level - 1]] : NULL;
    for (int i = from; i < s->m->edges && !s->told; i++) {
        const validate_edge *next = &s->m->edge[i];
        bool still = told;
        if (s->m->dim > 4 && last && last->side == next->side && last->corner != next->corner)
            continue;
        if (edges_after(s->m, i) < s->m->dim - 2 - level)
            continue;
        s->chosen[level] = i;
        if (is_independent(s, level, &still))
            choose(s, level + 1, i + 1, still);
    }
}

/* Any interior that M has is inside of all its facets, and the nearest of these is as far from 0 as
 * the boundary. If M lies in one plane its normal is among these, and reaches 0 far one way; if in
 * less than a plane, all are 0. */
bool validate_depth_is(validate_difference *m, const mpq_t square)
{
    search s = {.m = m, .square = square, .minor[0] = 1, .size[0] = 1};
    for (int i = 0; i < MOST; i++) {
        mpz_init(s.normal[i]);
        for (int j = 0; j < MOST; j++)
            mpz_init(s.table[i][j]);
    }
    mpz_inits(s.reach, s.norm, s.part, NULL);
    for (int j = 0; j < m->dim; j++)
        s.coarsest = m->finer[j] > s.coarsest ? m->finer[j] : s.coarsest;
    read_long_doubles(&s);
    list_sets(&s);
    validate_farther_load(&s.rough, m, square);
    choose(&s, 0, 0, true);
    for (int i = 0; i < MOST; i++) {
        mpz_clear(s.normal[i]);
        for (int j = 0; j < MOST; j++)
            mpz_clear(s.table[i][j]);
    }
    mpz_clears(s.reach, s.norm, s.part, NULL);
    return !s.less && (s.any ? s.equal : mpq_sgn(square) == 0);
}
