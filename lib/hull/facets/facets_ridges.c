/* facets_ridges.c: which facets share a ridge after a generator g was added; see facets.h.
 *
 * All new ridges contain g, so they lie between new or touched facets, the candidates. Two of these
 * share a ridge if and only if no third facet contains all their common generators; it would
 * contain g as well. Two touched facets may share a ridge that they did not share before.
 *
 * If not all are simplices, most pairs have too few common generators. For each generator the set
 * of candidates that contain it is listed; adding these sets over a facet's generators counts those
 * in common with 64 others at a time, and intersecting them finds a third facet.
 */
#include <string.h>

#include "hull/facets/facets_private.h"
#include "num/bitset.h"

static bool are_neighbours(const fmb_facet *a, uint32_t b)
{
    for (size_t k = 0; k < a->nexts; k++)
        if (a->next[k] == b)
            return true;
    return false;
}

/* f->common = the generators on both; returns their number. */
static size_t find_common(fmb_facets *f, const fmb_facet *a, const fmb_facet *b)
{
    size_t count = 0;
    for (size_t w = 0; w < f->words; w++) {
        f->common[w] = a->on[w] & b->on[w];
        count += fmb_ones64(f->common[w]);
    }
    return count;
}

/* Candidate number i: new facets, then touched ones. */
static uint32_t candidate(const fmb_facets *f, size_t i)
{
    return i < f->mades ? f->made[i] : f->touched[i - f->mades];
}

static size_t count_candidates(const fmb_facets *f)
{
    return f->mades + f->toucheds;
}

/* Has the facet just rank - 1 generators? They are independent, any rank - 2 of them span a ridge,
 * and no other facet contains them all. */
static bool is_simplex(const fmb_facets *f, const fmb_facet *a)
{
    return a->ons + 1 == f->rank;
}

/* Counts decide whether two simplices share a ridge, and a simplex and any other facet. */
static bool are_counts_enough(const fmb_facets *f)
{
    size_t others = 0;
    for (size_t i = 0; others < 2 && i < count_candidates(f); i++)
        others += !is_simplex(f, &f->facet[candidate(f, i)]);
    return others < 2;
}

/* The least number of common generators of two candidates that share a ridge; at least 1. */
static size_t least_in_common(const fmb_facets *f)
{
    return f->rank > 3 ? f->rank - 2 : 1;
}

static fmb_status list_holders(fmb_facets *f)
{
    size_t n = count_candidates(f), words = f->holder_words = fmb_set_words(n);
    size_t size = 64 * f->words * words, scratch = least_in_common(f) * words;
    FMB_TRY(FMB_RESERVE(f->num.mem, &f->holder, &f->holder_capacity, size + scratch));
    memset(f->holder, 0, size * sizeof *f->holder);
    for (size_t i = 0; i < n; i++) {
        const fmb_facet *a = &f->facet[candidate(f, i)];
        for (size_t g = fmb_facet_next(a, 0, true); g < 64 * f->words;
             g = fmb_facet_next(a, g + 1, true))
            fmb_set_put(f->holder + g * words, i);
    }
    return FMB_OK;
}

/* The set of candidates with enough generators in common with a. Level k - 1 is the set of those
 * with k common generators so far: 64 candidates at a time are counted. */
static const uint64_t *find_near_candidates(fmb_facets *f, const fmb_facet *a)
{
    size_t words = f->holder_words, levels = least_in_common(f);
    uint64_t *level = &f->holder[64 * f->words * words];
    memset(level, 0, levels * words * sizeof *level);
    for (size_t g = fmb_facet_next(a, 0, true); g < 64 * f->words;
         g = fmb_facet_next(a, g + 1, true)) {
        const uint64_t *holder = &f->holder[g * words];
        for (size_t k = levels - 1; k > 0; k--)
            for (size_t w = 0; w < words; w++)
                level[k * words + w] |= level[(k - 1) * words + w] & holder[w];
        for (size_t w = 0; w < words; w++)
            level[w] |= holder[w];
    }
    return &level[(levels - 1) * words];
}

/* Word w of the set of candidates that contain all common generators. */
static uint64_t holders_of_common(const fmb_facets *f, size_t w)
{
    uint64_t holders = UINT64_MAX;
    for (size_t u = 0; holders != 0 && u < f->words; u++)
        for (uint64_t left = f->common[u]; left != 0; left &= left - 1) {
            size_t g = 64 * u + (size_t)__builtin_ctzll(left);
            holders &= f->holder[g * f->holder_words + w];
        }
    return holders;
}

/* For candidates i and j: does a third one contain all their common generators? */
static bool is_common_to_a_third(const fmb_facets *f, size_t i, size_t j)
{
    for (size_t w = 0; w < f->holder_words; w++) {
        uint64_t holders = holders_of_common(f, w);
        if (w == i / 64)
            holders &= ~((uint64_t)1 << i % 64);
        if (w == j / 64)
            holders &= ~((uint64_t)1 << j % 64);
        if (holders != 0)
            return true;
    }
    return false;
}

static bool share_a_ridge(fmb_facets *f, size_t i, size_t j)
{
    const fmb_facet *p = &f->facet[candidate(f, i)], *q = &f->facet[candidate(f, j)];
    size_t count = find_common(f, p, q);
    if (is_simplex(f, p) || is_simplex(f, q))
        return count + 2 == f->rank;
    return count + 2 >= f->rank && !is_common_to_a_third(f, i, j);
}

/* Is the facet a simplex all of whose ridges are found? */
static bool has_all_neighbours(const fmb_facets *f, uint32_t a)
{
    const fmb_facet *t = &f->facet[a];
    return is_simplex(f, t) && t->nexts + 1 == f->rank;
}

static fmb_status join_if_neighbours(fmb_facets *f, size_t i, size_t j)
{
    uint32_t a = candidate(f, i), b = candidate(f, j);
    if (has_all_neighbours(f, b))
        return FMB_OK;
    bool old = j >= f->mades && are_neighbours(&f->facet[a], b);
    return !old && share_a_ridge(f, i, j) ? fmb_facets_join(f, a, b) : FMB_OK;
}

/* Join candidate i with earlier ones that share a ridge with it. */
static fmb_status join_each(fmb_facets *f, size_t i)
{
    for (size_t j = 0; j < i && !has_all_neighbours(f, candidate(f, i)); j++)
        FMB_TRY(join_if_neighbours(f, i, j));
    return FMB_OK;
}

/* The same if holders are listed. */
static fmb_status join_near(fmb_facets *f, size_t i)
{
    fmb_status st = FMB_OK;
    const uint64_t *near = find_near_candidates(f, &f->facet[candidate(f, i)]);
    for (size_t w = 0; w <= i / 64; w++) {
        uint64_t left = near[w] & (w < i / 64 ? UINT64_MAX : ((uint64_t)1 << i % 64) - 1);
        for (; st == FMB_OK && left != 0; left &= left - 1)
            st = join_if_neighbours(f, i, 64 * w + (size_t)__builtin_ctzll(left));
    }
    return st;
}

/* Work for candidate i if holders are listed. */
static size_t work_of_near(const fmb_facets *f, size_t i)
{
    return 150 + 2 * i + f->facet[candidate(f, i)].ons * least_in_common(f) * f->holder_words;
}

fmb_status fmb_facets_join_new(fmb_facets *f)
{
    bool listed = !are_counts_enough(f);
    FMB_TRY(listed ? list_holders(f) : FMB_OK);
    for (size_t i = 1; i < count_candidates(f); i++) {
        f->pairs += i;
        fmb_run_count(f->run, listed ? work_of_near(f, i) : 50 + i * (10 + 2 * f->words));
        if (f->most_pairs > 0 && f->pairs > f->most_pairs)
            return FMB_LIMIT;
        FMB_TRY(listed ? join_near(f, i) : join_each(f, i));
        FMB_TRY(fmb_run_poll(f->run));
    }
    return FMB_OK;
}
