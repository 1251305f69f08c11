/* facets_many.c: adds many generators, the farthest ones first; see facets.h.
 *
 * Each vector that may still be outside waits at a facet that it is beyond. The one farthest beyond
 * its facet is added next. Vectors that wait at removed facets are then tested against the new and
 * the touched facets: if they are beyond none of these, they are inside for good.
 *
 * Proof. Let p wait at v, which is removed as g is added, and be beyond a facet of the new cone.
 * The facets of the old cone that p is beyond are connected by ridges. If all are removed, those of
 * the new cone that p is beyond are new or touched. Else a removed one, v', shares a ridge with a
 * remaining one, n. If n is touched, p is beyond a touched facet. If not, n is positive on g, and
 * the new facet over that ridge is a combination of n and v' with positive numbers: p is beyond it.
 *
 * Source: Barber, Dobkin, Huhdanpaa 1996, The quickhull algorithm for convex hulls, lemma 3.1.
 */
#include <math.h>

#include "hull/facets/facets_private.h"

#define NOBODY UINT32_MAX

/* The vectors waiting at a facet, by slot. */
typedef struct queue {
    uint32_t first; /* the farthest one */
    double depth;   /* its distance in doubles */
} queue;

struct fmb_facet_crowd {
    fmb_facets *f;
    const fmb_vec *v; /* [size] */
    size_t size, t;
    double *near;   /* [size][d] the vectors, scaled so that distances are comparable */
    uint32_t *next; /* [size] the next vector at the same facet */
    queue *at;      /* [slots] */
    size_t slots, capacity;
    uint32_t turn; /* the facet whose first vector comes next */
};

typedef struct fmb_facet_crowd crowd;

/* ---- vectors in doubles ---------------------------------------------------------------------- */

/* No entry of a vector in doubles is larger than about 2^900: then sums of products with normals,
 * and the bounds of these, do not overflow. */
enum { MOST_EXPONENT = 900, LEAST_EXPONENT = -1200 };

/* Entry k is the result, from 1/2 to 1 or 0, times 2^*exponent, truncated to 53 bits. */
static double take_apart(const fmb_vec *v, size_t k, long *exponent)
{
    int e;
    if (v->z)
        return mpz_get_d_2exp(exponent, v->z[k]);
    double x = frexp((double)v->s[k], &e);
    *exponent = e;
    return x;
}

/* The largest exponent of an entry that is not 0, and the column where it is. */
static long find_largest_exponent(const fmb_vec *v, size_t d, size_t *column)
{
    long most = 0, e;
    *column = d;
    for (size_t k = 0; k < d; k++)
        if (take_apart(v, k, &e) != 0 && (*column == d || e > most)) {
            most = e;
            *column = k;
        }
    return most;
}

/* Points get the coordinate t = 1, rays a largest coordinate of about 1; or less, if another one
 * would overflow.
 *
 * Theorem. x_k = s v_k up to a factor within 1 +- 2^-50, and up to 2^-1075, for some s > 0. Proof.
 * Entry k is truncated and divided: a factor within 1 +- 2^-51. The truncated divisor is the same
 * for all entries, as is the power of two: they are in s. Only ldexp may underflow, once; entries
 * less than 2^LEAST_EXPONENT become 0 either way. */
static void scale_vector(const fmb_vec *v, size_t d, size_t t, double *x)
{
    size_t largest, unit = t;
    long most = find_largest_exponent(v, d, &largest), one, e;
    if (fmb_vec_sgn(v, t) == 0)
        unit = largest;
    double by = fabs(take_apart(v, unit, &one));
    if (most - one > MOST_EXPONENT)
        one = most - MOST_EXPONENT;
    for (size_t k = 0; k < d; k++) {
        double part = take_apart(v, k, &e) / by;
        x[k] = ldexp(part, e - one < LEAST_EXPONENT ? LEAST_EXPONENT : (int)(e - one));
    }
}

static void scale_vectors(crowd *c)
{
    size_t d = c->f->d;
    for (size_t i = 0; i < c->size; i++)
        scale_vector(&c->v[i], d, c->t, c->near + i * d);
}

/* ---- queues ---------------------------------------------------------------------------------- */

static void wait_at_facet(crowd *c, uint32_t a, uint32_t i)
{
    queue *q = &c->at[a];
    double depth = -c->f->facet[a].value;
    bool farthest = q->first == NOBODY || depth > q->depth;
    uint32_t *place = farthest ? &q->first : &c->next[q->first];
    q->depth = farthest ? depth : q->depth;
    c->next[i] = *place;
    *place = i;
}

/* If the vector is certainly beyond one of these facets, let it wait there. */
static bool look_for_sure_facet(crowd *c, uint32_t i, const uint32_t *facet, size_t facets,
                                bool *doubtful)
{
    const double *near = c->near + i * c->f->d;
    for (size_t k = 0; k < facets; k++) {
        int side;
        fmb_run_count(c->f->run, 10 + c->f->d);
        bool sure = fmb_facets_guess_side(c->f, &c->f->facet[facet[k]], near, &side);
        *doubtful |= !sure;
        if (sure && side < 0) {
            wait_at_facet(c, facet[k], i);
            return true;
        }
    }
    return false;
}

/* The same with doubtful signs decided exactly. */
static fmb_status look_for_facet(crowd *c, uint32_t i, const uint32_t *facet, size_t facets,
                                 bool *waits)
{
    fmb_status st = FMB_OK;
    const double *near = c->near + i * c->f->d;
    for (size_t k = 0; st == FMB_OK && !*waits && k < facets; k++) {
        int side;
        st = fmb_facets_side(c->f, facet[k], &c->v[i], near, &side);
        *waits = st == FMB_OK && side < 0;
        if (*waits)
            wait_at_facet(c, facet[k], i);
    }
    return st;
}

static fmb_status look_for_new_facet(crowd *c, uint32_t i)
{
    const fmb_facets *f = c->f;
    bool doubtful = false;
    bool waits = look_for_sure_facet(c, i, f->made, f->mades, &doubtful) ||
                 look_for_sure_facet(c, i, f->touched, f->toucheds, &doubtful);
    if (waits || !doubtful)
        return FMB_OK;
    FMB_TRY(look_for_facet(c, i, f->made, f->mades, &waits));
    return look_for_facet(c, i, f->touched, f->toucheds, &waits);
}

static fmb_status open_queues(crowd *c)
{
    FMB_TRY(FMB_RESERVE(c->f->num.mem, &c->at, &c->capacity, c->f->slots));
    for (; c->slots < c->f->slots; c->slots++)
        c->at[c->slots] = (queue){.first = NOBODY};
    return FMB_OK;
}

/* ---- all of them ----------------------------------------------------------------------------- */

static fmb_status add_from_crowd(crowd *c, size_t i)
{
    bool grown;
    FMB_TRY(fmb_run_poll(c->f->run));
    return fmb_facets_add_vec(c->f, &c->v[i], &grown);
}

/* Add the extreme vectors in both directions of each coordinate. */
static fmb_status add_outermost_vectors(crowd *c)
{
    size_t d = c->f->d;
    for (size_t k = 0; k < d && c->size > 0; k++) {
        size_t least = 0, most = 0;
        for (size_t i = 1; i < c->size; i++) {
            least = c->near[i * d + k] < c->near[least * d + k] ? i : least;
            most = c->near[i * d + k] > c->near[most * d + k] ? i : most;
        }
        FMB_TRY(add_from_crowd(c, least));
        FMB_TRY(add_from_crowd(c, most));
    }
    return FMB_OK;
}

/* Add vectors until all are in the span of the generators. */
static fmb_status add_vectors_off_the_span(crowd *c)
{
    for (size_t i = 0; i < c->size && c->f->rank < c->f->d; i++)
        if (fmb_facets_is_off_span(c->f, &c->v[i]))
            FMB_TRY(add_from_crowd(c, i));
    return FMB_OK;
}

static fmb_status send_all_to_facets(crowd *c)
{
    fmb_facets *f = c->f;
    f->mades = f->toucheds = 0;
    FMB_TRY(open_queues(c));
    for (uint32_t a = 0; a < f->slots; a++)
        if (f->facet[a].alive)
            FMB_TRY(fmb_facets_list(f, &f->made, &f->mades, &f->made_capacity, a));
    for (uint32_t i = 0; i < c->size; i++) {
        FMB_TRY(look_for_new_facet(c, i));
        FMB_TRY(fmb_run_poll(f->run));
    }
    return FMB_OK;
}

/* Make the first vector at facet a a generator; vectors at removed facets move on. Facets count as
 * rows. */
static fmb_status add_first_at_facet(crowd *c, uint32_t a)
{
    uint32_t i = c->at[a].first;
    c->at[a].first = c->next[i];
    FMB_TRY(fmb_run_poll(c->f->run));
    FMB_TRY(fmb_facets_add_beyond(c->f, &c->v[i], a));
    FMB_TRY(fmb_run_rows(c->f->run, c->f->alive));
    FMB_TRY(open_queues(c));
    for (size_t k = 0; k < c->f->seens; k++) {
        queue *q = &c->at[c->f->seen[k]];
        uint32_t next = q->first;
        *q = (queue){.first = NOBODY};
        while (next != NOBODY) {
            i = next;
            next = c->next[i];
            FMB_TRY(look_for_new_facet(c, i));
        }
    }
    return FMB_OK;
}

/* The next facet with a waiting vector, from the one whose turn it is; NOBODY: there is none. */
static uint32_t find_facet_waited_at(const crowd *c)
{
    for (size_t k = 0; k < c->slots; k++) {
        uint32_t a = (uint32_t)((c->turn + k) % c->slots);
        if (c->at[a].first != NOBODY)
            return a;
    }
    return NOBODY;
}

fmb_status fmb_facet_crowd_go_on(fmb_facet_crowd *c, bool *done)
{
    fmb_status st = FMB_OK;
    do {
        uint32_t a = find_facet_waited_at(c);
        *done = a == NOBODY;
        if (!*done) {
            st = add_first_at_facet(c, a);
            c->turn = a + 1;
        }
    } while (st == FMB_OK && !*done && !fmb_run_is_slice_over(c->f->run));
    return st;
}

void fmb_facet_crowd_close(fmb_facet_crowd *c)
{
    if (!c)
        return;
    fmb_mem *mem = c->f->num.mem;
    fmb_mem_put(mem, c->near, c->size * c->f->d, sizeof *c->near);
    fmb_mem_put(mem, c->next, c->size, sizeof *c->next);
    fmb_mem_put(mem, c->at, c->capacity, sizeof *c->at);
    fmb_mem_put(mem, c, 1, sizeof *c);
}

fmb_status fmb_facet_crowd_open(fmb_facets *f, const fmb_vec *v, size_t size, size_t t,
                                fmb_facet_crowd **out)
{
    fmb_mem *mem = f->num.mem;
    crowd *c = *out = fmb_mem_zero(mem, 1, sizeof *c);
    if (!c)
        return fmb_mem_status(mem);
    *c = (crowd){.f = f, .v = v, .size = size, .t = t};
    c->near = fmb_mem_get(mem, size * f->d, sizeof *c->near);
    c->next = fmb_mem_get(mem, size, sizeof *c->next);
    FMB_TRY(c->near && c->next ? FMB_OK : fmb_mem_status(mem));
    scale_vectors(c);
    FMB_TRY(add_outermost_vectors(c));
    FMB_TRY(add_vectors_off_the_span(c));
    return send_all_to_facets(c);
}

fmb_status fmb_facets_add_all(fmb_facets *f, const fmb_vec *v, size_t size, size_t t)
{
    fmb_facet_crowd *c;
    bool done = false;
    fmb_status st = fmb_facet_crowd_open(f, v, size, t, &c);
    while (st == FMB_OK && !done)
        st = fmb_facet_crowd_go_on(c, &done);
    fmb_facet_crowd_close(c);
    return st;
}
