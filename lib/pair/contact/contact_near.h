/* contact_near.h: how far apart two bodies (bodies.h) are, and what hulls of many corners do, in
 * doubles that are proved.
 */
#ifndef FMB_PAIR_CONTACT_CONTACT_NEAR_H
#define FMB_PAIR_CONTACT_CONTACT_NEAR_H

#include "pair/contact/bodies.h"

/* How deep or how far apart: off by rounding alone. */
typedef struct fmb_pair_near {
    double length,
        normal[3];      /* of length 1, or 0 where frames touch that are apart (open contact) */
    double point[2][3]; /* of frames that are apart: the nearest of each */
    bool has_row;       /* and what fmb_contact_offset says is there: */
    double offset;
} fmb_pair_near;

/* Of frames that are apart: the distance, the normal, the nearest points, as <fmb/pair.h> promises
 * them. False: that is not certain. */
bool fmb_contact_distance(const fmb_frame *p, const fmb_frame *q, fmb_pair_near *out);

/* range[0] <= the distance <= range[1], in doubles that are close together unless it is certainly
 * more than `enough`. False: nothing is known. */
bool fmb_contact_range(const fmb_frame *p, const fmb_frame *q, double enough, double range[2]);

/* Do they meet? UNKNOWN: that is not certain. If *good, then how far or deep is asked for, too, and
 * *good becomes whether that is known. */
fmb_verdict fmb_contact_of_hulls(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                                 const fmb_hull_kernels *hulls, bool *good, fmb_pair_near *out);

/* b of a row normal.x <= b that holds for p, and normal.x >= b for q; NAN where none is known. */
double fmb_contact_offset(const fmb_frame *p, const fmb_frame *q, const double *normal);
/* The same where p goes as far as `low` along the normal, from its origin, and q from `high` on,
 * off by 64 u reach at most; all over 2^exponent. */
double fmb_contact_offset_between(const fmb_frame *p, const double *normal, double low, double high,
                                  double reach, int exponent);

#endif
