/* evidence.h: inside of an fmb_evidence: claims about one system and the numbers that prove them.
 *
 * Multipliers refer to the rows as the user wrote them (fmb_sysrow.val / den). Every claim owns its
 * numbers, without zeros. Claims are appended by one holder; once shared, they never change, so
 * handing out evidence copies nothing.
 */
#ifndef FMB_PROOF_EVIDENCE_H
#define FMB_PROOF_EVIDENCE_H

#include <stdatomic.h>

#include <fmb/gmp.h>
#include <fmb/proof.h>

#include "base/mem.h"

/* A sparse vector of rationals: multipliers are indexed by row, all others by variable. */
typedef struct fmb_sparse_vector {
    size_t *index;
    mpq_t *value;
    size_t size, capacity;
    bool mixed; /* the indices are not increasing */
} fmb_sparse_vector;

typedef struct fmb_claim {
    fmb_claim_kind kind;
    size_t row;              /* REDUNDANT, EQUALITY, IRREDUNDANT; else SIZE_MAX */
    int var;                 /* BOUND, UNBOUNDED: of this variable; else -1 */
    fmb_side side;           /* BOUND, UNBOUNDED */
    fmb_rel rel;             /* BOUND: LE attained, LT not; IMPLIED: the relation */
    mpq_t value;             /* BOUND: the end; IMPLIED: the right side */
    size_t value_bytes;      /* of its limbs, charged when the next claim begins */
    fmb_sparse_vector terms; /* IMPLIED, FOLLOWS; BOUND, UNBOUNDED without var: left side, by
                                variable; WHOLE: which variables, whatever the numbers */
    fmb_sparse_vector
        multipliers;           /* by row; >= 0 unless the row is an equality; FOLLOWS: by claim */
    fmb_sparse_vector reverse; /* IMPLIED with EQ, REDUNDANT equality: the same for the reverse */
    fmb_sparse_vector point; /* by variable: FEASIBLE, BOUND, IRREDUNDANT, CORNER; WHOLE: variables
                                that are eliminated, in the order of these numbers; or none */
    fmb_sparse_vector ray;   /* by variable: UNBOUNDED, CORNER */
} fmb_claim;

struct fmb_evidence {
    fmb_mem mem; /* limbs are charged to it, too */
    atomic_size_t holders;
    int dim;     /* of the system */
    size_t rows; /* of the system */
    fmb_claim *claim;
    size_t claims, claim_capacity;
};

fmb_status fmb_evidence_new(int dim, size_t rows, const fmb_alloc *hook, fmb_evidence **out);
/* Are both not NULL, and has s the dimension and number of rows that the claims are about? */
static inline bool fmb_evidence_fits(const fmb_evidence *e, const fmb_system *s)
{
    return e && s && e->dim == fmb_system_dim(s) && e->rows == fmb_system_rows(s);
}
/* [give] The same claims for one more holder, who releases them by fmb_evidence_free. */
fmb_evidence *fmb_evidence_share(fmb_evidence *e);
/* Remove all claims. */
void fmb_evidence_reset(fmb_evidence *e);
/* Append an empty claim of that kind; *out points to it until the next call. If filling it fails,
 * fmb_evidence_drop_last removes it. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_evidence_claim(fmb_evidence *e, fmb_claim_kind kind, fmb_claim **out);
void fmb_evidence_drop_last(fmb_evidence *e);
/* Append (index, value) to a list; zero values are skipped. The caller guarantees that an index
 * comes at most once in a list. */
fmb_status fmb_evidence_push(fmb_evidence *e, fmb_sparse_vector *list, size_t index,
                             const mpq_t value);
/* Append the nonzero entries of x[n], entry j with index at[j], or j if at is NULL. */
fmb_status fmb_evidence_push_all(fmb_evidence *e, fmb_sparse_vector *list, size_t n, const int *at,
                                 mpq_t *x);
/* Multiply all values by a nonzero factor. After a failure some are not yet multiplied. */
fmb_status fmb_evidence_scale(fmb_evidence *e, fmb_sparse_vector *list, const mpq_t factor);
/* Sort the list by index. */
void fmb_sparse_sort(fmb_sparse_vector *list);
/* The value of an index; NULL if it is not in the list. */
mpq_srcptr fmb_sparse_find(const fmb_sparse_vector *list, size_t index);

#endif
