/* scope.c: symbols and their meanings; see scope.h. */
#include "io/smt2/scope.h"

#include <string.h>

void fmb_smt_scope_init(fmb_smt_scope *s, fmb_mem *mem)
{
    *s = (fmb_smt_scope){.mem = mem};
}

void fmb_smt_scope_clear(fmb_smt_scope *s)
{
    fmb_mem_put(s->mem, s->symbol, s->symbol_capacity, sizeof *s->symbol);
    fmb_mem_put(s->mem, s->slot, s->slots, sizeof *s->slot);
    fmb_mem_put(s->mem, s->local, s->local_capacity, sizeof *s->local);
    fmb_mem_put(s->mem, s->given, s->given_capacity, sizeof *s->given);
}

/* FNV-1a. */
static size_t hash_symbol_text(fmb_span w)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (size_t i = 0; i < w.n; i++)
        h = (h ^ (unsigned char)w.p[i]) * 0x100000001b3u;
    return (size_t)(h ^ h >> 29);
}

/* The slot that holds the symbol, or the free slot where it would go. */
static size_t find_symbol_slot(const fmb_smt_scope *s, fmb_span w)
{
    size_t i = hash_symbol_text(w) & (s->slots - 1);
    for (; s->slot[i] > 0; i = (i + 1) & (s->slots - 1)) {
        fmb_span known = s->symbol[s->slot[i] - 1].text;
        if (known.n == w.n && memcmp(known.p, w.p, w.n) == 0)
            break;
    }
    return i;
}

static fmb_status reserve_symbol_slots(fmb_smt_scope *s)
{
    size_t slots = s->slots ? s->slots : 64;
    while (slots <= 2 * (s->symbols + 1))
        slots *= 2;
    if (slots == s->slots)
        return FMB_OK;
    size_t *slot;
    FMB_TRY(FMB_GET_ZERO(s->mem, slot, slots));
    fmb_mem_put(s->mem, s->slot, s->slots, sizeof *s->slot);
    s->slot = slot;
    s->slots = slots;
    for (size_t k = 0; k < s->symbols; k++)
        s->slot[find_symbol_slot(s, s->symbol[k].text)] = k + 1;
    return FMB_OK;
}

fmb_status fmb_smt_intern(fmb_smt_scope *s, fmb_span text, size_t *out)
{
    FMB_TRY(reserve_symbol_slots(s));
    size_t i = find_symbol_slot(s, text);
    if (s->slot[i] == 0) {
        FMB_TRY(FMB_RESERVE(s->mem, &s->symbol, &s->symbol_capacity, s->symbols + 1));
        s->symbol[s->symbols] = (fmb_smt_symbol){.text = text, .newest = FMB_SMT_NONE};
        s->slot[i] = ++s->symbols;
    }
    *out = s->slot[i] - 1;
    return FMB_OK;
}

fmb_status fmb_smt_give(fmb_smt_scope *s, size_t symbol, bool sort)
{
    FMB_TRY(FMB_RESERVE(s->mem, &s->given, &s->given_capacity, s->givens + 1));
    s->given[s->givens++] = (fmb_smt_given){symbol, sort};
    return FMB_OK;
}

void fmb_smt_take_back(fmb_smt_scope *s, size_t givens)
{
    while (s->givens > givens) {
        const fmb_smt_given *g = &s->given[--s->givens];
        if (g->sort)
            s->symbol[g->symbol].is_sort = false;
        else
            s->symbol[g->symbol].meaning = FMB_SMT_NOTHING;
    }
}

fmb_status fmb_smt_bind(fmb_smt_scope *s, size_t symbol, fmb_smt_value value)
{
    FMB_TRY(FMB_RESERVE(s->mem, &s->local, &s->local_capacity, s->locals + 1));
    s->local[s->locals] = (fmb_smt_local){symbol, s->symbol[symbol].newest, value};
    s->symbol[symbol].newest = s->locals++;
    return FMB_OK;
}

void fmb_smt_unbind(fmb_smt_scope *s, size_t locals)
{
    while (s->locals > locals) {
        const fmb_smt_local *b = &s->local[--s->locals];
        s->symbol[b->symbol].newest = b->older;
    }
}

const fmb_smt_local *fmb_smt_find_local(const fmb_smt_scope *s, size_t symbol)
{
    size_t newest = s->symbol[symbol].newest;
    return newest != FMB_SMT_NONE && newest >= s->visible ? &s->local[newest] : NULL;
}
