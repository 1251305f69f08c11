/* separate.c: a row that separates two frames; see fmb/proximity.h.
 *
 * The system of the common points has the variables x, t and the coordinates c of both frames; each
 * frame has rows of its own, which share only x and t. So Farkas multipliers of a conflict combine
 * the rows of the first frame to w.x + k t <= b, where its c cancel, and those of the second frame
 * and of time to a row that contradicts it: w separates. Only w is kept. The row handed out is at
 * rest relative to the second frame (the coefficient of t is minus its speed along w), and its
 * right side is the largest value that the first frame reaches.
 */
#include "num/rationals.h"
#include "num/vec.h"
#include "proximity/proximity_private.h"
#include "system/system_private.h"

/* The number of a frame's rows before those that define its point x (frame/frame_rows.c). */
static size_t rows_before_point(const fmb_minkowski_frame *f)
{
    size_t n = (size_t)f->naxes;
    return f->shape == FMB_CUBOID ? 2 * n : n + (n > 0);
}

static size_t find_conflict(const fmb_evidence *e)
{
    size_t i = 0;
    while (i < fmb_evidence_claims(e) && fmb_evidence_kind(e, i) != FMB_CLAIM_INFEASIBLE)
        i++;
    return i;
}

/* w_j is the multiplier of the row that defines x_j, times the coefficient of x_j in it. */
static void read_direction(const fmb_minkowski *m, const fmb_system *s, const fmb_evidence *e,
                           mpq_t *w)
{
    size_t claim = find_conflict(e), row = rows_before_point(&m->frame[0]);
    mpq_t coef;
    mpq_init(coef);
    for (int j = 0; j < m->dim; j++) {
        fmb_evidence_multiplier_q(e, claim, row + (size_t)j, w[j]);
        fmb_system_term_q(s, row + (size_t)j, 0, coef); /* x comes before all other variables */
        mpq_mul(w[j], w[j], coef);
    }
    mpq_clear(coef);
}

/* out = w without fractions. */
static void make_direction_integer(const fmb_minkowski *m, mpq_t *w, mpz_t *out)
{
    mpz_t scale;
    mpz_init_set_ui(scale, 1);
    for (int j = 0; j < m->dim; j++)
        mpz_lcm(scale, scale, mpq_denref(w[j]));
    for (int j = 0; j < m->dim; j++) {
        mpz_divexact(out[j], scale, mpq_denref(w[j]));
        mpz_mul(out[j], out[j], mpq_numref(w[j]));
    }
    mpz_clear(scale);
}

/* Divide n integers by their greatest common divisor. */
static void make_primitive(mpz_t *z, size_t n)
{
    mpz_t g;
    mpz_init(g);
    for (size_t k = 0; k < n; k++)
        mpz_gcd(g, g, z[k]);
    for (size_t k = 0; mpz_cmp_ui(g, 1) > 0 && k < n; k++)
        mpz_divexact(z[k], z[k], g);
    mpz_clear(g);
}

/* The row over x and, if something moves, t. The vertex is the one of M where w is largest. */
static fmb_status append_separating_row(fmb_minkowski *m, mpz_t *w, mpz_t *vertex, fmb_system *out)
{
    size_t dim = (size_t)m->dim, n = 0;
    const fmb_minkowski_frame *q = &m->frame[1];
    int *var = fmb_mem_get(m->mem, dim + 1, sizeof *var);
    mpz_t *z = fmb_vec_block(dim + 3, m->mem);
    fmb_status st = var && z ? FMB_OK : fmb_mem_status(m->mem);
    for (size_t j = 0; st == FMB_OK && j < dim; j++)
        if (mpz_sgn(w[j]) != 0) {
            var[n] = (int)j;
            mpz_mul(z[n++], w[j], m->unit);
        }
    if (st == FMB_OK) {
        fmb_minkowski_dot(m, w, q->row + (size_t)(q->naxes + 1) * dim, z[n]);
        mpz_neg(z[n], z[n]);
        var[n] = (int)dim;
        n += mpz_sgn(z[n]) != 0;
        fmb_minkowski_dot(m, w, vertex + dim, z[n]);
        fmb_minkowski_dot(m, w, m->drift, m->t[0]);
        mpz_addmul(z[n], m->t[0], vertex[3 * dim]);
        make_primitive(z, n + 1);
        mpz_set_ui(z[n + 1], 1);
        st = fmb_system_append(out, n, var, z, FMB_LE);
    }
    fmb_vec_block_free(z, dim + 3, m->mem);
    fmb_mem_put(m->mem, var, dim + 1, sizeof *var);
    return st;
}

/* The scratch integers: w, then -w, then a vertex. */
static fmb_status find_row(fmb_minkowski *m, const fmb_system *s, const fmb_evidence *e,
                           fmb_system *out)
{
    size_t dim = (size_t)m->dim, size = (2 + FMB_VERTEX_ROWS) * dim;
    mpq_t *w = NULL;
    mpz_t *whole = fmb_vec_block(size, m->mem);
    fmb_status st = whole ? fmb_rationals_new(&w, dim, m->mem) : fmb_mem_status(m->mem);
    if (st == FMB_OK) {
        read_direction(m, s, e, w);
        make_direction_integer(m, w, whole);
        for (size_t j = 0; j < dim; j++)
            mpz_neg(whole[dim + j], whole[j]);
        fmb_minkowski_lowest(m, whole + dim, whole + 2 * dim);
        st = append_separating_row(m, whole, whole + 2 * dim, out);
    }
    fmb_rationals_free(w, dim, m->mem);
    fmb_vec_block_free(whole, size, m->mem);
    return st;
}

/* [give] A system over x1, x2, ... and, if something moves, t, with that one row. */
static fmb_status make_row(fmb_solver *v, const fmb_two *two, const fmb_system *s,
                           const fmb_evidence *e, fmb_system **out)
{
    fmb_minkowski m;
    fmb_system *row = NULL;
    fmb_status st = fmb_minkowski_init(&m, two, &v->mem);
    FMB_THEN(st, fmb_system_new(m.dim, &v->mem.alloc, &row));
    if (st == FMB_OK && m.moves)
        st = fmb_system_add_variable(row, "t", NULL);
    FMB_THEN(st, find_row(&m, s, e, row));
    fmb_minkowski_clear(&m);
    if (st == FMB_OK)
        *out = row;
    else
        fmb_system_free(row);
    return st;
}

/* The evidence is needed, whatever the solver's options keep. */
static fmb_status solve_with_evidence(fmb_solver *v, const fmb_system *s, fmb_evidence **out,
                                      fmb_result *res)
{
    fmb_evidence_kept wanted = v->options.evidence;
    v->options.evidence = FMB_EVIDENCE_VERDICT;
    fmb_status st = fmb_solve(v, s, res);
    v->options.evidence = wanted;
    if (st == FMB_OK && res->verdict == FMB_INFEASIBLE)
        st = fmb_solver_evidence(v, out);
    v->answered = false;
    return st;
}

static fmb_status separate_two(fmb_solver *v, const fmb_two *two, fmb_contact contact,
                               fmb_system **out, fmb_result *res)
{
    fmb_system *s = NULL, *row = NULL;
    fmb_evidence *e = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_status st = fmb_two_expect(v, two, out != NULL, res);
    if (st == FMB_OK && (unsigned)contact > FMB_CONTACT_OPEN)
        st = fmb_solver_refuse(v, FMB_ERR_ARG, "contact is %d, which is none", (int)contact);
    FMB_THEN(st, fmb_two_system(two, FMB_COORDINATES_ALL, contact, &v->mem.alloc, &s));
    FMB_THEN(st, solve_with_evidence(v, s, &e, &r));
    if (st == FMB_OK && e)
        st = make_row(v, two, s, e, &row);
    if (st == FMB_OK) {
        *out = row;
        fmb_result_give(res, &r);
    }
    fmb_evidence_free(e);
    fmb_system_free(s);
    return st;
}

fmb_status fmb_separate(fmb_solver *v, const fmb_frame *f, fmb_contact contact, fmb_system **out,
                        fmb_result *res)
{
    return separate_two(v, &(fmb_two){.f = f}, contact, out, res);
}

fmb_status fmb_separate_q(fmb_solver *v, const fmb_frame_q *f, fmb_contact contact,
                          fmb_system **out, fmb_result *res)
{
    return separate_two(v, &(fmb_two){.q = f}, contact, out, res);
}
