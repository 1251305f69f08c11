/* peak.h: how much memory a stretch of a process adds at most, as the kernel sees it. */
#ifndef FMB_PEERS_PEAK_H
#define FMB_PEERS_PEAK_H

#include <stddef.h>

/* What this process holds now [bytes]; its peak begins anew. Memory that was freed goes back
 * first. */
size_t peak_begin(void);
/* The peak since then, less what was there [bytes]; 0 where the kernel does not tell. */
size_t peak_end(size_t before);

#endif
