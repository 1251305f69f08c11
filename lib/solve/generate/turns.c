/* turns.c: facets of hulls by ways in turns; see turns.h.
 *
 * Facets are the rays of the dual cone, whose rows are vertices and rays of the hull. Row by row
 * (dd/cone.h) there may be very many rays in between, in one order or in another: lexicographic, or
 * rows of few coefficients first. Where rows are many and facets few, support queries of a section
 * of the cone find them one by one (hull/section.h). None is best on all; so each gets its turn,
 * and then a longer one. What is begun anew costs a part in LONGER.
 */
#include "solve/generate/turns.h"

#include "hull/section.h"

/* With fewer generators for each coordinate, facets mostly are more than those. */
#define MANY_ROWS 4
/* Rays of the first turn, and so many for each row; each turn is LONGER times the one before. */
#define FIRST_RAYS  4096
#define RAYS_OF_ROW 4
#define LONGER      8
/* Pairs of facets that a section may look at for each of these. */
#define PAIRS_OF_RAY 512

typedef struct turns {
    fmb_image *m;
    fmb_section section;
    bool begun; /* the section */
} turns;

static size_t count_coefficients(const fmb_vec *v, size_t n)
{
    size_t count = 0;
    for (size_t k = 0; k < n; k++)
        count += fmb_vec_sgn(v, k) != 0;
    return count;
}

/* Do some have fewer coefficients than others? */
static bool are_some_rays_sparse(const fmb_image *m)
{
    for (size_t i = 1; i < m->rays; i++)
        if (count_coefficients(&m->ray[i], m->n) != count_coefficients(&m->ray[0], m->n))
            return true;
    return false;
}

static fmb_status find_facets_by_section(turns *t, uint64_t pairs, bool *done)
{
    fmb_image *m = t->m, dual = {0};
    fmb_status st =
        t->begun ? FMB_OK : fmb_section_open(&t->section, m->run, m->ray, m->rays, m->n);
    t->begun = true;
    if (st == FMB_OK)
        st = fmb_section_ask(&t->section, pairs, done);
    if (st == FMB_OK && *done)
        st = fmb_section_take_rays(&t->section, &dual);
    if (st == FMB_OK && *done)
        st = fmb_image_take_facets(m, &dual);
    fmb_image_clear(&dual);
    return st;
}

static fmb_status take_turns_at_facets(turns *t)
{
    bool done = false, sparse = are_some_rays_sparse(t->m);
    fmb_status st = FMB_OK;
    uint64_t rays = FIRST_RAYS + RAYS_OF_ROW * t->m->rays;
    for (; st == FMB_OK && !done; rays *= LONGER) {
        st = fmb_image_try_facets(t->m, false, rays, &done);
        if (st == FMB_OK && !done && sparse)
            st = fmb_image_try_facets(t->m, true, rays, &done);
        if (st == FMB_OK && !done)
            st = find_facets_by_section(t, PAIRS_OF_RAY * rays, &done);
    }
    return st;
}

fmb_status fmb_hull_find_facets(fmb_image *m)
{
    turns t = {.m = m};
    bool few = m->lines > 0 || m->rays < MANY_ROWS * m->n;
    if (few || fmb_image_has_few_coordinates(m))
        return fmb_image_find_facets(m, false);
    fmb_status st = take_turns_at_facets(&t);
    fmb_section_close(&t.section);
    return st;
}
