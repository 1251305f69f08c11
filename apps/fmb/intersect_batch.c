/* intersect_batch.c: many pairs at once. Pairs in doubles are collected for fmb_pair_test; others
 * between them are answered exactly at once, and their reports wait for their turn. */
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "fmb/intersect.h"
#include "fmb/stop.h"

enum {
    MOST = 1024,       /* lines that wait */
    NUMBERS = 1 << 21, /* doubles of frames that wait, at least of one pair */
};

struct batch {
    intersect *x;
    fmb_pair *k; /* for frames of dimension dim, or NULL */
    int dim;
    size_t lines, pairs, most; /* most: pairs that can wait */
    meeting found[MOST];
    size_t place[MOST];       /* of pair i among the lines */
    fmb_frame frame[2][MOST]; /* [A or B][pair] */
    double *number;           /* room for every pair that can wait */
    double *answer;           /* and for the answers: world, inside, time, witness */
    fmb_verdict verdict[MOST];
    numbers *room; /* for lines that are answered in rationals */
};

batch *batch_new(intersect *x)
{
    batch *b = app_need(calloc(1, sizeof *b));
    b->x = x;
    b->room = numbers_new();
    return b;
}

void batch_free(batch *b)
{
    if (!b)
        return;
    app_stop_pairs(NULL);
    fmb_pair_free(b->k);
    free(b->number);
    free(b->answer);
    numbers_free(b->room);
    free(b);
}

/* Numbers of a frame: origin, axes, speed. */
static size_t frame_size(size_t dim)
{
    return dim * (dim + 2);
}

/* Numbers of an answer. */
static size_t answer_size(size_t dim)
{
    return 5 * dim + 2;
}

void batch_join(const batch *b)
{
    app_stop_pairs(b->k);
}

/* Make a pair query for this dimension; no pairs are collected. */
static fmb_status prepare(batch *b, int dim)
{
    size_t d = (size_t)dim;
    fmb_pair_options o = {.size = sizeof o};
    o.contact = b->x->ask->contact;
    o.max_seconds = b->x->ask->max_seconds;
    o.max_bytes = b->x->ask->max_bytes > 0 ? b->x->ask->max_bytes : SIZE_MAX;
    app_stop_pairs(NULL);
    fmb_pair_free(b->k);
    b->k = NULL;
    b->dim = dim;
    b->most = NUMBERS / (2 * frame_size(d));
    b->most = b->most < 1 ? 1 : b->most > MOST ? MOST : b->most;
    b->number = app_need(realloc(b->number, 2 * b->most * frame_size(d) * sizeof *b->number));
    b->answer = app_need(realloc(b->answer, (b->most + 1) * answer_size(d) * sizeof *b->answer));
    fmb_status st = fmb_pair_new(dim, &o, NULL, &b->k);
    app_stop_pairs(b->k);
    return st;
}

/* ---- answers --------------------------------------------------------------------------------- */

static interval interval_of(const batch *b, const double *ends, char *at)
{
    const intersect_ask *ask = b->x->ask;
    return (interval){.lower = report_double(ask, ends[0], APP_DOWN),
                      .upper = report_double(ask, ends[1], APP_UP),
                      .at = at};
}

/* Read the answers of fmb_pair_test about pair i. */
static void take_answer(batch *b, size_t i, const fmb_pair_answers *a)
{
    meeting *m = &b->found[b->place[i]];
    size_t d = (size_t)b->dim;
    m->verdict = b->verdict[i];
    m->stop = m->verdict != FMB_UNKNOWN    ? FMB_STOP_DONE
              : b->x->ask->max_seconds > 0 ? FMB_STOP_TIME
                                           : FMB_STOP_BYTES;
    if (m->verdict == FMB_UNKNOWN && app_stop_asked())
        m->stop = FMB_STOP_CANCELLED;
    if (m->verdict != FMB_FEASIBLE || !a->world)
        return;
    const fmb_frame *p = &b->frame[0][i], *q = &b->frame[1][i];
    m->dim = b->dim;
    m->inside = q->naxes;
    m->moves = p->speed || q->speed;
    m->interval = app_need(calloc(2 * d + 1, sizeof *m->interval));
    interval *to = m->interval;
    for (size_t j = 0; j < d; j++)
        *to++ = interval_of(b, a->world + 2 * (d * i + j),
                            report_double(b->x->ask, a->witness[d * i + j], APP_NEAREST));
    for (size_t j = 0; j < (size_t)q->naxes; j++)
        *to++ = interval_of(b, a->inside + 2 * (d * i + j), NULL);
    if (m->moves)
        *to = interval_of(b, a->time + 2 * i, NULL);
}

static fmb_status test_pairs(batch *b)
{
    size_t d = (size_t)b->dim, n = b->pairs;
    fmb_pair_answers a = {.size = sizeof a, .verdict = b->verdict};
    if (n == 0)
        return FMB_OK;
    if (n == 1 && b->dim <= 3) { /* boxes of several are the same in any company */
        b->frame[0][1] = b->frame[0][0];
        b->frame[1][1] = b->frame[1][0];
        n = 2;
    }
    if (b->x->ask->boxes == BOXES_OUTWARD) {
        a.world = b->answer;
        a.inside = a.world + 2 * d * n;
        a.time = a.inside + 2 * d * n;
        a.witness = a.time + 2 * n;
    }
    for (size_t i = 0; i < n; i++)
        b->verdict[i] = FMB_UNKNOWN;
    /* A signal that came before would not be meant for this test. */
    fmb_status st =
        app_stop_asked() ? FMB_OK : fmb_pair_test(b->k, n, b->frame[0], b->frame[1], &a);
    for (size_t i = 0; st == FMB_OK && i < b->pairs; i++)
        take_answer(b, i, &a);
    return st;
}

fmb_status batch_flush(batch *b)
{
    fmb_status st = test_pairs(b);
    for (size_t i = 0; st == FMB_OK && i < b->lines; i++)
        report_pair(b->x, &b->found[i]);
    b->lines = b->pairs = 0;
    return st;
}

/* ---- lines ----------------------------------------------------------------------------------- */

/* A copy whose numbers lie at `to`. */
static fmb_frame copy_frame(const fmb_frame *f, double *to)
{
    size_t d = (size_t)f->dim, axes = d * (size_t)f->naxes;
    fmb_frame copy = *f;
    memcpy(to, f->origin, d * sizeof *to);
    if (axes > 0)
        memcpy(to + d, f->axes, axes * sizeof *to);
    if (f->speed)
        memcpy(to + d + axes, f->speed, d * sizeof *to);
    copy.origin = to;
    copy.axes = to + d;
    copy.speed = f->speed ? to + d + axes : NULL;
    return copy;
}

static void put_pair(batch *b, const fmb_frame_line *line)
{
    size_t each = frame_size((size_t)b->dim);
    double *to = b->number + 2 * each * b->pairs;
    b->frame[0][b->pairs] = copy_frame(&line->frame[0], to);
    b->frame[1][b->pairs] = copy_frame(&line->frame[1], to + each);
    b->place[b->pairs++] = b->lines;
}

/* Can the line be collected: frames of doubles, with room for their numbers, and only verdicts and
 * boxes requested? */
static bool is_for_batch(const batch *b, const fmb_frame_line *line)
{
    return line->are_doubles && b->x->ask->boxes != BOXES_EXACT &&
           !near_is_asked(&b->x->ask->near) && line->frame[0].naxes <= line->dim &&
           line->frame[1].naxes <= line->dim;
}

bool batch_wants_rationals(const batch *b, const fmb_frame_line *line)
{
    return !is_for_batch(b, line);
}

fmb_status batch_put(batch *b, const fmb_frame_line *line)
{
    fmb_status st = FMB_OK;
    bool fast = is_for_batch(b, line);
    if (fast && line->dim != b->dim) {
        st = batch_flush(b);
        if (st == FMB_OK)
            st = prepare(b, line->dim);
    }
    if (st != FMB_OK)
        return st;
    meeting *m = &b->found[b->lines];
    *m = (meeting){.line = b->x->before + line->number,
                   .id = line->id ? app_need(strdup(line->id)) : NULL};
    if (fast)
        put_pair(b, line);
    else
        st = intersect_exactly(b->x, line, b->room, m);
    b->lines++;
    bool full = b->lines == MOST || b->pairs == b->most || b->x->ask->boxes == BOXES_EXACT;
    return st == FMB_OK && full ? batch_flush(b) : st;
}
