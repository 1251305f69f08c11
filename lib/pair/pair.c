/* pair.c: see fmb/pair.h; how answers are found: pair_portfolio.h. */
#include <fmb/pair.h>

#include <stdio.h>

#include "base/sized.h"
#include "pair/kernels/minors_kernels.h"
#include "pair/pair_contact.h"
#include "pair/pair_portfolio.h"

/* ---- life ------------------------------------------------------------------------------------ */

enum { MOST_THREADS = 64 };

static int count_threads_of_pairs(const fmb_pair_options *o)
{
    return o->threads < 1 ? 1 : o->threads > MOST_THREADS ? MOST_THREADS : (int)o->threads;
}

/* Make the workers of the other threads: each has k's options except threads. */
static fmb_status hire_workers(fmb_pair *k, const fmb_alloc *hook)
{
    fmb_pair_options o = k->options;
    o.threads = 1;
    if (k->threads == 1)
        return FMB_OK;
    FMB_TRY(FMB_GET_ZERO(&k->mem, k->workers, (size_t)k->threads - 1));
    for (int i = 0; i < k->threads - 1; i++)
        FMB_TRY(fmb_pair_new(k->dim, &o, hook, &k->workers[i]));
    return FMB_OK;
}

static void dismiss_workers(fmb_pair *k)
{
    fmb_threads_close(&k->running);
    for (int i = 0; k->workers && i < k->threads - 1; i++)
        fmb_pair_free(k->workers[i]);
    fmb_mem_put(&k->mem, k->workers, (size_t)k->threads - 1, sizeof *k->workers);
}

/* Copy the given options, or the default ones. Errors: ARG, with the reason. */
static fmb_status read_pair_options(const fmb_pair_options *o, fmb_pair_options *ours, char *why,
                                    size_t size)
{
    if (!fmb_sized_take(ours, sizeof *ours, o, "options", why, size))
        return FMB_ERR_ARG;
    if ((unsigned)ours->contact > FMB_CONTACT_OPEN)
        snprintf(why, size, "contact is %d, which is none", (int)ours->contact);
    else if ((unsigned)ours->method > FMB_PAIR_EXACT)
        snprintf(why, size, "method is %d, which is none", (int)ours->method);
    else if (!(ours->max_seconds >= 0))
        snprintf(why, size, "max_seconds is %g", ours->max_seconds);
    else if (!fmb_pair_kernels_choose(ours->simd))
        snprintf(why, size, "simd is %d: none, or the processor lacks these instructions",
                 (int)ours->simd);
    return why[0] ? FMB_ERR_ARG : FMB_OK;
}

size_t fmb_pair_options_trouble(const fmb_pair_options *o, char *text, size_t size)
{
    fmb_pair_options ours;
    char why[160];
    (void)read_pair_options(o, &ours, why, sizeof why);
    return fmb_text_give(why, text, size);
}

/* Align to lanes of eight numbers. */
static double *align_to_lanes(double *p)
{
    return p + (FMB_BLOCK_MOST_LANES - (uintptr_t)p / sizeof *p % FMB_BLOCK_MOST_LANES) %
                   FMB_BLOCK_MOST_LANES;
}

/* Numbers of the workspace of kernels, and of the records of pairs. */
static size_t room_of_minors(int dim)
{
    return fmb_minors_is_dim(dim) ? fmb_minors_room(dim) + FMB_BLOCK_MOST_LANES +
                                        2 * (size_t)FMB_MINOR_PAIRS * (size_t)fmb_minors_record(dim)
                                  : 0;
}

fmb_status fmb_pair_new(int dim, const fmb_pair_options *o, const fmb_alloc *hook, fmb_pair **out)
{
    fmb_pair_options options;
    fmb_mem mem;
    char why[160];
    if (!out || dim < 1 || dim > FMB_FRAME_MOST_DIM ||
        read_pair_options(o, &options, why, sizeof why) != FMB_OK)
        return FMB_ERR_ARG;
    o = &options;
    fmb_mem_init(&mem, hook, 0);
    fmb_pair *k;
    FMB_TRY(FMB_GET_ZERO(&mem, k, 1));
    k->mem = mem;
    k->options = *o;
    k->dim = dim;
    k->threads = count_threads_of_pairs(o);
    fmb_pair_use_kernels(k, &fmb_pair_kernels_narrow, fmb_pair_kernels_choose(o->simd));
    k->minors = fmb_minors_is_dim(dim)
                    ? fmb_mem_get(&k->mem, room_of_minors(dim), sizeof *k->minors)
                    : NULL;
    k->room = k->minors ? align_to_lanes(k->minors) : NULL;
    k->record = k->minors ? k->room + fmb_minors_room(dim) : NULL;
    k->general = fmb_general_new(dim, o->simd, &k->mem);
    bool good = k->general && (k->minors || !fmb_minors_is_dim(dim));
    fmb_status st = good ? fmb_pair_oracle_open(&k->oracle, o, hook) : FMB_ERR_MEMORY;
    FMB_THEN(st, hire_workers(k, hook));
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
    dismiss_workers(k);
    fmb_pair_oracle_close(&k->oracle);
    fmb_general_free(k->general, &k->mem);
    fmb_exact_boxer_free(k->boxer, &k->mem);
    fmb_mem_put(&k->mem, k->minors, room_of_minors(k->dim), sizeof *k->minors);
    fmb_mem mem = k->mem;
    fmb_mem_put(&mem, k, 1, sizeof *k);
}

void fmb_pair_use_kernels(fmb_pair *k, const fmb_pair_kernels *one, const fmb_pair_kernels *wide)
{
    k->one = one;
    k->wide = wide;
    for (int i = 0; k->workers && i < k->threads - 1; i++)
        fmb_pair_use_kernels(k->workers[i], one, wide);
}

fmb_status fmb_pair_count(const fmb_pair *k, fmb_pair_counts *out)
{
    fmb_pair_counts all = {.size = sizeof all};
    if (!k || !out || !fmb_sized_is_good(out, sizeof *out, "out", NULL, 0))
        return FMB_ERR_ARG;
    for (int i = -1; i < k->threads - 1; i++) {
        const fmb_pair_counts *c = i < 0 ? &k->counts : &k->workers[i]->counts;
        all.pairs += c->pairs;
        all.exact_verdicts += c->exact_verdicts;
        all.exact_boxes += c->exact_boxes;
    }
    fmb_sized_give(out, &all, sizeof all);
    return FMB_OK;
}

const char *fmb_pair_trouble(const fmb_pair *k)
{
    return k ? k->error : "";
}

void fmb_pair_cancel(fmb_pair *k)
{
    for (int i = -1; k && i < k->threads - 1; i++)
        atomic_store(i < 0 ? &k->oracle.cancel : &k->workers[i]->oracle.cancel, 1);
}

/* The argument that is missing, or NULL. */
static const char *find_missing(size_t n, const fmb_frame *p, const fmb_frame *q,
                                const fmb_pair_answers *out)
{
    if (n == 0)
        return NULL;
    return !p ? "p" : !q ? "q" : !out->verdict ? "out->verdict" : NULL;
}

fmb_status fmb_pair_read_answers(fmb_pair *k, const fmb_pair_answers *out, fmb_pair_answers *ours)
{
    k->error[0] = '\0';
    if (!out)
        snprintf(k->error, sizeof k->error, "out is NULL");
    else
        (void)fmb_sized_take(ours, sizeof *ours, out, "out", k->error, sizeof k->error);
    return k->error[0] ? FMB_ERR_ARG : FMB_OK;
}

fmb_status fmb_pair_test(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                         const fmb_pair_answers *out)
{
    fmb_pair_answers ours;
    if (!k || fmb_pair_read_answers(k, out, &ours) != FMB_OK)
        return FMB_ERR_ARG;
    const char *missing = find_missing(n, p, q, &ours);
    if (missing) {
        snprintf(k->error, sizeof k->error, "%s is NULL", missing);
        return FMB_ERR_ARG;
    }
    atomic_store_explicit(&k->oracle.cancel, 0, memory_order_relaxed);
    k->counts.pairs += n;
    return fmb_contact_asks_depth(&ours) || fmb_contact_asks_distance(&ours)
               ? fmb_contact_answer_all(k, n, p, q, &ours)
               : fmb_pair_answer_all(k, n, p, q, FMB_PAIR_NEW, &ours);
}

fmb_status fmb_pair_answer_q(const fmb_frame_q *p, const fmb_frame_q *q,
                             const fmb_pair_answers_q *out, fmb_verdict *verdict)
{
    fmb_pair_answers_q ours;
    fmb_mem mem;
    if (!p || !q || !out || !verdict || !fmb_sized_take(&ours, sizeof ours, out, "out", NULL, 0) ||
        !fmb_frame_q_is_good(p, p->dim) || !fmb_frame_q_is_good(q, p->dim))
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, NULL, 0);
    *verdict = fmb_exact_box_answer_q(p, q, &ours, &mem);
    if (*verdict == FMB_UNKNOWN)
        *verdict = fmb_long_box_answer_q(p, q, &ours, &mem);
    return FMB_OK;
}
