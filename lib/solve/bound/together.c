/* together.c: ends of variables, by several threads; see ends.h.
 *
 * Variables come in groups of a fixed size, each with an oracle of its own that starts anew: so
 * what is found does not depend on how many threads there are, or on which of them was faster.
 * Claims are made afterwards, in order, by the thread that asked.
 */
#include "solve/bound/ends.h"

#ifdef _OPENMP
#include <omp.h>
#endif

enum { GROUP = 16 };

/* One group of variables, and what its thread works with. */
typedef struct group {
    fmb_share share;
    int first, count;
    fmb_found_end end[GROUP][2];
    int ready; /* ends initialised */
} group;

typedef struct team {
    fmb_query *q;
    const fmb_part *p;
    const fmb_program *program;
    const fmb_box *box;
    const int *place;
    group *group;
    int groups;
} team;

static fmb_status find_ends_of_group(team *t, group *g)
{
    fmb_oracle *o = NULL;
    bool feasible;
    fmb_status st = fmb_oracle_new(&g->share.run, t->program, &o);
    if (st == FMB_OK)
        st = fmb_oracle_feasible(o, &feasible);
    for (int k = 0; st == FMB_OK && k < 2 * g->count; k++) {
        int var = t->box->var[t->place[g->first + k / 2]];
        fmb_found_end *f = &g->end[k / 2][k % 2];
        st = fmb_found_end_init(f, (size_t)t->p->n, t->q->claims != NULL, &g->share.mem);
        g->ready++;
        if (st == FMB_OK)
            st = fmb_find_end(o, t->q->parts.place[var], k % 2 == FMB_LOWER ? -1 : 1, &g->share.mem,
                              f);
    }
    fmb_oracle_free(o);
    return st;
}

static void find_all_ends(team *t, int threads)
{
    (void)threads;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
#endif
    for (int k = 0; k < t->groups; k++)
        t->group[k].share.st = find_ends_of_group(t, &t->group[k]);
}

static fmb_status note_ends_of_group(team *t, group *g, fmb_box *box)
{
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < g->ready; k++) {
        int place = t->place[g->first + k / 2], side = k % 2;
        fmb_bound_job j = {.q = t->q,
                           .p = t->p,
                           .var = box->var[place],
                           .column = t->q->parts.place[box->var[place]],
                           .side = (fmb_side)side,
                           .sign = side == FMB_LOWER ? -1 : 1,
                           .end = &box->side[place][side]};
        if (g->end[k / 2][side].known)
            st = fmb_note_end(&j, &g->end[k / 2][side]);
    }
    return st;
}

static void close_group(team *t, group *g)
{
    for (int k = 0; k < g->ready; k++)
        fmb_found_end_clear(&g->end[k / 2][k % 2], (size_t)t->p->n, &g->share.mem);
}

/* Notes what was found, then says what went wrong first. */
static fmb_status finish_team(team *t, fmb_box *box)
{
    fmb_status st = FMB_OK, worst = FMB_OK;
    fmb_mem *mem = t->q->run.mem;
    size_t peak = 0;
    for (int k = 0; k < t->groups; k++) {
        group *g = &t->group[k];
        if (st == FMB_OK)
            st = note_ends_of_group(t, g, box);
        if (worst == FMB_OK || (worst == FMB_LIMIT && g->share.st != FMB_OK))
            worst = g->share.st;
        fmb_share_end(&g->share, &t->q->run, &peak);
        close_group(t, g);
    }
    if (mem->used + peak > mem->peak)
        mem->peak = mem->used + peak;
    return st != FMB_OK ? st : worst;
}

fmb_status fmb_find_ends_together(fmb_query *q, int part, fmb_box *box, const int *place, int count)
{
    fmb_oracle *o; /* made, for its program */
    fmb_status st = fmb_query_feasible_oracle(q, part, &o);
    if (st != FMB_OK)
        return st;
    size_t threads = q->v->options.threads;
    team t = {.q = q,
              .p = &q->parts.part[part],
              .program = &q->program[part],
              .box = box,
              .place = place,
              .groups = (count + GROUP - 1) / GROUP};
    t.group = fmb_mem_zero(q->run.mem, (size_t)t.groups, sizeof *t.group);
    if (!t.group)
        return fmb_mem_status(q->run.mem);
    threads = threads > (size_t)t.groups ? (size_t)t.groups : threads;
    for (int k = 0; k < t.groups; k++) {
        int first = k * GROUP;
        t.group[k].first = first;
        t.group[k].count = count - first < GROUP ? count - first : GROUP;
        fmb_share_begin(&t.group[k].share, &q->run, (size_t)t.groups);
    }
    find_all_ends(&t, (int)threads);
    st = finish_team(&t, box);
    fmb_mem_put(q->run.mem, t.group, (size_t)t.groups, sizeof *t.group);
    return st;
}
