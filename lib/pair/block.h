/* block.h: pairs of one kind, waiting until a kernel can answer all of them at once. */
#ifndef FMB_PAIR_BLOCK_H
#define FMB_PAIR_BLOCK_H

#include "pair/kernels.h"

typedef struct fmb_block {
    double number[FMB_BLOCK_MOST_ROWS * FMB_BLOCK_MOST_LANES];
    size_t pair[FMB_BLOCK_MOST_LANES]; /* which pair each lane is */
    int lanes;                         /* that are taken */
} fmb_block;

/* Put pair i = (p, q) into the next lane of a block of that width; with places and speeds if boxes
 * are wanted. dim is that of both frames, which have all axes. */
static inline void fmb_block_put(fmb_block *b, int width, const fmb_frame *p, const fmb_frame *q,
                                 bool moves, bool boxes, size_t i)
{
    int dim = p->dim, all = dim * dim;
    double *to = b->number + b->lanes;
    b->pair[b->lanes++] = i;
    for (int j = 0; j < dim; j++, to += width)
        *to = q->origin[j] - p->origin[j];
    for (int j = 0; j < all; j++, to += width)
        *to = p->axes[j];
    for (int j = 0; j < all; j++, to += width)
        *to = q->axes[j];
    for (int j = 0; moves && j < dim; j++, to += width)
        *to = (q->speed ? q->speed[j] : 0) - (p->speed ? p->speed[j] : 0);
    for (int j = 0; boxes && j < 2 * dim; j++, to += width)
        *to = j < dim ? p->origin[j] : q->origin[j - dim];
    for (int j = 0; boxes && moves && j < 2 * dim; j++, to += width) {
        const double *speed = j < dim ? p->speed : q->speed;
        *to = speed ? speed[j % dim] : 0;
    }
}

#endif
