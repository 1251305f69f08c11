/* combine_rows.h: the two questions behind all claims: to which row do multipliers combine rows,
 * and on which side of a row does a point lie? Rows are taken as the user wrote them.
 */
#ifndef FMB_PROOF_COMBINE_ROWS_H
#define FMB_PROOF_COMBINE_ROWS_H

#include "proof/evidence/evidence.h"
#include "proof/sum.h"
#include "system/system_private.h"

/* The inequality that multipliers shall prove, times sign: form <= value of a claim, whose form is
 * its variable, if it has one, plus its terms; otherwise the row; otherwise 0 <= 0. */
typedef struct fmb_combination_goal {
    const fmb_claim *claim; /* or NULL */
    size_t row;             /* or SIZE_MAX */
    int sign;
} fmb_combination_goal;

/* The sum of rows times multipliers, minus the goal, is left.x <= right: *wrong = the first
 * variable whose coefficient in left is not 0, or -1; *right = the sign of right. The caller has
 * checked all indices. Errors: MEMORY, LIMIT, and the status of poll; here and below. */
fmb_status fmb_combine_rows(const fmb_system *s, const fmb_sparse_vector *multipliers,
                            const fmb_combination_goal *goal, fmb_mem *mem, const fmb_poll *poll,
                            int *wrong, int *right);

/* A point or a direction, laid out by variable to be compared with rows. */
typedef struct fmb_place {
    fmb_fractions x; /* nonzero coordinates, then the factor of right sides: -1 or 0 */
    size_t *of;      /* [dim] 1 + the number of the variable's coordinate; 0: none */
    size_t dim;
    fmb_product *product; /* [capacity] scratch */
    size_t capacity;
} fmb_place;

fmb_status fmb_place_init(fmb_place *p, size_t dim, fmb_mem *mem);
void fmb_place_clear(fmb_place *p, fmb_mem *mem);
/* Store x, with indices below dim. The caller must call fmb_place_take even after an error. */
fmb_status fmb_place_put(fmb_place *p, const fmb_sparse_vector *x, bool direction, fmb_mem *mem,
                         const fmb_poll *poll);
void fmb_place_take(fmb_place *p, const fmb_sparse_vector *x);
/* The sign of a.x - b for row a.x REL b; for a direction, that of a.x. */
fmb_status fmb_place_side(fmb_place *p, const fmb_sysrow *row, int *side);

/* The sign of form(x) - value, or of form(x) where value is NULL. */
fmb_status fmb_form_sign(const fmb_claim *q, const fmb_sparse_vector *x, mpq_srcptr value,
                         fmb_mem *mem, const fmb_poll *poll, int *sign);

#endif
