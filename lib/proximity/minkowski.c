/* minkowski.c: see minkowski.h. */
#include "proximity/minkowski.h"

#include "num/vec.h"
#include "system/system_private.h"

/* ---- frames in whole numbers ----------------------------------------------------------------- */

static mpz_t *row_of_frame(const fmb_minkowski *m, int k, int i)
{
    return m->frame[k].row + (size_t)i * (size_t)m->dim;
}

/* The axes of the world have units of their own (frame/frame_integers.h); here they share one. */
static void find_common_unit(fmb_minkowski *m, const fmb_scene *scene)
{
    mpz_set_ui(m->unit, 1);
    for (int j = 0; j < m->dim; j++)
        mpz_lcm(m->unit, m->unit, scene->unit[j]);
}

static void read_frame_rows(fmb_minkowski *m, const fmb_scene *scene, int k)
{
    const fmb_integer_frame *f = &scene->frame[k];
    for (int j = 0; j < m->dim; j++) {
        mpz_divexact(m->t[0], m->unit, scene->unit[j]);
        for (int i = 0; i < f->rows; i++) {
            mpz_ptr to = row_of_frame(m, k, i)[j];
            fmb_scene_number(scene, f, i, j, to);
            mpz_mul(to, to, m->t[0]);
        }
    }
}

static fmb_status read_scene(fmb_minkowski *m, const fmb_scene *scene)
{
    size_t dim = (size_t)scene->dim, rows = 1; /* of the drift */
    for (int k = 0; k < 2; k++)
        rows += (size_t)scene->frame[k].naxes + 2;
    m->cells = rows * dim;
    m->cell = fmb_vec_block(m->cells, m->mem);
    if (!m->cell)
        return fmb_mem_status(m->mem);
    mpz_t *next = m->cell;
    find_common_unit(m, scene);
    for (int k = 0; k < 2; k++) {
        const fmb_integer_frame *f = &scene->frame[k];
        m->frame[k] = (fmb_minkowski_frame){f->shape, f->naxes, next};
        m->moves |= f->moves;
        next += ((size_t)f->naxes + 2) * dim;
        read_frame_rows(m, scene, k);
    }
    m->drift = next;
    for (int j = 0; j < m->dim; j++)
        mpz_sub(m->drift[j], row_of_frame(m, 0, m->frame[0].naxes + 1)[j],
                row_of_frame(m, 1, m->frame[1].naxes + 1)[j]);
    return FMB_OK;
}

fmb_status fmb_minkowski_init(fmb_minkowski *m, const fmb_two *two, fmb_mem *mem)
{
    fmb_scene scene = {0};
    *m = (fmb_minkowski){.mem = mem, .dim = fmb_two_dim(two)};
    mpz_init(m->unit);
    for (int k = 0; k < 4; k++)
        mpz_init(m->t[k]);
    fmb_status st = fmb_scene_open(&scene, two->f, two->q, 2, mem, NULL);
    FMB_THEN(st, read_scene(m, &scene));
    fmb_scene_clear(&scene);
    return st;
}

void fmb_minkowski_clear(fmb_minkowski *m)
{
    fmb_vec_block_free(m->cell, m->cells, m->mem);
    mpz_clear(m->unit);
    for (int k = 0; k < 4; k++)
        mpz_clear(m->t[k]);
}

void fmb_minkowski_shorten(fmb_minkowski *m, mp_bitcnt_t *by)
{
    size_t dim = (size_t)m->dim;
    for (size_t j = 0; j < dim; j++) {
        mpz_set_ui(m->t[0], 0); /* the bits of all numbers, of which the lowest counts */
        for (size_t i = j; i < m->cells; i += dim)
            mpz_ior(m->t[0], m->t[0], m->cell[i]);
        by[j] = mpz_sgn(m->t[0]) == 0 ? 0 : mpz_scan1(m->t[0], 0);
        for (size_t i = j; i < m->cells; i += dim)
            mpz_tdiv_q_2exp(m->cell[i], m->cell[i], by[j]);
    }
}

/* ---- its lowest vertex ----------------------------------------------------------------------- */

void fmb_minkowski_dot(const fmb_minkowski *m, mpz_t *a, mpz_t *b, mpz_t out)
{
    mpz_set_ui(out, 0);
    for (int j = 0; j < m->dim; j++)
        mpz_addmul(out, a[j], b[j]);
}

static void add_row(const fmb_minkowski *m, mpz_t *row, mpz_t *to)
{
    for (int j = 0; j < m->dim; j++)
        mpz_add(to[j], to[j], row[j]);
}

/* The corner of frame k where sign w is least: of a cuboid each edge is taken that leads down, of a
 * simplex the one that leads down most. */
static void find_lowest_corner(fmb_minkowski *m, int k, mpz_t *w, int sign, mpz_t *corner)
{
    const fmb_minkowski_frame *f = &m->frame[k];
    int best = 0;
    mpz_ptr slope = m->t[0], least = m->t[1];
    for (int j = 0; j < m->dim; j++)
        mpz_set(corner[j], row_of_frame(m, k, 0)[j]);
    mpz_set_ui(least, 0);
    for (int i = 1; i <= f->naxes; i++) {
        fmb_minkowski_dot(m, w, row_of_frame(m, k, i), slope);
        if (sign < 0)
            mpz_neg(slope, slope);
        if (f->shape == FMB_CUBOID && mpz_sgn(slope) < 0)
            add_row(m, row_of_frame(m, k, i), corner);
        if (f->shape == FMB_SIMPLEX && mpz_cmp(slope, least) < 0) {
            mpz_set(least, slope);
            best = i;
        }
    }
    if (best > 0)
        add_row(m, row_of_frame(m, k, best), corner);
}

void fmb_minkowski_lowest(fmb_minkowski *m, mpz_t *w, mpz_t *vertex)
{
    mpz_t *p = vertex + m->dim, *q = p + m->dim, *time = q + m->dim;
    find_lowest_corner(m, 0, w, 1, p);
    find_lowest_corner(m, 1, w, -1, q);
    fmb_minkowski_dot(m, w, m->drift, m->t[0]);
    mpz_set_ui(time[0], mpz_sgn(m->t[0]) < 0);
    for (int j = 0; j < m->dim; j++) {
        mpz_sub(vertex[j], p[j], q[j]);
        mpz_addmul(vertex[j], time[0], m->drift[j]);
    }
}

/* ---- as a system ----------------------------------------------------------------------------- */

/* A row to be appended to a system. */
typedef struct row_draft {
    fmb_system *s;
    size_t n;
    int *var;
    mpz_t *z; /* terms, right side, denominator 1 */
} row_draft;

static void put_term(row_draft *r, int var, const mpz_t z)
{
    if (mpz_sgn(z) == 0)
        return;
    r->var[r->n] = var;
    mpz_set(r->z[r->n++], z);
}

static fmb_status append_draft(row_draft *r, const mpz_t right, fmb_rel rel)
{
    mpz_set(r->z[r->n], right);
    mpz_set_ui(r->z[r->n + 1], 1);
    fmb_status st = fmb_system_append(r->s, r->n, r->var, r->z, rel);
    r->n = 0;
    return st;
}

/* 0 <= c <= 1 for `n` variables, or 0 <= c with their sum at most 1. */
static fmb_status bound_coordinates(fmb_minkowski *m, row_draft *r, int from, int n,
                                    fmb_shape shape)
{
    mpz_ptr one = m->t[0], minus = m->t[1], zero = m->t[2];
    mpz_set_si(one, 1);
    mpz_set_si(minus, -1);
    mpz_set_si(zero, 0);
    for (int i = 0; i < n; i++) {
        put_term(r, from + i, minus);
        FMB_TRY(append_draft(r, zero, FMB_LE));
        if (shape == FMB_CUBOID) {
            put_term(r, from + i, one);
            FMB_TRY(append_draft(r, one, FMB_LE));
        }
    }
    for (int i = 0; shape == FMB_SIMPLEX && i < n; i++)
        put_term(r, from + i, one);
    return r->n > 0 ? append_draft(r, one, FMB_LE) : FMB_OK;
}

/* unit m_j - (edges of P) c + (edges of Q) c' - drift t = origin of P - origin of Q */
static fmb_status append_coordinate(fmb_minkowski *m, row_draft *r, int j)
{
    int var = m->dim;
    put_term(r, j, m->unit);
    for (int k = 0; k < 2; k++)
        for (int i = 1; i <= m->frame[k].naxes; i++) {
            mpz_set(m->t[0], row_of_frame(m, k, i)[j]);
            if (k == 0)
                mpz_neg(m->t[0], m->t[0]);
            put_term(r, var++, m->t[0]);
        }
    mpz_neg(m->t[0], m->drift[j]);
    if (m->moves)
        put_term(r, var, m->t[0]);
    mpz_sub(m->t[0], row_of_frame(m, 0, 0)[j], row_of_frame(m, 1, 0)[j]);
    return append_draft(r, m->t[0], FMB_EQ);
}

static fmb_status append_all_rows(fmb_minkowski *m, row_draft *r)
{
    int var = m->dim;
    for (int j = 0; j < m->dim; j++)
        FMB_TRY(append_coordinate(m, r, j));
    for (int k = 0; k < 2; k++) {
        FMB_TRY(bound_coordinates(m, r, var, m->frame[k].naxes, m->frame[k].shape));
        var += m->frame[k].naxes;
    }
    return m->moves ? bound_coordinates(m, r, var, 1, FMB_CUBOID) : FMB_OK;
}

fmb_status fmb_minkowski_system(fmb_minkowski *m, const fmb_alloc *hook, fmb_system **out)
{
    int vars = m->dim + m->frame[0].naxes + m->frame[1].naxes + m->moves;
    size_t width = (size_t)vars + 2;
    row_draft r = {0};
    FMB_TRY(fmb_system_new(vars, hook, &r.s));
    r.var = fmb_mem_get(m->mem, width, sizeof *r.var);
    r.z = fmb_vec_block(width, m->mem);
    fmb_status st = r.var && r.z ? append_all_rows(m, &r) : fmb_mem_status(m->mem);
    fmb_vec_block_free(r.z, width, m->mem);
    fmb_mem_put(m->mem, r.var, width, sizeof *r.var);
    if (st == FMB_OK)
        *out = r.s;
    else
        fmb_system_free(r.s);
    return st;
}
