/* intersect_exact.c: one pair by the public verbs, in rationals. */
#include <stdlib.h>

#include "common/message.h"
#include "fmb/intersect.h"
#include "fmb/show.h"

/* The variables whose intervals are reported: the point, the coordinates in the second frame, the
 * time. The system has those of the first frame before them, if that is one. */
static void list_variables(const fmb_frame_line *line, const fmb_system *s, meeting *m, int *var)
{
    int n = 0;
    bool first = !line->body[0].rows;
    m->dim = line->dim;
    m->inside = line->body[1].rows ? 0 : line->body[1].frame.naxes;
    m->inside = m->inside > m->dim ? 0 : m->inside; /* of a hull they are not unique */
    m->moves = line->body[0].frame.speed || line->body[1].frame.speed;
    for (; n < m->dim; n++)
        var[n] = n;
    for (int i = 0; i < m->inside; i++)
        var[n++] = m->dim + (first ? line->body[0].frame.naxes : 0) + i;
    if (m->moves)
        var[n] = fmb_system_dim(s) - 1;
}

static char *end_text(const intersect *x, const fmb_box *box, int i, fmb_side side)
{
    fmb_end end = fmb_box_end(box, i, side);
    if (end.kind == FMB_END_UNKNOWN)
        return NULL;
    if (end.kind == FMB_END_INFINITE)
        return app_print(side == FMB_LOWER ? "-inf" : "inf");
    app_rounding outward = side == FMB_LOWER ? APP_DOWN : APP_UP;
    if (x->ask->boxes == BOXES_OUTWARD)
        return report_double(x->ask, end.value, outward);
    mpq_t q;
    mpq_init(q);
    fmb_box_end_q(box, i, side, q);
    char *text = report_rational(x->ask, q, outward);
    mpq_clear(q);
    return text;
}

static bool is_open(const fmb_box *box, int i, fmb_side side)
{
    fmb_end_kind kind = fmb_box_end(box, i, side).kind;
    return kind == FMB_END_OUTER || kind == FMB_END_UNKNOWN;
}

static char *witness_text(const intersect *x, const fmb_evidence *e, int var)
{
    if (x->ask->boxes == BOXES_OUTWARD)
        return report_double(x->ask, fmb_evidence_coordinate(e, 0, var), APP_NEAREST);
    mpq_t q;
    mpq_init(q);
    fmb_evidence_coordinate_q(e, 0, var, q);
    char *text = report_rational(x->ask, q, APP_NEAREST);
    mpq_clear(q);
    return text;
}

/* The box of a pair that meets. A limit leaves ends outer or unknown. */
static fmb_status find_box(const intersect *x, const fmb_frame_line *line, const fmb_system *s,
                           const fmb_evidence *e, meeting *out)
{
    int *var = app_need(malloc((size_t)(fmb_system_dim(s) + 1) * sizeof *var));
    fmb_box *box = NULL;
    fmb_result res = {.size = sizeof res};
    list_variables(line, s, out, var);
    int n = out->dim + out->inside + out->moves;
    out->interval = app_need(calloc((size_t)n, sizeof *out->interval));
    for (int i = 0; i < n; i++)
        out->interval[i].at = witness_text(x, e, var[i]);
    fmb_status st = fmb_bound(x->solver, s, var, n, &box, &res);
    for (int i = 0; st == FMB_OK && i < n; i++) {
        interval *to = &out->interval[i];
        to->outer = !box || is_open(box, i, FMB_LOWER) || is_open(box, i, FMB_UPPER);
        to->lower = box ? end_text(x, box, i, FMB_LOWER) : NULL;
        to->upper = box ? end_text(x, box, i, FMB_UPPER) : NULL;
    }
    out->stop = res.stop;
    fmb_box_free(box);
    free(var);
    return st;
}

/* In more dimensions, solving for the coordinates of one frame is too expensive. */
#define MOST_SOLVED_DIM 32

/* [give] The system for a box; or for a verdict, with fewer variables where frames allow it. */
static fmb_status make_system(const intersect *x, const fmb_frame_line *line, fmb_system **out,
                              fmb_stop *stop)
{
    fmb_contact contact = x->ask->contact;
    fmb_status st = FMB_ERR_ARG;
    if (x->ask->boxes == BOXES_NONE && !line->body[0].rows && !line->body[1].rows &&
        line->dim <= MOST_SOLVED_DIM)
        st = fmb_system_from_line_within(line, FMB_COORDINATES_LAST, contact, x->solver, out, stop);
    return st == FMB_ERR_ARG ? fmb_system_from_line_within(line, FMB_COORDINATES_ALL, contact,
                                                           x->solver, out, stop)
                             : st;
}

static fmb_status intersect_by_verbs(const intersect *x, const fmb_frame_line *line, meeting *out)
{
    fmb_system *s = NULL;
    fmb_evidence *e = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_status st = make_system(x, line, &s, &res.stop);
    if (st == FMB_OK && s)
        st = fmb_solve(x->solver, s, &res);
    out->verdict = res.verdict;
    out->stop = res.stop;
    if (st == FMB_OK && res.verdict == FMB_FEASIBLE && x->ask->boxes != BOXES_NONE) {
        st = fmb_solver_evidence(x->solver, &e);
        if (st == FMB_OK)
            st = find_box(x, line, s, e, out);
    }
    fmb_evidence_free(e);
    fmb_system_free(s);
    return st;
}

fmb_status intersect_exactly(const intersect *x, const fmb_frame_line *line, numbers *room,
                             meeting *out)
{
    fmb_status st = intersect_quickly(x, line, room, out);
    if (st == FMB_OK && out->verdict == FMB_UNKNOWN)
        st = intersect_by_verbs(x, line, out);
    if (st == FMB_OK && near_is_asked(&x->ask->near))
        st = near_find(&x->ask->near, x->solver, line, x->ask->contact, out->verdict, &out->near);
    return st;
}
