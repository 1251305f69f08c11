/* box_rule.c: the box of the rows with one variable; see box_rule.h.
 *
 * A row -x <= -l or x <= u of the base does not change until x is eliminated, and is a base row of
 * every combination afterwards; so the box is permanent until histories start anew. Ends whose
 * numbers do not fit are left out: the box is then larger, and its conclusions weaker.
 */
#include "elim/rules/box_rule.h"

#include <string.h>

#include "num/gcd.h"

/* Is the bound of row x on variable c tighter than that of y (same side)? */
static bool is_tighter_bound(const fmb_elim *e, uint32_t x, uint32_t y, size_t c)
{
    const fmb_derived *a = &e->row[x], *b = &e->row[y];
    size_t n = (size_t)e->n;
    int order = fmb_vec_compare_products(&a->v, n, &b->v, c, &b->v, n, &a->v, c);
    return order < 0 || (order == 0 && a->strict && !b->strict);
}

/* Find the tightest row of each end; drop_implied_bounds removes the others. False: no end. */
static bool find_tightest_ends(fmb_elim *e)
{
    fmb_box_rows *box = &e->box;
    bool any = false;
    for (size_t i = 0; i < e->live.size; i++) {
        uint32_t r = e->live.row[i];
        int c = e->row[r].equality ? -1 : fmb_elim_single_variable(e, &e->row[r]);
        if (c < 0)
            continue;
        uint32_t *end = &box->row[fmb_vec_sgn(&e->row[r].v, (size_t)c) > 0][c];
        if (*end == FMB_NO_ROW || is_tighter_bound(e, r, *end, (size_t)c))
            *end = r;
        any = true;
    }
    return any;
}

static void drop_implied_bounds(fmb_elim *e)
{
    size_t left = 0;
    for (size_t i = 0; i < e->live.size; i++) {
        uint32_t r = e->live.row[i];
        int c = e->row[r].equality ? -1 : fmb_elim_single_variable(e, &e->row[r]);
        if (c < 0 || e->box.row[fmb_vec_sgn(&e->row[r].v, (size_t)c) > 0][c] == r)
            e->live.row[left++] = r;
    }
    e->live.size = left;
}

/* Multiply one more denominator into the unit if the unit stays small. */
static void widen_unit(fmb_box_rows *box, uint64_t a)
{
    uint64_t factor = a / fmb_gcd64((uint64_t)box->unit, a);
    if (factor >> 31 == 0 && ((uint64_t)box->unit * factor) >> 31 == 0)
        box->unit = (int64_t)((uint64_t)box->unit * factor);
}

/* unit times the end that row r puts on variable c; false if it is no integer, or too large. */
static bool scale_end_to_unit(const fmb_box_rows *box, const fmb_derived *r, size_t n, size_t c,
                              int64_t *end)
{
    int64_t a = r->v.s[c], b = r->v.s[n];
    return box->unit % a == 0 && !__builtin_mul_overflow(b, box->unit / a, end) &&
           fmb_bits64(fmb_abs64(*end)) <= FMB_SMALL_BITS;
}

static void scale_all_ends(fmb_elim *e)
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
            if (fmb_vec_is_wide(&d->v) || !scale_end_to_unit(box, d, n, c, &box->end[side][c])) {
                *r = FMB_NO_ROW;
                continue;
            }
            int bits = fmb_bits64(fmb_abs64(box->end[side][c]));
            box->bits = bits > box->bits ? bits : box->bits;
            box->any = true;
            fmb_set_put(box->ended, c);
        }
    }
}

/* ---- a budget -------------------------------------------------------------------------------- */

/* Is the row a budget: an inequality in at least two variables, all with their least ends, and one
 * without the other end? Then *room = its right side minus the least value of its left. */
static bool is_budget_row(const fmb_elim *e, const fmb_derived *r, int64_t *room)
{
    bool open = false;
    int variables = 0;
    if (r->equality || !fmb_set_is_inside(r->names, e->box.ended, e->var_words) ||
        fmb_vec_is_wide(&r->v) ||
        r->v.bits + e->box.bits + fmb_bits64((uint64_t)e->n + 1) > FMB_SMALL_BITS)
        return false;
    *room = r->v.s[e->n] * e->box.unit;
    for (int j = 0; j < e->n; j++) {
        int64_t s = r->v.s[j];
        int side = fmb_box_side_of_least(s);
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

/* Find the first budget. Without histories it is not known which rows are derived from it. */
static void find_first_budget(fmb_elim *e)
{
    fmb_box_rows *box = &e->box;
    for (size_t i = 0; e->histories && box->any && i < e->live.size; i++)
        if (is_budget_row(e, &e->row[e->live.row[i]], &box->room)) {
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
    FMB_TRY(FMB_ARENA_GET(e->arena, box->hard, e->words));
    for (size_t k = 0; k < e->words; k++)
        box->hard[k] = 0;
    for (size_t i = 0; i < e->bases; i++) {
        bool hard =
            e->base[i] == box->budget || fmb_elim_single_variable(e, &e->row[e->base[i]]) >= 0;
        box->hard[i / 64] |= (uint64_t)hard << (i % 64);
    }
    return FMB_OK;
}

/* ---- all of it ------------------------------------------------------------------------------- */

fmb_status fmb_box_make(fmb_elim *e)
{
    fmb_box_rows *box = &e->box;
    size_t n = (size_t)e->n;
    box->unit = 1;
    box->any = false;
    box->budget = FMB_NO_ROW;
    box->hard = NULL;
    for (int side = FMB_LOWER; !box->ended && side <= FMB_UPPER; side++) {
        FMB_TRY(FMB_ARENA_GET(e->arena, box->row[side], n));
        FMB_TRY(FMB_ARENA_GET(e->arena, box->end[side], n));
    }
    if (!box->ended)
        FMB_TRY(FMB_ARENA_GET(e->arena, box->ended, e->var_words));
    memset(box->ended, 0, e->var_words * sizeof *box->ended);
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++)
        for (size_t c = 0; c < n; c++)
            box->row[side][c] = FMB_NO_ROW;
    if (!fmb_elim_keeps(e, FMB_STEP_BOUNDS) || !find_tightest_ends(e))
        return FMB_OK;
    drop_implied_bounds(e);
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++)
        for (size_t c = 0; c < n; c++)
            if (box->row[side][c] != FMB_NO_ROW && !e->row[box->row[side][c]].v.z)
                widen_unit(box, fmb_abs64(e->row[box->row[side][c]].v.s[c]));
    scale_all_ends(e);
    find_first_budget(e);
    return FMB_OK;
}
