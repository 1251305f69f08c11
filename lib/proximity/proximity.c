/* proximity.c: see proximity_private.h and fmb/proximity.h. */
#include "proximity/proximity_private.h"

#include "num/rationals.h"

/* [give] All zeros. Errors: MEMORY. */
static fmb_status new_proximity(int dim, fmb_norm norm, const fmb_alloc *hook, fmb_proximity **out)
{
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_proximity *p;
    FMB_TRY(FMB_GET_ZERO(&mem, p, 1));
    mpq_init(p->measure);
    mpq_init(p->time);
    p->mem = mem;
    p->dim = dim;
    p->norm = norm;
    mpq_t **const list[] = {&p->point[0], &p->point[1], &p->shift, &p->normal};
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < 4; k++)
        st = fmb_rationals_new(list[k], (size_t)dim, &p->mem);
    if (st == FMB_OK)
        *out = p;
    else
        fmb_proximity_free(p);
    return st;
}

void fmb_proximity_free(fmb_proximity *p)
{
    if (!p)
        return;
    for (int k = 0; k < 2; k++)
        fmb_rationals_free(p->point[k], (size_t)p->dim, &p->mem);
    fmb_rationals_free(p->shift, (size_t)p->dim, &p->mem);
    fmb_rationals_free(p->normal, (size_t)p->dim, &p->mem);
    mpq_clear(p->measure);
    mpq_clear(p->time);
    fmb_mem mem = p->mem;
    fmb_mem_put(&mem, p, 1, sizeof *p);
}

/* ---- how it is asked ------------------------------------------------------------------------- */

fmb_status fmb_proximity_ask(fmb_solver *v, fmb_minkowski *m, const char *name,
                             fmb_proximity_answer *answer, fmb_proximity *out, fmb_result *res)
{
    fmb_system *none = NULL;
    fmb_query q;
    FMB_TRY(fmb_system_new(m->dim, &v->mem.alloc, &none));
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = fmb_query_begin(&q, v, none, name);
    FMB_THEN(st, answer(m, &q.run, out, &verdict));
    st = fmb_query_end(&q, st, verdict, res);
    v->answered = false;
    fmb_system_free(none);
    return st;
}

fmb_status fmb_proximity_find(fmb_solver *v, const fmb_two *two, fmb_norm norm, bool apart,
                              fmb_proximity_way *way, fmb_proximity **out, fmb_result *res)
{
    fmb_minkowski m;
    fmb_proximity *p = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_status st = fmb_two_expect(v, two, out != NULL, res);
    if (st == FMB_OK && (unsigned)norm > FMB_NORM_MAX)
        st = fmb_solver_refuse(v, FMB_ERR_ARG, "norm is %d, which is none", (int)norm);
    if (st != FMB_OK)
        return st;
    st = fmb_minkowski_init(&m, two, &v->mem);
    FMB_THEN(st, new_proximity(m.dim, norm, &v->mem.alloc, &p));
    FMB_THEN(st, way(v, &m, p, &r));
    fmb_minkowski_clear(&m);
    bool found =
        st == FMB_OK && (r.verdict == FMB_FEASIBLE || (apart && r.verdict == FMB_INFEASIBLE));
    if (st == FMB_OK) {
        *out = found ? p : NULL;
        fmb_result_give(res, &r);
    }
    if (!found)
        fmb_proximity_free(p);
    return st;
}

/* ---- what it says ---------------------------------------------------------------------------- */

static bool is_coordinate(const fmb_proximity *p, int j)
{
    return p && j >= 0 && j < p->dim;
}

static mpq_srcptr point_of(const fmb_proximity *p, int which, int j)
{
    return is_coordinate(p, j) && (which == 0 || which == 1) ? p->point[which][j] : NULL;
}

static mpq_srcptr shift_of(const fmb_proximity *p, int j)
{
    return is_coordinate(p, j) ? p->shift[j] : NULL;
}

int fmb_proximity_dim(const fmb_proximity *p)
{
    return p ? p->dim : 0;
}

double fmb_proximity_length(const fmb_proximity *p)
{
    return p && p->norm == FMB_NORM_EUCLIDEAN ? fmb_nearest_root(p->measure)
                                              : fmb_nearest_double(p ? p->measure : NULL);
}

double fmb_proximity_time(const fmb_proximity *p)
{
    return fmb_nearest_double(p ? p->time : NULL);
}

double fmb_proximity_point(const fmb_proximity *p, int which, int j)
{
    return fmb_nearest_double(point_of(p, which, j));
}

double fmb_proximity_shift(const fmb_proximity *p, int j)
{
    return fmb_nearest_double(shift_of(p, j));
}

void fmb_proximity_measure_q(const fmb_proximity *p, mpq_t out)
{
    fmb_rational_give(p ? p->measure : NULL, out);
}

void fmb_proximity_time_q(const fmb_proximity *p, mpq_t out)
{
    fmb_rational_give(p ? p->time : NULL, out);
}

void fmb_proximity_point_q(const fmb_proximity *p, int which, int j, mpq_t out)
{
    fmb_rational_give(point_of(p, which, j), out);
}

void fmb_proximity_shift_q(const fmb_proximity *p, int j, mpq_t out)
{
    fmb_rational_give(shift_of(p, j), out);
}

size_t fmb_proximity_measure_text(const fmb_proximity *p, char *text, size_t size)
{
    return fmb_rational_print(p ? p->measure : NULL, text, size);
}

size_t fmb_proximity_time_text(const fmb_proximity *p, char *text, size_t size)
{
    return fmb_rational_print(p ? p->time : NULL, text, size);
}

size_t fmb_proximity_point_text(const fmb_proximity *p, int which, int j, char *text, size_t size)
{
    return fmb_rational_print(point_of(p, which, j), text, size);
}

size_t fmb_proximity_shift_text(const fmb_proximity *p, int j, char *text, size_t size)
{
    return fmb_rational_print(shift_of(p, j), text, size);
}
