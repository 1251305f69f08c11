/* duplicate.c: of rows that are equal (they are primitive, so equal up to positive scaling is
 * equal) one stays.
 *
 * A strict row implies its copy that is not strict, so a strict one stays if there is one.
 * Equalities are left alone.
 */
#include "rule/rule.h"

/* A table of live rows by hash, at most half full. */
typedef struct table {
    size_t *slot; /* row + 1, 0 = free */
    size_t size;  /* a power of two */
} table;

/* The slot of a row equal to row i, or the free slot where i belongs. */
static size_t *find(const table *t, const fmb_view *w, size_t i)
{
    size_t n = (size_t)w->n + 1, at = (size_t)fmb_vec_hash(w->row[i].v, n);
    for (;; at++) {
        size_t *s = &t->slot[at & (t->size - 1)];
        if (*s == 0 || fmb_vec_equal(w->row[*s - 1].v, w->row[i].v, n))
            return s;
    }
}

static fmb_status end_round(void *state, const fmb_view *w, fmb_mem *mem, bool *drop,
                            size_t *marked)
{
    table t = {.size = 16};
    (void)state;
    while (t.size < 2 * w->rows)
        t.size *= 2;
    t.slot = fmb_mem_zero(mem, t.size, sizeof *t.slot);
    if (!t.slot)
        return fmb_mem_status(mem);
    *marked = 0;
    for (size_t i = 0; i < w->rows; i++) {
        if (w->row[i].equality)
            continue;
        size_t *s = find(&t, w, i);
        if (*s != 0) {
            size_t other = *s - 1;
            bool keep_new = w->row[i].strict && !w->row[other].strict;
            drop[keep_new ? other : i] = true;
            ++*marked;
            if (!keep_new)
                continue;
        }
        *s = i + 1;
    }
    fmb_mem_put(mem, t.slot, t.size, sizeof *t.slot);
    return FMB_OK;
}

const fmb_rule fmb_rule_duplicate = {
    .name = "duplicate",
    .source = "Fourier1827",
    .flags = FMB_RULE_BREAKS_HISTORY,
    .end_round = end_round,
};
