/* bars.h: how far ahead fmb is to be, and how far it is: in projections against the established
 * libraries, against PPLite, and against the best of its own ways by itself; in vertices and hulls
 * against each library. */
#ifndef FMB_PEERS_BARS_H
#define FMB_PEERS_BARS_H

#include "report.h"

/* Are both of one side: fmb's own ways, or peers that one bar is against? */
bool bars_same_side(peer_question question, const peer *a, const peer *b);
/* Of projections, vertices or hulls. Names whatever is below its bar. */
void bars_print(const report *r);

#endif
