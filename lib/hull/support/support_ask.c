/* support_ask.c: life, and which facet is asked about next; see support.h. */
#include "base/ways.h"
#include "hull/support/support_private.h"

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_support_init(fmb_support *s, fmb_run *run, fmb_oracle *oracle, size_t n,
                            const int *kept, size_t k, bool strict, bool proves)
{
    *s =
        (fmb_support){.run = run, .n = n, .k = k, .kept = kept, .strict = strict, .proves = proves};
    fmb_status st = fmb_support_worker_init(&s->worker, run, oracle, n);
    if (st == FMB_OK)
        st = fmb_integers_init(&s->g, k + 1, run->mem);
    return st == FMB_OK ? fmb_facets_init(&s->hull, run, k + 1) : st;
}

void fmb_support_clear(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    fmb_support_dismiss(s);
    fmb_support_close_tight(s);
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
    fmb_support_worker_clear(&s->worker);
}

/* ---- the next question ----------------------------------------------------------------------- */

/* Some vertex of the program. */
static fmb_status find_first_point(fmb_support *s)
{
    const fmb_weights nowhere = {0};
    fmb_oracle_end end;
    fmb_status st = fmb_oracle_approach(s->worker.oracle, &nowhere, &end);
    s->begun = true;
    if (st == FMB_OK)
        fmb_oracle_point_integers(s->worker.oracle, s->worker.x.z, s->worker.den);
    return st == FMB_OK ? fmb_support_take(s, &s->worker, 0) : st;
}

/* An equation that all generators satisfy: on either side, does the projection go further? */
static fmb_status ask_about_equation(fmb_support *s)
{
    fmb_support_row row = {.rel = FMB_EQ};
    bool stands;
    const fmb_vec *e = &s->hull.equation[s->equations];
    fmb_status st = fmb_support_query(s, e, 0, 1, &row, &stands);
    if (st == FMB_OK && stands)
        st = fmb_support_query(s, e, 0, -1, &row, &stands);
    if (st == FMB_OK && stands) {
        s->equations++;
        return fmb_support_keep(s, &row);
    }
    fmb_support_drop(&row, s->run->mem);
    return st;
}

/* Is it x0 >= 0, the face at infinity? */
static bool is_at_infinity(const fmb_support *s, const fmb_vec *normal)
{
    for (size_t j = 1; j <= s->k; j++)
        if (fmb_vec_sgn(normal, j) != 0)
            return false;
    return true;
}

static bool is_open(const fmb_facet *a)
{
    return a->alive && a->note == FMB_FACET_OPEN;
}

/* How far back is slot i, going round from the one asked about last? */
static size_t slots_back(const fmb_support *s, size_t i)
{
    size_t slots = s->hull.slots;
    return (s->at % slots + slots - 1 - i) % slots;
}

/* The first open one going back, of those on the generator that was found last, which it made or
 * touched; SIZE_MAX: none. There the oracle stands, so that its way to the optimum is short. */
static size_t find_open_facet_nearby(const fmb_support *s)
{
    const fmb_facets *f = &s->hull;
    size_t best = SIZE_MAX;
    for (size_t k = 0; k < f->mades + f->toucheds; k++) {
        size_t i = k < f->mades ? f->made[k] : f->touched[k - f->mades];
        if (is_open(&f->facet[i]) && fmb_facet_holds(&f->facet[i], f->generators - 1) &&
            (best == SIZE_MAX || slots_back(s, i) < slots_back(s, best)))
            best = i;
    }
    return best;
}

static size_t find_open_facet_anywhere(const fmb_support *s)
{
    const fmb_facets *f = &s->hull;
    size_t i = f->slots > 0 ? s->at % f->slots : 0;
    for (size_t k = 0; k < f->slots; k++) {
        i = (i > 0 ? i : f->slots) - 1;
        if (is_open(&f->facet[i]))
            return i;
    }
    return SIZE_MAX;
}

/* Are rows wanted that are no facets? Then those asked about are from all around, so that these
 * are, too. */
static bool is_hull_coarse(const fmb_support *s)
{
    return s->outers < s->outer_most && s->rows + s->hull.generators >= s->outer_after;
}

/* A facet that nothing is known of, its normal known; SIZE_MAX if there is none. It is one near the
 * last generator, or else the youngest, roughly. */
static fmb_status find_open_facet(fmb_support *s, size_t *at)
{
    fmb_facets *f = &s->hull;
    for (;;) {
        *at = is_hull_coarse(s) ? SIZE_MAX : find_open_facet_nearby(s);
        if (*at == SIZE_MAX)
            *at = find_open_facet_anywhere(s);
        if (*at == SIZE_MAX)
            return FMB_OK;
        s->at = *at;
        fmb_status st = fmb_facets_need_normal(f, s->at);
        if (st != FMB_OK || !is_at_infinity(s, &f->facet[s->at].normal))
            return st;
        f->facet[s->at].note = FMB_FACET_STANDS;
    }
}

/* As fmb_support_query about a facet, whose slot may go with it; and if it does not stand, how far
 * does the projection go there? */
static fmb_status ask_and_look_along(fmb_support *s, size_t at, fmb_support_row *row, bool *stands)
{
    fmb_mem *mem = s->run->mem;
    const fmb_vec *normal = &s->hull.facet[at].normal;
    if (!is_hull_coarse(s))
        return fmb_support_query(s, normal, at, 1, row, stands);
    fmb_vec h = {.s = fmb_mem_zero(mem, s->k + 1, sizeof *h.s)};
    fmb_status st = h.s ? fmb_vec_copy(&h, normal, s->k + 1, mem) : fmb_mem_status(mem);
    if (st == FMB_OK)
        st = fmb_support_query(s, &h, at, 1, row, stands);
    if (st == FMB_OK && !*stands)
        st = fmb_support_look_along(s, &h);
    fmb_vec_clear(&h, s->k + 1, mem);
    fmb_mem_put(mem, h.s, s->k + 1, sizeof *h.s);
    return st;
}

static fmb_status ask_about_facet(fmb_support *s, size_t at)
{
    fmb_support_row row = {0};
    bool stands = false;
    const fmb_vec *normal = &s->hull.facet[at].normal;
    if (s->known && fmb_way(FMB_WAY_KNOWN) && fmb_support_is_known(s, normal)) {
        fmb_way_answered(FMB_WAY_KNOWN, true);
        fmb_support_note_facet(s, at, FMB_LE);
        return FMB_OK;
    }
    fmb_status st = FMB_OK;
    if (fmb_way(FMB_WAY_TIGHT))
        st = fmb_support_try_tight_rows(s, at, &row, &stands);
    fmb_way_answered(FMB_WAY_TIGHT, stands);
    if (st == FMB_OK && !stands)
        st = ask_and_look_along(s, at, &row, &stands);
    if (st == FMB_OK && stands) {
        st = fmb_support_stand(s, at, &row);
        return st == FMB_OK ? fmb_support_note_images(s, normal) : st;
    }
    fmb_support_drop(&row, s->run->mem);
    return st;
}

static bool has_asked_a_while(const fmb_support *s)
{
    return s->rows + s->hull.generators >= FMB_QUERIES_ALONE;
}

/* That one and others. */
static fmb_status ask_about_facets_at_once(fmb_support *s, size_t first)
{
    size_t facet[FMB_SUPPORT_WORKERS], n = 0, at = first;
    fmb_status st = FMB_OK;
    while (st == FMB_OK && n < FMB_SUPPORT_WORKERS && (n == 0 || at != first)) {
        facet[n++] = at;
        st = find_open_facet(s, &at);
    }
    return st == FMB_OK ? fmb_support_ask_workers(s, n, facet) : st;
}

static fmb_status ask_about_open_facets(fmb_support *s, size_t first)
{
    bool known;
    fmb_status st = fmb_support_recall(s, first, &known);
    if (st != FMB_OK || known)
        return st;
    return s->workers && has_asked_a_while(s) ? ask_about_facets_at_once(s, first)
                                              : ask_about_facet(s, first);
}

static fmb_status ask_next_question(fmb_support *s, bool *done)
{
    const fmb_facets *f = &s->hull;
    size_t at;
    fmb_status st = fmb_run_poll_now(s->run);
    if (st == FMB_OK && s->program && !s->symmetry && (s->k > 2 || s->given) &&
        has_asked_a_while(s) && fmb_way(FMB_WAY_SYMMETRY))
        st = fmb_support_find_symmetry(s);
    if (st != FMB_OK)
        return st;
    if (s->outer_most > 0 && s->ends_asked < 2 * s->k)
        return fmb_support_ask_about_end(s);
    if (s->equations < f->d - f->rank)
        return ask_about_equation(s);
    st = find_open_facet(s, &at);
    if (st != FMB_OK)
        return st;
    if (at != SIZE_MAX)
        return ask_about_open_facets(s, at);
    *done = true;
    return s->strict ? fmb_support_find_missing_faces(s) : FMB_OK;
}

fmb_status fmb_support_ask(fmb_support *s, uint64_t pairs, bool *done)
{
    fmb_status st = s->begun ? FMB_OK : find_first_point(s);
    uint64_t first = s->hull.pairs;
    *done = false;
    while (st == FMB_OK && !*done && (pairs == 0 || s->hull.pairs - first < pairs) &&
           (s->most == 0 || s->hull.generators <= s->most))
        st = ask_next_question(s, done);
    s->ended = st != FMB_OK;
    return st;
}
