/* pair_portfolio.c: see pair_portfolio.h. */
#include "pair/pair_portfolio.h"

#include "base/ways.h"
#include "pair/kernels/packed_kernels.h"
#include "pair/minors_of_frames.h"
#include "pair/single_pair.h"

/* Put pair i into a block of that stage. */
static fmb_status wait_in_block(const fmb_pair_call *a, int stage, size_t i);
/* Put pair i into the block for any number of axes, if its edges are doubles. */
static fmb_status wait_in_flat_block(const fmb_pair_call *a, size_t i);

/* ---- boxes by kernels ------------------------------------------------------------------------ */

/* Write rows of lower ends, then of upper ends, as pairs (lower, upper). */
FMB_BLOCK_INLINE void write_ends(int dim, const double *from, int width, double *to)
{
#pragma GCC unroll 3
    for (int j = 0; j < dim; j++) {
        to[2 * j] = from[j * width];
        to[2 * j + 1] = from[(dim + j) * width];
    }
}

/* dim is constant. */
FMB_BLOCK_INLINE void write_lane_of_box(int dim, const fmb_pair_answers *out, const double *from,
                                        int width, size_t i)
{
    size_t d = (size_t)dim;
    if (out->world)
        write_ends(dim, from, width, out->world + 2 * d * i);
    if (out->inside)
        write_ends(dim, from + 2 * dim * width, width, out->inside + 2 * d * i);
    if (out->time)
        write_ends(1, from + 4 * dim * width, width, out->time + 2 * i);
    for (int j = 0; out->witness && j < dim; j++)
        out->witness[d * i + (size_t)j] = from[(4 * dim + 2 + j) * width];
}

static void write_lanes(const fmb_pair_call *a, const fmb_block *b, unsigned lanes,
                        const double *answer)
{
    for (; lanes; lanes &= lanes - 1) {
        int lane = __builtin_ctz(lanes);
        if (a->k->dim == 2)
            write_lane_of_box(2, a->out, answer + lane, a->kernels->width, b->pair[lane]);
        else
            write_lane_of_box(3, a->out, answer + lane, a->kernels->width, b->pair[lane]);
    }
}

/* The kernel of a stage; NULL: there is none. */
static fmb_box_kernel *kernel_of_boxes(const fmb_pair_call *a, int stage, int kind)
{
    return a->k->options.tightest ? NULL
                                  : a->kernels->box[stage - STAGE_BOX][a->k->dim - 2][kind / 4];
}

/* Find the box of pair i, which meets by a kernel. */
static fmb_status find_box_from_stage(const fmb_pair_call *a, int stage, int kind, size_t i)
{
    return stage < STAGES && kernel_of_boxes(a, stage, kind) ? wait_in_block(a, stage, i)
                                                             : fmb_single_pair_answer(a, i);
}

/* Boxes of these lanes of a block. */
static fmb_status find_boxes_of_lanes(const fmb_pair_call *a, const fmb_block *b, int stage,
                                      int kind, unsigned lanes)
{
    _Alignas(64) double answer[FMB_BOX_MOST_ROWS * FMB_BLOCK_MOST_LANES];
    unsigned good =
        kernel_of_boxes(a, stage, kind)(kind / 4, kind / 2 % 2, kind % 2, b->number, answer);
    fmb_status st = FMB_OK;
    write_lanes(a, b, lanes & good, answer);
    for (lanes &= ~good; st == FMB_OK && lanes; lanes &= lanes - 1)
        st = find_box_from_stage(a, stage + 1, kind, b->pair[__builtin_ctz(lanes)]);
    return st;
}

/* ---- verdicts -------------------------------------------------------------------------------- */

/* Decide a pair that kernels left open. Kernels may still find its box, from that stage on. */
static fmb_status decide_generally(const fmb_pair_call *a, int stage, int kind, size_t i)
{
    fmb_pair *k = a->k;
    if (!fmb_single_pair_is_good(a, i))
        return fmb_single_pair_refuse(a, i);
    a->out->verdict[i] = FMB_UNKNOWN;
    if (k->options.method != FMB_PAIR_EXACT && !fmb_pair_is_cancelled(k))
        fmb_single_pair_decide(a, i, &a->out->verdict[i]);
    if (a->out->verdict[i] == FMB_UNKNOWN)
        return fmb_single_pair_decide_exactly(a, i);
    return a->out->verdict[i] == FMB_FEASIBLE && a->boxes ? find_box_from_stage(a, stage, kind, i)
                                                          : FMB_OK;
}

static fmb_verdict_kernel *verdict_kernel(const fmb_pair_call *a, int kind)
{
    return a->kernels->verdict[a->k->dim - 2][kind / 4][kind / 2 % 2][kind % 2];
}

static unsigned lanes_taken(const fmb_block *b)
{
    return (1U << b->lanes) - 1;
}

/* If most lanes meet, their boxes are found in the same block; else it is cheaper to put them into
 * another block. */
static fmb_status flush_verdicts(const fmb_pair_call *a, const fmb_block *b, int kind)
{
    fmb_pair_bits bits = verdict_kernel(a, kind)(b->number);
    unsigned boxed = a->boxes ? bits.meet & ~bits.apart & lanes_taken(b) : 0;
    bool stay = 2 * __builtin_popcount(boxed) > b->lanes && kernel_of_boxes(a, STAGE_BOX, kind);
    for (int lane = 0; lane < b->lanes; lane++) {
        size_t i = b->pair[lane];
        fmb_way_answered(FMB_WAY_PAIR_KERNELS, (bits.apart | bits.meet) >> lane & 1);
        if (bits.apart >> lane & 1) {
            a->out->verdict[i] = FMB_INFEASIBLE;
        } else if (bits.meet >> lane & 1) {
            a->out->verdict[i] = FMB_FEASIBLE;
            FMB_TRY(a->boxes && !stay ? find_box_from_stage(a, STAGE_BOX, kind, i) : FMB_OK);
        } else {
            FMB_TRY(decide_generally(a, STAGE_BOX, kind, i));
        }
    }
    return stay ? find_boxes_of_lanes(a, b, STAGE_BOX, kind, boxed) : FMB_OK;
}

/* Take what kernels that have no boxes say of pair i; if they leave it open, `open` decides. */
static fmb_status take_verdict(const fmb_pair_call *a, size_t i, bool meet, bool apart,
                               const fmb_pair_call *open)
{
    if (!meet && !apart)
        return decide_generally(open, STAGES, 0, i);
    a->out->verdict[i] = meet ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return meet && a->boxes ? fmb_single_pair_answer(a, i) : FMB_OK;
}

/* Decide the block of frames with any number of axes. */
static fmb_status flush_flat_verdicts(const fmb_pair_call *a, const fmb_block *b)
{
    fmb_pair_bits bits = a->kernels->packed->flat(&a->k->flat, b->number);
    for (int lane = 0; lane < b->lanes; lane++) {
        bool meet = bits.meet >> lane & 1, apart = bits.apart >> lane & 1;
        fmb_way_answered(FMB_WAY_PAIR_FLAT, meet || apart);
        FMB_TRY(take_verdict(a, b->pair[lane], meet, apart, a));
    }
    return FMB_OK;
}

/* ---- four to eight dimensions ---------------------------------------------------------------- */

/* Decide the pairs of a block in four to eight dimensions. */
static fmb_status flush_minors(const fmb_pair_call *a, fmb_minors_what what)
{
    fmb_minor_block *b = &a->k->minor[what];
    fmb_pair_call open = *a;
    fmb_pair_bits bits = {0, 0};
    fmb_status st = FMB_OK;
    unsigned made = 0;
    const int n = b->n;
    b->n = 0;
    if (fmb_minors_of_frames_pay(a, n))
        bits = fmb_minors_of_frames(a, what, b->pair, n, &made);
    open.known = FMB_PAIR_OPEN;
    for (int l = 0; st == FMB_OK && l < n; l++) {
        const bool meet = bits.meet >> l & 1, apart = bits.apart >> l & 1;
        fmb_way_answered(FMB_WAY_PAIR_KERNELS, meet || apart);
        st = take_verdict(a, b->pair[l], meet, apart, made >> l & 1 ? &open : a);
    }
    return st;
}

static fmb_status wait_for_minors(const fmb_pair_call *a, fmb_minors_what what, size_t i)
{
    fmb_minor_block *b = &a->k->minor[what];
    b->pair[b->n++] = i;
    return b->n == FMB_MINOR_PAIRS ? flush_minors(a, what) : FMB_OK;
}

/* Shall pair i wait? Then *what is its kind. */
static bool is_for_minors(const fmb_pair_call *a, size_t i, fmb_minors_what *what)
{
    return !a->alone && a->known == FMB_PAIR_NEW && a->k->options.method != FMB_PAIR_EXACT &&
           fmb_minors_of_frames_kind(a, i, what) && fmb_way(FMB_WAY_PAIR_KERNELS);
}

/* ---- one pair after another ------------------------------------------------------------------ */

/* Has the frame all axes, and edges that are doubles? */
static bool has_all_axes(const fmb_frame *f, int dim)
{
    fmb_corner_edges ignored;
    return f->naxes == dim && f->origin && f->axes &&
           ((unsigned)f->shape <= FMB_SIMPLEX ||
            (fmb_frame_is_by_corners(f->shape) && fmb_edges_of_frame(f, &ignored)));
}

/* How many pairs ahead frames are prefetched, before they are put into blocks. */
enum { AHEAD = 12 };

/* Two lines of the cache. The second address is a number, as the axes may be few, or missing. */
static void prefetch_axes(const fmb_frame *f)
{
    __builtin_prefetch(f->axes);
    __builtin_prefetch((const void *)((uintptr_t)f->axes + 64));
}

static void prefetch_frames(const fmb_frame *p, const fmb_frame *q)
{
    prefetch_axes(p);
    prefetch_axes(q);
}

static fmb_status answer_or_wait(const fmb_pair_call *a, size_t i)
{
    fmb_pair *k = a->k;
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    if (p->dim != k->dim || q->dim != k->dim)
        return fmb_single_pair_refuse(a, i);
    fmb_minors_what what;
    if (is_for_minors(a, i, &what))
        return wait_for_minors(a, what, i);
    if (k->dim < 2 || k->dim > 3 || k->options.method == FMB_PAIR_EXACT ||
        fmb_single_pair_is_of_hulls(p, q))
        return decide_generally(a, STAGES, 0, i);
    if (has_all_axes(p, k->dim) && has_all_axes(q, k->dim))
        return fmb_way(FMB_WAY_PAIR_KERNELS) ? wait_in_block(a, STAGE_VERDICT, i)
                                             : decide_generally(a, STAGES, 0, i);
    return fmb_way(FMB_WAY_PAIR_FLAT) ? wait_in_flat_block(a, i)
                                      : decide_generally(a, STAGES, 0, i);
}

/* ---- blocks ---------------------------------------------------------------------------------- */

/* Unused lanes repeat the first. */
static void fill_unused_lanes(fmb_block *b, int width)
{
    for (int r = 0; b->lanes < width && r < FMB_BLOCK_MOST_ROWS; r++)
        for (int lane = b->lanes; lane < width; lane++)
            b->number[r * width + lane] = b->number[r * width];
}

static fmb_status flush_block(const fmb_pair_call *a, int number)
{
    fmb_block *b = &a->k->block[number];
    int stage = number / KINDS, kind = number % KINDS;
    if (!a->alone || number == FLAT_BLOCK)
        fill_unused_lanes(b, a->kernels->width);
    fmb_status st = number == FLAT_BLOCK ? flush_flat_verdicts(a, b)
                    : stage == STAGE_VERDICT
                        ? flush_verdicts(a, b, kind)
                        : find_boxes_of_lanes(a, b, stage, kind, lanes_taken(b));
    b->lanes = 0;
    a->k->waiting &= ~(UINT64_C(1) << number);
    return st;
}

static fmb_status wait_in_block(const fmb_pair_call *a, int stage, size_t i)
{
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    fmb_corner_edges of_p, of_q;
    if (((unsigned)p->shape | (unsigned)q->shape) > FMB_SIMPLEX &&
        fmb_single_pair_edges(a, i, &of_p, &of_q)) {
        p = &of_p.frame;
        q = &of_q.frame;
    }
    bool moves = p->speed || q->speed;
    int number = KINDS * stage + 4 * moves + 2 * (int)p->shape + (int)q->shape;
    fmb_block *b = &a->k->block[number];
    if (a->alone)
        fmb_block_put_alone(b, a->kernels->width, p, q, moves, a->boxes);
    else
        fmb_block_put(b, a->kernels->width, p, q, moves, a->boxes, i);
    a->k->waiting |= UINT64_C(1) << number;
    return b->lanes == a->kernels->width ? flush_block(a, number) : FMB_OK;
}

static bool is_flat_kind(const fmb_flat_kind *k, bool moves, const fmb_frame *p, const fmb_frame *q)
{
    return k->moves == moves && k->side[0].naxes == p->naxes && k->side[1].naxes == q->naxes &&
           k->side[0].simplex == (bool)p->shape && k->side[1].simplex == (bool)q->shape;
}

/* The block holds one kind at a time: a pair of another kind flushes it first. */
static fmb_status prepare_flat_block(const fmb_pair_call *a, const fmb_frame *p, const fmb_frame *q)
{
    const int naxes[2] = {p->naxes, q->naxes};
    const bool simplex[2] = {p->shape, q->shape}, moves = p->speed || q->speed;
    fmb_pair *k = a->k;
    fmb_status st = FMB_OK;
    if (k->flat.dim > 0 && is_flat_kind(&k->flat, moves, p, q))
        return FMB_OK;
    if (k->block[FLAT_BLOCK].lanes > 0)
        st = flush_block(a, FLAT_BLOCK);
    fmb_flat_kind_of(k->dim, moves, naxes, simplex, &k->flat);
    return st;
}

static fmb_status wait_in_flat_block(const fmb_pair_call *a, size_t i)
{
    fmb_pair *k = a->k;
    fmb_block *b = &k->block[FLAT_BLOCK];
    fmb_corner_edges p, q;
    if (!fmb_single_pair_is_good(a, i) || !fmb_single_pair_edges(a, i, &p, &q))
        return decide_generally(a, STAGES, 0, i);
    fmb_status st = prepare_flat_block(a, &p.frame, &q.frame);
    int width = a->kernels->width;
    fmb_block_put_flat(b, width, &p.frame, &q.frame, i);
    k->waiting |= UINT64_C(1) << FLAT_BLOCK;
    return st == FMB_OK && b->lanes == width ? flush_block(a, FLAT_BLOCK) : st;
}

static void forget_waiting_pairs(fmb_pair *k)
{
    for (int number = 0; k->waiting && number < BLOCKS; number++)
        k->block[number].lanes = 0;
    k->waiting = 0;
    for (int what = 0; what < FMB_MINORS_WHATS; what++)
        k->minor[what].n = 0;
}

/* Pairs between two checks for a cancel; slow pairs check themselves. */
enum { PAIRS_AT_ONCE = 256 };

/* Are both frames of pair i by edges, still, with all axes, and of the shapes of pair `first`? */
static bool is_plain_pair(const fmb_pair_call *a, size_t first, size_t i)
{
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    int dim = a->k->dim;
    int differ = (p->dim ^ dim) | (q->dim ^ dim) | (p->naxes ^ dim) | (q->naxes ^ dim) |
                 (int)(p->shape ^ a->p[first].shape) | (int)(q->shape ^ a->q[first].shape);
    return differ == 0 && p->origin && p->axes && !p->speed && q->origin && q->axes && !q->speed;
}

/* Do the next pairs fill a block, all of them plain and of one kind? */
static bool is_plain_block(const fmb_pair_call *a, size_t from, size_t to)
{
    const size_t width = (size_t)a->kernels->width;
    size_t n = 0;
    if (to - from < width ||
        ((unsigned)a->p[from].shape | (unsigned)a->q[from].shape) > FMB_SIMPLEX)
        return false;
    while (n < width && is_plain_pair(a, from, from + n))
        n++;
    return n == width;
}

/* Answer a block of plain pairs, of which only verdicts are requested. */
static fmb_status answer_plain_block(const fmb_pair_call *a, size_t from)
{
    const fmb_frame *p = &a->p[from], *q = &a->q[from];
    bool swap = p->shape == FMB_SIMPLEX && q->shape == FMB_CUBOID;
    fmb_block b;
    b.lanes = a->kernels->width;
    for (int lane = 0; lane < b.lanes; lane++)
        b.pair[lane] = from + (size_t)lane;
    a->kernels->packed->load(a->k->dim, swap ? q : p, swap ? p : q, b.number);
    return flush_verdicts(a, &b, 2 * (int)p->shape + (int)q->shape);
}

/* Answer the pairs from `from` to `to` - 1. If a block is not plain, its pairs are taken one after
 * another, so that mixed pairs are rarely tested twice. */
static fmb_status answer_some(const fmb_pair_call *a, size_t from, size_t to, size_t n)
{
    const size_t width = (size_t)a->kernels->width;
    const bool blocks = !a->boxes && (a->k->dim == 2 || a->k->dim == 3) &&
                        a->k->options.method != FMB_PAIR_EXACT && fmb_way(FMB_WAY_PAIR_KERNELS);
    for (size_t i = from, end; i < to; i = end) {
        end = to - i < width ? to : i + width;
        for (size_t j = i + AHEAD; j < end + AHEAD && j < n; j++)
            prefetch_frames(&a->p[j], &a->q[j]);
        bool whole = blocks && is_plain_block(a, i, to);
        if (whole)
            FMB_TRY(answer_plain_block(a, i));
        for (size_t j = i; !whole && j < end; j++)
            FMB_TRY(answer_or_wait(a, j));
    }
    return FMB_OK;
}

fmb_status fmb_pair_answer_all(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                               fmb_pair_known known, const fmb_pair_answers *out)
{
    fmb_pair_call a = {k,
                       p,
                       q,
                       out,
                       out->world || out->inside || out->time || out->witness,
                       n == 1,
                       known,
                       n == 1 ? k->one : k->wide};
    fmb_status st = FMB_OK;
    size_t next = 0;
    while (st == FMB_OK && next < n && !fmb_pair_is_cancelled(k)) {
        size_t from = next;
        next = n - from < PAIRS_AT_ONCE ? n : from + PAIRS_AT_ONCE;
        st = answer_some(&a, from, next, n);
    }
    for (size_t i = next; st == FMB_OK && i < n; i++)
        out->verdict[i] = FMB_UNKNOWN;
    while (st == FMB_OK && k->waiting)
        st = flush_block(&a, __builtin_ctzll(k->waiting));
    for (int what = 0; st == FMB_OK && what < FMB_MINORS_WHATS; what++)
        st = k->minor[what].n > 0 ? flush_minors(&a, (fmb_minors_what)what) : FMB_OK;
    forget_waiting_pairs(k);
    return st;
}
