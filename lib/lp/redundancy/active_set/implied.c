/* implied.c: redundancy by guessed multipliers; see implied.h.
 *
 * Where a point strictly inside is known, rays from there tell most rows that are irredundant
 * (interior_point.h). The others are tested against these and whatever else they need
 * (active_set.h): by one search, or where they are many by a fixed number of searches, each with a
 * range of them and with what it found out itself, so that what goes does not depend on how many
 * threads there are.
 *
 * Each proof of one search names no row that went before; but proofs of several may argue in a
 * circle: each of two equal rows may go for the other. So searches are heard one after another, and
 * no row goes that an accepted proof of another search names. Then a row that went rests on rows
 * that stay, on some that went in earlier searches, or later in its own: there is no circle, and
 * those that stay imply all.
 */
#include "lp/redundancy/active_set/implied.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/arrays.h"
#include "base/ways.h"
#include "elim/tiny/tiny.h"
#include "lp/oracle/oracle.h"
#include "lp/redundancy/active_set/active_set.h"
#include "num/gcd.h"
#include "trace/team.h"

/* Rows shot at before the search: each shot looks at all rows. */
#define MOST_SHOTS 1024
/* Searches of one question, and numbers in its rows that are worth them: about a millisecond. */
enum { SEARCHES = 4, WORTH_SEARCHES = 4048 };

/* ---- rows in the columns that some of them name ---------------------------------------------- */

/* Of the columns of a part, an elimination leaves few: whoever looks at all entries of a row should
 * not look at the others. */
typedef struct nonzero_columns {
    fmb_mem *mem;
    size_t n, m;     /* columns, rows */
    fmb_lp_row *row; /* [m] over n columns */
    fmb_vec *v;      /* [m] */
    int64_t *entry;  /* [m][n + 1] */
} nonzero_columns;

/* Those of coefficients that some row names, and last that of right sides. */
static size_t choose_columns(size_t n, size_t m, const fmb_lp_row *row, size_t *to)
{
    size_t chosen = 0;
    for (size_t j = 0; j < n; j++) {
        bool nonzero = false;
        for (size_t i = 0; i < m && !nonzero; i++)
            nonzero = row[i].v->s[j] != 0;
        if (nonzero)
            to[chosen++] = j;
    }
    to[chosen] = n;
    return chosen;
}

static void copy_entries_of_columns(nonzero_columns *t, const size_t *from, const fmb_lp_row *row)
{
    size_t d = t->n + 1;
    for (size_t i = 0; i < t->m; i++) {
        int64_t *s = &t->entry[i * d];
        for (size_t k = 0; k < d; k++)
            s[k] = row[i].v->s[from[k]];
        t->v[i] = (fmb_vec){.s = s};
        fmb_vec_measure(&t->v[i], d);
        t->row[i] = (fmb_lp_row){&t->v[i], row[i].rel};
    }
}

static fmb_status hold_nonzero_columns(nonzero_columns *t, bool get)
{
    return FMB_ARRAYS_IN_BLOCK(t->mem, get, FMB_ARRAY(t->row, t->m), FMB_ARRAY(t->v, t->m),
                               FMB_ARRAY(t->entry, t->m * (t->n + 1)));
}

/* Rows over n columns, all of them small (num/vec.h). Errors: MEMORY, LIMIT. */
static fmb_status open_nonzero_columns(nonzero_columns *t, fmb_mem *mem, size_t n, size_t m,
                                       const fmb_lp_row *row)
{
    *t = (nonzero_columns){.mem = mem, .m = m};
    size_t *from;
    FMB_TRY(FMB_GET(mem, from, n + 1));
    t->n = choose_columns(n, m, row, from);
    fmb_status st = hold_nonzero_columns(t, true);
    if (st == FMB_OK)
        copy_entries_of_columns(t, from, row);
    fmb_mem_put(mem, from, n + 1, sizeof *from);
    return st;
}

typedef struct fmb_paused_sorting {
    fmb_run *run;
    nonzero_columns reduced; /* of small rows */
    fmb_leading_rows leading;
    fmb_scaled_rows rows;
    bool roomy; /* some point is strictly inside, wherever it is */
    size_t searches;
    size_t *open; /* [opens] rows that rays did not settle */
    size_t opens;
    bool *used;    /* [m] named in a proof that was accepted */
    fmb_team team; /* of several searches */
    fmb_sorting *out;
    fmb_active_set search[SEARCHES]; /* [searches] */
} sorting;

/* ---- at sight -------------------------------------------------------------------------------- */

/* The set, if it has one element; else the empty one. */
static uint64_t only_element(uint64_t set)
{
    return (set & (set - 1)) == 0 ? set : 0;
}

/* For each row, is there a column where no other one has its sign? */
static bool has_each_row_a_sign_alone(const nonzero_columns *t)
{
    uint64_t found = 0;
    for (size_t j = 0; j < t->n; j++) {
        uint64_t positive = 0, negative = 0, row = 1;
        for (size_t i = 0; i < t->m; i++, row <<= 1) {
            positive |= t->v[i].s[j] > 0 ? row : 0;
            negative |= t->v[i].s[j] < 0 ? row : 0;
        }
        found |= only_element(positive) | only_element(negative);
    }
    return found == UINT64_MAX >> (64 - t->m);
}

/* From a point inside, the way along a column ends at the one row that has this sign there: so each
 * such row is irredundant. True: all is told. */
static bool settle_at_sight(const nonzero_columns *t, fmb_sorting *out)
{
    if (!out->wants_tight || t->m == 0 || t->m > 64 || !has_each_row_a_sign_alone(t))
        return false;
    out->inner = fmb_tiny_find_tight(t->n, t->m, t->v, &out->tight) == FMB_FEASIBLE;
    for (size_t i = 0; out->inner && i < t->m; i++)
        out->kept[i] = true;
    return out->inner || out->tight != 0;
}

/* ---- a point inside -------------------------------------------------------------------------- */

static fmb_status ask_oracle_if_feasible(sorting *s)
{
    fmb_program program;
    fmb_oracle *oracle = NULL;
    fmb_status st = FMB_OK;
    fmb_program_init(&program, s->run->mem, (int)s->rows.n);
    for (size_t i = 0; st == FMB_OK && i < s->rows.m; i++)
        st = fmb_program_add_dense(&program, s->rows.row[i].v, s->rows.row[i].rel);
    FMB_THEN(st, fmb_oracle_new(s->run, &program, &oracle));
    FMB_THEN(st, fmb_oracle_feasible(oracle, &s->out->feasible));
    fmb_oracle_free(oracle);
    fmb_program_clear(&program);
    return st;
}

/* Write the leading bits of all rows; false if there are equalities, and so no point inside. */
static bool write_leading_rows(sorting *s)
{
    bool equal = false;
    mpz_t scratch;
    mpz_init(scratch);
    for (size_t i = 0; i < s->rows.m && !equal; i++) {
        fmb_leading_rows_add(&s->leading, s->rows.row[i].v, scratch);
        equal = s->rows.row[i].rel == FMB_EQ;
    }
    mpz_clear(scratch);
    return !equal;
}

/* Where no point is strictly inside, the search for one goes on to its end: so a glance comes
 * first, and then an elimination on the stack, which tells that of few rows. Unless a solution is
 * known, the oracle is the last, which so is not asked about most systems that have one. */
static fmb_status look_for_inner_point(sorting *s)
{
    bool possible = write_leading_rows(s), known = s->out->known, *inner = &s->out->inner;
    if (possible && (!known || s->out->wants_tight))
        FMB_TRY(fmb_leading_rows_find_inside(&s->leading, s->run, 0, inner));
    if (s->out->wants_tight && !*inner) {
        s->roomy =
            fmb_tiny_find_tight(s->rows.n, s->rows.m, s->reduced.v, &s->out->tight) == FMB_FEASIBLE;
        if (s->out->tight != 0)
            return FMB_OK;
    }
    if (!known && !*inner && !s->roomy)
        FMB_TRY(ask_oracle_if_feasible(s));
    if (possible && !*inner && s->out->feasible)
        FMB_TRY(fmb_leading_rows_find_inside(&s->leading, s->run, INFINITY, inner));
    return FMB_OK;
}

/* The same of long rows. Without a solution that is known the oracle would be asked, which looks at
 * such rows itself. */
static fmb_status look_inside_long_rows(sorting *s)
{
    return write_leading_rows(s)
               ? fmb_leading_rows_find_inside(&s->leading, s->run, INFINITY, &s->out->inner)
               : FMB_OK;
}

/* ---- by searches ----------------------------------------------------------------------------- */

static fmb_status shoot_for_search(void *self, size_t k, fmb_run *run)
{
    sorting *s = self;
    size_t shots = s->rows.m < MOST_SHOTS ? s->rows.m : MOST_SHOTS, of = s->searches;
    fmb_active_set *search = &s->search[k];
    const fmb_interior_point *inside = &s->leading.inside;
    FMB_TRY(fmb_active_set_init(search, run, &s->rows, s->out->inner ? inside : NULL));
    return s->out->inner ? fmb_active_set_shoot(search, shots * k / of, shots * (k + 1) / of)
                         : FMB_OK;
}

/* Of the slice that is left, the part of one search: at least one step. */
static uint64_t slice_of_search(const sorting *s)
{
    const fmb_run *run = s->run;
    if (run->slice_end == 0)
        return 0;
    return fmb_run_is_slice_over(run) ? 1 : (run->slice_end - run->work) / s->searches + 1;
}

static fmb_status test_for_search(void *self, size_t k, fmb_run *run)
{
    sorting *s = self;
    size_t of = s->searches;
    s->search[k].pauses = s->out->pauses;
    run->slice_end = run == s->run ? run->slice_end : slice_of_search(s);
    return fmb_active_set_test(&s->search[k], s->open, s->opens * k / of, s->opens * (k + 1) / of);
}

/* Every search learns what all rays hit; the rows left are open. */
static void share_what_was_hit(sorting *s)
{
    s->opens = 0;
    for (size_t i = 0; i < s->rows.m; i++) {
        bool kept = s->out->kept[i];
        for (size_t k = 0; k < s->searches; k++)
            kept |= s->search[k].kept[i];
        for (size_t k = 0; k < s->searches; k++)
            s->search[k].kept[i] = kept;
        s->out->kept[i] = kept;
        if (!kept && s->rows.row[i].rel != FMB_EQ)
            s->open[s->opens++] = i;
    }
}

/* Rows go that no search heard before needs. True if all do. */
static bool drop_rows_not_used(sorting *s, const fmb_active_set *search)
{
    size_t refused = 0;
    for (size_t at = 0; at < search->told; at += 2 + search->proved[at + 1]) {
        size_t row = search->proved[at];
        s->out->gone[row] = !s->used[row];
        refused += s->used[row];
    }
    s->out->doubtful += refused;
    return refused == 0;
}

static void note_rows_used(sorting *s, const fmb_active_set *search)
{
    for (size_t at = 0; at < search->told; at += 2 + search->proved[at + 1])
        for (size_t k = 0; s->out->gone[search->proved[at]] && k < search->proved[at + 1]; k++)
            s->used[search->proved[at + 2 + k]] = true;
}

/* A ray of a search that is not believed everything may have passed a row that stays. */
static void hear_search(sorting *s, const fmb_active_set *search)
{
    bool believed = drop_rows_not_used(s, search);
    note_rows_used(s, search);
    s->out->doubtful += search->doubtful;
    for (size_t i = 0; believed && i < s->rows.m; i++)
        s->out->kept[i] |= search->kept[i];
}

/* Rays make up for what searches find out by themselves: without them each would find out the same.
 */
static size_t count_searches(const sorting *s)
{
    return s->out->inner && s->rows.m * s->rows.d >= WORTH_SEARCHES ? SEARCHES : 1;
}

static fmb_status do_for_searches(sorting *s, fmb_team_job job)
{
    return s->searches > 1 ? fmb_team_do(&s->team, s->searches, job, s) : job(s, 0, s->run);
}

static fmb_status begin_searches(sorting *s)
{
    s->searches = count_searches(s);
    for (size_t k = 0; k < s->searches; k++)
        s->search[k].run = NULL;
    FMB_TRY(s->searches > 1 ? fmb_team_open(&s->team, s->run, s->searches) : FMB_OK);
    FMB_TRY(do_for_searches(s, shoot_for_search));
    share_what_was_hit(s);
    return FMB_OK;
}

/* Doubles do not see how long rows differ: what is undecided is in doubt. */
static void count_doubtful_long_rows(sorting *s)
{
    s->out->doubtful = 0;
    for (size_t i = 0; i < s->rows.m; i++)
        s->out->doubtful += !s->out->gone[i] && !s->out->kept[i] && s->rows.row[i].rel != FMB_EQ;
}

/* Until all rows are tested or some search pauses. */
static fmb_status go_on_with_searches(sorting *s, bool *paused)
{
    fmb_status st = do_for_searches(s, test_for_search);
    for (size_t k = 0; k < s->searches; k++)
        *paused |= s->search[k].paused;
    for (size_t k = 0; st == FMB_OK && !*paused && k < s->searches; k++)
        hear_search(s, &s->search[k]);
    if (!s->rows.small && !*paused)
        count_doubtful_long_rows(s);
    return st;
}

/* ---- frame ----------------------------------------------------------------------------------- */

static void close_sorting(sorting *s)
{
    fmb_mem *mem = s->run->mem;
    for (size_t k = 0; k < s->searches; k++)
        fmb_active_set_clear(&s->search[k]);
    if (s->team.run)
        fmb_team_close(&s->team);
    if (s->leading.mem)
        fmb_leading_rows_close(&s->leading);
    fmb_mem_put(mem, s->open, s->rows.m, sizeof *s->open);
    fmb_mem_put(mem, s->used, s->rows.m, sizeof *s->used);
    fmb_scaled_rows_clear(&s->rows, mem);
    if (s->reduced.mem)
        (void)hold_nonzero_columns(&s->reduced, false);
    fmb_mem_put(mem, s, 1, sizeof *s);
}

static fmb_status open_leading_rows(sorting *s, size_t n, size_t m, const fmb_lp_row *row)
{
    FMB_TRY(fmb_leading_rows_open(&s->leading, s->run->mem, n, m));
    fmb_leading_rows_list_columns(&s->leading, n, m, row);
    return fmb_leading_rows_choose_units(&s->leading, m, row);
}

static fmb_status scale_rows(sorting *s, size_t n, size_t m, const fmb_lp_row *row, bool small)
{
    fmb_mem *mem = s->run->mem;
    fmb_status st = fmb_scaled_rows_init(&s->rows, mem, n, m, row, small, &s->leading);
    s->open = fmb_mem_get(mem, m, sizeof *s->open);
    s->used = fmb_mem_zero(mem, m, sizeof *s->used);
    return st != FMB_OK || (s->open && s->used) ? st : fmb_mem_status(mem);
}

/* Differences of products have to fit: see rounded_proof.c. */
#define MOST_SORTED_COLUMNS 200

/* Whether there is a solution, and a point inside; *open: rows are open. */
static fmb_status prepare_small_rows(sorting *s, size_t n, size_t m, const fmb_lp_row *row,
                                     bool *open)
{
    fmb_sorting *out = s->out;
    const nonzero_columns *t = &s->reduced;
    FMB_TRY(open_nonzero_columns(&s->reduced, s->run->mem, n, m, row));
    bool told = settle_at_sight(t, out), narrow = !told && t->n <= MOST_SORTED_COLUMNS;
    out->doubtful = narrow || told ? 0 : m;
    if (!narrow)
        return FMB_OK;
    FMB_TRY(open_leading_rows(s, t->n, m, t->row));
    FMB_TRY(scale_rows(s, t->n, m, t->row, true));
    FMB_TRY(look_for_inner_point(s));
    *open = out->feasible && out->tight == 0;
    return FMB_OK;
}

static fmb_status prepare_long_rows(sorting *s, size_t n, size_t m, const fmb_lp_row *row,
                                    bool *open)
{
    FMB_TRY(open_leading_rows(s, n, m, row));
    if (s->leading.n > MOST_SORTED_COLUMNS)
        return FMB_OK;
    FMB_TRY(scale_rows(s, n, m, row, false));
    FMB_TRY(look_inside_long_rows(s));
    *open = s->out->known || s->out->inner;
    s->out->doubtful = *open ? 0 : m;
    return FMB_OK;
}

/* Whether there is a solution, rays, and searches that are ready; NULL: all is said. */
static fmb_status open_sorting(fmb_run *run, int n, size_t m, const fmb_lp_row *row,
                               fmb_sorting *out, sorting **opened)
{
    sorting *s;
    bool open = false;
    FMB_TRY(FMB_GET(run->mem, s, 1));
    memset(s, 0, offsetof(sorting, search));
    s->run = run;
    s->out = out;
    fmb_status st = fmb_lp_rows_are_small(m, row) ? prepare_small_rows(s, (size_t)n, m, row, &open)
                                                  : prepare_long_rows(s, (size_t)n, m, row, &open);
    if (open && st == FMB_OK)
        st = begin_searches(s);
    if (open && st == FMB_OK)
        *opened = s;
    else
        close_sorting(s);
    return st;
}

fmb_status fmb_lp_sort_rows(fmb_run *run, int n, size_t m, const fmb_lp_row *row, fmb_sorting *out)
{
    bool paused = false;
    sorting *s = out->paused;
    fmb_status st = FMB_OK;
    if (!s) {
        out->inner = false;
        out->tight = 0;
        out->feasible = true;
        out->doubtful = m;
        if (!fmb_way(FMB_WAY_ACTIVE_SET))
            return FMB_OK;
        fmb_run_count(run, m * (100 + 8 * (size_t)n));
        st = open_sorting(run, n, m, row, out, &s);
    }
    if (s) {
        s->out = out;
        st = go_on_with_searches(s, &paused);
        out->inner |= s->roomy;
        out->paused = st == FMB_OK && paused ? s : NULL;
        if (!out->paused)
            close_sorting(s);
    }
    if (!paused)
        fmb_way_answered(FMB_WAY_ACTIVE_SET, 4 * out->doubtful < m);
    return st;
}

void fmb_lp_sorting_clear(fmb_sorting *s)
{
    if (s->paused)
        close_sorting(s->paused);
    s->paused = NULL;
}
