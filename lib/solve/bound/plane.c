/* plane.c: see plane.h. */
#include "solve/bound/plane.h"

#include "solve/limit/outer_ends.h"

fmb_status fmb_plane_open(fmb_plane *p, fmb_elim *e, int x, int y, bool *possible)
{
    fmb_round *round = &e->round[e->rounds];
    *p = (fmb_plane){.e = e, .x = x, .y = y, .round = round};
    *round = (fmb_round){.var = y};
    *possible = false;
    FMB_TRY(FMB_ARENA_GET(e->arena, round->row, e->live.size));
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        if (fmb_vec_sgn(&r->v, (size_t)y) == 0)
            continue;
        if (r->equality)
            return FMB_OK;
        round->row[round->rows++] = e->live.row[i];
    }
    e->rounds++;
    *possible = true;
    return FMB_OK;
}

void fmb_plane_close(fmb_plane *p)
{
    p->e->rounds--;
}

/* The bound that a row sets on y, as a line over t = sign x. Lines are compared by their values at
 * t; while t is infinite, by their slopes first. */
typedef struct line {
    mpq_t at_zero, slope, at_t;
    uint32_t row; /* FMB_NO_ROW: none */
} line;

/* A search for the greatest t. */
typedef struct search {
    fmb_plane *p;
    int sign;
    line lower, upper, next; /* greatest lower line, least upper line, the line being compared */
    mpq_t t, s;
    bool finite;         /* t is */
    uint32_t row;        /* the row over x alone that gives t; or, if FMB_NO_ROW, */
    uint32_t from, with; /* the lower and the upper row whose combination gives t */
} search;

/* Row r, a x + c y <= b, bounds y by (b - a sign t) / c. */
static void read_bound_as_line(search *h, uint32_t r)
{
    const fmb_vec *v = &h->p->e->row[r].v;
    line *l = &h->next;
    fmb_vec_get_q(v, (size_t)h->p->y, h->s);
    fmb_vec_get_q(v, (size_t)h->p->e->n, l->at_zero);
    mpq_div(l->at_zero, l->at_zero, h->s);
    fmb_vec_get_q(v, (size_t)h->p->x, l->slope);
    mpq_div(l->slope, l->slope, h->s);
    if (h->sign > 0)
        mpq_neg(l->slope, l->slope);
    mpq_mul(l->at_t, l->slope, h->t);
    mpq_add(l->at_t, l->at_t, l->at_zero);
    l->row = r;
}

/* If the line just read is the best of its side so far, keep it. */
static void offer_as_extreme_line(search *h, bool upper)
{
    line *best = upper ? &h->upper : &h->lower, *next = &h->next;
    const fmb_derived *row = h->p->e->row;
    int order = upper ? -1 : 1;
    if (best->row != FMB_NO_ROW) {
        order = h->finite ? mpq_cmp(next->at_t, best->at_t) : mpq_cmp(next->slope, best->slope);
        if (order == 0 && !h->finite)
            order = mpq_cmp(next->at_zero, best->at_zero);
        if (order == 0 && row[next->row].strict && !row[best->row].strict)
            order = upper ? -1 : 1;
    }
    if (upper ? order < 0 : order > 0) {
        line other = *best;
        *best = *next;
        *next = other;
    }
}

static void find_extreme_pair(search *h)
{
    const fmb_plane *p = h->p;
    h->lower.row = h->upper.row = FMB_NO_ROW;
    for (size_t i = 0; i < p->round->rows; i++) {
        read_bound_as_line(h, p->round->row[i]);
        offer_as_extreme_line(h, fmb_vec_sgn(&p->e->row[p->round->row[i]].v, (size_t)p->y) > 0);
    }
}

/* Bounds of t by rows over x alone. */
static void bound_by_single_rows(search *h)
{
    const fmb_elim *e = h->p->e;
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        int sign = fmb_vec_sgn(&r->v, (size_t)h->p->x);
        if (sign == 0 || fmb_vec_sgn(&r->v, (size_t)h->p->y) != 0 ||
            (!r->equality && sign != h->sign))
            continue;
        fmb_end_of_row(&r->v, e->n, h->p->x, h->s);
        if (h->sign < 0)
            mpq_neg(h->s, h->s);
        int order = h->finite ? mpq_cmp(h->s, h->t) : -1;
        if (order < 0 || (order == 0 && r->strict && !e->row[h->row].strict)) {
            mpq_set(h->t, h->s);
            h->row = e->live.row[i];
            h->finite = true;
        }
    }
}

static bool is_extreme_strict(const search *h)
{
    const fmb_derived *row = h->p->e->row;
    return h->row != FMB_NO_ROW ? row[h->row].strict : row[h->from].strict || row[h->with].strict;
}

static void take_extreme_pair(search *h)
{
    h->row = FMB_NO_ROW;
    h->from = h->lower.row;
    h->with = h->upper.row;
}

/* One step from t to where the extreme pair meets; false: t is the maximum, or unbounded. */
static bool take_newton_step(search *h)
{
    const fmb_derived *row = h->p->e->row;
    find_extreme_pair(h);
    if (h->lower.row == FMB_NO_ROW || h->upper.row == FMB_NO_ROW)
        return false;
    mpq_sub(h->s, h->lower.slope, h->upper.slope);
    if (h->finite) {
        int gap = mpq_cmp(h->upper.at_t, h->lower.at_t);
        bool open = row[h->lower.row].strict || row[h->upper.row].strict;
        if (gap == 0 && open && mpq_sgn(h->s) > 0 && !is_extreme_strict(h))
            take_extreme_pair(h);
        if (gap >= 0 || mpq_sgn(h->s) <= 0) /* the latter: no solution, a rule was unsound */
            return false;
    } else if (mpq_sgn(h->s) <= 0) {
        return false;
    }
    mpq_sub(h->t, h->upper.at_zero, h->lower.at_zero);
    mpq_div(h->t, h->t, h->s);
    h->finite = true;
    take_extreme_pair(h);
    return true;
}

static void init_plane_search(search *h)
{
    line *all[] = {&h->lower, &h->upper, &h->next};
    for (int i = 0; i < 3; i++)
        mpq_inits(all[i]->at_zero, all[i]->slope, all[i]->at_t, NULL);
    mpq_inits(h->t, h->s, NULL);
}

static void clear_plane_search(search *h)
{
    line *all[] = {&h->lower, &h->upper, &h->next};
    for (int i = 0; i < 3; i++)
        mpq_clears(all[i]->at_zero, all[i]->slope, all[i]->at_t, NULL);
    mpq_clears(h->t, h->s, NULL);
}

fmb_status fmb_plane_extreme(fmb_plane *p, int sign, uint32_t *row)
{
    search h = {.p = p, .sign = sign, .row = FMB_NO_ROW};
    fmb_status st = FMB_OK;
    init_plane_search(&h);
    bound_by_single_rows(&h);
    while (st == FMB_OK && take_newton_step(&h))
        st = fmb_run_poll(p->e->run);
    *row = h.row;
    if (st == FMB_OK && h.finite && h.row == FMB_NO_ROW) {
        p->e->run->stats.pairs++;
        st = fmb_elim_derive_row(p->e, h.from, h.with, p->y, row);
    }
    clear_plane_search(&h);
    return st;
}
