/* ray_shooting.c: see ray_shooting.h.
 *
 * One thread tests all rows, and each test uses all vertices found before. Several threads take
 * groups of a fixed size, each with its own vertices, so that results depend neither on the number
 * of threads nor on their speed: rows of a group are neighbours, and so are the vertices around
 * them. Results are noted, and reported in order afterwards. Parallel rows but one are removed
 * first: otherwise each of two in different groups might be removed because of the other.
 */
#include "lp/redundancy/ray_shooting/ray_shooting.h"

#include <string.h>

#include "lp/redundancy/parallel_rows.h"
#include "lp/redundancy/ray_shooting/ray_sorter.h"
#include "num/rationals.h"
#include "trace/team.h"

enum { GROUP = 1024 };

#define MOST_WORK 2e8

bool fmb_ray_shooting_is_affordable(size_t n, size_t m)
{
    return (double)n * (double)n * (double)m <= MOST_WORK;
}

fmb_status fmb_ray_shooting_open(fmb_ray_shooting *s, fmb_run *run, size_t n, size_t m,
                                 const fmb_lp_row *row, bool *inner)
{
    *s = (fmb_ray_shooting){.run = run};
    return fmb_polar_points_open(&s->points, run, n, m, row, inner);
}

void fmb_ray_shooting_close(fmb_ray_shooting *s)
{
    if (s->run)
        fmb_polar_points_clear(&s->points);
    s->run = NULL;
}

static fmb_status sort_rows(const fmb_ray_shooting *s, fmb_run *run, fmb_fate *fate,
                            const fmb_verdicts *told, size_t from, size_t to)
{
    fmb_ray_sorter sorter;
    fmb_status st = fmb_ray_sorter_init(&sorter, run, &s->points, fate, told);
    FMB_THEN(st, fmb_ray_sorter_sort(&sorter, from, to));
    fmb_ray_sorter_clear(&sorter);
    return st;
}

/* ---- results for rows, noted to be reported later -------------------------------------------- */

typedef struct logged_result {
    size_t row;
    bool kept;
    fmb_weights weights; /* the proof of a row that is redundant, */
    mpq_t *x;            /* [n] or the point of one that is not; unless not wanted */
} logged_result;

typedef struct result_log {
    fmb_mem *mem;
    size_t n;
    logged_result *item; /* [count] */
    size_t count, room;
    fmb_verdicts listener; /* notes results with their proofs */
} result_log;

/* Note the fate of a row, without a proof. Errors: MEMORY, LIMIT. */
static fmb_status result_log_note(result_log *f, size_t row, fmb_fate fate)
{
    FMB_TRY(FMB_RESERVE(f->mem, &f->item, &f->room, f->count + 1));
    f->item[f->count++] = (logged_result){.row = row, .kept = fate == FMB_FATE_KEPT};
    return FMB_OK;
}

static fmb_status note_redundant_row(void *self, size_t i, const fmb_weights *w)
{
    result_log *f = self;
    FMB_TRY(result_log_note(f, i, FMB_FATE_REDUNDANT));
    for (size_t k = 0; k < w->size; k++)
        FMB_TRY(fmb_weights_add(&f->item[f->count - 1].weights, w->index[k], w->value[k], f->mem));
    return FMB_OK;
}

static fmb_status note_irredundant_row(void *self, size_t i, mpq_t *x)
{
    result_log *f = self;
    FMB_TRY(result_log_note(f, i, FMB_FATE_KEPT));
    FMB_TRY(fmb_rationals_new(&f->item[f->count - 1].x, f->n, f->mem));
    for (size_t j = 0; j < f->n; j++)
        mpq_set(f->item[f->count - 1].x[j], x[j]);
    return FMB_OK;
}

/* An empty log. f must not move. */
static void result_log_begin(result_log *f, fmb_mem *mem, size_t n)
{
    *f = (result_log){.mem = mem, .n = n};
    f->listener = (fmb_verdicts){
        .redundant = note_redundant_row, .irredundant = note_irredundant_row, .self = f};
}

static void result_log_end(result_log *f)
{
    for (size_t k = 0; k < f->count; k++) {
        fmb_weights_clear(&f->item[k].weights, f->mem);
        fmb_rationals_free(f->item[k].x, f->n, f->mem);
    }
    if (f->mem)
        fmb_mem_put(f->mem, f->item, f->room, sizeof *f->item);
}

/* Set fate[m] for the noted rows that are UNKNOWN there, and report these; told may be NULL.
 * Errors: those of told. */
static fmb_status result_log_tell(result_log *f, fmb_fate *fate, const fmb_verdicts *told)
{
    for (size_t k = 0; k < f->count; k++) {
        logged_result *it = &f->item[k];
        if (fate[it->row] != FMB_FATE_UNKNOWN)
            continue;
        fate[it->row] = it->kept ? FMB_FATE_KEPT : FMB_FATE_REDUNDANT;
        if (told && it->kept && told->irredundant)
            FMB_TRY(told->irredundant(told->self, it->row, it->x));
        else if (told && !it->kept && told->redundant)
            FMB_TRY(told->redundant(told->self, it->row, &it->weights));
    }
    return FMB_OK;
}

/* ---- together -------------------------------------------------------------------------------- */

typedef struct sort_job {
    const fmb_ray_shooting *s;
    result_log *found; /* [groups] */
} sort_job;

/* Sort a group with a copy of the fates. */
static fmb_status sort_group(void *self, size_t number, fmb_run *run)
{
    const sort_job *all = self;
    const fmb_ray_shooting *s = all->s;
    result_log *found = &all->found[number];
    size_t m = s->points.m, from = number * GROUP, to = from + GROUP < m ? from + GROUP : m;
    fmb_fate *fate = fmb_mem_get(run->mem, m, sizeof *fate);
    const fmb_verdicts *told = s->told ? &found->listener : NULL;
    result_log_begin(found, run->mem, s->points.n);
    if (!fate)
        return fmb_mem_status(run->mem);
    memcpy(fate, s->fate, m * sizeof *fate);
    fmb_status st = sort_rows(s, run, fate, told, from, to);
    for (size_t i = 0; (st == FMB_OK || st == FMB_LIMIT) && !told && i < m; i++)
        if (fate[i] != s->fate[i])
            st = result_log_note(found, i, fate[i]) == FMB_OK ? st : FMB_ERR_MEMORY;
    fmb_mem_put(run->mem, fate, m, sizeof *fate);
    return st;
}

/* Report the results in order, then return the first error. */
static fmb_status sort_all_groups(fmb_ray_shooting *s, result_log *found, size_t groups)
{
    fmb_team team;
    sort_job all = {s, found};
    fmb_status st = FMB_OK, worst = fmb_team_open(&team, s->run, groups);
    bool begun = worst == FMB_OK;
    if (begun)
        worst = fmb_team_do(&team, groups, sort_group, &all);
    for (size_t k = 0; begun && k < groups; k++) {
        FMB_THEN(st, result_log_tell(&found[k], s->fate, s->told));
        result_log_end(&found[k]);
    }
    fmb_team_close(&team);
    return st != FMB_OK ? st : worst;
}

static fmb_status sort_together(fmb_ray_shooting *s, size_t groups)
{
    fmb_mem *mem = s->run->mem;
    result_log *found;
    FMB_TRY(FMB_GET_ZERO(mem, found, groups));
    fmb_status st = sort_all_groups(s, found, groups);
    fmb_mem_put(mem, found, groups, sizeof *found);
    return st;
}

/* ---- all rows -------------------------------------------------------------------------------- */

fmb_status fmb_ray_shooting_sort(fmb_ray_shooting *s, fmb_fate *fate, const fmb_verdicts *told)
{
    const fmb_polar_points *p = &s->points;
    size_t groups = (p->m + GROUP - 1) / GROUP;
    s->fate = fate;
    s->told = told;
    FMB_TRY(fmb_drop_parallel_rows(s->run, p->n, p->m, p->row, fate, told));
    for (size_t i = 0; i < p->m; i++)
        if (fate[i] == FMB_FATE_REDUNDANT)
            fmb_polar_points_hide(&s->points, i);
    if (s->run->threads > 1 && groups > 1)
        return sort_together(s, groups);
    return sort_rows(s, s->run, fate, told, 0, p->m);
}
