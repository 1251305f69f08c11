/* image_corners.c: which rays of an image are extreme; see image.h.
 *
 * The forms are b t - a.x of each inequality, and t. If cone G is the cone P on which no form is
 * negative, then g of G is on an extreme ray of P, up to the lines of P, if and only if all vectors
 * of G that are 0 on all forms that are 0 at g are lines, or multiples of g up to lines. For the
 * points of P where these forms are 0 are the least face with g, spanned by the vectors of G on it.
 * Such multiples are 0 on the same forms; one of them suffices. Lines are 0 on all forms. So
 * incidences decide which vectors are corners. If G spans less than P, or if there are lines, too
 * many may be taken for corners; the caller finds that out.
 */
#include <string.h>

#include "hull/image/image.h"

typedef struct corner_search {
    fmb_image *m;
    size_t forms, words;   /* words of a set of rays */
    const uint64_t **zero; /* [forms] rays where the form is 0 */
    uint64_t *face;        /* [words] scratch */
    size_t *zeros;         /* [rays] forms that are 0 there */
    bool *stays;           /* [rays] is it a corner? */
} corner_search;

static fmb_status list_forms(corner_search *c)
{
    fmb_image *m = c->m;
    uint64_t *infinity;
    FMB_TRY(FMB_ARENA_GET(&m->arena, infinity, c->words));
    FMB_TRY(FMB_ARENA_GET(&m->arena, c->zero, m->facets + 1));
    FMB_TRY(FMB_ARENA_GET(&m->arena, c->face, c->words));
    FMB_TRY(FMB_ARENA_GET(&m->arena, c->zeros, m->rays));
    FMB_TRY(FMB_ARENA_GET(&m->arena, c->stays, m->rays));
    for (size_t i = 0; i < m->facets; i++)
        if (m->facet[i].on && !m->facet[i].equality)
            c->zero[c->forms++] = m->facet[i].on;
    memset(infinity, 0, c->words * sizeof *infinity);
    for (size_t g = 0; g < m->rays; g++)
        if (fmb_vec_sgn(&m->ray[g], m->n - 1) == 0)
            fmb_set_put(infinity, g);
    c->zero[c->forms++] = infinity;
    for (size_t g = 0; g < m->rays; g++) {
        c->zeros[g] = 0;
        for (size_t i = 0; i < c->forms; i++)
            c->zeros[g] += fmb_set_has(c->zero[i], g);
    }
    return FMB_OK;
}

/* c->face = the rays on all forms that are 0 at g. */
static void find_least_face(corner_search *c, size_t g)
{
    memset(c->face, 0xff, c->words * sizeof *c->face);
    for (size_t i = 0; i < c->forms; i++)
        for (size_t k = 0; fmb_set_has(c->zero[i], g) && k < c->words; k++)
            c->face[k] &= c->zero[i][k];
}

/* Is g, up to lines, the only vector of its face, or the first of those with as many zeros? */
static bool is_corner(const corner_search *c, size_t g)
{
    bool only = c->zeros[g] < c->forms;
    for (size_t i = 0; only && i < c->m->rays; i++)
        if (c->face[i / 64] == 0)
            i |= 63; /* none of these */
        else if (i != g && fmb_set_has(c->face, i) && c->zeros[i] < c->forms)
            only = c->zeros[i] == c->zeros[g] && i > g;
    return only;
}

fmb_status fmb_image_keep_corners(fmb_image *m)
{
    corner_search c = {.m = m, .words = fmb_set_words(m->rays)};
    size_t left = 0;
    fmb_status st = list_forms(&c);
    for (size_t g = 0; st == FMB_OK && g < m->rays; g++) {
        find_least_face(&c, g);
        c.stays[g] = is_corner(&c, g);
        st = fmb_run_poll(m->run);
    }
    for (size_t g = 0; st == FMB_OK && g < m->rays; g++) {
        bool line = c.zeros[g] == c.forms;
        if (c.stays[g]) {
            m->above[left] = m->above[g];
            m->ray[left++] = m->ray[g];
        } else if (line) {
            m->line_above[m->lines] = m->above[g];
            m->line[m->lines++] = m->ray[g];
        } else {
            fmb_vec_clear(&m->ray[g], m->n, m->run->mem);
        }
    }
    m->rays = st == FMB_OK ? left : m->rays;
    return st;
}
