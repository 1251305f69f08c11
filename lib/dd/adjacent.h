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

/* A new row. */
void fmb_adjacency_start(fmb_adjacency *p);
void fmb_adjacency_clear(fmb_adjacency *p, fmb_mem *mem);

/* The rays of the larger side that are adjacent to ray a of the smaller one, into found. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_find_adjacent(fmb_cone *c, uint32_t a, size_t *found);

#endif
