/* binary_frames.c: pairs of frames in binary: round trips, truncated and malformed input. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "frame_reading.h"

static const double unit[4] = {1, 0, 0, 1}, near[2] = {0.1, -0.5}, slow[2] = {0x1p-1074, -3},
                    still[2] = {0, 0};
static const fmb_frame square = {FMB_CUBOID, 2, 2, near, unit, NULL},
                       mover = {FMB_SIMPLEX_BY_CORNERS, 2, 1, near, unit, slow},
                       place = {FMB_SIMPLEX, 2, 0, unit, NULL, still};

/* [give, free()] Four pairs in two blocks. */
static char *write_pairs(size_t *size)
{
    const fmb_frame p[4] = {square, square, place, place}, q[4] = {mover, mover, square, square};
    char *bytes = NULL;
    FILE *out = open_memstream(&bytes, size);
    cr_assert(out);
    cr_assert_eq(fmb_frame_pairs_write(out, 4, p, q), FMB_OK);
    fclose(out);
    return bytes;
}

static void expect_same(const fmb_frame *f, const fmb_frame *want)
{
    size_t d = (size_t)want->dim;
    cr_expect(f->shape == want->shape && f->dim == want->dim && f->naxes == want->naxes);
    cr_expect_arr_eq(f->origin, want->origin, d * sizeof(double));
    cr_expect(want->naxes == 0 ||
              memcmp(f->axes, want->axes, d * (size_t)want->naxes * sizeof(double)) == 0);
    cr_expect_eq(f->speed != NULL, want->speed == slow, "a speed of 0 is none");
    cr_expect(!f->speed || memcmp(f->speed, want->speed, d * sizeof(double)) == 0);
}

Test(binary_frames, round)
{
    size_t size;
    char *bytes = write_pairs(&size);
    frame_reading a = frame_reading_begin(bytes, size, NULL);
    for (long i = 1; i <= 4; i++) {
        const fmb_frame_line *line = frame_reading_next(&a);
        cr_assert(line);
        cr_expect(line->number == i && !line->id && line->are_doubles && line->dim == 2);
        expect_same(&line->frame[0], i <= 2 ? &square : &place);
        expect_same(&line->frame[1], i <= 2 ? &mover : &square);
        cr_expect_null(line->body[0].frame.origin);
        cr_assert_eq(fmb_frame_reader_rationals(a.r), FMB_OK);
        expect_rationals(line->body[i <= 2].frame.axes, (const char *[]){"1", "0"}, i <= 2 ? 2 : 0);
        cr_expect_eq(mpq_get_d(line->body[1].frame.origin[0]), 0.1);
        cr_expect_eq(line->body[1].frame.speed != NULL, i <= 2);
    }
    cr_expect_null(frame_reading_next(&a));
    cr_expect_null(frame_reading_next(&a));
    frame_reading_end(&a);
    free(bytes);
}

Test(binary_frames, of_single_precision)
{
    char bytes[32] = "fmbpairs\1\4\1\1";
    const float x[2] = {0.1f, -2};
    bytes[16] = bytes[28] = 1;
    char whole[32 + sizeof x];
    memcpy(whole, bytes, 32);
    memcpy(whole + 32, x, sizeof x);
    frame_reading a = frame_reading_begin(whole, sizeof whole, NULL);
    const fmb_frame_line *line = frame_reading_next(&a);
    cr_assert(line && line->dim == 1);
    cr_expect_eq(line->frame[0].origin[0], (double)0.1f);
    cr_expect_eq(line->frame[1].origin[0], -2);
    frame_reading_end(&a);
}

/* How many pairs are read before an error (*fault) or the end. */
static int count_pairs(const char *bytes, size_t size, bool *fault)
{
    const fmb_reader how = {.size = sizeof how, .max_bytes = 1000};
    frame_reading a = frame_reading_begin(bytes, size, &how);
    const fmb_frame_line *line = NULL;
    fmb_where w = {0};
    int n = 0;
    fmb_status st;
    while ((st = fmb_frame_reader_next(a.r, &line, &w)) == FMB_OK && line)
        n++;
    *fault = st != FMB_OK;
    cr_expect(st == FMB_OK ||
              (st == FMB_ERR_PARSE && w.line == n + 1 && strncmp(w.text, "expected ", 9) == 0));
    if (*fault)
        cr_expect(fmb_frame_reader_next(a.r, &line, &w) == FMB_OK && !line,
                  "nothing behind an error");
    frame_reading_end(&a);
    return n;
}

Test(binary_frames, cut_or_wrong)
{
    static const struct {
        size_t at;
        char byte;
    } wrong[] = {{3, 'x'}, {8, 2},  {9, 5},  {10, 4}, {11, 9}, {12, 4},  {13, 1},
                 {15, 7},  {17, 1}, {19, 8}, {20, 3}, {27, 1}, {38, -16}};
    size_t size;
    bool fault;
    char *bytes = write_pairs(&size);
    for (size_t cut = 1; cut < size; cut++) {
        int n = count_pairs(bytes, cut, &fault);
        cr_expect(n < 4 && fault != (cut == 32 + 2 * 8 * 12), "%zu bytes", cut);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char kept = bytes[wrong[i].at];
        bytes[wrong[i].at] = wrong[i].byte;
        if (wrong[i].at == 38)
            bytes[39] = 0x7f; /* no number */
        cr_expect(count_pairs(bytes, size, &fault) == 0 && fault, "byte %zu", wrong[i].at);
        bytes[wrong[i].at] = kept;
    }
    free(bytes);
}

Test(binary_frames, not_written)
{
    const fmb_frame flat = {FMB_CUBOID, 3, 0, near, NULL, NULL};
    char *bytes = NULL;
    size_t size;
    FILE *out = open_memstream(&bytes, &size);
    cr_expect_eq(fmb_frame_pairs_write(NULL, 1, &square, &square), FMB_ERR_ARG);
    cr_expect_eq(fmb_frame_pairs_write(out, 1, NULL, &square), FMB_ERR_ARG);
    cr_expect_eq(fmb_frame_pairs_write(out, 1, &square, &flat), FMB_ERR_ARG);
    cr_expect_eq(fmb_frame_pairs_write(out, 0, NULL, NULL), FMB_OK);
    cr_expect_eq(fmb_frame_reader_rationals(NULL), FMB_ERR_ARG);
    fclose(out);
    cr_expect_eq(size, 0);
    free(bytes);
}
