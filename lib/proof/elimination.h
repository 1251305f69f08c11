/* elimination.h: the rows that remain when variables are eliminated, computed for the checker.
 *
 * Let R be the inequalities of a system, E its equalities, and V a set of variables. W is the cone
 * of all u >= 0, a number for each row of R, for which numbers w for E exist such that V vanishes
 * from u R + w E. A point of the other variables is the image of a solution if and only if it
 * satisfies u R + w E for all u in W and all such w (lemma of Farkas, or of Motzkin if rows are
 * strict; u R + w E is strict if u is positive on a strict row). It suffices that it does so for
 * all extreme rays u of W, one w each, and for all sums w E without variables of V: W contains no
 * line, so each u is a sum of extreme rays; and if u R is strict, so it is for one of these.
 *
 * This file keeps a list of vectors u of W, each with its row, and of sums of equalities.
 *
 * INVARIANT. The list contains all extreme rays of W, up to factors; its equalities span all sums w
 * E without variables of V; W is the part u >= 0 of a space given by at most t equations, where t
 * is the number of variables eliminated by pairing.
 *
 * PROOF. At first V is empty, W is all u >= 0, and its extreme rays are the rows. Let v be the next
 * variable. If some equality e contains v, multiples of e remove v from all other rows: W does not
 * change, and e leaves the span. Otherwise no sum of the equalities contains v, so the coefficient
 * f(u) of v is a linear form on the space of W, and the new cone W' is its part where f = 0: one
 * equation more. Let z be an extreme ray of W', and F the least face of W with z: the members of W
 * that are positive only where z is. F meets f = 0 in the multiples of z, so its dimension is 1 or
 * 2. If it is 1, z is an extreme ray of W, in the list, with f = 0. If it is 2, F has two extreme
 * rays, f is positive on one and negative on the other, and z is a sum of multiples of these: a
 * pair. So vectors with f = 0 and all pairs contain all extreme rays. Some may be dropped: an
 * extreme ray of the part u >= 0 of a space with t equations is positive in at most t + 1 places;
 * and if z in W' is positive in a proper subset of the places where u in W' is, then u - s z is in
 * W' for some s > 0, so u is no extreme ray. If both are positive in the same places and one is an
 * extreme ray, they are multiples of each other: one suffices. END
 *
 * Sources: Kohler 1967, Projections of convex polyhedral sets; Chernikov 1960.
 */
#ifndef FMB_PROOF_ELIMINATION_H
#define FMB_PROOF_ELIMINATION_H

#include "num/integers.h"
#include "proof/evidence/guard.h"

/* a.x REL b. */
typedef struct fmb_eliminated_row {
    fmb_integers z; /* [dim + 1] a, then b */
    fmb_rel rel;
    uint64_t *of; /* [words] the inequalities of the system where u is positive, by number */
} fmb_eliminated_row;

typedef struct fmb_elimination {
    const fmb_system *s;
    fmb_mem *mem;
    const fmb_poll *poll;
    size_t dim, words;
    fmb_eliminated_row *row; /* [rows] */
    size_t rows, capacity;
    size_t pairings;
    uint64_t work, most; /* rough count of operations, and its limit */
    mpz_t p, q;          /* scratch */
} fmb_elimination;

/* Begin with the rows of s, which outlives it. Errors: MEMORY, LIMIT, and the status of poll; here
 * and below. The caller must call fmb_elimination_close even after an error. */
fmb_status fmb_elimination_open(fmb_elimination *e, const fmb_system *s, uint64_t most,
                                fmb_mem *mem, const fmb_poll *poll);
void fmb_elimination_close(fmb_elimination *e);

/* Eliminate another variable. *done false: beyond e->most, and no further call is allowed. */
fmb_status fmb_elimination_go_on(fmb_elimination *e, size_t variable, bool *done);

#endif
