/* lattice.c: the faces of a cone, level by level, from sets of generators; see lattice.h. */
#include "proof/lattice.h"
#include "base/arrays.h"
#include "num/bitset.h"

#include <string.h>

/* Limit on the words processed: some seconds. */
#define MOST_WORDS ((uint64_t)1 << 32)
/* Words of the sets of one level: 128 MiB. */
#define MOST_WORDS_OF_LEVEL ((size_t)1 << 24)

/* All faces of one dimension, each once. */
typedef struct faces_of_level {
    uint64_t *set; /* [size][words] */
    size_t size, capacity;
    size_t *slot; /* [slots] number of a face plus 1, by hash; 0: free */
    size_t slots; /* more than size, a power of 2, or 0 */
} faces_of_level;

/* f&r for some form r. */
typedef struct face_cut {
    uint64_t *set; /* [parts] of the walk */
    size_t size;   /* vectors in it */
} face_cut;

typedef struct lattice_walk {
    const fmb_lattice *l;
    fmb_mem *mem;
    faces_of_level here, below;
    size_t *part; /* [parts] nonzero words of the current face: faces have few vectors */
    size_t parts;
    uint64_t *face;    /* [words] scratch */
    uint64_t *set;     /* [forms][parts] of the cuts */
    face_cut *cut;     /* [forms] */
    size_t *facet;     /* [forms] cuts that are maximal ... */
    size_t facets;     /* ... of the current face */
    uint64_t words;    /* processed so far */
    uint64_t *unshown; /* the last face that misses a set `shows` ... */
    bool is_unshown;   /* ... if there is one */
    fmb_lattice_end end;
} lattice_walk;

/* ---- faces of a level ------------------------------------------------------------------------ */

/* The slot of that face, or the free slot for it; at least one slot is free. */
static size_t *find_slot_of_face(const faces_of_level *at, const uint64_t *set, size_t words)
{
    uint64_t h = 0;
    for (size_t k = 0; k < words; k++) {
        h = (h ^ set[k]) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
    }
    size_t i = (size_t)h & (at->slots - 1);
    while (at->slot[i] > 0 &&
           memcmp(at->set + (at->slot[i] - 1) * words, set, words * sizeof *set) != 0)
        i = (i + 1) & (at->slots - 1);
    return &at->slot[i];
}

static fmb_status double_slots(faces_of_level *at, size_t words, fmb_mem *mem)
{
    size_t slots = at->slots > 0 ? 2 * at->slots : 64;
    size_t *slot;
    FMB_TRY(FMB_GET_ZERO(mem, slot, slots));
    fmb_mem_put(mem, at->slot, at->slots, sizeof *slot);
    at->slot = slot;
    at->slots = slots;
    for (size_t i = 0; i < at->size; i++)
        *find_slot_of_face(at, at->set + i * words, words) = i + 1;
    return FMB_OK;
}

static fmb_status add_face(faces_of_level *at, const uint64_t *set, size_t words, fmb_mem *mem)
{
    fmb_status st = FMB_OK;
    if (2 * at->size >= at->slots)
        st = double_slots(at, words, mem);
    size_t *slot = st == FMB_OK ? find_slot_of_face(at, set, words) : NULL;
    if (!slot || *slot > 0)
        return st;
    st = FMB_RESERVE(mem, &at->set, &at->capacity, (at->size + 1) * words);
    if (st != FMB_OK)
        return st;
    memcpy(at->set + at->size * words, set, words * sizeof *set);
    *slot = ++at->size;
    return FMB_OK;
}

static void clear_level(faces_of_level *at, fmb_mem *mem)
{
    fmb_mem_put(mem, at->set, at->capacity, sizeof *at->set);
    fmb_mem_put(mem, at->slot, at->slots, sizeof *at->slot);
    *at = (faces_of_level){0};
}

/* ---- one face -------------------------------------------------------------------------------- */

/* Insert a cut; larger ones come first. */
static void insert_cut(face_cut *cut, size_t cuts, face_cut c)
{
    for (; cuts > 0 && cut[cuts - 1].size < c.size; cuts--)
        cut[cuts] = cut[cuts - 1];
    cut[cuts] = c;
}

/* For the form r with zeros zero[]: is f&r neither empty nor f? */
static bool is_proper_cut(const lattice_walk *w, const uint64_t *f, const uint64_t *zero)
{
    uint64_t in = 0, out = 0;
    for (size_t k = 0; k < w->parts; k++) {
        in |= f[w->part[k]] & zero[w->part[k]];
        out |= f[w->part[k]] & ~zero[w->part[k]];
    }
    return in != 0 && out != 0;
}

/* List the sets f&r that are neither empty nor f, larger ones first; returns their number. */
static size_t cut_face(lattice_walk *w, const uint64_t *f)
{
    size_t words = w->l->words, cuts = 0;
    w->parts = 0;
    for (size_t k = 0; k < words; k++)
        if (f[k] != 0)
            w->part[w->parts++] = k;
    for (size_t r = 0; r < w->l->forms; r++) {
        uint64_t *set = w->set + cuts * w->parts;
        const uint64_t *zero = w->l->zero + r * words;
        if (!is_proper_cut(w, f, zero))
            continue;
        for (size_t k = 0; k < w->parts; k++)
            set[k] = f[w->part[k]] & zero[w->part[k]];
        insert_cut(w->cut, cuts++, (face_cut){set, fmb_set_size(set, w->parts)});
    }
    w->words += w->l->forms * w->parts;
    return cuts;
}

/* Find the facets of f, unless some cut shows that f is not closed. A cut comes after all cuts that
 * contain it, so the maximal ones are known by then. */
static bool find_facets(lattice_walk *w, const uint64_t *f)
{
    size_t cuts = cut_face(w, f), words = w->parts, facets = 0;
    bool closed = true;
    for (size_t i = 0; closed && i < cuts; i++) {
        const face_cut *c = &w->cut[i];
        size_t above = 0;
        bool known = false;
        for (size_t k = 0; above < 2 && k < facets; k++) {
            const face_cut *facet = &w->cut[w->facet[k]];
            bool inside = fmb_set_is_inside(c->set, facet->set, words);
            above += inside;
            known = known || (inside && facet->size == c->size);
        }
        w->words += (facets + 1) * words;
        if (above == 0)
            w->facet[facets++] = i;
        closed = above != 1 || known;
    }
    w->facets = facets;
    return closed && facets > 1;
}

/* ---- simple faces ---------------------------------------------------------------------------- */

/* The members of a face, and for each the `width` forms that are 0 there: T(g), ascending. */
typedef struct simple_face {
    size_t members, width;
    uint32_t *tight; /* [members][width] */
    size_t *slot;    /* [slots] number of a member and a form left out of it, plus 1; 0: free */
    bool *is_met;    /* [slots] another member has these forms plus another one */
    size_t slots;
} simple_face;

/* Are the forms of numbers x and y the same, without the ones left out? */
static bool are_same_but_one(const simple_face *s, size_t x, size_t y)
{
    const uint32_t *a = s->tight + x / s->width * s->width, *b = s->tight + y / s->width * s->width;
    size_t i = 0, k = 0;
    bool same = true;
    for (size_t n = 0; same && n + 1 < s->width; n++) {
        i += i == x % s->width;
        k += k == y % s->width;
        same = a[i++] == b[k++];
    }
    return same;
}

/* The slot of the same forms without one as number x; at least one slot is free. */
static size_t find_slot_of_neighbours(const simple_face *s, size_t x)
{
    const uint32_t *forms = s->tight + x / s->width * s->width;
    uint64_t h = 0;
    for (size_t k = 0; k < s->width; k++)
        if (k != x % s->width)
            h = (h ^ forms[k]) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
    size_t i = (size_t)h & (s->slots - 1);
    while (s->slot[i] > 0 && !are_same_but_one(s, s->slot[i] - 1, x))
        i = (i + 1) & (s->slots - 1);
    return i;
}

/* Has each member of the face, for each of its forms, one neighbour with all other forms but not
 * it? A second one would be the same vector twice, up to a factor: that is left to the walk. */
static bool have_all_neighbours(const simple_face *s)
{
    bool all = true;
    for (size_t x = 0; all && x < s->members * s->width; x++) {
        size_t i = find_slot_of_neighbours(s, x);
        if (s->slot[i] == 0) {
            s->slot[i] = x + 1;
        } else {
            all = !s->is_met[i] && s->tight[s->slot[i] - 1] != s->tight[x];
            s->is_met[i] = true;
        }
    }
    for (size_t i = 0; all && i < s->slots; i++)
        all = s->slot[i] == 0 || s->is_met[i];
    return all;
}

/* List the facets that contain each member of f; false: not as many as the width. */
static bool list_tight_forms(const lattice_walk *w, const uint64_t *f, simple_face *s)
{
    size_t at = 0;
    bool good = true;
    for (size_t g = 0; good && g < 64 * w->parts; g++) {
        size_t n = 0;
        if (!(f[w->part[g / 64]] >> g % 64 & 1))
            continue;
        for (size_t i = 0; good && i < w->facets; i++) {
            if (!fmb_set_has(w->cut[w->facet[i]].set, g))
                continue;
            good = n < s->width;
            if (good)
                s->tight[at * s->width + n++] = (uint32_t)i;
        }
        good = good && n == s->width;
        at++;
    }
    return good;
}

/* Is f simple, where R' is one form for each facet? */
static fmb_status is_simple(lattice_walk *w, const uint64_t *f, size_t dimension, bool *simple)
{
    simple_face s = {.members = fmb_set_size(f, w->l->words), .width = dimension - 1, .slots = 64};
    size_t incidences = 0;
    for (size_t i = 0; i < w->facets; i++)
        incidences += w->cut[w->facet[i]].size;
    *simple =
        w->facets <= UINT32_MAX && incidences % s.width == 0 && incidences / s.width == s.members;
    if (!*simple || (s.width == 1 && s.members == 2)) /* two facets, a member each */
        return FMB_OK;
    while (s.slots < 2 * incidences)
        s.slots *= 2;
    const fmb_array arrays[] = {FMB_ARRAY(s.tight, incidences), FMB_ARRAY_ZERO(s.slot, s.slots),
                                FMB_ARRAY_ZERO(s.is_met, s.slots)};
    fmb_status st = fmb_arrays(w->mem, true, FMB_ALL(arrays));
    *simple = st == FMB_OK && list_tight_forms(w, f, &s) && have_all_neighbours(&s);
    w->words += incidences + s.slots;
    (void)fmb_arrays(w->mem, false, FMB_ALL(arrays));
    return st;
}

/* Make the facets of f faces of the next level, unless f is simple, or some cut shows that it is
 * not closed. If there are sets `shows`, all faces are visited. */
static fmb_status descend_to_facets(lattice_walk *w, const uint64_t *f, size_t dimension)
{
    bool simple = false;
    fmb_status st = FMB_OK;
    if (!find_facets(w, f))
        w->end = FMB_LATTICE_OPEN;
    else if (w->l->wanted == 0)
        st = is_simple(w, f, dimension, &simple);
    memset(w->face, 0, w->l->words * sizeof *w->face);
    for (size_t i = 0; st == FMB_OK && w->end == FMB_LATTICE_CLOSED && !simple && i < w->facets;
         i++) {
        for (size_t k = 0; k < w->parts; k++)
            w->face[w->part[k]] = w->cut[w->facet[i]].set[k];
        st = add_face(&w->below, w->face, w->l->words, w->mem);
    }
    return st;
}

/* Is f one vector at which some form is positive? */
static bool is_closed_ray(const lattice_walk *w, const uint64_t *f)
{
    size_t words = w->l->words;
    bool positive = false;
    for (size_t r = 0; !positive && r < w->l->forms; r++)
        positive = !fmb_sets_meet(f, w->l->zero + r * words, words);
    return positive && fmb_set_size(f, words) == 1;
}

static bool is_shown_or_excluded(const lattice_walk *w, const uint64_t *f)
{
    const fmb_lattice *l = w->l;
    bool excluded = l->wanted == 0, all = true;
    for (size_t r = 0; !excluded && r < l->forms; r++)
        excluded = l->excludes[r] && fmb_set_is_inside(f, l->zero + r * l->words, l->words);
    for (size_t i = 0; !excluded && all && i < l->wanted; i++)
        all = fmb_sets_meet(f, l->shows + i * l->words, l->words);
    return all;
}

/* ---- all ------------------------------------------------------------------------------------- */

static fmb_status look_at_face(lattice_walk *w, const uint64_t *f, size_t dimension)
{
    fmb_status st = FMB_OK;
    if (!is_shown_or_excluded(w, f)) {
        w->is_unshown = true;
        memcpy(w->unshown, f, w->l->words * sizeof *f);
    }
    if (dimension > 1)
        st = descend_to_facets(w, f, dimension);
    else if (!is_closed_ray(w, f))
        w->end = FMB_LATTICE_OPEN;
    if (w->words > MOST_WORDS || w->below.size > MOST_WORDS_OF_LEVEL / w->l->words)
        w->end = FMB_LATTICE_LARGE;
    return st;
}

static fmb_status walk_down(lattice_walk *w, size_t dimension, const fmb_poll *poll)
{
    for (; dimension > 0 && w->end == FMB_LATTICE_CLOSED; dimension--) {
        for (size_t i = 0; w->end == FMB_LATTICE_CLOSED && i < w->here.size; i++) {
            FMB_TRY(fmb_poll_ask(poll));
            FMB_TRY(look_at_face(w, w->here.set + i * w->l->words, dimension));
        }
        clear_level(&w->here, w->mem);
        w->here = w->below;
        w->below = (faces_of_level){0};
    }
    return FMB_OK;
}

fmb_status fmb_lattice_check(const fmb_lattice *l, const uint64_t *top, size_t dimension,
                             fmb_mem *mem, const fmb_poll *poll, fmb_lattice_end *end,
                             uint64_t *face)
{
    lattice_walk w = {.l = l, .mem = mem, .unshown = face};
    size_t words;
    if (__builtin_mul_overflow(l->forms, l->words, &words))
        return FMB_ERR_MEMORY;
    const fmb_array arrays[] = {FMB_ARRAY(w.set, words), FMB_ARRAY(w.cut, l->forms),
                                FMB_ARRAY(w.facet, l->forms), FMB_ARRAY(w.part, l->words),
                                FMB_ARRAY(w.face, l->words)};
    fmb_status st = fmb_arrays(mem, true, FMB_ALL(arrays));
    FMB_THEN(st, add_face(&w.here, top, l->words, mem));
    if (dimension == 0)
        w.end = FMB_LATTICE_OPEN;
    FMB_THEN(st, walk_down(&w, dimension, poll));
    clear_level(&w.here, mem);
    clear_level(&w.below, mem);
    (void)fmb_arrays(mem, false, FMB_ALL(arrays));
    if (st == FMB_OK)
        *end = w.end == FMB_LATTICE_CLOSED && w.is_unshown ? FMB_LATTICE_UNSHOWN : w.end;
    return st;
}
