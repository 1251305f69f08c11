/* frame_reading.h: pairs of frames, read from a text in memory. */
#ifndef FMB_TEST_FRAME_READING_H
#define FMB_TEST_FRAME_READING_H

#include <fmb/geometry.h>
#include <fmb/gmp.h>

/* A reader of a text, and its stream. */
typedef struct frame_reading {
    FILE *in;
    fmb_frame_reader *r;
} frame_reading;

/* The text must live as long. how may be NULL. */
frame_reading frame_reading_begin(const char *text, size_t size, const fmb_reader *how);
void frame_reading_end(frame_reading *a);
/* The next pair, which must be none that goes wrong; NULL at the end. */
const fmb_frame_line *frame_reading_next(const frame_reading *a);

/* a[n] are the numbers of these texts. */
void expect_rationals(mpq_t *a, const char *const *want, int n);

#endif
