/* exact.c: see exact.h. */
#include "pair/exact.h"

#include <math.h>

#include "frame/frame_private.h"
#include "num/rationals.h"
#include "pair/exact_box/exact_box.h"
#include "pair/exact_box/exact_box_program.h"
#include "proximity/proximity_private.h"
#include "solve/query/solver.h"
#include "system/system_private.h"

fmb_status fmb_pair_oracle_open(fmb_pair_oracle *x, const fmb_pair_options *o,
                                const fmb_alloc *hook)
{
    *x = (fmb_pair_oracle){.contact = o->contact,
                           .limits = (fmb_options){.size = sizeof(fmb_options)}};
    x->limits.max_seconds = o->max_seconds;
    x->limits.max_bytes = o->max_bytes == 0          ? (size_t)1 << 30
                          : o->max_bytes == SIZE_MAX ? 0
                                                     : o->max_bytes;
    fmb_mem_init(&x->mem, hook, 0);
    fmb_options how = {.size = sizeof how};
    how.evidence = FMB_EVIDENCE_NONE;
    fmb_status st = fmb_solver_new(&how, hook, &x->solver);
    how.evidence = FMB_EVIDENCE_ALL;
    FMB_THEN(st, fmb_solver_new(&how, hook, &x->proving));
    if (st == FMB_OK)
        x->solver->within = x->proving->within = &x->run;
    return st;
}

void fmb_pair_oracle_close(fmb_pair_oracle *x)
{
    fmb_solver_free(x->solver);
    fmb_solver_free(x->proving);
}

/* [give] Start a query: its clock, its system, and the remaining limit of memory. */
static fmb_status start_query(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                              fmb_coordinates in, fmb_system **out)
{
    const fmb_frame both[2] = {*p, *q};
    size_t most = x->limits.max_bytes;
    fmb_run_begin(&x->run, &x->mem, &x->limits, &x->cancel, (fmb_sink){0}, "pair");
    fmb_status st =
        fmb_frames_within_limits(both, NULL, 2, in, x->contact, &x->mem.alloc, &x->run, out);
    if (st == FMB_OK && most > 0)
        most = most > (*out)->mem.used ? most - (*out)->mem.used : 1;
    x->solver->options.max_bytes = x->proving->options.max_bytes = most;
    return st;
}

fmb_status fmb_pair_oracle_decide(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                  fmb_verdict *out)
{
    fmb_system *s = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_status st = start_query(x, p, q, FMB_COORDINATES_EACH, &s);
    FMB_THEN(st, fmb_solve(x->solver, s, &res));
    if (st == FMB_OK || st == FMB_LIMIT)
        *out = res.verdict;
    fmb_system_free(s);
    return st == FMB_LIMIT ? FMB_OK : st;
}

static void write_interval(const fmb_box *box, int i, double *out)
{
    out[0] = fmb_box_end(box, i, FMB_LOWER).value;
    out[1] = fmb_box_end(box, i, FMB_UPPER).value;
}

/* Are coordinates in q to be written? In a hull they are not unique, and too many for the array. */
static bool asks_inside(const fmb_frame *q, const fmb_pair_answers *out)
{
    return out->inside && q->naxes <= q->dim;
}

/* List the requested variables of the system, whose order is x, c of p, c of q, t. Returns their
 * number. */
static int list_variables_asked(const fmb_frame *p, const fmb_frame *q, const fmb_pair_answers *out,
                                int *vars)
{
    int dim = p->dim, from = dim + p->naxes, n = 0;
    for (int j = 0; out->world && j < dim; j++)
        vars[n++] = j;
    for (int j = 0; asks_inside(q, out) && j < q->naxes; j++)
        vars[n++] = from + j;
    if (out->time && (p->speed || q->speed))
        vars[n++] = from + q->naxes;
    return n;
}

static void write_box_asked(const fmb_box *box, const fmb_frame *p, const fmb_frame *q,
                            const fmb_pair_answers *out)
{
    int i = 0;
    for (int j = 0; out->world && j < p->dim; j++)
        write_interval(box, i++, out->world + 2 * j);
    for (int j = 0; asks_inside(q, out) && j < q->naxes; j++)
        write_interval(box, i++, out->inside + 2 * j);
    if (out->time && (p->speed || q->speed)) {
        write_interval(box, i, out->time);
    } else if (out->time) {
        out->time[0] = 0;
        out->time[1] = 1;
    }
}

static fmb_status bound_variables_asked(fmb_pair_oracle *x, const fmb_system *s, const fmb_frame *p,
                                        const fmb_frame *q, const fmb_pair_answers *out)
{
    size_t most = 2 * (size_t)p->dim + 1;
    fmb_box *box = NULL;
    fmb_result res = {.size = sizeof res};
    int *vars;
    FMB_TRY(FMB_GET(&x->mem, vars, most));
    fmb_status st =
        fmb_bound(x->solver, s, vars, list_variables_asked(p, q, out, vars), &box, &res);
    if (st == FMB_OK)
        *out->verdict = res.stop == FMB_STOP_DONE ? res.verdict : FMB_UNKNOWN;
    if (st == FMB_OK && *out->verdict == FMB_FEASIBLE)
        write_box_asked(box, p, q, out);
    fmb_box_free(box);
    fmb_mem_put(&x->mem, vars, most, sizeof *vars);
    return st;
}

static fmb_status find_witness(fmb_pair_oracle *x, const fmb_system *s, int dim,
                               const fmb_pair_answers *out)
{
    fmb_evidence *e = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_status st = fmb_solve(x->proving, s, &res);
    if (st == FMB_OK)
        *out->verdict = res.verdict;
    if (st == FMB_OK && res.verdict == FMB_FEASIBLE)
        st = fmb_solver_evidence(x->proving, &e);
    for (int j = 0; e && j < dim; j++)
        out->witness[j] = fmb_evidence_coordinate(e, 0, j);
    fmb_evidence_free(e);
    return st;
}

fmb_status fmb_pair_oracle_answer(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                  const fmb_pair_answers *out)
{
    fmb_system *s = NULL;
    fmb_status st = start_query(x, p, q, FMB_COORDINATES_ALL, &s);
    if (st == FMB_OK && out->witness)
        st = find_witness(x, s, p->dim, out);
    bool goes_on = !out->witness || *out->verdict == FMB_FEASIBLE;
    if (st == FMB_OK && goes_on && (out->world || out->inside || out->time))
        st = bound_variables_asked(x, s, p, q, out);
    if (st == FMB_LIMIT)
        *out->verdict = FMB_UNKNOWN;
    fmb_system_free(s);
    return st == FMB_LIMIT ? FMB_OK : st;
}

bool fmb_pair_oracle_answer_at_vertices(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                        const fmb_pair_answers *out)
{
    if (!fmb_exact_box_is_for(p->dim, p->naxes, q->naxes))
        return false;
    fmb_run_begin(&x->run, &x->mem, &x->limits, &x->cancel, (fmb_sink){0}, "pair");
    const fmb_poll poll = fmb_run_asked(&x->run);
    fmb_exact_boxer *b = fmb_long_boxer_new(&x->mem, &poll);
    bool done = fmb_long_box_answer(b, p, q, out);
    fmb_long_boxer_free(b, &x->mem);
    if (!done && x->run.stop != FMB_STOP_DONE)
        *out->verdict = FMB_UNKNOWN;
    return done || x->run.stop != FMB_STOP_DONE;
}

bool fmb_pair_oracle_decide_at_vertices(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                        fmb_verdict *out)
{
    *out = FMB_UNKNOWN;
    if (!fmb_exact_box_is_for(p->dim, p->naxes, q->naxes))
        return false;
    fmb_run_begin(&x->run, &x->mem, &x->limits, &x->cancel, (fmb_sink){0}, "pair");
    const fmb_poll poll = fmb_run_asked(&x->run);
    fmb_exact_boxer *b = fmb_long_boxer_new(&x->mem, &poll);
    *out = fmb_long_box_decide(b, p, q, x->contact);
    fmb_long_boxer_free(b, &x->mem);
    return *out != FMB_UNKNOWN || x->run.stop != FMB_STOP_DONE;
}

/* ---- how near -------------------------------------------------------------------------------- */

/* The direction of a vector as doubles of length 1, whatever its numbers are. */
static void write_direction(int dim, mpq_t *v, double *out)
{
    mpq_t most, x;
    double length = 0;
    mpq_inits(most, x, NULL);
    for (int j = 0; j < dim; j++) {
        mpq_abs(x, v[j]);
        if (mpq_cmp(x, most) > 0)
            mpq_set(most, x);
    }
    for (int j = 0; j < dim; j++) {
        if (mpq_sgn(most) != 0)
            mpq_div(x, v[j], most);
        out[j] = fmb_nearest_double(x);
        length += out[j] * out[j];
    }
    for (int j = 0; length > 0 && j < dim; j++)
        out[j] /= sqrt(length);
    mpq_clears(most, x, NULL);
}

fmb_status fmb_pair_oracle_near(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                fmb_verdict *verdict, fmb_pair_near *out)
{
    const fmb_frame both[2] = {*p, *q};
    bool meet = *verdict == FMB_FEASIBLE;
    fmb_proximity *near = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_run_begin(&x->run, &x->mem, &x->limits, &x->cancel, (fmb_sink){0}, "pair");
    x->solver->options.max_bytes = x->limits.max_bytes;
    fmb_status st =
        (meet ? fmb_depth : fmb_distance)(x->solver, both, FMB_NORM_EUCLIDEAN, &near, &res);
    if (near) {
        out->length = fmb_proximity_length(near);
        write_direction(p->dim, near->normal, out->normal);
        for (int j = 0; j < p->dim; j++)
            for (int k = 0; k < 2; k++)
                out->point[k][j] = fmb_proximity_point(near, k, j);
    } else {
        *verdict = FMB_UNKNOWN;
    }
    fmb_proximity_free(near);
    return st == FMB_LIMIT ? FMB_OK : st;
}
