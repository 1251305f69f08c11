/* arena.h: memory that is handed out piece by piece and taken back all at once.
 *
 * Chunks survive a reset, so that the second query of a solver allocates nothing.
 */
#ifndef FMB_BASE_ARENA_H
#define FMB_BASE_ARENA_H

#include "base/mem.h"

typedef struct fmb_chunk fmb_chunk;

typedef struct fmb_arena {
    fmb_mem *mem;
    fmb_chunk *first, *current;
    size_t at; /* [bytes] used of current */
} fmb_arena;

void fmb_arena_init(fmb_arena *a, fmb_mem *mem);
/* count * size bytes, aligned to 16, not zeroed; NULL on failure: see fmb_mem_status. */
void *fmb_arena_get(fmb_arena *a, size_t count, size_t size);
#define FMB_ARENA_GET(a, p, count)                                                                 \
    ((p) = fmb_arena_get(a, count, sizeof *(p)), (p) ? FMB_OK : fmb_mem_status((a)->mem))
/* Make *p, an array of *capacity elements in the arena, hold at least need: it moves, and its old
 * memory is unused until the reset, so capacity doubles. Errors: MEMORY, LIMIT. */
fmb_status fmb_arena_reserve(fmb_arena *a, void **p, size_t *capacity, size_t need, size_t size);
#define FMB_ARENA_RESERVE(a, p, capacity, need)                                                    \
    ((need) <= *(capacity) ? FMB_OK                                                                \
                           : fmb_arena_reserve(a, (void **)(p), capacity, need, sizeof **(p)))
void fmb_arena_reset(fmb_arena *a);

/* A fill level of the arena; fmb_arena_rewind takes back what was handed out beyond it. */
typedef struct fmb_arena_place {
    fmb_chunk *current;
    size_t at;
} fmb_arena_place;

fmb_arena_place fmb_arena_tell(const fmb_arena *a);
void fmb_arena_rewind(fmb_arena *a, fmb_arena_place to);
/* Free the chunks behind the last one in use. */
void fmb_arena_trim(fmb_arena *a);
void fmb_arena_clear(fmb_arena *a);

#endif
