/* minors_loops.h: pairs and rows of packed cuboids and simplices in four to eight dimensions; the
 * body of minors_*.c, which set FMB_LANES and name the table FMB_MINORS_TABLE. */
#ifndef FMB_PAIR_MINORS_LOOPS_H
#define FMB_PAIR_MINORS_LOOPS_H

#include "pair/kernels/lane/transpose.h"
#include "pair/kernels/minors/minors_kernel.h"

/* Of a record, rounded up. */
enum { MINORS_ROWS = 2 * 8 * 8 + 3 * 8 + 8 };

/* Each kernel once. Of one of each records come with the cuboid first. */
#define MINORS_ASK(dim, what)                                                                      \
    static FMB_NEVER_CLONED unsigned minors_ask_##dim##what(                                       \
        minors_asked how, const lane *a, const lane *b, double *room, minors_said *said)           \
    {                                                                                              \
        const minors_kind d = minors_kind_of((dim), (what));                                       \
        return minors_ask(d, how, d.from_simplex ? b : a, d.from_simplex ? a : b, room, said);     \
    }
MINORS_ASK(4, 0)
MINORS_ASK(5, 0)
MINORS_ASK(6, 0)
MINORS_ASK(7, 0)
MINORS_ASK(8, 0)
MINORS_ASK(4, 1)
MINORS_ASK(5, 1)
MINORS_ASK(6, 1)
MINORS_ASK(7, 1)
MINORS_ASK(4, 2)
MINORS_ASK(5, 2)
MINORS_ASK(6, 2)
MINORS_ASK(4, 3)
MINORS_ASK(5, 3)
MINORS_ASK(6, 3)
MINORS_ASK(4, 4)
MINORS_ASK(5, 4)
MINORS_ASK(6, 4)
MINORS_ASK(4, 5)
MINORS_ASK(5, 5)

typedef unsigned minors_asker(minors_asked how, const lane *a, const lane *b, double *room,
                              minors_said *said);
static minors_asker *const MINORS_ASKERS[FMB_MINORS_WHATS][FMB_MINORS_DIMS] = {
    {minors_ask_40, minors_ask_50, minors_ask_60, minors_ask_70, minors_ask_80},
    {minors_ask_41, minors_ask_51, minors_ask_61, minors_ask_71, NULL},
    {minors_ask_42, minors_ask_52, minors_ask_62, NULL, NULL},
    {minors_ask_43, minors_ask_53, minors_ask_63, NULL, NULL},
    {minors_ask_44, minors_ask_54, minors_ask_64, NULL, NULL},
    {minors_ask_45, minors_ask_55, NULL, NULL, NULL}};

/* Of lanes that rows leave open. */
static FMB_NEVER_CLONED fmb_pair_bits minors_decide_open(minors_asker *ask, bool whole,
                                                         const lane *a, const lane *b, double *room,
                                                         unsigned open)
{
    fmb_pair_bits bits = {0, 0};
    minors_said said = minors_silent();
    if (whole) {
        ask(MINORS_WHOLE, a, b, room, &said);
        said.meet = said.meet - lane_of(1);
        bits = minors_bits(&said);
        bits.apart &= open;
        bits.meet &= open;
    }
    if (open & ~(bits.apart | bits.meet))
        bits.meet |= open & ~bits.apart & ask(MINORS_POINT, a, b, room, &said);
    return bits;
}

static fmb_pair_bits minors_answer(int dim, fmb_minors_what what, bool closed, const lane *a,
                                   const lane *b, double *room)
{
    minors_asker *ask = MINORS_ASKERS[what][dim - FMB_MINORS_LEAST_DIM];
    minors_said said = minors_silent();
    ask(MINORS_AT_0, a, b, room, &said);
    if (what == FMB_MINORS_MOVING_SIMPLICES && !minors_all_apart(&said))
        ask(MINORS_AT_1, a, b, room, &said);
    fmb_pair_bits bits = minors_bits(&said);
    const unsigned open = lane_bits(said.known) & ~(bits.apart | bits.meet);
    if (open) {
        const bool whole = closed && what / 2 != 1;
        const fmb_pair_bits more = minors_decide_open(ask, whole, a, b, room, open);
        bits.apart |= more.apart;
        bits.meet |= more.meet;
    }
    return bits;
}

/* FMB_LANES records as lanes. */
FMB_INLINE void minors_pack(int rows, const double *const *from, lane *out)
{
    for (int r = 0; r < rows; r += 4)
        transpose_four(from, r, out + r);
}

static void minors_tiles(int dim, const double *record, const uint32_t *index, size_t n,
                         double *tiles)
{
    const int rows = fmb_minors_record(dim);
    for (size_t i = 0; i < (n + 7) / 8 * 8; i += FMB_LANES) {
        const double *from[FMB_LANES];
        lane out[MINORS_ROWS];
        for (size_t l = 0; l < FMB_LANES; l++)
            from[l] = record + (size_t)rows * index[i + l < n ? i + l : n - 1];
        minors_pack(rows, from, out);
        for (int r = 0; r < rows; r++, tiles += FMB_LANES)
            lane_store(tiles, out[r]);
    }
}

static void minors_row(int dim, fmb_minors_what what, const fmb_packed_row *x, double *room,
                       fmb_packed_bits *out)
{
    const int rows = fmb_minors_record(dim);
    lane one[MINORS_ROWS];
    const double *tiles = x->tiles;
    for (int r = 0; r < rows; r++)
        one[r] = lane_of(x->one[r]);
    for (size_t g = 0; g < (x->n + 7) / 8; g++) {
        out[g] = (fmb_packed_bits){0, 0};
        for (unsigned l = 0; l < 8; l += FMB_LANES, tiles += rows * FMB_LANES) {
            const lane *side[2] = {one, (const lane *)tiles};
            fmb_pair_bits some =
                minors_answer(dim, what, x->closed, side[x->swapped], side[!x->swapped], room);
            out[g].apart = (uint8_t)(out[g].apart | some.apart << l);
            out[g].meet = (uint8_t)(out[g].meet | some.meet << l);
        }
    }
}

static bool minors_pairs(int dim, fmb_minors_what what, const fmb_packed_pairs *x, double *room,
                         fmb_verdict *out)
{
    const int rows = fmb_minors_record(dim);
    bool known = true;
    for (size_t i = 0; i < x->n; i += FMB_LANES) {
        lane side[2][MINORS_ROWS];
        for (int s = 0; s < 2; s++) {
            const double *from[FMB_LANES];
            for (size_t l = 0; l < FMB_LANES; l++)
                from[l] = x->record[s] +
                          (size_t)rows * x->index[s][2 * (i + l < x->n ? i + l : x->n - 1)];
            minors_pack(rows, from, side[s]);
        }
        fmb_pair_bits bits = minors_answer(dim, what, x->closed, side[0], side[1], room);
        for (size_t l = 0; l < FMB_LANES && i + l < x->n; l++) {
            out[i + l] = bits.apart >> l & 1  ? FMB_INFEASIBLE
                         : bits.meet >> l & 1 ? FMB_FEASIBLE
                                              : FMB_UNKNOWN;
            known &= out[i + l] != FMB_UNKNOWN;
        }
    }
    return known;
}

extern const fmb_minor_kernels FMB_MINORS_TABLE;
const fmb_minor_kernels FMB_MINORS_TABLE = {
    .pairs = minors_pairs, .tiles = minors_tiles, .row = minors_row};

#endif
