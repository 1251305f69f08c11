/* counted_clock.h: a clock that advances with its readings, not with time.
 *
 * A program that links it replaces clock_gettime. Until counted_clock_start it shows the time. From
 * then on the monotonic clock, and that of a thread's processor time with it, advances by one
 * second at each reading only: so a limit of n seconds is one of n readings, on however busy a
 * machine, and a test can act at a chosen reading. A query with a time limit reads the clock when
 * it begins, when it ends, for each event, and at each check whether to go on.
 */
#ifndef FMB_TEST_COUNTED_CLOCK_H
#define FMB_TEST_COUNTED_CLOCK_H

#include <stddef.h>

/* A limit [s] that no query reaches: it checks the clock, but never stops. */
#define COUNTED_FOREVER 1e15

/* Readings are counted from 0, and from 1 on each is a second later. Reading `at` (0: never) first
 * calls act(self), on the thread that reads. */
void counted_clock_start(size_t at, void (*act)(void *self), void *self);
/* Readings since counted_clock_start. */
size_t counted_clock_readings(void);
/* Advance the clock without a reading. */
void counted_clock_pass(size_t seconds);
/* Show the real time again. */
void counted_clock_stop(void);

#endif
