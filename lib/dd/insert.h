/* insert.h: inserts one row into a cone; see cone.h. */
#ifndef FMB_DD_INSERT_H
#define FMB_DD_INSERT_H

#include "dd/cone.h"
#include "dd/edges.h"

/* Supports in planes, the layout of the kernels. */
typedef struct fmb_support_planes {
    uint64_t *word; /* [capacity] */
    size_t capacity;
    fmb_planes planes;
    bool ready;
} fmb_support_planes;

/* Per thread: data for finding the neighbours of a ray (adjacent.c). */
typedef struct fmb_adjacency {
    fmb_support_planes near;  /* of all rays with enough zeros in common with this ray */
    uint64_t *far, *far_rest; /* bit sets: rays of large, of rest with too few in common */
    size_t far_capacity, far_rest_capacity;
    uint32_t *nearby; /* the rays of near */
    size_t nearby_capacity;
    uint64_t *joint; /* the union of two supports */
    size_t joint_capacity;
    uint32_t *found; /* adjacent rays */
    size_t founds, found_capacity;
} fmb_adjacency;

/* Several threads (insert_workers.c). */
typedef struct fmb_insertion_workers fmb_insertion_workers;

/* The insertion of a row that separates rays. Pairs are formed ray by ray of the smaller side. */
typedef struct fmb_insertion {
    bool running;
    size_t entry; /* entry of vectors: the value in the row */
    size_t row;
    size_t rays;   /* before the insertion */
    uint32_t *ray; /* [ray_capacity] the larger side, the smaller side, those with value 0 */
    int8_t *sign;  /* [sign_capacity] of each ray in the row, scratch */
    size_t ray_capacity, sign_capacity;
    size_t small, large, zeros;
    bool small_is_positive;
    size_t next;                         /* of the smaller side */
    fmb_support_planes large_side, rest; /* supports; rest: of the smaller side, then of value 0 */
    bool by_edges;
    fmb_ray_edges edges; /* by_edges: of simple rays of the smaller side, */
    uint32_t *crowded;   /* and those of the larger side that are not simple */
    size_t crowds, crowded_capacity;
    fmb_support_planes crowd; /* their supports */
    fmb_adjacency pairs;
    fmb_insertion_workers *workers; /* or NULL */
} fmb_insertion;

/* Entry number `entry` of each vector is its value in the row. Errors: MEMORY, LIMIT. */
fmb_status fmb_insertion_begin(fmb_cone *c, size_t row, size_t entry);
/* Continue until the row is inserted or c->made reaches `most`. Errors: MEMORY, LIMIT. */
fmb_status fmb_insertion_run(fmb_cone *c, uint64_t most);
void fmb_insertion_clear(fmb_insertion *s, fmb_mem *mem);

/* Insert a row that is not zero on line number i. Errors: MEMORY, LIMIT. */
fmb_status fmb_insertion_break_line(fmb_cone *c, size_t row, size_t entry, size_t i);

/* ---- insert_pair.c --------------------------------------------------------------------------- */

/* Replace ray number `at`, which exists, by the ray of the pair a, b. Errors: MEMORY, LIMIT. */
fmb_status fmb_insertion_combine(const fmb_cone *c, size_t at, uint32_t a, uint32_t b,
                                 fmb_num *num);
/* Add sign to negatives[] of each remaining row in which the ray is negative. */
void fmb_cone_count_negatives(const fmb_cone *c, const fmb_vec *v, int sign, size_t *negatives);
/* How much the ray adds to c->made. */
uint64_t fmb_ray_price(const fmb_vec *v);
/* Work of making a ray of so many entries (fmb_run_count). */
static inline uint64_t fmb_work_of_ray(const fmb_vec *v, size_t width)
{
    return 50 + fmb_vec_work(v, width);
}

/* ---- insert_workers.c ------------------------------------------------------------------------ */

/* By several threads where that pays, for each ray: set the entry behind the coordinates to the
 * value in a row (of lines, too); find the edges if the ray is simple. Errors: MEMORY, LIMIT. */
fmb_status fmb_insertion_set_values(fmb_cone *c, const fmb_vec *row);
fmb_status fmb_insertion_find_edges(fmb_cone *c);
void fmb_insertion_dismiss_workers(fmb_insertion *s, fmb_mem *mem);

/* ---- insert_batch.c -------------------------------------------------------------------------- */

/* Are there threads, and enough work for them? */
bool fmb_insertion_is_work_for_workers(const fmb_cone *c);
/* Combine the next pairs as if one after another, until c->made reaches `most` or one batch is
 * done. Errors: MEMORY, LIMIT. */
fmb_status fmb_insertion_run_workers(fmb_cone *c, uint64_t most);

#endif
