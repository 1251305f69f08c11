/* ray_shooting.c: see ray_shooting.h.
 *
 * One thread sifts all rows, and each test knows of all vertices found before. Several take groups
 * of a fixed size, each with vertices of its own, so that what is found does not depend on how many
 * threads there are, or on which of them was faster: rows of a group stand next to each other, and
 * so do the vertices around them. What they find is noted, and told afterwards in order.
 */
#include "lp/redundancy/ray_shooting/ray_shooting.h"

#include <string.h>

#include "lp/redundancy/parallel_rows.h"
#include "lp/redundancy/ray_shooting/ray_sorter.h"
#include "lp/redundancy/result_log.h"
#include "trace/team.h"

enum { GROUP = 1024 };

#define MOST_WORK 2e8

bool fmb_sieve_is_affordable(size_t n, size_t m)
{
    return (double)n * (double)n * (double)m <= MOST_WORK;
}

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

typedef struct sifting {
    const fmb_sieve *s;
    fmb_findings *found; /* [groups] */
} sifting;

/* With fates of its own, which begin as they are. */
static fmb_status sift_group(void *self, size_t number, fmb_run *run)
{
    const sifting *all = self;
    const fmb_sieve *s = all->s;
    fmb_findings *found = &all->found[number];
    size_t m = s->polar.m, from = number * GROUP, to = from + GROUP < m ? from + GROUP : m;
    fmb_fate *fate = fmb_mem_get(run->mem, m, sizeof *fate);
    const fmb_verdicts *told = s->told ? &found->listener : NULL;
    fmb_findings_begin(found, run->mem, s->polar.n);
    if (!fate)
        return fmb_mem_status(run->mem);
    memcpy(fate, s->fate, m * sizeof *fate);
    fmb_status st = sift_rows(s, run, fate, told, from, to);
    for (size_t i = 0; (st == FMB_OK || st == FMB_LIMIT) && !told && i < m; i++)
        if (fate[i] != s->fate[i])
            st = fmb_findings_note(found, i, fate[i]) == FMB_OK ? st : FMB_ERR_MEMORY;
    fmb_mem_put(run->mem, fate, m, sizeof *fate);
    return st;
}

/* Tells what was found, in order, then says what went wrong first. */
static fmb_status sift_all_groups(fmb_sieve *s, fmb_findings *found, size_t groups)
{
    fmb_team team;
    sifting all = {s, found};
    fmb_status st = FMB_OK, worst = fmb_team_open(&team, s->run, groups);
    bool begun = worst == FMB_OK;
    if (begun)
        worst = fmb_team_do(&team, groups, sift_group, &all);
    for (size_t k = 0; begun && k < groups; k++) {
        if (st == FMB_OK)
            st = fmb_findings_tell(&found[k], s->fate, s->told);
        fmb_findings_end(&found[k]);
    }
    fmb_team_close(&team);
    return st != FMB_OK ? st : worst;
}

static fmb_status sift_together(fmb_sieve *s, size_t groups)
{
    fmb_mem *mem = s->run->mem;
    fmb_findings *found = fmb_mem_zero(mem, groups, sizeof *found);
    if (!found)
        return fmb_mem_status(mem);
    fmb_status st = sift_all_groups(s, found, groups);
    fmb_mem_put(mem, found, groups, sizeof *found);
    return st;
}

/* ---- all rows -------------------------------------------------------------------------------- */

fmb_status fmb_sieve_sort(fmb_sieve *s, fmb_fate *fate, const fmb_verdicts *told)
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
    if (s->run->threads > 1 && groups > 1)
        return sift_together(s, groups);
    return sift_rows(s, s->run, fate, told, 0, p->m);
}
