/* exact_contact.h: the depth of one pair that meets, exactly. */
#ifndef FMB_PAIR_CONTACT_EXACT_CONTACT_H
#define FMB_PAIR_CONTACT_EXACT_CONTACT_H

#include "base/mem.h"
#include "frame/frame_private.h"

/* f: two good frames of dim 2 or 3, of at most dim axes each, that meet. *depth is the double
 * nearest to the least depth, normal[dim] its direction, rounded. Errors: MEMORY. */
fmb_status fmb_exact_contact(const fmb_frame *f, fmb_mem *mem, double *depth, double *normal);

#endif
