/* sat_plain.h: separating axes as the article's program has them, to be measured beside ours: in
 * the world, all corners added up and projected on each axis, one axis after the other, with a
 * branch for each comparison. What it costs is what the article's program costs.
 *
 * Source: Baillehache 2020, whose SAT is that of Gottschalk, Lin and Manocha 1996. Written from the
 * description.
 */
#ifndef FMB_STUDY_SAT_PLAIN_H
#define FMB_STUDY_SAT_PLAIN_H

#include <fmb/frame.h>

/* Do the closed frames meet at some time? In plain doubles, without error bounds: wrong on some
 * that nearly touch. Both are in two or in three dimensions and have as many independent axes. */
bool study_sat_plain(const fmb_frame *p, const fmb_frame *q);

#endif
