/* minors_loops.h: pairs and rows of packed cuboids and simplices in four to eight dimensions; the
 * body of minors_*.c, which set FMB_LANES and name the table FMB_MINORS_TABLE, and what lists open
 * rows FMB_MINORS_LIST. */
#ifndef FMB_PAIR_MINORS_LOOPS_H
#define FMB_PAIR_MINORS_LOOPS_H

#include "pair/kernels/lane/transpose.h"
#include "pair/kernels/minors/minors_inverse.h"
#include "pair/kernels/minors/minors_kernel.h"

/* minors_open.h */
minors_lister FMB_MINORS_LIST;

/* Instantiates each kernel once. For a cuboid and a simplex, the cuboid's record is first. */
#define MINORS_ASK(dim, what)                                                                      \
    static FMB_NEVER_CLONED unsigned minors_ask_##dim##what(                                       \
        const minors_asked *x, const lane *a, const lane *b, double *room, minors_said *said)      \
    {                                                                                              \
        const minors_kind d = minors_kind_of((dim), (what));                                       \
        return minors_ask(d, x, d.from_simplex ? b : a, d.from_simplex ? a : b, room, said);       \
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

typedef unsigned minors_asker(const minors_asked *x, const lane *a, const lane *b, double *room,
                              minors_said *said);
static minors_asker *const MINORS_ASKERS[FMB_MINORS_WHATS][FMB_MINORS_DIMS] = {
    {minors_ask_40, minors_ask_50, minors_ask_60, minors_ask_70, minors_ask_80},
    {minors_ask_41, minors_ask_51, minors_ask_61, minors_ask_71, NULL},
    {minors_ask_42, minors_ask_52, minors_ask_62, NULL, NULL},
    {minors_ask_43, minors_ask_53, minors_ask_63, NULL, NULL},
    {minors_ask_44, minors_ask_54, minors_ask_64, NULL, NULL},
    {minors_ask_45, minors_ask_55, NULL, NULL, NULL}};

/* The lanes whose frames both have integers of few bits; `size`: the place before whole and grain.
 */
FMB_INLINE unsigned minors_are_whole(const lane *a, const lane *b, int size)
{
    return lane_bits(lane_less(lane_of(0), lane_min(a[size + 2], b[size + 2])));
}

/* Decide the open rows of open lanes in integers, if these are short: a single row of each lane or,
 * on request, all. *open becomes the lanes with short integers. */
static fmb_pair_bits minors_decide_rows(int dim, fmb_minors_what what, bool closed, const lane *a,
                                        const lane *b, double *room, unsigned *open, bool all)
{
    fmb_pair_bits bits = {0, 0};
    minors_said said = minors_silent();
    fmb_open_rows rows;
    rows.of.dim = dim;
    rows.of.width = FMB_LANES;
    rows.of.moves = what % 2 == 1;
    rows.closed = closed;
    rows.all = all;
    const bool mixed = what >= FMB_MINORS_MIXED;
    rows.of.simplex[0] = what >= FMB_MINORS_SIMPLICES;
    rows.of.simplex[1] = rows.of.simplex[0] && !mixed;
    rows.of.record[mixed] = (const double *)a;
    rows.of.record[!mixed] = (const double *)b;
    rows.wanted = rows.full = 0;
    rows.n = 0;
    for (unsigned left = *open; left; left &= left - 1) {
        const unsigned l = (unsigned)__builtin_ctz(left);
        rows.wanted |= (unsigned)fmb_open_rows_are_short(&rows, l) << l;
    }
    const unsigned wanted = *open = rows.wanted;
    if (wanted)
        MINORS_ASKERS[what][dim - FMB_MINORS_LEAST_DIM](
            &(minors_asked){.how = MINORS_OPEN, .list = FMB_MINORS_LIST, .rows = &rows}, a, b, room,
            &said);
    for (unsigned left = wanted; left; left &= left - 1) {
        const unsigned l = (unsigned)__builtin_ctz(left);
        const fmb_verdict is = fmb_open_rows_decide(&rows, l);
        bits.apart |= (unsigned)(is == FMB_INFEASIBLE) << l;
        bits.meet |= (unsigned)(is == FMB_FEASIBLE) << l;
    }
    return bits;
}

/* Merge new results of open lanes into bits; returns the lanes still open. */
FMB_INLINE unsigned minors_learn(fmb_pair_bits more, unsigned open, fmb_pair_bits *bits)
{
    bits->apart |= more.apart & open;
    bits->meet |= more.meet & open;
    return open & ~(more.apart | more.meet);
}

/* Are rows tested in integers? For simplices there are so many tests that a vertex of a single pair
 * is found sooner, but not vertices for half of the lanes. */
FMB_INLINE bool minors_want_row(fmb_minors_what what, unsigned open, unsigned whole)
{
    return what == FMB_MINORS_SIMPLICES ? 2 * __builtin_popcount(open) >= FMB_LANES
                                        : what / 2 != 1 && (open & ~whole) != 0;
}

/* Decide lanes that rows leave open, by in turn: one row of each; all rows of lanes with integers
 * of few bits, first if all lanes have these; all other rows; a point. */
static FMB_NEVER_CLONED fmb_pair_bits minors_decide_open(int dim, fmb_minors_what what, bool closed,
                                                         const lane *a, const lane *b, double *room,
                                                         unsigned open)
{
    minors_asker *ask = MINORS_ASKERS[what][dim - FMB_MINORS_LEAST_DIM];
    const bool rows = what / 2 != 1;
    fmb_pair_bits bits = {0, 0};
    minors_said said = minors_silent();
    const unsigned whole = closed && rows ? minors_are_whole(a, b, dim * (2 * dim + 3)) : 0;
    unsigned some = open;
    if (minors_want_row(what, open, whole))
        open = minors_learn(minors_decide_rows(dim, what, closed, a, b, room, &some, false), open,
                            &bits);
    some &= open;
    if (open & whole) {
        ask(&(minors_asked){.how = MINORS_WHOLE}, a, b, room, &said);
        said.meet = said.meet - lane_of(1);
        open = minors_learn(minors_bits(&said), open, &bits);
        some &= open;
    }
    if (some && rows)
        open = minors_learn(minors_decide_rows(dim, what, closed, a, b, room, &some, true), open,
                            &bits);
    if (open)
        bits.meet |=
            open & ask(&(minors_asked){.how = MINORS_POINT, .lanes = open}, a, b, room, &said);
    return bits;
}

/* So many open lanes of a block, or less, are answered together with those of other blocks: rows
 * beyond faces cost as much for one lane as for all of them. 0: gathering records takes longer than
 * that (docs/experiments.md). */
FMB_INLINE int minors_few(int dim, fmb_minors_what what)
{
    const int columns = dim + (int)what % 2 + (what >= FMB_MINORS_SIMPLICES);
    return columns > 5 ? FMB_LANES / 2 : 0;
}

/* Answer a block: the first n lanes are pairs, others repeat one of these. If `few` lanes
 * or less are open before all rows are tested, these become *waiting. */
FMB_INLINE fmb_pair_bits minors_answer(int dim, fmb_minors_what what, bool closed, const lane *a,
                                       const lane *b, double *room, size_t n, int few,
                                       unsigned *waiting)
{
    const unsigned asked = n < FMB_LANES ? (1U << n) - 1 : (1U << FMB_LANES) - 1;
    minors_asker *ask = MINORS_ASKERS[what][dim - FMB_MINORS_LEAST_DIM];
    minors_said said = minors_silent();
    *waiting = asked & ask(&(minors_asked){.how = MINORS_AT_0, .few = few}, a, b, room, &said);
    if (*waiting)
        return (fmb_pair_bits){asked & ~*waiting, 0};
    if (what == FMB_MINORS_MOVING_SIMPLICES && !minors_all_apart(&said))
        ask(&(minors_asked){.how = MINORS_AT_1}, a, b, room, &said);
    fmb_pair_bits bits = minors_bits(&said);
    const unsigned open = asked & lane_bits(said.known) & ~(bits.apart | bits.meet);
    if (open) {
        const fmb_pair_bits more = minors_decide_open(dim, what, closed, a, b, room, open);
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

static unsigned minors_invert(int dim, double *const *record, unsigned n)
{
    const int begin = dim * (dim + 2), end = dim * (2 * dim + 3) + 2;
    const double *from[FMB_LANES];
    lane x[FMB_MINORS_MOST_RECORD];
    for (unsigned l = 0; l < FMB_LANES; l++)
        from[l] = record[l < n ? l : 0];
    minors_pack((begin + 3) / 4 * 4, from, x);
    unsigned good = minors_fill_records(dim, x) & ((1U << n) - 1);
    for (int r = dim; r < end; r++) {
        double row[FMB_LANES];
        lane_store(row, x[r]);
        for (unsigned l = 0; l < n; l++)
            record[l][r] = row[l];
    }
    return good;
}

static void minors_tiles(int dim, const double *record, const uint32_t *index, size_t n,
                         double *tiles)
{
    const int rows = fmb_minors_record(dim);
    for (size_t i = 0; i < (n + 7) / 8 * 8; i += FMB_LANES) {
        const double *from[FMB_LANES];
        lane out[FMB_MINORS_MOST_RECORD];
        for (size_t l = 0; l < FMB_LANES; l++)
            from[l] = record + (size_t)rows * index[i + l < n ? i + l : n - 1];
        minors_pack(rows, from, out);
        for (int r = 0; r < rows; r++, tiles += FMB_LANES)
            lane_store(tiles, out[r]);
    }
}

/* Places of pairs, in a row or among pairs by index, that wait to fill a block. Fewer than a block
 * wait when lanes of eight pairs are added, half of them at most, or of one if there are two. */
typedef struct minors_queue {
    size_t place[3 * FMB_LANES];
    size_t n;
} minors_queue;

static void minors_add_waiting(minors_queue *q, unsigned waiting, size_t first)
{
    for (; waiting; waiting &= waiting - 1)
        q->place[q->n++] = first + (size_t)__builtin_ctz(waiting);
}

/* Take the places of a block off the queue; returns how many these are. */
static size_t minors_take_waiting(minors_queue *q, size_t place[FMB_LANES])
{
    const size_t n = q->n < FMB_LANES ? q->n : FMB_LANES;
    q->n -= n;
    for (size_t l = 0; l < FMB_LANES; l++)
        place[l] = q->place[q->n + (l < n ? l : 0)];
    return n;
}

/* Answer frames of a row that wait, as one block. */
static void minors_answer_waiting_of_row(int dim, fmb_minors_what what, const fmb_packed_row *x,
                                         const lane *one, minors_queue *q, double *room,
                                         fmb_packed_bits *out)
{
    const int rows = fmb_minors_record(dim);
    size_t place[FMB_LANES], n = minors_take_waiting(q, place);
    const double *from[FMB_LANES];
    lane other[FMB_MINORS_MOST_RECORD];
    unsigned none;
    for (size_t l = 0; l < FMB_LANES; l++)
        from[l] = x->record + (size_t)rows * x->index[place[l]];
    minors_pack(rows, from, other);
    const lane *side[2] = {one, other};
    const fmb_pair_bits bits =
        minors_answer(dim, what, x->closed, side[x->swapped], side[!x->swapped], room, n, 0, &none);
    for (size_t l = 0; l < n; l++) {
        fmb_packed_bits *to = &out[place[l] / 8];
        to->apart = (uint8_t)(to->apart | (bits.apart >> l & 1) << place[l] % 8);
        to->meet = (uint8_t)(to->meet | (bits.meet >> l & 1) << place[l] % 8);
    }
}

static void minors_row(int dim, fmb_minors_what what, const fmb_packed_row *x, double *room,
                       fmb_packed_bits *out)
{
    const int rows = fmb_minors_record(dim);
    minors_queue q = {.n = 0};
    lane one[FMB_MINORS_MOST_RECORD];
    for (int r = 0; r < rows; r++)
        one[r] = lane_of(x->one[r]);
    for (uint64_t left = x->open; left; left &= left - 1) {
        const size_t g = (size_t)__builtin_ctzll(left);
        const double *tiles = x->tiles + 8 * g * (size_t)rows;
        out[g] = (fmb_packed_bits){0, 0};
        for (unsigned l = 0; l < 8; l += FMB_LANES, tiles += rows * FMB_LANES) {
            const lane *side[2] = {one, (const lane *)tiles};
            unsigned waiting;
            fmb_pair_bits some = minors_answer(
                dim, what, x->closed, side[x->swapped], side[!x->swapped], room,
                x->n > 8 * g + l ? x->n - 8 * g - l : 0, minors_few(dim, what), &waiting);
            out[g].apart = (uint8_t)(out[g].apart | some.apart << l);
            out[g].meet = (uint8_t)(out[g].meet | some.meet << l);
            minors_add_waiting(&q, waiting, 8 * g + l);
        }
        while (q.n >= FMB_LANES)
            minors_answer_waiting_of_row(dim, what, x, one, &q, room, out);
    }
    while (q.n > 0)
        minors_answer_waiting_of_row(dim, what, x, one, &q, room, out);
}

/* Answer the pairs at these places, as one block; returns the lanes that wait. */
static unsigned minors_answer_pairs(int dim, fmb_minors_what what, const fmb_packed_pairs *x,
                                    const size_t place[FMB_LANES], size_t n, int few, double *room,
                                    fmb_verdict *out)
{
    const int rows = fmb_minors_record(dim);
    lane side[2][FMB_MINORS_MOST_RECORD];
    unsigned waiting;
    for (int s = 0; s < 2; s++) {
        const double *from[FMB_LANES];
        for (size_t l = 0; l < FMB_LANES; l++)
            from[l] = x->record[s] + (size_t)rows * x->index[s][2 * place[l]];
        minors_pack(rows, from, side[s]);
    }
    fmb_pair_bits bits =
        minors_answer(dim, what, x->closed, side[0], side[1], room, n, few, &waiting);
    for (size_t l = 0; l < n; l++)
        if (!(waiting >> l & 1))
            out[place[l]] = bits.apart >> l & 1  ? FMB_INFEASIBLE
                            : bits.meet >> l & 1 ? FMB_FEASIBLE
                                                 : FMB_UNKNOWN;
    return waiting;
}

static bool minors_pairs(int dim, fmb_minors_what what, const fmb_packed_pairs *x, double *room,
                         fmb_verdict *out)
{
    minors_queue q = {.n = 0};
    size_t place[FMB_LANES];
    bool known = true;
    for (size_t i = 0; i < x->n; i += FMB_LANES) {
        const size_t n = x->n - i < FMB_LANES ? x->n - i : FMB_LANES;
        for (size_t l = 0; l < FMB_LANES; l++)
            place[l] = i + (l < n ? l : 0);
        const int few = x->n > FMB_LANES ? minors_few(dim, what) : 0;
        minors_add_waiting(&q, minors_answer_pairs(dim, what, x, place, n, few, room, out), i);
        if (q.n >= FMB_LANES) {
            const size_t taken = minors_take_waiting(&q, place);
            (void)minors_answer_pairs(dim, what, x, place, taken, 0, room, out);
        }
    }
    while (q.n > 0) {
        const size_t taken = minors_take_waiting(&q, place);
        (void)minors_answer_pairs(dim, what, x, place, taken, 0, room, out);
    }
    for (size_t i = 0; i < x->n; i++)
        known &= out[i] != FMB_UNKNOWN;
    return known;
}

extern const fmb_minor_kernels FMB_MINORS_TABLE;
const fmb_minor_kernels FMB_MINORS_TABLE = {
    .invert = minors_invert, .pairs = minors_pairs, .tiles = minors_tiles, .row = minors_row};

#endif
