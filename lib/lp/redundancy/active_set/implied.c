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

#include "base/ways.h"
#include "lp/oracle/oracle.h"
#include "lp/redundancy/active_set/active_set.h"
#include "lp/redundancy/active_set/nonzero_columns.h"
#include "trace/team.h"

/* Rows shot at before the search: each shot looks at all rows. */
#define MOST_SHOTS 1024
/* Searches of one question, and numbers in its rows that are worth them: about a millisecond. */
enum { SEARCHES = 4, WORTH_SEARCHES = 4048 };

typedef struct sorting {
    fmb_run *run;
    fmb_scaled_rows rows;
    fmb_interior_point inside;
    fmb_active_set search[SEARCHES];
    size_t searches;
    size_t *open; /* [opens] rows that rays did not settle */
    size_t opens;
    bool *used; /* [m] named in a proof that was accepted */
    fmb_sorting *out;
} sorting;

/* ---- a point inside -------------------------------------------------------------------------- */

static fmb_status ask_oracle_if_feasible(sorting *s)
{
    fmb_program program;
    fmb_oracle *oracle = NULL;
    fmb_status st = FMB_OK;
    fmb_program_init(&program, s->run->mem, (int)s->rows.n);
    for (size_t i = 0; st == FMB_OK && i < s->rows.m; i++)
        st = fmb_program_add_dense(&program, s->rows.row[i].v, s->rows.row[i].rel);
    if (st == FMB_OK)
        st = fmb_oracle_new(s->run, &program, &oracle);
    if (st == FMB_OK)
        st = fmb_oracle_feasible(oracle, &s->out->feasible);
    fmb_oracle_free(oracle);
    fmb_program_clear(&program);
    return st;
}

/* Where there is no solution, the search goes on to its end: so unless one is known, a glance comes
 * first, and then the oracle, which is not asked about most systems that have one. */
static fmb_status look_for_inner_point(sorting *s)
{
    bool possible, known = s->out->known, *inner = &s->out->inner;
    fmb_status st =
        fmb_interior_point_open(&s->inside, s->run, s->rows.n, s->rows.m, s->rows.row, &possible);
    if (st == FMB_OK && possible && !known)
        st = fmb_interior_point_find_quickly(&s->inside, inner);
    if (st == FMB_OK && !known && !*inner)
        st = ask_oracle_if_feasible(s);
    if (st == FMB_OK && possible && !*inner && s->out->feasible)
        st = fmb_interior_point_find(&s->inside, inner);
    return st;
}

/* ---- by searches ----------------------------------------------------------------------------- */

static fmb_status shoot_for_search(void *self, size_t k, fmb_run *run)
{
    sorting *s = self;
    size_t shots = s->rows.m < MOST_SHOTS ? s->rows.m : MOST_SHOTS, of = s->searches;
    fmb_active_set *search = &s->search[k];
    fmb_status st = fmb_active_set_init(search, run, &s->rows, s->out->inner ? &s->inside : NULL);
    return st == FMB_OK && s->out->inner
               ? fmb_active_set_shoot(search, shots * k / of, shots * (k + 1) / of)
               : st;
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

static fmb_status search_alone(sorting *s)
{
    fmb_status st = shoot_for_search(s, 0, s->run);
    if (st == FMB_OK)
        share_what_was_hit(s);
    return st == FMB_OK ? test_for_search(s, 0, s->run) : st;
}

static fmb_status search_together(sorting *s, fmb_team *team)
{
    fmb_status st = fmb_team_open(team, s->run, s->searches);
    if (st == FMB_OK)
        st = fmb_team_do(team, s->searches, shoot_for_search, s);
    if (st == FMB_OK)
        share_what_was_hit(s);
    return st == FMB_OK ? fmb_team_do(team, s->searches, test_for_search, s) : st;
}

/* Rays make up for what searches find out by themselves: without them each would find out the same.
 */
static size_t count_searches(const sorting *s)
{
    return s->out->inner && s->rows.m * s->rows.d >= WORTH_SEARCHES ? SEARCHES : 1;
}

static fmb_status search_all_rows(sorting *s)
{
    fmb_team team;
    s->searches = count_searches(s);
    bool together = s->searches > 1;
    fmb_status st = together ? search_together(s, &team) : search_alone(s);
    for (size_t k = 0; k < s->searches; k++) {
        if (st == FMB_OK)
            hear_search(s, &s->search[k]);
        s->out->paused |= s->search[k].paused;
        fmb_active_set_clear(&s->search[k]);
    }
    if (together)
        fmb_team_close(&team);
    return st;
}

/* ---- frame ----------------------------------------------------------------------------------- */

static fmb_status sort_scaled_rows(sorting *s)
{
    size_t m = s->rows.m;
    fmb_mem *mem = s->run->mem;
    s->open = fmb_mem_get(mem, m, sizeof *s->open);
    s->used = fmb_mem_zero(mem, m, sizeof *s->used);
    fmb_status st = s->open && s->used ? FMB_OK : fmb_mem_status(mem);
    if (st == FMB_OK)
        st = look_for_inner_point(s);
    if (st == FMB_OK && s->out->feasible)
        st = search_all_rows(s);
    if (s->inside.run)
        fmb_interior_point_clear(&s->inside);
    fmb_mem_put(mem, s->open, m, sizeof *s->open);
    fmb_mem_put(mem, s->used, m, sizeof *s->used);
    return st;
}

static fmb_status sort_reduced_rows(fmb_run *run, const fmb_nonzero_columns *reduced,
                                    fmb_sorting *out)
{
    sorting s = {.run = run, .out = out};
    fmb_status st = fmb_scaled_rows_init(&s.rows, run->mem, reduced->n, reduced->m, reduced->row);
    if (st == FMB_OK)
        st = sort_scaled_rows(&s);
    fmb_scaled_rows_clear(&s.rows, run->mem);
    return st;
}

static bool are_rows_small(size_t m, const fmb_lp_row *row)
{
    for (size_t i = 0; i < m; i++)
        if (row[i].v->z)
            return false;
    return true;
}

/* Differences of products have to fit: see rounded_proof.c. */
#define MOST_COLUMNS 200

fmb_status fmb_lp_sort_rows(fmb_run *run, int n, size_t m, const fmb_lp_row *row, fmb_sorting *out)
{
    fmb_nonzero_columns reduced;
    out->doubtful = 0;
    out->inner = out->paused = false;
    out->feasible = true;
    if (!are_rows_small(m, row) || !fmb_way(FMB_WAY_ACTIVE_SET)) {
        out->doubtful = m;
        return FMB_OK;
    }
    fmb_status st = fmb_nonzero_columns_open(&reduced, run->mem, (size_t)n, m, row);
    if (st == FMB_OK && reduced.n <= MOST_COLUMNS)
        st = sort_reduced_rows(run, &reduced, out);
    else if (st == FMB_OK)
        out->doubtful = m;
    fmb_nonzero_columns_clear(&reduced);
    fmb_way_answered(FMB_WAY_ACTIVE_SET, 4 * out->doubtful < m);
    return st;
}
