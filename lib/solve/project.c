/* project.c: the projection, part by part (shadow.h). */
#include "solve/outer.h"
#include "solve/shadow.h"
#include "system/system.h"

/* An empty system over the variables kept; keep NULL: the first n. */
static fmb_status open_projection(const fmb_system *s, const int *keep, int n, fmb_system **out)
{
    fmb_system *t;
    fmb_status st = fmb_system_new(0, &s->mem.alloc, &t);
    if (st != FMB_OK)
        return st;
    for (int i = 0; st == FMB_OK && i < n; i++)
        st = fmb_system_add_variable(t, fmb_system_name(s, keep ? keep[i] : i), NULL);
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
    fmb_status st = open_projection(like, keep, n, &t);
    if (st != FMB_OK)
        return st;
    mpz_init_set_si(z[0], -1);
    mpz_init_set_ui(z[1], 1);
    st = fmb_system_append(t, 0, NULL, z, FMB_LE);
    mpz_clears(z[0], z[1], NULL);
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    return st;
}

/* Where proofs are wanted, whether there is a solution is decided first. *part is the one that a
 * limit has cut short. */
static fmb_status project_parts(fmb_query *q, const int *place, fmb_system *out,
                                fmb_verdict *verdict, int *part)
{
    bool feasible = true;
    fmb_status st = FMB_OK;
    q->decided = q->evidence != NULL || q->parts.false_row != SIZE_MAX;
    if (q->decided)
        st = fmb_query_decide(q, true, verdict);
    if (st != FMB_OK || *verdict == FMB_INFEASIBLE)
        return st;
    for (int c = 0; feasible && c < q->parts.count; c++) {
        size_t rows = fmb_system_rows(out);
        st = fmb_query_project_part(q, c, place, out, &feasible);
        *part =
            fmb_system_rows(out) == rows ? c : c + 1; /* what there is need not be found again */
        if (st != FMB_OK)
            return st;
    }
    *verdict = feasible ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return FMB_OK;
}

static fmb_status project(fmb_query *q, const int *place, fmb_system *out, fmb_verdict *verdict)
{
    int part = 0;
    fmb_arena_place start = fmb_arena_tell(&q->v->arena);
    fmb_status st = project_parts(q, place, out, verdict, &part);
    if (st != FMB_LIMIT)
        return st;
    fmb_outer_release(q, start);
    st = fmb_outer_projection(q, part, place, out, verdict);
    return st == FMB_OK && *verdict != FMB_INFEASIBLE ? FMB_LIMIT : st;
}

/* The place of each variable in keep, -1 where it is not kept; NULL if keep is not increasing. */
static int *invert(const fmb_system *s, const int *keep, int n, fmb_mem *mem, fmb_status *st)
{
    int dim = fmb_system_dim(s);
    *st = FMB_ERR_ARG;
    for (int i = 0; i < n; i++)
        if (keep[i] < 0 || keep[i] >= dim || (i > 0 && keep[i] <= keep[i - 1]))
            return NULL;
    int *place = n < 0 ? NULL : fmb_mem_get(mem, (size_t)dim, sizeof *place);
    if (!place) {
        *st = n < 0 ? FMB_ERR_ARG : FMB_ERR_MEMORY;
        return NULL;
    }
    for (int j = 0; j < dim; j++)
        place[j] = -1;
    for (int i = 0; i < n; i++)
        place[keep[i]] = i;
    *st = FMB_OK;
    return place;
}

fmb_status fmb_project(fmb_solver *v, const fmb_system *s, const int *keep, int n, fmb_system **out,
                       fmb_result *res)
{
    fmb_query q;
    fmb_system *image = NULL, *empty = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = FMB_ERR_ARG;
    int *place = out ? invert(s, keep, n, &v->mem, &st) : NULL;
    if (!place) {
        v->answered &= st != FMB_ERR_MEMORY; /* the evidence at hand is that of an older query */
        return st;
    }
    st = fmb_query_begin(&q, v, s, "project");
    fmb_status opened = open_projection(s, keep, n, &image);
    if (opened != FMB_OK && (st == FMB_OK || st == FMB_LIMIT))
        st = opened;
    if (st == FMB_OK)
        st = project(&q, place, image, &verdict);
    if (st == FMB_OK && verdict == FMB_INFEASIBLE)
        st = fmb_empty_set(s, keep, n, &empty);
    fmb_mem_put(&v->mem, place, (size_t)fmb_system_dim(s), sizeof *place);
    st = fmb_query_end(&q, st, verdict, res);
    if (st == FMB_OK)
        *out = empty ? empty : image;
    fmb_system_free(st != FMB_OK || empty ? image : NULL);
    fmb_system_free(st != FMB_OK ? empty : NULL);
    return st;
}
