/* edges.h: adjacency of simple rays without a test of each pair.
 *
 * With rank the rank of the rows, a ray is simple if it is zero in only rank - 1 rows. These are
 * independent; so the points that are zero in all of them but one form a face of dimension 2, an
 * edge, and each edge has two rays. Two simple rays are adjacent if and only if they share an edge.
 * The edges of the smaller side are put into a hash table, in which those of the larger side are
 * looked up: work for rays times rank instead of rays times rays.
 */
#ifndef FMB_DD_EDGES_H
#define FMB_DD_EDGES_H

#include "num/bitset.h"
#include "num/kernels/kernels.h"
#include "trace/run.h"

/* One edge of a simple ray: the rows in which it is zero, without one of them. */
typedef struct fmb_ray_edge {
    uint64_t key;  /* hash of these zeros */
    uint32_t gone; /* the bit of the zero left out */
    uint32_t end;  /* the ray on the larger side; FMB_NO_RAY: no simple ray */
} fmb_ray_edge;

#define FMB_NO_RAY UINT32_MAX

typedef struct fmb_ray_edges {
    size_t degree;      /* edges of a ray */
    fmb_ray_edge *edge; /* [rays of the smaller side][degree]; valid for simple rays */
    size_t edge_capacity;
    _Atomic uint32_t *table; /* [mask + 1] numbers of edges */
    size_t table_capacity, mask;
} fmb_ray_edges;

/* Supports: bit sets of the rows in which a ray is positive; and the two sides. */
typedef struct fmb_edge_sides {
    const uint64_t *support; /* ray i: [words] at support + i * words */
    size_t words, bits, rank;
    const uint32_t *small, *large; /* rays */
    size_t smalls, larges;
} fmb_edge_sides;

static inline bool fmb_is_simple(const fmb_edge_sides *of, uint32_t ray)
{
    size_t n = 0;
    for (size_t k = 0; k < of->words; k++)
        n += fmb_ones64(of->support[ray * of->words + k]);
    return n + of->rank == of->bits + 1;
}

/* Rays number `from` to `to` - 1 of a side. */
typedef struct fmb_side_part {
    size_t from, to;
} fmb_side_part;

/* Fill in the edges of simple rays. rank >= 2. Errors: MEMORY, LIMIT. */
fmb_status fmb_ray_edges_find(fmb_ray_edges *e, const fmb_edge_sides *of, fmb_run *run);
/* In steps: allocate; enter the edges of the smaller side; look up those of the larger one. The
 * last two go by parts, several at once. Errors: MEMORY, LIMIT; of the last two LIMIT. */
fmb_status fmb_ray_edges_begin(fmb_ray_edges *e, const fmb_edge_sides *of, fmb_run *run);
fmb_status fmb_ray_edges_enter(fmb_ray_edges *e, const fmb_edge_sides *of, fmb_side_part part,
                               fmb_run *run);
fmb_status fmb_ray_edges_look_up(fmb_ray_edges *e, const fmb_edge_sides *of, fmb_side_part part,
                                 fmb_run *run);
void fmb_ray_edges_clear(fmb_ray_edges *e, fmb_mem *mem);

#endif
