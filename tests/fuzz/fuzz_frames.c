/* fuzz_frames.c: the reader of pairs of frames on any bytes: every line is a pair or a complaint
 * with a place, and every pair makes a system. */
#include <stdlib.h>

#include <fmb/gmp.h>

#include "round.h"

static void demand(bool ok)
{
    if (!ok)
        abort();
}

static void use(const fmb_frame_line *line)
{
    for (int contact = 0; contact < 2; contact++) {
        fmb_system *s = NULL;
        demand(fmb_system_from_line(line, (fmb_contact)contact, NULL, &s) == FMB_OK);
        demand(fmb_system_dim(s) >= line->dim);
        fmb_system_free(s);
    }
    fmb_system *s = NULL;
    fmb_status st = FMB_OK;
    if (line->are_doubles)
        st = fmb_system_from_frames(line->frame, 2, FMB_COORDINATES_ALL, FMB_CONTACT_CLOSED, NULL,
                                    &s);
    demand(st == FMB_OK);
    fmb_system_free(s);
}

static void read_all(const uint8_t *data, size_t size, bool nearest)
{
    fmb_frame_reader *r = NULL;
    const fmb_frame_line *line = NULL;
    fmb_status st;
    long last = 0;
    const fmb_reader how = {.size = sizeof how, .nearest = nearest};
    demand(fmb_frame_reader_from_text((const char *)data, size, &how, &r) == FMB_OK);
    do {
        fmb_where where = {.line = -1};
        st = fmb_frame_reader_next(r, &line, &where);
        demand(st == FMB_OK || (st == FMB_ERR_PARSE && where.line > last && where.column > 0));
        demand(st == FMB_ERR_PARSE || !line || line->number > last);
        if (st == FMB_OK && line) {
            demand(fmb_frame_reader_rationals(r) == FMB_OK);
            use(line);
        }
        last = st == FMB_ERR_PARSE ? where.line : line ? line->number : last;
    } while (st == FMB_ERR_PARSE || line);
    fmb_frame_reader_free(r);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > 0) {
        read_all(data, size, false);
        read_all(data, size, true);
    }
    return 0;
}
