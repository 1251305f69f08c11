/* pair.c: see fmb/pair.h.
 *
 * The ladder: kernels (two and three dimensions, all axes), the general way in doubles, the exact
 * query. Pairs for the kernels wait in blocks, one for each kind, until a block is full; the rest
 * is answered at once.
 */
#include <fmb/pair.h>

#include <stdatomic.h>

#include "base/mem.h"
#include "frame/frame.h"
#include "pair/block.h"
#include "pair/exact.h"
#include "pair/general.h"

/* Blocks by number: [stage][kind], where a kind is [moves][shape of A][shape of B]. What a block
 * leaves open goes to one of a later stage, or is settled without a block. */
enum { STAGE_VERDICT, STAGE_BOX, STAGES = STAGE_BOX + FMB_BOX_LEVELS };
enum { KINDS = 2 * 2 * 2, BLOCKS = STAGES * KINDS };

struct fmb_pair {
    fmb_mem mem;
    fmb_pair_options options;
    int dim;
    const fmb_pair_kernels *wide;
    fmb_general *general;
    fmb_pair_oracle oracle;
    fmb_pair_counts counts;
    atomic_bool cancelled;
    uint32_t waiting; /* the blocks that are not empty */
    fmb_block block[BLOCKS];
};

/* One call of fmb_pair_test. */
typedef struct query {
    fmb_pair *k;
    const fmb_frame *p, *q;
    const fmb_pair_answers *out;
    bool boxes;                      /* more than the verdict is wanted */
    const fmb_pair_kernels *kernels; /* a single pair needs no wide ones */
} query;

/* ---- life ------------------------------------------------------------------------------------ */

fmb_pair_options fmb_pair_options_default(void)
{
    return (fmb_pair_options){0};
}

static bool are_options(const fmb_pair_options *o)
{
    return (unsigned)o->contact <= FMB_CONTACT_OPEN && (unsigned)o->method <= FMB_PAIR_EXACT &&
           o->max_seconds >= 0 && fmb_pair_kernels_choose(o->simd);
}

fmb_status fmb_pair_new(int dim, const fmb_pair_options *o, const fmb_alloc *hook, fmb_pair **out)
{
    fmb_pair_options usual = fmb_pair_options_default();
    fmb_mem mem;
    o = o ? o : &usual;
    if (!out || dim < 1 || !are_options(o))
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, hook, 0);
    fmb_pair *k = fmb_mem_zero(&mem, 1, sizeof *k);
    if (!k)
        return fmb_mem_status(&mem);
    k->mem = mem;
    k->options = *o;
    k->dim = dim;
    k->wide = fmb_pair_kernels_choose(o->simd);
    k->general = fmb_general_new(dim, o->simd, &k->mem);
    fmb_status st = k->general ? fmb_pair_oracle_open(&k->oracle, o, hook) : FMB_ERR_MEMORY;
    if (st == FMB_OK)
        *out = k;
    else
        fmb_pair_free(k);
    return st;
}

void fmb_pair_free(fmb_pair *k)
{
    if (!k)
        return;
    fmb_pair_oracle_close(&k->oracle);
    fmb_general_free(k->general, &k->mem);
    fmb_mem mem = k->mem;
    fmb_mem_put(&mem, k, 1, sizeof *k);
}

fmb_pair_counts fmb_pair_count(const fmb_pair *k)
{
    return k->counts;
}

void fmb_pair_cancel(fmb_pair *k)
{
    atomic_store(&k->cancelled, true);
    fmb_solver_cancel(k->oracle.solver);
    fmb_solver_cancel(k->oracle.proving);
}

/* ---- one pair -------------------------------------------------------------------------------- */

/* The places of pair i. */
static fmb_pair_answers answers_of(const query *a, size_t i)
{
    size_t dim = (size_t)a->k->dim;
    const fmb_pair_answers *o = a->out;
    return (fmb_pair_answers){.verdict = o->verdict + i,
                              .world = o->world ? o->world + 2 * dim * i : NULL,
                              .inside = o->inside ? o->inside + 2 * dim * i : NULL,
                              .time = o->time ? o->time + 2 * i : NULL,
                              .witness = o->witness ? o->witness + dim * i : NULL};
}

static bool asks_exactly(const query *a)
{
    return !a->k->options.doubles_only && !atomic_load(&a->k->cancelled);
}

/* More than a verdict, which is FEASIBLE. */
static fmb_status answer_exactly(const query *a, size_t i)
{
    fmb_pair_answers out = answers_of(a, i);
    if (!asks_exactly(a)) {
        *out.verdict = FMB_UNKNOWN;
        return FMB_OK;
    }
    a->k->counts.exact_boxes++;
    return fmb_pair_oracle_answer(&a->k->oracle, &a->p[i], &a->q[i], &out);
}

/* The same, in doubles if they are good enough. */
static fmb_status answer_generally(const query *a, size_t i)
{
    const fmb_pair *k = a->k;
    fmb_pair_answers out = answers_of(a, i);
    if (k->options.method != FMB_PAIR_EXACT && !k->options.tightest &&
        fmb_general_answer(k->general, &a->p[i], &a->q[i], &out))
        return FMB_OK;
    return answer_exactly(a, i);
}

static fmb_status decide_exactly(const query *a, size_t i)
{
    fmb_verdict *out = &a->out->verdict[i];
    *out = FMB_UNKNOWN;
    if (!asks_exactly(a))
        return FMB_OK;
    a->k->counts.exact_verdicts++;
    fmb_status st = fmb_pair_oracle_decide(&a->k->oracle, &a->p[i], &a->q[i], out);
    return st == FMB_OK && *out == FMB_FEASIBLE && a->boxes ? answer_exactly(a, i) : st;
}

/* Let pair i wait in a block of that stage. */
static fmb_status put(const query *a, int stage, size_t i);

/* ---- boxes by kernels ------------------------------------------------------------------------ */

/* Rows of lower, then of upper ends, in turn. */
static inline __attribute__((always_inline)) void write_ends(int dim, const double *from, int width,
                                                             double *to)
{
#pragma GCC unroll 3
    for (int j = 0; j < dim; j++) {
        to[2 * j] = from[j * width];
        to[2 * j + 1] = from[(dim + j) * width];
    }
}

/* dim is constant. */
static inline __attribute__((always_inline)) void
write_lane(int dim, const fmb_pair_answers *out, const double *from, int width, size_t i)
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

static void write_lanes(const query *a, const fmb_block *b, unsigned lanes, const double *answer)
{
    for (; lanes; lanes &= lanes - 1) {
        int lane = __builtin_ctz(lanes);
        if (a->k->dim == 2)
            write_lane(2, a->out, answer + lane, a->kernels->width, b->pair[lane]);
        else
            write_lane(3, a->out, answer + lane, a->kernels->width, b->pair[lane]);
    }
}

/* The kernel of a stage; NULL: there is none. */
static fmb_box_kernel *box_kernel(const query *a, int stage, int kind)
{
    fmb_box_kernel *const(*of)[2][2][2] = a->kernels->box[stage - STAGE_BOX];
    return a->k->options.tightest ? NULL : of[a->k->dim - 2][kind / 4][kind / 2 % 2][kind % 2];
}

/* Pair i meets; a kernel said so. */
static fmb_status put_box(const query *a, int stage, int kind, size_t i)
{
    return stage < STAGES && box_kernel(a, stage, kind) ? put(a, stage, i) : answer_generally(a, i);
}

/* Boxes of these lanes of a block. */
static fmb_status box_lanes(const query *a, const fmb_block *b, int stage, int kind, unsigned lanes)
{
    _Alignas(64) double answer[FMB_BOX_MOST_ROWS * FMB_BLOCK_MOST_LANES];
    unsigned good = box_kernel(a, stage, kind)(b->number, answer);
    fmb_status st = FMB_OK;
    write_lanes(a, b, lanes & good, answer);
    for (lanes &= ~good; st == FMB_OK && lanes; lanes &= lanes - 1)
        st = put_box(a, stage + 1, kind, b->pair[__builtin_ctz(lanes)]);
    return st;
}

/* ---- verdicts --------------------------------------------------------------------- */

/* What no kernel decides. Then its box may still be one for kernels, from that stage on. */
static fmb_status decide_generally(const query *a, int stage, int kind, size_t i)
{
    fmb_pair *k = a->k;
    if (!fmb_frame_is_good(&a->p[i], k->dim) || !fmb_frame_is_good(&a->q[i], k->dim))
        return FMB_ERR_ARG;
    if (k->options.method != FMB_PAIR_EXACT)
        a->out->verdict[i] = fmb_general_decide(k->general, &a->p[i], &a->q[i]);
    else
        a->out->verdict[i] = FMB_UNKNOWN;
    if (a->out->verdict[i] == FMB_UNKNOWN)
        return decide_exactly(a, i);
    return a->out->verdict[i] == FMB_FEASIBLE && a->boxes ? put_box(a, stage, kind, i) : FMB_OK;
}

static fmb_verdict_kernel *verdict_kernel(const query *a, int kind)
{
    fmb_verdict_kernel *const(*of)[2][2][2] =
        a->k->options.method == FMB_PAIR_SAT ? a->kernels->sat : a->kernels->fmb;
    return of[a->k->dim - 2][kind / 4][kind / 2 % 2][kind % 2];
}

static unsigned taken(const fmb_block *b)
{
    return (1U << b->lanes) - 1;
}

/* Where most lanes meet, they go on to boxes as they stand; else it is cheaper to put them into a
 * block of their own. */
static fmb_status flush_verdicts(const query *a, const fmb_block *b, int kind)
{
    fmb_pair_bits bits = verdict_kernel(a, kind)(b->number);
    unsigned boxed = a->boxes ? bits.meet & ~bits.apart & taken(b) : 0;
    bool stay = 2 * __builtin_popcount(boxed) > a->kernels->width && box_kernel(a, STAGE_BOX, kind);
    fmb_status st = FMB_OK;
    for (int lane = 0; st == FMB_OK && lane < b->lanes; lane++) {
        size_t i = b->pair[lane];
        if (bits.apart >> lane & 1) {
            a->out->verdict[i] = FMB_INFEASIBLE;
        } else if (bits.meet >> lane & 1) {
            a->out->verdict[i] = FMB_FEASIBLE;
            st = a->boxes && !stay ? put_box(a, STAGE_BOX, kind, i) : FMB_OK;
        } else {
            st = decide_generally(a, STAGE_BOX, kind, i);
        }
    }
    return st == FMB_OK && stay ? box_lanes(a, b, STAGE_BOX, kind, boxed) : st;
}

static bool has_all_axes(const fmb_frame *f, int dim)
{
    return f->naxes == dim && f->origin && f->axes && (unsigned)f->shape <= FMB_SIMPLEX;
}

/* Frames that are soon put into blocks: their numbers may still be far from the processor. */
enum { AHEAD = 12 };

static void expect(const fmb_frame *p, const fmb_frame *q)
{
    __builtin_prefetch(p->axes);
    __builtin_prefetch(p->axes + 8);
    __builtin_prefetch(q->axes);
    __builtin_prefetch(q->axes + 8);
}

static fmb_status put_pair(const query *a, size_t i)
{
    fmb_pair *k = a->k;
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    if (p->dim != k->dim || q->dim != k->dim)
        return FMB_ERR_ARG;
    if (k->dim < 2 || k->dim > 3 || k->options.method == FMB_PAIR_EXACT ||
        !has_all_axes(p, k->dim) || !has_all_axes(q, k->dim))
        return decide_generally(a, STAGES, 0, i);
    return put(a, STAGE_VERDICT, i);
}

/* ---- blocks ---------------------------------------------------------------------------------- */

/* Unused lanes repeat the first. */
static void fill_up(fmb_block *b, int width)
{
    for (int r = 0; b->lanes < width && r < FMB_BLOCK_MOST_ROWS; r++)
        for (int lane = b->lanes; lane < width; lane++)
            b->number[r * width + lane] = b->number[r * width];
}

static fmb_status flush(const query *a, int number)
{
    fmb_block *b = &a->k->block[number];
    int stage = number / KINDS, kind = number % KINDS;
    fill_up(b, a->kernels->width);
    fmb_status st = stage == STAGE_VERDICT ? flush_verdicts(a, b, kind)
                                           : box_lanes(a, b, stage, kind, taken(b));
    b->lanes = 0;
    a->k->waiting &= ~(UINT32_C(1) << number);
    return st;
}

static fmb_status put(const query *a, int stage, size_t i)
{
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    bool moves = p->speed || q->speed;
    int number = KINDS * stage + 4 * moves + 2 * (int)p->shape + (int)q->shape;
    fmb_block *b = &a->k->block[number];
    fmb_block_put(b, a->kernels->width, p, q, moves, a->boxes, i);
    a->k->waiting |= UINT32_C(1) << number;
    return b->lanes == a->kernels->width ? flush(a, number) : FMB_OK;
}

static void forget(fmb_pair *k)
{
    for (int number = 0; k->waiting && number < BLOCKS; number++)
        k->block[number].lanes = 0;
    k->waiting = 0;
}

fmb_status fmb_pair_test(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                         const fmb_pair_answers *out)
{
    if (!k || !out || (n > 0 && (!p || !q || !out->verdict)))
        return FMB_ERR_ARG;
    query a = {k,
               p,
               q,
               out,
               out->world || out->inside || out->time || out->witness,
               n == 1 ? &fmb_pair_kernels_one : k->wide};
    fmb_status st = FMB_OK;
    atomic_store_explicit(&k->cancelled, false, memory_order_relaxed);
    for (size_t i = 0; st == FMB_OK && i < n; i++) {
        if (i + AHEAD < n)
            expect(&p[i + AHEAD], &q[i + AHEAD]);
        st = put_pair(&a, i);
    }
    while (st == FMB_OK && k->waiting)
        st = flush(&a, __builtin_ctz(k->waiting));
    forget(k);
    k->counts.pairs += n;
    return st;
}
