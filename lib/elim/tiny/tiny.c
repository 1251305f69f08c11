/* tiny.c: the rounds of a tiny elimination.
 *
 * The same elimination as the engine's, on the stack: no allocation, no proof. A round removes the
 * variable with the fewest pairs; pairs are refused by Kohler's rule (see rule/kohler.c), rows
 * dropped or refuted over the box of the rows with one variable (rule/box.c, rules/box_slack.c).
 * When two variables remain, the pairs of one are bounds on the other, of which only the tightest
 * are kept (round/squeeze.c). Histories are sets of at most 64 base rows: one word.
 *
 * Numbers stay exact: products that may overflow are formed in 128 bits, and the elimination is
 * given up when a row still does not fit. Then, and when a table is full, the answer is unknown.
 */
#include "elim/tiny/tiny.h"
#include "elim/tiny/tiny_private.h"

#include "num/gcd.h"
#include "system/system_private.h"

/* ---- the next variable ----------------------------------------------------------------------- */

/* Rows of either sign for each variable. */
typedef struct counts {
    uint64_t of[2][FMB_TINY_WORDS];
} counts;

static void count_signs(const fmb_tiny *t, counts *c)
{
    *c = (counts){0};
    for (int i = 0; i < t->now->rows; i++) {
        const int64_t *a = t->now->a[i];
        for (int k = 1; k <= t->n; k++) {
            c->of[0][k] += (uint64_t)a[k] >> 63;
            c->of[1][k] += (uint64_t)-a[k] >> 63;
        }
    }
}

/* The variable with the fewest pairs; one with no pairs comes first. */
static int choose_fewest_pairs(const fmb_tiny *t)
{
    counts c;
    int best = 1;
    int64_t least = INT64_MAX;
    count_signs(t, &c);
    for (int k = 1; k <= t->n; k++) {
        int64_t p = (int64_t)c.of[0][k], q = (int64_t)c.of[1][k];
        int64_t cost = p * q == 0 ? INT64_MIN : p * q - p - q;
        if (cost < least) {
            least = cost;
            best = k;
        }
    }
    return best;
}

/* ---- pairs ----------------------------------------------------------------------------------- */

/* Rows of negative and of positive coefficient. */
typedef struct sides {
    uint8_t row[2][FMB_TINY_ROWS];
    int rows[2];
} sides;

/* Has the set more than `most` elements? */
static bool has_more_than(uint64_t set, int most)
{
    for (; most > 0; most--)
        set &= set - 1;
    return set != 0;
}

static bool names_no_variable(const int64_t *a, int n)
{
    int64_t all = 0;
    for (int k = 1; k <= n; k++)
        all |= a[k];
    return all == 0;
}

/* Keep the row at the end of the next table, whose variable is cancelled, unless constant. */
static fmb_tiny_step keep_unless_constant(fmb_tiny *t)
{
    fmb_tiny_table *next = t->next;
    int i = next->rows;
    const int64_t *a = next->a[i];
    if (!names_no_variable(a, t->n - 1))
        next->rows++;
    else if (a[0] < 0 || (a[0] == 0 && next->strict[i])) {
        t->clash = next->history[i];
        return FMB_TINY_CLASH;
    }
    return FMB_TINY_GO;
}

static fmb_tiny_step combine_unless_refused(fmb_tiny *t, int p, int q, int c)
{
    t->stats->pairs++;
    if (has_more_than(t->now->history[p] | t->now->history[q], t->since + 2)) {
        t->stats->rows_dropped++;
        return FMB_TINY_GO;
    }
    if (t->next->rows == FMB_TINY_ROWS || !fmb_tiny_combine(t, p, q, c))
        return FMB_TINY_FULL;
    t->stats->rows_made++;
    return keep_unless_constant(t);
}

/* ---- a round --------------------------------------------------------------------------------- */

/* Sort the rows with variable c into sides, and copy the others to the next table. */
static void split_by_sign(fmb_tiny *t, int c, sides *s)
{
    const fmb_tiny_table *now = t->now;
    fmb_tiny_table *next = t->next;
    next->rows = s->rows[0] = s->rows[1] = 0;
    for (int i = 0; i < now->rows; i++) {
        int64_t a = now->a[i][c];
        if (a != 0) {
            int side = a > 0;
            s->row[side][s->rows[side]++] = (uint8_t)i;
            continue;
        }
        fmb_tiny_copy(next, next->rows, now, i);
        next->a[next->rows][c] = now->a[i][t->n];
        next->rows++;
    }
}

/* After variable c is eliminated, give its number to the last variable. */
static void close_variable(fmb_tiny *t, int c)
{
    int n = t->n--;
    for (int side = 0; side < 2; side++) {
        t->end[side][c] = t->end[side][n];
        t->end_history[side][c] = t->end_history[side][n];
        t->open[side] = (t->open[side] & ~(1u << c)) | (t->open[side] >> n & 1) << c;
    }
}

static fmb_tiny_step make_round(fmb_tiny *t)
{
    sides s;
    fmb_tiny_step step = FMB_TINY_GO;
    int c = choose_fewest_pairs(t);
    split_by_sign(t, c, &s);
    int old = t->next->rows;
    if (t->stats->pairs + (uint64_t)(s.rows[0] * s.rows[1]) > t->most_pairs)
        return FMB_TINY_FULL;
    for (int i = 0; i < s.rows[0]; i++)
        for (int j = 0; step == FMB_TINY_GO && j < s.rows[1]; j++)
            step = combine_unless_refused(t, s.row[0][i], s.row[1][j], c);
    if (s.rows[0] > 0 && s.rows[1] > 0) {
        t->since++;
        t->stats->rounds++;
    }
    close_variable(t, c);
    if (step == FMB_TINY_GO)
        step = fmb_tiny_prune(t, t->next, old);
    t->stats->rows_kept += (uint64_t)(t->next->rows - old);
    if ((uint64_t)t->next->rows > t->stats->rows_peak)
        t->stats->rows_peak = (uint64_t)t->next->rows;
    fmb_tiny_table *free = t->now;
    t->now = t->next;
    t->next = free;
    return step;
}

/* ---- the last two ---------------------------------------------------------------------------- */

static fmb_tiny_step note_pair_as_bound(fmb_tiny *t, int p, int q, int c, int d)
{
    const int64_t *a = t->now->a[p], *b = t->now->a[q];
    uint64_t history = t->now->history[p] | t->now->history[q];
    t->stats->pairs++;
    if (has_more_than(history, t->since + 2)) {
        t->stats->rows_dropped++;
        return FMB_TINY_GO;
    }
    t->stats->rows_made++;
    int64_t f = b[c], g = -a[c];
    return fmb_tiny_note(t, fmb_i128_plus_product(fmb_i128_product(f, a[d]), g, b[d]),
                         fmb_i128_plus_product(fmb_i128_product(f, a[0]), g, b[0]),
                         t->now->strict[p] || t->now->strict[q], history);
}

static fmb_tiny_step make_last_round(fmb_tiny *t)
{
    sides s;
    fmb_tiny_step step = FMB_TINY_GO;
    int c = t->n == 2 ? choose_fewest_pairs(t) : 2, d = 3 - c;
    s.rows[0] = s.rows[1] = 0;
    for (int i = 0; i < t->now->rows; i++) {
        int64_t a = t->n == 2 ? t->now->a[i][c] : 0;
        if (a != 0)
            s.row[a > 0][s.rows[a > 0]++] = (uint8_t)i;
        else if (step == FMB_TINY_GO)
            step = fmb_tiny_note(t, fmb_i128_of(t->now->a[i][d]), fmb_i128_of(t->now->a[i][0]),
                                 t->now->strict[i], t->now->history[i]);
    }
    for (int i = 0; i < s.rows[0]; i++)
        for (int j = 0; step == FMB_TINY_GO && j < s.rows[1]; j++)
            step = note_pair_as_bound(t, s.row[0][i], s.row[1][j], c, d);
    t->stats->rounds += s.rows[0] > 0 && s.rows[1] > 0;
    return step == FMB_TINY_GO ? fmb_tiny_compare_ends(t) : step;
}

/* Eliminate all variables of s, or (s NULL) of m small rows over n variables, taken as strict. */
static fmb_verdict eliminate_all(size_t n, const fmb_system *s, size_t m, const fmb_vec *row,
                                 fmb_stats *stats, uint64_t *clash)
{
    fmb_tiny t;
    if (n > FMB_TINY_VARIABLES || m > FMB_TINY_BASE)
        return FMB_UNKNOWN;
    t.stats = stats;
    t.now = &t.table[0];
    t.next = &t.table[1];
    t.n = (int)n;
    t.since = 0;
    t.most_pairs = n < 7 ? FMB_TINY_PAIRS : FMB_TINY_FEW_PAIRS;
    t.last[0].known = t.last[1].known = false;
    fmb_tiny_step step = fmb_tiny_load(&t, s, m, row);
    stats->rows_peak = (uint64_t)t.now->rows;
    while (step == FMB_TINY_GO && t.n > 2)
        step = make_round(&t);
    if (step == FMB_TINY_GO)
        step = make_last_round(&t);
    *clash = step == FMB_TINY_CLASH ? t.clash : 0;
    return step == FMB_TINY_GO      ? FMB_FEASIBLE
           : step == FMB_TINY_CLASH ? FMB_INFEASIBLE
                                    : FMB_UNKNOWN;
}

fmb_verdict fmb_tiny_decide(const fmb_system *s, fmb_stats *stats)
{
    uint64_t clash;
    return eliminate_all((size_t)fmb_system_dim(s), s, s->rows, NULL, stats, &clash);
}

fmb_verdict fmb_tiny_find_tight(size_t n, size_t m, const fmb_vec *row, uint64_t *tight)
{
    fmb_stats stats = {0};
    *tight = 0;
    return eliminate_all(n, NULL, m, row, &stats, tight);
}
