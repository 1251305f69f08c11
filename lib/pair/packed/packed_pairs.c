/* packed_pairs.c: pairs of frames of sets, by index. */
#include <stdio.h>

#include "pair/packed/packed.h"
#include "pair/pair_contact.h"

/* ---- verdicts of a portion ------------------------------------------------------------------- */

enum { PORTION = 1024 };

typedef struct pairs_query {
    const fmb_frames *a, *b;
    const fmb_frames_pair *pair;
    const fmb_pair_answers *out;
    size_t n;
} pairs_query;

/* A way to decide n pairs of these kinds. */
typedef fmb_status decide_pairs(fmb_pair *k, const pairs_query *x, const fmb_packed_plan *plan,
                                size_t n, const fmb_frames_pair *pair, fmb_verdict *out);

/* Decide by `decide` the pairs whose verdicts are UNKNOWN among n. */
static fmb_status decide_open_pairs(fmb_pair *k, const pairs_query *x, const fmb_packed_plan *plan,
                                    decide_pairs *decide, size_t n, const fmb_frames_pair *pair,
                                    fmb_verdict *out)
{
    fmb_frames_pair open[FMB_PACKED_AT_ONCE];
    fmb_verdict is[FMB_PACKED_AT_ONCE];
    size_t place[FMB_PACKED_AT_ONCE], found = 0;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i <= n; i++) {
        if (i < n && out[i] == FMB_UNKNOWN) {
            open[found] = pair[i];
            place[found++] = i;
        }
        if (found < FMB_PACKED_AT_ONCE && i < n)
            continue;
        st = found > 0 ? decide(k, x, plan, found, open, is) : FMB_OK;
        for (size_t j = 0; st == FMB_OK && j < found; j++)
            out[place[j]] = is[j];
        found = 0;
    }
    return st;
}

static fmb_status decide_exactly(fmb_pair *k, const pairs_query *x, const fmb_packed_plan *plan,
                                 size_t n, const fmb_frames_pair *pair, fmb_verdict *out)
{
    (void)plan;
    return fmb_packed_decide(k, x->a, x->b, n, pair, out);
}

static fmb_status decide_in_doubles(fmb_pair *k, const pairs_query *x, const fmb_packed_plan *plan,
                                    size_t n, const fmb_frames_pair *pair, fmb_verdict *out)
{
    const fmb_packed_pairs packed = fmb_packed_pairs_of(k, x->a, x->b, plan, n, pair);
    bool known = k->dim > 3 ? k->wide->minors->pairs(k->dim, plan->what, &packed, k->room, out)
                            : k->wide->packed->pairs[k->dim - 2](&packed, out);
    return known ? FMB_OK : decide_open_pairs(k, x, plan, decide_exactly, n, pair, out);
}

/* Pairs that are decided in floats before the others of a portion: if they leave more than half of
 * them open, reading doubles, too, takes longer than reading doubles alone. */
enum { FIRST = 64 };

static fmb_status decide_in_floats(fmb_pair *k, const pairs_query *x, const fmb_packed_plan *plan,
                                   size_t n, const fmb_frames_pair *pair, fmb_verdict *out)
{
    const size_t first = n < FIRST ? n : FIRST;
    fmb_packed_pairs packed = fmb_packed_pairs_of(k, x->a, x->b, plan, first, pair);
    bool known = k->wide->packed->single(&packed, out);
    size_t open = 0;
    for (size_t i = 0; !known && i < first; i++)
        open += out[i] == FMB_UNKNOWN;
    if (2 * open > first)
        return decide_in_doubles(k, x, plan, n, pair, out);
    packed = fmb_packed_pairs_of(k, x->a, x->b, plan, n - first, pair + first);
    known &= first == n || k->wide->packed->single(&packed, out + first);
    return known ? FMB_OK : decide_open_pairs(k, x, plan, decide_in_doubles, n, pair, out);
}

/* n > 0 pairs of these kinds. */
static fmb_status decide_pairs_of_kinds(fmb_pair *k, const pairs_query *x, int kind_a, int kind_b,
                                        size_t n, const fmb_frames_pair *pair, fmb_verdict *out)
{
    fmb_packed_plan plan;
    if (!fmb_packed_plan_of(k, kind_a, kind_b, &plan))
        return fmb_packed_decide(k, x->a, x->b, n, pair, out);
    const bool floats = k->dim == 3 && plan.shapes != FMB_PACKED_ANY && k->wide->packed->single;
    return (floats ? decide_in_floats : decide_in_doubles)(k, x, &plan, n, pair, out);
}

/* Pairs of many kinds: first those of one kind are brought together (counting sort). */
static fmb_status decide_mixed_pairs(fmb_pair *k, const pairs_query *x, size_t n,
                                     const fmb_frames_pair *pair, fmb_verdict *out)
{
    uint16_t first[FMB_KINDS * FMB_KINDS + 1] = {0}, key[PORTION], place[PORTION];
    fmb_frames_pair sorted[PORTION];
    fmb_verdict is[PORTION];
    for (size_t i = 0; i < n; i++) {
        key[i] = (uint16_t)(FMB_KINDS * x->a->kind[pair[i].a] + x->b->kind[pair[i].b]);
        first[key[i] + 1]++;
    }
    for (int j = 0; j < FMB_KINDS * FMB_KINDS; j++)
        first[j + 1] = (uint16_t)(first[j + 1] + first[j]);
    for (size_t i = 0; i < n; i++) {
        place[i] = first[key[i]]++;
        sorted[place[i]] = pair[i];
    }
    fmb_status st = FMB_OK;
    /* first[j] is now the end of kind j */
    for (size_t j = 0, from = 0; st == FMB_OK && from < n; from = first[j++]) {
        if (first[j] > from)
            st = decide_pairs_of_kinds(k, x, (int)j / FMB_KINDS, (int)j % FMB_KINDS,
                                       first[j] - from, sorted + from, is + from);
    }
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        out[i] = is[place[i]];
    return st;
}

/* The first pair with a number of no frame; n: there is none. */
static size_t find_bad_pair(const fmb_pair *k, const pairs_query *x, size_t n,
                            const fmb_frames_pair *pair)
{
    uint32_t most[2];
    size_t i = 0;
    k->wide->packed->largest(&pair->a, 2 * n, most);
    if (most[0] < x->a->n && most[1] < x->b->n)
        return n;
    while (pair[i].a < x->a->n && pair[i].b < x->b->n)
        i++;
    return i;
}

/* Pairs from `from`, PORTION at most. */
static fmb_status answer_portion(fmb_pair *k, const pairs_query *x, size_t from)
{
    size_t n = x->n - from < PORTION ? x->n - from : PORTION;
    const fmb_frames_pair *pair = x->pair + from;
    const fmb_pair_answers *o = x->out;
    size_t bad = find_bad_pair(k, x, n, pair);
    if (bad < n) {
        snprintf(k->error, sizeof k->error, "pair[%zu]: no such frame", from + bad);
        return FMB_ERR_ARG;
    }
    if (fmb_pair_is_cancelled(k)) {
        for (size_t i = 0; i < n; i++)
            o->verdict[from + i] = FMB_UNKNOWN;
        return FMB_OK;
    }
    k->counts.pairs += n;
    if (fmb_contact_asks_depth(o) || fmb_contact_asks_distance(o)) {
        fmb_pair_answers some = fmb_pair_answers_from(o, (size_t)k->dim, from);
        return fmb_packed_contacts(k, x->a, x->b, n, pair, &some);
    }
    if (fmb_pair_answers_more(o)) {
        fmb_pair_answers some = fmb_pair_answers_from(o, (size_t)k->dim, from);
        return fmb_packed_answer(k, x->a, x->b, n, pair, &some);
    }
    return x->a->only >= 0 && x->b->only >= 0
               ? decide_pairs_of_kinds(k, x, x->a->only, x->b->only, n, pair, o->verdict + from)
               : decide_mixed_pairs(k, x, n, pair, o->verdict + from);
}

/* ---- threads --------------------------------------------------------------------------------- */

/* Portions that a thread takes at once. */
enum { PORTIONS = 4 };

typedef struct pairs_round {
    fmb_pair *k;
    const pairs_query *x;
    size_t *failed; /* [jobs] the first pair of its first portion with an error */
    fmb_status *st; /* [jobs] */
} pairs_round;

static void answer_some_portions(void *self, size_t job, size_t thread)
{
    const pairs_round *r = self;
    size_t from = job * PORTIONS * PORTION, to = from + PORTIONS * PORTION;
    to = to < r->x->n ? to : r->x->n;
    for (r->st[job] = FMB_OK; r->st[job] == FMB_OK && from < to; from += PORTION) {
        r->st[job] = answer_portion(fmb_packed_worker(r->k, thread), r->x, from);
        r->failed[job] = from;
    }
}

/* Returns the error of the first portion that has one. That portion is repeated by k, so that its
 * error text is about this portion and not about a later one. */
static fmb_status answer_by_threads(fmb_pair *k, const pairs_query *x)
{
    size_t jobs = (x->n - 1) / (PORTIONS * PORTION) + 1, job = 0;
    pairs_round r = {.k = k, .x = x};
    r.failed = fmb_mem_get(&k->mem, jobs, sizeof *r.failed);
    r.st = r.failed ? fmb_mem_get(&k->mem, jobs, sizeof *r.st) : NULL;
    fmb_status st = r.st ? FMB_OK : fmb_mem_status(&k->mem);
    FMB_THEN(st, fmb_packed_do(k, jobs, answer_some_portions, &r));
    if (st == FMB_OK) {
        while (job + 1 < jobs && r.st[job] == FMB_OK)
            job++;
        st = r.st[job];
    }
    if (st == FMB_ERR_ARG)
        st = answer_portion(k, x, r.failed[job]);
    fmb_mem_put(&k->mem, r.failed, jobs, sizeof *r.failed);
    fmb_mem_put(&k->mem, r.st, jobs, sizeof *r.st);
    return st;
}

static fmb_status answer_alone(fmb_pair *k, const pairs_query *x)
{
    for (size_t from = 0; from < x->n; from += PORTION)
        FMB_TRY(answer_portion(k, x, from));
    return FMB_OK;
}

fmb_status fmb_frames_test(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                           const fmb_frames_pair *pair, const fmb_pair_answers *out)
{
    fmb_pair_answers ours = {.size = sizeof ours};
    if (!k || !fmb_packed_begin(k, a, b) ||
        ((n > 0 || out) && fmb_pair_read_answers(k, out, &ours) != FMB_OK))
        return FMB_ERR_ARG;
    if (n > 0 && (!pair || !ours.verdict)) {
        snprintf(k->error, sizeof k->error, "%s is NULL", !pair ? "pair" : "out->verdict");
        return FMB_ERR_ARG;
    }
    pairs_query x = {a, b, pair, &ours, n};
    return k->threads > 1 && n > PORTION ? answer_by_threads(k, &x) : answer_alone(k, &x);
}
