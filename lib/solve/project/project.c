/* project.c: the projection, part by part (portfolio.h). */
#include "solve/limit/outer.h"
#include "solve/portfolio/portfolio.h"
#include "solve/portfolio/project_support.h"
#include "solve/portfolio/symmetries.h"
#include "solve/prepare/recession.h"
#include "solve/project/canonical.h"
#include "solve/project/completeness.h"
#include "system/system_private.h"

/* A system without rows over the kept variables; keep NULL: the first n. */
static fmb_status open_empty_projection(const fmb_system *s, const int *keep, int n,
                                        fmb_system **out)
{
    fmb_system *t;
    fmb_status st = fmb_system_new(0, &s->mem.alloc, &t);
    if (st != FMB_OK)
        return st;
    for (int i = 0; st == FMB_OK && i < n; i++) {
        int j = keep ? keep[i] : i;
        st = fmb_system_add_variable(t, fmb_system_name(s, j), NULL);
        if (st == FMB_OK)
            t->mark[i].integer = s->mark[j].integer;
    }
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    return st;
}

fmb_status fmb_empty_set(const fmb_system *like, const int *keep, int n, fmb_system **out)
{
    fmb_system *t;
    mpz_t z[2];
    FMB_TRY(open_empty_projection(like, keep, n, &t));
    mpz_init_set_si(z[0], -1);
    mpz_init_set_ui(z[1], 1);
    fmb_status st = fmb_system_append(t, 0, NULL, z, FMB_LE);
    mpz_clears(z[0], z[1], NULL);
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    return st;
}

/* The state of a projection when it reaches a limit. */
typedef struct progress {
    int part;    /* the current part, or the first */
    size_t rows; /* of the parts before it */
    bool points; /* points can be claimed: solutions of all parts are known, or not wanted */
} progress;

/* Variables of rows with so few terms each are eliminated in no time. */
#define FEW_NAMED 4

/* Is the system possibly infeasible, as 0 is no solution, and is that cheap to decide first? */
static bool is_doubt_cheap(const fmb_system *s)
{
    size_t nonzero = 0;
    bool origin = true;
    for (size_t i = 0; i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        int side = fmb_vec_sgn(&r->val, r->nnz);
        origin &= side > 0 || (side == 0 && r->rel != FMB_LT);
        nonzero += r->nnz;
    }
    return !origin && nonzero <= FEW_NAMED * s->rows;
}

/* Decide feasibility first if proofs are wanted, or if that costs almost nothing. */
static fmb_status decide_before_projection(fmb_query *q, fmb_verdict *verdict)
{
    q->decided = q->evidence != NULL || q->parts.false_row != SIZE_MAX;
    if (q->decided)
        return fmb_query_decide(q, true, verdict);
    if (q->v->options.method == FMB_METHOD_AUTO && is_doubt_cheap(q->s))
        *verdict = fmb_query_decide_tiny(q);
    q->decided = *verdict == FMB_FEASIBLE;
    return FMB_OK;
}

static bool is_everything_at_sight(const fmb_query *q, const int *place)
{
    bool sound = !q->evidence && q->parts.false_row == SIZE_MAX;
    return sound && q->v->options.method == FMB_METHOD_AUTO &&
           fmb_recession_drops_all_at_sight(q->s, place);
}

static fmb_status project_all_parts(fmb_query *q, const int *place, fmb_system *out,
                                    fmb_verdict *verdict, progress *at)
{
    bool feasible = true;
    if (is_everything_at_sight(q, place)) {
        *verdict = FMB_FEASIBLE;
        return FMB_OK;
    }
    FMB_TRY(decide_before_projection(q, verdict));
    if (*verdict == FMB_INFEASIBLE)
        return FMB_OK;
    at->points = true;
    for (int c = 0; feasible && c < q->parts.count; c++) {
        at->part = c;
        at->rows = fmb_system_rows(out);
        q->put_out = false;
        FMB_TRY(fmb_query_project_part(q, c, place, out, &feasible));
    }
    *verdict = feasible ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return FMB_OK;
}

/* After a limit: append outer rows and, after support queries, claim inner points. Outer rows are
 * ends of variables, cheap under any limit, and rows that engines had proved. */
static fmb_status put_parts_at_limit(fmb_query *q, const progress *at, const int *place,
                                     fmb_system *out, fmb_verdict *verdict)
{
    for (int c = at->part; *verdict != FMB_INFEASIBLE && c < q->parts.count; c++) {
        size_t first = c == at->part ? at->rows : fmb_system_rows(out);
        FMB_TRY(fmb_outer_projection(q, c, place, out, verdict));
        if (*verdict != FMB_INFEASIBLE && at->points && !(c == at->part && q->put_out))
            FMB_TRY(fmb_queries_at_limit(q, c, place, out));
        if (*verdict != FMB_INFEASIBLE)
            FMB_TRY(fmb_outer_drop_parallel_rows(q, out, first));
    }
    return FMB_OK;
}

static fmb_status project_or_outer_rows(fmb_query *q, const int *place, fmb_system *out,
                                        fmb_verdict *verdict)
{
    progress at = {0};
    fmb_arena_place start = fmb_arena_tell(&q->v->arena);
    if (q->v->options.method != FMB_METHOD_HULL)
        fmb_run_reserve(&q->run);
    fmb_status st = project_all_parts(q, place, out, verdict, &at);
    if (st != FMB_LIMIT)
        return st;
    fmb_outer_release(q, start);
    st = put_parts_at_limit(q, &at, place, out, verdict);
    return st == FMB_OK && *verdict != FMB_INFEASIBLE ? FMB_LIMIT : st;
}

static fmb_status expect_increasing(fmb_solver *v, const fmb_system *s, const int *keep, int n)
{
    FMB_TRY(fmb_solver_expect_variables(v, s, "keep", keep, n));
    if (!keep && n > 0)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "keep is NULL, but n is %d", n);
    for (int i = 1; i < n; i++)
        if (keep[i] <= keep[i - 1])
            FMB_TRY(fmb_solver_refuse(v, FMB_ERR_ARG,
                                      "keep[%d] is %d, after %d: they must increase", i, keep[i],
                                      keep[i - 1]));
    return FMB_OK;
}

/* The place of each variable in keep, -1 if it is not kept; NULL without memory. */
static int *places_of_kept(const fmb_system *s, const int *keep, int n, fmb_mem *mem)
{
    int dim = fmb_system_dim(s);
    int *place = fmb_mem_get(mem, (size_t)dim, sizeof *place);
    for (int j = 0; place && j < dim; j++)
        place[j] = -1;
    for (int i = 0; place && i < n; i++)
        place[keep[i]] = i;
    return place;
}

fmb_status fmb_project(fmb_solver *v, const fmb_system *s, const int *keep, int n, fmb_system **out,
                       fmb_result *res)
{
    fmb_query q;
    fmb_system *image = NULL, *empty = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    FMB_TRY(fmb_solver_expect(v, s, out != NULL, res));
    FMB_TRY(expect_increasing(v, s, keep, n));
    int *place = places_of_kept(s, keep, n, &v->mem);
    if (!place) {
        v->answered = false; /* the evidence is that of an older query */
        return FMB_ERR_MEMORY;
    }
    fmb_status st = fmb_symmetries_enter(v, s, place);
    if (st != FMB_OK) {
        v->answered = v->answered && st == FMB_ERR_ARG;
        fmb_symmetries_leave(v, s);
        fmb_mem_put(&v->mem, place, (size_t)fmb_system_dim(s), sizeof *place);
        return st;
    }
    st = fmb_query_begin(&q, v, s, "project");
    fmb_status opened = open_empty_projection(s, keep, n, &image);
    if (opened != FMB_OK && (st == FMB_OK || st == FMB_LIMIT))
        st = opened;
    if (opened == FMB_OK)
        fmb_mem_enter(&image->mem, &v->mem);
    FMB_THEN(st, project_or_outer_rows(&q, place, image, &verdict));
    if (st == FMB_OK && verdict == FMB_FEASIBLE)
        st = fmb_query_canonical(&q, place, image);
    if (st == FMB_OK && verdict == FMB_FEASIBLE)
        st = fmb_query_prove_complete(&q, place, image);
    if (st == FMB_OK && verdict == FMB_INFEASIBLE)
        st = fmb_empty_set(s, keep, n, &empty);
    if (st == FMB_OK || st == FMB_LIMIT) {
        fmb_status carried = fmb_system_carry_objective(empty ? empty : image, s, place);
        st = carried == FMB_OK ? st : carried;
    }
    fmb_mem_put(&v->mem, place, (size_t)fmb_system_dim(s), sizeof *place);
    if (image)
        fmb_mem_leave(&image->mem);
    st = fmb_query_end(&q, st, verdict, res);
    fmb_symmetries_leave(v, s);
    if (st == FMB_OK)
        *out = empty ? empty : image;
    fmb_system_free(st != FMB_OK || empty ? image : NULL);
    fmb_system_free(st != FMB_OK ? empty : NULL);
    return st;
}
