/* meet.c: see meet.h. */
#include "meet.h"

#include <criterion/criterion.h>
#include <stdlib.h>

#include "property/random/rows.h"

fmb_system *meeting(const fmb_frame *f, size_t n, fmb_coordinates in)
{
    fmb_system *s = NULL;
    must(fmb_system_from_frames(f, n, in, FMB_CONTACT_CLOSED, NULL, &s));
    return s;
}

bool is_feasible(const fmb_system *s)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_evidence *e = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_judgement j = {.size = sizeof j};
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &r));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted && j.verdict == r.verdict, "%s", j.reason);
    fmb_evidence_free(e);
    fmb_solver_free(v);
    return r.verdict == FMB_FEASIBLE;
}

static bool decide(const fmb_frame *f, size_t n, fmb_coordinates in, fmb_contact contact)
{
    fmb_system *s = NULL;
    must(fmb_system_from_frames(f, n, in, contact, NULL, &s));
    bool yes = is_feasible(s);
    fmb_system_free(s);
    return yes;
}

bool meet(const fmb_frame *f, size_t n, fmb_coordinates in)
{
    return decide(f, n, in, FMB_CONTACT_CLOSED);
}

bool meet_open(const fmb_frame *f, size_t n, fmb_coordinates in)
{
    return decide(f, n, in, FMB_CONTACT_OPEN);
}

/* ---- rationals ------------------------------------------------------------------------------- */

static mpq_t *numbers(int n)
{
    mpq_t *a = malloc(((size_t)n + 1) * sizeof *a);
    cr_assert(a);
    for (int i = 0; i < n; i++)
        mpq_init(a[i]);
    return a;
}

fmb_frame_q rational_new(fmb_shape shape, int dim, int naxes, bool moves)
{
    return (fmb_frame_q){
        shape, dim, naxes, numbers(dim), numbers(dim * naxes), moves ? numbers(dim) : NULL};
}

fmb_frame_q rational_of(const fmb_frame *f)
{
    fmb_frame_q q = rational_new(f->shape, f->dim, f->naxes, f->speed != NULL);
    for (int j = 0; j < f->dim; j++) {
        mpq_set_d(q.origin[j], f->origin[j]);
        if (f->speed)
            mpq_set_d(q.speed[j], f->speed[j]);
        for (int i = 0; i < f->naxes; i++)
            mpq_set_d(q.axes[i * f->dim + j], f->axes[i * f->dim + j]);
    }
    return q;
}

static void drop(mpq_t *a, int n)
{
    for (int i = 0; a && i < n; i++)
        mpq_clear(a[i]);
    free(a);
}

void rational_free(fmb_frame_q *f)
{
    drop(f->origin, f->dim);
    drop(f->axes, f->dim * f->naxes);
    drop(f->speed, f->dim);
}
