/* filter.c: vectorized tests of the histories of pairs; see filter.h. */
#include "elim/history/filter.h"

#include <string.h>

#include "elim/history/history.h"

void fmb_filter_new_round(fmb_filter *f)
{
    f->uppers.ready = f->rows.ready = false;
}

void fmb_filter_forget(fmb_filter *f)
{
    fmb_filter_new_round(f);
    f->silents = 0;
}

static void clear_layout(fmb_layout *l, fmb_mem *mem)
{
    fmb_mem_put(mem, l->bits, l->capacity, sizeof *l->bits);
    *l = (fmb_layout){0};
}

void fmb_filter_clear(fmb_filter *f, fmb_mem *mem)
{
    clear_layout(&f->uppers, mem);
    clear_layout(&f->rows, mem);
    fmb_mem_put(mem, f->drop, f->drop_capacity, sizeof *f->drop);
    f->drop = NULL;
    f->drop_capacity = 0;
}

uint64_t *fmb_filter_bits(fmb_filter *f, size_t uppers, fmb_mem *mem)
{
    size_t words = fmb_set_words(uppers);
    if (FMB_RESERVE(mem, &f->drop, &f->drop_capacity, words) != FMB_OK)
        return NULL;
    memset(f->drop, 0, words * sizeof *f->drop);
    return f->drop;
}

fmb_status fmb_filter_keep_silent(fmb_elim *e, bool *kept)
{
    fmb_filter *f = e->filter;
    const uint64_t *history = e->row[e->rows].history;
    *kept = f->wants_silent && history;
    if (!*kept)
        return FMB_OK;
    FMB_TRY(FMB_ARENA_RESERVE(e->arena, &f->silent, &f->silent_capacity, f->silents + 1));
    f->silent[f->silents++] = history;
    return FMB_OK;
}

/* ---- planes ---------------------------------------------------------------------------------- */

/* Memory for count sets. */
static fmb_status open_layout(fmb_layout *l, size_t words, size_t count, fmb_mem *mem)
{
    size_t stride = (count + 7) / 8 * 8;
    FMB_TRY(FMB_RESERVE(mem, &l->bits, &l->capacity, words * stride));
    for (size_t k = 0; k < words; k++)
        memset(&l->bits[k * stride + count], 0, (stride - count) * sizeof *l->bits);
    l->planes = (fmb_planes){l->bits, stride, words, count};
    l->ready = true;
    return FMB_OK;
}

static void lay_out_history(fmb_layout *l, size_t j, const uint64_t *history)
{
    for (size_t k = 0; k < l->planes.words; k++)
        l->bits[k * l->planes.stride + j] = history[k];
}

static fmb_status lay_out_uppers(fmb_elim *e, const uint32_t *upper, size_t uppers)
{
    fmb_layout *l = &e->filter->uppers;
    if (l->ready)
        return FMB_OK;
    FMB_TRY(open_layout(l, e->words, uppers, e->run->mem));
    for (size_t j = 0; j < uppers; j++)
        lay_out_history(l, j, e->row[upper[j]].history);
    return FMB_OK;
}

static fmb_status lay_out_live_rows(fmb_elim *e)
{
    fmb_filter *f = e->filter;
    size_t live = e->live.size;
    f->wants_silent = true;
    if (f->rows.ready)
        return FMB_OK;
    FMB_TRY(open_layout(&f->rows, e->words, live + f->silents, e->run->mem));
    for (size_t j = 0; j < f->silents; j++)
        lay_out_history(&f->rows, j, f->silent[j]);
    for (size_t j = 0; j < live; j++)
        lay_out_history(&f->rows, f->silents + j, e->row[e->live.row[j]].history);
    return FMB_OK;
}

/* ---- tests ----------------------------------------------------------------------------------- */

fmb_status fmb_filter_drop_larger(fmb_elim *e, uint32_t row, const uint32_t *upper, size_t uppers,
                                  int most, uint64_t *drop)
{
    fmb_status st = lay_out_uppers(e, upper, uppers);
    fmb_run_count(e->run, 50 + e->words * uppers / 4);
    if (st == FMB_OK)
        e->run->kernels->larger(&e->filter->uppers.planes, e->row[row].history, most, drop);
    return st;
}

/* Two subsets of the union are the histories of the pair itself; a third one covers the pair. */
fmb_status fmb_filter_drop_covered(fmb_elim *e, uint32_t row, const uint32_t *upper, size_t uppers,
                                   uint64_t *drop)
{
    fmb_status st = lay_out_live_rows(e);
    if (st != FMB_OK)
        return st;
    uint64_t *u = fmb_history_get(e);
    const uint64_t *a = e->row[row].history;
    if (!u)
        return fmb_mem_status(e->arena->mem);
    for (size_t j = 0; st == FMB_OK && j < uppers; j++) {
        uint64_t bit = (uint64_t)1 << (j % 64);
        if (drop[j / 64] & bit)
            continue;
        const uint64_t *b = e->row[upper[j]].history;
        for (size_t k = 0; k < e->words; k++)
            u[k] = a[k] | b[k];
        fmb_run_count(e->run, 50 + e->words * e->filter->rows.planes.count / 8);
        if (e->run->kernels->inside(&e->filter->rows.planes, u, 3) >= 3)
            drop[j / 64] |= bit;
        st = fmb_run_poll(e->run);
    }
    e->spare_history = u;
    return st;
}
