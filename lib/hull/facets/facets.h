/* facets.h: the facets of the cone spanned by integer vectors, updated as vectors are added.
 *
 * The convex hull of points and rays is such a cone, one dimension higher: (x0, x) with x0 > 0 is
 * the point x / x0, and (0, x) is a ray. One of its facets may be x0 >= 0, the face at infinity.
 *
 * Invariants between calls, `rank` being the dimension of the span of the generators:
 * 1. equation[0..d - rank) are independent, and 0 on all generators;
 * 2. the normal of a facet is >= 0 on all generators, and 0 exactly on those in its set `on`, which
 *    span rank - 1 dimensions;
 * 3. `next` of a facet lists the facets with which it shares a ridge, of rank - 2 dimensions.
 * Normals are coprime, and unique up to equations. The same holds for cones that contain lines:
 * their lines are on every facet.
 *
 * A normal is kept in doubles, with bounds on its errors. It is known in integers only if its
 * numbers are short, the cone is flat, or a sign was in doubt (facets_roughly.c): most facets are
 * removed before that.
 *
 * Sources: Seidel 1981 (beneath and beyond); Barber, Dobkin, Huhdanpaa 1996 (quickhull); Fukuda and
 * Prodon 1996 (adjacency by sets, for cones that are not simplicial).
 */
#ifndef FMB_HULL_FACETS_H
#define FMB_HULL_FACETS_H

#include "num/bitset.h"
#include "num/vec.h"
#include "trace/run.h"

/* Up to this many dimensions normals are computed in integers only when needed. */
#define FMB_FACETS_FEW 7

typedef struct fmb_facet {
    fmb_vec normal; /* [d + 1] if known; the last entry is scratch, 0 between calls */
    bool known;
    bool fresh;        /* `roughly` was recomputed from `on`, if that was possible */
    double *roughly;   /* [2 d] the normal, scaled; bounds on errors of its entries */
    double value, off; /* rough value on the new generator, error bound; sign: `side` */
    uint64_t *on;      /* [words] set of generators, */
    size_t words, ons; /* and its size */
    uint32_t *next;    /* [nexts] */
    size_t nexts, next_capacity;
    int side; /* sign of the normal on the generator of `round` */
    uint64_t round;
    bool valued; /* scratch: the last entry is the normal's value on that generator */
    bool alive;
    int note; /* free for the owner of the structure; initially 0 */
} fmb_facet;

typedef struct fmb_facets {
    fmb_run *run;
    fmb_num num;
    size_t d, rank;
    fmb_vec *equation;  /* [d], d + 1 entries each, as those of normals */
    fmb_vec *generator; /* [generators], d entries each, coprime */
    double *rounded;    /* [generators][d] scaled to entries of at most 1 */
    size_t generators, generator_capacity, rounded_capacity, words;
    fmb_facet *facet; /* [slots]; slots not alive are free */
    size_t slots, facet_capacity, alive;
    uint64_t round;                           /* number of generators processed */
    uint64_t pairs;                           /* pairs of facets tested for a common ridge, */
    uint64_t most_pairs;                      /* and a limit on them; 0: none */
    fmb_vec g;                                /* [d] the generator being added, */
    double *near;                             /* [d] and in doubles */
    mpz_t *minor;                             /* [2^d] scratch, or NULL */
    uint32_t *seen, *touched, *made, *unused; /* lists of facets, scratch: visible from the
                                                 last generator, touched by it, new ones; free
                                                 slots */
    size_t seens, toucheds, mades, unuseds;
    size_t seen_capacity, touched_capacity, made_capacity, unused_capacity;
    uint64_t *common; /* [common_words] scratch */
    size_t common_words;
    uint64_t *holder; /* scratch: of each generator, the candidate facets that contain it, */
    size_t holder_words, holder_capacity; /* words of each set */
} fmb_facets;

/* No generators: the cone {0}. Errors: MEMORY, LIMIT, as below; call fmb_facets_clear even then.
 */
fmb_status fmb_facets_init(fmb_facets *f, fmb_run *run, size_t d);
void fmb_facets_clear(fmb_facets *f);

/* Add the vector g[d], not 0. *grown: it was outside the cone, and is generator number
 * f->generators - 1. After an error only fmb_facets_clear may be called. The search for facets
 * visible from g begins at slot number `at`, and is quickest if that facet is visible. */
fmb_status fmb_facets_add_near(fmb_facets *f, size_t at, mpz_t *g, bool *grown);
static inline fmb_status fmb_facets_add(fmb_facets *f, mpz_t *g, bool *grown)
{
    return fmb_facets_add_near(f, 0, g, grown);
}
/* The same for v[d], which need not be coprime. */
fmb_status fmb_facets_add_vec(fmb_facets *f, const fmb_vec *v, bool *grown);

/* The same for many vectors, fewer than 2^32, in an order that makes few intermediate facets.
 * Points are compared at v_t = 1. */
fmb_status fmb_facets_add_all(fmb_facets *f, const fmb_vec *v, size_t size, size_t t);

/* The same in steps, for the vectors not yet added. f and v must outlive *out. The caller must call
 * fmb_facet_crowd_close even after an error. */
typedef struct fmb_facet_crowd fmb_facet_crowd;
fmb_status fmb_facet_crowd_open(fmb_facets *f, const fmb_vec *v, size_t size, size_t t,
                                fmb_facet_crowd **out);
/* Add vectors until all are, *done, or a slice is over (trace/run.h), but at least one. */
fmb_status fmb_facet_crowd_go_on(fmb_facet_crowd *c, bool *done);
void fmb_facet_crowd_close(fmb_facet_crowd *c);

/* Compute the integer normal of a facet, unless known. Errors: MEMORY, LIMIT. */
fmb_status fmb_facets_need_normal(fmb_facets *f, size_t at);
/* The same for all facets, by as many threads as the run has. Errors: MEMORY, LIMIT. */
fmb_status fmb_facets_need_all_normals(fmb_facets *f);

static inline bool fmb_facet_holds(const fmb_facet *a, size_t generator)
{
    return fmb_set_has(a->on, generator);
}
/* The first generator from number i on that is on a facet, or not on it; beyond the last one if
 * there is none. */
static inline size_t fmb_facet_next(const fmb_facet *a, size_t i, bool on)
{
    uint64_t flip = on ? 0 : UINT64_MAX;
    for (size_t w = i / 64; w < a->words; w++) {
        uint64_t set = a->on[w] ^ flip;
        if (w == i / 64)
            set &= UINT64_MAX << i % 64;
        if (set != 0)
            return 64 * w + (size_t)__builtin_ctzll(set);
    }
    return 64 * a->words;
}

#endif
