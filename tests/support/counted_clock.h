/* counted_clock.h: a clock that goes by what is asked of it, and not by time.
 *
 * A program that links it has a clock_gettime of its own. Until a test winds it up it shows the
 * time. From then on the monotonic clock, and that of a thread's processor time with it, stands
 * still, but for a second at each reading: so a limit of n seconds is one of n readings, on however
 * busy a machine, and something can be done at a certain reading. A query reads it when it begins,
 * when it ends, for each event, and wherever it asks whether to go on, if it has a limit of time.
 */
#ifndef FMB_TEST_COUNTED_CLOCK_H
#define FMB_TEST_COUNTED_CLOCK_H

#include <stddef.h>

/* So long that no query reads the clock so often [s]: it asks whether to go on, and does. */
#define COUNTED_FOREVER 1e15

/* Readings are counted from 0, and from 1 on each is a second later. At number `at` (0: never),
 * before it is given, act(self) is called, by whoever reads. */
void counted_clock_start(size_t at, void (*act)(void *self), void *self);
/* Readings since counted_clock_start. */
size_t counted_clock_readings(void);
/* So many seconds later, without a reading. */
void counted_clock_pass(size_t seconds);
/* Back to the time. */
void counted_clock_stop(void);

#endif
