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

/* The rows that every kernel reads; dim is constant. */
static inline __attribute__((always_inline)) double *
fmb_block_fill(double *to, int width, int dim, const fmb_frame *p, const fmb_frame *q, bool moves)
{
    const double still[3] = {0};
    double shift[3], drift[3];
    for (int j = 0; j < dim; j++)
        shift[j] = q->origin[j] - p->origin[j];
    to = fmb_block_copy(to, width, dim, shift);
    to = fmb_block_copy(to, width, dim * dim, p->axes);
    to = fmb_block_copy(to, width, dim * dim, q->axes);
    if (!moves)
        return to;
    const double *a = p->speed ? p->speed : still, *b = q->speed ? q->speed : still;
    for (int j = 0; j < dim; j++)
        drift[j] = b[j] - a[j];
    return fmb_block_copy(to, width, dim, drift);
}

/* Put pair i = (p, q) into the next lane of a block of that width; with places and speeds if boxes
 * are wanted. dim is that of both frames, which have all axes. */
static inline void fmb_block_put(fmb_block *b, int width, const fmb_frame *p, const fmb_frame *q,
                                 bool moves, bool boxes, size_t i)
{
    bool swap = p->shape == FMB_SIMPLEX && q->shape == FMB_CUBOID;
    const fmb_frame *first = swap ? q : p, *second = swap ? p : q;
    int dim = p->dim;
    double *to = b->number + b->lanes;
    b->pair[b->lanes++] = i;
    to = dim == 2 ? fmb_block_fill(to, width, 2, first, second, moves)
                  : fmb_block_fill(to, width, 3, first, second, moves);
    for (int j = 0; boxes && j < 2 * dim; j++, to += width)
        *to = j < dim ? first->origin[j] : second->origin[j - dim];
    for (int j = 0; boxes && moves && j < 2 * dim; j++, to += width) {
        const double *speed = j < dim ? first->speed : second->speed;
        *to = speed ? speed[j % dim] : 0;
    }
}

#endif
