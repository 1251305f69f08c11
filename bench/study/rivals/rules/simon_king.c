/* simon_king.c: no more rows after a round than before it, the sparsest. NOT SOUND, on purpose.
 *
 * In program analysis a projection may be too large a set, but must be quick: where a round would
 * make the system grow, exactness is given up. Here the rows with most variables are dropped until
 * there are no more than before the round; the kept rows hold for every solution, so that analyses
 * stay sound, but they are the projection only if no row was dropped. The paper replaces dropped
 * rows by others that a simplex method finds; a rule cannot add rows through <fmb/rule.h>, so this
 * one loses more. Source: Simon, King 2005, after its abstract.
 *
 * A number to check: of |x1| + ... + |x4| <= 1, written as 16 rows, 16, 11 and 5 are left after
 * three rounds; the interval that they say for x4 is right by luck.
 */
#include "study/rivals/rules/rivals.h"

typedef struct bound {
    size_t rows; /* before the round */
} bound;

static void note_rows(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    (void)i, (void)drop;
    ((bound *)state)->rows = fmb_view_rows(w);
}

static int count_variables(const fmb_view *w, size_t row)
{
    int n = 0;
    for (int j = 0; j < fmb_view_dim(w); j++)
        n += fmb_view_sign(w, row, j) != 0;
    return n;
}

static fmb_status drop_dense_rows(void *state, const fmb_view *w, bool *drop)
{
    size_t rows = fmb_view_rows(w), most = ((bound *)state)->rows, left = rows;
    for (int n = fmb_view_dim(w); most > 0 && n > 0 && left > most; n--)
        for (size_t i = rows; i-- > 0 && left > most;)
            if (count_variables(w, fmb_view_row(w, i)) == n) {
                drop[i] = true;
                left--;
            }
    return FMB_OK;
}

const fmb_rule rival_simon_king = {
    .name = "simon-king",
    .source = "SimonKing2005",
    .flags = FMB_RULE_BREAKS_HISTORY,
    .state_bytes = sizeof(bound),
    .drop_pairs = note_rows,
    .end_round = drop_dense_rows,
};
