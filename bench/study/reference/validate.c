/* validate.c: see validate.h. */
#include "study/reference/validate.h"

#include <fmb/frames.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "study/draw/draft.h"
#include "study/reference/proofs.h"
#include "study/reference/truth.h"
#include "study/reference/validate_boxes.h"
#include "study/reference/validate_contacts.h"

struct study_validator {
    study_validation v;
    atomic_bool stopped;
    unsigned ways; /* bits: those that say something new in this dimension */
    fmb_pair *way[STUDY_PAIR_WAYS];
    study_proofs *proofs;
    study_box_bench *boxes;        /* NULL: not wanted */
    study_contact_bench *contacts; /* NULL: not wanted */
    study_pairs pairs;
    study_verdicts verdicts[STUDY_VALIDATE_MOST];
    unsigned faults[STUDY_VALIDATE_MOST];
    /* Those whose verdicts are proved; the first of them are asked of the textbook, too. */
    size_t chosen, slow, index[STUDY_VALIDATE_MOST];
    fmb_frame p[STUDY_VALIDATE_MOST], q[STUDY_VALIDATE_MOST];
};

enum {
    SAT_WAYS = 1 << STUDY_SAT_DOUBLES | 1 << STUDY_SAT_CLOSED | 1 << STUDY_SAT_OPEN,
    EXACT_WAYS = 1 << STUDY_EXACT_CLOSED | 1 << STUDY_EXACT_OPEN
};

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status study_validator_open(const study_validation *v, study_validator **out)
{
    study_validator *s = calloc(1, sizeof *s);
    if (!s)
        return FMB_ERR_MEMORY;
    s->v = *v;
    s->ways = (1U << STUDY_PAIR_WAYS) - 1;
    if (v->plan.dim < 2 || v->plan.dim > 3)
        s->ways &= ~(unsigned)SAT_WAYS;
    fmb_status st = study_pairs_room(&v->plan, STUDY_VALIDATE_MOST, &s->pairs);
    for (int i = 0; st == FMB_OK && i < STUDY_PAIR_WAYS; i++)
        st = study_way_open((study_way_of_pairs)i, v->plan.dim, v->simd, &s->way[i]);
    if (st == FMB_OK)
        st = study_proofs_open(v->plan.dim, &s->proofs);
    if (st == FMB_OK && v->boxes)
        st = study_box_bench_open(v->plan.dim, v->simd, &s->boxes);
    if (st == FMB_OK && v->contacts)
        st = study_contact_bench_open(v->plan.dim, v->simd, &s->contacts);
    if (st == FMB_OK)
        *out = s;
    else
        study_validator_close(s);
    return st;
}

void study_validator_close(study_validator *s)
{
    if (!s)
        return;
    for (int i = 0; i < STUDY_PAIR_WAYS; i++)
        fmb_pair_free(s->way[i]);
    study_proofs_close(s->proofs);
    study_box_bench_close(s->boxes);
    study_contact_bench_close(s->contacts);
    study_pairs_free(&s->pairs);
    free(s);
}

void study_validator_cancel(study_validator *s)
{
    atomic_store(&s->stopped, true);
    for (int i = 0; i < STUDY_PAIR_WAYS; i++)
        fmb_pair_cancel(s->way[i]);
    study_proofs_cancel(s->proofs);
    if (s->boxes)
        study_box_bench_cancel(s->boxes);
    if (s->contacts)
        study_contact_bench_cancel(s->contacts);
}

/* ---- one lot of pairs ------------------------------------------------------------------------ */

typedef enum share { LEFT, PROVED, SLOW } share;

static share share_of(const study_validation *v, uint64_t k)
{
    uint64_t state;
    study_splitmix.set(&state, v->seed ^ (k + 1) * 0xd1342543de82ef95u);
    bool proved = study_splitmix.get_double(&state) < v->sample;
    bool slow = study_splitmix.get_double(&state) < v->textbook;
    return v->plan.family == STUDY_PAIR_ARTICLE && !proved ? LEFT : slow ? SLOW : PROVED;
}

static void choose_share(study_validator *s, uint64_t first, share which)
{
    for (size_t i = 0; i < s->pairs.n; i++) {
        if (share_of(&s->v, first + i) != which)
            continue;
        s->verdicts[i].asked = s->ways & ~(which == SLOW ? 0U : (unsigned)EXACT_WAYS);
        if (which == LEFT)
            continue;
        s->p[s->chosen] = s->pairs.p[i];
        s->q[s->chosen] = s->pairs.q[i];
        s->index[s->chosen++] = i;
    }
}

static void choose(study_validator *s, uint64_t first)
{
    s->chosen = 0;
    for (size_t i = 0; i < s->pairs.n; i++) {
        s->faults[i] = 0;
        s->verdicts[i] = (study_verdicts){0};
    }
    choose_share(s, first, SLOW);
    s->slow = s->chosen;
    choose_share(s, first, PROVED);
    choose_share(s, first, LEFT);
}

/* The same as fmb_pair_test, by sets of frames. */
static fmb_status ask_by_sets(fmb_pair *k, int dim, size_t n, const fmb_frame *p,
                              const fmb_frame *q, const fmb_pair_answers *out)
{
    fmb_frames_pair pair[STUDY_VALIDATE_MOST];
    fmb_frames *a = NULL, *b = NULL;
    for (uint32_t i = 0; i < n; i++)
        pair[i] = (fmb_frames_pair){i, i};
    fmb_status st = fmb_frames_new(dim, n, p, NULL, &a);
    if (st == FMB_OK)
        st = fmb_frames_new(dim, n, q, NULL, &b);
    if (st == FMB_OK)
        st = fmb_frames_test(k, a, b, n, pair, out);
    fmb_frames_free(a);
    fmb_frames_free(b);
    return st;
}

/* One way in one order, about all pairs or about those for the textbook. In more than three
 * dimensions sets have kernels of their own: the second order is asked of them. */
static fmb_status ask(study_validator *s, int way, int order)
{
    fmb_verdict said[STUDY_VALIDATE_MOST];
    fmb_pair_answers out = {.size = sizeof out, .verdict = said};
    bool few = EXACT_WAYS >> way & 1;
    size_t n = few ? s->slow : s->pairs.n;
    const fmb_frame *p = few ? s->p : s->pairs.p, *q = few ? s->q : s->pairs.q;
    fmb_status st = order && s->v.plan.dim > 3
                        ? ask_by_sets(s->way[way], s->v.plan.dim, n, q, p, &out)
                        : fmb_pair_test(s->way[way], n, order ? q : p, order ? p : q, &out);
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        s->verdicts[few ? s->index[i] : i].said[way][order] = said[i];
    return st;
}

static void count(const study_validator *s, study_tally *t)
{
    t->tested += s->pairs.n;
    t->exact += s->chosen;
    for (size_t i = 0; i < s->pairs.n; i++) {
        const study_verdicts *v = &s->verdicts[i];
        bool meet = v->said[STUDY_FMB_CLOSED][0] == FMB_FEASIBLE;
        t->meeting += meet;
        t->touching += meet && v->said[STUDY_FMB_OPEN][0] != FMB_FEASIBLE;
        for (int order = 0; order < 2; order++)
            for (int way = STUDY_FMB_DOUBLES; way <= STUDY_SAT_DOUBLES; way++)
                t->unknown[way] += (v->asked >> way & 1) && v->said[way][order] == FMB_UNKNOWN;
        t->disagreeing += s->faults[i] != 0;
        for (int f = 0; f < STUDY_FAULTS; f++)
            t->fault[f] += s->faults[i] >> f & 1;
    }
}

fmb_status study_findings_add(study_findings *to, const study_finding *f)
{
    if (to->n == to->capacity) {
        size_t more = 2 * to->capacity + 16;
        study_finding *item = realloc(to->item, more * sizeof *item);
        if (!item)
            return FMB_ERR_MEMORY;
        to->item = item;
        to->capacity = more;
    }
    to->item[to->n++] = *f;
    return FMB_OK;
}

static fmb_status note(const study_validator *s, uint64_t first, study_findings *out)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; i < s->pairs.n && st == FMB_OK; i++)
        if (s->faults[i] != 0)
            st = study_findings_add(out, &(study_finding){first + i, s->faults[i], s->verdicts[i]});
    return st;
}

/* Those chosen that meet move to the front; how many they are. */
static size_t keep_meeting(study_validator *s)
{
    size_t n = 0;
    for (size_t i = 0; i < s->chosen; i++)
        if (s->verdicts[s->index[i]].proved[FMB_CONTACT_CLOSED] == FMB_FEASIBLE) {
            s->p[n] = s->p[i];
            s->q[n] = s->q[i];
            s->index[n++] = s->index[i];
        }
    return n;
}

static fmb_status ask_boxes(study_validator *s, study_tally *t)
{
    unsigned faults[STUDY_VALIDATE_MOST];
    size_t n = keep_meeting(s);
    fmb_status st = study_box_bench_run(s->boxes, n, s->p, s->q, faults, t);
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        s->faults[s->index[i]] |= faults[i];
    return st;
}

fmb_status study_validator_run(study_validator *s, uint64_t first, size_t n, study_tally *tally,
                               study_findings *out)
{
    study_tally t = {0};
    fmb_status st = FMB_OK;
    study_pairs_fill(&s->v.plan, s->v.seed, first, n, &s->pairs);
    choose(s, first);
    size_t chosen = s->chosen;
    for (int way = 0; way < STUDY_PAIR_WAYS; way++)
        for (int order = 0; st == FMB_OK && (s->ways >> way & 1) && order < 2; order++)
            if (!atomic_load(&s->stopped))
                st = ask(s, way, order);
    if (st == FMB_OK && !atomic_load(&s->stopped))
        st = study_proofs_run(s->proofs, s->chosen, s->p, s->q, s->index, s->verdicts, s->faults,
                              &t.solved);
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        s->faults[i] |= study_verdict_faults(&s->verdicts[i]);
    if (st == FMB_OK)
        st = study_truth_run(s->slow, s->p, s->q, s->index, s->verdicts, s->faults, &s->stopped,
                             &t.textbook, &t.left);
    if (st == FMB_OK && s->contacts && !atomic_load(&s->stopped))
        st = study_contact_bench_run(s->contacts, s->chosen, s->p, s->q, s->index, s->faults, &t);
    if (st == FMB_OK && s->boxes && !atomic_load(&s->stopped))
        st = ask_boxes(s, &t);
    s->chosen = chosen;
    if (st == FMB_OK) {
        count(s, &t);
        study_tally_add(tally, &t);
        st = note(s, first, out);
    }
    return st;
}

void study_tally_add(study_tally *to, const study_tally *more)
{
    to->tested += more->tested;
    to->meeting += more->meeting;
    to->touching += more->touching;
    to->exact += more->exact;
    to->solved += more->solved;
    to->textbook += more->textbook;
    to->left += more->left;
    to->boxes += more->boxes;
    to->boxes_solved += more->boxes_solved;
    to->doubtful += more->doubtful;
    to->contacts += more->contacts;
    to->contacts_open += more->contacts_open;
    to->disagreeing += more->disagreeing;
    for (int i = 0; i < 2; i++)
        to->unknown[i] += more->unknown[i];
    for (int i = 0; i < STUDY_FAULTS; i++)
        to->fault[i] += more->fault[i];
    to->excess = fmax(to->excess, more->excess);
}
