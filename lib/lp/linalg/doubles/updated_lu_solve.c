/* updated_lu_solve.c: see updated_lu.h. */
#include "lp/linalg/doubles/updated_lu.h"

#include "base/arrays.h"

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_arrays_of_lu(fmb_updated_lu *u, bool get)
{
    const size_t n = u->n, steps = n + FMB_MOST_EXCHANGES;
    return FMB_ARRAYS(u->f->run->mem, get, FMB_ARRAY(u->member, n), FMB_ARRAY(u->singleton, n),
                      FMB_ARRAY(u->singleton_of, n), FMB_ARRAY(u->reciprocal, n),
                      FMB_ARRAY(u->turned, FMB_MOST_EXCHANGES), FMB_ARRAY(u->place_of_step, steps),
                      FMB_ARRAY(u->column, n), FMB_ARRAY(u->step, n),
                      FMB_ARRAY(u->slot_of_place, n), FMB_ARRAY(u->slot_of_column, n),
                      FMB_ARRAY(u->slot_of_step, steps));
}

fmb_status fmb_updated_lu_init(fmb_updated_lu *u, const fmb_scaled_program *f)
{
    fmb_mem *mem = f->run->mem;
    *u = (fmb_updated_lu){.f = f, .n = f->n};
    fmb_arena_init(&u->arena, mem);
    fmb_status st = hold_arrays_of_lu(u, true);
    FMB_THEN(st, fmb_triangle_init(&u->lower, mem, u->n + FMB_MOST_EXCHANGES));
    FMB_THEN(st, fmb_triangle_init(&u->upper, mem, u->n));
    FMB_THEN(st, fmb_compressed_rows_reserve_starts(&u->beside, mem, u->n));
    FMB_THEN(st, fmb_compressed_rows_reserve(&u->written, mem, u->n));
    FMB_THEN(st, fmb_compressed_rows_reserve(&u->left, mem, u->n));
    return st == FMB_OK ? fmb_compressed_rows_reserve_starts(&u->turn, mem, FMB_MOST_EXCHANGES)
                        : st;
}

void fmb_updated_lu_clear(fmb_updated_lu *u)
{
    fmb_mem *mem = u->f->run->mem;
    fmb_triangle_clear(&u->lower, mem);
    fmb_triangle_clear(&u->upper, mem);
    fmb_compressed_rows_free(&u->beside, mem);
    fmb_compressed_rows_free(&u->written, mem);
    fmb_compressed_rows_free(&u->left, mem);
    fmb_compressed_rows_free(&u->turn, mem);
    fmb_arena_clear(&u->arena);
    (void)hold_arrays_of_lu(u, false);
}

/* ---- singletons ------------------------------------------------------------------------------ */

/* Make the first member with only one column, for each column, a singleton. */
static void set_singletons_aside(fmb_updated_lu *u)
{
    memset(u->singleton, -1, u->n * sizeof *u->singleton);
    memset(u->singleton_of, -1, u->n * sizeof *u->singleton_of);
    for (size_t r = 0; r < u->n; r++) {
        int one;
        fmb_terms t = fmb_member_terms(u->f, u->member[r], &one);
        if (t.size != 1 || u->singleton_of[*t.column] >= 0)
            continue;
        u->singleton[r] = *t.column;
        u->singleton_of[*t.column] = (int)r;
        u->reciprocal[r] = 1 / *t.value;
    }
}

/* Count the core's entries in columns of singletons, or (put) store each before earlier ones. */
static void look_beside(fmb_updated_lu *u, bool put)
{
    fmb_compressed_rows *b = &u->beside;
    for (size_t r = u->n; r-- > 0;) {
        int one;
        fmb_terms t = fmb_member_terms(u->f, u->member[r], &one);
        for (size_t k = 0; u->singleton[r] < 0 && k < t.size; k++) {
            size_t *at = &b->start[t.column[k]];
            if (u->singleton_of[t.column[k]] < 0)
                continue;
            *at = put ? *at - 1 : *at + 1;
            if (put) {
                b->index[*at] = (int)r;
                b->value[*at] = t.value[k];
            }
        }
    }
}

static fmb_status list_beside(fmb_updated_lu *u)
{
    fmb_compressed_rows *b = &u->beside;
    size_t sum = 0;
    memset(b->start, 0, (u->n + 1) * sizeof *b->start);
    look_beside(u, false);
    for (size_t j = 0; j <= u->n; j++) {
        sum += b->start[j];
        b->start[j] = sum;
    }
    b->size = 0;
    FMB_TRY(fmb_compressed_rows_reserve(b, u->f->run->mem, sum));
    b->size = sum;
    look_beside(u, true);
    return FMB_OK;
}

/* ---- factoring ------------------------------------------------------------------------------- */

static void drop_place_from_list(fmb_compressed_rows *l, size_t r)
{
    for (size_t t = 0; t < l->size; t++)
        l->value[t] = l->index[t] == (int)r ? 0 : l->value[t];
}

/* Give places of the core without a slot the columns without one, as unit vectors, from which
 * nothing was subtracted. */
static void fill_up_with_units(fmb_updated_lu *u)
{
    size_t j = 0;
    for (size_t r = 0; r < u->n; r++) {
        if (u->slot_of_place[r] >= 0 || u->singleton[r] >= 0)
            continue;
        while (u->slot_of_column[j] >= 0 || u->singleton_of[j] >= 0)
            j++;
        drop_place_from_list(&u->lower.ahead, r);
        drop_place_from_list(&u->beside, r);
        u->member[r] = FMB_UNIT + j;
        fmb_updated_lu_take_slot(u, (int)r, (int)j, 1);
    }
}

fmb_status fmb_updated_lu_factor(fmb_updated_lu *u, size_t *member)
{
    u->core = u->turns = 0;
    u->lower.ahead.size = u->upper.ahead.size = u->turn.size = 0;
    u->lower.ahead.start[0] = u->upper.ahead.start[0] = u->turn.start[0] = 0;
    memset(u->slot_of_place, -1, u->n * sizeof *u->slot_of_place);
    memset(u->slot_of_column, -1, u->n * sizeof *u->slot_of_column);
    memcpy(u->member, member, u->n * sizeof *member);
    set_singletons_aside(u);
    FMB_TRY(list_beside(u));
    FMB_TRY(fmb_updated_lu_eliminate(u));
    fill_up_with_units(u);
    memcpy(member, u->member, u->n * sizeof *member);
    FMB_TRY(fmb_triangle_finish(&u->lower, u->f->run->mem, u->core, u->slot_of_place));
    return fmb_triangle_finish(&u->upper, u->f->run->mem, u->core, u->slot_of_column);
}

/* ---- exchanges ------------------------------------------------------------------------------- */

/* Move the place of a singleton into the core; returns its slot. */
static size_t wake_place(fmb_updated_lu *u, size_t p)
{
    size_t s = u->upper.steps;
    double w = 1 / u->reciprocal[p];
    int j = u->singleton[p];
    for (size_t t = 0; t < u->left.size; t++)
        fmb_triangle_push(&u->upper, (size_t)u->left.index[t], -w * u->left.value[t]);
    fmb_triangle_add(&u->upper, w);
    u->column[s] = j;
    u->slot_of_place[p] = u->slot_of_column[j] = (int)s;
    u->singleton[p] = u->singleton_of[j] = -1;
    return s;
}

/* Keep the entries of z except entry s, divided by entry s, which is one over the pivot. */
static void keep_turn(fmb_updated_lu *u, size_t s, double pivot)
{
    for (size_t t = 0; t < u->left.size; t++)
        if (u->left.index[t] != (int)s)
            fmb_compressed_rows_push(&u->turn, (size_t)u->left.index[t], u->left.value[t] * pivot);
    u->turned[u->turns++] = (int)s;
    u->turn.start[u->turns] = u->turn.size;
}

static fmb_status reserve_pivot(fmb_updated_lu *u)
{
    fmb_mem *mem = u->f->run->mem;
    FMB_TRY(fmb_triangle_reserve(&u->lower, mem, u->written.size));
    FMB_TRY(fmb_triangle_reserve(&u->upper, mem, u->left.size));
    return fmb_compressed_rows_reserve(&u->turn, mem, u->left.size);
}

fmb_status fmb_updated_lu_pivot(fmb_updated_lu *u, size_t place, size_t member, double entry)
{
    FMB_TRY(reserve_pivot(u));
    size_t s;
    if (u->singleton[place] >= 0) {
        s = wake_place(u, place);
    } else {
        s = (size_t)u->slot_of_place[place];
        double pivot = u->lower.pivot[u->step[s]];
        keep_turn(u, s, pivot);
        entry *= pivot;
        fmb_triangle_drop(&u->lower, (size_t)u->step[s]);
    }
    for (size_t t = 0; t < u->written.size; t++)
        if (u->written.index[t] != (int)s)
            fmb_triangle_push(&u->lower, (size_t)u->step[u->written.index[t]], u->written.value[t]);
    u->step[s] = (int)u->lower.steps;
    u->slot_of_step[u->lower.steps] = (int)s;
    u->place_of_step[u->lower.steps] = (int)place;
    fmb_triangle_add(&u->lower, entry);
    u->member[place] = member;
    return FMB_OK;
}

bool fmb_updated_lu_is_long(const fmb_updated_lu *u)
{
    size_t exchanges = u->lower.steps - u->core,
           first = u->lower.ahead.size + u->upper.ahead.size + u->beside.size + u->n;
    return exchanges + 1 >= FMB_MOST_EXCHANGES ||
           (exchanges > 20 && u->lower.links + u->upper.links + u->turn.size > first);
}

/* ---- solving --------------------------------------------------------------------------------- */

static double member_times(const fmb_scaled_program *f, size_t i, const double *x)
{
    int one;
    fmb_terms m = fmb_member_terms(f, i, &one);
    double sum = 0;
    for (size_t k = 0; k < m.size; k++)
        sum += m.value[k] * x[m.column[k]];
    return sum;
}

/* The step of a place in the core. */
static inline size_t step_of_place(const fmb_updated_lu *u, size_t r)
{
    return (size_t)u->step[u->slot_of_place[r]];
}

/* Add value to x_j, j a singleton's column, and correct right sides of unexchanged core members. */
static void solve_singleton(fmb_updated_lu *u, size_t j, double value, fmb_indexed_vector *x)
{
    fmb_indexed_vector_add(x, j, value);
    for (size_t t = u->beside.start[j]; t < u->beside.start[j + 1]; t++) {
        size_t k = step_of_place(u, (size_t)u->beside.index[t]);
        if (k < u->core)
            fmb_triangle_put(&u->lower, k, -value * u->beside.value[t]);
    }
}

/* Solve for the columns of singletons; the rest of b is the right side of the core. */
static void load_right_side(fmb_updated_lu *u, fmb_indexed_vector *b, fmb_indexed_vector *x)
{
    for (size_t t = 0; t < b->count; t++) {
        size_t r = (size_t)b->index[t];
        double value = b->at[r];
        b->at[r] = 0;
        if (value == 0)
            continue;
        if (u->singleton[r] >= 0)
            solve_singleton(u, (size_t)u->singleton[r], value * u->reciprocal[r], x);
        else
            fmb_triangle_put(&u->lower, step_of_place(u, r), value);
    }
    b->count = 0;
    for (size_t k = u->core; x->count > 0 && k < u->lower.steps; k++) {
        double value = member_times(u->f, u->member[u->place_of_step[k]], x->at);
        if (value != 0)
            fmb_triangle_put(&u->lower, k, -value);
    }
}

/* T_1^-1 ... T_k^-1 times `upper`. */
static void turn_back(fmb_updated_lu *u)
{
    for (size_t k = u->turns; k-- > 0;) {
        double value = u->upper.v[u->turned[k]];
        for (size_t t = u->turn.start[k]; value != 0 && t < u->turn.start[k + 1]; t++)
            fmb_triangle_put(&u->upper, (size_t)u->turn.index[t], value * u->turn.value[t]);
    }
}

/* `upper` times that. */
static void turn_across(fmb_updated_lu *u)
{
    for (size_t k = 0; k < u->turns; k++) {
        double sum = 0;
        for (size_t t = u->turn.start[k]; t < u->turn.start[k + 1]; t++)
            sum += u->turn.value[t] * u->upper.v[u->turn.index[t]];
        if (sum != 0)
            fmb_triangle_put(&u->upper, (size_t)u->turned[k], sum);
    }
}

void fmb_updated_lu_solve(fmb_updated_lu *u, fmb_indexed_vector *b, fmb_indexed_vector *x)
{
    bool wakes = b->count == 1 && u->singleton[b->index[0]] >= 0;
    fmb_indexed_vector_clear(x, false);
    load_right_side(u, b, x);
    fmb_triangle_forward(&u->lower);
    fmb_triangle_move(&u->lower, u->slot_of_step, &u->upper);
    if (!wakes)
        fmb_triangle_list(&u->upper, &u->left);
    turn_back(u);
    if (wakes)
        fmb_triangle_list(&u->upper, &u->left);
    fmb_triangle_backward(&u->upper);
    fmb_triangle_hand_out(&u->upper, u->column, x);
}

/* Move the entries of c in columns of singletons to the places of these. */
static void load_cost(fmb_updated_lu *u, fmb_indexed_vector *c, fmb_indexed_vector *y)
{
    for (size_t t = 0; t < c->count; t++) {
        size_t j = (size_t)c->index[t];
        int r = u->singleton_of[j];
        if (r >= 0)
            fmb_indexed_vector_add(y, (size_t)r, c->at[j] * u->reciprocal[r]);
        else
            fmb_triangle_put(&u->upper, (size_t)u->slot_of_column[j], c->at[j]);
        c->at[j] = 0;
    }
    c->count = 0;
}

/* Subtract a member times the multiplier `value` from the places of singletons. */
static inline void price_at_rest(const fmb_updated_lu *u, fmb_terms m, double value,
                                 fmb_indexed_vector *y)
{
    const int *singleton_of = u->singleton_of;
    for (size_t k = 0; k < m.size; k++) {
        int r = singleton_of[m.column[k]];
        if (r >= 0 && y->full)
            y->at[r] -= value * m.value[k] * u->reciprocal[r];
        else if (r >= 0)
            fmb_indexed_vector_add(y, (size_t)r, -value * m.value[k] * u->reciprocal[r]);
    }
}

/* The number of terms of the members in the core that count; counting may stop beyond `most`. */
static size_t count_terms(const fmb_updated_lu *u, const fmb_indexed_vector *y, size_t most)
{
    size_t terms = 0;
    int one;
    for (size_t t = 0; t < y->count && terms < most; t++) {
        size_t r = (size_t)y->index[t];
        if (u->singleton[r] < 0)
            terms += fmb_member_terms(u->f, u->member[r], &one).size;
    }
    return terms;
}

/* Compute the values at places of singletons from all others. */
static void price_places_at_rest(fmb_updated_lu *u, fmb_indexed_vector *y)
{
    size_t count = y->count;
    y->full = count_terms(u, y, u->n / 4 + 1) > u->n / 4;
    for (size_t t = 0; t < count; t++) {
        size_t r = (size_t)y->index[t];
        int one;
        if (u->singleton[r] < 0 && fabs(y->at[r]) > FMB_NOTHING)
            price_at_rest(u, fmb_member_terms(u->f, u->member[r], &one), y->at[r], y);
    }
}

void fmb_updated_lu_solve_transposed(fmb_updated_lu *u, fmb_indexed_vector *c,
                                     fmb_indexed_vector *y)
{
    fmb_indexed_vector_clear(y, false);
    load_cost(u, c, y);
    fmb_triangle_forward(&u->upper);
    turn_across(u);
    fmb_triangle_list(&u->upper, &u->written);
    fmb_triangle_move(&u->upper, u->step, &u->lower);
    fmb_triangle_backward(&u->lower);
    fmb_triangle_hand_out(&u->lower, u->place_of_step, y);
    price_places_at_rest(u, y);
}
