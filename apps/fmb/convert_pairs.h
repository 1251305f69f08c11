/* convert_pairs.h: pairs of frames in binary, for fmb convert. */
#ifndef FMB_CONVERT_PAIRS_H
#define FMB_CONVERT_PAIRS_H

#include "common/source.h"

/* Write the pairs of frames of the source to standard output, in binary; an exit code. */
int convert_pairs(const app_source *source, bool nearest);

#endif
