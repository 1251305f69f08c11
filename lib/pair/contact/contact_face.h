/* contact_face.h: the contact points of two frames after the second was moved out of the first. */
#ifndef FMB_PAIR_CONTACT_CONTACT_FACE_H
#define FMB_PAIR_CONTACT_CONTACT_FACE_H

#include <fmb/pair.h>

/* For frames that are bodies (bodies.h) and do not move; normal as in <fmb/pair.h>. Sets faces[2]
 * and points[FMB_PAIR_MOST_POINTS][dim]; returns the number of points. */
int fmb_contact_face(const fmb_frame *p, const fmb_frame *q, const double *normal, uint8_t *faces,
                     double *points);

#endif
