/* tiny_load.c: copies rows into a table on the stack.
 *
 * Of the rows with one variable only the tightest of each side is kept. Its end, rounded outward to
 * an integer, is an end of the box: the box may be larger than the rows require, and a row that
 * holds strictly, or fails, in all of it does so in the smaller box.
 */
#include "elim/tiny/tiny_private.h"
#include "num/gcd.h"
#include "system/system_private.h"

static void ask_for_memory(const void *p)
{
#ifdef __GNUC__
    __builtin_prefetch(p);
#else
    (void)p;
#endif
}

/* Base rows that are ends: row[side][variable], or -1. */
typedef struct load_ends {
    int row[2][FMB_TINY_WORDS];
} load_ends;

/* a.x REL b: coefficients a[0..nnz) of the variables var[k], and b = a[nnz]. */
typedef struct load_row {
    size_t nnz;
    const int *var;
    const int64_t *a;
    int bits;
    bool strict;
    uint64_t history;
    int own_var[FMB_TINY_WORDS]; /* memory for var and a */
    int64_t own[FMB_TINY_WORDS];
} load_row;

/* Is a x REL b tighter than row i on the same side of the same variable? */
static bool is_tighter_end(const fmb_tiny_table *base, int i, const load_row *r)
{
    fmb_i128 mine = fmb_i128_product(r->a[1], (int64_t)fmb_abs64(base->a[i][r->var[0] + 1]));
    fmb_i128 its = fmb_i128_product(base->a[i][0], (int64_t)fmb_abs64(r->a[0]));
    int order = fmb_i128_compare(mine, its);
    return order < 0 || (order == 0 && r->strict && !base->strict[i]);
}

static void put_base_row(fmb_tiny_table *base, int i, const load_row *r)
{
    int64_t *a = base->a[i];
    for (int k = 0; k < FMB_TINY_WORDS; k++)
        a[k] = 0;
    for (size_t k = 0; k < r->nnz; k++)
        a[r->var[k] + 1] = r->a[k];
    a[0] = r->a[r->nnz];
    base->history[i] = r->history;
    base->bits[i] = (uint8_t)r->bits;
    base->strict[i] = r->strict;
}

/* Make a row with one variable an end, unless there is a tighter one. */
static void put_end_row(fmb_tiny_table *base, load_ends *e, const load_row *r)
{
    int *end = &e->row[r->a[0] > 0][r->var[0] + 1];
    if (*end < 0)
        put_base_row(base, *end = base->rows++, r);
    else if (is_tighter_end(base, *end, r))
        put_base_row(base, *end, r);
}

/* The greatest integer that is at most b / a, for a > 0. */
static int64_t floor_divide(int64_t b, int64_t a)
{
    return a == 1 ? b : b / a - (b % a < 0);
}

/* Ends that are too large for the sums in tiny_box.c are left out. */
static void make_outward_box(fmb_tiny *t, const load_ends *e)
{
    t->open[0] = t->open[1] = 0;
    for (int k = 1; k <= t->n; k++) {
        for (int side = 0; side < 2; side++) {
            int i = e->row[side][k];
            t->end_history[side][k] = i < 0 ? 0 : t->now->history[i];
            if (i >= 0) {
                const int64_t *a = t->now->a[i];
                t->end[side][k] = side ? -floor_divide(-a[0], a[k]) : floor_divide(-a[0], -a[k]);
            }
            bool open = i < 0 || fmb_bits64(fmb_abs64(t->end[side][k])) > FMB_TINY_END_BITS;
            t->open[side] |= (unsigned)open << k;
            if (open) /* included in sums, and then ignored */
                t->end[side][k] = 0;
        }
    }
}

/* Do all rows fit the tables? Their words are far apart in memory and are prefetched meanwhile: at
 * this size waiting for them one by one would take longer than all the rest. */
static bool suits_the_stack(const fmb_system *s)
{
    bool good = true;
    for (size_t i = 0; i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        ask_for_memory(r->var);
        ask_for_memory(r->val.s);
        good &= !fmb_vec_is_wide(&r->val) & (r->rel != FMB_EQ);
    }
    return good;
}

static void read_system_row(load_row *to, const fmb_sysrow *r)
{
    to->nnz = r->nnz;
    to->var = r->var;
    to->a = r->val.s;
    to->bits = r->val.bits;
    to->strict = r->rel == FMB_LT;
}

static void read_dense_row(load_row *to, const fmb_vec *v, size_t n)
{
    to->nnz = 0;
    to->var = to->own_var;
    to->a = to->own;
    to->bits = v->bits;
    to->strict = true;
    for (size_t j = 0; j < n; j++)
        if (v->s[j] != 0) {
            to->own_var[to->nnz] = (int)j;
            to->own[to->nnz++] = v->s[j];
        }
    to->own[to->nnz] = v->s[n];
}

fmb_tiny_step fmb_tiny_load(fmb_tiny *t, const fmb_system *s, size_t m, const fmb_vec *row)
{
    load_ends e;
    load_row r;
    t->now->rows = 0;
    if (s && !suits_the_stack(s))
        return FMB_TINY_FULL;
    for (int k = 0; k < FMB_TINY_WORDS; k++)
        e.row[0][k] = e.row[1][k] = -1;
    for (size_t i = 0; i < m; i++) {
        if (s)
            read_system_row(&r, fmb_system_row(s, i));
        else
            read_dense_row(&r, &row[i], (size_t)t->n);
        r.history = (uint64_t)1 << i;
        if (r.nnz == 1)
            put_end_row(t->now, &e, &r);
        else if (r.nnz > 1)
            put_base_row(t->now, t->now->rows++, &r);
        else if (r.a[0] < 0 || (r.a[0] == 0 && r.strict)) {
            t->clash = r.history;
            return FMB_TINY_CLASH;
        }
    }
    make_outward_box(t, &e);
    return fmb_tiny_prune(t, t->now, 0);
}
