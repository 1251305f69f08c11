/* insert_workers.h: threads that work on the rays of a cone, for the files that give them work.
 *
 * Work is divided into chunks that are the same for any number of threads. What a chunk makes is
 * counted in its own memory until the cone takes it over.
 */
#ifndef FMB_DD_INSERT_WORKERS_H
#define FMB_DD_INSERT_WORKERS_H

#include "dd/adjacent.h"
#include "trace/team.h"

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
