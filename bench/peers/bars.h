/* bars.h: the required and the measured lead of fmb: in projections over the established libraries,
 * over PPLite, and over the best of its own methods run alone; in vertices and hulls over each
 * library. */
#ifndef FMB_PEERS_BARS_H
#define FMB_PEERS_BARS_H

#include "report.h"

/* Are both on one side: fmb's own methods, or peers that share a bar? */
bool bars_same_side(peer_question question, const peer *a, const peer *b);
/* For projections, vertices or hulls. Names each side whose lead is below its bar. */
void bars_print(const report *r);

#endif
