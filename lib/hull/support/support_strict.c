/* support_strict.c: which faces a projection with strict rows lacks; see support.h.
 *
 * The missing points are a union of faces (docs/theory.md, theorem 26): so it suffices to query
 * faces all of whose generators are missing, by the sum h of the normals of the facets around each.
 * A face is missing if and only if the optimum of h is not attained: then h < optimum is a row.
 * Faces of missing facets, or of other missing faces, need no row of their own.
 */
#include <string.h>

#include "base/arrays.h"
#include "hull/support/support_private.h"
#include "num/bitset.h"

typedef struct lattice {
    fmb_support *s;
    fmb_facets *f;
    uint64_t *missing; /* [words] generators: missing points */
    uint64_t *points;  /* [words] generators that are points */
    uint64_t *face;    /* [faces][words] faces met so far, as sets of generators */
    size_t faces, capacity, words;
    uint64_t *gone; /* [gones][words] missing faces, which have rows now */
    size_t gones, gone_capacity;
    fmb_integers sum; /* [d] scratch */
    fmb_vec h;        /* the same */
} lattice;

static bool is_facet_alive(const lattice *l, size_t a, int note)
{
    return l->f->facet[a].alive && l->f->facet[a].note == note;
}

/* Is the set part of a missing facet or face, which has a row already? */
static bool is_on_missing_face(const lattice *l, const uint64_t *set)
{
    for (size_t i = 0; i < l->gones; i++)
        if (fmb_set_is_inside(set, l->gone + i * l->words, l->words))
            return true;
    for (size_t a = 0; a < l->f->slots; a++)
        if (is_facet_alive(l, a, FMB_FACET_MISSING) &&
            fmb_set_is_inside(set, l->f->facet[a].on, l->words))
            return true;
    return false;
}

/* ---- questions ------------------------------------------------------------------------------- */

/* l->h = the sum of the normals of all facets that contain the set. */
static fmb_status add_normals_around(lattice *l, const uint64_t *set)
{
    mpz_t t;
    mpz_init(t);
    for (size_t j = 0; j < l->f->d; j++)
        mpz_set_ui(l->sum.z[j], 0);
    for (size_t a = 0; a < l->f->slots; a++) {
        const fmb_facet *facet = &l->f->facet[a];
        if (!facet->alive || !fmb_set_is_inside(set, facet->on, l->words))
            continue;
        for (size_t j = 0; j < l->f->d; j++) {
            fmb_vec_get(&facet->normal, j, t);
            mpz_add(l->sum.z[j], l->sum.z[j], t);
        }
    }
    mpz_clear(t);
    FMB_TRY(fmb_vec_set_z(&l->h, l->f->d, l->sum.z, l->s->run->mem));
    return fmb_vec_reduce(&l->h, l->f->d, &l->f->num);
}

/* Is the face of that set missing? If so, write its row. */
static fmb_status ask_about_face(lattice *l, const uint64_t *set, fmb_support_row *row,
                                 bool *missing)
{
    bool stands;
    *row = (fmb_support_row){0};
    fmb_status st = add_normals_around(l, set);
    FMB_THEN(st, fmb_support_query(l->s, &l->h, 1, row, &stands));
    *missing = st == FMB_OK && row->rel == FMB_LT;
    if (!*missing)
        fmb_support_drop(row, l->s->run->mem);
    return st;
}

static fmb_status find_missing_points(lattice *l)
{
    fmb_support_row row;
    fmb_status st = FMB_OK;
    uint64_t *one = l->face; /* not in use yet */
    for (size_t i = 0; st == FMB_OK && i < l->f->generators; i++) {
        if (fmb_vec_sgn(&l->f->generator[i], 0) == 0)
            continue;
        fmb_set_put(l->points, i);
        memset(one, 0, l->words * sizeof *one);
        fmb_set_put(one, i);
        bool missing = is_on_missing_face(l, one);
        if (!missing) {
            st = ask_about_face(l, one, &row, &missing);
            if (missing)
                fmb_support_drop(&row, l->s->run->mem);
        }
        if (missing)
            fmb_set_put(l->missing, i);
    }
    return st;
}

/* ---- faces ----------------------------------------------------------------------------------- */

static bool was_face_met(const lattice *l, const uint64_t *set)
{
    for (size_t i = 0; i < l->faces; i++)
        if (memcmp(l->face + i * l->words, set, l->words * sizeof *set) == 0)
            return true;
    return false;
}

/* Memory for one more set at the end of a list. */
static fmb_status reserve_set(lattice *l, uint64_t **list, size_t size, size_t *capacity)
{
    return FMB_RESERVE(l->s->run->mem, list, capacity, (size + 1) * l->words);
}

/* List the intersections of face i with facets that may be missing and have no row yet. */
static fmb_status list_faces_of_face(lattice *l, size_t i)
{
    for (size_t a = 0; a < l->f->slots; a++) {
        if (!is_facet_alive(l, a, FMB_FACET_STANDS))
            continue;
        FMB_TRY(reserve_set(l, &l->face, l->faces, &l->capacity));
        uint64_t *next = l->face + l->faces * l->words;
        for (size_t w = 0; w < l->words; w++)
            next[w] = l->face[i * l->words + w] & l->f->facet[a].on[w];
        if (fmb_sets_meet(next, l->missing, l->words) && !was_face_met(l, next) &&
            !is_on_missing_face(l, next))
            l->faces++;
        FMB_TRY(fmb_run_poll(l->s->run));
    }
    return FMB_OK;
}

static bool are_all_points_missing(const lattice *l, const uint64_t *set)
{
    for (size_t w = 0; w < l->words; w++)
        if (set[w] & l->points[w] & ~l->missing[w])
            return false;
    return true;
}

/* Move the largest face from number i on to place i. */
static void bring_largest_forward(lattice *l, size_t i)
{
    size_t best = i, most = 0;
    for (size_t k = i; k < l->faces; k++) {
        size_t size = 0;
        for (size_t w = 0; w < l->words; w++)
            size += (size_t)__builtin_popcountll(l->face[k * l->words + w]);
        if (size > most) {
            best = k;
            most = size;
        }
    }
    for (size_t w = 0; w < l->words; w++) {
        uint64_t t = l->face[i * l->words + w];
        l->face[i * l->words + w] = l->face[best * l->words + w];
        l->face[best * l->words + w] = t;
    }
}

static fmb_status keep_missing_face(lattice *l, size_t i, fmb_support_row *row)
{
    fmb_status st = reserve_set(l, &l->gone, l->gones, &l->gone_capacity);
    if (st != FMB_OK) {
        fmb_support_drop(row, l->s->run->mem);
        return st;
    }
    memcpy(l->gone + l->gones++ * l->words, l->face + i * l->words, l->words * sizeof *l->gone);
    return fmb_support_keep(l->s, row);
}

static fmb_status look_at_face(lattice *l, size_t i)
{
    fmb_support_row row;
    bool missing = false;
    const uint64_t *face = l->face + i * l->words;
    if (i > 0 && is_on_missing_face(l, face))
        return FMB_OK;
    if (i > 0 && are_all_points_missing(l, face))
        FMB_TRY(ask_about_face(l, face, &row, &missing));
    return missing ? keep_missing_face(l, i, &row) : list_faces_of_face(l, i);
}

/* Go from the whole hull downwards, the largest face first: so a face comes after all faces that
 * contain it, and a missing one gets a row unless a larger face has one. */
static fmb_status walk_down_the_lattice(lattice *l)
{
    memset(l->face, 0xff, l->words * sizeof *l->face);
    l->faces = 1;
    for (size_t i = 0; i < l->faces; i++) {
        bring_largest_forward(l, i);
        FMB_TRY(look_at_face(l, i));
    }
    return FMB_OK;
}

/* ---- all ------------------------------------------------------------------------------------- */

static fmb_status open_lattice(lattice *l)
{
    fmb_mem *mem = l->s->run->mem;
    FMB_TRY(FMB_ARRAYS(mem, true, FMB_ARRAY_ZERO(l->missing, l->words),
                       FMB_ARRAY_ZERO(l->points, l->words), FMB_ARRAY(l->h.s, l->f->d)));
    FMB_TRY(reserve_set(l, &l->face, l->faces, &l->capacity));
    return fmb_integers_init(&l->sum, l->f->d, mem);
}

static void close_lattice(lattice *l)
{
    fmb_mem *mem = l->s->run->mem;
    fmb_vec_clear(&l->h, l->f->d, mem);
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(l->h.s, l->f->d), FMB_ARRAY(l->missing, l->words),
                   FMB_ARRAY(l->points, l->words), FMB_ARRAY(l->face, l->capacity),
                   FMB_ARRAY(l->gone, l->gone_capacity));
    fmb_integers_clear(&l->sum, mem);
}

fmb_status fmb_support_find_missing_faces(fmb_support *s)
{
    lattice l = {.s = s, .f = &s->hull, .words = s->hull.words};
    fmb_status st = open_lattice(&l);
    FMB_THEN(st, find_missing_points(&l));
    FMB_THEN(st, walk_down_the_lattice(&l));
    close_lattice(&l);
    return st;
}
