/* mem.h: every byte the library allocates goes through an fmb_mem.
 *
 * Invariants: used is the sum of all live blocks and charges [bytes], used <= limit when limit > 0.
 * The limbs of GMP integers come from GMP's allocator; their owners charge them here, so that a
 * limit on bytes counts them too. What is charged to a mem that stands within another counts there
 * as well: so one limit holds for the sum of a query's workspace, evidence and results.
 */
#ifndef FMB_BASE_MEM_H
#define FMB_BASE_MEM_H

#include <fmb/base.h>

/* A status that never leaves the library: a limit was reached, and fmb_run knows which. */
#define FMB_LIMIT ((fmb_status)100)

/* What goes wrong in the call is what goes wrong in the function that makes it, which ends here:
 * for functions of a status that have nothing to clean up. */
#define FMB_TRY(call)                                                                              \
    do {                                                                                           \
        fmb_status fmb_tried = (call);                                                             \
        if (fmb_tried != FMB_OK)                                                                   \
            return fmb_tried;                                                                      \
    } while (0)
/* The call if all has gone well up to here, which st says, and how that went: where there is
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
    struct fmb_mem *within;   /* where all this counts too, or NULL */
} fmb_mem;

/* hook NULL means malloc. */
void fmb_mem_init(fmb_mem *m, const fmb_alloc *hook, size_t limit);

/* count * size bytes, or NULL: then fmb_mem_status says why. A request of 0 bytes gets a block. */
void *fmb_mem_get(fmb_mem *m, size_t count, size_t size);
void *fmb_mem_zero(fmb_mem *m, size_t count, size_t size);
/* A block of old * size bytes becomes one of count * size; on NULL the old one still stands. */
void *fmb_mem_grow(fmb_mem *m, void *p, size_t old, size_t count, size_t size);
void fmb_mem_put(fmb_mem *m, void *p, size_t count, size_t size);

/* The same by the type of p, which the block goes to (NULL if there is none): a status. */
#define FMB_GET(m, p, count)                                                                       \
    ((p) = fmb_mem_get(m, count, sizeof *(p)), (p) ? FMB_OK : fmb_mem_status(m))
#define FMB_GET_ZERO(m, p, count)                                                                  \
    ((p) = fmb_mem_zero(m, count, sizeof *(p)), (p) ? FMB_OK : fmb_mem_status(m))

/* Grow *p, an array of *capacity elements, to hold at least need, by doubling; the second knows
 * the size of an element by the type of p. */
fmb_status fmb_mem_reserve(fmb_mem *m, void **p, size_t *capacity, size_t need, size_t size);
#define FMB_RESERVE(m, p, capacity, need)                                                          \
    fmb_mem_reserve(m, (void **)(p), capacity, need, sizeof **(p))

/* Count bytes that come from elsewhere; false (nothing charged) if the limit forbids it. */
bool fmb_mem_charge(fmb_mem *m, size_t bytes);
void fmb_mem_refund(fmb_mem *m, size_t bytes);
/* Count bytes that are there already, whatever the limit. */
void fmb_mem_take(fmb_mem *m, size_t bytes);

/* From now on what m holds counts in outer too; what it holds already is counted whatever the limit
 * there. Until fmb_mem_leave. */
void fmb_mem_enter(fmb_mem *m, fmb_mem *outer);
void fmb_mem_leave(fmb_mem *m);

/* FMB_LIMIT or FMB_ERR_MEMORY, after a failure. */
fmb_status fmb_mem_status(const fmb_mem *m);

/* A copy of a string, released with fmb_mem_put_text. */
char *fmb_mem_text(fmb_mem *m, const char *s);
void fmb_mem_put_text(fmb_mem *m, char *s);

#endif
