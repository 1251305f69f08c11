/* bastrakov_zolotykh.c: Chernikov's rule, tested in a graph of possibly adjacent rows.
 *
 * In round k the combination of two rows is minimal if no third history lies inside the union of
 * their histories, and the union has at most k + 1 members. Call two live rows adjacent in the
 * graph if the union of their histories has at most k + 1 members. A third row whose history lies
 * inside the union of two is adjacent to both, as its union with either lies inside that union; so
 * only the few neighbours of one of the two are searched, not all rows.
 *
 * The test is right if the live rows are exactly the extreme rays of the cone of combinations,
 * except those of trivial rows (0 <= 3), which are gone: any other row between two extreme rays
 * would hide their combination. A combination that only a trivial row could have covered is made,
 * and dropped by its rank. So the live rows are extreme rays, each once: an extreme ray of the next
 * round lies on a face that exactly two extreme rays span. Source: Bastrakov, Zolotykh 2015, the
 * test of Zolotykh 2012 for the double description method.
 *
 * A number to check: of |x1| + ... + |x4| <= 1, written as 16 rows, 28 rows are left, as by
 * `chernikov`.
 */
#include "study/rivals/rules/rivals.h"

/* The live rows that are adjacent to one row. */
typedef struct neighbours {
    const uint64_t **history;
    size_t n, words;
} neighbours;

static bool collect_neighbours(const fmb_view *w, const uint64_t *of, neighbours *g)
{
    size_t rows = fmb_view_rows(w);
    int most = fmb_view_eliminated(w) + 1;
    g->n = 0;
    g->history = fmb_view_scratch(w, rows * sizeof *g->history);
    for (size_t i = 0; g->history && i < rows; i++) {
        const uint64_t *other = fmb_view_history(w, fmb_view_row(w, i), &g->words);
        if (other != of && rival_count_union(of, other, g->words) <= most)
            g->history[g->n++] = other;
    }
    return g->history != NULL;
}

/* Is some neighbour of the row `of`, but `other`, inside the union of the two? */
static bool is_covered(const neighbours *g, const uint64_t *of, const uint64_t *other)
{
    for (size_t i = 0; i < g->n; i++) {
        uint64_t outside = 0;
        for (size_t k = 0; k < g->words; k++)
            outside |= g->history[i][k] & ~(of[k] | other[k]);
        if (!outside && g->history[i] != other)
            return true;
    }
    return false;
}

static void drop_pairs_off_the_graph(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    size_t words, uppers = fmb_view_uppers(w);
    const uint64_t *of = fmb_view_history(w, fmb_view_lower(w, i), &words);
    neighbours g = {0};
    (void)state;
    fmb_view_drop_larger(w, i, fmb_view_eliminated(w) + 1, drop);
    for (size_t j = 0; of && j < uppers && !fmb_view_stop(w); j++) {
        if (drop[j / 64] >> j % 64 & 1)
            continue;
        if (!g.history && !collect_neighbours(w, of, &g))
            return;
        if (is_covered(&g, of, fmb_view_history(w, fmb_view_upper(w, j), &words)))
            drop[j / 64] |= UINT64_C(1) << j % 64;
    }
}

static bool drop_row_unless_minimal(void *state, const fmb_view *w, size_t row)
{
    (void)state;
    return !fmb_view_minimal(w, row);
}

const fmb_rule rival_bastrakov_zolotykh = {
    .name = "bastrakov-zolotykh",
    .source = "BastrakovZolotykh2015",
    .flags = FMB_RULE_NEEDS_HISTORY,
    .drop_pairs = drop_pairs_off_the_graph,
    .drop_row = drop_row_unless_minimal,
};
