/* validate_boxes.c: see validate_boxes.h. */
#include "study/reference/validate_boxes.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/solve.h>

#include "study/reference/ends.h"
#include "study/reference/near.h"
#include "study/reference/propose.h"

enum { USUAL, TIGHTEST, EXACT, WAYS, MOST = STUDY_PAIR_MOST_DIM };

typedef struct answers {
    fmb_verdict *verdict;
    double *world, *inside, *time, *witness;
} answers;

struct study_box_bench {
    int dim;
    atomic_bool stopped;
    fmb_pair *way[WAYS];
    answers said[2][WAYS];                      /* by order */
    fmb_solver *solver;                         /* of witnesses */
    study_proposer *proposer, *double_proposer; /* the second in twice as many dimensions */
    study_witness_pair near;
    study_meeting meeting;
    study_form form;
    study_meeting witnessed;
    bool started; /* the ends of `meeting` */
};

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status open_answers(answers *a, size_t n, size_t dim)
{
    *a = (answers){calloc(n, sizeof(fmb_verdict)), calloc(2 * n * dim, sizeof(double)),
                   calloc(2 * n * dim, sizeof(double)), calloc(2 * n, sizeof(double)),
                   calloc(n * dim, sizeof(double))};
    return a->verdict && a->world && a->inside && a->time && a->witness ? FMB_OK : FMB_ERR_MEMORY;
}

static void close_answers(answers *a)
{
    void *all[] = {a->verdict, a->world, a->inside, a->time, a->witness};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        free(all[k]);
}

static fmb_status open_way(study_box_bench *b, int i, fmb_simd simd)
{
    fmb_pair_options o = {.size = sizeof o};
    o.method = i == EXACT ? FMB_PAIR_EXACT : FMB_PAIR_FMB;
    o.tightest = i == TIGHTEST;
    o.simd = simd;
    fmb_status st = FMB_OK;
    for (int order = 0; st == FMB_OK && order < 2; order++)
        st = open_answers(&b->said[order][i], STUDY_VALIDATE_MOST, (size_t)b->dim);
    return st == FMB_OK ? fmb_pair_new(b->dim, &o, NULL, &b->way[i]) : st;
}

fmb_status study_box_bench_open(int dim, fmb_simd simd, study_box_bench **out)
{
    study_box_bench *b = calloc(1, sizeof *b);
    if (!b)
        return FMB_ERR_MEMORY;
    b->dim = dim;
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_NONE;
    study_meeting_init(&b->meeting);
    study_meeting_init(&b->witnessed);
    study_form_init(&b->form);
    b->proposer = study_proposer_open(dim);
    b->double_proposer = study_proposer_open(2 * dim);
    fmb_status st =
        b->proposer && b->double_proposer ? fmb_solver_new(&o, NULL, &b->solver) : FMB_ERR_MEMORY;
    for (int i = 0; st == FMB_OK && i < WAYS; i++)
        st = open_way(b, i, simd);
    if (st == FMB_OK)
        *out = b;
    else
        study_box_bench_close(b);
    return st;
}

void study_box_bench_close(study_box_bench *b)
{
    if (!b)
        return;
    for (int i = 0; i < WAYS; i++) {
        for (int order = 0; order < 2; order++)
            close_answers(&b->said[order][i]);
        fmb_pair_free(b->way[i]);
    }
    fmb_solver_free(b->solver);
    study_proposer_close(b->proposer);
    study_proposer_close(b->double_proposer);
    study_meeting_clear(&b->meeting);
    study_meeting_clear(&b->witnessed);
    study_form_clear(&b->form);
    free(b);
}

void study_box_bench_cancel(study_box_bench *b)
{
    atomic_store(&b->stopped, true);
    for (int i = 0; i < WAYS; i++)
        fmb_pair_cancel(b->way[i]);
    fmb_solver_cancel(b->solver);
}

/* ---- questions ------------------------------------------------------------------------------- */

static fmb_pair_answers of_pair(const study_box_bench *b, int order, int way, size_t i)
{
    const answers *a = &b->said[order][way];
    size_t dim = (size_t)b->dim;
    return (fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                              .verdict = a->verdict + i,
                              .world = a->world + 2 * dim * i,
                              .inside = a->inside + 2 * dim * i,
                              .time = a->time + 2 * i,
                              .witness = a->witness + dim * i};
}

/* Is x proved to be near a common point? */
static bool is_proved_near(study_box_bench *b, const fmb_frame *p, const fmb_frame *q,
                           const double *x)
{
    fmb_verdict verdict[2] = {FMB_UNKNOWN, FMB_UNKNOWN};
    const fmb_frame *f = b->near.frame;
    if (study_witness_frames(p, q, x, &b->near) && study_meeting_load(&b->witnessed, &f[0], &f[1]))
        study_prove_verdicts(b->double_proposer, &b->witnessed, verdict);
    return verdict[FMB_CONTACT_CLOSED] == FMB_FEASIBLE;
}

static fmb_status check_witness(study_box_bench *b, const fmb_frame *p, const fmb_frame *q,
                                const double *x, unsigned *faults)
{
    fmb_system *s = NULL;
    fmb_result res = {.size = sizeof res};
    for (int j = 0; j < b->dim; j++)
        if (!isfinite(x[j])) {
            *faults |= STUDY_FAULT_WITNESS;
            return FMB_OK;
        }
    if ((b->started && study_prove_near(b->proposer, &b->meeting, x, study_neighbourhood(p, q))) ||
        is_proved_near(b, p, q, x))
        return FMB_OK;
    fmb_status st = study_witness_system(p, q, x, &s);
    if (st == FMB_OK)
        st = fmb_solve(b->solver, s, &res);
    if (st == FMB_OK && res.verdict != FMB_FEASIBLE)
        *faults |= STUDY_FAULT_WITNESS;
    fmb_system_free(s);
    return st;
}

/* ---- ends ------------------------------------------------------------------------------------ */

/* Are the ends of the form, and of its opposite, those? */
static bool is_interval_proved(study_box_bench *b, bool is_world, int number, const double *ends)
{
    bool good = true;
    for (int sign = 1; sign >= -1; sign -= 2) {
        if (is_world)
            study_form_of_coordinate(&b->form, &b->meeting, number, sign);
        else
            study_form_of_unknown(&b->form, &b->meeting, number, sign);
        good &= study_prove_end(b->proposer, &b->meeting, &b->form, sign > 0 ? ends[1] : -ends[0]);
    }
    return good;
}

static bool are_unknowns_proved(study_box_bench *b, int frame, const double *inside)
{
    const int *from = b->meeting.from;
    bool good = true;
    for (int j = from[frame]; j < from[frame + 1]; j++)
        good &= is_interval_proved(b, false, j, inside + 2 * (j - from[frame]));
    return good;
}

/* Ends in the world, and of time. */
static bool are_ends_proved(study_box_bench *b, const fmb_pair_answers *a)
{
    const study_meeting *s = &b->meeting;
    bool good = true;
    for (int i = 0; i < b->dim; i++)
        good &= is_interval_proved(b, true, i, a->world + 2 * i);
    if (s->columns == s->from[2])
        return good && a->time[0] == 0 && a->time[1] == 1;
    return good & is_interval_proved(b, false, s->from[2], a->time);
}

static bool are_same_ends(const double *a, const double *b, int n)
{
    bool same = true;
    for (int i = 0; i < 2 * n; i++)
        same &= a[i] == b[i];
    return same;
}

/* Is every end of the pair i proved to be the exact one, rounded outward, in either order? In the
 * world and in time these are the same in both. */
static void prove_boxes(study_box_bench *b, size_t i, const fmb_frame *p, const fmb_frame *q,
                        bool proved[2])
{
    const fmb_pair_answers first = of_pair(b, 0, TIGHTEST, i), other = of_pair(b, 1, TIGHTEST, i);
    proved[0] = proved[1] = false;
    b->started =
        study_meeting_load(&b->meeting, p, q) && study_start_ends(b->proposer, &b->meeting);
    if (!b->started || !are_ends_proved(b, &first))
        return;
    proved[0] = are_unknowns_proved(b, 1, first.inside);
    proved[1] = are_same_ends(first.world, other.world, b->dim) &&
                are_same_ends(first.time, other.time, 1) && are_unknowns_proved(b, 0, other.inside);
}

/* Ends by the exact way, where they are not proved. */
static fmb_status ask_exactly(study_box_bench *b, const fmb_frame *p, const fmb_frame *q,
                              unsigned *faults, const fmb_pair_answers *tightest,
                              study_tally *tally)
{
    fmb_pair_answers exact = of_pair(b, 0, EXACT, 0);
    double none;
    fmb_status st = fmb_pair_test(b->way[EXACT], 1, p, q, &exact);
    tally->boxes_solved++;
    if (st == FMB_OK && *exact.verdict != FMB_FEASIBLE)
        *faults |= STUDY_FAULT_UNDECIDED;
    else if (st == FMB_OK)
        *faults |= study_box_faults(p, q, tightest, &exact, true, &none);
    return st;
}

/* Pair i in that order, once everything was asked about it. */
static fmb_status judge_order(study_box_bench *b, int order, size_t i, const fmb_frame *p,
                              const fmb_frame *q, bool proved, unsigned *faults, study_tally *tally)
{
    fmb_pair_answers usual = of_pair(b, order, USUAL, i), tightest = of_pair(b, order, TIGHTEST, i);
    double excess;
    fmb_status st = proved ? FMB_OK : ask_exactly(b, p, q, faults, &tightest, tally);
    *faults |= study_box_faults(p, q, &usual, &tightest, false, &excess);
    tally->excess = fmax(tally->excess, excess);
    if (st == FMB_OK)
        st = check_witness(b, p, q, usual.witness, faults);
    bool same = memcmp(usual.witness, tightest.witness, (size_t)b->dim * sizeof(double)) == 0;
    return st == FMB_OK && !same ? check_witness(b, p, q, tightest.witness, faults) : st;
}

static fmb_status judge(study_box_bench *b, size_t i, const fmb_frame *p, const fmb_frame *q,
                        unsigned *faults, study_tally *tally)
{
    bool proved[2];
    for (int order = 0; order < 2; order++)
        for (int way = 0; way < EXACT; way++)
            if (b->said[order][way].verdict[i] != FMB_FEASIBLE) {
                *faults |= STUDY_FAULT_UNDECIDED;
                return FMB_OK;
            }
    prove_boxes(b, i, p, q, proved);
    fmb_status st = judge_order(b, 0, i, p, q, proved[0], faults, tally);
    return st == FMB_OK ? judge_order(b, 1, i, q, p, proved[1], faults, tally) : st;
}

fmb_status study_box_bench_run(study_box_bench *b, size_t n, const fmb_frame *p, const fmb_frame *q,
                               unsigned *faults, study_tally *tally)
{
    fmb_pair_counts before = {.size = sizeof before}, after = {.size = sizeof after};
    fmb_status st = fmb_pair_count(b->way[USUAL], &before);
    for (int order = 0; order < 2; order++)
        for (int way = 0; st == FMB_OK && way < EXACT && !atomic_load(&b->stopped); way++) {
            fmb_pair_answers out = of_pair(b, order, way, 0);
            st = fmb_pair_test(b->way[way], n, order ? q : p, order ? p : q, &out);
        }
    for (size_t i = 0; i < n; i++) {
        faults[i] = 0;
        if (st == FMB_OK && !atomic_load(&b->stopped))
            st = judge(b, i, &p[i], &q[i], &faults[i], tally);
    }
    tally->boxes += n;
    if (st == FMB_OK)
        st = fmb_pair_count(b->way[USUAL], &after);
    tally->doubtful += after.exact_boxes - before.exact_boxes;
    return st;
}
