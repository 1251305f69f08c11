/* packed_lines.c: see packed_lines.h. */
#include "io/frames/packed_lines.h"

#include <fmb/gmp.h>

#include <string.h>

#include "base/memory_stream.h"

static const char magic[8] = {'f', 'm', 'b', 'p', 'a', 'i', 'r', 's'};

enum { VERSION = 1 };

/* ---- words ----------------------------------------------------------------------------------- */

static inline uint64_t read_four(const unsigned char *b)
{
    return (uint64_t)b[0] | (uint64_t)b[1] << 8 | (uint64_t)b[2] << 16 | (uint64_t)b[3] << 24;
}

/* One load, where the processor is little-endian: compilers see that without a loop. */
static inline uint64_t read_eight(const unsigned char *b)
{
    return (uint64_t)b[0] | (uint64_t)b[1] << 8 | (uint64_t)b[2] << 16 | (uint64_t)b[3] << 24 |
           (uint64_t)b[4] << 32 | (uint64_t)b[5] << 40 | (uint64_t)b[6] << 48 |
           (uint64_t)b[7] << 56;
}

static void write_word(uint64_t word, int size, unsigned char *to)
{
    for (int i = 0; i < size; i++, word >>= 8)
        to[i] = (unsigned char)word;
}

void fmb_packed_read(const unsigned char *from, int size, size_t n, double *to)
{
    for (size_t i = 0; size == 8 && i < n; i++) {
        uint64_t word = read_eight(from + 8 * i);
        memcpy(&to[i], &word, sizeof word);
    }
    for (size_t i = 0; size == 4 && i < n; i++) {
        uint32_t word = (uint32_t)read_four(from + 4 * i);
        float single;
        memcpy(&single, &word, sizeof word);
        to[i] = (double)single;
    }
}

/* ---- headers --------------------------------------------------------------------------------- */

static bool has_possible_axes(const fmb_packed_block *b, int k)
{
    bool is_hull = b->shape[k] == FMB_SIMPLEX_BY_CORNERS;
    return b->shape[k] <= FMB_SIMPLEX_BY_CORNERS &&
           b->naxes[k] <= (is_hull ? (uint32_t)FMB_FRAME_MOST_DIM : b->dim);
}

const char *fmb_packed_decode(const unsigned char *from, fmb_packed_block *out)
{
    if (memcmp(from, magic, sizeof magic) != 0)
        return "\"fmbpairs\" in front of pairs in binary";
    if (from[8] != VERSION)
        return "version 1 of pairs in binary";
    *out = (fmb_packed_block){
        .dim = (uint32_t)read_four(from + 16),
        .naxes = {(uint32_t)read_four(from + 20), (uint32_t)read_four(from + 24)},
        .pairs = (uint32_t)read_four(from + 28),
        .size = from[9],
        .shape = {from[10], from[11]},
        .moves = {from[12] & 1, from[12] >> 1 & 1}};
    if (out->size != 4 && out->size != 8)
        return "numbers of 4 or 8 bytes";
    if (out->dim < 1 || out->dim > FMB_FRAMES_DIM)
        return "1 to 10000 dimensions";
    if (!has_possible_axes(out, 0) || !has_possible_axes(out, 1))
        return "shapes from 0 to 3, with no more edges than dimensions";
    return from[12] > 3 || from[13] || from[14] || from[15] ? "zeros in the rest of a header"
                                                            : NULL;
}

/* ---- writing --------------------------------------------------------------------------------- */

static bool is_outline_packable(const fmb_frame *f, int dim)
{
    return f->dim == dim && dim >= 1 && dim <= FMB_FRAMES_DIM && f->naxes >= 0 && f->origin &&
           (f->axes || f->naxes == 0) && (unsigned)f->shape <= FMB_SIMPLEX_BY_CORNERS;
}

static bool are_alike(const fmb_frame *f, const fmb_frame *g)
{
    return f->shape == g->shape && f->naxes == g->naxes && !f->speed == !g->speed;
}

static bool write_numbers(FILE *out, const double *x, size_t n)
{
    unsigned char bytes[8 * 64];
    bool good = true;
    for (size_t i = 0; good && i < n; i += 64) {
        size_t some = n - i < 64 ? n - i : 64;
        for (size_t k = 0; k < some; k++) {
            uint64_t word;
            memcpy(&word, &x[i + k], sizeof word);
            write_word(word, 8, bytes + 8 * k);
        }
        good = fwrite(bytes, 8, some, out) == some;
    }
    return good;
}

static bool write_frame(FILE *out, const fmb_frame *f)
{
    size_t d = (size_t)f->dim;
    return write_numbers(out, f->origin, d) && write_numbers(out, f->axes, d * (size_t)f->naxes) &&
           (!f->speed || write_numbers(out, f->speed, d));
}

static bool write_header(FILE *out, const fmb_frame *p, const fmb_frame *q, size_t pairs)
{
    unsigned char header[FMB_PACKED_HEADER] = {0};
    memcpy(header, magic, sizeof magic);
    header[8] = VERSION;
    header[9] = 8;
    header[10] = (unsigned char)p->shape;
    header[11] = (unsigned char)q->shape;
    header[12] = (unsigned char)((p->speed != NULL) | (q->speed != NULL) << 1);
    write_word((uint64_t)p->dim, 4, header + 16);
    write_word((uint64_t)p->naxes, 4, header + 20);
    write_word((uint64_t)q->naxes, 4, header + 24);
    write_word(pairs, 4, header + 28);
    return fwrite(header, 1, sizeof header, out) == sizeof header;
}

fmb_status fmb_frame_pairs_write(FILE *out, size_t n, const fmb_frame *p, const fmb_frame *q)
{
    if (!out || (n > 0 && (!p || !q)))
        return FMB_ERR_ARG;
    for (size_t i = 0; i < n; i++)
        if (!is_outline_packable(&p[i], p[0].dim) || !is_outline_packable(&q[i], p[0].dim))
            return FMB_ERR_ARG;
    for (size_t first = 0, end; first < n; first = end) {
        for (end = first + 1; end < n && end - first < UINT32_MAX; end++)
            if (!are_alike(&p[end], &p[first]) || !are_alike(&q[end], &q[first]))
                break;
        bool good = write_header(out, &p[first], &q[first], end - first);
        for (size_t i = first; good && i < end; i++)
            good = write_frame(out, &p[i]) && write_frame(out, &q[i]);
        if (!good)
            return FMB_ERR_IO;
    }
    return FMB_OK;
}

typedef struct frame_pairs {
    size_t n;
    const fmb_frame *p, *q;
} frame_pairs;

static fmb_status write_these_pairs(const void *self, FILE *out)
{
    const frame_pairs *w = self;
    return fmb_frame_pairs_write(out, w->n, w->p, w->q);
}

fmb_status fmb_frame_pairs_print(size_t n, const fmb_frame *p, const fmb_frame *q, char *bytes,
                                 size_t size, size_t *length)
{
    return fmb_memory_print(write_these_pairs, &(frame_pairs){n, p, q}, bytes, size, length);
}
