/* adjacent.h: which rays on the other side of a row are adjacent to one on this side.
 *
 * Two extreme rays of a cone are adjacent if they span a face of dimension 2. With rank the rank of
 * the rows, they then are zero together in rank - 2 rows at least; and no third ray is zero in all
 * of those (Fukuda and Prodon 1996, Proposition 7). Where one of the two is zero in rank - 1 rows
 * only, these are independent: then any two rays that share rank - 2 of them are adjacent.
 *
 * In terms of supports: the union of the two is small, and no third support lies inside it. These
 * are Kohler's and Chernikov's questions about histories, and the same kernels answer them.
 */
#ifndef FMB_DD_ADJACENT_H
#define FMB_DD_ADJACENT_H

#include "dd/insert.h"
#include "trace/team.h"

void fmb_adjacency_clear(fmb_adjacency *p, fmb_mem *mem);

/* The two sides of the row. */
fmb_edge_sides fmb_adjacency_sides(const fmb_cone *c);
/* A new row: gather the supports of the larger side; will it be done by edges? Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_adjacency_begin(fmb_cone *c);
/* And those of all other rays: before threads look for neighbours. Errors: MEMORY, LIMIT. */
fmb_status fmb_adjacency_gather_rest(fmb_cone *c);

/* The rays of the larger side that are adjacent to number i of the smaller one, into p->found;
 * memory and counts are those of the run. Errors: MEMORY, LIMIT. */
fmb_status fmb_find_adjacent(fmb_cone *c, fmb_run *run, fmb_adjacency *p, size_t i);

/* ---- insert_workers.c: threads that work on the rays of a cone ---------------------------------
 *
 * Work is divided into chunks that are the same for any number of threads. What a chunk makes is
 * counted in its own memory until the cone takes it over. */

enum {
    FMB_INSERTION_CHUNKS = 16,
    FMB_INSERTION_CHUNK_RAYS = 64 /* of the smaller side, in a chunk */
};

typedef struct fmb_insertion_chunk {
    size_t first, rays; /* on the smaller side */
    fmb_adjacency pairs;
    uint32_t *found; /* neighbours of its rays, one ray after another, */
    size_t founds, found_capacity;
    size_t end[FMB_INSERTION_CHUNK_RAYS]; /* up to there */
    size_t at;                            /* the place of its first new ray */
    fmb_num num;
    size_t *negatives;    /* [m] what its new rays add to those of the cone */
    size_t bytes;         /* that its new rays hold */
    size_t before, after; /* what its part of all rays held and holds [bytes] */
} fmb_insertion_chunk;

struct fmb_insertion_workers {
    fmb_team team;
    size_t m;
    const fmb_vec *row; /* whose values are taken */
    fmb_insertion_chunk chunk[FMB_INSERTION_CHUNKS];
};

/* A job for each chunk, of the cone. Threads are hired first if there are none. Errors: MEMORY,
 * LIMIT, those of jobs. */
fmb_status fmb_insertion_do(fmb_cone *c, fmb_team_job job);
fmb_status fmb_insertion_hire(fmb_cone *c);

#endif
