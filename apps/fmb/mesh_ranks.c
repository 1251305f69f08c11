/* mesh_ranks.c: all pairs of cells of two meshes, by one process or the ranks of several
 * (common/ranks.h): each takes the next rows of pairs when it has done its last ones. */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "common/message.h"
#include "common/ranks.h"
#include "fmb/mesh_ask.h"

/* ---- meshes ---------------------------------------------------------------------------------- */

/* Arrays of the mesh on rank 0; room for them elsewhere. */
static fmb_status share_arrays(const uint64_t head[4], fmb_mesh **m)
{
    size_t points = 3 * (size_t)head[2], corners = (size_t)(head[1] * head[3]);
    double *point = app_need(malloc((points + 1) * sizeof *point));
    uint32_t *corner = app_need(malloc((corners + 1) * sizeof *corner));
    if (app_rank() == 0) {
        memcpy(point, fmb_mesh_points(*m), points * sizeof *point);
        memcpy(corner, fmb_mesh_indices(*m), corners * sizeof *corner);
    }
    app_ranks_share(point, points * sizeof *point);
    app_ranks_share(corner, corners * sizeof *corner);
    fmb_status st = FMB_OK;
    if (app_rank() > 0)
        st = fmb_mesh_new((int)head[1], (size_t)head[2], point, (size_t)head[3], corner, NULL, m);
    free(point);
    free(corner);
    return st;
}

int mesh_share(int code, fmb_mesh **m)
{
    if (app_ranks() == 1)
        return code;
    uint64_t head[4] = {(uint64_t)code, (uint64_t)fmb_mesh_corners(*m), fmb_mesh_vertices(*m),
                        fmb_mesh_cells(*m)};
    app_ranks_share(head, sizeof head);
    if (head[0] != APP_YES || head[3] == 0)
        return (int)head[0];
    fmb_status st = share_arrays(head, m);
    return st == FMB_OK ? APP_YES : app_ranks_fail(app_status_error(st));
}

/* ---- rows of pairs --------------------------------------------------------------------------- */

/* Progress within the current rows, as a share of all. */
typedef struct rows_progress {
    const fmb_mesh_options *of_all;
    double before, share;
} rows_progress;

static bool tell_progress_of_rows(void *self, double done)
{
    const rows_progress *p = self;
    return p->of_all->progress(p->of_all->self, p->before + done * p->share);
}

/* Many portions for each rank, none of them longer than some seconds. */
static uint64_t rows_of_portion(const fmb_mesh *a, const fmb_mesh *b)
{
    enum { PORTIONS = 16, MOST_PAIRS = 1 << 26 };
    uint64_t rows = fmb_mesh_cells(a) / ((uint64_t)app_ranks() * PORTIONS),
             most = MOST_PAIRS / (fmb_mesh_cells(b) + 1);
    rows = rows < most ? rows : most;
    return rows > 0 ? rows : 1;
}

static void append_answer(const fmb_mesh_answer *more, fmb_mesh_answer *all)
{
    size_t hits = all->hits + more->hits;
    if (hits > all->capacity) {
        all->capacity = 2 * hits;
        all->hit = app_need(realloc(all->hit, all->capacity * sizeof *all->hit));
    }
    if (more->hits > 0)
        memcpy(all->hit + all->hits, more->hit, more->hits * sizeof *all->hit);
    all->hits = hits;
    all->tested += more->tested;
    all->framed += more->framed;
    all->stop = more->stop;
}

/* The memory limit of this rank minus the hits found so far. */
static size_t room_for_hits(const fmb_mesh_options *how, const fmb_mesh_answer *all)
{
    size_t limit = how->max_bytes / (size_t)app_ranks(), used = all->capacity * sizeof *all->hit;
    return how->max_bytes == 0 ? 0 : limit > used ? limit - used : 1;
}

/* The remaining time for all rows; never 0, which would mean no limit. */
static double seconds_left(const fmb_mesh_options *how, double began)
{
    double left = how->max_seconds - (fmb_monotonic_seconds() - began);
    return how->max_seconds == 0 ? 0 : left > 0 ? left : DBL_MIN;
}

static fmb_status ask_rows_of_this_rank(const fmb_mesh *a, const fmb_mesh *b,
                                        const fmb_mesh_options *how, fmb_mesh_answer *all)
{
    uint64_t cells = fmb_mesh_cells(a), rows = rows_of_portion(a, b ? b : a), from;
    double began = fmb_monotonic_seconds();
    fmb_status st = FMB_OK;
    while (st == FMB_OK && all->stop == FMB_STOP_DONE && (from = app_ranks_take(0, rows)) < cells) {
        uint64_t to = cells - from < rows ? cells : from + rows;
        rows_progress p = {how, (double)from / (double)cells, (double)(to - from) / (double)cells};
        fmb_mesh_options o = *how;
        fmb_mesh_answer part = {.size = sizeof part};
        o.max_seconds = seconds_left(how, began);
        o.max_bytes = room_for_hits(how, all);
        o.progress = tell_progress_of_rows;
        o.self = &p;
        st = fmb_mesh_meet_pairs(a, (size_t)from, (size_t)to, b, &o, &part);
        if (st == FMB_OK)
            append_answer(&part, all);
        fmb_mesh_answer_clear(&part);
    }
    return st;
}

/* ---- the answer of all ----------------------------------------------------------------------- */

static int compare_hits(const void *x, const void *y)
{
    const fmb_mesh_hit *p = x, *q = y;
    return p->a != q->a ? (p->a > q->a) - (p->a < q->a) : (p->b > q->b) - (p->b < q->b);
}

/* Join the answers of all ranks on rank 0. */
static void join_answers(fmb_mesh_answer *all)
{
    uint64_t sum[5] = {all->tested, all->framed, all->stop == FMB_STOP_CANCELLED,
                       all->stop == FMB_STOP_TIME, all->stop == FMB_STOP_BYTES};
    size_t bytes;
    app_ranks_sum(sum, 5);
    fmb_mesh_hit *hit = app_ranks_gather(all->hit, all->hits * sizeof *hit, &bytes);
    free(all->hit);
    *all = (fmb_mesh_answer){.size = sizeof(fmb_mesh_answer),
                             .hits = bytes / sizeof *hit,
                             .hit = hit,
                             .tested = sum[0],
                             .framed = sum[1],
                             .stop = sum[2]   ? FMB_STOP_CANCELLED
                                     : sum[3] ? FMB_STOP_TIME
                                     : sum[4] ? FMB_STOP_BYTES
                                              : FMB_STOP_DONE};
    if (hit)
        qsort(hit, all->hits, sizeof *hit, compare_hits);
}

fmb_status mesh_meet_pairs(const fmb_mesh *a, const fmb_mesh *b, const fmb_mesh_options *how,
                           fmb_mesh_answer *out)
{
    fmb_status st = ask_rows_of_this_rank(a, b, how, out);
    if (st == FMB_OK)
        join_answers(out);
    return st;
}
