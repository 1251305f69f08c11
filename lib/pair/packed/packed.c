/* packed.c: see packed.h. */
#include "pair/packed/packed.h"

#include <stdio.h>

#include "pair/pair_contact.h"
#include "pair/pair_portfolio.h"

bool fmb_packed_begin(fmb_pair *k, const fmb_frames *a, const fmb_frames *b)
{
    k->error[0] = '\0';
    if (!a || !b || a->dim != k->dim || b->dim != k->dim) {
        snprintf(k->error, sizeof k->error, "%s",
                 !a || !b ? "a set is NULL" : "a set has another dim");
        return false;
    }
    for (int i = -1; i < k->threads - 1; i++)
        atomic_store_explicit(i < 0 ? &k->oracle.cancel : &k->workers[i]->oracle.cancel, 0,
                              memory_order_relaxed);
    return true;
}

fmb_status fmb_packed_do(fmb_pair *k, size_t jobs, fmb_thread_job job, void *self)
{
    fmb_status st = FMB_OK;
    if (!k->running.thread)
        st = fmb_threads_open(&k->running, &k->mem, (size_t)k->threads);
    if (st == FMB_OK)
        fmb_threads_do(&k->running, jobs, job, self);
    return st;
}

fmb_pair *fmb_packed_worker(fmb_pair *k, size_t thread)
{
    return thread == 0 ? k : k->workers[thread - 1];
}

bool fmb_packed_plan_of(const fmb_pair *k, int a, int b, fmb_packed_plan *out)
{
    if (k->options.method == FMB_PAIR_EXACT || a == FMB_KIND_NONE || b == FMB_KIND_NONE)
        return false;
    const int naxes[2] = {fmb_kind_naxes(k->dim, a), fmb_kind_naxes(k->dim, b)};
    const bool simplex[2] = {fmb_kind_shape(a), fmb_kind_shape(b)};
    out->moves = ((a | b) & FMB_KIND_MOVES) != 0;
    out->swapped = false;
    out->shapes = FMB_PACKED_ANY;
    out->what = fmb_minors_what_of(simplex[0], simplex[1], out->moves);
    if (k->dim > 3 && (!k->room || !k->wide->minors || !fmb_minors_decide(k->dim, out->what)))
        return false;
    if (naxes[0] == k->dim && naxes[1] == k->dim) {
        out->swapped = simplex[0] && !simplex[1];
        out->shapes = simplex[0] && simplex[1]   ? FMB_PACKED_SIMPLICES
                      : simplex[0] || simplex[1] ? FMB_PACKED_ONE_OF_EACH
                                                 : FMB_PACKED_CUBOIDS;
    } else {
        fmb_flat_kind_of(k->dim, out->moves, naxes, simplex, &out->flat);
    }
    return true;
}

fmb_packed_pairs fmb_packed_pairs_of(const fmb_pair *k, const fmb_frames *a, const fmb_frames *b,
                                     const fmb_packed_plan *plan, size_t n,
                                     const fmb_frames_pair *pair)
{
    const fmb_frames *set[2] = {a, b};
    const uint32_t *index[2] = {&pair->a, &pair->b};
    fmb_packed_pairs out = {.n = n,
                            .far = a->far + b->far,
                            .fast = a->fast + b->fast,
                            .rounding = a->rounded || b->rounded ? FMB_SINGLE_ERROR : 0,
                            .moves = plan->moves,
                            .closed = k->options.contact == FMB_CONTACT_CLOSED,
                            .shapes = plan->shapes,
                            .kind = &plan->flat};
    for (int side = 0; side < 2; side++) {
        out.record[side] = set[side ^ plan->swapped]->record;
        out.single[side] = set[side ^ plan->swapped]->single;
        out.index[side] = index[side ^ plan->swapped];
    }
    return out;
}

/* Answer n <= FMB_PACKED_AT_ONCE pairs as frames, with more than verdicts; out is for them. */
static fmb_status answer_as_frames(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                                   const fmb_frames_pair *pair, fmb_pair_known known,
                                   const fmb_pair_answers *out)
{
    fmb_frame p[FMB_PACKED_AT_ONCE], q[FMB_PACKED_AT_ONCE];
    for (size_t i = 0; i < n; i++) {
        p[i] = fmb_frames_at(a, pair[i].a);
        q[i] = fmb_frames_at(b, pair[i].b);
    }
    return fmb_pair_answer_all(k, n, p, q, known, out);
}

static fmb_status answer_by_portions(fmb_pair *k, const fmb_frames *a, const fmb_frames *b,
                                     size_t n, const fmb_frames_pair *pair, fmb_pair_known known,
                                     const fmb_pair_answers *out)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < n; i += FMB_PACKED_AT_ONCE) {
        fmb_pair_answers some = fmb_pair_answers_from(out, (size_t)k->dim, i);
        st = answer_as_frames(k, a, b, n - i < FMB_PACKED_AT_ONCE ? n - i : FMB_PACKED_AT_ONCE,
                              pair + i, known, &some);
    }
    return st;
}

fmb_status fmb_packed_answer(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                             const fmb_frames_pair *pair, const fmb_pair_answers *out)
{
    return answer_by_portions(k, a, b, n, pair, FMB_PAIR_GOOD, out);
}

fmb_status fmb_packed_decide(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                             const fmb_frames_pair *pair, fmb_verdict *out)
{
    const fmb_pair_answers answers = {.size = sizeof answers, .verdict = out};
    fmb_packed_plan plan;
    const bool open = n > 0 && fmb_packed_plan_of(k, a->kind[pair->a], b->kind[pair->b], &plan);
    return answer_by_portions(k, a, b, n, pair, open ? FMB_PAIR_OPEN : FMB_PAIR_GOOD, &answers);
}
