/* depth.c: how deep two frames are in each other; see fmb/proximity.h.
 *
 * The frames part after the second moves by z iff z is not in the interior of M: so the shortest
 * such z leads from 0, inside M, to a facet. Beyond the facet a.x <= b the Euclidean norm reaches
 * first b a / |a|^2; the cube around 0 reaches first its corner with the signs of a, at half width
 * b / (|a_1| + |a_2| + ...). An equality among the rows of M, which then is flat, is a facet at
 * depth 0.
 */
#include "num/rationals.h"
#include "proximity/proximity_private.h"
#include "system/system_private.h"

typedef struct deepest {
    fmb_proximity *out;
    bool found;
    mpq_t depth, size, b, a; /* of the row at hand: its measure, |a|^2 or the sum of |a_j| */
} deepest;

/* The measure of how far 0 is from row i: b^2 / |a|^2, or b / sum |a_j|. */
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

/* The shift beyond row i, which was measured. */
static void take_row(deepest *d, const fmb_system *facets, size_t i)
{
    fmb_proximity *out = d->out;
    size_t terms = fmb_system_terms(facets, i);
    mpq_set(out->measure, d->depth);
    mpq_div(d->b, d->b, d->size);
    for (int j = 0; j < out->dim; j++)
        mpq_set_ui(out->shift[j], 0, 1);
    for (size_t k = 0; k < terms; k++) {
        int j = fmb_system_term_q(facets, i, k, d->a);
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

/* The facets of M. They are not wanted with evidence: it would be about a system that nobody sees.
 */
static fmb_status find_facets(fmb_solver *v, const fmb_two *two, fmb_system **out, fmb_result *res)
{
    fmb_minkowski m;
    fmb_system *s = NULL;
    int dim = fmb_two_dim(two);
    fmb_evidence_kept wanted = v->options.evidence;
    int *keep = fmb_mem_get(&v->mem, (size_t)dim, sizeof *keep);
    fmb_status st = fmb_minkowski_init(&m, two, &v->mem);
    if (!keep)
        st = fmb_mem_status(&v->mem);
    for (int j = 0; keep && j < dim; j++)
        keep[j] = j;
    if (st == FMB_OK)
        st = fmb_minkowski_system(&m, &v->mem.alloc, &s);
    fmb_minkowski_clear(&m);
    v->options.evidence = FMB_EVIDENCE_NONE;
    if (st == FMB_OK)
        st = fmb_project(v, s, keep, dim, out, res);
    v->options.evidence = wanted;
    v->answered = false;
    fmb_system_free(s);
    fmb_mem_put(&v->mem, keep, (size_t)dim, sizeof *keep);
    return st;
}

static fmb_status find_depth(fmb_solver *v, const fmb_two *two, fmb_norm norm, fmb_proximity **out,
                             fmb_result *res)
{
    fmb_system *facets = NULL;
    fmb_proximity *p = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_status st = fmb_two_expect(v, two, out != NULL, res);
    if (st == FMB_OK && (unsigned)norm > FMB_NORM_MAX)
        st = fmb_solver_refuse(v, FMB_ERR_ARG, "norm is %d, which is none", (int)norm);
    if (st != FMB_OK)
        return st;
    st = find_facets(v, two, &facets, &r);
    if (st != FMB_OK)
        return st;
    r.verdict = r.stop != FMB_STOP_DONE ? FMB_UNKNOWN
                : holds_origin(facets)  ? FMB_FEASIBLE
                                        : FMB_INFEASIBLE;
    if (r.verdict == FMB_FEASIBLE)
        st = fmb_proximity_new(fmb_two_dim(two), norm, &v->mem.alloc, &p);
    if (p)
        find_least_depth(facets, p);
    if (st == FMB_OK) {
        *out = p;
        fmb_result_give(res, &r);
    }
    fmb_system_free(facets);
    return st;
}

fmb_status fmb_depth(fmb_solver *v, const fmb_frame *f, fmb_norm norm, fmb_proximity **out,
                     fmb_result *res)
{
    return find_depth(v, &(fmb_two){.f = f}, norm, out, res);
}

fmb_status fmb_depth_q(fmb_solver *v, const fmb_frame_q *f, fmb_norm norm, fmb_proximity **out,
                       fmb_result *res)
{
    return find_depth(v, &(fmb_two){.q = f}, norm, out, res);
}
