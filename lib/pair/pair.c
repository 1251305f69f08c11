/* pair.c: see fmb/pair.h; how answers are found: ladder.h. */
#include <fmb/pair.h>

#include <stdio.h>

#include "pair/ladder.h"

/* ---- life ------------------------------------------------------------------------------------ */

fmb_pair_options fmb_pair_options_default(void)
{
    return (fmb_pair_options){.max_bytes = (size_t)1 << 30};
}

static bool are_options(const fmb_pair_options *o)
{
    return (unsigned)o->contact <= FMB_CONTACT_OPEN && (unsigned)o->method <= FMB_PAIR_EXACT &&
           o->max_seconds >= 0 && fmb_pair_kernels_choose(o->simd);
}

fmb_status fmb_pair_new(int dim, const fmb_pair_options *o, const fmb_alloc *hook, fmb_pair **out)
{
    fmb_pair_options usual = fmb_pair_options_default();
    fmb_mem mem;
    o = o ? o : &usual;
    if (!out || dim < 1 || dim > FMB_FRAME_MOST_DIM || !are_options(o))
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, hook, 0);
    fmb_pair *k = fmb_mem_zero(&mem, 1, sizeof *k);
    if (!k)
        return fmb_mem_status(&mem);
    k->mem = mem;
    k->options = *o;
    k->dim = dim;
    fmb_pair_use_kernels(k, &fmb_pair_kernels_narrow, fmb_pair_kernels_choose(o->simd));
    k->general = fmb_general_new(dim, o->simd, &k->mem);
    fmb_status st = k->general ? fmb_pair_oracle_open(&k->oracle, o, hook) : FMB_ERR_MEMORY;
    if (st == FMB_OK)
        *out = k;
    else
        fmb_pair_free(k);
    return st;
}

void fmb_pair_free(fmb_pair *k)
{
    if (!k)
        return;
    fmb_pair_oracle_close(&k->oracle);
    fmb_general_free(k->general, &k->mem);
    fmb_mem mem = k->mem;
    fmb_mem_put(&mem, k, 1, sizeof *k);
}

void fmb_pair_use_kernels(fmb_pair *k, const fmb_pair_kernels *one, const fmb_pair_kernels *wide)
{
    k->one = one;
    k->wide = wide;
}

fmb_pair_counts fmb_pair_count(const fmb_pair *k)
{
    return k ? k->counts : (fmb_pair_counts){0};
}

const char *fmb_pair_trouble(const fmb_pair *k)
{
    return k ? k->trouble : "";
}

void fmb_pair_cancel(fmb_pair *k)
{
    if (k)
        atomic_store(&k->oracle.cancel, 1);
}

/* The argument that is missing, or NULL. */
static const char *find_missing(size_t n, const fmb_frame *p, const fmb_frame *q,
                                const fmb_pair_answers *out)
{
    if (!out)
        return "out";
    if (n == 0)
        return NULL;
    return !p ? "p" : !q ? "q" : !out->verdict ? "out->verdict" : NULL;
}

fmb_status fmb_pair_test(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                         const fmb_pair_answers *out)
{
    if (!k)
        return FMB_ERR_ARG;
    const char *missing = find_missing(n, p, q, out);
    k->trouble[0] = '\0';
    if (missing) {
        snprintf(k->trouble, sizeof k->trouble, "%s is NULL", missing);
        return FMB_ERR_ARG;
    }
    atomic_store_explicit(&k->oracle.cancel, 0, memory_order_relaxed);
    k->counts.pairs += n;
    return fmb_pair_answer_all(k, n, p, q, out);
}
