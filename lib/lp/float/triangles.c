/* triangles.c: see triangles.h. */
#include "lp/float/triangles.h"

/* What list k holds under index i is in list step_of[i] of *to under place[k]. */
static fmb_status transpose_lists(const fmb_triangles *u, const fmb_lists *from, const int *step_of,
                                  fmb_lists *to)
{
    to->size = 0;
    fmb_status st = fmb_lists_reserve(to, u->f->run->mem, from->size);
    if (st != FMB_OK)
        return st;
    memset(to->start, 0, (u->n + 1) * sizeof *to->start);
    for (size_t t = 0; t < from->size; t++)
        to->start[step_of[from->index[t]]]++;
    for (size_t k = 0, sum = 0; k <= u->n; k++) {
        sum += to->start[k];
        to->start[k] = sum;
    }
    for (size_t k = u->n; k-- > 0;)
        for (size_t t = from->start[k]; t < from->start[k + 1]; t++) {
            size_t at = --to->start[step_of[from->index[t]]];
            to->index[at] = u->place[k];
            to->value[at] = from->value[t];
        }
    to->size = from->size;
    return FMB_OK;
}

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_triangles_init(fmb_triangles *u, const fmb_reals *f)
{
    fmb_mem *mem = f->run->mem;
    size_t n = f->n;
    *u = (fmb_triangles){.f = f, .n = n};
    u->place = fmb_mem_get(mem, n, sizeof *u->place);
    u->column = fmb_mem_get(mem, n, sizeof *u->column);
    u->step_of_place = fmb_mem_get(mem, n, sizeof *u->step_of_place);
    u->step_of_column = fmb_mem_get(mem, n, sizeof *u->step_of_column);
    u->pivot = fmb_mem_get(mem, n, sizeof *u->pivot);
    u->marks = fmb_mem_zero(mem, n / 64 + 1, sizeof *u->marks);
    if (!u->place || !u->column || !u->step_of_place || !u->step_of_column || !u->pivot ||
        !u->marks)
        return fmb_mem_status(mem);
    fmb_lists *all[] = {&u->lower,           &u->lower_by_target, &u->upper,
                        &u->upper_by_column, &u->entry,           &u->edge};
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < sizeof all / sizeof *all; k++)
        st = fmb_lists_reserve_starts(all[k], mem, n);
    return st;
}

void fmb_triangles_clear(fmb_triangles *u)
{
    fmb_mem *mem = u->f->run->mem;
    fmb_lists *all[] = {&u->lower,           &u->lower_by_target, &u->upper,
                        &u->upper_by_column, &u->entry,           &u->edge};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        fmb_lists_free(all[k], mem);
    fmb_mem_put(mem, u->place, u->n, sizeof *u->place);
    fmb_mem_put(mem, u->column, u->n, sizeof *u->column);
    fmb_mem_put(mem, u->step_of_place, u->n, sizeof *u->step_of_place);
    fmb_mem_put(mem, u->step_of_column, u->n, sizeof *u->step_of_column);
    fmb_mem_put(mem, u->pivot, u->n, sizeof *u->pivot);
    fmb_mem_put(mem, u->marks, u->n / 64 + 1, sizeof *u->marks);
    fmb_mem_put(mem, u->eta, u->eta_room, sizeof *u->eta);
}

/* ---- factoring ------------------------------------------------------------------------------- */

/* Places without a step get the columns without one, as unit vectors: of which nothing was
 * subtracted. */
static void fill_up_with_units(fmb_triangles *u, size_t *member, size_t steps)
{
    size_t j = 0;
    for (size_t r = 0; r < u->n && steps < u->n; r++) {
        if (u->step_of_place[r] >= 0)
            continue;
        while (u->step_of_column[j] >= 0)
            j++;
        for (size_t t = 0; t < u->lower.size; t++)
            u->lower.value[t] = u->lower.index[t] == (int)r ? 0 : u->lower.value[t];
        member[r] = FMB_UNIT + j;
        u->place[steps] = (int)r;
        u->column[steps] = (int)j;
        u->pivot[steps] = 1;
        u->step_of_place[r] = u->step_of_column[j] = (int)steps++;
        u->lower.start[steps] = u->lower.size;
        u->upper.start[steps] = u->upper.size;
    }
}

fmb_status fmb_triangles_factor(fmb_triangles *u, size_t *member)
{
    size_t steps = 0;
    u->etas = u->entry.size = u->edge.size = 0;
    fmb_status st = fmb_triangles_eliminate(u, member, &steps);
    if (st == FMB_OK)
        fill_up_with_units(u, member, steps);
    if (st == FMB_OK)
        st = transpose_lists(u, &u->lower, u->step_of_place, &u->lower_by_target);
    if (st == FMB_OK)
        st = transpose_lists(u, &u->upper, u->step_of_column, &u->upper_by_column);
    return st;
}

/* What v has but at place `but`, as list k. */
static void keep_list(fmb_lists *l, size_t k, const fmb_spread *v, size_t but)
{
    l->start[k] = l->size;
    for (size_t t = 0; t < fmb_spread_count(v); t++) {
        size_t at = fmb_spread_key(v, t);
        if (at != but && v->at[at] != 0)
            fmb_lists_push(l, at, v->at[at]);
    }
    l->start[k + 1] = l->size;
}

fmb_status fmb_triangles_exchange(fmb_triangles *u, size_t place, size_t member,
                                  const fmb_spread *entry, const fmb_spread *edge)
{
    fmb_mem *mem = u->f->run->mem;
    fmb_status st =
        fmb_mem_reserve(mem, (void **)&u->eta, &u->eta_room, u->etas + 1, sizeof *u->eta);
    if (st == FMB_OK)
        st = fmb_lists_reserve(&u->entry, mem, fmb_spread_count(entry));
    if (st == FMB_OK)
        st = fmb_lists_reserve(&u->edge, mem, fmb_spread_count(edge));
    if (st == FMB_OK)
        st = fmb_lists_reserve_starts(&u->entry, mem, u->etas + 1);
    if (st == FMB_OK)
        st = fmb_lists_reserve_starts(&u->edge, mem, u->etas + 1);
    if (st != FMB_OK)
        return st;
    keep_list(&u->entry, u->etas, entry, place);
    keep_list(&u->edge, u->etas, edge, FMB_NOWHERE);
    u->eta[u->etas++] = (fmb_eta){.place = place, .member = member, .pivot = entry->at[place]};
    return FMB_OK;
}

bool fmb_triangles_are_long(const fmb_triangles *u)
{
    return u->etas > 100 || (u->etas > 20 && u->entry.size + u->edge.size >
                                                 4 * (u->lower.size + u->upper.size + u->n));
}

/* ---- solving --------------------------------------------------------------------------------- */

static inline void mark_step(fmb_triangles *u, int step)
{
    u->marks[step / 64] |= (uint64_t)1 << (step % 64);
}

static void mark_steps_of(fmb_triangles *u, const fmb_spread *v, const int *step_of)
{
    for (size_t t = 0; t < fmb_spread_count(v); t++) {
        size_t k = fmb_spread_key(v, t);
        if (v->at[k] != 0)
            mark_step(u, step_of[k]);
    }
}

/* from less factor times list k, with their steps marked. */
static inline void subtract_list(fmb_triangles *u, const fmb_lists *l, size_t k, double factor,
                                 double *from, const int *step_of)
{
    for (size_t t = l->start[k]; t < l->start[k + 1]; t++) {
        from[l->index[t]] -= factor * l->value[t];
        mark_step(u, step_of[l->index[t]]);
    }
}

/* The same, to a spread. */
static void subtract_list_from(const fmb_lists *l, size_t k, double factor, fmb_spread *from)
{
    for (size_t t = l->start[k]; t < l->start[k + 1]; t++)
        fmb_spread_add(from, (size_t)l->index[t], -factor * l->value[t]);
}

/* Marked steps go up; steps that are marked on the way are later ones. */
static void solve_lower(fmb_triangles *u, double *b)
{
    for (size_t w = 0; w <= u->n / 64; w++)
        for (uint64_t done = 0, left; (left = u->marks[w] & ~done) != 0;) {
            int bit = __builtin_ctzll(left);
            size_t k = 64 * w + (size_t)bit;
            done |= (uint64_t)1 << bit;
            if (fabs(b[u->place[k]]) > FMB_NOTHING)
                subtract_list(u, &u->lower, k, b[u->place[k]], b, u->step_of_place);
        }
}

static void solve_upper(fmb_triangles *u, double *b, fmb_spread *x)
{
    for (size_t w = u->n / 64 + 1; w-- > 0;)
        while (u->marks[w] != 0) {
            int bit = 63 - __builtin_clzll(u->marks[w]);
            size_t k = 64 * w + (size_t)bit;
            double value = b[u->place[k]] / u->pivot[k];
            u->marks[w] &= ~((uint64_t)1 << bit);
            b[u->place[k]] = 0;
            if (fabs(value) <= FMB_NOTHING)
                continue;
            fmb_spread_add(x, (size_t)u->column[k], value);
            subtract_list(u, &u->upper_by_column, k, value, b, u->step_of_place);
        }
}

static double member_times(const fmb_reals *f, size_t i, const double *x)
{
    if (i >= FMB_UNIT)
        return x[i - FMB_UNIT];
    const int *column = fmb_reals_columns(f, i);
    const double *value = &f->value[f->start[i]];
    size_t size = f->start[i + 1] - f->start[i];
    double sum = 0;
    for (size_t k = 0; k < size; k++)
        sum += value[k] * x[column[k]];
    return sum;
}

void fmb_triangles_solve(fmb_triangles *u, fmb_spread *b, fmb_spread *x)
{
    fmb_spread_clear(x, false);
    for (size_t k = 0; k < u->etas; k++)
        u->eta[k].right = b->at[u->eta[k].place];
    mark_steps_of(u, b, u->step_of_place);
    solve_lower(u, b->at);
    solve_upper(u, b->at, x);
    b->count = 0;
    for (size_t k = 0; k < u->etas; k++) {
        const fmb_eta *e = &u->eta[k];
        double over = member_times(u->f, e->member, x->at) - e->right;
        if (fabs(over) > FMB_NOTHING)
            subtract_list_from(&u->edge, k, over / e->pivot, x);
    }
}

/* Marks stay, at the places of what is not zero. */
static void solve_upper_transposed(fmb_triangles *u, double *c, fmb_spread *y)
{
    for (size_t w = 0; w <= u->n / 64; w++)
        for (uint64_t done = 0, left; (left = u->marks[w] & ~done) != 0;) {
            int bit = __builtin_ctzll(left);
            size_t k = 64 * w + (size_t)bit;
            double value = c[u->column[k]] / u->pivot[k];
            done |= (uint64_t)1 << bit;
            c[u->column[k]] = 0;
            if (fabs(value) <= FMB_NOTHING)
                continue;
            fmb_spread_add(y, (size_t)u->place[k], value);
            subtract_list(u, &u->upper, k, value, c, u->step_of_column);
        }
}

static void solve_lower_transposed(fmb_triangles *u, fmb_spread *y)
{
    const fmb_lists *l = &u->lower_by_target;
    for (size_t w = u->n / 64 + 1; w-- > 0;)
        while (u->marks[w] != 0) {
            int bit = 63 - __builtin_clzll(u->marks[w]);
            size_t k = 64 * w + (size_t)bit;
            double value = y->at[u->place[k]];
            u->marks[w] &= ~((uint64_t)1 << bit);
            for (size_t t = l->start[k]; fabs(value) > FMB_NOTHING && t < l->start[k + 1]; t++) {
                fmb_spread_add(y, (size_t)l->index[t], -value * l->value[t]);
                mark_step(u, u->step_of_place[l->index[t]]);
            }
        }
}

void fmb_triangles_solve_transposed(fmb_triangles *u, fmb_spread *c, fmb_spread *y)
{
    fmb_spread_clear(y, false);
    mark_steps_of(u, c, u->step_of_column);
    solve_upper_transposed(u, c->at, y);
    solve_lower_transposed(u, y);
    c->count = 0;
    for (size_t k = 0; k < u->etas; k++) {
        const fmb_eta *e = &u->eta[k];
        if (fabs(y->at[e->place]) <= FMB_NOTHING)
            continue;
        y->at[e->place] /= e->pivot;
        subtract_list_from(&u->entry, k, y->at[e->place], y);
    }
}
