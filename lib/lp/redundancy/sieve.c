/* sieve.c: see sieve.h.
 *
 * One thread sifts all rows, and each test knows of all vertices found before. Several take groups
 * of a fixed size, each with vertices of its own, so that what is found does not depend on how many
 * threads there are, or on which of them was faster: rows of a group stand next to each other, and
 * so do the vertices around them. What they find is noted, and told afterwards in order.
 */
#include "lp/redundancy/sieve.h"

#include <string.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#include "lp/redundancy/findings.h"
#include "lp/redundancy/sift.h"
#include "lp/redundancy/twins.h"

enum { GROUP = 1024 };

fmb_status fmb_sieve_open(fmb_sieve *s, fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                          bool *inner)
{
    *s = (fmb_sieve){.run = run};
    return fmb_polar_open(&s->polar, run, n, m, row, inner);
}

void fmb_sieve_close(fmb_sieve *s)
{
    if (s->run)
        fmb_polar_clear(&s->polar);
    s->run = NULL;
}

static fmb_status sift_rows(const fmb_sieve *s, fmb_run *run, fmb_fate *fate,
                            const fmb_verdicts *told, size_t from, size_t to)
{
    fmb_sifter sifter;
    fmb_status st = fmb_sifter_init(&sifter, run, &s->polar, fate, told);
    if (st == FMB_OK)
        st = fmb_sift(&sifter, from, to);
    fmb_sifter_clear(&sifter);
    return st;
}

/* ---- together -------------------------------------------------------------------------------- */

typedef struct group {
    fmb_share share;
    fmb_findings found;
} group;

/* With fates of its own, which begin as they are. */
static fmb_status sift_group(const fmb_sieve *s, group *g, size_t from)
{
    size_t m = s->polar.m, to = from + GROUP < m ? from + GROUP : m;
    fmb_fate *fate = fmb_mem_get(&g->share.mem, m, sizeof *fate);
    const fmb_verdicts *told = s->told ? &g->found.listener : NULL;
    fmb_findings_begin(&g->found, &g->share.mem, s->polar.n);
    if (!fate)
        return fmb_mem_status(&g->share.mem);
    memcpy(fate, s->fate, m * sizeof *fate);
    fmb_status st = sift_rows(s, &g->share.run, fate, told, from, to);
    for (size_t i = 0; (st == FMB_OK || st == FMB_LIMIT) && !told && i < m; i++)
        if (fate[i] != s->fate[i])
            st = fmb_findings_note(&g->found, i, fate[i]) == FMB_OK ? st : FMB_ERR_MEMORY;
    fmb_mem_put(&g->share.mem, fate, m, sizeof *fate);
    return st;
}

static void sift_all_groups(const fmb_sieve *s, group *all, size_t groups, size_t threads)
{
    (void)threads;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads((int)threads)
#endif
    for (size_t k = 0; k < groups; k++)
        all[k].share.st = sift_group(s, &all[k], k * GROUP);
}

/* Tells what was found, in order, then says what went wrong first. */
static fmb_status finish_groups(fmb_sieve *s, group *all, size_t groups)
{
    fmb_status st = FMB_OK, worst = FMB_OK;
    fmb_mem *mem = s->run->mem;
    size_t peak = 0;
    for (size_t k = 0; k < groups; k++) {
        if (st == FMB_OK)
            st = fmb_findings_tell(&all[k].found, s->fate, s->told);
        if (worst == FMB_OK || (worst == FMB_LIMIT && all[k].share.st != FMB_OK))
            worst = all[k].share.st;
        fmb_findings_end(&all[k].found);
        fmb_share_end(&all[k].share, s->run, &peak);
    }
    if (mem->used + peak > mem->peak)
        mem->peak = mem->used + peak;
    return st != FMB_OK ? st : worst;
}

static fmb_status sift_together(fmb_sieve *s, size_t groups, size_t threads)
{
    fmb_mem *mem = s->run->mem;
    group *all = fmb_mem_zero(mem, groups, sizeof *all);
    if (!all)
        return fmb_mem_status(mem);
    for (size_t k = 0; k < groups; k++)
        fmb_share_begin(&all[k].share, s->run, groups);
    sift_all_groups(s, all, groups, threads < groups ? threads : groups);
    fmb_status st = finish_groups(s, all, groups);
    fmb_mem_put(mem, all, groups, sizeof *all);
    return st;
}

/* ---- all rows -------------------------------------------------------------------------------- */

fmb_status fmb_sieve_sort(fmb_sieve *s, size_t threads, fmb_fate *fate, const fmb_verdicts *told)
{
    const fmb_polar *p = &s->polar;
    size_t groups = (p->m + GROUP - 1) / GROUP;
    s->fate = fate;
    s->told = told;
    fmb_status st = fmb_drop_twins(s->run, p->n, p->m, p->row, fate, told);
    if (st != FMB_OK)
        return st;
    for (size_t i = 0; i < p->m; i++)
        if (fate[i] == FMB_FATE_REDUNDANT)
            fmb_polar_hide(&s->polar, i);
    if (threads > 1 && groups > 1)
        return sift_together(s, groups, threads);
    return sift_rows(s, s->run, fate, told, 0, p->m);
}
