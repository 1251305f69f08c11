/* evidence.h: inside of an fmb_evidence: claims about one system and the numbers that prove them.
 *
 * Multipliers count for the rows as the user wrote them (fmb_sysrow.val / den). Points and rays are
 * dense. Every claim owns its numbers; unused ones are empty (NULL, size 0).
 */
#ifndef FMB_PROOF_EVIDENCE_H
#define FMB_PROOF_EVIDENCE_H

#include <fmb/gmp.h>
#include <fmb/proof.h>

#include "base/mem.h"

/* A sparse list of rationals with an index each: multipliers by row, terms by variable. */
typedef struct fmb_sparse {
    size_t *index;
    mpq_t *value;
    size_t size, capacity;
} fmb_sparse;

typedef struct fmb_claim {
    fmb_claim_kind kind;
    size_t row;             /* REDUNDANT, EQUALITY, IRREDUNDANT; else SIZE_MAX */
    int var;                /* BOUND, UNBOUNDED; else -1 */
    fmb_side side;          /* BOUND, UNBOUNDED */
    fmb_rel rel;            /* BOUND: LE attained, LT not; IMPLIED: the relation */
    mpq_t value;            /* BOUND: the end; IMPLIED: the right side */
    fmb_sparse terms;       /* IMPLIED: left side, by variable */
    fmb_sparse multipliers; /* by row; >= 0 unless the row is an equality */
    fmb_sparse reverse;     /* IMPLIED with EQ, REDUNDANT equality: the same for the reverse */
    mpq_t *point;           /* [dim] or NULL */
    mpq_t *ray;             /* [dim] or NULL */
} fmb_claim;

struct fmb_evidence {
    fmb_mem mem; /* under a limit each claim's limbs are charged, once the next claim begins */
    int dim;     /* of the system */
    size_t rows; /* of the system */
    fmb_claim *claim;
    size_t claims, claim_capacity;
};

fmb_status fmb_evidence_new(int dim, size_t rows, const fmb_alloc *hook, fmb_evidence **out);
fmb_status fmb_evidence_copy(const fmb_evidence *e, fmb_evidence **out);
/* Forget all claims. */
void fmb_evidence_reset(fmb_evidence *e);
/* Append an empty claim of that kind; *out points to it until the next call. If filling it fails,
 * fmb_evidence_drop_last takes it back. */
fmb_status fmb_evidence_claim(fmb_evidence *e, fmb_claim_kind kind, fmb_claim **out);
void fmb_evidence_drop_last(fmb_evidence *e);
/* Append (index, value) to a list; zero values are skipped. An index comes at most once in a list:
 * the caller's promise. */
fmb_status fmb_evidence_push(fmb_evidence *e, fmb_sparse *list, size_t index, const mpq_t value);
/* Give the claim a point or ray of dim zeros: *slot is claim->point or claim->ray. */
fmb_status fmb_evidence_vector(fmb_evidence *e, mpq_t **slot);

#endif
