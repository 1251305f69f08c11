/* convert_pairs.c: see convert_pairs.h. */
#include "fmb/convert_pairs.h"

#include <stdarg.h>
#include <stdio.h>

#include <fmb/gmp.h>

#include "common/file.h"
#include "common/message.h"

/* Every pair, up to the end or a mistake, which is then told. */
static int write_all(fmb_frames *lines, const char *file)
{
    const fmb_frames_line *line = NULL;
    fmb_where where = {0};
    fmb_status st, written = FMB_OK;
    do {
        st = fmb_frames_next(lines, &line, &where);
        if (st == FMB_OK && line && !line->are_doubles) {
            where = (fmb_where){.line = line->number, .column = 1};
            snprintf(where.text, sizeof where.text,
                     "expected frames whose numbers are doubles (--nearest rounds them)");
            st = FMB_ERR_PARSE;
        }
        if (st == FMB_OK && line)
            written = fmb_frames_write(stdout, 1, &line->frame[0], &line->frame[1]);
    } while (st == FMB_OK && written == FMB_OK && line);
    return written == FMB_OK ? app_source_outcome(st, file, &where) : app_status_error(written);
}

int convert_pairs(const app_source *source, bool nearest)
{
    fmb_reader reading = {.nearest = nearest, .max_bytes = source->max_input};
    fmb_frames *lines = NULL;
    FILE *in;
    int code = app_file_open(source->file, &in);
    if (code != APP_YES)
        return code;
    fmb_status st = fmb_frames_open(in, &reading, &lines);
    code = st == FMB_OK ? write_all(lines, source->file) : app_status_error(st);
    fmb_frames_close(lines);
    app_file_close_input(in);
    return code;
}
