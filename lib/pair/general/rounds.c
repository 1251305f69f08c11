/* rounds.c: the rounds of an elimination in doubles.
 *
 * A row has two ends, so the pair p - q of two rows whose unknown has coefficient 1 gives both p's
 * upper with q's lower end and q's upper with p's lower one: one difference of vectors for two
 * inequalities, with opposite histories. Kohler's rule (rule/kohler.c) looks at the two parts of a
 * history together: a base row is in both if its two ends are used, and then counts twice, as the
 * two inequalities that it is. The box is not among the rows; it pairs with each by leaving out the
 * unknown.
 */
#include "pair/general/workspace.h"

#include <math.h>
#include <string.h>

#include "num/bitset.h"

/* Pairs looked at before giving up [pairs]: what five dimensions need. In six and more the simplex
 * method is faster by then. */
#define MOST_PAIRS 1000

static bool says_nothing(double low, double high)
{
    return low == -INFINITY && high == INFINITY;
}

static void subtract_cells(double *restrict to, const double *restrict a, const double *restrict b,
                           int n)
{
    for (int k = 0; k < n; k++)
        to[k] = a[k] - b[k];
}

static fmb_general_step pair_two_rows(fmb_general *g, size_t p, size_t q)
{
    const fmb_general_head *x = &g->head[p], *y = &g->head[q];
    double low = x->low - y->high, high = x->high - y->low;
    if (says_nothing(low, high))
        return FMB_GENERAL_GO;
    if (g->rows + 1 >= g->most_rows)
        return FMB_GENERAL_LOST;
    g->head[g->rows] = (fmb_general_head){low, high, x->plus | y->minus, x->minus | y->plus};
    subtract_cells(fmb_general_cell(g, g->rows), fmb_general_cell(g, p), fmb_general_cell(g, q),
                   g->dim + g->n - 1);
    return fmb_general_settle(g, g->n - 1);
}

/* Row i as it is, without its last unknown. */
static fmb_general_step keep_without_last(fmb_general *g, size_t i, fmb_general_head head)
{
    if (g->rows + 1 >= g->most_rows)
        return FMB_GENERAL_LOST;
    memcpy(fmb_general_cell(g, g->rows), fmb_general_cell(g, i),
           (size_t)(g->dim + g->n - 1) * sizeof *g->cell);
    g->head[g->rows] = head;
    return FMB_GENERAL_GO;
}

/* Row p with its last unknown anywhere in its place; a simplex has no upper end here, but its sum
 * among the rows. */
static fmb_general_step pair_with_box(fmb_general *g, size_t p, int column)
{
    fmb_general_head head = g->head[p];
    head.low -= g->pair.kind[column] == FMB_GENERAL_UNIT ? 1 : INFINITY;
    head.minus |= (uint64_t)1 << column;
    if (says_nothing(head.low, head.high))
        return FMB_GENERAL_GO;
    fmb_general_step step = keep_without_last(g, p, head);
    return step == FMB_GENERAL_GO ? fmb_general_settle(g, g->n - 1) : step;
}

/* ---- a round --------------------------------------------------------------------------------- */

/* The place of the unknown that fewest rows name. */
static int choose_least_named(const fmb_general *g, const fmb_general_level *from)
{
    size_t rows[FMB_GENERAL_MOST_COLUMNS] = {0};
    int best = 0;
    for (size_t i = 0; i < from->rows; i++) {
        const double *a = fmb_general_cell(g, from->first + i) + g->dim;
        for (int k = 0; k < g->n; k++)
            rows[k] += a[k] != 0;
    }
    for (int k = 1; k < g->n; k++)
        if (rows[k] < rows[best])
            best = k;
    return best;
}

/* Turn all rows; those without the unknown go on as they are. */
static fmb_general_step sort_rows_by_unknown(fmb_general *g, const fmb_general_level *from,
                                             size_t *named)
{
    fmb_general_step step = FMB_GENERAL_GO;
    *named = 0;
    for (size_t i = from->first; step == FMB_GENERAL_GO && i < from->first + from->rows; i++) {
        fmb_general_turn(g, i, from->place);
        if (fmb_general_cell(g, i)[g->dim + g->n - 1] == 0) {
            step = keep_without_last(g, i, g->head[i]);
            g->rows += step == FMB_GENERAL_GO;
            continue;
        }
        g->bits[*named] = g->head[i].plus;
        g->bits[g->most_rows + *named] = g->head[i].minus;
        g->named[(*named)++] = (uint16_t)i;
    }
    return step;
}

/* Named row i with those before it. */
static fmb_general_step pair_with_those_before(fmb_general *g, size_t i)
{
    const fmb_general_head *x = &g->head[g->named[i]];
    const fmb_planes planes = {g->bits, g->most_rows, 2, i};
    fmb_general_step step = FMB_GENERAL_GO;
    memset(g->drop, 0, fmb_set_words(i) * sizeof *g->drop);
    g->kernels->larger(&planes, (const uint64_t[2]){x->minus, x->plus}, g->removed + 2, g->drop);
    g->pairs += i;
    for (size_t j = 0; step == FMB_GENERAL_GO && j < i; j++)
        if (!fmb_set_has(g->drop, j))
            step = pair_two_rows(g, g->named[i], g->named[j]);
    return step == FMB_GENERAL_GO && g->pairs > MOST_PAIRS ? FMB_GENERAL_LOST : step;
}

static fmb_general_step remove_one_unknown(fmb_general *g, fmb_general_level *from)
{
    size_t named, last = (size_t)g->n - 1;
    from->place = choose_least_named(g, from);
    int column = g->unknown[from->place];
    g->unknown[from->place] = g->unknown[last];
    g->unknown[last] = column;
    fmb_general_step step = sort_rows_by_unknown(g, from, &named);
    for (size_t i = 0; step == FMB_GENERAL_GO && i < named; i++) {
        step = pair_with_box(g, g->named[i], column);
        if (step == FMB_GENERAL_GO)
            step = pair_with_those_before(g, i);
    }
    g->n--;
    g->removed++;
    from[1].first = from->first + from->rows;
    from[1].rows = g->rows - from[1].first;
    return step;
}

fmb_general_step fmb_general_eliminate(fmb_general *g)
{
    fmb_general_step step = fmb_general_start(g);
    while (step == FMB_GENERAL_GO && g->n > 2)
        step = remove_one_unknown(g, &g->level[g->removed]);
    return step;
}
