/* fmb/generators.h: polyhedra converted from rows to vertices, rays and lines, and back.
 *
 * A polyhedron is the set of all sums: a weighted mean of its vertices, a nonnegative combination
 * of its rays, any combination of its lines. If there are lines, "vertices" are points of its
 * minimal faces, one each.
 *
 * Source: Minkowski 1896, Weyl 1935; Schrijver 1986, Theory of linear and integer programming,
 * section 8.
 */
#ifndef FMB_GENERATORS_H
#define FMB_GENERATORS_H

#include <fmb/solve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The kind of a generator. */
typedef enum fmb_generator_kind { FMB_VERTEX = 0, FMB_RAY, FMB_LINE } fmb_generator_kind;

/* A list of generators of one dimension. */
typedef struct fmb_generators fmb_generators;

/* [give] No generators yet: the empty set. Errors: ARG (dim < 0, out NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_generators_new(int dim, const fmb_alloc *mem,
                                                  fmb_generators **out);
FMB_API void fmb_generators_free(fmb_generators *g);

/* Append x[dim]; a double means its exact binary value, and fmb_generators_add_q of <fmb/gmp.h>
 * takes rationals. Errors: ARG (NULL, a number that is not finite, no such kind), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_generators_add(fmb_generators *g, fmb_generator_kind kind,
                                                  const double *x);

/* What was wrong with the arguments of the last addition, in one line: "x[2] is nan"; "" if nothing
 * was, and for NULL. Valid until the next addition. */
FMB_API const char *fmb_generators_trouble(const fmb_generators *g);

/* Dimension; number of generators. Of NULL both are 0. */
FMB_API int fmb_generators_dim(const fmb_generators *g);
FMB_API size_t fmb_generators_size(const fmb_generators *g);
/* The kind of the i-th generator; VERTEX if there is none. */
FMB_API fmb_generator_kind fmb_generators_kind(const fmb_generators *g, size_t i);
/* Its coordinate j, the nearest double; 0 where there is none. Exactly:
 * fmb_generators_coordinate_q. */
FMB_API double fmb_generators_coordinate(const fmb_generators *g, size_t i, int j);
/* That coordinate as exact text (<fmb/base.h>), "0" if there is none. */
FMB_API size_t fmb_generators_coordinate_text(const fmb_generators *g, size_t i, int j, char *text,
                                              size_t size);
/* The generators first .. first + n at once: kind[n] and x[n][dim], the nearest doubles; each may
 * be NULL. Errors: ARG (no such generators). */
FMB_API FMB_CHECKED fmb_status fmb_generators_get(const fmb_generators *g, size_t first, size_t n,
                                                  fmb_generator_kind *kind, double *x);

/* [give] A minimal set of generators of s: all vertices, extreme rays and a basis of the lines;
 * vertices first, lines last. Strict rows are taken for <=: the closure of the set of solutions is
 * generated, unless that set is empty. *out is NULL if s is infeasible. If a limit was reached
 * (res->stop), *out has all lines, perhaps not all vertices and rays, and the verdict is FEASIBLE;
 * or *out is NULL, and the verdict may be UNKNOWN. There can be very many generators: set a limit;
 * max_rows counts live rays, too. Evidence proves the verdict. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_generate(fmb_solver *v, const fmb_system *s,
                                            fmb_generators **out, fmb_result *res);

/* [give] The convex hull of g: an irredundant system over x1, x2, ...; without a vertex the single
 * row 0 <= -1, and the verdict INFEASIBLE. *out is NULL if a limit was reached. There is no
 * evidence, and none is needed: a row is valid if no generator violates it, and a facet if the
 * generators on which it is tight span it; both are checked by evaluation. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_hull(fmb_solver *v, const fmb_generators *g, fmb_system **out,
                                        fmb_result *res);

#ifdef __cplusplus
}
#endif
#endif
