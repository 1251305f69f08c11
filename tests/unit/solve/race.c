/* race.c: of two concurrent lanes the one that needs less work wins, whichever thread is faster;
 * and projections by a race equal those of one thread, and are proved. */
#include <criterion/criterion.h>
#include <limits.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

#include "property/random/agree.h"
#include "solve/portfolio/race.h"
#include "study/program/projection.h"
#include "support.h"

/* ---- lanes ----------------------------------------------------------------------------------- */

/* What each lane needs, and how it ends then; how much it does at a time, and whether it lets
 * others go first. */
typedef struct needs {
    fmb_run *run[2];
    uint64_t need[2], step[2];
    fmb_status end[2];
    bool yields[2];
} needs;

static fmb_status go(needs *n, int k, bool *ready)
{
    fmb_run *run = n->run[k];
    uint64_t from = run->work;
    while (!fmb_run_is_slice_over(run)) {
        uint64_t left = n->need[k] - (run->work - from);
        fmb_run_count(run, left < n->step[k] ? left : n->step[k]);
        if (run->work - from == n->need[k]) {
            *ready = n->end[k] == FMB_OK;
            return n->end[k];
        }
        if (n->yields[k])
            sched_yield();
    }
    return FMB_OK;
}

static fmb_status go_here(void *n, bool *ready)
{
    return go(n, 0, ready);
}

static fmb_status go_there(void *n, bool *ready)
{
    return go(n, 1, ready);
}

static void draw_needs(support_rng *g, needs *n)
{
    for (int k = 0; k < 2; k++) {
        n->need[k] = (uint64_t)support_between(g, 1, 3000);
        n->step[k] = (uint64_t)support_between(g, 1, 40);
        n->end[k] = support_chance(g, 20) ? FMB_LIMIT : FMB_OK;
        n->yields[k] = support_chance(g, 30);
    }
    if (support_chance(g, 20))
        n->need[1] = n->need[0];
}

Test(race, less_work_wins)
{
    support_rng g = {17};
    atomic_int cancel = 0;
    int won[2] = {0};
    for (int i = 0; i < (1000 + WATCHED) / WATCHED; i++) {
        fmb_mem mem;
        fmb_run run;
        fmb_share share;
        fmb_options o = {.size = sizeof o, .threads = 2, .max_bytes = 1000000};
        needs n;
        size_t winner;
        fmb_mem_init(&mem, NULL, 0);
        fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
        run.work = (uint64_t)support_between(&g, 0, 99);
        fmb_share_begin(&share, &run, 1);
        fmb_mem_enter(&share.mem, &mem);
        draw_needs(&g, &n);
        n.run[0] = &run;
        n.run[1] = &share.run;
        fmb_race r = {
            .lane = {{.run = &run, .go_on = go_here}, {.run = &share.run, .go_on = go_there}},
            .self = &n};
        fmb_status st = fmb_race_run(&r, &mem, &share.mem, &winner);
        bool there = n.end[1] == FMB_OK && n.need[1] < n.need[0];
        cr_expect_eq(winner, there);
        cr_expect_eq(st, there ? FMB_OK : n.end[0]);
        cr_expect_eq(r.lane[winner].ready, st == FMB_OK);
        cr_expect_eq(r.lane[winner].spent, n.need[winner]);
        cr_expect(mem.used == 0 && mem.limit == 1000000 && share.mem.within == &mem);
        cr_expect(!run.overtaken && !share.run.overtaken);
        won[winner]++;
    }
    cr_expect(WATCHED > 1 || (won[0] > 100 && won[1] > 100));
}

/* ---- projections ----------------------------------------------------------------------------- */

typedef struct heard_race {
    int raced, queries_won;
} heard_race;

/* In a race there is no slice. */
static void hear_race(void *self, const fmb_event *e)
{
    heard_race *h = self;
    if (e->kind != FMB_EVENT_ENGINE || strcmp(e->attempt->engine, "support queries") != 0)
        return;
    h->raced += e->attempt->budget == 0;
    h->queries_won += e->attempt->budget == 0 && strcmp(e->attempt->ended, "answered") == 0;
}

/* Rows of some terms around a point. */
static fmb_system *around_point(support_rng *g, int dim, int rows, int terms, int strict)
{
    fmb_system *s = rows_none(dim);
    for (int i = 0; i < rows; i++) {
        int64_t a[16] = {0}, right = 0;
        for (int k = 0; k < terms; k++)
            a[support_between(g, 0, dim - 1)] = support_between(g, -9, 9);
        for (int j = 0; j < dim; j++)
            right += a[j] * (j % 5 - 2);
        must(fmb_system_add_int(s, a, support_chance(g, strict) ? FMB_LT : FMB_LE,
                                right + support_between(g, 1, 40)));
    }
    return s;
}

/* [give] Rows and proof as one text. */
static char *race_for(const fmb_system *s, int keep, size_t threads, heard_race *h)
{
    static const int kept[] = {0, 1, 2, 3, 4, 5, 6, 7};
    fmb_options o = {.size = sizeof o, .threads = threads, .evidence = FMB_EVIDENCE_ALL};
    fmb_solver *v = NULL;
    fmb_system *out = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    must(fmb_solver_new(&o, NULL, &v));
    *h = (heard_race){0};
    fmb_solver_set_sink(v, (fmb_sink){hear_race, h});
    must(fmb_project(v, s, kept, keep, &out, &r));
    cr_expect_eq(r.stop, FMB_STOP_DONE);
    must(fmb_system_write(out, FMB_FORMAT_TEXT, f));
    putc('\0', f);
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_expect(j.accepted, "%s", j.reason);
    must(fmb_evidence_write(e, s, f));
    fclose(f);
    fmb_evidence_free(e);
    fmb_system_free(out);
    fmb_solver_free(v);
    return text;
}

/* Whoever wins, the rows are those of one thread, and the proof is that of any other number. */
static heard_race expect_same_answers(const fmb_system *s, int keep)
{
    heard_race one, two, five;
    char *alone = race_for(s, keep, 1, &one), *by_two = race_for(s, keep, 2, &two),
         *by_five = race_for(s, keep, 5, &five);
    cr_expect_str_eq(alone, by_two);
    cr_expect_str_eq(by_two, by_five);
    cr_expect_str_eq(by_two + strlen(by_two) + 1, by_five + strlen(by_five) + 1);
    free(alone);
    free(by_two);
    free(by_five);
    return two;
}

Test(race, for_projections_at_random)
{
    support_rng g = {18};
    int raced = 0;
    for (int i = 0; i < (10 + WATCHED) / WATCHED; i++) {
        int dim = support_between(&g, 9, 12);
        fmb_system *s =
            around_point(&g, dim, 2 * dim + 2, support_between(&g, 3, 5), i % 3 == 0 ? 10 : 0);
        raced += expect_same_answers(s, dim / 2).raced;
        fmb_system_free(s);
    }
    cr_expect(WATCHED > 1 || raced > 0);
}

/* A problem on which the fitted choice of engines begins with one that does not end soon: so a race
 * starts. A new fit may need other seeds. */
static void expect_race(const char *family, uint64_t seed, int larger, int queries_win)
{
    int k = 0;
    study_projection p;
    while (strcmp(study_projection_name(k), family) != 0)
        k++;
    must(study_projection_draw_larger(k, seed, larger, &p));
    heard_race h = expect_same_answers(p.s, p.keep);
    cr_expect(h.raced == 1 && h.queries_won == queries_win, "%d, %d", h.raced, h.queries_won);
    fmb_system_free(p.s);
}

Test(race, won_by_queries)
{
    expect_race("relu", 3, 2, 1);
}

Test(race, won_by_others)
{
    expect_race("union", 1, 3, 0);
}

/* ---- what ends a race ------------------------------------------------------------------------ */

/* After so many allocations one fails, or the query is cancelled. */
typedef struct ending {
    atomic_long left, held; /* held: [bytes] */
    fmb_solver *cancels;    /* NULL: the allocation fails */
} ending;

static void *resize_until(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    ending *e = self;
    void *q = NULL;
    bool now = new_bytes > 0 && atomic_fetch_sub(&e->left, 1) == 1;
    if (now && e->cancels)
        fmb_solver_cancel(e->cancels);
    if (new_bytes == 0)
        free(p);
    else if ((now && !e->cancels) || !(q = realloc(p, new_bytes)))
        return NULL;
    e->held += (long)new_bytes - (long)old_bytes;
    return q;
}

/* Returns how many allocations there were, and what the query came to. */
static long race_until(const study_projection *p, long allocations, bool cancels, size_t bytes,
                       fmb_status *st, fmb_stop *stop)
{
    enum { MOST = 16 };
    int keep[MOST];
    ending at = {.left = LONG_MAX};
    fmb_alloc hook = {resize_until, &at};
    fmb_options o = {.size = sizeof o, .threads = 2, .max_bytes = bytes};
    fmb_result r = {.size = sizeof r};
    fmb_system *out = NULL;
    fmb_solver *v = NULL;
    for (int i = 0; i < p->keep; i++)
        keep[i] = i;
    must(fmb_solver_new(&o, &hook, &v));
    at.cancels = cancels ? v : NULL;
    at.left = allocations;
    *st = fmb_project(v, p->s, keep, p->keep, &out, &r);
    *stop = r.stop;
    long made = allocations - at.left;
    at.cancels = NULL;
    at.left = LONG_MAX;
    cr_expect(*st == FMB_OK ? out != NULL : out == NULL);
    if (*st == FMB_OK && *stop == FMB_STOP_DONE)
        cr_expect_gt(fmb_system_rows(out), 100);
    fmb_system_free(out);
    fmb_solver_free(v);
    cr_expect_eq(at.held, 0);
    return made;
}

/* Whatever it is, all memory is given back, and the next query is none the worse. */
Test(race, ends)
{
    enum { TIMES = (24 + WATCHED) / WATCHED };
    support_rng g = {19};
    study_projection p;
    fmb_status st;
    fmb_stop stop;
    int k = 0, failed = 0, cancelled = 0, limited = 0;
    while (strcmp(study_projection_name(k), "dense") != 0)
        k++;
    must(study_projection_draw_larger(k, 4, 3, &p));
    long all = race_until(&p, LONG_MAX, false, 0, &st, &stop);
    cr_assert(st == FMB_OK && stop == FMB_STOP_DONE);
    for (int i = 0; i < TIMES; i++) {
        long at = 1 + (long)((double)all * support_between(&g, 1, 1000) / 1000);
        race_until(&p, at, false, 0, &st, &stop);
        cr_expect(st == FMB_OK || st == FMB_ERR_MEMORY, "%s", fmb_status_text(st));
        failed += st == FMB_ERR_MEMORY;
        race_until(&p, at, true, 0, &st, &stop);
        cr_expect(st == FMB_OK && (stop == FMB_STOP_DONE || stop == FMB_STOP_CANCELLED));
        cancelled += stop == FMB_STOP_CANCELLED;
        race_until(&p, LONG_MAX, false, (size_t)support_between(&g, 1, 64) << 18, &st, &stop);
        cr_expect(st == FMB_OK && (stop == FMB_STOP_DONE || stop == FMB_STOP_BYTES));
        limited += stop == FMB_STOP_BYTES;
    }
    printf("of %d: %d failed, %d cancelled, %d limited\n", TIMES, failed, cancelled, limited);
    cr_expect(WATCHED > 1 || (failed > 0 && cancelled > 0 && limited > 0));
    fmb_system_free(p.s);
}
