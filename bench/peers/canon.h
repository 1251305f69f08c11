/* canon.h: one canonical text for each polyhedron, whatever its description. */
#ifndef FMB_PEERS_CANON_H
#define FMB_PEERS_CANON_H

#include <fmb/fmb.h>

/* The rows of the projection on all variables, which are the same for equal sets, one a line,
 * sorted. "empty" if there is no solution. The caller frees it. */
char *canonical_text(const fmb_system *s);

/* Like canonical_text, for an irredundant list with explicit equalities: rows, or generators, where
 * the row x <= t is the vertex x / t or a ray, and x = 0 a line. Inequalities are unique up to
 * equalities, so are vertices and rays up to lines. */
char *canonical_list(const fmb_system *s, bool generators);

#endif
