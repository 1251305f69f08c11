/* mem.h: every byte the library allocates goes through an fmb_mem.
 *
 * Invariants: used is the sum of all live blocks and charges [bytes], used <= limit when limit > 0.
 * The limbs of GMP integers come from GMP's allocator; their owners charge them here, so that a
 * limit on bytes includes them. A charge to a mem within another one counts there as well: so one
 * limit holds for the sum of a query's workspace, evidence and results.
 */
#ifndef FMB_BASE_MEM_H
#define FMB_BASE_MEM_H

#include <fmb/base.h>

/* A status that never leaves the library: a limit was reached, and fmb_run knows which. */
#define FMB_LIMIT ((fmb_status)100)

/* Return from the calling function with the status of the call if that is not FMB_OK: for functions
 * that return a status and have nothing to clean up. */
#define FMB_TRY(call)                                                                              \
    do {                                                                                           \
        fmb_status fmb_tried = (call);                                                             \
        if (fmb_tried != FMB_OK)                                                                   \
            return fmb_tried;                                                                      \
    } while (0)
/* Make the call only if st is still FMB_OK, and put its status into st: for functions that have
 * something to clean up. */
#define FMB_THEN(st, call)                                                                         \
    do {                                                                                           \
        if ((st) == FMB_OK)                                                                        \
            (st) = (call);                                                                         \
    } while (0)

typedef struct fmb_mem {
    fmb_alloc alloc;
    size_t used, peak, limit; /* [bytes]; limit 0 = none */
    bool over;                /* the last failure was the limit, not the allocator */
    struct fmb_mem *within;   /* the outer mem that counts all this too, or NULL */
} fmb_mem;

/* hook NULL: malloc. */
void fmb_mem_init(fmb_mem *m, const fmb_alloc *hook, size_t limit);

/* count * size bytes; NULL on failure: see fmb_mem_status. 0 bytes get a block, too. */
void *fmb_mem_get(fmb_mem *m, size_t count, size_t size);
void *fmb_mem_zero(fmb_mem *m, size_t count, size_t size);
/* Resize a block of old * size bytes to count * size; NULL on failure, the old block then stays. */
void *fmb_mem_grow(fmb_mem *m, void *p, size_t old, size_t count, size_t size);
void fmb_mem_put(fmb_mem *m, void *p, size_t count, size_t size);

/* Macros whose value is a status: p, whose type gives `size`, becomes the block or NULL. */
#define FMB_GET(m, p, count)                                                                       \
    ((p) = fmb_mem_get(m, count, sizeof *(p)), (p) ? FMB_OK : fmb_mem_status(m))
#define FMB_GET_ZERO(m, p, count)                                                                  \
    ((p) = fmb_mem_zero(m, count, sizeof *(p)), (p) ? FMB_OK : fmb_mem_status(m))

/* Grow *p, an array of *capacity elements, by doubling to hold at least need; the macro takes the
 * size of an element from the type of p, and calls only if there is no room. */
fmb_status fmb_mem_reserve(fmb_mem *m, void **p, size_t *capacity, size_t need, size_t size);
#define FMB_RESERVE(m, p, capacity, need)                                                          \
    ((need) <= *(capacity) ? FMB_OK                                                                \
                           : fmb_mem_reserve(m, (void **)(p), capacity, need, sizeof **(p)))

/* Charge bytes allocated elsewhere; false, and nothing charged, if the limit forbids it. */
bool fmb_mem_charge(fmb_mem *m, size_t bytes);
void fmb_mem_refund(fmb_mem *m, size_t bytes);
/* Charge bytes that are allocated already, even beyond the limit. */
void fmb_mem_take(fmb_mem *m, size_t bytes);

/* Until fmb_mem_leave, everything that m holds counts in outer too; what m holds already is charged
 * to outer even beyond its limit. */
void fmb_mem_enter(fmb_mem *m, fmb_mem *outer);
void fmb_mem_leave(fmb_mem *m);

/* After a failure: FMB_LIMIT if it was the limit, else FMB_ERR_MEMORY. */
fmb_status fmb_mem_status(const fmb_mem *m);

/* A copy of a string, released with fmb_mem_put_text. */
char *fmb_mem_text(fmb_mem *m, const char *s);
void fmb_mem_put_text(fmb_mem *m, char *s);

#endif
