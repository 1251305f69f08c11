/* lift_hull.c: lifts of hulls: of several polyhedra, and of vertices, rays and lines; see
 * lift_private.h.
 *
 * A mean of points x_k of polyhedra A_k x <= b_k with weights t_k is the sum of y_k = t_k x_k, and
 * A_k y_k <= b_k t_k, t_k >= 0, sum t_k = 1. If t_k is 0, y_k is any direction of the recession
 * cone of the k-th: as this is not empty, adding them gives the closure (Balas 1998, theorem 2.1;
 * if it were empty, they would be no directions of it). Rows < become rows <= of the closure, again
 * as no polyhedron is empty.
 */
#include <fmb/lift.h>

#include "lift/lift_private.h"
#include "num/rationals.h"
#include "system/generators_private.h"
#include "system/system_private.h"

/* sum coef[i] x_var[i] REL right for terms in any order. */
typedef struct lifted_row {
    int *var;
    mpq_t *coef;
    size_t room, n;
    mpq_t right; /* initially 0 */
} lifted_row;

static fmb_status open_lifted_row(lifted_row *r, fmb_system *lift, size_t room)
{
    *r = (lifted_row){.room = room};
    mpq_init(r->right);
    r->var = fmb_mem_get(&lift->mem, room, sizeof *r->var);
    return r->var ? fmb_rationals_new(&r->coef, room, &lift->mem) : fmb_mem_status(&lift->mem);
}

static void close_lifted_row(lifted_row *r, fmb_system *lift)
{
    mpq_clear(r->right);
    fmb_rationals_free(r->coef, r->room, &lift->mem);
    fmb_mem_put(&lift->mem, r->var, r->room, sizeof *r->var);
}

static mpq_ptr next_term(lifted_row *r, int var)
{
    r->var[r->n] = var;
    return r->coef[r->n++];
}

/* Append the row of the present terms, and remove these. */
static fmb_status append_lifted_row(lifted_row *r, fmb_system *lift, fmb_rel rel)
{
    fmb_status st = fmb_system_add_q(lift, r->n, r->var, r->coef, rel, r->right);
    r->n = 0;
    return st;
}

/* 1 = the sum of these variables. */
static fmb_status append_total(lifted_row *r, fmb_system *lift, const int *var, size_t n)
{
    for (size_t i = 0; i < n; i++)
        mpq_set_ui(next_term(r, var[i]), 1, 1);
    mpq_set_ui(r->right, 1, 1);
    fmb_status st = append_lifted_row(r, lift, FMB_EQ);
    mpq_set_ui(r->right, 0, 1);
    return st;
}

static fmb_status append_nonnegative(lifted_row *r, fmb_system *lift, int var)
{
    mpq_set_si(next_term(r, var), -1, 1);
    return append_lifted_row(r, lift, FMB_LE);
}

/* ---- of several polyhedra -------------------------------------------------------------------- */

/* Append the closures of the rows of s over copy[], with right sides times weight. */
static fmb_status append_weighted_rows(lifted_row *r, fmb_system *lift, const fmb_system *s,
                                       const int *copy, int weight)
{
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        const fmb_sysrow *from = fmb_system_row(s, i);
        for (size_t k = 0; k < from->nnz; k++)
            fmb_sysrow_get_q(from, k, next_term(r, copy[from->var[k]]));
        mpq_ptr right = next_term(r, weight);
        fmb_sysrow_get_q(from, from->nnz, right);
        mpq_neg(right, right);
        FMB_TRY(append_lifted_row(r, lift, from->rel == FMB_EQ ? FMB_EQ : FMB_LE));
        if (from->label)
            FMB_TRY(fmb_system_set_label(lift, lift->rows - 1, from->label));
    }
    return FMB_OK;
}

static fmb_status append_weighted_systems(const fmb_lift_copies *c, fmb_system *lift, lifted_row *r,
                                          int *weight)
{
    FMB_TRY(fmb_lift_append_sums(c, lift));
    for (size_t k = 0; k < c->n; k++)
        FMB_TRY(fmb_lift_add_fresh(lift, "t", k + 1, &weight[k]));
    FMB_TRY(append_total(r, lift, weight, c->n));
    for (size_t k = 0; k < c->n; k++) {
        FMB_TRY(append_nonnegative(r, lift, weight[k]));
        FMB_TRY(append_weighted_rows(r, lift, c->s[k], c->var[k], weight[k]));
    }
    return FMB_OK;
}

/* For n = 0 this has the row 0 = 1, so it is empty. */
fmb_status fmb_lift_hull(fmb_system *lift, const fmb_system *like, const fmb_system *const *s,
                         size_t n)
{
    fmb_lift_copies c;
    lifted_row r;
    size_t most = n;
    for (size_t k = 0; k < n; k++)
        most = (size_t)fmb_system_dim(s[k]) > most ? (size_t)fmb_system_dim(s[k]) : most;
    int *weight = fmb_mem_get(&lift->mem, n, sizeof *weight);
    fmb_status st = open_lifted_row(&r, lift, most + 1);
    if (st == FMB_OK && !weight)
        st = fmb_mem_status(&lift->mem);
    fmb_status opened = fmb_lift_open_copies(&c, lift, like, s, n);
    st = st == FMB_OK ? opened : st;
    FMB_THEN(st, append_weighted_systems(&c, lift, &r, weight));
    fmb_lift_close_copies(&c, lift);
    close_lifted_row(&r, lift);
    fmb_mem_put(&lift->mem, weight, n, sizeof *weight);
    return st;
}

/* ---- of vertices, rays and lines ------------------------------------------------------------- */

/* x_j = the sum of the j-th coordinates of the generators, each times its weight. */
static fmb_status append_coordinate(lifted_row *r, fmb_system *lift, const fmb_generators *g, int j,
                                    const int *weight)
{
    mpq_set_si(next_term(r, j), -1, 1);
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        fmb_generators_coordinate_q(g, i, j, next_term(r, weight[i]));
    return append_lifted_row(r, lift, FMB_EQ);
}

/* vertex[] = the weights of vertices, whose sum is 1. */
static fmb_status append_combination(lifted_row *r, fmb_system *lift, const fmb_generators *g,
                                     const int *weight, int *vertex)
{
    size_t vertices = 0;
    for (int j = 0; j < fmb_generators_dim(g); j++)
        FMB_TRY(append_coordinate(r, lift, g, j, weight));
    for (size_t i = 0; i < fmb_generators_size(g); i++) {
        if (fmb_generators_kind(g, i) == FMB_VERTEX)
            vertex[vertices++] = weight[i];
        if (fmb_generators_kind(g, i) != FMB_LINE)
            FMB_TRY(append_nonnegative(r, lift, weight[i]));
    }
    return append_total(r, lift, vertex, vertices);
}

static fmb_status lift_generators(fmb_system *lift, const fmb_generators *g, const fmb_system *like)
{
    static const char *const WEIGHT[] = {
        [FMB_VERTEX] = "vertex", [FMB_RAY] = "ray", [FMB_LINE] = "line"};
    size_t n = fmb_generators_size(g);
    lifted_row r;
    int *weight = fmb_mem_get(&lift->mem, n, sizeof *weight);
    int *vertex = fmb_mem_get(&lift->mem, n, sizeof *vertex);
    fmb_status st = open_lifted_row(&r, lift, n + 1);
    if (st == FMB_OK && (!weight || !vertex))
        st = fmb_mem_status(&lift->mem);
    FMB_THEN(st, fmb_lift_add_answer(lift, like));
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        st = fmb_lift_add_fresh(lift, WEIGHT[fmb_generators_kind(g, i)], i + 1, &weight[i]);
    FMB_THEN(st, append_combination(&r, lift, g, weight, vertex));
    close_lifted_row(&r, lift);
    fmb_mem_put(&lift->mem, vertex, n, sizeof *vertex);
    fmb_mem_put(&lift->mem, weight, n, sizeof *weight);
    return st;
}

fmb_status fmb_lift_generators(const fmb_generators *g, const fmb_system *like, fmb_system **out)
{
    fmb_system *lift = NULL, *plain = NULL;
    if (!g || !out || (like && fmb_lift_dim(like) != fmb_generators_dim(g)))
        return FMB_ERR_ARG;
    fmb_status st = fmb_system_new(0, &g->mem.alloc, &lift);
    if (st == FMB_OK && !like)
        st = fmb_system_new(fmb_generators_dim(g), &g->mem.alloc, &plain);
    FMB_THEN(st, lift_generators(lift, g, like ? like : plain));
    fmb_system_free(plain);
    if (st == FMB_OK)
        *out = lift;
    else
        fmb_system_free(lift);
    return st;
}
