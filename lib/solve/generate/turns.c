/* turns.c: facets of hulls by several methods in turns; see some_rays.h.
 *
 * Facets are the rays of the dual cone, whose rows are vertices and rays of the hull. Double
 * description (dd/cone.h) may have very many intermediate rays in one of its two insertion orders:
 * lexicographic, or rows of few coefficients first. Where facets are far fewer than rows, support
 * queries of a section of the cone find them one by one (hull/section/section.h). No method is best
 * on all inputs, so they take turns of growing length. Queries end once facets prove to be many.
 */
#include "solve/generate/some_rays.h"

#include "hull/section/section.h"

/* With fewer generators per coordinate, facets mostly outnumber them, or are soon found. */
#define MANY_RAYS 16
/* With fewer coordinates, inserting generators one by one is as quick (measured: with one more, a
 * section takes 0.2 to 1.3 times as long). */
#define SECTION_COORDINATES 7
/* Rays of the first turn: a constant, and so many per row; each turn is LONGER times the last. */
#define RAYS_OF_FIRST_TURN 4096
#define RAYS_OF_ROW        4
#define LONGER             8
/* Pairs of facets that a section may test for each ray of a turn. */
#define PAIRS_OF_RAY 512
/* Facets are few if there are at most two per coordinate, and one per so many rows. */
#define ROWS_OF_FACET 8

typedef struct turns {
    fmb_image *m;
    fmb_dual rows, sparse_rows; /* begun if they have an image */
    fmb_section section;        /* begun if it has a run */
    bool is_sparse, are_facets_many;
} turns;

/* Is a quarter of all coefficients 0? */
static bool are_coefficients_few(const fmb_image *m)
{
    size_t zeros = 0;
    for (size_t i = 0; i < m->rays; i++)
        for (size_t k = 0; k < m->n; k++)
            zeros += fmb_vec_sgn(&m->ray[i], k) == 0;
    return 4 * zeros >= m->rays * m->n;
}

static void tell_facet_attempt(const fmb_image *m, fmb_attempt a, fmb_status st, bool done)
{
    a.task = "facets";
    a.part = -1;
    a.columns = m->n;
    a.rows = m->rays;
    fmb_run_tell_attempt(m->run, a, st, done);
}

static fmb_status find_facets_by_rows(turns *t, fmb_dual *d, uint64_t rays, bool *done)
{
    bool sparse = d == &t->sparse_rows;
    fmb_attempt a = {.engine = sparse ? "sparse double description" : "double description",
                     .budget = rays,
                     .unit = "rays"};
    fmb_status st = d->of ? FMB_OK : fmb_dual_open(d, t->m, sparse);
    FMB_THEN(st, fmb_dual_find_facets(d, rays, false, done));
    tell_facet_attempt(t->m, a, st, *done);
    return st;
}

static fmb_status find_all_facets(fmb_image *m)
{
    fmb_status st = fmb_image_find_facets(m, false);
    tell_facet_attempt(m, (fmb_attempt){.engine = "double description"}, st, true);
    return st;
}

static fmb_status find_facets_by_section(turns *t, uint64_t pairs, bool *done)
{
    fmb_section *c = &t->section;
    fmb_image *m = t->m, dual = {0};
    size_t few = 2 * m->n + m->rays / ROWS_OF_FACET;
    fmb_status st = c->run ? FMB_OK : fmb_section_open(c, m->run, m->ray, m->rays, m->n);
    FMB_THEN(st, fmb_section_ask(c, few, pairs, done));
    t->are_facets_many = !*done && fmb_section_found(c) > few;
    if (st == FMB_OK && *done)
        st = fmb_section_take_rays(c, &dual);
    if (st == FMB_OK && *done)
        st = fmb_image_take_facets(m, &dual);
    fmb_image_clear(&dual);
    tell_facet_attempt(m, (fmb_attempt){.engine = "section", .budget = pairs, .unit = "pairs"}, st,
                       *done);
    return st;
}

static uint64_t rays_of_first_turn(const turns *t)
{
    return RAYS_OF_FIRST_TURN + RAYS_OF_ROW * t->m->rays;
}

static fmb_status take_turns_at_facets(turns *t)
{
    bool done = false;
    fmb_status st = FMB_OK;
    for (uint64_t rays = rays_of_first_turn(t); st == FMB_OK && !done; rays *= LONGER) {
        st = find_facets_by_rows(t, &t->rows, rays, &done);
        if (st == FMB_OK && !done && t->is_sparse)
            st = find_facets_by_rows(t, &t->sparse_rows, rays, &done);
        if (st == FMB_OK && !done && !t->are_facets_many)
            st = find_facets_by_section(t, PAIRS_OF_RAY * rays, &done);
    }
    return st;
}

/* One turn for the section, before generators come one by one. */
static fmb_status try_section_first(turns *t)
{
    bool done = false;
    fmb_status st = find_facets_by_section(t, PAIRS_OF_RAY * rays_of_first_turn(t), &done);
    fmb_section_close(&t->section);
    return st == FMB_OK && !done ? find_all_facets(t->m) : st;
}

fmb_status fmb_hull_find_facets(fmb_image *m)
{
    bool by_one = fmb_image_has_few_coordinates(m);
    if (m->lines > 0 || m->rays < MANY_RAYS * m->n || (by_one && m->n < SECTION_COORDINATES))
        return find_all_facets(m);
    turns t = {.m = m, .is_sparse = are_coefficients_few(m)};
    fmb_status st = by_one ? try_section_first(&t) : take_turns_at_facets(&t);
    fmb_section_close(&t.section);
    fmb_dual_close(&t.sparse_rows);
    fmb_dual_close(&t.rows);
    return st;
}
