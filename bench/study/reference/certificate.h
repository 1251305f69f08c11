/* certificate.h: what proves where two frames meet, and the check of it in whole numbers.
 *
 * The frames A and B have a point together iff M z = h for some z = (c of A, c of B, t), each
 * within its frame, 0 <= t <= 1: M = [axes of A, - axes of B, speed of A - speed of B], h = origin
 * of B - origin of A. Each coordinate of the world has a unit of its own, a power of 2, in which
 * all its numbers are whole. So a point z = Z / N or a direction y of whole numbers is checked by
 * products and sums alone. Where it comes from does not matter.
 */
#ifndef FMB_STUDY_CERTIFICATE_H
#define FMB_STUDY_CERTIFICATE_H

#include <fmb/gmp.h>
#include <fmb/pair.h>

#include "study/draw/pairs.h"

enum { STUDY_MEETING_MOST_COLUMNS = 2 * STUDY_PAIR_MOST_DIM + 1 };

/* M z = h. */
typedef struct study_meeting {
    fmb_shape shape[2];
    int dim, columns;
    int from[3]; /* columns from[f] ... from[f + 1] - 1 are c of frame f; any more is t */
    int unit[STUDY_PAIR_MOST_DIM]; /* exponents of 2 */
    mpz_t m[STUDY_PAIR_MOST_DIM][STUDY_MEETING_MOST_COLUMNS], h[STUDY_PAIR_MOST_DIM];
    mpz_t origin[STUDY_PAIR_MOST_DIM], speed[STUDY_PAIR_MOST_DIM]; /* of A */
    mpz_t price[STUDY_MEETING_MOST_COLUMNS], sum, most, part;      /* of the check at hand */
} study_meeting;

void study_meeting_init(study_meeting *s);
void study_meeting_clear(study_meeting *s);
/* False if they are no cuboids and simplices of that many dimensions. Numbers are finite. */
bool study_meeting_load(study_meeting *s, const fmb_frame *p, const fmb_frame *q);

/* Is Z / N a common point, of relative interiors if the contact is open? Z has `columns` numbers.
 */
bool study_meeting_has_point(study_meeting *s, fmb_contact contact, mpz_t *z, const mpz_t n);
/* Is Z / N a common point, and is the point of the world there as near to x in every coordinate, up
 * to rounding of x +- near? */
bool study_meeting_is_near(study_meeting *s, mpz_t *z, const mpz_t n, const double *x, double near);
/* Does the direction y, of dim numbers, show that there is none? */
bool study_meeting_has_none(study_meeting *s, fmb_contact contact, mpz_t *y);

/* A linear form on z, (w0 + w z) 2^unit. */
typedef struct study_form {
    mpz_t w0, w[STUDY_MEETING_MOST_COLUMNS];
    int unit;
} study_form;

void study_form_init(study_form *f);
void study_form_clear(study_form *f);
/* sign (1 or -1) times coordinate i of the common point, or unknown j. */
void study_form_of_coordinate(study_form *f, const study_meeting *s, int i, int sign);
void study_form_of_unknown(study_form *f, const study_meeting *s, int j, int sign);

/* Is `end` the least double that no common point exceeds with that form? The point Z / N shows that
 * it cannot be less, prices y / K of the rows that nothing exceeds it. N, K > 0. */
bool study_meeting_has_end(study_meeting *s, const study_form *f, mpz_t *z, const mpz_t n, mpz_t *y,
                           const mpz_t k, double end);

/* x = *whole 2^*exponent, *whole odd or 0. */
void study_split(double x, double *whole, int *exponent);

#endif
