/* formats.h: the table of formats. To add one: a folder of its own, a line in formats.c. */
#ifndef FMB_IO_FORMATS_H
#define FMB_IO_FORMATS_H

#include "io/core/io_private.h"

/* One format. */
typedef struct fmb_codec {
    fmb_format format;
    const char *name; /* as in --format; ".name" is its ending */
    fmb_read_fn *read;
    fmb_write_fn *write;                /* NULL: reading only */
    bool (*sniff)(const fmb_cursor *c); /* does the text look like it? c is at the start */
} fmb_codec;

/* Entry of a format; NULL for AUTO and nonsense. */
const fmb_codec *fmb_codec_of(fmb_format f);
/* By content; text for people (.fmb) if nothing else fits. */
const fmb_codec *fmb_codec_guess(const fmb_cursor *c);

#endif
