/* elimination.h: what rows a system leaves when variables are eliminated, as the judge does it.
 *
 * Let R be the inequalities of a system, E its equalities, and V a set of variables. W is the cone
 * of all u >= 0, a number for each of R, for which numbers w for E exist such that V vanishes from
 * u R + w E. A point of the other variables is the image of a solution if and only if it satisfies
 * u R + w E for all u in W and such w (the lemma of Farkas, or of Motzkin where rows are strict; u
 * R + w E is strict if u is positive on a strict row). It is enough if it does for all extreme rays
 * u of W, one w each, and for all sums w E from which V vanishes. For W contains no line, so each u
 * is a sum of extreme rays; and if u R is strict, one of these is.
 *
 * Here is a list of vectors u of W, each with its row, and of sums of equalities.
 *
 * INVARIANT. It contains all extreme rays of W, up to factors; its equalities span all sums w E
 * from which V vanishes; W is the part u >= 0 of a space given by at most t equations, where t
 * counts the variables that were eliminated by pairing.
 *
 * PROOF. At first V is empty, W is all u >= 0, and its extreme rays are the rows. Let v be the next
 * variable. If some equality e names v, multiples of it make v vanish from all other rows: W stays
 * what it was, and e is not in the span any more. Else no sum of the equalities names v, so that
 * the coefficient of v, f(u), is a linear form on the space of W, and the new W' is its part where
 * f = 0: one equation more. Let z be an extreme ray of W', and F the least face of W with z: its
 * members are those of W that are positive only where z is. F meets f = 0 in the multiples of z, so
 * its dimension is 1 or 2. If it is 1, z is an extreme ray of W, in the list, with f = 0. If it is
 * 2, F has two extreme rays, f is positive on one and negative on the other, and z is the sum of
 * multiples of these: a pair. So zeros of f and all pairs contain all extreme rays. Some pairs may
 * go: an extreme ray of the part u >= 0 of a space with t equations is positive in at most t + 1
 * places; and if z in W' is positive wherever u in W' is, and elsewhere, then u - s z is in W' for
 * some s > 0, so that u is no extreme ray. If both are positive in the same places and one is an
 * extreme ray, they are multiples of each other, and one is enough. END
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
    uint64_t work, most; /* operations so far, roughly; with more than that it is too much */
    mpz_t p, q;          /* scratch */
} fmb_elimination;

/* The rows of s, which outlives it. In any case fmb_elimination_close it. Errors: MEMORY, LIMIT,
 * and what poll says; here and below. */
fmb_status fmb_elimination_open(fmb_elimination *e, const fmb_system *s, uint64_t most,
                                fmb_mem *mem, const fmb_poll *poll);
void fmb_elimination_close(fmb_elimination *e);

/* Eliminate that variable, too. *done false: that is too much, and nothing more can be asked. */
fmb_status fmb_elimination_go_on(fmb_elimination *e, size_t variable, bool *done);

#endif
