/* support_next.c: which facet is queried next; see support.h. */
#include "hull/support/support_private.h"

static bool is_open(const fmb_facet *a)
{
    return a->alive && a->note == FMB_FACET_OPEN;
}

/* The distance of slot i going backwards cyclically from the last facet queried. */
static size_t slots_back(const fmb_support *s, size_t i)
{
    size_t slots = s->hull.slots;
    return (s->at % slots + slots - 1 - i) % slots;
}

/* The first open facet going backwards, among those on that generator. */
static size_t find_open_facet_nearby(const fmb_support *s, const fmb_support_near *near)
{
    const fmb_facets *f = &s->hull;
    size_t best = SIZE_MAX;
    for (size_t k = 0; k < near->slots; k++) {
        size_t i = near->slot[k];
        if (is_open(&f->facet[i]) && fmb_facet_holds(&f->facet[i], near->generator) &&
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

bool fmb_support_is_hull_coarse(const fmb_support *s)
{
    return s->outers < s->outer_most && s->rows + s->hull.generators >= s->outer_after;
}

size_t fmb_support_find_open_facet(fmb_support *s, const fmb_support_near *near)
{
    size_t at = fmb_support_is_hull_coarse(s) ? SIZE_MAX : find_open_facet_nearby(s, near);
    if (at == SIZE_MAX)
        at = find_open_facet_anywhere(s);
    if (at != SIZE_MAX)
        s->at = at;
    return at;
}
