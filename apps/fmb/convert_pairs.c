/* convert_pairs.c: see convert_pairs.h. Pairs are collected, so that consecutive ones of the same
 * layout share a header. */
#include "fmb/convert_pairs.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/gmp.h>

#include "common/file.h"
#include "common/message.h"

enum { MOST_PAIRS = 4096, MOST_NUMBERS = 1 << 17 };

/* The collected pairs, of one dimension, and their numbers. */
typedef struct waiting {
    fmb_frame frame[2][MOST_PAIRS];
    double number[MOST_NUMBERS];
    size_t pairs, numbers;
} waiting;

static fmb_status write_waiting_pairs(waiting *w)
{
    fmb_status st = fmb_frame_pairs_write(stdout, w->pairs, w->frame[0], w->frame[1]);
    w->pairs = w->numbers = 0;
    return st;
}

static size_t count_numbers(const fmb_frame *f)
{
    return (size_t)f->dim * (1 + (size_t)f->naxes + (f->speed != NULL));
}

static const double *keep_numbers(waiting *w, const double *x, size_t n)
{
    double *to = w->number + w->numbers;
    if (n > 0)
        memcpy(to, x, n * sizeof *x);
    w->numbers += n;
    return to;
}

static fmb_frame keep_frame(waiting *w, const fmb_frame *f)
{
    size_t d = (size_t)f->dim;
    fmb_frame kept = *f;
    kept.origin = keep_numbers(w, f->origin, d);
    kept.axes = keep_numbers(w, f->axes, d * (size_t)f->naxes);
    kept.speed = f->speed ? keep_numbers(w, f->speed, d) : NULL;
    return kept;
}

/* Add a pair; one with more numbers than can be collected is written at once. */
static fmb_status put_pair(waiting *w, const fmb_frame frame[2])
{
    size_t n = count_numbers(&frame[0]) + count_numbers(&frame[1]);
    bool fits = w->pairs < MOST_PAIRS && n <= MOST_NUMBERS - w->numbers &&
                (w->pairs == 0 || w->frame[0][0].dim == frame[0].dim);
    fmb_status st = fits ? FMB_OK : write_waiting_pairs(w);
    if (st == FMB_OK && n > MOST_NUMBERS)
        return fmb_frame_pairs_write(stdout, 1, &frame[0], &frame[1]);
    for (int k = 0; st == FMB_OK && k < 2; k++)
        w->frame[k][w->pairs] = keep_frame(w, &frame[k]);
    w->pairs += st == FMB_OK;
    return st;
}

/* Write every pair, up to the end or an error, which is then reported. */
static int write_all(fmb_frame_reader *lines, const char *file)
{
    const fmb_frame_line *line = NULL;
    waiting *w = app_need(calloc(1, sizeof *w));
    fmb_where where = {0};
    fmb_status st, written = FMB_OK;
    bool any = false;
    do {
        st = fmb_frame_reader_next(lines, &line, &where);
        if (st == FMB_OK && line && !line->are_doubles) {
            where = (fmb_where){.line = line->number, .column = 1};
            snprintf(where.text, sizeof where.text,
                     "expected frames whose numbers are doubles (--nearest rounds them)");
            st = FMB_ERR_PARSE;
        }
        if (st == FMB_OK && line)
            written = put_pair(w, line->frame);
        any = any || line;
    } while (st == FMB_OK && written == FMB_OK && line);
    if (st == FMB_OK && !any)
        st = app_source_without_pairs(&where);
    int cause = errno;
    if (written == FMB_OK)
        written = write_waiting_pairs(w);
    free(w);
    errno = cause;
    return written == FMB_OK ? app_source_outcome_of(APP_KIND_FRAMES, st, file, &where)
                             : app_status_error(written);
}

int convert_pairs(const app_source *source, bool nearest)
{
    fmb_reader reading = {
        .size = sizeof reading, .nearest = nearest, .max_bytes = source->max_input};
    fmb_frame_reader *lines = NULL;
    FILE *in;
    int code = app_file_open(source->file, &in);
    if (code != APP_YES)
        return code;
    fmb_status st = fmb_frame_reader_new(in, &reading, &lines);
    code = st == FMB_OK ? write_all(lines, source->file) : app_status_error(st);
    fmb_frame_reader_free(lines);
    app_file_close_input(in);
    return code;
}
