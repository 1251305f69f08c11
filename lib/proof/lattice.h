/* lattice.h: do generators span all that rows allow? Told from which lie on which alone.
 *
 * A finite set R of linear forms on a space of finite dimension, and a finite set G of vectors
 * there on which no form is negative. Of a set f of these vectors let
 *
 *     P(f) = {y in span f : r(y) >= 0 for all r in R},  f&r = {g in f : r(g) = 0},
 *     S(f) = the sets f&r that are neither empty nor f,  L(f) = the maximal members of S(f).
 *
 * f is *closed* of dimension 1 if it is one vector and some form is positive there; of dimension
 * j > 1 if L(f) has at least two members, each closed of dimension j - 1, and every other member of
 * S(f) lies in at least two of them. ("Every ridge of a facet lies in two facets.")
 *
 * THEOREM. If f is closed of dimension j and dim span f <= j, then dim span f = j, P(f) contains no
 * line, and P(f) = cone f; and the faces of P(f) but 0 are the cones of the sets met on the way.
 *
 * PROOF by induction on j. j = 1: P(f) = {s g : s r(g) >= 0}, r(g) > 0. Let j > 1, m = f&r in L(f).
 * r vanishes on span m, not on span f, so dim span m <= j - 1; by induction, equal. So dim span f
 * is j, span m is the part of span f where r = 0, and P(m) that of P(f): a facet. On a line in P(f)
 * all forms vanish, so it would lie in P(m), which has none.
 *   Let q be in the relative interior of P(f): all forms that do not vanish on f are positive
 * there. It is enough to show that such q are in cone f, which is closed. For u in a complement of
 * q in span f, u != 0, let h(u) = max -r(u)/r(q) over these forms, and e(u) = u + h(u) q: where the
 * half-plane of q and u leaves P(f). h is continuous. Let D be the set of all directions u, on a
 * sphere of dimension j - 2, with e(u) in some P(m), m in L(f). D is closed and not empty. Suppose
 * that some direction is missing.
 *   If j = 2 there are two directions. Two members of L(f) are single vectors, which do not lie in
 * the same one: or they were multiples of each other, and on the same forms. So none is missing.
 *   If j > 2, the sphere is connected, and finitely many great spheres of two dimensions less do
 * not separate it; so the border of D contains a u such that e(u) is in no face of P(f) of
 * dimension less than j - 2. D is closed: e(u) is in some P(m). If it is in the relative interior
 * of that, all directions near u are in D: no border. Else it is in the relative interior of a face
 * of P(m) of dimension j - 2, n = {y in P(m) : r'(y) = 0}, which is cone(m&r') as P(m) = cone m.
 * f&r' contains m&r', is in S(f), and is not m. It is in L(f), or in two members of L(f): so n is
 * in P(m') for another member m'. The forms that vanish at e(u) vanish on n: near e(u), P(f) is n
 * times a cone in the plane, whose two edges are the facets P(m) and P(m'). So all directions near
 * u are in D: no border.
 *   So e(u) and e(-u) are in cone f, and so is their sum, (h(u) + h(-u)) q. The factor is not
 * negative, as -r(u) + r(u) = 0; were it 0, then e(u) = -e(-u) would span a line. So q is in
 * cone f. As all of the boundary is in some P(m), there are no other facets; faces are faces of
 * these. END
 *
 * That is a walk through all faces. Many sets can be seen to be closed without it. Let j > 1, R' be
 * some of the forms, and T(g) the set of those of R' that are 0 at g. f is *simple* of dimension j
 * if it is not empty and for each g in f, T(g) has j - 1 members, and for each r in T(g) there is
 * an h in f with T(h) = T(g) without r, plus a form that is not in T(g).
 *
 * THEOREM 2. If f is simple of dimension j and dim span f <= j, then dim span f = j, P(f) contains
 * no line, and P(f) = cone f. So in theorem 1 a set may be simple instead of closed; but its faces
 * are then not met.
 *
 * PROOF. Let g be in f, and h(r) that h for r in T(g). At h(r) all forms of T(g) are 0 but r, which
 * is positive. So the j - 1 vectors h(r) are independent modulo the common zeros of T(g) in span f.
 * Among these is g, and not 0: a form that is 0 at some h(r) and not in T(g) is positive there. So
 * dim span f = j, and g and the h(r) are a basis: each y in span f is s g plus the sum of t(r)
 * h(r), and t(r) >= 0 for all r if y is in P'(f), the set where the forms of R' are not negative;
 * P(f) is a part of that. Let e be the sum of R'. It is positive on f, and >= 0 on P'(f). If it is
 * 0 at y in P'(f), all of R' is; then t(r) = 0 for all r, y = s g, and s e(g) = 0, so y = 0. So
 * P'(f) contains no line. Scale f so that e is 1 there. Suppose that some y in P'(f) is not in cone
 * f; it may be scaled so that e(y) = 1. There is a linear form c with c >= 0 on f and c(y) < 0. Let
 * g be one of f where c is least. As s and all t(r) add up to e(y) = 1, c(y) = s c(g) + sum t(r)
 * c(h(r)) >= c(g) >= 0. Contradiction. END
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
    bool *excludes;  /* [forms] faces on which it is 0 are not looked at below */
    size_t wanted;   /* each other face ... */
    uint64_t *shows; /* [wanted][words] ... must meet all of these sets */
} fmb_lattice;

typedef enum fmb_lattice_end {
    FMB_LATTICE_CLOSED = 0,
    FMB_LATTICE_OPEN,    /* the set is not closed of that dimension */
    FMB_LATTICE_UNSHOWN, /* it is, but some face does not meet what it must */
    FMB_LATTICE_LARGE    /* there is too much to look at */
} fmb_lattice_end;

/* Is the set `top` closed of that dimension? face[words]: with UNSHOWN, one of those of least
 * dimension. Errors: MEMORY, LIMIT, and what poll says. */
fmb_status fmb_lattice_check(const fmb_lattice *l, const uint64_t *top, size_t dimension,
                             fmb_mem *mem, const fmb_poll *poll, fmb_lattice_end *end,
                             uint64_t *face);

#endif
