/* fmb/lift.h: images, sums and hulls of polyhedra, as projections of systems with more variables.
 *
 * Here a polyhedron is given by a system: its projection on the variables marked as kept
 * (fmb_system_is_kept), on all of them if none is marked. The system is called a lift of its
 * projection. Lifts are short where answers are long: they have about as many rows as the systems
 * they are made of. Each verb writes a lift of its answer, projects it (fmb_project), and hands out
 * both: the evidence of the answer is evidence about its lift, which can also be used in any other
 * query, and be part of the next lift.
 *
 * In a lift the variables of the answer come first, in the order in which the first polyhedron
 * keeps them; those of several polyhedra are matched by their names. The others are copies of the
 * variables of each, named after them.
 *
 * Source: Balas 1998, Disjunctive programming: properties of the convex hull of feasible points,
 * Discrete Applied Mathematics 89 (for the hull).
 */
#ifndef FMB_LIFT_H
#define FMB_LIFT_H

#include <fmb/generators.h>
#include <fmb/io.h>

#ifdef __cplusplus
extern "C" {
#endif

/* [give] The image of s under a map that is given by its graph: a system whose first variables
 * stand for the kept variables of s, in their order and under any names, and whose others are the
 * variables of the answer. Rows y = a.x + c make it a map; any other rows make it a relation, and
 * the image is then the set of all y to which some x is related. Strict rows stay strict. *out is
 * as from fmb_project; *lift, unless lift is NULL, the lift of the image. If the lift alone exceeds
 * max_bytes, *out has no row, *lift is NULL and the verdict UNKNOWN. Errors: ARG (also: a graph
 * with fewer variables than s keeps), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_image(fmb_solver *v, const fmb_system *s,
                                         const fmb_system *graph, fmb_system **lift,
                                         fmb_system **out, fmb_result *res);

/* [give] The Minkowski sum of s[0..n): all sums of a point of each; empty if one of them is. Strict
 * rows stay strict. *out and *lift as above. Errors: ARG (also: n is 0; polyhedra that do not keep
 * variables of the same names), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_sum(fmb_solver *v, const fmb_system *const *s, size_t n,
                                       fmb_system **lift, fmb_system **out, fmb_result *res);

/* [give] The closure of the convex hull of the union of s[0..n); empty ones are ignored. (The hull
 * itself need not be closed: that of a line and a point beside it is not.) Strict rows are taken
 * for <=, as this is a closure; they matter only for whether a polyhedron is empty. First each is
 * solved; if a limit ends that, *out has no row, *lift is NULL and the verdict UNKNOWN. The lift is
 * made of the nonempty ones. Errors: as above. */
FMB_API FMB_CHECKED fmb_status fmb_hull_union(fmb_solver *v, const fmb_system *const *s, size_t n,
                                              fmb_system **lift, fmb_system **out, fmb_result *res);

/* [give] A lift of the polyhedron that g generates: a variable for the weight of each vertex, ray
 * and line. Its kept variables have the names of those that `like` keeps, or x1, x2, ... if like is
 * NULL. Errors: ARG (NULL; like keeps another number), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_lift_generators(const fmb_generators *g, const fmb_system *like,
                                                   fmb_system **out);

/* ---- text ------------------------------------------------------------------------------------ */

/* [give] The graph of a map over the polyhedron of s, for fmb_image, from text: a line
 *
 *     NAME = FORM
 *
 * for each variable of the answer, where FORM is a form as in .fmb files, over the names of the
 * variables that s keeps. NAME may be one of these as well. Errors: PARSE (malformed, no such
 * variable, a name twice, no line; *where is filled, if not NULL), IO, MEMORY, ARG. */
FMB_API FMB_CHECKED fmb_status fmb_system_read_graph(FILE *in, const fmb_reader *how,
                                                     const fmb_system *s, fmb_system **out,
                                                     fmb_where *where);
FMB_API FMB_CHECKED fmb_status fmb_system_parse_graph(const char *text, size_t size,
                                                      const fmb_reader *how, const fmb_system *s,
                                                      fmb_system **out, fmb_where *where);

/* [give] A polyhedron in either representation: *g if the text has a line "V-representation" and
 * how->format is AUTO or INE, else *s; the other becomes NULL. Errors: as of fmb_system_read. */
FMB_API FMB_CHECKED fmb_status fmb_polyhedron_read(FILE *in, const fmb_reader *how, fmb_system **s,
                                                   fmb_generators **g, fmb_where *where);
FMB_API FMB_CHECKED fmb_status fmb_polyhedron_parse(const char *text, size_t size,
                                                    const fmb_reader *how, fmb_system **s,
                                                    fmb_generators **g, fmb_where *where);

#ifdef __cplusplus
}
#endif
#endif
