/* active_set.c: see active_set.h. */
#include "lp/redundancy/active_set/active_set.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"
#include "lp/simplex/bounded/bounded_simplex.h"

/* Numbers below these are taken for rounding errors, in multipliers and in pivots: inputs are about
 * 1. */
#define ROUNDING    1e-9
#define LEAST_PIVOT 1e-7

/* ---- rows ------------------------------------------------------------------------------------ */

static void scale_row(fmb_scaled_rows *s, size_t i)
{
    const fmb_vec *v = s->row[i].v;
    const fmb_leading_rows *t = s->leading;
    s->exponent[i] = fmb_leading_rows_bits(t, v);
    for (size_t k = 0; k < s->d; k++)
        s->at[k * s->m + i] = fmb_vec_entry_double(v, k < s->n ? t->column[k] : t->right,
                                                   s->exponent[i] + t->shift[k]);
}

static fmb_status hold_scaled_rows(fmb_scaled_rows *s, fmb_mem *mem, bool get)
{
    return FMB_ARRAYS_IN_BLOCK(mem, get, FMB_ARRAY(s->at, s->d * s->m),
                               FMB_ARRAY(s->exponent, s->m));
}

fmb_status fmb_scaled_rows_init(fmb_scaled_rows *s, fmb_mem *mem, size_t n, size_t m,
                                const fmb_lp_row *row, bool small, const fmb_leading_rows *leading)
{
    *s = (fmb_scaled_rows){
        .n = leading->n, .m = m, .row = row, .small = small, .leading = leading, .width = n};
    s->d = s->n + 1;
    FMB_TRY(hold_scaled_rows(s, mem, true));
    for (size_t i = 0; i < m; i++)
        scale_row(s, i);
    fmb_program_init(&s->sparse, mem, (int)n);
    for (size_t i = 0; !small && i < m; i++)
        FMB_TRY(fmb_program_add_dense(&s->sparse, row[i].v, row[i].rel));
    return FMB_OK;
}

void fmb_scaled_rows_clear(fmb_scaled_rows *s, fmb_mem *mem)
{
    (void)hold_scaled_rows(s, mem, false);
    if (s->sparse.mem)
        fmb_program_clear(&s->sparse);
}

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_arrays_of_search(fmb_active_set *s, bool get)
{
    const size_t m = s->of->m;
    return FMB_ARRAYS_IN_BLOCK(s->run->mem, get, FMB_ARRAY_ZERO(s->gone, m),
                               FMB_ARRAY_ZERO(s->kept, m), FMB_ARRAY(s->target, s->of->d),
                               FMB_ARRAY(s->price, m), FMB_ARRAY(s->way, s->of->n),
                               FMB_ARRAY(s->speed, m), FMB_ARRAY(s->number, m),
                               FMB_ARRAY(s->source, m + 1), FMB_ARRAY(s->support, s->of->d));
}

fmb_status fmb_active_set_init(fmb_active_set *s, fmb_run *run, const fmb_scaled_rows *of,
                               const fmb_interior_point *seen)
{
    *s = (fmb_active_set){.run = run, .of = of, .seen = seen, .inactive = of->m};
    FMB_TRY(fmb_basis_init(&s->cone, run->mem, run->kernels, of->d));
    s->cone.value_zero = ROUNDING;
    s->cone.entry_zero = LEAST_PIVOT;
    FMB_TRY(hold_arrays_of_search(s, true));
    for (size_t i = 0; i < of->m; i++)
        s->number[i] = SIZE_MAX;
    return of->small ? fmb_rounded_proof_init(&s->proof, run->mem, of->d)
                     : fmb_combination_init(&s->combination, run->mem, of->width, of->row);
}

void fmb_active_set_clear(fmb_active_set *s)
{
    if (!s->run)
        return;
    fmb_mem *mem = s->run->mem;
    fmb_basis_clear(&s->cone);
    fmb_rounded_proof_clear(&s->proof, mem);
    fmb_combination_clear(&s->combination);
    (void)hold_arrays_of_search(s, false);
    fmb_mem_put(mem, s->proved, s->proved_room, sizeof *s->proved);
    s->run = NULL;
}

/* ---- proofs ---------------------------------------------------------------------------------- */

/* The row at place r of the basis if it has a multiplier in a proof of row i; else m. Row i and
 * removed rows may still be basic, at 0. An edge on which the right side falls may give them
 * multipliers, but they prove nothing. */
static size_t row_in_proof(const fmb_active_set *s, size_t i, size_t r)
{
    size_t g = s->cone.basic[r], j = g == SIZE_MAX ? s->of->m : s->source[g];
    bool counts = j < s->of->m && j != i && !s->gone[j] && fabs(s->cone.value[r]) >= ROUNDING;
    return counts ? j : s->of->m;
}

/* Round the multipliers of the basis for target i; false if they are not simple. */
static bool round_multipliers_of_basis(fmb_active_set *s, size_t i)
{
    const int *exponent = s->of->exponent;
    fmb_rounded_proof_begin(&s->proof);
    for (size_t r = 0; r < s->of->d; r++) {
        size_t j = row_in_proof(s, i, r);
        if (j < s->of->m && !fmb_rounded_proof_add(
                                &s->proof, j, ldexp(s->cone.value[r], exponent[i] - exponent[j])))
            return false;
    }
    return true;
}

/* Which rows make up the least right side along the edge on which it falls. Multipliers need not
 * meet a right side exactly: so a vertex where it counts for none is left for the next one. */
static void let_right_side_fall(fmb_active_set *s)
{
    fmb_basis *b = &s->cone;
    double most = HUGE_VAL;
    size_t leaves = SIZE_MAX;
    if (b->is_basic[0])
        return;
    fmb_basis_write(b, 0);
    for (size_t r = 0; r < s->of->d; r++) {
        bool bounded = b->basic[r] != SIZE_MAX && b->range[b->basic[r]] == FMB_RANGE_UP;
        if (bounded && b->entry[r] > LEAST_PIVOT && b->value[r] < most * b->entry[r]) {
            most = b->value[r] / b->entry[r];
            leaves = r;
        }
    }
    for (size_t r = 0; leaves < SIZE_MAX && r < s->of->d; r++)
        b->value[r] = r == leaves ? 0 : b->value[r] - most * b->entry[r];
}

/* Is row i a combination of the rows of the basis with multipliers? Where these cannot be told from
 * 0, or right sides may be equal, they are solved for. */
static fmb_status combine_rows_of_basis(fmb_active_set *s, size_t i, bool *proved)
{
    fmb_refined refined;
    let_right_side_fall(s);
    s->supports = 0;
    for (size_t r = 0; r < s->of->d; r++) {
        size_t j = row_in_proof(s, i, r);
        if (j < s->of->m)
            s->support[s->supports++] = j;
    }
    *proved = false;
    if (s->supports > s->of->n)
        return FMB_OK;
    const size_t size = s->supports,
                 limbs = fmb_vec_most_bits(s->of->row[i].v, s->of->width + 1) / 64 + 1;
    fmb_run_count(s->run, 3000 + size * size * (2 * size + 50 + limbs));
    FMB_TRY(fmb_refined_implication(s->run, &s->of->sparse, i, size, s->support, &refined));
    *proved = refined == FMB_REFINED_TRUE;
    if (refined != FMB_REFINED_UNKNOWN)
        return FMB_OK;
    fmb_run_count(s->run, 6 * limbs * size * size * size * (30 + limbs));
    FMB_TRY(fmb_combine(&s->combination, s->run, i, s->support, size, proved));
    *proved = *proved && fmb_combination_proves(&s->combination);
    s->supports = s->combination.size;
    memcpy(s->support, s->combination.index, s->supports * sizeof *s->support);
    return FMB_OK;
}

static fmb_status note_proof_of_row(fmb_active_set *s, size_t i)
{
    size_t size = s->of->small ? s->proof.size : s->supports;
    const size_t *index = s->of->small ? s->proof.index : s->support;
    FMB_TRY(FMB_RESERVE(s->run->mem, &s->proved, &s->proved_room, s->told + 2 + size));
    s->proved[s->told++] = i;
    s->proved[s->told++] = size;
    for (size_t k = 0; k < size; k++)
        s->proved[s->told++] = index[k];
    return FMB_OK;
}

static void note_row_gone(fmb_active_set *s, size_t i)
{
    s->gone[i] = true;
    if (s->number[i] != SIZE_MAX)
        s->cone.range[s->number[i]] = FMB_RANGE_ZERO;
    else
        s->inactive--;
}

/* The cone says that row i is implied: prove it, and let it go. */
static fmb_status drop_row_if_proved(fmb_active_set *s, size_t i)
{
    bool proved = false;
    fmb_run_count(s->run, 200 + 4 * s->of->d * s->of->d);
    if (!s->of->small)
        FMB_TRY(combine_rows_of_basis(s, i, &proved));
    else
        proved = round_multipliers_of_basis(s, i) &&
                 fmb_rounded_proof_holds(&s->proof, s->of->n, s->of->row, i);
    if (!proved) {
        s->doubtful++;
        return FMB_OK;
    }
    note_row_gone(s, i);
    return note_proof_of_row(s, i);
}

/* ---- rays ------------------------------------------------------------------------------------ */

/* What the ray hits is kept; SIZE_MAX: nothing that is proved thereby. */
static size_t keep_row_hit(fmb_active_set *s)
{
    fmb_run_count(s->run, s->of->m * (2 + s->of->d / 4));
    size_t hit = fmb_interior_point_shoot(s->seen, s->way, s->gone, s->speed);
    if (hit != SIZE_MAX)
        s->kept[hit] = true;
    return hit;
}

fmb_status fmb_active_set_shoot(fmb_active_set *s, size_t from, size_t to)
{
    for (size_t i = from; i < to; i++) {
        for (size_t j = 0; j < s->of->n; j++)
            s->way[j] = s->of->at[j * s->of->m + i];
        (void)keep_row_hit(s);
        FMB_TRY(fmb_run_poll(s->run));
    }
    return FMB_OK;
}

/* Behind the hyperplane lies a point that breaks the row at hand and no other active row: shoot
 * there. */
static size_t shoot_beyond_normal(fmb_active_set *s)
{
    const double *normal = s->cone.normal;
    double depth = normal[s->of->n];
    if (!s->seen)
        return SIZE_MAX;
    for (size_t j = 0; j < s->of->n; j++) /* at the scale of the point, 1 / depth */
        s->way[j] = -normal[j] - depth * s->seen->x[j];
    return keep_row_hit(s);
}

/* ---- guesses --------------------------------------------------------------------------------- */

static void aim_at_row(fmb_active_set *s, size_t i)
{
    for (size_t k = 0; k < s->of->d; k++)
        s->target[k] = s->of->at[k * s->of->m + i];
}

static fmb_status activate_row_in_cone(fmb_active_set *s, size_t i)
{
    aim_at_row(s, i);
    s->inactive--;
    s->number[i] = s->generators;
    s->source[s->generators++] = i;
    return fmb_basis_add(&s->cone, s->target,
                         s->of->row[i].rel == FMB_EQ ? FMB_RANGE_FREE : FMB_RANGE_UP);
}

/* The sleeping row farthest beyond the hyperplane, SIZE_MAX if none is. */
static size_t find_farthest_inactive(fmb_active_set *s)
{
    size_t best = SIZE_MAX, m = s->of->m;
    double least = 0;
    if (s->inactive == 0)
        return SIZE_MAX;
    fmb_run_count(s->run, m * s->of->d / 4);
    memset(s->price, 0, m * sizeof *s->price);
    for (size_t k = 0; k < s->of->d; k++)
        s->run->kernels->accumulate(s->price, &s->of->at[k * m], m, s->cone.normal[k]);
    for (size_t i = 0; i < m; i++)
        if (s->price[i] < least && s->number[i] == SIZE_MAX && !s->gone[i]) {
            least = s->price[i];
            best = i;
        }
    return best;
}

/* A row that sleeps beyond the hyperplane, best one that is proved to stay; SIZE_MAX if none does.
 */
static size_t find_row_to_activate(fmb_active_set *s)
{
    size_t hit = shoot_beyond_normal(s);
    return hit != SIZE_MAX && s->number[hit] == SIZE_MAX ? hit : find_farthest_inactive(s);
}

/* Activate rows until those that are active imply row i, or it is active itself. */
static fmb_status test_inactive_row(fmb_active_set *s, size_t i)
{
    fmb_status st = FMB_OK;
    while (st == FMB_OK && s->number[i] == SIZE_MAX) {
        fmb_guess guess;
        aim_at_row(s, i);
        st = fmb_simplex_search(&s->cone, s->target, SIZE_MAX, s->run, &guess);
        if (st == FMB_OK && guess == FMB_GUESS_INSIDE)
            st = drop_row_if_proved(s, i);
        if (guess == FMB_GUESS_INSIDE && s->gone[i])
            return st;
        size_t j = guess == FMB_GUESS_OUTSIDE ? find_row_to_activate(s) : i;
        FMB_THEN(st, activate_row_in_cone(s, j == SIZE_MAX ? i : j));
        FMB_THEN(st, fmb_run_poll(s->run));
    }
    return st;
}

/* Does row i, active itself, lie beyond all active ones? Others may be inactive there: *on if one
 * was activated. */
static fmb_status activate_row_beyond_normal(fmb_active_set *s, size_t i, bool *on)
{
    size_t j = find_row_to_activate(s);
    *on = !s->kept[i] && j != SIZE_MAX;
    return *on ? activate_row_in_cone(s, j) : FMB_OK;
}

/* Once more with all rows that matter active. */
static fmb_status test_active_row(fmb_active_set *s, size_t i)
{
    for (bool on = true; on;) {
        fmb_guess guess;
        on = false;
        aim_at_row(s, i);
        FMB_TRY(fmb_simplex_search(&s->cone, s->target, s->number[i], s->run, &guess));
        if (guess == FMB_GUESS_INSIDE)
            FMB_TRY(drop_row_if_proved(s, i));
        else if (guess == FMB_GUESS_OUTSIDE)
            FMB_TRY(activate_row_beyond_normal(s, i, &on));
        FMB_TRY(fmb_run_poll(s->run));
    }
    return FMB_OK;
}

/* ---- a search -------------------------------------------------------------------------------- */

static bool is_row_settled(const fmb_active_set *s, size_t i)
{
    return s->gone[i] || s->kept[i] || s->of->row[i].rel == FMB_EQ;
}

static fmb_status activate_row_into_basis(fmb_active_set *s, size_t i)
{
    FMB_TRY(activate_row_in_cone(s, i));
    (void)fmb_basis_span(&s->cone, s->number[i], LEAST_PIVOT);
    return fmb_run_poll(s->run);
}

/* The right side as generator 0, rows that stay, and others until they span what they can. */
static fmb_status activate_first_rows(fmb_active_set *s)
{
    size_t d = s->of->d;
    for (size_t k = 0; k < d; k++)
        s->target[k] = k + 1 == d;
    s->source[s->generators++] = s->of->m;
    FMB_TRY(fmb_basis_add(&s->cone, s->target, FMB_RANGE_UP));
    (void)fmb_basis_span(&s->cone, 0, LEAST_PIVOT);
    for (size_t i = 0; i < s->of->m; i++)
        if (is_row_settled(s, i))
            FMB_TRY(activate_row_into_basis(s, i));
    for (size_t i = 0; i < s->of->m && s->cone.pivots < d; i++)
        if (s->number[i] == SIZE_MAX)
            FMB_TRY(activate_row_into_basis(s, i));
    return FMB_OK;
}

static bool is_time_to_pause(fmb_active_set *s)
{
    s->paused = s->pauses && fmb_run_is_slice_over(s->run);
    return s->paused;
}

/* Inactive rows, or in the second pass active ones. */
static fmb_status test_open_rows(fmb_active_set *s, size_t rows, const size_t *open)
{
    fmb_status st = FMB_OK;
    for (; st == FMB_OK && s->tested < rows && !is_time_to_pause(s); s->tested++) {
        size_t i = open[s->tested];
        if (s->again && !is_row_settled(s, i))
            st = test_active_row(s, i);
        else if (!s->again && s->number[i] == SIZE_MAX && !s->gone[i])
            st = test_inactive_row(s, i);
    }
    return st;
}

fmb_status fmb_active_set_test(fmb_active_set *s, const size_t *open, size_t from, size_t to)
{
    s->paused = false;
    if (from == to)
        return FMB_OK;
    FMB_TRY(s->generators == 0 ? activate_first_rows(s) : FMB_OK);
    FMB_TRY(test_open_rows(s, to - from, open + from));
    if (!s->paused && !s->again) {
        s->doubtful = 0; /* they were activated, and are tried again */
        s->tested = 0;
        s->again = true;
        FMB_TRY(test_open_rows(s, to - from, open + from));
    }
    return FMB_OK;
}
