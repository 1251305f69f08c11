/* peak.h: the peak memory that a section of a process adds, as the kernel counts it. */
#ifndef FMB_PEERS_PEAK_H
#define FMB_PEERS_PEAK_H

#include <stddef.h>

/* The resident memory of this process [bytes], after freed memory was returned to the system;
 * resets the kernel's peak. */
size_t peak_begin(void);
/* The peak since peak_begin, minus its value `before` [bytes]; 0 where the kernel has no figure. */
size_t peak_end(size_t before);

#endif
