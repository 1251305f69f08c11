/* pool.c: see pool.h. */
#include "fmb-qualify/verdicts/pool.h"

#include <stdlib.h>
#include <string.h>

#include "fmb-qualify/watch.h"
#include "study/rivals/aabb.h"

const char *verdict_case_text(int dim, bool moves)
{
    static const char *const CASE[2][2] = {{"2d-static", "3d-static"},
                                           {"2d-dynamic", "3d-dynamic"}};
    return CASE[moves][dim - 2];
}

const char *verdict_kind_text(verdict_kind kind)
{
    static const char *const KIND[] = {"CC", "CT", "TT", "any"};
    return KIND[kind];
}

typedef struct chooser {
    const verdict_source *from;
    fmb_pair *judge;
    fmb_verdict wanted;
    fmb_status st;
} chooser;

static bool boxes_meet(const fmb_frame *p, const fmb_frame *q)
{
    double a[2 * STUDY_PAIR_MOST_DIM], b[2 * STUDY_PAIR_MOST_DIM];
    bool meet = true;
    study_aabb_of(p, a);
    study_aabb_of(q, b);
    study_aabb_meet(p->dim, a, b, a);
    for (int j = 0; j < p->dim; j++)
        meet &= a[2 * j] <= a[2 * j + 1];
    return meet;
}

/* A copy of a frame, in number. */
static fmb_frame copy_frame(const fmb_frame *f, double *number)
{
    fmb_frame out = *f;
    size_t dim = (size_t)f->dim;
    out.origin = memcpy(number, f->origin, dim * sizeof *number);
    out.axes = memcpy(number + dim, f->axes, dim * dim * sizeof *number);
    if (f->speed)
        out.speed = memcpy(number + dim + dim * dim, f->speed, dim * sizeof *number);
    return out;
}

/* The frame's numbers, in writable memory of the caller. */
static verdict_draft numbers_of(const fmb_frame *f, double *memory)
{
    return (verdict_draft){memory + (f->origin - memory), memory + (f->axes - memory),
                           f->speed ? memory + (f->speed - memory) : NULL};
}

static void reshape_pair(const verdict_source *from, const fmb_frame *p, double *of_p,
                         const fmb_frame *q, double *of_q)
{
    const verdict_draft f[2] = {numbers_of(p, of_p), numbers_of(q, of_q)};
    if (from->reshape)
        from->reshape(from->self, p->dim, f);
}

static bool choose(void *self, const fmb_frame *p, const fmb_frame *q)
{
    chooser *c = self;
    double number[2][STUDY_PAIR_MOST_DIM * (STUDY_PAIR_MOST_DIM + 2)];
    fmb_frame a = copy_frame(p, number[0]), b = copy_frame(q, number[1]);
    fmb_verdict verdict = FMB_UNKNOWN;
    if (c->st != FMB_OK || qualify_watch_interrupted())
        return true; /* so that the search ends */
    reshape_pair(c->from, &a, number[0], &b, number[1]);
    if (c->from->near && !boxes_meet(&a, &b))
        return false;
    c->st =
        fmb_pair_test(c->judge, 1, &a, &b,
                      &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &verdict});
    return verdict == c->wanted;
}

static void reshape_all(const verdict_source *from, study_pairs *s)
{
    for (size_t i = 0; i < s->n; i++)
        reshape_pair(from, &s->p[i], s->number, &s->q[i], s->number);
}

static const int SHAPE[][2][2] = {
    [VERDICT_CC] = {{FMB_CUBOID, FMB_CUBOID}, {FMB_CUBOID, FMB_CUBOID}},
    [VERDICT_CT] = {{FMB_CUBOID, FMB_SIMPLEX}, {FMB_SIMPLEX, FMB_CUBOID}},
    [VERDICT_TT] = {{FMB_SIMPLEX, FMB_SIMPLEX}, {FMB_SIMPLEX, FMB_SIMPLEX}},
    [VERDICT_ANY] = {{STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE},
                     {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}},
};

static fmb_status make_part(const verdict_class *c, int part, uint64_t seed, size_t n, chooser *by,
                            study_pairs *out)
{
    study_pair_plan plan = {.family = by->from->family[c->meets], .dim = c->dim, .moves = c->moves};
    memcpy(plan.shape, SHAPE[c->kind][part], sizeof plan.shape);
    fmb_status st = study_pairs_make(&plan, seed, n, choose, by, out);
    if (st == FMB_OK)
        reshape_all(by->from, out);
    return st != FMB_OK ? st : by->st;
}

/* Pair i is one of part i mod parts. */
static void take_turns(verdict_pool *pool, size_t parts)
{
    for (size_t i = 0; i < pool->n; i++) {
        pool->p[i] = pool->part[i % parts].p[i / parts];
        pool->q[i] = pool->part[i % parts].q[i / parts];
    }
}

fmb_status verdict_pool_make(const verdict_source *from, const verdict_class *c, uint64_t seed,
                             size_t n, fmb_pair *judge, verdict_pool *out)
{
    chooser by = {from, judge, c->meets ? FMB_FEASIBLE : FMB_INFEASIBLE, FMB_OK};
    size_t parts = c->kind == VERDICT_CT ? 2 : 1;
    *out = (verdict_pool){.n = n, .p = calloc(n, sizeof *out->p), .q = calloc(n, sizeof *out->q)};
    fmb_status st = out->p && out->q ? FMB_OK : FMB_ERR_MEMORY;
    for (size_t i = 0; st == FMB_OK && i < parts; i++)
        st = make_part(c, (int)i, seed, (n + parts - 1 - i) / parts, &by, &out->part[i]);
    out->drawn = out->part[0].drawn + out->part[1].drawn;
    if (st == FMB_OK)
        take_turns(out, parts);
    else
        verdict_pool_free(out);
    return st;
}

void verdict_pool_free(verdict_pool *pool)
{
    study_pairs_free(&pool->part[0]);
    study_pairs_free(&pool->part[1]);
    free(pool->p);
    free(pool->q);
    *pool = (verdict_pool){0};
}
