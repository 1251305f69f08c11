/* sat_plain.h: separating axes as the article's program has them, to be measured beside ours: in
 * the world, all corners added up and projected on each axis, one axis after the other, with a
 * branch for each comparison. What it costs is what the article's program costs (article.h).
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

/* A frame as the article's program has it, all numbers in one place: finding them costs a quarter
 * of a verdict on frames that are apart in the plane. */
typedef struct study_sat_record {
    fmb_shape shape;
    double origin[3], axes[9], speed[3];
} study_sat_record;

void study_sat_record_make(const fmb_frame *f, study_sat_record *out);
/* The same on such frames; a function for each case, as there. If any moves, all do, some with
 * speed 0. */
typedef bool study_sat_records_meet(const study_sat_record *p, const study_sat_record *q);
study_sat_records_meet *study_sat_program(int dim, bool move);

#endif
