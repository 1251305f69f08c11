/* result_log.c: see result_log.h. */
#include "lp/redundancy/result_log.h"

#include "num/rationals.h"

fmb_status fmb_result_log_note(fmb_result_log *f, size_t row, fmb_fate fate)
{
    fmb_status st =
        fmb_mem_reserve(f->mem, (void **)&f->item, &f->room, f->count + 1, sizeof *f->item);
    if (st == FMB_OK)
        f->item[f->count++] = (fmb_logged_result){.row = row, .kept = fate == FMB_FATE_KEPT};
    return st;
}

static fmb_status note_redundant_row(void *self, size_t i, const fmb_weights *w)
{
    fmb_result_log *f = self;
    fmb_status st = fmb_result_log_note(f, i, FMB_FATE_REDUNDANT);
    for (size_t k = 0; st == FMB_OK && k < w->size; k++)
        st = fmb_weights_add(&f->item[f->count - 1].weights, w->index[k], w->value[k], f->mem);
    return st;
}

static fmb_status note_irredundant_row(void *self, size_t i, mpq_t *x)
{
    fmb_result_log *f = self;
    fmb_status st = fmb_result_log_note(f, i, FMB_FATE_KEPT);
    if (st == FMB_OK)
        st = fmb_rationals_new(&f->item[f->count - 1].x, f->n, f->mem);
    for (size_t j = 0; st == FMB_OK && j < f->n; j++)
        mpq_set(f->item[f->count - 1].x[j], x[j]);
    return st;
}

void fmb_result_log_begin(fmb_result_log *f, fmb_mem *mem, size_t n)
{
    *f = (fmb_result_log){.mem = mem, .n = n};
    f->listener = (fmb_verdicts){
        .redundant = note_redundant_row, .irredundant = note_irredundant_row, .self = f};
}

void fmb_result_log_end(fmb_result_log *f)
{
    for (size_t k = 0; k < f->count; k++) {
        fmb_weights_clear(&f->item[k].weights, f->mem);
        fmb_rationals_free(f->item[k].x, f->n, f->mem);
    }
    if (f->mem)
        fmb_mem_put(f->mem, f->item, f->room, sizeof *f->item);
}

fmb_status fmb_result_log_tell(fmb_result_log *f, fmb_fate *fate, const fmb_verdicts *told)
{
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < f->count; k++) {
        fmb_logged_result *it = &f->item[k];
        if (fate[it->row] != FMB_FATE_UNKNOWN)
            continue;
        fate[it->row] = it->kept ? FMB_FATE_KEPT : FMB_FATE_REDUNDANT;
        if (told && it->kept && told->irredundant)
            st = told->irredundant(told->self, it->row, it->x);
        else if (told && !it->kept && told->redundant)
            st = told->redundant(told->self, it->row, &it->weights);
    }
    return st;
}
