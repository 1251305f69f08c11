/* contact_near.h: distances and depths of two bodies (bodies.h), also of hulls of many corners, in
 * doubles with proved error bounds.
 */
#ifndef FMB_PAIR_CONTACT_CONTACT_NEAR_H
#define FMB_PAIR_CONTACT_CONTACT_NEAR_H

#include "pair/contact/bodies.h"

/* A depth or a distance, exact up to rounding. */
typedef struct fmb_pair_near {
    double length,
        normal[3];      /* of length 1, or 0 where frames touch that are apart (open contact) */
    double point[2][3]; /* of frames that are apart: the nearest of each */
    bool has_row;       /* the result of fmb_contact_offset is known: */
    double offset;
} fmb_pair_near;

/* For frames that are apart: the distance, the normal, the nearest points, as <fmb/pair.h> promises
 * them. False: they could not be proved. */
bool fmb_contact_distance(const fmb_frame *p, const fmb_frame *q, fmb_pair_near *out);

/* Bounds range[0] <= distance <= range[1], which are close together unless the distance certainly
 * exceeds `enough`. False: nothing is known. */
bool fmb_contact_range(const fmb_frame *p, const fmb_frame *q, double enough, double range[2]);

/* What is asked of a pair of hulls. */
typedef enum fmb_hulls_asked {
    FMB_HULLS_VERDICT,
    FMB_HULLS_DEPTH,   /* of a pair that meets */
    FMB_HULLS_DISTANCE /* or the distance of one that is apart */
} fmb_hulls_asked;

/* Do the frames meet? UNKNOWN: that is not certain. Sets *good, unless it is NULL: is what else is
 * asked known? */
fmb_verdict fmb_contact_of_hulls(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                                 const fmb_hull_kernels *hulls, fmb_hulls_asked asked, bool *good,
                                 fmb_pair_near *out);

/* A number b with normal.x <= b on p and normal.x >= b on q; NAN if none is known. */
double fmb_contact_offset(const fmb_frame *p, const fmb_frame *q, const double *normal);
/* Like the function above, given that along the normal, from p's origin, p extends up to `low` and
 * q from `high` on, with errors of at most 64 u reach; all divided by 2^exponent. */
double fmb_contact_offset_between(const fmb_frame *p, const double *normal, double low, double high,
                                  double reach, int exponent);

#endif
