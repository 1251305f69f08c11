/* validate_boxes.c: see validate_boxes.h. */
#include "study/reference/validate_boxes.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/solve.h>

#include "study/reference/ends.h"
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
    answers said[WAYS];
    fmb_solver *solver;                         /* of witnesses */
    study_proposer *proposer, *double_proposer; /* the second in twice as many dimensions */
    study_witness_pair near;
    study_meeting meeting;
    study_form form;
};

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status open_way(study_box_bench *b, int i, fmb_simd simd)
{
    size_t n = STUDY_VALIDATE_MOST, dim = (size_t)b->dim;
    fmb_pair_options o = {.size = sizeof o};
    o.method = i == EXACT ? FMB_PAIR_EXACT : FMB_PAIR_FMB;
    o.tightest = i == TIGHTEST;
    o.simd = simd;
    b->said[i] = (answers){calloc(n, sizeof(fmb_verdict)), calloc(2 * n * dim, sizeof(double)),
                           calloc(2 * n * dim, sizeof(double)), calloc(2 * n, sizeof(double)),
                           calloc(n * dim, sizeof(double))};
    const answers *a = &b->said[i];
    if (!a->verdict || !a->world || !a->inside || !a->time || !a->witness)
        return FMB_ERR_MEMORY;
    return fmb_pair_new(b->dim, &o, NULL, &b->way[i]);
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
        answers *a = &b->said[i];
        void *all[] = {a->verdict, a->world, a->inside, a->time, a->witness};
        for (size_t k = 0; k < sizeof all / sizeof *all; k++)
            free(all[k]);
        fmb_pair_free(b->way[i]);
    }
    fmb_solver_free(b->solver);
    study_proposer_close(b->proposer);
    study_proposer_close(b->double_proposer);
    study_meeting_clear(&b->meeting);
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

static fmb_pair_answers of_pair(const study_box_bench *b, int way, size_t i)
{
    const answers *a = &b->said[way];
    size_t dim = (size_t)b->dim;
    return (fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                              .verdict = a->verdict + i,
                              .world = a->world + 2 * dim * i,
                              .inside = a->inside + 2 * dim * i,
                              .time = a->time + 2 * i,
                              .witness = a->witness + dim * i};
}

/* Is x proved to be in both, as it is? Frames that move may hold it at different times. */
static bool is_proved_common(study_box_bench *b, const fmb_frame *p, const fmb_frame *q,
                             const double *x)
{
    const fmb_frame point = {FMB_CUBOID, b->dim, 0, x, NULL, NULL}, *const f[2] = {p, q};
    bool good = !p->speed && !q->speed;
    for (int k = 0; good && k < 2; k++) {
        fmb_verdict verdict[2] = {FMB_UNKNOWN, FMB_UNKNOWN};
        if (study_meeting_load(&b->meeting, f[k], &point))
            study_prove_verdicts(b->proposer, &b->meeting, f[k], &point, verdict);
        good = verdict[FMB_CONTACT_CLOSED] == FMB_FEASIBLE;
    }
    return good;
}

/* Is x proved to be near a common point? */
static bool is_proved_near(study_box_bench *b, const fmb_frame *p, const fmb_frame *q,
                           const double *x)
{
    fmb_verdict verdict[2] = {FMB_UNKNOWN, FMB_UNKNOWN};
    const fmb_frame *f = b->near.frame;
    if (study_witness_frames(p, q, x, &b->near) && study_meeting_load(&b->meeting, &f[0], &f[1]))
        study_prove_verdicts(b->double_proposer, &b->meeting, &f[0], &f[1], verdict);
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
    if (is_proved_common(b, p, q, x) || is_proved_near(b, p, q, x))
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

static bool are_ends_proved(study_box_bench *b, const fmb_frame *q, const fmb_pair_answers *a)
{
    const study_meeting *s = &b->meeting;
    bool good = true;
    for (int i = 0; i < b->dim; i++)
        good &= is_interval_proved(b, true, i, a->world + 2 * i);
    for (int k = 0; k < q->naxes; k++)
        good &= is_interval_proved(b, false, s->from[1] + k, a->inside + 2 * k);
    if (s->columns == s->from[2])
        return good && a->time[0] == 0 && a->time[1] == 1;
    return good & is_interval_proved(b, false, s->from[2], a->time);
}

/* Is every end proved to be the exact one, rounded outward? At the second try all points are known
 * that were found at the first. */
static bool is_box_proved(study_box_bench *b, const fmb_frame *p, const fmb_frame *q,
                          const fmb_pair_answers *a)
{
    return study_meeting_load(&b->meeting, p, q) && study_start_ends(b->proposer, p, q) &&
           (are_ends_proved(b, q, a) || are_ends_proved(b, q, a));
}

/* Ends by the exact way, where they are not proved. */
static fmb_status ask_exactly(study_box_bench *b, const fmb_frame *p, const fmb_frame *q,
                              unsigned *faults, const fmb_pair_answers *tightest,
                              study_tally *tally)
{
    fmb_pair_answers exact = of_pair(b, EXACT, 0);
    double none;
    fmb_status st = fmb_pair_test(b->way[EXACT], 1, p, q, &exact);
    tally->boxes_solved++;
    if (st == FMB_OK && *exact.verdict != FMB_FEASIBLE)
        *faults |= STUDY_FAULT_UNDECIDED;
    else if (st == FMB_OK)
        *faults |= study_box_faults(p, q, tightest, &exact, true, &none);
    return st;
}

/* Pair i, once everything was asked about it. */
static fmb_status judge(study_box_bench *b, size_t i, const fmb_frame *p, const fmb_frame *q,
                        unsigned *faults, study_tally *tally)
{
    fmb_pair_answers usual = of_pair(b, USUAL, i), tightest = of_pair(b, TIGHTEST, i);
    double excess;
    fmb_status st = FMB_OK;
    if (*usual.verdict != FMB_FEASIBLE || *tightest.verdict != FMB_FEASIBLE) {
        *faults |= STUDY_FAULT_UNDECIDED;
        return FMB_OK;
    }
    if (!is_box_proved(b, p, q, &tightest))
        st = ask_exactly(b, p, q, faults, &tightest, tally);
    *faults |= study_box_faults(p, q, &usual, &tightest, false, &excess);
    tally->excess = fmax(tally->excess, excess);
    if (st == FMB_OK)
        st = check_witness(b, p, q, usual.witness, faults);
    bool same = memcmp(usual.witness, tightest.witness, (size_t)b->dim * sizeof(double)) == 0;
    return st == FMB_OK && !same ? check_witness(b, p, q, tightest.witness, faults) : st;
}

fmb_status study_box_bench_run(study_box_bench *b, size_t n, const fmb_frame *p, const fmb_frame *q,
                               unsigned *faults, study_tally *tally)
{
    fmb_pair_counts before = {.size = sizeof before}, after = {.size = sizeof after};
    fmb_status st = fmb_pair_count(b->way[USUAL], &before);
    for (size_t i = 0; i < n; i++)
        faults[i] = 0;
    for (int order = 0; order < 2; order++) {
        const fmb_frame *x = order ? q : p, *y = order ? p : q;
        for (int way = 0; st == FMB_OK && way < EXACT && !atomic_load(&b->stopped); way++) {
            fmb_pair_answers out = of_pair(b, way, 0);
            st = fmb_pair_test(b->way[way], n, x, y, &out);
        }
        for (size_t i = 0; st == FMB_OK && i < n && !atomic_load(&b->stopped); i++)
            st = judge(b, i, &x[i], &y[i], &faults[i], tally);
    }
    tally->boxes += n;
    if (st == FMB_OK)
        st = fmb_pair_count(b->way[USUAL], &after);
    tally->doubtful += after.exact_boxes - before.exact_boxes;
    return st;
}
