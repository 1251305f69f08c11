/* sum.h: signs of sums of integers times rationals, in time nearly linear in their length.
 *
 * The rationals are *weights*, numerator over denominator, used in many sums: the multipliers of a
 * claim in a sum for each column, a point in a sum for each row. Weights whose denominators have
 * much in common share one: they are put into groups, in the order of their denominators, and a
 * group is extended as long as a common denominator makes none of its weights more than twice as
 * long. A sum within a group is one of integers; groups are added by halves, so that long numbers
 * meet long ones. Nothing is cancelled.
 *
 * Source of the latter: the product tree, Bernstein 2008, Fast multiplication and its applications,
 * section 12.
 */
#ifndef FMB_PROOF_SUM_H
#define FMB_PROOF_SUM_H

#include "num/integers.h"
#include "num/vec.h"
#include "proof/evidence/guard.h"

typedef struct fmb_fractions {
    fmb_mem *mem;
    const fmb_poll *poll;
    fmb_integers num, den; /* weight i is num[i] / den[group[i]] after fmb_fractions_share */
    size_t *group;         /* [size] */
    size_t size;
} fmb_fractions;

/* n weights 0/0, which the caller fills in: num[i] over den[i] > 0, in lowest terms or not. Errors:
 * MEMORY, LIMIT. The caller must call fmb_fractions_clear even then. */
fmb_status fmb_fractions_init(fmb_fractions *w, size_t n, fmb_mem *mem, const fmb_poll *poll);
void fmb_fractions_clear(fmb_fractions *w);
/* Put the weights into groups. Errors: MEMORY, LIMIT, and the status of poll; here and below. */
fmb_status fmb_fractions_share(fmb_fractions *w);

/* Entry k of a vector (NULL: 1) times a weight, a summand of the sum of a column. */
typedef struct fmb_product {
    size_t column, group; /* group: of the weight */
    const fmb_vec *val;
    size_t k, weight;
} fmb_product;

/* Sort by column, and by group within a column. */
void fmb_products_sort(fmb_product *p, size_t n);
/* The sign of the sum of n products, whose groups ascend. */
fmb_status fmb_products_sign(const fmb_fractions *w, const fmb_product *p, size_t n, int *sign);

#endif
