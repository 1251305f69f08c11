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

void fmb_adjacency_clear(fmb_adjacency *p, fmb_mem *mem);

/* The two sides of the row. */
fmb_edge_sides fmb_adjacency_sides(const fmb_cone *c);
/* A new row: gather the supports of the larger side; will it be done by edges? Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_adjacency_begin(fmb_cone *c);
/* And those of all other rays: before threads look for neighbours. Errors: MEMORY, LIMIT. */
fmb_status fmb_adjacency_gather_rest(fmb_cone *c);

/* The rays of the larger side that are adjacent to number i of the smaller one, into p->found;
 * memory and counts are those of the run. Errors: MEMORY, LIMIT. */
fmb_status fmb_find_adjacent(fmb_cone *c, fmb_run *run, fmb_adjacency *p, size_t i);

#endif
