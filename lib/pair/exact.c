/* exact.c: see exact.h. */
#include "pair/exact.h"

#include "base/mem.h"

fmb_status fmb_pair_oracle_open(fmb_pair_oracle *x, const fmb_pair_options *o,
                                const fmb_alloc *hook)
{
    *x = (fmb_pair_oracle){.hook = hook ? *hook : (fmb_alloc){0}, .contact = o->contact};
    fmb_options how = fmb_options_default();
    how.evidence = false;
    how.max_seconds = o->max_seconds;
    fmb_status st = fmb_solver_new(&how, hook, &x->solver);
    how.evidence = true;
    return st == FMB_OK ? fmb_solver_new(&how, hook, &x->proving) : st;
}

void fmb_pair_oracle_close(fmb_pair_oracle *x)
{
    fmb_solver_free(x->solver);
    fmb_solver_free(x->proving);
}

/* [give] */
static fmb_status make(const fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                       fmb_coordinates in, fmb_system **out)
{
    const fmb_frame both[2] = {*p, *q};
    return fmb_system_from_frames(both, 2, in, x->contact, x->hook.resize ? &x->hook : NULL, out);
}

fmb_status fmb_pair_oracle_decide(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                  fmb_verdict *out)
{
    fmb_system *s = NULL;
    fmb_result res;
    fmb_status st = make(x, p, q, FMB_COORDINATES_EACH, &s);
    if (st == FMB_OK)
        st = fmb_solve(x->solver, s, &res);
    if (st == FMB_OK)
        *out = res.verdict;
    fmb_system_free(s);
    return st;
}

static void write_interval(const fmb_box *box, int i, double *out)
{
    out[0] = fmb_box_end(box, i, FMB_LOWER).value;
    out[1] = fmb_box_end(box, i, FMB_UPPER).value;
}

/* The variables of the system are x, c of p, c of q, t; those that are asked for, in this order.
 * Their number. */
static int choose(const fmb_frame *p, const fmb_frame *q, const fmb_pair_answers *out, int *vars)
{
    int dim = p->dim, from = dim + p->naxes, n = 0;
    for (int j = 0; out->world && j < dim; j++)
        vars[n++] = j;
    for (int j = 0; out->inside && j < q->naxes; j++)
        vars[n++] = from + j;
    if (out->time && (p->speed || q->speed))
        vars[n++] = from + q->naxes;
    return n;
}

static void write_box(const fmb_box *box, const fmb_frame *p, const fmb_frame *q,
                      const fmb_pair_answers *out)
{
    int i = 0;
    for (int j = 0; out->world && j < p->dim; j++)
        write_interval(box, i++, out->world + 2 * j);
    for (int j = 0; out->inside && j < q->naxes; j++)
        write_interval(box, i++, out->inside + 2 * j);
    if (out->time && (p->speed || q->speed)) {
        write_interval(box, i, out->time);
    } else if (out->time) {
        out->time[0] = 0;
        out->time[1] = 1;
    }
}

static fmb_status bound(fmb_pair_oracle *x, const fmb_system *s, const fmb_frame *p,
                        const fmb_frame *q, const fmb_pair_answers *out)
{
    size_t most = 2 * (size_t)p->dim + 1;
    fmb_mem mem;
    fmb_box *box = NULL;
    fmb_result res;
    fmb_mem_init(&mem, x->hook.resize ? &x->hook : NULL, 0);
    int *vars = fmb_mem_get(&mem, most, sizeof *vars);
    if (!vars)
        return fmb_mem_status(&mem);
    fmb_status st = fmb_bound(x->solver, s, vars, choose(p, q, out, vars), &box, &res);
    if (st == FMB_OK)
        *out->verdict = res.stop == FMB_STOP_DONE ? res.verdict : FMB_UNKNOWN;
    if (st == FMB_OK && *out->verdict == FMB_FEASIBLE)
        write_box(box, p, q, out);
    fmb_box_free(box);
    fmb_mem_put(&mem, vars, most, sizeof *vars);
    return st;
}

static fmb_status find_witness(fmb_pair_oracle *x, const fmb_system *s, int dim,
                               const fmb_pair_answers *out)
{
    fmb_evidence *e = NULL;
    fmb_result res;
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
    fmb_status st = make(x, p, q, FMB_COORDINATES_ALL, &s);
    if (st == FMB_OK && out->witness)
        st = find_witness(x, s, p->dim, out);
    bool goes_on = !out->witness || *out->verdict == FMB_FEASIBLE;
    if (st == FMB_OK && goes_on && (out->world || out->inside || out->time))
        st = bound(x, s, p, q, out);
    fmb_system_free(s);
    return st;
}
