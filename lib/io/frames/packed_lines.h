/* packed_lines.h: pairs of frames in binary; docs/formats.md, "packed frames". */
#ifndef FMB_IO_FRAMES_PACKED_LINES_H
#define FMB_IO_FRAMES_PACKED_LINES_H

#include <fmb/pair.h>

/* The largest dimension: products of two dimensions fit an int. */
#define FMB_FRAMES_DIM 10000

enum { FMB_PACKED_HEADER = 32 }; /* [bytes] */

/* The header of a block of pairs with the same layout. */
typedef struct fmb_packed_block {
    uint32_t dim, naxes[2], pairs;
    uint8_t size;     /* of a number [bytes]: 4 or 8 */
    uint8_t shape[2]; /* of fmb_shape */
    bool moves[2];
} fmb_packed_block;

/* Decode a header of FMB_PACKED_HEADER bytes. NULL, or the wrong field ("dimension"). */
const char *fmb_packed_decode(const unsigned char *from, fmb_packed_block *out);
/* Numbers of frame k. */
static inline size_t fmb_packed_numbers(const fmb_packed_block *b, int k)
{
    return (size_t)b->dim * (1 + (size_t)b->naxes[k] + (b->moves[k] ? 1 : 0));
}

/* Read n little-endian numbers of that size [bytes]. */
void fmb_packed_read(const unsigned char *from, int size, size_t n, double *to);

#endif
