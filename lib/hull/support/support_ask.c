/* support_ask.c: creation, and one query after another; see support.h. */
#include "base/ways.h"
#include "hull/support/support_private.h"

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_support_init(fmb_support *s, fmb_run *run, fmb_oracle *oracle, size_t n,
                            const int *kept, size_t k, bool strict, bool proves)
{
    *s = (fmb_support){.run = run,
                       .oracle = oracle,
                       .n = n,
                       .k = k,
                       .kept = kept,
                       .strict = strict,
                       .proves = proves};
    mpz_inits(s->t, s->seen.den, NULL);
    FMB_TRY(fmb_integers_init(&s->seen.x, n, run->mem));
    FMB_TRY(fmb_integers_init(&s->g, k + 1, run->mem));
    return fmb_facets_init(&s->hull, run, k + 1);
}

void fmb_support_clear(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    fmb_mem_put(mem, s->near.slot, s->near.capacity, sizeof *s->near.slot);
    fmb_integers_clear(&s->seen.x, mem);
    mpz_clears(s->t, s->seen.den, NULL);
    fmb_support_forget_symmetry(s);
    fmb_support_forget_rows(s);
    fmb_support_forget_outer_rows(s);
    for (size_t i = 0; i < s->rows; i++)
        fmb_support_drop(&s->row[i], mem);
    fmb_mem_put(mem, s->row, s->row_capacity, sizeof *s->row);
    for (size_t i = 0; i < s->points; i++)
        fmb_integers_clear(&s->point[i], mem);
    fmb_mem_put(mem, s->point, s->point_capacity, sizeof *s->point);
    fmb_facets_clear(&s->hull);
    fmb_integers_clear(&s->g, mem);
}

/* ---- points and equations -------------------------------------------------------------------- */

/* Find some vertex of the program. */
static fmb_status find_first_point(fmb_support *s)
{
    const fmb_weights nowhere = {0};
    fmb_oracle_end end;
    fmb_status st = fmb_oracle_approach(s->oracle, &nowhere, &end);
    s->begun = true;
    if (st == FMB_OK)
        fmb_oracle_point_integers(s->oracle, s->seen.x.z, s->seen.den);
    return st == FMB_OK ? fmb_support_take(s, 0) : st;
}

/* Does the projection extend beyond an equation of all generators, on either side? */
static fmb_status ask_about_equation(fmb_support *s)
{
    fmb_support_row row = {.rel = FMB_EQ};
    bool stands;
    const fmb_vec *e = &s->hull.equation[s->equations];
    fmb_status st = fmb_support_query(s, e, 1, &row, &stands);
    if (st == FMB_OK && stands)
        st = fmb_support_query(s, e, -1, &row, &stands);
    if (st == FMB_OK && stands) {
        s->equations++;
        return fmb_support_keep(s, &row);
    }
    fmb_support_drop(&row, s->run->mem);
    return st;
}

/* ---- facets ---------------------------------------------------------------------------------- */

/* Add the point found beyond a facet, which is removed, and maximize in that direction. */
static fmb_status take_and_look_along(fmb_support *s, size_t at)
{
    fmb_mem *mem = s->run->mem;
    if (!fmb_support_is_hull_coarse(s))
        return fmb_support_take(s, at);
    fmb_vec h = {.s = fmb_mem_zero(mem, s->k + 1, sizeof *h.s)};
    fmb_status st =
        h.s ? fmb_vec_copy(&h, &s->hull.facet[at].normal, s->k + 1, mem) : fmb_mem_status(mem);
    FMB_THEN(st, fmb_support_take(s, at));
    FMB_THEN(st, fmb_support_look_along(s, &h));
    fmb_vec_clear(&h, s->k + 1, mem);
    fmb_mem_put(mem, h.s, s->k + 1, sizeof *h.s);
    return st;
}

/* Make a query for an open facet. */
static fmb_status ask_about_facet(fmb_support *s, size_t at)
{
    fmb_support_row row = {0};
    fmb_support_answer answer;
    bool known = false;
    fmb_status st = fmb_facets_need_normal(&s->hull, at);
    FMB_THEN(st, fmb_support_recall(s, at, &known));
    if (st != FMB_OK || known)
        return st;
    const fmb_facet *a = &s->hull.facet[at];
    st = fmb_support_settle(s, a, &row, &answer);
    if (st == FMB_OK && answer == FMB_SUPPORT_ROW) {
        st = fmb_support_keep_facet(s, at, &row);
        return st == FMB_OK ? fmb_support_note_images(s, &a->normal) : st;
    }
    fmb_support_drop(&row, s->run->mem);
    if (st == FMB_OK && answer == FMB_SUPPORT_BEYOND)
        return take_and_look_along(s, at);
    if (st == FMB_OK)
        fmb_support_note_facet(s, at, FMB_LE);
    return st;
}

static fmb_status ask_about_next_facet(fmb_support *s, bool *done)
{
    size_t at = fmb_support_find_open_facet(s, &s->near);
    *done = at == SIZE_MAX;
    return *done ? FMB_OK : ask_about_facet(s, at);
}

static fmb_status ask_next_question(fmb_support *s, bool *done)
{
    const fmb_facets *f = &s->hull;
    FMB_TRY(fmb_run_poll_now(s->run));
    if (s->outer_most > 0 && s->ends_asked < 2 * s->k)
        return fmb_support_ask_about_end(s);
    if (s->equations < f->d - f->rank)
        return ask_about_equation(s);
    FMB_TRY(ask_about_next_facet(s, done));
    return *done && s->strict ? fmb_support_find_missing_faces(s) : FMB_OK;
}

fmb_status fmb_support_ask(fmb_support *s, uint64_t pairs, bool *done)
{
    fmb_status st = s->begun ? FMB_OK : find_first_point(s);
    uint64_t first = s->hull.pairs;
    *done = false;
    while (st == FMB_OK && !*done && !fmb_run_is_slice_over(s->run) &&
           (pairs == 0 || s->hull.pairs - first < pairs) &&
           (s->most == 0 || s->hull.generators <= s->most))
        st = ask_next_question(s, done);
    s->ended = st != FMB_OK;
    return st;
}
