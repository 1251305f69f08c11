/* facets.h: the facets of the cone spanned by vectors of integers, kept up to date as vectors come.
 *
 * The convex hull of points and rays is such a cone, one dimension higher: (x0, x) with x0 > 0 is
 * the point x / x0, and (0, x) is a ray. One of its facets may be x0 >= 0, the face at infinity.
 *
 * Invariants between calls, `rank` being the dimension of what the generators span:
 * - equation[0..d - rank) are independent, and 0 on all generators;
 * - the normal of a facet is >= 0 on all generators, and 0 exactly on those in its set `on`, which
 *   span rank - 1 dimensions;
 * - `next` of a facet names the facets with which it shares a ridge, rank - 2 dimensions.
 * Normals are coprime, and unique up to equations. Cones that contain lines are no exception:
 * their lines are on every facet.
 *
 * A normal is kept in doubles, with bounds on its errors; in integers it is known only where its
 * numbers are short, the cone is flat, or a sign was in doubt (facets_roughly.c). Most facets go
 * again before that.
 *
 * Sources: Seidel 1981 (beneath and beyond); Barber, Dobkin, Huhdanpaa 1996 (quickhull); Fukuda and
 * Prodon 1996 (adjacency by sets, of cones that are not simplicial).
 */
#ifndef FMB_HULL_FACETS_H
#define FMB_HULL_FACETS_H

#include "num/bitset.h"
#include "num/vec.h"
#include "trace/run.h"

/* In so few dimensions normals need not be known. */
#define FMB_FACETS_FEW 7

typedef struct fmb_facet {
    fmb_vec normal; /* [d + 1] if known; the last entry is scratch, 0 between calls */
    bool known;
    bool fresh;        /* roughly, it was found from what is on it, as far as that goes */
    double *roughly;   /* [2 d] the normal, scaled; and how far each entry may be off */
    double value, off; /* of the generator at hand, roughly: its sign is that of `side` */
    uint64_t *on;      /* [words] set of generators, */
    size_t words, ons; /* and how many they are */
    uint32_t *next;    /* [nexts] */
    size_t nexts, next_capacity;
    int side; /* sign of the normal on the generator of that round */
    uint64_t round;
    bool valued; /* scratch: the last entry is the normal's value on that generator */
    bool alive;
    int note; /* whoever holds the facets may note something here; 0 at first */
} fmb_facet;

typedef struct fmb_facets {
    fmb_run *run;
    fmb_num num;
    size_t d, rank;
    fmb_vec *equation;  /* [d], d + 1 entries each, as those of normals */
    fmb_vec *generator; /* [generators], d entries each, coprime */
    double *rounded;    /* [generators][d] the same up to a positive factor, at most 1 */
    size_t generators, generator_capacity, rounded_capacity, words;
    fmb_facet *facet; /* [slots]; those not alive are free */
    size_t slots, facet_capacity, alive;
    uint64_t round;      /* counts generators that were looked at */
    uint64_t pairs;      /* of facets, of which it was asked whether they share a ridge, */
    uint64_t most_pairs; /* and a limit of them; 0: none */
    fmb_vec g;           /* [d] the generator at hand, */
    double *near;        /* [d] and roughly */
    mpz_t *minor;        /* [2^d] scratch, or NULL */
    uint32_t *seen, *touched, *made, *unused; /* lists of facets, scratch: those that the last
                                                 generator removed, had on its hyperplane, and made;
                                                 free slots */
    size_t seens, toucheds, mades, unuseds;
    size_t seen_capacity, touched_capacity, made_capacity, unused_capacity;
    uint64_t *common; /* [common_words] scratch */
    size_t common_words;
    uint64_t *holder; /* scratch: of each generator, the set of facets at hand that hold it, */
    size_t holder_words, holder_capacity; /* so many words each */
} fmb_facets;

/* No generators yet: the cone {0}. Errors: MEMORY, LIMIT, as below. In any case fmb_facets_clear.
 */
fmb_status fmb_facets_init(fmb_facets *f, fmb_run *run, size_t d);
void fmb_facets_clear(fmb_facets *f);

/* Take in g[d], not 0. *grown: it was outside of the cone, and is generator number
 * f->generators - 1. After an error nothing but fmb_facets_clear may be called. The facets that it
 * is beyond are looked for from slot number `at` on: quickest if that is one of them. */
fmb_status fmb_facets_add_near(fmb_facets *f, size_t at, mpz_t *g, bool *grown);
static inline fmb_status fmb_facets_add(fmb_facets *f, mpz_t *g, bool *grown)
{
    return fmb_facets_add_near(f, 0, g, grown);
}
/* The same; v[d] need not be coprime. */
fmb_status fmb_facets_add_vec(fmb_facets *f, const fmb_vec *v, bool *grown);

/* The same with many at once, in an order that makes few facets on the way. Points are compared at
 * v_t = 1. Fewer vectors than 2^32. */
fmb_status fmb_facets_add_all(fmb_facets *f, const fmb_vec *v, size_t size, size_t t);

/* The same, some at a time: those that are not taken in yet. f and v stay. In any case
 * fmb_facet_crowd_close *out. */
typedef struct fmb_facet_crowd fmb_facet_crowd;
fmb_status fmb_facet_crowd_open(fmb_facets *f, const fmb_vec *v, size_t size, size_t t,
                                fmb_facet_crowd **out);
/* Until all are, *done; or a slice is over (trace/run.h), but at least one. */
fmb_status fmb_facet_crowd_go_on(fmb_facet_crowd *c, bool *done);
void fmb_facet_crowd_close(fmb_facet_crowd *c);

/* Make the normal of a facet known. Errors: MEMORY, LIMIT. */
fmb_status fmb_facets_need_normal(fmb_facets *f, size_t at);
/* Those of all facets, by as many threads as the run has. Errors: MEMORY, LIMIT. */
fmb_status fmb_facets_need_all_normals(fmb_facets *f);

static inline bool fmb_facet_holds(const fmb_facet *a, size_t generator)
{
    return fmb_set_has(a->on, generator);
}
/* The first generator on a facet, or not on it, from number i on; behind the last one if there is
 * none. */
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
