/* view.c: the window through which rules see an elimination; see <fmb/rule.h>. */
#include "elim/rules/view.h"

#include <fmb/gmp.h>
#include <string.h>

#include "elim/history/filter.h"
#include "elim/history/history.h"
#include "elim/rules/box_rule.h"
#include "num/rationals.h"

struct fmb_scratch {
    struct fmb_scratch *next;
    size_t bytes; /* this header included */
    _Alignas(16) unsigned char at[];
};

void fmb_window_open(fmb_window *w, fmb_elim *e, const fmb_rule *rule, int var)
{
    *w = (fmb_window){.view = {.e = e, .rule = rule, .var = var}};
    w->view.scratch = &w->blocks;
    w->view.status = &w->failed;
}

fmb_status fmb_window_close(fmb_window *w)
{
    while (w->blocks) {
        fmb_scratch *s = w->blocks;
        w->blocks = s->next;
        fmb_mem_put(w->view.e->run->mem, s, s->bytes, 1);
    }
    return w->failed;
}

/* Note the first failure inside an accessor; it is returned when the window closes. */
static void note_failure(const fmb_view *w, fmb_status st)
{
    if (*w->status == FMB_OK)
        *w->status = st;
}

void *fmb_view_scratch(const fmb_view *w, size_t bytes)
{
    size_t all = bytes + sizeof(fmb_scratch);
    if (!w)
        return NULL;
    fmb_mem *mem = w->e->run->mem;
    fmb_scratch *s = all > bytes ? fmb_mem_get(mem, all, 1) : NULL;
    if (!s) {
        note_failure(w, all > bytes ? fmb_mem_status(mem) : FMB_ERR_MEMORY);
        return NULL;
    }
    *s = (fmb_scratch){.next = *w->scratch, .bytes = all};
    *w->scratch = s;
    return s->at;
}

bool fmb_view_stop(const fmb_view *w)
{
    if (!w)
        return true;
    fmb_status st = fmb_run_poll(w->e->run);
    note_failure(w, st);
    return st != FMB_OK;
}

const fmb_rule *fmb_view_rule(const fmb_view *w)
{
    return w ? w->rule : NULL;
}

int fmb_view_dim(const fmb_view *w)
{
    return w ? w->e->n : 0;
}

int fmb_view_variable(const fmb_view *w, int col)
{
    return !w ? -1 : w->e->run->var_of ? w->e->run->var_of[col] : col;
}

int fmb_view_column(const fmb_view *w)
{
    return w ? w->var : -1;
}

size_t fmb_view_rows(const fmb_view *w)
{
    return w ? w->e->live.size : 0;
}

size_t fmb_view_row(const fmb_view *w, size_t i)
{
    return w ? w->e->live.row[i] : 0;
}

int fmb_view_eliminated(const fmb_view *w)
{
    return w ? w->e->since : 0;
}

size_t fmb_view_lowers(const fmb_view *w)
{
    return w ? w->lowers : 0;
}

size_t fmb_view_uppers(const fmb_view *w)
{
    return w ? w->uppers : 0;
}

size_t fmb_view_lower(const fmb_view *w, size_t i)
{
    return w ? w->lower[i] : 0;
}

size_t fmb_view_upper(const fmb_view *w, size_t j)
{
    return w ? w->upper[j] : 0;
}

fmb_rel fmb_view_rel(const fmb_view *w, size_t row)
{
    return w ? fmb_derived_rel(&w->e->row[row]) : FMB_LE;
}

int fmb_view_sign(const fmb_view *w, size_t row, int col)
{
    return w ? fmb_vec_sgn(&w->e->row[row].v, (size_t)col) : 0;
}

const int64_t *fmb_view_int64(const fmb_view *w, size_t row)
{
    const fmb_vec *v = w ? &w->e->row[row].v : NULL;
    return !v || fmb_vec_is_wide(v) ? NULL : v->s;
}

void fmb_view_get(const fmb_view *w, size_t row, int col, mpz_t out)
{
    if (w && out)
        fmb_vec_get(&w->e->row[row].v, (size_t)col, out);
    else if (out)
        mpz_set_ui(out, 0);
}

size_t fmb_view_text(const fmb_view *w, size_t row, int col, char *text, size_t size)
{
    mpq_t q;
    if (!w)
        return fmb_rational_print(NULL, text, size);
    mpq_init(q);
    fmb_view_get(w, row, col, mpq_numref(q));
    size_t length = fmb_rational_print(q, text, size);
    mpq_clear(q);
    return length;
}

/* ---- histories ------------------------------------------------------------------------------- */

const uint64_t *fmb_view_history(const fmb_view *w, size_t row, size_t *words)
{
    if (words)
        *words = w ? w->e->words : 0;
    return w && w->e->histories && w->e->based ? w->e->row[row].history : NULL;
}

const uint64_t *fmb_view_effective(const fmb_view *w, size_t row, size_t *words)
{
    size_t before;
    const uint64_t *h = fmb_view_history(w, row, &before);
    if (words)
        *words = w ? w->e->var_words : 0;
    return h ? h + before : NULL;
}

void fmb_view_implicit(const fmb_view *w, size_t row, uint64_t *out)
{
    size_t words;
    if (!w || !out)
        return;
    if (fmb_view_history(w, row, &words))
        fmb_history_implicit(w->e, &w->e->row[row], out);
    else
        memset(out, 0, w->e->var_words * sizeof *out);
}

const uint64_t *fmb_view_gone(const fmb_view *w)
{
    return w ? w->e->gone : NULL;
}

size_t fmb_view_bases(const fmb_view *w)
{
    return w ? w->e->bases : 0;
}

int fmb_view_base_sign(const fmb_view *w, size_t base, int col)
{
    return w ? fmb_view_sign(w, w->e->base[base], col) : 0;
}

void fmb_view_base_get(const fmb_view *w, size_t base, int col, mpz_t out)
{
    fmb_view_get(w, w ? w->e->base[base] : 0, col, out);
}

bool fmb_view_minimal(const fmb_view *w, size_t row)
{
    bool minimal = true;
    size_t words;
    if (!fmb_view_history(w, row, &words))
        return true;
    note_failure(w, fmb_elim_minimal(w->e, &w->e->row[row], &minimal));
    return minimal;
}

void fmb_view_drop_larger(const fmb_view *w, size_t i, int most, uint64_t *drop)
{
    if (w && drop && w->e->histories)
        note_failure(w, fmb_filter_drop_larger(w->e, w->lower[i], w->upper, w->uppers, most, drop));
}

void fmb_view_drop_covered(const fmb_view *w, size_t i, uint64_t *drop)
{
    if (w && drop && w->e->histories)
        note_failure(w, fmb_filter_drop_covered(w->e, w->lower[i], w->upper, w->uppers, drop));
}

int fmb_view_slack(const fmb_view *w, size_t row)
{
    return w ? fmb_box_slack(w->e, &w->e->row[row]) : -1;
}
