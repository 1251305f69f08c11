/* frame_reader.h: the state of the reader of pairs of frames.
 *
 * Arrays and their rationals are reused from line to line: only a line longer than all before it
 * allocates.
 */
#ifndef FMB_IO_FRAMES_FRAME_READER_H
#define FMB_IO_FRAMES_FRAME_READER_H

#include <stdatomic.h>

#include "io/frames/json.h"
#include "io/frames/packed_lines.h"

/* Numbers in the order read: as the nearest doubles, and exactly where they are not doubles or
 * rationals are wanted. q[0..capacity) are initialised. */
typedef struct fmb_numbers {
    mpq_t *q;
    double *d;
    size_t n, capacity, d_capacity;
} fmb_numbers;

/* A body being read. */
typedef struct fmb_body_draft {
    fmb_numbers origin, axes, speed, coefficients; /* coefficients: of one row */
    fmb_shape shape;
    bool is_polytope, is_hull;
    int naxes;
    fmb_system *rows; /* or NULL */
} fmb_body_draft;

struct fmb_frame_reader {
    fmb_mem mem;
    fmb_alloc hook;
    fmb_reader how;
    FILE *in;
    bool owns_in; /* in was opened here, over text in memory */
    atomic_int cancel;
    char *text; /* the line, with its end */
    size_t size, capacity;
    char *id;
    size_t id_capacity;
    fmb_frame_line line;
    bool is_packed, is_over; /* binary input; it has ended, or had an error */
    fmb_packed_block block;
    uint32_t left; /* unread pairs of the block */
    /* of the line being read: */
    fmb_body_draft body[2], *now;
    int dim;            /* of the pair; 0: not known yet */
    bool exact;         /* all numbers so far are doubles */
    size_t digits;      /* of long numbers, roughly */
    size_t numbers;     /* their count */
    fmb_numbers *point; /* where the numbers of an array go */
    fmb_draft row;      /* of a polytope */
    fmb_rel rel;        /* its relation */
};

/* FMB_LIMIT once the reader was cancelled. */
static inline fmb_status fmb_frame_reader_poll(const fmb_frame_reader *r)
{
    return atomic_load_explicit(&r->cancel, memory_order_relaxed) ? FMB_LIMIT : FMB_OK;
}

/* Are numbers read as nearest doubles only, without rationals? */
static inline bool fmb_frame_reader_are_nearest(const fmb_frame_reader *r)
{
    return r->is_packed || r->how.nearest;
}

/* The number at c. Errors: PARSE. */
fmb_status fmb_frame_reader_value(fmb_frame_reader *r, fmb_cursor *c, mpq_t out);
/* Read an array of dim numbers and append them to *to. Errors: PARSE, MEMORY, LIMIT. */
fmb_status fmb_frame_reader_point(fmb_frame_reader *r, fmb_cursor *c, fmb_numbers *to);
/* Set the rationals from the doubles. Errors: MEMORY. */
fmb_status fmb_numbers_rationals(fmb_numbers *a, fmb_mem *mem);
void fmb_numbers_clear(fmb_numbers *a, fmb_mem *mem);

/* Read the next binary pair into r->body, if there is one. Errors: PARSE, MEMORY, LIMIT, IO. */
fmb_status fmb_frame_reader_fetch_packed(fmb_frame_reader *r, bool *found, fmb_where *where);

/* Read the body at c into *r->now. Errors: PARSE, MEMORY, LIMIT. */
fmb_status fmb_frame_reader_body(fmb_frame_reader *r, fmb_cursor *c);

#endif
