/* intersect_quick.c: one pair of frames at its vertices: exact, too, and in microseconds. */
#include <math.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb/intersect.h"

enum { MOST_DIM = 8, MOST_VARIABLES = 2 * MOST_DIM + 1 };

/* Ends, two a variable, and a common point: of the world, of the second frame, of time. */
struct numbers {
    mpq_t end[2 * MOST_VARIABLES], at[MOST_VARIABLES];
};

numbers *numbers_new(void)
{
    numbers *room = app_need(malloc(sizeof *room));
    for (int i = 0; i < 2 * MOST_VARIABLES; i++)
        mpq_init(room->end[i]);
    for (int i = 0; i < MOST_VARIABLES; i++)
        mpq_init(room->at[i]);
    return room;
}

void numbers_free(numbers *room)
{
    for (int i = 0; room && i < 2 * MOST_VARIABLES; i++)
        mpq_clear(room->end[i]);
    for (int i = 0; room && i < MOST_VARIABLES; i++)
        mpq_clear(room->at[i]);
    free(room);
}

/* ---- as doubles ------------------------------------------------------------------------------ */

/* The greatest double that is at most q, or the least that is at least q. */
static double double_beside(mpq_srcptr q, bool above)
{
    double d = mpq_get_d(q), away = above ? INFINITY : -INFINITY;
    mpq_t back;
    if (!isfinite(d))
        return (d > 0) == above ? d : nextafter(d, 0);
    mpq_init(back);
    mpq_set_d(back, d);
    int order = mpq_cmp(back, q);
    mpq_clear(back);
    return order != 0 && (order > 0) != above ? nextafter(d, away) : d;
}

static double nearest_double(mpq_srcptr q)
{
    double side[2] = {double_beside(q, false), double_beside(q, true)};
    mpq_t off[2];
    if (!isfinite(side[0]) || !isfinite(side[1]))
        return isfinite(side[0]) ? side[0] : side[1];
    for (int i = 0; i < 2; i++) {
        mpq_init(off[i]);
        mpq_set_d(off[i], side[i]);
        mpq_sub(off[i], off[i], q);
        mpq_abs(off[i], off[i]);
    }
    bool is_above = mpq_cmp(off[1], off[0]) < 0;
    mpq_clears(off[0], off[1], NULL);
    return side[is_above];
}

/* ---- answers --------------------------------------------------------------------------------- */

static void write_intervals(const intersect *x, numbers *a, meeting *out)
{
    int n = out->dim + out->inside + out->moves;
    bool rounds = x->ask->boxes == BOXES_OUTWARD;
    out->interval = app_need(calloc((size_t)n, sizeof *out->interval));
    for (int i = 0; i < n; i++) {
        interval *to = &out->interval[i];
        mpq_srcptr low = a->end[2 * i], high = a->end[2 * i + 1], at = a->at[i];
        if (rounds) {
            to->lower = report_double(x->ask, double_beside(low, false), APP_DOWN);
            to->upper = report_double(x->ask, double_beside(high, true), APP_UP);
            to->at = report_double(x->ask, nearest_double(at), APP_NEAREST);
        } else {
            to->lower = report_rational(x->ask, low, APP_DOWN);
            to->upper = report_rational(x->ask, high, APP_UP);
            to->at = report_rational(x->ask, at, APP_NEAREST);
        }
    }
}

/* The arrays for the requested answers. */
static fmb_pair_answers_q list_answers(const meeting *m, numbers *a)
{
    mpq_t *inside = a->end + 2 * m->dim;
    return (fmb_pair_answers_q){.size = sizeof(fmb_pair_answers_q),
                                .world = a->end,
                                .inside = inside,
                                .time = inside + 2 * m->inside,
                                .witness = a->at};
}

static bool is_quick(const fmb_frame_line *line)
{
    return !line->body[0].rows && !line->body[1].rows && line->dim <= MOST_DIM &&
           line->body[0].frame.naxes <= line->dim && line->body[1].frame.naxes <= line->dim;
}

fmb_status intersect_quickly(const intersect *x, const fmb_frame_line *line, numbers *room,
                             meeting *out)
{
    const fmb_frame_q *p = &line->body[0].frame, *q = &line->body[1].frame;
    fmb_pair_answers_q places = {.size = sizeof places};
    if (!is_quick(line))
        return FMB_OK;
    out->dim = line->dim;
    out->inside = q->naxes;
    out->moves = p->speed || q->speed;
    if (x->ask->boxes != BOXES_NONE)
        places = list_answers(out, room);
    fmb_status st = fmb_pair_answer_q(p, q, &places, &out->verdict);
    if (x->ask->contact == FMB_CONTACT_OPEN && out->verdict == FMB_FEASIBLE)
        out->verdict = FMB_UNKNOWN; /* closed frames may only touch */
    if (st == FMB_OK && out->verdict == FMB_FEASIBLE && x->ask->boxes != BOXES_NONE)
        write_intervals(x, room, out);
    return st;
}
