/* simulate.c: an elimination of signs; see simulate.h.
 *
 * A row is the signs of its coefficients in the eliminated variables, and its history, a set of
 * input rows. Where the signs of a pair differ, the sign of the sum is drawn; cancellation to 0 is
 * ignored. The variable that creates the fewest new rows is eliminated first, and a row whose
 * history has more than k + 1 rows after k variables is dropped (Kohler 1967).
 */
#include "simulate.h"

typedef struct sign_row {
    uint64_t plus, minus; /* of eliminated variables, in their order */
    uint64_t behind[SIMULATED_BASE / 64];
} sign_row;

typedef struct sign_rows {
    sign_row row[SIMULATED_ROWS + 1];
    size_t size;
    size_t finished; /* rows without eliminated variables: only counted */
    int columns;
    long up[SIMULATED_COLUMNS], down[SIMULATED_COLUMNS]; /* rows of each sign */
    uint64_t drawn;                                      /* state of the draws */
} sign_rows;

static void count_signs(uint64_t signs, long *of, long change)
{
    for (; signs != 0; signs &= signs - 1)
        of[__builtin_ctzll(signs)] += change;
}

static void count_row(sign_rows *s, const sign_row *r, long change)
{
    count_signs(r->plus, s->up, change);
    count_signs(r->minus, s->down, change);
}

/* False: too many rows. */
static bool put_sign_row(sign_rows *s, const sign_row *r)
{
    bool named = (r->plus | r->minus) != 0;
    if (named && s->size <= SIMULATED_ROWS)
        s->row[s->size++] = *r;
    s->finished += !named;
    count_row(s, r, 1);
    return s->size + s->finished <= SIMULATED_ROWS;
}

static void load_signs(sign_rows *s, const fmb_elim *e, const bool *drop)
{
    for (int j = 0; j < e->n; j++)
        s->columns += drop[j];
    if (s->columns > SIMULATED_COLUMNS || e->live.size > SIMULATED_BASE)
        return;
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        sign_row signs = {.plus = 0};
        int at = 0;
        for (int j = 0; j < e->n; j++) {
            if (!drop[j])
                continue;
            int sign = fmb_vec_sgn(&r->v, (size_t)j);
            signs.plus |= (uint64_t)(sign > 0) << at;
            signs.minus |= (uint64_t)(sign < 0) << at++;
        }
        signs.behind[i / 64] = (uint64_t)1 << (i % 64);
        (void)put_sign_row(s, &signs);
    }
}

/* The growth of the number of rows by eliminating variable j; may be negative. */
static long growth_of_column(const sign_rows *s, int j)
{
    return s->up[j] * s->down[j] - s->up[j] - s->down[j];
}

/* -1: no row names an eliminated variable. */
static int choose_column(const sign_rows *s)
{
    int best = -1;
    for (int j = 0; j < s->columns; j++)
        if (s->up[j] + s->down[j] > 0 &&
            (best < 0 || growth_of_column(s, j) < growth_of_column(s, best)))
            best = j;
    return best;
}

/* splitmix64 (Steele, Lea, Flood 2014). */
static uint64_t draw_signs(sign_rows *s)
{
    uint64_t z = (s->drawn += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* False: the history of the sum is too large. */
static bool combine_signs(sign_rows *s, const sign_row *a, const sign_row *b, uint64_t gone,
                          int most, sign_row *to)
{
    int count = 0;
    for (int w = 0; w < SIMULATED_BASE / 64; w++) {
        to->behind[w] = a->behind[w] | b->behind[w];
        count += __builtin_popcountll(to->behind[w]);
    }
    if (count > most)
        return false;
    uint64_t opposite = (a->plus & b->minus) | (a->minus & b->plus), drawn = draw_signs(s);
    to->plus = (((a->plus | b->plus) & ~opposite) | (opposite & drawn)) & ~gone;
    to->minus = (((a->minus | b->minus) & ~opposite) | (opposite & ~drawn)) & ~gone;
    return true;
}

/* Move the rows that name the variable from s to *taken; returns their number. */
static size_t take_rows_out(sign_rows *s, uint64_t bit, sign_row *taken)
{
    size_t left = 0, n = 0;
    for (size_t i = 0; i < s->size; i++) {
        const sign_row *r = &s->row[i];
        if ((r->plus | r->minus) & bit) {
            count_row(s, r, -1);
            taken[n++] = *r;
        } else {
            s->row[left++] = *r;
        }
    }
    s->size = left;
    return n;
}

/* Eliminate the k-th variable by pairs. False: too many rows, or pairs. */
static bool eliminate_signs(sign_rows *s, int j, int k, sign_row *taken, size_t *pairs)
{
    uint64_t bit = (uint64_t)1 << j;
    size_t n = take_rows_out(s, bit, taken);
    for (size_t a = 0; a < n; a++) {
        for (size_t b = 0; (taken[a].plus & bit) && b < n; b++) {
            sign_row sum;
            if (!(taken[b].minus & bit))
                continue;
            if (++*pairs >= SIMULATED_PAIRS)
                return false;
            if (combine_signs(s, &taken[a], &taken[b], bit, k + 1, &sum) && !put_sign_row(s, &sum))
                return false;
        }
    }
    return true;
}

simulated_elimination simulate_elimination(const fmb_elim *e, const bool *drop)
{
    sign_rows s;
    sign_row taken[SIMULATED_ROWS + 1];
    simulated_elimination out = {.most = e->live.size};
    s.size = s.finished = 0;
    s.columns = 0;
    s.drawn = 0;
    for (int j = 0; j < SIMULATED_COLUMNS; j++)
        s.up[j] = s.down[j] = 0;
    load_signs(&s, e, drop);
    if (s.size == 0 && s.finished == 0) { /* too large to be followed */
        out.left = s.columns;
        return out;
    }
    int j = choose_column(&s);
    out.first = j >= 0 ? growth_of_column(&s, j) : 0;
    for (int k = 1; j >= 0; k++, j = choose_column(&s)) {
        bool few = eliminate_signs(&s, j, k, taken, &out.pairs);
        size_t rows = s.size + s.finished;
        out.most = rows > out.most ? rows : out.most;
        if (!few)
            break;
    }
    for (int c = 0; j >= 0 && c < s.columns; c++)
        out.left += s.up[c] + s.down[c] > 0;
    return out;
}
