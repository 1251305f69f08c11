/* history.c: sets of base rows and of variables; see history.h. */
#include "elim/history/history.h"

#include <string.h>

uint64_t *fmb_history_get(fmb_elim *e)
{
    uint64_t *h = e->spare_history;
    e->spare_history = NULL;
    return h ? h : fmb_arena_get(e->arena, e->words + e->var_words, sizeof *h);
}

fmb_status fmb_history_number_base(fmb_elim *e)
{
    e->words = fmb_set_words(e->bases);
    e->spare_history = NULL; /* its size is no longer right */
    size_t size = e->words + e->var_words;
    uint64_t *h;
    FMB_TRY(FMB_ARENA_GET(e->arena, h, e->bases * size));
    memset(h, 0, e->bases * size * sizeof *h);
    for (size_t i = 0; i < e->bases; i++, h += size) {
        fmb_set_put(h, i);
        e->row[e->base[i]].history = h;
        FMB_TRY(fmb_run_poll(e->run));
    }
    return FMB_OK;
}

fmb_status fmb_history_join(fmb_elim *e, fmb_derived *r, const fmb_derived *p, const fmb_derived *q)
{
    if (!e->histories || !e->based)
        return FMB_OK;
    r->history = fmb_history_get(e);
    if (!r->history)
        return fmb_mem_status(e->arena->mem);
    size_t size = e->words + e->var_words;
    for (size_t i = 0; i < size; i++)
        r->history[i] = p->history[i] | q->history[i];
    fmb_set_put(r->history + e->words, (size_t)r->var);
    return FMB_OK;
}

/* Imbert's I is computed anew from the base rows: the union of the parents' I is wrong, since a
 * variable that vanished by chance can come back. */
void fmb_history_implicit(const fmb_elim *e, const fmb_derived *r, uint64_t *out)
{
    memset(out, 0, e->var_words * sizeof *out);
    for (size_t w = 0; w < e->words; w++)
        for (uint64_t left = r->history[w]; left != 0; left &= left - 1) {
            const uint64_t *names = e->row[e->base[w * 64 + (size_t)__builtin_ctzll(left)]].names;
            for (size_t k = 0; k < e->var_words; k++)
                out[k] |= names[k];
        }
    for (size_t w = 0; w < e->var_words; w++)
        out[w] &= ~(r->names[w] | r->history[e->words + w]);
}
