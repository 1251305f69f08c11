/* simulate.c: an elimination of signs.
 *
 * A row is the signs of its coefficients and the set of first rows behind it. Where a pair of rows
 * has opposite signs, that of the sum is drawn by its place; that it may be 0 is left out. The
 * variable with the fewest pairs goes first, and a row with more than k + 1 first rows behind it
 * after k variables is dropped (Kohler 1967).
 */
#include "simulate.h"

#include <stdlib.h>
#include <string.h>

enum { SET_WORDS = (SIMULATED_ROWS + 63) / 64 };

typedef struct sign_row {
    uint64_t behind[SET_WORDS];
    signed char sign[]; /* [n] */
} sign_row;

typedef struct sign_rows {
    char *at;
    size_t size, stride;
} sign_rows;

static sign_row *row_at(const sign_rows *r, size_t i)
{
    return (sign_row *)(void *)(r->at + i * r->stride);
}

static size_t count_behind(const sign_row *r)
{
    size_t n = 0;
    for (int w = 0; w < SET_WORDS; w++)
        n += (size_t)__builtin_popcountll(r->behind[w]);
    return n;
}

static void load_signs(const fmb_reduced_part *h, sign_rows *to)
{
    const fmb_elim *e = &h->e;
    for (; to->size < e->live.size; to->size++) {
        sign_row *r = row_at(to, to->size);
        memset(r, 0, to->stride);
        r->behind[to->size / 64] = (uint64_t)1 << (to->size % 64);
        for (int j = 0; j < e->n; j++)
            r->sign[j] = (signed char)fmb_vec_sgn(&e->row[e->live.row[to->size]].v, (size_t)j);
    }
}

/* Rows that are more after j is gone; negative where there are fewer. */
static long growth_of_column(const sign_rows *rows, int j)
{
    long up = 0, down = 0;
    for (size_t i = 0; i < rows->size; i++) {
        up += row_at(rows, i)->sign[j] > 0;
        down += row_at(rows, i)->sign[j] < 0;
    }
    return up + down == 0 ? 0 : up * down - up - down;
}

static bool is_named(const sign_rows *rows, int j)
{
    for (size_t i = 0; i < rows->size; i++)
        if (row_at(rows, i)->sign[j] != 0)
            return true;
    return false;
}

/* -1: none of them is named any more. */
static int choose_column(const fmb_reduced_part *h, const sign_rows *rows)
{
    int best = -1;
    for (int j = 0; j < h->e.n; j++)
        if (h->drop[j] && is_named(rows, j) &&
            (best < 0 || growth_of_column(rows, j) < growth_of_column(rows, best)))
            best = j;
    return best;
}

static void combine_signs(const sign_row *a, const sign_row *b, int gone, int n, sign_row *to)
{
    for (int w = 0; w < SET_WORDS; w++)
        to->behind[w] = a->behind[w] | b->behind[w];
    for (int j = 0; j < n; j++) {
        int drawn = ((int)to->behind[0] ^ (j * 7)) & 1 ? a->sign[j] : b->sign[j];
        bool opposite = a->sign[j] * b->sign[j] < 0;
        to->sign[j] = (signed char)(opposite ? drawn : a->sign[j] ? a->sign[j] : b->sign[j]);
    }
    to->sign[gone] = 0;
}

/* False: there are too many. */
static bool put_row(sign_rows *to, const sign_row *r)
{
    if (to->size > SIMULATED_ROWS)
        return false;
    memcpy(row_at(to, to->size++), r, to->stride);
    return true;
}

/* The k-th variable goes. */
static bool eliminate_signs(const sign_rows *from, int j, int n, size_t k, sign_rows *to)
{
    to->size = 0;
    for (size_t i = 0; i < from->size; i++) {
        const sign_row *a = row_at(from, i);
        if (a->sign[j] == 0 && !put_row(to, a))
            return false;
        for (size_t l = 0; a->sign[j] > 0 && l < from->size; l++) {
            const sign_row *b = row_at(from, l);
            if (b->sign[j] >= 0)
                continue;
            if (to->size > SIMULATED_ROWS)
                return false;
            combine_signs(a, b, j, n, row_at(to, to->size));
            to->size += count_behind(row_at(to, to->size)) <= k + 1;
        }
    }
    return true;
}

static int count_columns_left(const fmb_reduced_part *h, const sign_rows *rows)
{
    int n = 0;
    for (int j = 0; j < h->e.n; j++)
        n += h->drop[j] && is_named(rows, j);
    return n;
}

static void run_simulation(const fmb_reduced_part *h, sign_rows rows[2], simulated_rows *out)
{
    int now = 0;
    size_t k = 1;
    load_signs(h, &rows[0]);
    out->most = rows[0].size;
    for (int j; (j = choose_column(h, &rows[now])) >= 0; now = !now, k++) {
        bool few = eliminate_signs(&rows[now], j, h->e.n, k, &rows[!now]);
        out->most = rows[!now].size > out->most ? rows[!now].size : out->most;
        if (!few)
            break;
    }
    out->left = count_columns_left(h, &rows[now]);
    out->last = out->left > 0 ? SIMULATED_ROWS + 1 : rows[now].size;
}

bool simulate_elimination(const fmb_reduced_part *h, simulated_rows *out)
{
    size_t stride = sizeof(sign_row) + (size_t)h->e.n;
    sign_rows rows[2];
    stride = (stride + 7) / 8 * 8;
    *out = (simulated_rows){.most = SIMULATED_ROWS + 1, .last = SIMULATED_ROWS + 1, .left = h->e.n};
    if (h->e.live.size > SIMULATED_ROWS)
        return true;
    for (int k = 0; k < 2; k++)
        rows[k] = (sign_rows){malloc((SIMULATED_ROWS + 2) * stride), 0, stride};
    bool good = rows[0].at && rows[1].at;
    if (good)
        run_simulation(h, rows, out);
    free(rows[0].at);
    free(rows[1].at);
    return good;
}
