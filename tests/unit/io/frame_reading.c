/* frame_reading.c: see frame_reading.h. */
#include "frame_reading.h"

#include <criterion/criterion.h>

frame_reading frame_reading_begin(const char *text, size_t size, const fmb_reader *how)
{
    frame_reading a = {.in = fmemopen((void *)(uintptr_t)text, size, "rb")};
    cr_assert(a.in);
    cr_assert_eq(fmb_frame_reader_new(a.in, how, &a.r), FMB_OK);
    return a;
}

void frame_reading_end(frame_reading *a)
{
    fmb_frame_reader_free(a->r);
    fclose(a->in);
}

const fmb_frame_line *frame_reading_next(const frame_reading *a)
{
    const fmb_frame_line *line = NULL;
    fmb_where w = {0};
    fmb_status st = fmb_frame_reader_next(a->r, &line, &w);
    cr_assert_eq(st, FMB_OK, "%ld:%ld: %s", w.line, w.column, w.text);
    return line;
}

void expect_rationals(mpq_t *a, const char *const *want, int n)
{
    mpq_t q;
    mpq_init(q);
    for (int i = 0; i < n; i++) {
        mpq_set_str(q, want[i], 10);
        cr_expect(mpq_equal(a[i], q), "number %d is not %s", i, want[i]);
    }
    mpq_clear(q);
}
