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

/* Blocks by number: for verdicts [moves][kind], then for boxes [level][moves][shape of A][of B].
 * What a block leaves open goes to one with a higher number, or is settled without a block. */
enum { BOX_LEVELS = 2, BOX_BLOCKS = 2 * 2 * 2, FIRST_BOX = 2 * FMB_KINDS };
enum { BLOCKS = FIRST_BOX + BOX_LEVELS * BOX_BLOCKS };

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

/* What no kernel answers. */
static fmb_status decide_generally(const query *a, size_t i)
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
    return a->out->verdict[i] == FMB_FEASIBLE && a->boxes ? answer_generally(a, i) : FMB_OK;
}

/* Let pair i = (p, q) wait in a block. */
static fmb_status put(const query *a, int number, const fmb_frame *p, const fmb_frame *q, size_t i);

/* ---- boxes by kernels ------------------------------------------------------------------------ */

static void write_lane(const query *a, const double *answer, int width, int lane, size_t i)
{
    int dim = a->k->dim;
    fmb_pair_answers out = answers_of(a, i);
    const double *from = answer + lane;
    for (int j = 0; j < dim; j++) {
        const double *world = from + j * width, *inside = from + (2 * dim + j) * width;
        if (out.world) {
            out.world[2 * j] = world[0];
            out.world[2 * j + 1] = world[dim * width];
        }
        if (out.inside) {
            out.inside[2 * j] = inside[0];
            out.inside[2 * j + 1] = inside[dim * width];
        }
        if (out.witness)
            out.witness[j] = from[(4 * dim + 2 + j) * width];
    }
    for (int side = 0; out.time && side < 2; side++)
        out.time[side] = from[(4 * dim + side) * width];
}

/* The kernel of a level: at first that for boxes, then the fine one; NULL: there is none. */
static fmb_box_kernel *box_kernel(const query *a, int level, int which)
{
    int d = a->k->dim - 2, moves = which / 4, p = which / 2 % 2, q = which % 2;
    return level == 0   ? a->kernels->box[d][moves][p][q]
           : level == 1 ? a->kernels->fine[d][moves][p][q]
                        : NULL;
}

/* Pair i meets; a kernel said so. */
static fmb_status put_box(const query *a, int level, size_t i)
{
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    bool moves = p->speed || q->speed;
    int which = 4 * moves + 2 * (int)p->shape + (int)q->shape;
    if (a->k->options.tightest || !box_kernel(a, level, which))
        return answer_generally(a, i);
    return put(a, FIRST_BOX + BOX_BLOCKS * level + which, p, q, i);
}

/* Boxes of these lanes of a block. */
static fmb_status box_lanes(const query *a, const fmb_block *b, int level, int which,
                            unsigned lanes)
{
    double answer[FMB_BOX_MOST_ROWS * FMB_BLOCK_MOST_LANES];
    fmb_status st = FMB_OK;
    unsigned good = box_kernel(a, level, which)(b->number, answer);
    for (int lane = 0; st == FMB_OK && lane < b->lanes; lane++) {
        if (!(lanes >> lane & 1))
            continue;
        if (good >> lane & 1)
            write_lane(a, answer, a->kernels->width, lane, b->pair[lane]);
        else
            st = put_box(a, level + 1, b->pair[lane]);
    }
    return st;
}

static fmb_status flush_boxes(const query *a, const fmb_block *b, int level, int which)
{
    return box_lanes(a, b, level, which, ~0U);
}

/* ---- verdicts by kernels --------------------------------------------------------------------- */

static fmb_verdict_kernel *verdict_kernel(const query *a, int which)
{
    int d = a->k->dim - 2, moves = which / FMB_KINDS, kind = which % FMB_KINDS;
    return a->k->options.method == FMB_PAIR_SAT ? a->kernels->sat[d][moves][kind]
                                                : a->kernels->fmb[d][moves][kind];
}

/* Do these lanes go on to boxes as they stand? Where most lanes do not meet, it is cheaper to put
 * those that do into a block of their own, and that must be where a pair was swapped. */
static unsigned stay(const query *a, const fmb_block *b, int which, unsigned meet)
{
    unsigned lanes = 0;
    int moves = which / FMB_KINDS, kind = which % FMB_KINDS;
    meet &= (1U << b->lanes) - 1;
    if (!a->boxes || a->k->options.tightest || 2 * __builtin_popcount(meet) <= a->kernels->width ||
        !a->kernels->box[a->k->dim - 2][moves][kind == FMB_KIND_TT][kind != FMB_KIND_CC])
        return 0;
    for (int lane = 0; lane < b->lanes; lane++)
        if (meet >> lane & 1 && (kind != FMB_KIND_CT || a->p[b->pair[lane]].shape == FMB_CUBOID))
            lanes |= 1U << lane;
    return lanes;
}

static fmb_status flush_verdicts(const query *a, const fmb_block *b, int which)
{
    static const int shapes[FMB_KINDS] = {[FMB_KIND_CC] = 0, [FMB_KIND_CT] = 1, [FMB_KIND_TT] = 3};
    fmb_pair_bits bits = verdict_kernel(a, which)(b->number);
    unsigned boxed = stay(a, b, which, bits.meet & ~bits.apart);
    fmb_status st = FMB_OK;
    for (int lane = 0; st == FMB_OK && lane < b->lanes; lane++) {
        size_t i = b->pair[lane];
        if (bits.apart >> lane & 1) {
            a->out->verdict[i] = FMB_INFEASIBLE;
        } else if (bits.meet >> lane & 1) {
            a->out->verdict[i] = FMB_FEASIBLE;
            st = a->boxes && !(boxed >> lane & 1) ? put_box(a, 0, i) : FMB_OK;
        } else {
            st = decide_generally(a, i);
        }
    }
    if (st == FMB_OK && boxed)
        st = box_lanes(a, b, 0, 4 * (which / FMB_KINDS) + shapes[which % FMB_KINDS], boxed);
    return st;
}

static bool has_all_axes(const fmb_frame *f, int dim)
{
    return f->naxes == dim && f->origin && f->axes && (unsigned)f->shape <= FMB_SIMPLEX;
}

static fmb_status put_pair(const query *a, size_t i)
{
    fmb_pair *k = a->k;
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    if (p->dim != k->dim || q->dim != k->dim)
        return FMB_ERR_ARG;
    if (k->dim < 2 || k->dim > 3 || k->options.method == FMB_PAIR_EXACT ||
        !has_all_axes(p, k->dim) || !has_all_axes(q, k->dim))
        return decide_generally(a, i);
    bool swap = p->shape == FMB_SIMPLEX && q->shape == FMB_CUBOID;
    int which = FMB_KINDS * (p->speed || q->speed) + (int)p->shape + (int)q->shape;
    return put(a, which, swap ? q : p, swap ? p : q, i);
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
    int box = number - FIRST_BOX;
    fill_up(b, a->kernels->width);
    fmb_status st = box < 0 ? flush_verdicts(a, b, number)
                            : flush_boxes(a, b, box / BOX_BLOCKS, box % BOX_BLOCKS);
    b->lanes = 0;
    a->k->waiting &= ~(UINT32_C(1) << number);
    return st;
}

static fmb_status put(const query *a, int number, const fmb_frame *p, const fmb_frame *q, size_t i)
{
    fmb_block *b = &a->k->block[number];
    bool moves = p->speed || q->speed;
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
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        st = put_pair(&a, i);
    while (st == FMB_OK && k->waiting)
        st = flush(&a, __builtin_ctz(k->waiting));
    forget(k);
    k->counts.pairs += n;
    return st;
}
