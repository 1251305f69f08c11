/* sat_plain.h: separating axes as in the article's program, for comparison with ours: in world
 * coordinates, all corners are computed and projected on each axis, one axis after the other, with
 * a branch for each comparison. It costs what that program costs (article.h).
 *
 * Source: Baillehache 2020, whose SAT is that of Gottschalk, Lin and Manocha 1996. Written from the
 * description.
 */
#ifndef FMB_STUDY_SAT_PLAIN_H
#define FMB_STUDY_SAT_PLAIN_H

#include <fmb/frame.h>

/* Do the closed frames meet at some time? Doubles without error bounds: wrong on some pairs that
 * nearly touch. Both are in two or in three dimensions and have as many independent axes. */
bool study_sat_plain(const fmb_frame *p, const fmb_frame *q);

/* A frame as in the article's program, all numbers in one place: loading scattered ones costs a
 * quarter of a verdict on disjoint frames in the plane. */
typedef struct study_sat_record {
    fmb_shape shape;
    double origin[3], axes[9], speed[3];
} study_sat_record;

void study_sat_record_make(const fmb_frame *f, study_sat_record *out);
/* Like study_sat_plain, for records; one function for each case. If one moves, both do, perhaps
 * with speed 0. */
typedef bool study_sat_records_meet(const study_sat_record *p, const study_sat_record *q);
study_sat_records_meet *study_sat_program(int dim, bool move);

#endif
