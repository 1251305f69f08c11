/* normals.h: verdicts on pairs in the plane and in space, exactly: the normals of frame/flat.h in
 * doubles, and in integers (wide.h) where doubles are not certain.
 */
#ifndef FMB_PAIR_NORMALS_H
#define FMB_PAIR_NORMALS_H

#include <fmb/pair.h>

/* Of good frames. False, and *out is as it was: another dimension, numbers too far apart, all in
 * one plane, or the faces alone meet (FMB_CONTACT_OPEN) and something moves. Nothing is allocated.
 */
bool fmb_exact_box_decide(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                          fmb_verdict *out);

#endif
