/* intersect_quick.c: one pair of frames at its vertices: exact, too, and in microseconds. */
#include <stdlib.h>

#include "common/message.h"
#include "fmb/intersect.h"

enum { MOST_DIM = 3, MOST_VARIABLES = 2 * MOST_DIM + 1 };

/* Ends, two a variable, and a common point: of the world, of the second frame, of time. */
typedef struct numbers {
    mpq_t end[2 * MOST_VARIABLES], at[MOST_VARIABLES];
} numbers;

static void write_intervals(numbers *a, meeting *out)
{
    int n = out->dim + out->inside + out->moves;
    out->interval = app_need(calloc((size_t)n, sizeof *out->interval));
    for (int i = 0; i < n; i++) {
        interval *to = &out->interval[i];
        to->lower = app_need(mpq_get_str(NULL, 10, a->end[2 * i]));
        to->upper = app_need(mpq_get_str(NULL, 10, a->end[2 * i + 1]));
        to->at = app_need(mpq_get_str(NULL, 10, a->at[i]));
    }
}

/* Where there is room for what is asked. */
static fmb_pair_answers_q list_answers(const meeting *m, numbers *a)
{
    mpq_t *inside = a->end + 2 * m->dim;
    return (fmb_pair_answers_q){a->end, inside, inside + 2 * m->inside, a->at};
}

static bool is_quick(const intersect *x, const fmb_frames_line *line)
{
    return x->ask->boxes != BOXES_OUTWARD && x->ask->contact == FMB_CONTACT_CLOSED &&
           !line->body[0].rows && !line->body[1].rows && line->dim <= MOST_DIM &&
           line->body[0].frame.naxes <= line->dim && line->body[1].frame.naxes <= line->dim;
}

fmb_status intersect_quickly(const intersect *x, const fmb_frames_line *line, meeting *out)
{
    const fmb_frame_q *p = &line->body[0].frame, *q = &line->body[1].frame;
    fmb_pair_answers_q places = {0};
    numbers a;
    if (!is_quick(x, line))
        return FMB_OK;
    out->dim = line->dim;
    out->inside = q->naxes;
    out->moves = p->speed || q->speed;
    for (int i = 0; i < 2 * MOST_VARIABLES; i++)
        mpq_init(a.end[i]);
    for (int i = 0; i < MOST_VARIABLES; i++)
        mpq_init(a.at[i]);
    if (x->ask->boxes != BOXES_NONE)
        places = list_answers(out, &a);
    fmb_status st = fmb_pair_answer_q(p, q, &places, &out->verdict);
    if (st == FMB_OK && out->verdict == FMB_FEASIBLE && x->ask->boxes != BOXES_NONE)
        write_intervals(&a, out);
    for (int i = 0; i < 2 * MOST_VARIABLES; i++)
        mpq_clear(a.end[i]);
    for (int i = 0; i < MOST_VARIABLES; i++)
        mpq_clear(a.at[i]);
    return st;
}
