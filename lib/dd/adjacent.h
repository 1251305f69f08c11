/* adjacent.h: finds the rays on one side of a row that are adjacent to a ray on the other side.
 *
 * Two extreme rays of a cone are adjacent if they span a face of dimension 2. With rank the rank of
 * the rows, both are then zero in at least rank - 2 common rows, and no third ray is zero in all of
 * these (Fukuda and Prodon 1996, Proposition 7). If one of the two is zero in only rank - 1 rows,
 * these are independent, and sharing rank - 2 of them suffices.
 *
 * In terms of supports: the union of the two is small, and no third support lies inside it. These
 * are Kohler's and Chernikov's tests of histories, and the same kernels compute them.
 */
#ifndef FMB_DD_ADJACENT_H
#define FMB_DD_ADJACENT_H

#include "dd/insert.h"
#include "trace/team.h"

void fmb_adjacency_clear(fmb_adjacency *p, fmb_mem *mem);

/* The two sides of the row being inserted. */
fmb_edge_sides fmb_adjacency_sides(const fmb_cone *c);
/* For a new row: gather the supports of the larger side and decide whether edges are used. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_adjacency_begin(fmb_cone *c);
/* Gather the supports of all other rays: before threads find neighbours. Errors: MEMORY, LIMIT. */
fmb_status fmb_adjacency_gather_rest(fmb_cone *c);

/* p->found = the rays of the larger side that are adjacent to number i of the smaller one; memory
 * and work count for `run`. Errors: MEMORY, LIMIT. */
fmb_status fmb_find_adjacent(fmb_cone *c, fmb_run *run, fmb_adjacency *p, size_t i);

/* ---- insert_workers.c: threads that work on the rays of a cone ---------------------------------
 *
 * Work is divided into chunks that are the same for any number of threads. The new rays of a chunk
 * are charged to its own memory until the cone takes them over. */

enum {
    FMB_INSERTION_CHUNKS = 16,
    FMB_INSERTION_CHUNK_RAYS = 64 /* of the smaller side, in a chunk */
};

typedef struct fmb_insertion_chunk {
    size_t first, rays; /* on the smaller side */
    fmb_adjacency pairs;
    uint32_t *found; /* neighbours of its rays, one ray after another, */
    size_t founds, found_capacity;
    size_t end[FMB_INSERTION_CHUNK_RAYS]; /* each ray's end there */
    size_t at;                            /* the place of its first new ray */
    fmb_num num;
    size_t *negatives;    /* [m] to be added to those of the cone for its new rays */
    size_t bytes;         /* of its new rays */
    size_t before, after; /* bytes of its part of all rays before and after the job */
} fmb_insertion_chunk;

struct fmb_insertion_workers {
    fmb_team team;
    size_t m;
    const fmb_vec *row; /* the row whose values are computed */
    fmb_insertion_chunk chunk[FMB_INSERTION_CHUNKS];
};

/* A job of the cone for each chunk; hires threads first if there are none. Errors: MEMORY, LIMIT,
 * those of jobs. */
fmb_status fmb_insertion_do(fmb_cone *c, fmb_team_job job);
fmb_status fmb_insertion_hire(fmb_cone *c);

#endif
