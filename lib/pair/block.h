/* block.h: pairs of one kind, waiting until a kernel can answer all of them at once. */
#ifndef FMB_PAIR_BLOCK_H
#define FMB_PAIR_BLOCK_H

#include "pair/kernels.h"

typedef struct fmb_block {
    double number[FMB_BLOCK_MOST_ROWS * FMB_BLOCK_MOST_LANES];
    size_t pair[FMB_BLOCK_MOST_LANES]; /* which pair each lane is */
    int lanes;                         /* that are taken */
} fmb_block;

/* n numbers, width apart; returns where the next one goes. n is constant, and never more than 9. */
static inline __attribute__((always_inline)) double *fmb_block_copy(double *to, int width, int n,
                                                                    const double *from)
{
#pragma GCC unroll 9
    for (int j = 0; j < n; j++, to += width)
        *to = from[j];
    return to;
}

static inline __attribute__((always_inline)) double *
fmb_block_differ(double *to, int width, int n, const double *a, const double *b)
{
#pragma GCC unroll 3
    for (int j = 0; j < n; j++, to += width)
        *to = b[j] - a[j];
    return to;
}

/* One lane; dim is constant. */
static inline __attribute__((always_inline)) void fmb_block_fill(double *to, int width, int dim,
                                                                 const fmb_frame *p,
                                                                 const fmb_frame *q, bool moves,
                                                                 bool boxes)
{
    static const double still[3] = {0};
    const double *a = p->speed ? p->speed : still, *b = q->speed ? q->speed : still;
    to = fmb_block_differ(to, width, dim, p->origin, q->origin);
    to = fmb_block_copy(to, width, dim * dim, p->axes);
    to = fmb_block_copy(to, width, dim * dim, q->axes);
    if (moves)
        to = fmb_block_differ(to, width, dim, a, b);
    if (!boxes)
        return;
    to = fmb_block_copy(to, width, dim, p->origin);
    to = fmb_block_copy(to, width, dim, q->origin);
    if (!moves)
        return;
    to = fmb_block_copy(to, width, dim, a);
    fmb_block_copy(to, width, dim, b);
}

/* Put pair i = (p, q) into the next lane of a block of that width; with places and speeds if boxes
 * are wanted. dim is that of both frames, which have all axes. */
static inline void fmb_block_put(fmb_block *b, int width, const fmb_frame *p, const fmb_frame *q,
                                 bool moves, bool boxes, size_t i)
{
    bool swap = p->shape == FMB_SIMPLEX && q->shape == FMB_CUBOID;
    const fmb_frame *first = swap ? q : p, *second = swap ? p : q;
    double *to = b->number + b->lanes;
    b->pair[b->lanes++] = i;
    if (p->dim == 2)
        fmb_block_fill(to, width, 2, first, second, moves, boxes);
    else
        fmb_block_fill(to, width, 3, first, second, moves, boxes);
}

#endif
