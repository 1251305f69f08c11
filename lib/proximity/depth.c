/* depth.c: the penetration depth of two frames; see fmb/proximity.h.
 *
 * If the second frame is translated by z, the interiors do not meet iff z is not in the interior of
 * M: so the shortest such z leads from 0, inside M, to a facet a.x <= b. Its length is b / |a|,
 * with z = b a / |a|^2, in the Euclidean norm; in the maximum norm it is s = b / (|a_1| + |a_2| +
 * ...), with z_j = +-s, the signs of a. If M is flat, an equality among its rows is a facet at
 * depth 0.
 *
 * In up to eight dimensions the normals of facets are known without a projection.
 */
#include "num/rationals.h"
#include "proximity/least_overlap.h"
#include "proximity/proximity_private.h"
#include "system/system_private.h"

typedef struct deepest {
    fmb_proximity *out;
    bool found;
    mpq_t depth, size, b, a; /* of the current row: its depth, |a|^2 or the sum of |a_j| */
} deepest;

/* The distance of 0 from row i: b^2 / |a|^2, the square, or b / sum |a_j|. */
static void measure_row(deepest *d, const fmb_system *facets, size_t i)
{
    bool square = d->out->norm == FMB_NORM_EUCLIDEAN;
    size_t terms = fmb_system_terms(facets, i);
    mpq_set_ui(d->size, 0, 1);
    for (size_t k = 0; k < terms; k++) {
        fmb_system_term_q(facets, i, k, d->a);
        if (square)
            mpq_mul(d->a, d->a, d->a);
        else
            mpq_abs(d->a, d->a);
        mpq_add(d->size, d->size, d->a);
    }
    fmb_system_rhs_q(facets, i, d->b);
    mpq_set(d->depth, d->b);
    if (square)
        mpq_mul(d->depth, d->depth, d->b);
    mpq_div(d->depth, d->depth, d->size);
}

/* Take the translation to row i, which was measured. */
static void take_row(deepest *d, const fmb_system *facets, size_t i)
{
    fmb_proximity *out = d->out;
    size_t terms = fmb_system_terms(facets, i);
    mpq_set(out->measure, d->depth);
    mpq_div(d->b, d->b, d->size);
    for (int j = 0; j < out->dim; j++) {
        mpq_set_ui(out->shift[j], 0, 1);
        mpq_set_ui(out->normal[j], 0, 1);
    }
    for (size_t k = 0; k < terms; k++) {
        int j = fmb_system_term_q(facets, i, k, d->a);
        mpq_set(out->normal[j], d->a);
        if (out->norm == FMB_NORM_MAX)
            mpq_set_si(d->a, mpq_sgn(d->a), 1);
        mpq_mul(out->shift[j], d->a, d->b);
    }
    d->found = true;
}

static void find_least_depth(const fmb_system *facets, fmb_proximity *out)
{
    deepest d = {.out = out};
    mpq_inits(d.depth, d.size, d.b, d.a, NULL);
    for (size_t i = 0; i < fmb_system_rows(facets); i++) {
        measure_row(&d, facets, i);
        if (!d.found || mpq_cmp(d.depth, out->measure) < 0)
            take_row(&d, facets, i);
    }
    mpq_clears(d.depth, d.size, d.b, d.a, NULL);
}

/* Is 0 a solution? */
static bool holds_origin(const fmb_system *facets)
{
    bool holds = true;
    mpq_t b;
    mpq_init(b);
    for (size_t i = 0; holds && i < fmb_system_rows(facets); i++) {
        fmb_system_rhs_q(facets, i, b);
        holds = fmb_system_rel(facets, i) == FMB_EQ ? mpq_sgn(b) == 0 : mpq_sgn(b) >= 0;
    }
    mpq_clear(b);
    return holds;
}

/* ---- by projection --------------------------------------------------------------------------- */

/* The facets of M, without evidence: it would be about a system that the caller does not know.
 */
static fmb_status find_facets(fmb_solver *v, fmb_minkowski *m, fmb_system **out, fmb_result *res)
{
    fmb_system *s = NULL;
    fmb_evidence_kept wanted = v->options.evidence;
    int *keep = fmb_mem_get(&v->mem, (size_t)m->dim, sizeof *keep);
    fmb_status st = keep ? fmb_minkowski_system(m, &v->mem.alloc, &s) : fmb_mem_status(&v->mem);
    for (int j = 0; keep && j < m->dim; j++)
        keep[j] = j;
    v->options.evidence = FMB_EVIDENCE_NONE;
    FMB_THEN(st, fmb_project(v, s, keep, m->dim, out, res));
    v->options.evidence = wanted;
    v->answered = false;
    fmb_system_free(s);
    fmb_mem_put(&v->mem, keep, (size_t)m->dim, sizeof *keep);
    return st;
}

static fmb_status ask_facets(fmb_solver *v, fmb_minkowski *m, fmb_proximity *out, fmb_result *res)
{
    fmb_system *facets = NULL;
    FMB_TRY(find_facets(v, m, &facets, res));
    res->verdict = res->stop != FMB_STOP_DONE ? FMB_UNKNOWN
                   : holds_origin(facets)     ? FMB_FEASIBLE
                                              : FMB_INFEASIBLE;
    if (res->verdict == FMB_FEASIBLE)
        find_least_depth(facets, out);
    fmb_system_free(facets);
    return FMB_OK;
}

/* ---- by normals ------------------------------------------------------------------------------ */

/* The translation is overlap n / |n|^2 for the normal n of the facet; in the maximum norm, a corner
 * of a cube: n is replaced by its signs, and |n| is the sum of its absolute coordinates. */
static void write_least_overlap(const fmb_minkowski *m, fmb_least_overlap *x, fmb_proximity *out)
{
    mpq_t step;
    mpq_init(step);
    mpz_set(mpq_numref(step), x->overlap);
    mpz_mul(mpq_denref(step), x->size, m->unit);
    if (x->found)
        mpq_canonicalize(step);
    else
        mpq_set_ui(step, 0, 1);
    mpq_set(out->measure, step);
    if (out->norm == FMB_NORM_EUCLIDEAN) {
        mpq_set_z(out->measure, x->size);
        mpq_mul(out->measure, out->measure, step);
        mpq_mul(out->measure, out->measure, step);
    }
    for (int j = 0; j < m->dim; j++) {
        mpq_set_z(out->normal[j], x->normal[j]);
        if (out->norm == FMB_NORM_MAX)
            mpz_set_si(x->normal[j], mpz_sgn(x->normal[j]));
        mpq_set_z(out->shift[j], x->normal[j]);
        mpq_mul(out->shift[j], out->shift[j], step);
    }
    mpq_clear(step);
}

/* If the least overlap is 0, then 0 is on the boundary of M, or M is flat: is 0 in M? */
static fmb_status answer_by_normals(fmb_minkowski *m, fmb_run *run, fmb_proximity *out,
                                    fmb_verdict *verdict)
{
    fmb_least_overlap x;
    fmb_least_overlap_init(&x);
    fmb_status st = fmb_find_least_overlap(m, out->norm, run, &x);
    if (st == FMB_OK)
        *verdict = mpz_sgn(x.overlap) < 0 ? FMB_INFEASIBLE : FMB_FEASIBLE;
    if (st == FMB_OK && mpz_sgn(x.overlap) == 0)
        st = fmb_find_nearest(m, run, NULL, verdict);
    if (st == FMB_OK && *verdict == FMB_FEASIBLE)
        write_least_overlap(m, &x, out);
    fmb_least_overlap_clear(&x);
    return st;
}

static fmb_status ask_depth(fmb_solver *v, fmb_minkowski *m, fmb_proximity *out, fmb_result *res)
{
    return fmb_has_normals(m) ? fmb_proximity_ask(v, m, "depth", answer_by_normals, out, res)
                              : ask_facets(v, m, out, res);
}

fmb_status fmb_depth(fmb_solver *v, const fmb_frame *f, fmb_norm norm, fmb_proximity **out,
                     fmb_result *res)
{
    return fmb_proximity_find(v, &(fmb_two){.f = f}, norm, false, ask_depth, out, res);
}

fmb_status fmb_depth_q(fmb_solver *v, const fmb_frame_q *f, fmb_norm norm, fmb_proximity **out,
                       fmb_result *res)
{
    return fmb_proximity_find(v, &(fmb_two){.q = f}, norm, false, ask_depth, out, res);
}
