/* box.c: the box of the rows with one variable; see box.h.
 *
 * A row -x <= -l or x <= u of the base stays what it is as long as x is there, and is among the
 * base rows of every combination afterwards; so the box is permanent until histories start anew.
 * Ends whose numbers would not fit are left out: the box is then larger, and says less.
 */
#include "elim/box.h"

#include <gmp.h>
#include <stdlib.h>

#include "elim/elim.h"
#include "num/gcd.h"

int fmb_elim_single_column(const fmb_elim *e, const fmb_derived *r)
{
    int found = -1;
    for (int j = 0; j < e->n; j++) {
        if (fmb_vec_sgn(&r->v, (size_t)j) == 0)
            continue;
        if (found >= 0)
            return -1;
        found = j;
    }
    return found;
}

/* Is the bound of row x on column c tighter than that of y (same side)? */
static bool is_tighter(const fmb_elim *e, uint32_t x, uint32_t y, size_t c)
{
    const fmb_derived *a = &e->row[x], *b = &e->row[y];
    size_t n = (size_t)e->n;
    int order = fmb_vec_compare_products(&a->v, n, &b->v, c, &b->v, n, &a->v, c);
    return order < 0 || (order == 0 && a->strict && !b->strict);
}

/* The tightest row of each end; the others of its kind leave the live rows. */
static void find_ends(fmb_elim *e)
{
    fmb_box_rows *box = &e->box;
    for (size_t i = 0; i < e->live.size; i++) {
        uint32_t r = e->live.row[i];
        int c = e->row[r].equality ? -1 : fmb_elim_single_column(e, &e->row[r]);
        if (c < 0)
            continue;
        uint32_t *end = &box->row[fmb_vec_sgn(&e->row[r].v, (size_t)c) > 0][c];
        if (*end == FMB_NO_ROW || is_tighter(e, r, *end, (size_t)c))
            *end = r;
    }
}

static void drop_others(fmb_elim *e)
{
    size_t left = 0;
    for (size_t i = 0; i < e->live.size; i++) {
        uint32_t r = e->live.row[i];
        int c = e->row[r].equality ? -1 : fmb_elim_single_column(e, &e->row[r]);
        if (c < 0 || e->box.row[fmb_vec_sgn(&e->row[r].v, (size_t)c) > 0][c] == r)
            e->live.row[left++] = r;
    }
    e->live.size = left;
}

/* Take one more denominator into the unit if the unit stays small. */
static void widen_unit(fmb_box_rows *box, uint64_t a)
{
    uint64_t factor = a / fmb_gcd64((uint64_t)box->unit, a);
    if (factor >> 31 == 0 && ((uint64_t)box->unit * factor) >> 31 == 0)
        box->unit = (int64_t)((uint64_t)box->unit * factor);
}

/* unit times the end that row r puts on column c; false if it is no integer, or too large. */
static bool scale_end(const fmb_box_rows *box, const fmb_derived *r, size_t n, size_t c,
                      int64_t *end)
{
    int64_t a = r->v.s[c], b = r->v.s[n];
    return box->unit % a == 0 && !__builtin_mul_overflow(b, box->unit / a, end) &&
           fmb_bits64(fmb_abs64(*end)) <= FMB_SMALL_BITS;
}

static void scale_ends(fmb_elim *e)
{
    fmb_box_rows *box = &e->box;
    size_t n = (size_t)e->n;
    box->bits = fmb_bits64((uint64_t)box->unit);
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
        for (size_t c = 0; c < n; c++) {
            uint32_t *r = &box->row[side][c];
            if (*r == FMB_NO_ROW)
                continue;
            const fmb_derived *d = &e->row[*r];
            if (fmb_vec_is_wide(&d->v) || !scale_end(box, d, n, c, &box->end[side][c])) {
                *r = FMB_NO_ROW;
                continue;
            }
            int bits = fmb_bits64(fmb_abs64(box->end[side][c]));
            box->bits = bits > box->bits ? bits : box->bits;
            box->any = true;
        }
    }
}

/* ---- a budget -------------------------------------------------------------------------------- */

/* The end at which s x_j is least: the lower one for positive s. */
static int least_side(int64_t s)
{
    return s > 0 ? FMB_LOWER : FMB_UPPER;
}

/* Is the row a budget: an inequality in two variables or more, each with its least end, and one of
 * them without the other? Then *room is what it leaves above the least ends. */
static bool is_budget(const fmb_elim *e, const fmb_derived *r, int64_t *room)
{
    bool open = false;
    int variables = 0;
    if (r->equality || fmb_vec_is_wide(&r->v) ||
        r->v.bits + e->box.bits + fmb_bits64((uint64_t)e->n + 1) > FMB_SMALL_BITS)
        return false;
    *room = r->v.s[e->n] * e->box.unit;
    for (int j = 0; j < e->n; j++) {
        int64_t s = r->v.s[j];
        int side = least_side(s);
        if (s == 0)
            continue;
        if (e->box.row[side][j] == FMB_NO_ROW)
            return false;
        open |= e->box.row[1 - side][j] == FMB_NO_ROW;
        *room -= s * e->box.end[side][j];
        variables++;
    }
    return open && variables > 1 && *room >= 0;
}

/* The first budget there is. Without histories nobody could tell which rows are made of it. */
static void find_budget(fmb_elim *e)
{
    fmb_box_rows *box = &e->box;
    for (size_t i = 0; e->histories && box->any && i < e->live.size; i++)
        if (is_budget(e, &e->row[e->live.row[i]], &box->room)) {
            int bits = fmb_bits64((uint64_t)box->room);
            box->budget = e->live.row[i];
            box->bits = bits > box->bits ? bits : box->bits;
            return;
        }
}

fmb_status fmb_box_mark(fmb_elim *e)
{
    fmb_box_rows *box = &e->box;
    if (box->budget == FMB_NO_ROW)
        return FMB_OK;
    box->hard = fmb_arena_get(e->arena, e->words, sizeof *box->hard);
    if (!box->hard)
        return fmb_mem_status(e->arena->mem);
    for (size_t k = 0; k < e->words; k++)
        box->hard[k] = 0;
    for (size_t i = 0; i < e->bases; i++) {
        bool hard =
            e->base[i] == box->budget || fmb_elim_single_column(e, &e->row[e->base[i]]) >= 0;
        box->hard[i / 64] |= (uint64_t)hard << (i % 64);
    }
    return FMB_OK;
}

/* ---- all of it --------------------------------------------------------------------------------
 */

fmb_status fmb_box_make(fmb_elim *e)
{
    fmb_box_rows *box = &e->box;
    size_t n = (size_t)e->n;
    box->unit = 1;
    box->any = false;
    box->budget = FMB_NO_ROW;
    box->hard = NULL;
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
        if (!box->row[side])
            box->row[side] = fmb_arena_get(e->arena, n, sizeof *box->row[side]);
        if (!box->end[side])
            box->end[side] = fmb_arena_get(e->arena, n, sizeof *box->end[side]);
        if (!box->row[side] || !box->end[side])
            return fmb_mem_status(e->arena->mem);
        for (size_t c = 0; c < n; c++)
            box->row[side][c] = FMB_NO_ROW;
    }
    if (!fmb_elim_keeps(e, FMB_STEP_BOUNDS))
        return FMB_OK;
    find_ends(e);
    drop_others(e);
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++)
        for (size_t c = 0; c < n; c++)
            if (box->row[side][c] != FMB_NO_ROW && !e->row[box->row[side][c]].v.z)
                widen_unit(box, fmb_abs64(e->row[box->row[side][c]].v.s[c]));
    scale_ends(e);
    find_budget(e);
    return FMB_OK;
}

/* ---- rows over the box ----------------------------------------------------------------------- */

/* The same as below in GMP. */
static int wide_sign(const fmb_elim *e, const fmb_derived *r, int at)
{
    const fmb_box_rows *box = &e->box;
    mpz_t sum, t;
    mpz_inits(sum, t, NULL);
    fmb_vec_get(&r->v, (size_t)e->n, t);
    mpz_mul_si(sum, t, box->unit);
    for (size_t j = 0; j < (size_t)e->n; j++) {
        int sign = fmb_vec_sgn(&r->v, j);
        if (sign == 0)
            continue;
        fmb_vec_get(&r->v, j, t);
        mpz_mul_si(t, t, box->end[sign * at > 0][j]);
        mpz_sub(sum, sum, t);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(sum, t, NULL);
    return sign;
}

static int small_sign(const fmb_elim *e, const fmb_derived *r, int at)
{
    const fmb_box_rows *box = &e->box;
    const int64_t *a = r->v.s;
    fmb_i128 sum = (fmb_i128)a[e->n] * box->unit;
    for (int j = 0; j < e->n; j++)
        if (a[j] != 0)
            sum -= (fmb_i128)a[j] * box->end[(a[j] > 0) == (at > 0)][j];
    return (sum > 0) - (sum < 0);
}

/* Has the box an end wherever a.x is greatest (at = 1) or least (at = -1)? */
static bool is_closed(const fmb_elim *e, const fmb_derived *r, int at)
{
    for (int j = 0; j < e->n; j++) {
        int sign = fmb_vec_sgn(&r->v, (size_t)j);
        if (sign != 0 && e->box.row[sign * at > 0][j] == FMB_NO_ROW)
            return false;
    }
    return true;
}

/* The sign of b - a.x where a.x is greatest or least. A sum of n + 1 products in 128 bits. */
static int sign_at(const fmb_elim *e, const fmb_derived *r, int at)
{
    int bits = r->v.bits + e->box.bits + fmb_bits64((uint64_t)e->n + 1);
    return r->v.z || bits > 126 ? wide_sign(e, r, at) : small_sign(e, r, at);
}

/* Does the row itself make an end or the budget? */
static bool makes_box(const fmb_elim *e, const fmb_derived *r)
{
    uint32_t number = (uint32_t)(r - e->row);
    int c = fmb_elim_single_column(e, r);
    return number == e->box.budget ||
           (c >= 0 && e->box.row[fmb_vec_sgn(&r->v, (size_t)c) > 0][c] == number);
}

/* Is the row made of nothing but rows of the box and the budget? */
static bool is_hard(const fmb_elim *e, const fmb_derived *r)
{
    if (!e->box.hard || !r->history)
        return false;
    for (size_t k = 0; k < e->words; k++)
        if (r->history[k] & ~e->box.hard[k])
            return false;
    return true;
}

/* Over the box with a budget, a.x is greatest with all of the budget's variables at their least
 * ends but one, which takes the room: that with the greatest gain a_j / s_j, if any gains. Sign of
 * b - that, times unit and s_j. */
static int sign_with_budget(const fmb_elim *e, const fmb_derived *r)
{
    const fmb_box_rows *box = &e->box;
    const int64_t *a = r->v.s, *s = e->row[box->budget].v.s;
    fmb_i128 sum = (fmb_i128)a[e->n] * box->unit;
    int64_t gain = 0, price = 1;
    int bits = r->v.bits + box->bits + fmb_bits64((uint64_t)e->n + 1);
    if (r->v.z || bits + e->row[box->budget].v.bits > 126)
        return -1;
    for (int j = 0; j < e->n; j++) {
        int side = s[j] != 0 ? least_side(s[j]) : a[j] > 0 ? FMB_UPPER : FMB_LOWER;
        if (a[j] == 0)
            continue;
        if (box->row[side][j] == FMB_NO_ROW)
            return -1;
        sum -= (fmb_i128)a[j] * box->end[side][j];
        int64_t g = s[j] < 0 ? -a[j] : a[j], p = (int64_t)fmb_abs64(s[j]);
        if (p > 0 && g > 0 && (fmb_i128)g * price > (fmb_i128)gain * p) {
            gain = g;
            price = p;
        }
    }
    sum = sum * price - (fmb_i128)gain * box->room;
    return (sum > 0) - (sum < 0);
}

int fmb_box_slack(const fmb_elim *e, const fmb_derived *r)
{
    if (!e->box.any || makes_box(e, r))
        return -1;
    if (e->box.budget != FMB_NO_ROW)
        return is_hard(e, r) ? -1 : sign_with_budget(e, r);
    return is_closed(e, r, 1) ? sign_at(e, r, 1) : -1;
}

bool fmb_box_refutes(const fmb_elim *e, const fmb_derived *r)
{
    if (!e->box.any || !is_closed(e, r, -1))
        return false;
    int sign = sign_at(e, r, -1);
    return sign < 0 || (sign == 0 && r->strict);
}
