/* contact_face.h: where two frames touch once the second has moved out of the first. */
#ifndef FMB_PAIR_CONTACT_CONTACT_FACE_H
#define FMB_PAIR_CONTACT_CONTACT_FACE_H

#include <fmb/pair.h>

/* Frames that are bodies (bodies.h), that stand still, and their normal as
 * <fmb/pair.h> has it. faces[2], points[FMB_PAIR_MOST_POINTS][dim], and how many points. */
int fmb_contact_face(const fmb_frame *p, const fmb_frame *q, const double *normal, uint8_t *faces,
                     double *points);

#endif
