/* pack.h: records of a set (pair/packed/set.h) transposed into lanes, and the loops over pairs and
 * rows.
 *
 * Four rows of all lanes come from one load of each record and three shuffles a row at most: the
 * cost of a block is mainly that of the shuffles, not of the loads.
 *
 * A file that includes this defines packed_ask before, which decides a block (packed_verdict.h),
 * and the name of the table, FMB_PACKED_TABLE; if it decides blocks of floats, too, then also
 * FMB_PACKED_SINGLE, the name of a function. It is inlined into the loops: in a row, numbers of
 * the one frame alone, such as its adjugate, are then computed once.
 */
#ifndef FMB_PAIR_PACK_H
#define FMB_PAIR_PACK_H

#include <string.h>

#include "pair/kernels/contact/contact_distance.h"
#include "pair/kernels/contact/contact_hulls.h"
#include "pair/kernels/lane/transpose.h"
#include "pair/kernels/packed_kernels.h"

/* Rows that are transposed of records: all numbers, but the speed only if it counts. */
FMB_INLINE int count_packed_rows(int dim, bool moves)
{
    return dim == 2 ? 8 : moves ? 16 : 12;
}

FMB_INLINE void pack_records(int dim, bool moves, const double *const *from, lane *out)
{
#pragma GCC unroll 4
    for (int r = 0; r < count_packed_rows(dim, moves); r += 4)
        transpose_four(from, r, out + r);
}

FMB_INLINE void pack_singles(int dim, bool moves, const float *const *from, lane *out)
{
#pragma GCC unroll 4
    for (int r = 0; r < count_packed_rows(dim, moves); r += 4)
        transpose_four_single(from, r, out + r);
}

/* A block of the lanes of A and of B. */
FMB_INLINE void pack_block(int dim, bool moves, const lane *a, const lane *b, double *block)
{
    double *to = block;
#pragma GCC unroll 3
    for (int j = 0; j < dim; j++, to += FMB_LANES)
        lane_store(to, b[j] - a[j]);
#pragma GCC unroll 9
    for (int j = 0; j < dim * dim; j++, to += FMB_LANES)
        lane_store(to, a[dim + j]);
#pragma GCC unroll 9
    for (int j = 0; j < dim * dim; j++, to += FMB_LANES)
        lane_store(to, b[dim + j]);
    if (!moves)
        return;
#pragma GCC unroll 3
    for (int j = dim * (dim + 1); j < dim * (dim + 2); j++, to += FMB_LANES)
        lane_store(to, b[j] - a[j]);
}

/* The rows that follow in a block of numbers that were rounded to floats. */
FMB_INLINE void pack_rounding(int dim, bool moves, const fmb_packed_pairs *x, double *block)
{
    double *to = block + dim * (1 + 2 * dim + moves) * FMB_LANES;
    lane_store(to, lane_of(x->far));
    lane_store(to + FMB_LANES, lane_of(x->fast));
    lane_store(to + 2 * FMB_LANES, lane_of(x->rounding));
}

/* ---- pairs by index -------------------------------------------------------------------------- */

/* The verdicts of the lanes. */
FMB_INLINE void write_verdicts(fmb_pair_bits bits, fmb_verdict *out)
{
#if FMB_LANES == 8
    __m512i v = _mm512_maskz_set1_epi32((__mmask16)bits.meet, FMB_FEASIBLE);
    v = _mm512_mask_set1_epi32(v, (__mmask16)bits.apart, FMB_INFEASIBLE);
    _mm256_storeu_si256((__m256i *)out, _mm512_castsi512_si256(v));
#else
    for (int l = 0; l < FMB_LANES; l++)
        out[l] = bits.apart >> l & 1  ? FMB_INFEASIBLE
                 : bits.meet >> l & 1 ? FMB_FEASIBLE
                                      : FMB_UNKNOWN;
#endif
}

/* Numbers of a record. */
FMB_INLINE size_t count_record(int dim)
{
    return dim == 2 ? 8 : 16;
}

/* Blocks whose records are being prefetched; a power of two. */
enum { PACKED_AHEAD = 4 };

/* The numbers before the records of one side of these blocks. */
typedef size_t packed_places[PACKED_AHEAD][FMB_LANES];

/* Find and prefetch records of one side of the block of pairs at `i`. single: constant, they are of
 * floats. */
FMB_INLINE void find_records(int dim, bool single, const fmb_packed_pairs *x, int side, size_t i,
                             packed_places out)
{
    const size_t size = count_record(dim);
    const uint32_t *index = x->index[side];
    size_t *at = out[i / FMB_LANES % PACKED_AHEAD];
    if (i + FMB_LANES > x->n) {
        for (size_t l = 0; l < FMB_LANES; l++)
            at[l] = size * index[2 * (i + l < x->n ? i + l : x->n - 1)];
        return;
    }
#pragma GCC unroll 8
    for (size_t l = 0; l < FMB_LANES; l++) {
        at[l] = size * index[2 * (i + l)];
        if (single) {
            __builtin_prefetch(x->single[side] + at[l]);
            continue;
        }
        __builtin_prefetch(x->record[side] + at[l]);
        if (dim == 3)
            __builtin_prefetch(x->record[side] + at[l] + 8);
    }
}

/* The records of one side at these places, as lanes. */
FMB_INLINE void pack_found(int dim, bool moves, bool single, const fmb_packed_pairs *x, int side,
                           const size_t *at, lane *out)
{
    const double *record[FMB_LANES];
    const float *floats[FMB_LANES];
    for (int l = 0; l < FMB_LANES; l++) {
        record[l] = x->record[side] + at[l];
        floats[l] = single ? x->single[side] + at[l] : NULL;
    }
    if (single)
        pack_singles(dim, moves, floats, out);
    else
        pack_records(dim, moves, record, out);
}

/* The block of pairs at i, whose records are found. */
FMB_INLINE fmb_pair_bits ask_pairs_at(int dim, bool moves, int shapes, bool single,
                                      const fmb_packed_pairs *x, size_t i, packed_places at[2],
                                      double *block)
{
    const size_t slot = i / FMB_LANES % PACKED_AHEAD;
    lane a[16], b[16];
    pack_found(dim, moves, single, x, 0, at[0][slot], a);
    pack_found(dim, moves, single, x, 1, at[1][slot], b);
    pack_block(dim, moves, a, b, block);
    if (single)
        pack_rounding(dim, moves, x, block);
    return packed_ask(dim, moves, shapes, single, FMB_ASK_ALL, x->kind, block);
}

/* Decide the pairs of x in full blocks; the last block is filled up by repeating the last pair. */
FMB_INLINE bool packed_pairs(int dim, bool moves, int shapes, bool single,
                             const fmb_packed_pairs *x, fmb_verdict *out)
{
    _Alignas(64) double block[FMB_BLOCK_MOST_ROWS * FMB_LANES];
    const size_t ahead = PACKED_AHEAD * FMB_LANES - FMB_LANES;
    const size_t rest = x->n % FMB_LANES, whole = x->n - rest;
    packed_places at[2];
    unsigned all = (1U << FMB_LANES) - 1, known = all;
    for (size_t i = 0; i < x->n + ahead; i += FMB_LANES) {
        for (int side = 0; i < x->n && side < 2; side++)
            find_records(dim, single, x, side, i, at[side]);
        if (i < ahead)
            continue;
        fmb_pair_bits bits = ask_pairs_at(dim, moves, shapes, single, x, i - ahead, at, block);
        known &= bits.apart | bits.meet;
        if (i - ahead < whole) {
            write_verdicts(bits, out + (i - ahead));
        } else {
            fmb_verdict last[FMB_LANES];
            write_verdicts(bits, last);
            memcpy(out + whole, last, rest * sizeof *out);
        }
    }
    return known == all;
}

static bool packed_pairs_3d(const fmb_packed_pairs *x, fmb_verdict *out);

/* Floats are not read of two simplices that move: their rows take longer than reading doubles. */
FMB_INLINE bool packed_pairs_of_shapes(int dim, bool moves, bool single, const fmb_packed_pairs *x,
                                       fmb_verdict *out)
{
    switch (x->shapes) {
    case FMB_PACKED_CUBOIDS:
        return packed_pairs(dim, moves, FMB_PACKED_CUBOIDS, single, x, out);
    case FMB_PACKED_ONE_OF_EACH:
        return packed_pairs(dim, moves, FMB_PACKED_ONE_OF_EACH, single, x, out);
    case FMB_PACKED_SIMPLICES:
        return single && moves ? packed_pairs_3d(x, out)
                               : packed_pairs(dim, moves, FMB_PACKED_SIMPLICES, single, x, out);
    default:
        return packed_pairs(dim, moves, FMB_PACKED_ANY, false, x, out);
    }
}

/* A function for each dimension: as one, kernels in the plane would take up to 1.17 of the time. */
static bool packed_pairs_2d(const fmb_packed_pairs *x, fmb_verdict *out)
{
    return x->moves ? packed_pairs_of_shapes(2, true, false, x, out)
                    : packed_pairs_of_shapes(2, false, false, x, out);
}

static bool packed_pairs_3d(const fmb_packed_pairs *x, fmb_verdict *out)
{
    return x->moves ? packed_pairs_of_shapes(3, true, false, x, out)
                    : packed_pairs_of_shapes(3, false, false, x, out);
}

#ifdef FMB_PACKED_SINGLE
static bool FMB_PACKED_SINGLE(const fmb_packed_pairs *x, fmb_verdict *out)
{
    return x->moves ? packed_pairs_of_shapes(3, true, true, x, out)
                    : packed_pairs_of_shapes(3, false, true, x, out);
}
#else
#define FMB_PACKED_SINGLE NULL
#endif

/* ---- depths and distances of pairs by index -------------------------------------------------- */

/* One of the two, an answer a block; the other is NULL. */
FMB_INLINE void packed_lengths_of(int dim, const fmb_packed_pairs *x, fmb_contact_lanes *contacts,
                                  fmb_distance_lanes *distances)
{
    _Alignas(64) double block[FMB_BLOCK_MOST_ROWS * FMB_LANES];
    const size_t ahead = PACKED_AHEAD * FMB_LANES - FMB_LANES;
    packed_places at[2];
    for (size_t i = 0; i < x->n + ahead; i += FMB_LANES) {
        lane a[16], b[16];
        for (int side = 0; i < x->n && side < 2; side++)
            find_records(dim, false, x, side, i, at[side]);
        if (i < ahead)
            continue;
        pack_found(dim, true, false, x, 0, at[0][(i - ahead) / FMB_LANES % PACKED_AHEAD], a);
        pack_found(dim, true, false, x, 1, at[1][(i - ahead) / FMB_LANES % PACKED_AHEAD], b);
        pack_block(dim, true, a, b, block);
        if (contacts)
            contact_ask(x->kind, block, contacts++);
        else
            distance_ask(x->kind, block, distances++);
    }
}

static void packed_lengths(const fmb_packed_pairs *x, fmb_contact_lanes *contacts,
                           fmb_distance_lanes *distances)
{
    if (x->kind->dim == 2)
        packed_lengths_of(2, x, contacts, distances);
    else
        packed_lengths_of(3, x, contacts, distances);
}

/* ---- frames by pointers ---------------------------------------------------------------------- */

FMB_INLINE void packed_load_of(int dim, const fmb_frame *a, const fmb_frame *b, double *block)
{
    const double *place[2][FMB_LANES], *axes[2][FMB_LANES];
    lane origin[2][3], of[9];
#pragma GCC unroll 8
    for (int l = 0; l < FMB_LANES; l++) {
        place[0][l] = a[l].origin;
        place[1][l] = b[l].origin;
        axes[0][l] = a[l].axes;
        axes[1][l] = b[l].axes;
    }
    for (int side = 0; side < 2; side++) {
        transpose_some(place[side], dim, origin[side]);
        transpose_some(axes[side], dim * dim, of);
#pragma GCC unroll 9
        for (int r = 0; r < dim * dim; r++)
            lane_store(block + (dim + side * dim * dim + r) * FMB_LANES, of[r]);
    }
    for (int j = 0; j < dim; j++)
        lane_store(block + j * FMB_LANES, origin[1][j] - origin[0][j]);
}

static void packed_load(int dim, const fmb_frame *a, const fmb_frame *b, double *block)
{
    if (dim == 2)
        packed_load_of(2, a, b, block);
    else
        packed_load_of(3, a, b, block);
}

/* ---- one against many ------------------------------------------------------------------------ */

/* Tiles of FMB_LANES frames: all rows of their records, lane by lane. */
FMB_INLINE void packed_tiles_of(int dim, const double *record, const uint32_t *index, size_t n,
                                double *tiles)
{
    const size_t rows = count_record(dim), whole = (n + 7) / 8 * 8;
    for (size_t i = 0; i < whole; i += FMB_LANES, tiles += rows * FMB_LANES) {
        const double *from[FMB_LANES];
        lane x[16];
        for (size_t l = 0; l < FMB_LANES; l++)
            from[l] = record + rows * index[i + l < n ? i + l : n - 1];
        pack_records(dim, true, from, x);
#pragma GCC unroll 16
        for (size_t r = 0; r < rows; r++)
            lane_store(tiles + r * FMB_LANES, x[r]);
    }
}

static void packed_tiles(int dim, const double *record, const uint32_t *index, size_t n,
                         double *tiles)
{
    if (dim == 2)
        packed_tiles_of(2, record, index, n, tiles);
    else
        packed_tiles_of(3, record, index, n, tiles);
}

/* FMB_LANES frames of a row. */
FMB_INLINE fmb_pair_bits ask_lanes_of_row(int dim, bool moves, int shapes, fmb_asked asked,
                                          const fmb_packed_row *x, const lane *one,
                                          const lane *other)
{
    _Alignas(64) double block[FMB_BLOCK_MOST_ROWS * FMB_LANES];
    if (x->swapped)
        pack_block(dim, moves, other, one, block);
    else
        pack_block(dim, moves, one, other, block);
    return packed_ask(dim, moves, shapes, false, asked, x->kind, block);
}

/* Eight frames of a row of tiles. */
FMB_INLINE fmb_packed_bits ask_eight_tiled(int dim, bool moves, int shapes, fmb_asked asked,
                                           const fmb_packed_row *x, const lane *one,
                                           const double *tiles)
{
    const int rows = (int)count_record(dim), used = dim * (dim + 1 + moves);
    fmb_packed_bits out = {0, 0};
    for (unsigned l = 0; l < 8; l += FMB_LANES, tiles += rows * FMB_LANES) {
        lane other[16];
#pragma GCC unroll 16
        for (int r = 0; r < used; r++)
            other[r] = lane_load(tiles + r * FMB_LANES);
        fmb_pair_bits some = ask_lanes_of_row(dim, moves, shapes, asked, x, one, other);
        out.apart = (uint8_t)(out.apart | some.apart << l);
        out.meet = (uint8_t)(out.meet | some.meet << l);
    }
    return out;
}

/* Append those of the frames 8 eight ... of a row that are not apart to n others; their new number.
 */
FMB_INLINE size_t collect_open(const fmb_packed_row *x, size_t eight, fmb_packed_bits bits,
                               uint16_t *open, size_t n)
{
    unsigned count = x->n - 8 * eight < 8 ? (1U << (x->n - 8 * eight)) - 1 : 0xff;
    for (unsigned left = ~(unsigned)bits.apart & count; left; left &= left - 1)
        open[n++] = (uint16_t)(8 * eight + (size_t)__builtin_ctz(left));
    return n;
}

/* All rows of up to FMB_LANES open frames of a row. */
FMB_INLINE void ask_open_lanes(bool moves, int shapes, const fmb_packed_row *x, const lane *one,
                               const uint16_t *open, size_t n, fmb_packed_bits *out)
{
    const double *from[FMB_LANES];
    lane other[16];
    for (size_t l = 0; l < FMB_LANES; l++)
        from[l] = x->record + count_record(3) * x->index[open[l < n ? l : 0]];
    pack_records(3, moves, from, other);
    fmb_pair_bits bits = ask_lanes_of_row(3, moves, shapes, FMB_ASK_ALL, x, one, other);
    for (size_t l = 0; l < n; l++) {
        fmb_packed_bits *to = &out[open[l] / 8];
        to->apart = (uint8_t)(to->apart | (bits.apart >> l & 1) << open[l] % 8);
        to->meet = (uint8_t)(to->meet | (bits.meet >> l & 1) << open[l] % 8);
    }
}

/* Eights of a row between two counts of open frames. */
enum { PACKED_LOOK = 8 };

/* Most simplices in space are separated by a face of one of the two: faces are tested for all
 * frames, and frames still open are collected in separate lanes. Once half of the frames are open,
 * faces are no longer tested first. (All rows are tested in one place only: their code is long.) */
FMB_INLINE void packed_row_by_faces(bool moves, int shapes, const fmb_packed_row *x,
                                    const lane *one, fmb_packed_bits *out)
{
    const size_t size = 8 * count_record(3), eights = (x->n + 7) / 8;
    uint16_t open[8 * PACKED_LOOK + FMB_LANES];
    size_t n = 0, g = 0;
    bool most_open = eights < PACKED_LOOK; /* or too few to look at */
    while (g < eights) {
        const size_t end = g + PACKED_LOOK < eights ? g + PACKED_LOOK : eights;
        size_t asked = 0;
        for (; g < end; g++) {
            out[g] = (fmb_packed_bits){0, 0};
            if (!most_open)
                out[g] =
                    ask_eight_tiled(3, moves, shapes, FMB_ASK_FACES, x, one, x->tiles + size * g);
            n = collect_open(x, g, out[g], open, n);
        }
        most_open = most_open || n > 8 * PACKED_LOOK / 2;
        while (n - asked >= FMB_LANES || (end == eights && asked < n)) {
            size_t some = n - asked < FMB_LANES ? n - asked : FMB_LANES;
            ask_open_lanes(moves, shapes, x, one, open + asked, some, out);
            asked += some;
        }
        memmove(open, open + asked, (n - asked) * sizeof *open);
        n -= asked;
    }
}

FMB_INLINE void packed_row(int dim, bool moves, int shapes, const fmb_packed_row *x,
                           fmb_packed_bits *out)
{
    const size_t rows = count_record(dim);
    lane one[16];
#pragma GCC unroll 16
    for (size_t r = 0; r < rows; r++)
        one[r] = lane_of(x->one[r]);
    if (dim == 3 && shapes == FMB_PACKED_SIMPLICES) {
        packed_row_by_faces(moves, shapes, x, one, out);
        return;
    }
    for (size_t g = 0; g < (x->n + 7) / 8; g++)
        out[g] = ask_eight_tiled(dim, moves, shapes, FMB_ASK_ALL, x, one, x->tiles + 8 * rows * g);
}

FMB_INLINE void packed_row_of_shapes(int dim, bool moves, const fmb_packed_row *x,
                                     fmb_packed_bits *out)
{
    switch (x->shapes) {
    case FMB_PACKED_CUBOIDS:
        packed_row(dim, moves, FMB_PACKED_CUBOIDS, x, out);
        break;
    case FMB_PACKED_ONE_OF_EACH:
        packed_row(dim, moves, FMB_PACKED_ONE_OF_EACH, x, out);
        break;
    case FMB_PACKED_SIMPLICES:
        packed_row(dim, moves, FMB_PACKED_SIMPLICES, x, out);
        break;
    default:
        packed_row(dim, moves, FMB_PACKED_ANY, x, out);
    }
}

static void packed_row_2d(const fmb_packed_row *x, fmb_packed_bits *out)
{
    if (x->moves)
        packed_row_of_shapes(2, true, x, out);
    else
        packed_row_of_shapes(2, false, x, out);
}

static void packed_row_3d(const fmb_packed_row *x, fmb_packed_bits *out)
{
    if (x->moves)
        packed_row_of_shapes(3, true, x, out);
    else
        packed_row_of_shapes(3, false, x, out);
}

/* ---- indices --------------------------------------------------------------------------------- */

/* Sixteen at a time, as compilers make vectors of that. */
static void packed_largest(const uint32_t *index, size_t n, uint32_t out[2])
{
    uint32_t most[16] = {0};
    size_t i = 0;
    for (; i + 16 <= n; i += 16)
        for (size_t l = 0; l < 16; l++)
            most[l] = most[l] > index[i + l] ? most[l] : index[i + l];
    for (size_t l = 0; i < n; i++, l++)
        most[l] = most[l] > index[i] ? most[l] : index[i];
    out[0] = out[1] = 0;
    for (size_t l = 0; l < 16; l++)
        out[l % 2] = out[l % 2] > most[l] ? out[l % 2] : most[l];
}

extern const fmb_packed FMB_PACKED_TABLE;
const fmb_packed FMB_PACKED_TABLE = {.flat = packed_ask_any,
                                     .contact = contact_ask,
                                     .lengths = packed_lengths,
                                     .distance = distance_ask,
                                     .pairs = {packed_pairs_2d, packed_pairs_3d},
                                     .single = FMB_PACKED_SINGLE,
                                     .load = packed_load,
                                     .tiles = packed_tiles,
                                     .row = {packed_row_2d, packed_row_3d},
                                     .largest = packed_largest,
                                     .hulls = {contact_farthest, contact_place}};

#endif
