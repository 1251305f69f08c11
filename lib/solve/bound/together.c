/* together.c: ends of variables, by several threads; see ends.h.
 *
 * Variables come in groups of a fixed size, each with a fresh oracle of its own, so the result does
 * not depend on the number of threads, nor on which of them was faster. Claims are made afterwards,
 * in order, by the calling thread.
 */
#include "solve/bound/ends.h"
#include "trace/team.h"

enum { GROUP = 16 };

/* One group of variables. */
typedef struct group {
    fmb_mem *mem; /* of its share */
    int first, count;
    fmb_found_end end[GROUP][2];
    int ready; /* ends initialised */
} group;

typedef struct shared_search {
    fmb_query *q;
    const fmb_part *p;
    const fmb_program *program;
    const fmb_box *box;
    const int *place;
    group *group;
    int groups;
} shared_search;

static fmb_status find_ends_of_group(void *self, size_t number, fmb_run *run)
{
    shared_search *t = self;
    group *g = &t->group[number];
    fmb_oracle *o = NULL;
    bool feasible;
    g->mem = run->mem;
    fmb_status st = fmb_oracle_new(run, t->program, &o);
    FMB_THEN(st, fmb_oracle_feasible(o, &feasible));
    for (int k = 0; st == FMB_OK && k < 2 * g->count; k++) {
        int var = t->box->var[t->place[g->first + k / 2]];
        fmb_found_end *f = &g->end[k / 2][k % 2];
        st = fmb_found_end_init(f, (size_t)t->p->n, t->q->claims != NULL, g->mem);
        g->ready++;
        FMB_THEN(st,
                 fmb_find_end(o, t->q->parts.place[var], k % 2 == FMB_LOWER ? -1 : 1, g->mem, f));
    }
    fmb_oracle_free(o);
    return st;
}

static fmb_status note_ends_of_group(shared_search *t, group *g, fmb_box *box)
{
    for (int k = 0; k < g->ready; k++) {
        int place = t->place[g->first + k / 2], side = k % 2;
        fmb_bound_job j = {.q = t->q,
                           .p = t->p,
                           .var = box->var[place],
                           .column = t->q->parts.place[box->var[place]],
                           .side = (fmb_side)side,
                           .sign = side == FMB_LOWER ? -1 : 1,
                           .end = &box->side[place][side]};
        if (g->end[k / 2][side].known)
            FMB_TRY(fmb_note_end(&j, &g->end[k / 2][side]));
    }
    return FMB_OK;
}

static void close_group(shared_search *t, group *g)
{
    for (int k = 0; k < g->ready; k++)
        fmb_found_end_clear(&g->end[k / 2][k % 2], (size_t)t->p->n, g->mem);
}

/* Note the ends that were found, then return the first error. */
static fmb_status find_and_note_all_ends(shared_search *t, fmb_box *box)
{
    fmb_team team;
    fmb_status st = FMB_OK, worst = fmb_team_open(&team, &t->q->run, (size_t)t->groups);
    if (worst == FMB_OK)
        worst = fmb_team_do(&team, (size_t)t->groups, find_ends_of_group, t);
    for (int k = 0; k < t->groups; k++) {
        FMB_THEN(st, note_ends_of_group(t, &t->group[k], box));
        close_group(t, &t->group[k]);
    }
    fmb_team_close(&team);
    return st != FMB_OK ? st : worst;
}

fmb_status fmb_find_ends_together(fmb_query *q, int part, fmb_box *box, const int *place, int count)
{
    fmb_oracle *o; /* made, for its program */
    FMB_TRY(fmb_query_feasible_oracle(q, part, &o));
    shared_search t = {.q = q,
                       .p = &q->parts.part[part],
                       .program = &q->program[part],
                       .box = box,
                       .place = place,
                       .groups = (count + GROUP - 1) / GROUP};
    FMB_TRY(FMB_GET_ZERO(q->run.mem, t.group, (size_t)t.groups));
    for (int k = 0; k < t.groups; k++) {
        int first = k * GROUP;
        t.group[k].first = first;
        t.group[k].count = count - first < GROUP ? count - first : GROUP;
    }
    fmb_status st = find_and_note_all_ends(&t, box);
    fmb_mem_put(q->run.mem, t.group, (size_t)t.groups, sizeof *t.group);
    return st;
}
