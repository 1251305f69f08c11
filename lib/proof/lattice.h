/* lattice.h: do generators span all that rows allow? Decided from their incidences alone.
 *
 * Let R be a finite set of linear forms on a space of finite dimension, and G a finite set of
 * vectors there on which no form is negative. For a set f of these vectors let
 *
 *     P(f) = {y in span f : r(y) >= 0 for all r in R},  f&r = {g in f : r(g) = 0},
 *     S(f) = the sets f&r that are neither empty nor f,  L(f) = the maximal members of S(f).
 *
 * f is *closed* of dimension 1 if it is one vector and some form is positive there; of dimension j
 * > 1 if L(f) has at least two members, each closed of dimension j - 1, and every other member of
 * S(f) lies in at least two of them. ("Every ridge of a facet lies in two facets.")
 *
 * If f is closed of dimension j and dim span f <= j, then P(f) = cone f: docs/theory.md, theorem 8,
 * with the proof. Checking this visits all faces. Many sets can be proved closed without that
 * (theorem 9): let j > 1, R' be some of the forms, and T(g) the set of those of R' that are 0 at g.
 * f is *simple* of dimension j if it is not empty and for each g in f, T(g) has j - 1 members, and
 * for each r in T(g) there is an h in f with T(h) = T(g) without r, plus a form that is not in
 * T(g).
 *
 * Source: the closed graph of facets of Jones, Kerrigan and Maciejowski 2004, Equality set
 * projection; faces as sets: Kaibel and Pfetsch 2002, Computing the face lattice of a polytope from
 * its vertex-facet incidences.
 */
#ifndef FMB_PROOF_LATTICE_H
#define FMB_PROOF_LATTICE_H

#include "proof/evidence/guard.h"

/* Sets of vectors are bits, `words` words each. */
typedef struct fmb_lattice {
    size_t words;
    size_t forms;
    uint64_t *zero;  /* [forms][words] where the form is 0 */
    bool *excludes;  /* [forms] faces on which it is 0 are not tested below */
    size_t wanted;   /* each other face ... */
    uint64_t *shows; /* [wanted][words] ... must meet all of these sets */
} fmb_lattice;

typedef enum fmb_lattice_end {
    FMB_LATTICE_CLOSED = 0,
    FMB_LATTICE_OPEN,    /* the set is not closed of that dimension */
    FMB_LATTICE_UNSHOWN, /* it is, but some face misses one of the sets `shows` */
    FMB_LATTICE_LARGE    /* there are too many faces */
} fmb_lattice_end;

/* Is the set `top` closed of that dimension? With UNSHOWN, face[words] is one of the faces of least
 * dimension that miss a set. Errors: MEMORY, LIMIT, and the status of poll. */
fmb_status fmb_lattice_check(const fmb_lattice *l, const uint64_t *top, size_t dimension,
                             fmb_mem *mem, const fmb_poll *poll, fmb_lattice_end *end,
                             uint64_t *face);

#endif
