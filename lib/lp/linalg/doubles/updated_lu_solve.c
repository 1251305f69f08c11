/* updated_lu_solve.c: see updated_lu.h. */
#include "lp/linalg/doubles/updated_lu.h"

#include "base/arrays.h"

/* What list k holds under index i is in list step_of[i] of *to under place[k]. */
static fmb_status transpose_rows(const fmb_updated_lu *u, const fmb_compressed_rows *from,
                                 const int *step_of, fmb_compressed_rows *to)
{
    to->size = 0;
    FMB_TRY(fmb_compressed_rows_reserve(to, u->f->run->mem, from->size));
    memset(to->start, 0, (u->steps + 1) * sizeof *to->start);
    for (size_t t = 0; t < from->size; t++)
        to->start[step_of[from->index[t]]]++;
    for (size_t k = 0, sum = 0; k <= u->steps; k++) {
        sum += to->start[k];
        to->start[k] = sum;
    }
    for (size_t k = u->steps; k-- > 0;)
        for (size_t t = from->start[k]; t < from->start[k + 1]; t++) {
            size_t at = --to->start[step_of[from->index[t]]];
            to->index[at] = u->place[k];
            to->value[at] = from->value[t];
        }
    to->size = from->size;
    return FMB_OK;
}

/* ---- life ------------------------------------------------------------------------------------ */

enum { LISTS = 8 };

static fmb_compressed_rows *find_list(fmb_updated_lu *u, size_t k)
{
    return (fmb_compressed_rows *[LISTS]){&u->lower,           &u->lower_by_target, &u->upper,
                                          &u->upper_by_column, &u->entry,           &u->edge,
                                          &u->beside,          &u->activated}[k];
}

static fmb_status hold_arrays_of_lu(fmb_updated_lu *u, bool get)
{
    const size_t n = u->n;
    return FMB_ARRAYS(u->f->run->mem, get, FMB_ARRAY(u->member, n), FMB_ARRAY(u->singleton, n),
                      FMB_ARRAY(u->singleton_of, n), FMB_ARRAY(u->reciprocal, n),
                      FMB_ARRAY(u->rests, n), FMB_ARRAY(u->resting, n), FMB_ARRAY(u->latest, n),
                      FMB_ARRAY(u->place, n), FMB_ARRAY(u->column, n),
                      FMB_ARRAY(u->step_of_place, n), FMB_ARRAY(u->step_of_column, n),
                      FMB_ARRAY(u->pivot, n), FMB_ARRAY_ZERO(u->marks, n / 64 + 1));
}

fmb_status fmb_updated_lu_init(fmb_updated_lu *u, const fmb_scaled_program *f)
{
    fmb_mem *mem = f->run->mem;
    *u = (fmb_updated_lu){.f = f, .n = f->n};
    fmb_arena_init(&u->arena, mem);
    fmb_status st = hold_arrays_of_lu(u, true);
    for (size_t k = 0; st == FMB_OK && k < LISTS; k++)
        st = fmb_compressed_rows_reserve_starts(find_list(u, k), mem, u->n);
    return st;
}

void fmb_updated_lu_clear(fmb_updated_lu *u)
{
    fmb_mem *mem = u->f->run->mem;
    for (size_t k = 0; k < LISTS; k++)
        fmb_compressed_rows_free(find_list(u, k), mem);
    fmb_arena_clear(&u->arena);
    (void)hold_arrays_of_lu(u, false);
    fmb_mem_put(mem, u->eta, u->eta_room, sizeof *u->eta);
}

/* ---- singletons ------------------------------------------------------------------------------ */

/* The first member that names a column alone. */
static void set_singletons_aside(fmb_updated_lu *u)
{
    for (size_t k = 0; k < u->n; k++) {
        u->singleton[k] = u->singleton_of[k] = u->resting[k] = u->latest[k] = -1;
        u->rests[k] = false;
    }
    for (size_t r = 0; r < u->n; r++) {
        int one;
        fmb_terms t = fmb_member_terms(u->f, u->member[r], &one);
        if (t.size != 1 || u->singleton_of[*t.column] >= 0)
            continue;
        u->singleton[r] = *t.column;
        u->singleton_of[*t.column] = u->resting[*t.column] = (int)r;
        u->reciprocal[r] = 1 / *t.value;
        u->rests[r] = true;
    }
}

/* What the core has in columns of singletons. */
static fmb_status list_beside(fmb_updated_lu *u)
{
    fmb_compressed_rows *b = &u->beside;
    int one;
    memset(b->start, 0, (u->n + 1) * sizeof *b->start);
    for (size_t r = 0; r < u->n; r++) {
        fmb_terms t = fmb_member_terms(u->f, u->member[r], &one);
        for (size_t k = 0; u->singleton[r] < 0 && k < t.size; k++)
            b->start[t.column[k]] += u->singleton_of[t.column[k]] >= 0;
    }
    size_t sum = 0;
    for (size_t j = 0; j <= u->n; j++) {
        sum += b->start[j];
        b->start[j] = sum;
    }
    b->size = 0;
    fmb_status st = fmb_compressed_rows_reserve(b, u->f->run->mem, sum);
    b->size = st == FMB_OK ? sum : 0;
    for (size_t r = u->n; st == FMB_OK && r-- > 0;) {
        fmb_terms t = fmb_member_terms(u->f, u->member[r], &one);
        for (size_t k = 0; u->singleton[r] < 0 && k < t.size; k++) {
            if (u->singleton_of[t.column[k]] < 0)
                continue;
            size_t at = --b->start[t.column[k]];
            b->index[at] = (int)r;
            b->value[at] = t.value[k];
        }
    }
    return st;
}

/* ---- factoring ------------------------------------------------------------------------------- */

static void drop_place_from_list(fmb_compressed_rows *l, size_t r)
{
    for (size_t t = 0; t < l->size; t++)
        l->value[t] = l->index[t] == (int)r ? 0 : l->value[t];
}

/* Places in the core without a step get the columns without one, as unit vectors: of which nothing
 * was subtracted. */
static void fill_up_with_units(fmb_updated_lu *u)
{
    size_t j = 0;
    for (size_t r = 0; r < u->n; r++) {
        if (u->step_of_place[r] >= 0 || u->singleton[r] >= 0)
            continue;
        while (u->step_of_column[j] >= 0 || u->singleton_of[j] >= 0)
            j++;
        drop_place_from_list(&u->lower, r);
        drop_place_from_list(&u->beside, r);
        u->member[r] = FMB_UNIT + j;
        u->place[u->steps] = (int)r;
        u->column[u->steps] = (int)j;
        u->pivot[u->steps] = 1;
        u->step_of_place[r] = u->step_of_column[j] = (int)u->steps++;
        u->lower.start[u->steps] = u->lower.size;
        u->upper.start[u->steps] = u->upper.size;
    }
}

fmb_status fmb_updated_lu_factor(fmb_updated_lu *u, size_t *member)
{
    u->etas = u->entry.size = u->edge.size = u->activated.size = 0;
    memcpy(u->member, member, u->n * sizeof *member);
    set_singletons_aside(u);
    FMB_TRY(list_beside(u));
    FMB_TRY(fmb_updated_lu_eliminate(u));
    fill_up_with_units(u);
    memcpy(member, u->member, u->n * sizeof *member);
    fmb_status st = transpose_rows(u, &u->lower, u->step_of_place, &u->lower_by_target);
    return st == FMB_OK ? transpose_rows(u, &u->upper, u->step_of_column, &u->upper_by_column) : st;
}

/* What v has but at place `but` and where it rests (NULL: nowhere), as list k. */
static void keep_list(fmb_compressed_rows *l, size_t k, const fmb_indexed_vector *v, size_t but,
                      const bool *rests)
{
    l->start[k] = l->size;
    for (size_t t = 0; t < fmb_indexed_vector_count(v); t++) {
        size_t at = fmb_indexed_vector_key(v, t);
        if (at != but && v->at[at] != 0 && !(rests && rests[at]))
            fmb_compressed_rows_push(l, at, v->at[at]);
    }
    l->start[k + 1] = l->size;
}

/* Why y_p is what it is at a place p that rests until now: the column of its singleton, in members
 * as they are, as list k; of other places nothing. */
static fmb_status activate_place(fmb_updated_lu *u, size_t k, size_t p)
{
    fmb_compressed_rows *l = &u->activated;
    int j = u->singleton[p];
    l->start[k] = l->start[k + 1] = l->size;
    if (!u->rests[p])
        return FMB_OK;
    size_t begin = u->beside.start[j], end = u->beside.start[j + 1];
    fmb_status st = fmb_compressed_rows_reserve(l, u->f->run->mem, end - begin + k);
    for (size_t t = begin; st == FMB_OK && t < end; t++)
        if (u->latest[u->beside.index[t]] < 0)
            fmb_compressed_rows_push(l, (size_t)u->beside.index[t],
                                     u->beside.value[t] * u->reciprocal[p]);
    for (size_t e = 0; st == FMB_OK && e < k; e++) {
        int one;
        fmb_terms m = fmb_member_terms(u->f, u->eta[e].member, &one);
        for (size_t t = 0; u->latest[u->eta[e].place] == (int)e && t < m.size; t++)
            if (m.column[t] == j)
                fmb_compressed_rows_push(l, u->eta[e].place, m.value[t] * u->reciprocal[p]);
    }
    l->start[k + 1] = l->size;
    u->rests[p] = false;
    u->resting[j] = -1;
    return st;
}

static fmb_status reserve_pivot(fmb_updated_lu *u, size_t entries, size_t edges)
{
    fmb_mem *mem = u->f->run->mem;
    fmb_status st = FMB_RESERVE(mem, &u->eta, &u->eta_room, u->etas + 1);
    FMB_THEN(st, fmb_compressed_rows_reserve(&u->entry, mem, entries));
    FMB_THEN(st, fmb_compressed_rows_reserve(&u->edge, mem, edges));
    FMB_THEN(st, fmb_compressed_rows_reserve_starts(&u->entry, mem, u->etas + 1));
    FMB_THEN(st, fmb_compressed_rows_reserve_starts(&u->edge, mem, u->etas + 1));
    return st == FMB_OK ? fmb_compressed_rows_reserve_starts(&u->activated, mem, u->etas + 1) : st;
}

fmb_status fmb_updated_lu_pivot(fmb_updated_lu *u, size_t place, size_t member,
                                const fmb_indexed_vector *entry, const fmb_indexed_vector *edge)
{
    fmb_status st =
        reserve_pivot(u, fmb_indexed_vector_count(entry), fmb_indexed_vector_count(edge));
    FMB_THEN(st, activate_place(u, u->etas, place));
    if (st != FMB_OK)
        return st;
    keep_list(&u->entry, u->etas, entry, place, u->rests);
    keep_list(&u->edge, u->etas, edge, FMB_NOWHERE, NULL);
    u->latest[place] = (int)u->etas;
    u->member[place] = member;
    u->eta[u->etas++] = (fmb_eta){.place = place, .member = member, .pivot = entry->at[place]};
    return FMB_OK;
}

bool fmb_updated_lu_is_long(const fmb_updated_lu *u)
{
    return u->etas > 100 ||
           (u->etas > 20 && u->entry.size + u->edge.size >
                                2 * (u->lower.size + u->upper.size + u->beside.size + u->n));
}

/* ---- solving --------------------------------------------------------------------------------- */

static inline void mark_step(fmb_updated_lu *u, int step)
{
    u->marks[step / 64] |= (uint64_t)1 << (step % 64);
}

static void mark_steps_of(fmb_updated_lu *u, const fmb_indexed_vector *v, const int *step_of)
{
    for (size_t t = 0; t < fmb_indexed_vector_count(v); t++) {
        size_t k = fmb_indexed_vector_key(v, t);
        if (v->at[k] != 0 && step_of[k] >= 0)
            mark_step(u, step_of[k]);
    }
}

/* from less factor times list k, with their steps marked. */
static inline void subtract_list(fmb_updated_lu *u, const fmb_compressed_rows *l, size_t k,
                                 double factor, double *from, const int *step_of)
{
    for (size_t t = l->start[k]; t < l->start[k + 1]; t++) {
        from[l->index[t]] -= factor * l->value[t];
        mark_step(u, step_of[l->index[t]]);
    }
}

/* The same, to an indexed vector. */
static void subtract_list_from(const fmb_compressed_rows *l, size_t k, double factor,
                               fmb_indexed_vector *from)
{
    for (size_t t = l->start[k]; t < l->start[k + 1]; t++)
        fmb_indexed_vector_add(from, (size_t)l->index[t], -factor * l->value[t]);
}

/* Marked steps go up; steps that are marked on the way are later ones. */
static void solve_lower(fmb_updated_lu *u, double *b)
{
    for (size_t w = 0; w <= u->steps / 64; w++)
        for (uint64_t done = 0, left; (left = u->marks[w] & ~done) != 0;) {
            int bit = __builtin_ctzll(left);
            size_t k = 64 * w + (size_t)bit;
            done |= (uint64_t)1 << bit;
            if (fabs(b[u->place[k]]) > FMB_NOTHING)
                subtract_list(u, &u->lower, k, b[u->place[k]], b, u->step_of_place);
        }
}

static void solve_upper(fmb_updated_lu *u, double *b, fmb_indexed_vector *x)
{
    for (size_t w = u->steps / 64 + 1; w-- > 0;)
        while (u->marks[w] != 0) {
            int bit = 63 - __builtin_clzll(u->marks[w]);
            size_t k = 64 * w + (size_t)bit;
            double value = b[u->place[k]] / u->pivot[k];
            u->marks[w] &= ~((uint64_t)1 << bit);
            b[u->place[k]] = 0;
            if (fabs(value) <= FMB_NOTHING)
                continue;
            fmb_indexed_vector_add(x, (size_t)u->column[k], value);
            subtract_list(u, &u->upper_by_column, k, value, b, u->step_of_place);
        }
}

static double member_times(const fmb_scaled_program *f, size_t i, const double *x)
{
    int one;
    fmb_terms m = fmb_member_terms(f, i, &one);
    double sum = 0;
    for (size_t k = 0; k < m.size; k++)
        sum += m.value[k] * x[m.column[k]];
    return sum;
}

/* Columns of singletons; what is left of b is that of the core, marked. */
static void solve_singletons(fmb_updated_lu *u, fmb_indexed_vector *b, fmb_indexed_vector *x)
{
    for (size_t t = 0; t < fmb_indexed_vector_count(b); t++) {
        size_t r = fmb_indexed_vector_key(b, t);
        if (b->at[r] == 0 || u->singleton[r] < 0)
            continue;
        size_t j = (size_t)u->singleton[r];
        double value = b->at[r] * u->reciprocal[r];
        b->at[r] = 0;
        fmb_indexed_vector_add(x, j, value);
        subtract_list(u, &u->beside, j, value, b->at, u->step_of_place);
    }
}

void fmb_updated_lu_solve(fmb_updated_lu *u, fmb_indexed_vector *b, fmb_indexed_vector *x)
{
    fmb_indexed_vector_clear(x, false);
    for (size_t k = 0; k < u->etas; k++)
        u->eta[k].right = b->at[u->eta[k].place];
    mark_steps_of(u, b, u->step_of_place);
    solve_singletons(u, b, x);
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
static void solve_upper_transposed(fmb_updated_lu *u, double *c, fmb_indexed_vector *y)
{
    for (size_t w = 0; w <= u->steps / 64; w++)
        for (uint64_t done = 0, left; (left = u->marks[w] & ~done) != 0;) {
            int bit = __builtin_ctzll(left);
            size_t k = 64 * w + (size_t)bit;
            double value = c[u->column[k]] / u->pivot[k];
            done |= (uint64_t)1 << bit;
            c[u->column[k]] = 0;
            if (fabs(value) <= FMB_NOTHING)
                continue;
            fmb_indexed_vector_add(y, (size_t)u->place[k], value);
            subtract_list(u, &u->upper, k, value, c, u->step_of_column);
        }
}

static void solve_lower_transposed(fmb_updated_lu *u, fmb_indexed_vector *y)
{
    const fmb_compressed_rows *l = &u->lower_by_target;
    for (size_t w = u->steps / 64 + 1; w-- > 0;)
        while (u->marks[w] != 0) {
            int bit = 63 - __builtin_clzll(u->marks[w]);
            size_t k = 64 * w + (size_t)bit;
            double value = y->at[u->place[k]];
            u->marks[w] &= ~((uint64_t)1 << bit);
            for (size_t t = l->start[k]; fabs(value) > FMB_NOTHING && t < l->start[k + 1]; t++) {
                fmb_indexed_vector_add(y, (size_t)l->index[t], -value * l->value[t]);
                mark_step(u, u->step_of_place[l->index[t]]);
            }
        }
}

/* What c has in columns of singletons becomes that of their places, and zero. */
static void price_singletons(fmb_updated_lu *u, fmb_indexed_vector *c, fmb_indexed_vector *y)
{
    for (size_t t = 0; t < fmb_indexed_vector_count(c); t++) {
        size_t j = fmb_indexed_vector_key(c, t);
        int r = u->singleton_of[j];
        if (r < 0 || c->at[j] == 0)
            continue;
        fmb_indexed_vector_add(y, (size_t)r, c->at[j] * u->reciprocal[r]);
        c->at[j] = 0;
    }
}

/* What places at rest have of a member with the multiplier `value`. */
static inline void price_at_rest(const fmb_updated_lu *u, fmb_terms m, double value,
                                 fmb_indexed_vector *y)
{
    const int *resting = u->resting;
    const double *reciprocal = u->reciprocal;
    double *at = y->at;
    int *index = y->index;
    size_t count = y->count;
    for (size_t k = 0; k < m.size; k++) {
        int s = resting[m.column[k]];
        if (s < 0)
            continue;
        double before = at[s], sum = before - value * m.value[k] * reciprocal[s];
        index[count] = s;
        count += before == 0;
        at[s] = sum != 0 ? sum : FMB_NOTHING / 2;
    }
    y->count = count;
}

/* Places at rest, from all others. */
static void price_places_at_rest(fmb_updated_lu *u, fmb_indexed_vector *y)
{
    for (size_t t = 0, count = y->count; t < count; t++) {
        size_t r = (size_t)y->index[t];
        double value = y->at[r];
        int one;
        if (!u->rests[r] && fabs(value) > FMB_NOTHING)
            price_at_rest(u, fmb_member_terms(u->f, u->member[r], &one), value, y);
    }
}

/* The number at the place of an exchange before it. */
static double price_before_pivot(const fmb_updated_lu *u, size_t k, const double *y)
{
    double at = y[u->eta[k].place];
    for (size_t t = u->activated.start[k]; t < u->activated.start[k + 1]; t++)
        at -= u->activated.value[t] * y[u->activated.index[t]];
    return at;
}

void fmb_updated_lu_solve_transposed(fmb_updated_lu *u, fmb_indexed_vector *c,
                                     fmb_indexed_vector *y)
{
    fmb_indexed_vector_clear(y, false);
    mark_steps_of(u, c, u->step_of_column);
    price_singletons(u, c, y);
    solve_upper_transposed(u, c->at, y);
    solve_lower_transposed(u, y);
    c->count = 0;
    for (size_t k = 0; k < u->etas; k++) {
        const fmb_eta *e = &u->eta[k];
        double at = price_before_pivot(u, k, y->at);
        bool vanishes = fabs(at) <= FMB_NOTHING;
        if (!vanishes || y->at[e->place] != 0)
            fmb_indexed_vector_put(y, e->place, vanishes ? 0 : at / e->pivot);
        if (!vanishes)
            subtract_list_from(&u->entry, k, at / e->pivot, y);
    }
    price_places_at_rest(u, y);
}
