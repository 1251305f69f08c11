/* box_check.c: see box_check.h. */
#include "box_check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "property/random/rows.h"

fmb_pair_answers box_answer_places(box_answer *a, fmb_verdict *verdict)
{
    memset(a, 0, sizeof *a);
    return (fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                              .verdict = verdict,
                              .world = a->world[0],
                              .inside = a->inside[0],
                              .time = a->time,
                              .witness = a->witness};
}

/* The largest coordinate j of a corner, or minus the least. */
static double far_out(const fmb_frame *f, int j, double sign)
{
    double at = sign * f->origin[j], most = 0;
    for (int l = 0; l < f->naxes; l++) {
        double x = sign * f->axes[l * f->dim + j];
        most = f->shape == FMB_SIMPLEX ? fmax(most, x) : most + fmax(x, 0);
    }
    at += most;
    return fmax(at, at + (f->speed ? sign * f->speed[j] : 0));
}

double box_largest(const fmb_frame *p, const fmb_frame *q)
{
    double most = 0;
    for (int j = 0; j < p->dim; j++)
        for (int side = -1; side <= 1; side += 2)
            most = fmax(most, fmax(far_out(p, j, side), far_out(q, j, side)));
    return most;
}

void box_check_open(box_check *c)
{
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_NONE;
    *c = (box_check){.solver = NULL};
    must(fmb_solver_new(&o, NULL, &c->solver));
}

void box_check_close(box_check *c)
{
    fmb_solver_free(c->solver);
}

/* An exact end, rounded outward. */
static double outward(const mpq_t end, fmb_side side)
{
    double x = mpq_get_d(end), to = side == FMB_LOWER ? -HUGE_VAL : HUGE_VAL;
    mpq_t back;
    mpq_init(back);
    mpq_set_d(back, x);
    int far = mpq_cmp(back, end);
    mpq_clear(back);
    return (side == FMB_LOWER ? far > 0 : far < 0) ? nextafter(x, to) : x;
}

/* Is end x at least as far out as the exact one, and by at most `allowed`? */
static bool is_good(box_check *c, const fmb_box *box, int i, fmb_side side, double x,
                    double allowed, bool tightest)
{
    mpq_t end, ours;
    mpq_inits(end, ours, NULL);
    bool is = isfinite(x) && fmb_box_end_q(box, i, side, end);
    if (is) {
        mpq_set_d(ours, x);
        mpq_sub(ours, side == FMB_LOWER ? end : ours, side == FMB_LOWER ? ours : end);
        bool exact = x == outward(end, side);
        double excess = exact ? 0 : mpq_get_d(ours) / allowed;
        is = mpq_sgn(ours) >= 0 && (exact || (!tightest && excess <= 1));
        if (!is)
            snprintf(c->why, sizeof c->why, "variable %d, side %d: %.17g for %.17g", i, (int)side,
                     x, mpq_get_d(end));
        c->excess = excess > c->excess && !tightest ? excess : c->excess;
    } else {
        snprintf(c->why, sizeof c->why, "variable %d, side %d: %g", i, (int)side, x);
    }
    mpq_clears(end, ours, NULL);
    return is;
}

static bool are_good(box_check *c, const fmb_box *box, int from, int n, double (*x)[2],
                     double allowed, bool tightest)
{
    for (int j = 0; j < n; j++)
        for (int side = 0; side < 2; side++)
            if (!is_good(c, box, from + j, side ? FMB_UPPER : FMB_LOWER, x[j][side], allowed,
                         tightest))
                return false;
    return true;
}

/* Some common point is within `allowed` of the witness in every coordinate. */
static bool witness_is_near(box_check *c, const fmb_system *s, int dim, const double *x,
                            double allowed)
{
    fmb_system *near = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_system_copy(s, &near));
    for (int j = 0; j < dim; j++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double row[3 * BOX_CHECK_MOST_DIM + 1] = {0};
            row[j] = sign;
            must(fmb_system_add(near, row, FMB_LE, sign * x[j] + allowed));
        }
    must(fmb_solve(c->solver, near, &r));
    fmb_system_free(near);
    if (r.verdict != FMB_FEASIBLE)
        snprintf(c->why, sizeof c->why, "the witness (%.17g, %.17g ...) is no common point", x[0],
                 x[1]);
    return r.verdict == FMB_FEASIBLE;
}

static bool check_answer(box_check *c, const fmb_system *s, const fmb_box *box, const fmb_frame *p,
                         const fmb_frame *q, box_answer a, bool tightest)
{
    int d = p->dim, time = d + p->naxes + q->naxes;
    double large = 1e-12 * box_largest(p, q);
    bool good = are_good(c, box, 0, d, a.world, large, tightest) &&
                are_good(c, box, d + p->naxes, q->naxes, a.inside, 1e-12, tightest);
    if (good && (p->speed || q->speed)) {
        good = are_good(c, box, time, 1, &a.time, 1e-12, tightest);
    } else if (good && (a.time[0] != 0 || a.time[1] != 1)) {
        snprintf(c->why, sizeof c->why, "nothing moves, but times are %g, %g", a.time[0],
                 a.time[1]);
        good = false;
    }
    return good && witness_is_near(c, s, d, a.witness, large + 0x1p-1073);
}

bool box_check_pair(box_check *c, const fmb_frame *p, const fmb_frame *q, const box_answer *a,
                    size_t n, bool tightest)
{
    const fmb_frame both[2] = {*p, *q};
    fmb_system *s = NULL;
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_system_from_frames(both, 2, FMB_COORDINATES_ALL, FMB_CONTACT_CLOSED, NULL, &s));
    must(fmb_bound(c->solver, s, NULL, 0, &box, &r));
    bool good = r.verdict == FMB_FEASIBLE;
    if (!good)
        snprintf(c->why, sizeof c->why, "they do not meet");
    for (size_t i = 0; good && i < n; i++)
        good = check_answer(c, s, box, p, q, a[i], tightest);
    fmb_box_free(box);
    fmb_system_free(s);
    return good;
}
