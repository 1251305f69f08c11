/* vertex.h: a basis, its vertex and its prices, exactly.
 *
 * The basis is n rows that hold with equality, or m + j for x_j = 0. Row i of the program has index
 * n + i in is_basic, the row x_j = 0 index j, since programs grow.
 */
#ifndef FMB_LP_VERTEX_H
#define FMB_LP_VERTEX_H

#include "lp/linalg/exact/factor.h"
#include "num/integers.h"

typedef struct fmb_vertex {
    fmb_run *run;
    const fmb_program *p;
    size_t n, m; /* m: the number of rows that `basis` assumes */
    fmb_factor *factor;
    size_t *basis;     /* [n] */
    bool *is_basic;    /* [n + m] */
    size_t marks;      /* room of is_basic */
    fmb_integers x, y; /* [n] vertex x / den; prices y / unit, by place */
    mpz_t den, unit;
    fmb_integers right; /* [n] scratch */
    double *roughly;    /* [n] x / den in doubles */
    bool set, solved;   /* there is a basis; x belongs to it */
    bool feasible;      /* x is known to satisfy the closure of every row */
    mpz_t sum;          /* scratch */
} fmb_vertex;

/* Errors: MEMORY, LIMIT. The caller must call fmb_vertex_clear even after an error. */
fmb_status fmb_vertex_init(fmb_vertex *v, fmb_run *run, const fmb_program *p);
void fmb_vertex_clear(fmb_vertex *v);
/* Adapt to rows appended to the program. */
fmb_status fmb_vertex_grow(fmb_vertex *v);

/* Use this basis[n], or a similar one if it is singular. */
fmb_status fmb_vertex_set(fmb_vertex *v, const size_t *basis);
/* Put row i at place r of the basis. */
fmb_status fmb_vertex_replace(fmb_vertex *v, size_t r, size_t i);
/* Solve for x. */
fmb_status fmb_vertex_solve(fmb_vertex *v);
/* Solve for prices y: sum_r y_r / unit (row r of the basis) = cost, cost[n] by column. */
fmb_status fmb_vertex_price(fmb_vertex *v, mpz_t *cost);
/* d[n] / den: the direction of x when the row at place r is left; its a.x falls by 1, or rises. */
fmb_status fmb_vertex_leave(fmb_vertex *v, size_t r, bool falls, fmb_integers *d, mpz_t den);

static inline bool fmb_vertex_is_unit(const fmb_vertex *v, size_t r)
{
    return v->basis[r] >= v->m;
}
/* Is the member at place r no row to satisfy, but x_j = 0 or a row that is off? */
static inline bool fmb_vertex_is_loose(const fmb_vertex *v, size_t r)
{
    return fmb_vertex_is_unit(v, r) || v->p->row[v->basis[r]].off;
}
static inline bool fmb_vertex_is_equality(const fmb_vertex *v, size_t r)
{
    return !fmb_vertex_is_loose(v, r) && v->p->row[v->basis[r]].rel == FMB_EQ;
}
static inline bool fmb_vertex_holds(const fmb_vertex *v, size_t row)
{
    return v->is_basic[v->n + row];
}

/* A row whose closure x violates: the deepest by doubles, or the first; SIZE_MAX: none. *sign: -1
 * if a.x is too small for an equality, else 1. */
fmb_status fmb_vertex_find_violated(fmb_vertex *v, bool first, size_t *row, int *sign);
/* Does the vertex satisfy every strict row strictly? */
bool fmb_vertex_is_inside(fmb_vertex *v);
/* Does the point x / den satisfy every row, strict rows strictly? roughly[n] is scratch.
 */
fmb_status fmb_vertex_try_point(fmb_vertex *v, mpz_t *x, const mpz_t den, double *roughly,
                                bool *holds);
/* Does the point x / den satisfy every strict row strictly? For a few points: computed exactly,
 * without polling. */
bool fmb_vertex_is_point_inside(fmb_vertex *v, mpz_t *x, const mpz_t den);
/* The price of place r times 2^exponent, rounded. */
double fmb_vertex_rough_price(const fmb_vertex *v, size_t r, int exponent);
/* b_i - a_i.x, rounded, of the row as it is in doubles (program.h). */
double fmb_vertex_slack(fmb_vertex *v, size_t i);
/* The sign of that, exactly. */
int fmb_vertex_slack_sign(fmb_vertex *v, size_t i);

#endif
