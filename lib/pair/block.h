/* block.h: a block of pairs of one kind, collected until a kernel answers all of them at once. */
#ifndef FMB_PAIR_BLOCK_H
#define FMB_PAIR_BLOCK_H

#include "pair/kernels/pair_kernels.h"

/* Always inlined, so that constant arguments of the caller are constants inside. */
#define FMB_BLOCK_INLINE static inline __attribute__((always_inline))

typedef struct fmb_block {
    double number[FMB_BLOCK_MOST_ROWS * FMB_BLOCK_MOST_LANES];
    size_t pair[FMB_BLOCK_MOST_LANES]; /* number of the pair in each lane */
    int lanes;                         /* lanes in use */
} fmb_block;

/* For a single pair in a block of two lanes: both hold it, written with one store. */
typedef double fmb_block_twice __attribute__((vector_size(16), aligned(8), may_alias));

/* alone is constant here and below. */
FMB_BLOCK_INLINE void fmb_block_write(double *to, bool alone, double x)
{
    if (alone)
        *(fmb_block_twice *)to = (fmb_block_twice){x, x};
    else
        *to = x;
}

/* Copy n numbers, width apart; returns the place of the next one. n is constant, at most 9. */
FMB_BLOCK_INLINE double *fmb_block_copy(double *to, int width, bool alone, int n,
                                        const double *from)
{
#pragma GCC unroll 9
    for (int j = 0; j < n; j++, to += width)
        fmb_block_write(to, alone, from[j]);
    return to;
}

FMB_BLOCK_INLINE double *fmb_block_differ(double *to, int width, bool alone, int n, const double *a,
                                          const double *b)
{
#pragma GCC unroll 3
    for (int j = 0; j < n; j++, to += width)
        fmb_block_write(to, alone, b[j] - a[j]);
    return to;
}

/* Fill one lane; dim is constant. */
FMB_BLOCK_INLINE void fmb_block_fill(double *to, int width, bool alone, int dim, const fmb_frame *p,
                                     const fmb_frame *q, bool moves, bool boxes)
{
    static const double still[3] = {0};
    const double *a = p->speed ? p->speed : still, *b = q->speed ? q->speed : still;
    to = fmb_block_differ(to, width, alone, dim, p->origin, q->origin);
    to = fmb_block_copy(to, width, alone, dim * dim, p->axes);
    to = fmb_block_copy(to, width, alone, dim * dim, q->axes);
    if (moves)
        to = fmb_block_differ(to, width, alone, dim, a, b);
    if (!boxes)
        return;
    to = fmb_block_copy(to, width, alone, dim, p->origin);
    to = fmb_block_copy(to, width, alone, dim, q->origin);
    if (!moves)
        return;
    to = fmb_block_copy(to, width, alone, dim, a);
    fmb_block_copy(to, width, alone, dim, b);
}

/* dim is that of both frames, which have all axes. */
FMB_BLOCK_INLINE void fmb_block_load(double *to, int width, bool alone, const fmb_frame *p,
                                     const fmb_frame *q, bool moves, bool boxes)
{
    bool swap = p->shape == FMB_SIMPLEX && q->shape == FMB_CUBOID;
    const fmb_frame *first = swap ? q : p, *second = swap ? p : q;
    if (p->dim == 2)
        fmb_block_fill(to, width, alone, 2, first, second, moves, boxes);
    else
        fmb_block_fill(to, width, alone, 3, first, second, moves, boxes);
}

/* Put pair i = (p, q) into the next lane of a block of that width; with origins and speeds if boxes
 * are wanted. */
static inline void fmb_block_put(fmb_block *b, int width, const fmb_frame *p, const fmb_frame *q,
                                 bool moves, bool boxes, size_t i)
{
    double *to = b->number + b->lanes;
    b->pair[b->lanes++] = i;
    fmb_block_load(to, width, false, p, q, moves, boxes);
}

/* Put the only pair (p, q) into all lanes, one or two, of an empty block; one counts as taken. */
static inline void fmb_block_put_alone(fmb_block *b, int width, const fmb_frame *p,
                                       const fmb_frame *q, bool moves, bool boxes)
{
    b->pair[0] = 0;
    b->lanes = 1;
    if (width == 1)
        fmb_block_load(b->number, 1, false, p, q, moves, boxes);
    else
        fmb_block_load(b->number, 2, true, p, q, moves, boxes);
}

/* Put pair i = (p, q) of frames by edges, of any number of axes, into the next lane of a block;
 * rows of missing axes stay as they were. */
static inline void fmb_block_put_flat(fmb_block *b, int width, const fmb_frame *p,
                                      const fmb_frame *q, size_t i)
{
    static const double still[3] = {0};
    const double *from = p->speed ? p->speed : still, *to = q->speed ? q->speed : still;
    const int dim = p->dim, row = width * dim;
    double *number = b->number + b->lanes;
    b->pair[b->lanes++] = i;
    for (int j = 0; j < dim; j++) {
        number[j * width] = q->origin[j] - p->origin[j];
        number[(1 + 2 * dim) * row + j * width] = to[j] - from[j];
    }
    for (int j = 0; j < p->naxes * dim; j++)
        number[row + j * width] = p->axes[j];
    for (int j = 0; j < q->naxes * dim; j++)
        number[(1 + dim) * row + j * width] = q->axes[j];
}

#endif
