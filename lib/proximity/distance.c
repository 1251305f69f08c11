/* distance.c: how far two frames are apart; see fmb/proximity.h. */
#include "num/rationals.h"
#include "proximity/proximity_private.h"
#include "system/system_private.h"

/* ---- in the norm of the largest coordinate --------------------------------------------------- */

/* Add the variable s, the last one, and the rows m_j <= s and -m_j <= s. */
static fmb_status bound_by_cube(fmb_minkowski *m, fmb_system *s)
{
    int var[2] = {0, fmb_system_dim(s)};
    fmb_status st = fmb_system_add_variable(s, "s", NULL);
    mpz_set_si(m->t[1], -1);
    mpz_set_si(m->t[2], 0);
    mpz_set_si(m->t[3], 1);
    for (int j = 0; st == FMB_OK && j < 2 * m->dim; j++) {
        mpz_set_si(m->t[0], j < m->dim ? 1 : -1);
        var[0] = j % m->dim;
        st = fmb_system_append(s, 2, var, m->t, FMB_LE);
    }
    return st;
}

static fmb_status minimize_variable(fmb_solver *v, const fmb_system *s, int var, fmb_optimum **out,
                                    fmb_result *res)
{
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    fmb_objective_q least = {.sense = FMB_SENSE_MIN, .n = 1, .var = &var, .coef = &one};
    fmb_status st = fmb_optimize_q(v, s, &least, out, res);
    mpq_clear(one);
    return st;
}

static void find_point(const fmb_minkowski *m, const fmb_optimum *best, int k, int j,
                       fmb_proximity *out)
{
    const fmb_minkowski_frame *f = &m->frame[k];
    int first = m->dim + (k == 1 ? m->frame[0].naxes : 0);
    mpq_t c, t;
    mpq_inits(c, t, NULL);
    mpq_ptr x = out->point[k][j];
    mpq_set_z(x, f->row[j]);
    for (int i = 1; i <= f->naxes + 1; i++) {
        if (i <= f->naxes)
            fmb_optimum_coordinate_q(best, first + i - 1, c);
        else
            mpq_set(c, out->time);
        mpq_set_z(t, f->row[(size_t)i * (size_t)m->dim + (size_t)j]);
        mpq_mul(t, t, c);
        mpq_add(x, x, t);
    }
    mpq_set_z(t, m->unit);
    mpq_div(x, x, t);
    mpq_clears(c, t, NULL);
}

static void write_optimum(const fmb_minkowski *m, const fmb_optimum *best, fmb_proximity *out)
{
    fmb_optimum_value_q(best, out->measure);
    if (m->moves)
        fmb_optimum_coordinate_q(best, m->dim + m->frame[0].naxes + m->frame[1].naxes, out->time);
    for (int j = 0; j < m->dim; j++) {
        for (int k = 0; k < 2; k++)
            find_point(m, best, k, j, out);
        mpq_sub(out->shift[j], out->point[0][j], out->point[1][j]);
    }
}

/* The least s for which M meets the cube of half width s around 0. */
static fmb_status ask_smallest_cube(fmb_solver *v, fmb_minkowski *m, fmb_proximity *out,
                                    fmb_result *res)
{
    fmb_system *s = NULL;
    fmb_optimum *best = NULL;
    FMB_TRY(fmb_minkowski_system(m, &v->mem.alloc, &s));
    int var = fmb_system_dim(s);
    fmb_status st = bound_by_cube(m, s);
    FMB_THEN(st, minimize_variable(v, s, var, &best, res));
    if (st == FMB_OK && fmb_optimum_end(best).kind == FMB_END_FINITE) {
        write_optimum(m, best, out);
        res->verdict = mpq_sgn(out->measure) == 0 ? FMB_FEASIBLE : FMB_INFEASIBLE;
    } else if (st == FMB_OK) {
        res->verdict = FMB_UNKNOWN;
    }
    fmb_optimum_free(best);
    fmb_system_free(s);
    return st;
}

/* ---- the verb -------------------------------------------------------------------------------- */

static fmb_status ask_distance(fmb_solver *v, fmb_minkowski *m, fmb_proximity *out, fmb_result *res)
{
    return out->norm == FMB_NORM_EUCLIDEAN
               ? fmb_proximity_ask(v, m, "distance", fmb_find_nearest, out, res)
               : ask_smallest_cube(v, m, out, res);
}

fmb_status fmb_distance(fmb_solver *v, const fmb_frame *f, fmb_norm norm, fmb_proximity **out,
                        fmb_result *res)
{
    return fmb_proximity_find(v, &(fmb_two){.f = f}, norm, true, ask_distance, out, res);
}

fmb_status fmb_distance_q(fmb_solver *v, const fmb_frame_q *f, fmb_norm norm, fmb_proximity **out,
                          fmb_result *res)
{
    return fmb_proximity_find(v, &(fmb_two){.q = f}, norm, true, ask_distance, out, res);
}
