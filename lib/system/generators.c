/* generators.c: lists of vertices, rays and lines; see generators_private.h. */
#include "system/generators_private.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "num/rationals.h"

fmb_status fmb_generators_new(int dim, const fmb_alloc *hook, fmb_generators **out)
{
    fmb_mem mem;
    if (dim < 0 || !out)
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, hook, 0);
    fmb_generators *g;
    FMB_TRY(FMB_GET_ZERO(&mem, g, 1));
    g->mem = mem;
    g->dim = dim;
    *out = g;
    return FMB_OK;
}

void fmb_generators_free(fmb_generators *g)
{
    if (!g)
        return;
    size_t n = (size_t)g->dim + 1;
    for (size_t i = 0; i < g->size; i++) {
        fmb_vec_clear(&g->vec[i], n, &g->mem);
        fmb_mem_put(&g->mem, g->vec[i].s, n, sizeof *g->vec[i].s);
    }
    fmb_mem_put(&g->mem, g->vec, g->vec_capacity, sizeof *g->vec);
    fmb_mem_put(&g->mem, g->kind, g->kind_capacity, sizeof *g->kind);
    fmb_mem mem = g->mem;
    fmb_mem_put(&mem, g, 1, sizeof *g);
}

/* ---- one more -------------------------------------------------------------------------------- */

/* Memory for one more generator, which is counted. */
static fmb_status open_generator(fmb_generators *g, fmb_generator_kind kind, fmb_vec **out)
{
    FMB_TRY(FMB_RESERVE(&g->mem, &g->vec, &g->vec_capacity, g->size + 1));
    FMB_TRY(FMB_RESERVE(&g->mem, &g->kind, &g->kind_capacity, g->size + 1));
    fmb_vec v = {.s = fmb_mem_get(&g->mem, (size_t)g->dim + 1, sizeof *v.s)};
    if (!v.s)
        return fmb_mem_status(&g->mem);
    *out = &g->vec[g->size];
    **out = v;
    g->kind[g->size++] = kind;
    return FMB_OK;
}

static fmb_status close_generator(fmb_generators *g, fmb_status st)
{
    if (st == FMB_OK)
        return st;
    fmb_vec *v = &g->vec[--g->size];
    fmb_vec_clear(v, (size_t)g->dim + 1, &g->mem);
    fmb_mem_put(&g->mem, v->s, (size_t)g->dim + 1, sizeof *v->s);
    return st;
}

fmb_status fmb_generators_append(fmb_generators *g, fmb_generator_kind kind, const fmb_vec *v)
{
    fmb_vec *to = NULL;
    FMB_TRY(open_generator(g, kind, &to));
    return close_generator(g, fmb_vec_copy(to, v, (size_t)g->dim + 1, &g->mem));
}

/* z[dim + 1] = x times its least common denominator, which is t for a vertex. */
static void write_common_multiple(const fmb_generators *g, fmb_generator_kind kind, mpq_t *x,
                                  mpz_t *z)
{
    size_t n = (size_t)g->dim;
    mpz_set_ui(z[n], 1);
    for (size_t j = 0; j < n; j++)
        mpz_lcm(z[n], z[n], mpq_denref(x[j]));
    for (size_t j = 0; j < n; j++) {
        mpz_divexact(z[j], z[n], mpq_denref(x[j]));
        mpz_mul(z[j], z[j], mpq_numref(x[j]));
    }
    if (kind != FMB_VERTEX)
        mpz_set_ui(z[n], 0);
}

__attribute__((format(printf, 2, 3))) static fmb_status refuse_generator(fmb_generators *g,
                                                                         const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(g->error, sizeof g->error, format, list);
    va_end(list);
    return FMB_ERR_ARG;
}

static fmb_status expect_generator_arguments(fmb_generators *g, fmb_generator_kind kind,
                                             const void *x)
{
    if (!g)
        return FMB_ERR_ARG;
    g->error[0] = '\0';
    if (!x && g->dim > 0)
        return refuse_generator(g, "x is NULL");
    if ((unsigned)kind > FMB_LINE)
        return refuse_generator(g, "kind is %d, which is none", (int)kind);
    return FMB_OK;
}

const char *fmb_generators_trouble(const fmb_generators *g)
{
    return g ? g->error : "";
}

fmb_status fmb_generators_add_q(fmb_generators *g, fmb_generator_kind kind, mpq_t *x)
{
    fmb_status st = expect_generator_arguments(g, kind, x);
    for (int j = 0; st == FMB_OK && j < g->dim; j++)
        if (mpz_sgn(mpq_denref(x[j])) == 0)
            st = refuse_generator(g, "x[%d] has denominator 0", j);
    if (st != FMB_OK)
        return st;
    size_t n = (size_t)g->dim + 1;
    fmb_vec *v = NULL;
    mpz_t *z = fmb_vec_block(n, &g->mem);
    st = z ? open_generator(g, kind, &v) : FMB_ERR_MEMORY;
    if (st == FMB_OK) {
        write_common_multiple(g, kind, x, z);
        st = close_generator(g, fmb_vec_set_z(v, n, z, &g->mem));
    }
    fmb_vec_block_free(z, n, &g->mem);
    return st;
}

fmb_status fmb_generators_add(fmb_generators *g, fmb_generator_kind kind, const double *x)
{
    mpq_t *q;
    fmb_status st = expect_generator_arguments(g, kind, x);
    for (int j = 0; st == FMB_OK && j < g->dim; j++)
        if (!isfinite(x[j]))
            st = refuse_generator(g, "x[%d] is %g", j, x[j]);
    if (st != FMB_OK)
        return st;
    st = fmb_rationals_new(&q, (size_t)g->dim, &g->mem);
    if (st != FMB_OK)
        return st;
    for (int j = 0; j < g->dim; j++)
        mpq_set_d(q[j], x[j]);
    st = fmb_generators_add_q(g, kind, q);
    fmb_rationals_free(q, (size_t)g->dim, &g->mem);
    return st;
}

/* ---- reading --------------------------------------------------------------------------------- */

int fmb_generators_dim(const fmb_generators *g)
{
    return g ? g->dim : 0;
}

size_t fmb_generators_size(const fmb_generators *g)
{
    return g ? g->size : 0;
}

fmb_generator_kind fmb_generators_kind(const fmb_generators *g, size_t i)
{
    return i < fmb_generators_size(g) ? g->kind[i] : FMB_VERTEX;
}

void fmb_generators_coordinate_q(const fmb_generators *g, size_t i, int j, mpq_t out)
{
    if (!out)
        return;
    mpq_set_ui(out, 0, 1);
    if (i >= fmb_generators_size(g) || j < 0 || j >= g->dim)
        return;
    fmb_vec_get(&g->vec[i], (size_t)j, mpq_numref(out));
    if (g->kind[i] != FMB_VERTEX)
        return;
    fmb_vec_get(&g->vec[i], (size_t)g->dim, mpq_denref(out));
    mpq_canonicalize(out);
}

double fmb_generators_coordinate(const fmb_generators *g, size_t i, int j)
{
    if (i >= fmb_generators_size(g) || j < 0 || j >= g->dim)
        return 0;
    double x;
    const fmb_vec *v = &g->vec[i];
    int64_t den = fmb_vec_is_wide(v) || g->kind[i] != FMB_VERTEX ? 1 : v->s[g->dim];
    if (!fmb_vec_is_wide(v) && fmb_nearest_quotient(v->s[j], den, &x))
        return x;
    mpq_t q;
    mpq_init(q);
    fmb_generators_coordinate_q(g, i, j, q);
    x = fmb_nearest_double(q);
    mpq_clear(q);
    return x;
}

size_t fmb_generators_coordinate_text(const fmb_generators *g, size_t i, int j, char *text,
                                      size_t size)
{
    mpq_t q;
    mpq_init(q);
    fmb_generators_coordinate_q(g, i, j, q);
    size_t length = fmb_rational_print(q, text, size);
    mpq_clear(q);
    return length;
}

fmb_status fmb_generators_get(const fmb_generators *g, size_t first, size_t n,
                              fmb_generator_kind *kind, double *x)
{
    if (!g || first > g->size || n > g->size - first)
        return FMB_ERR_ARG;
    for (size_t i = first; i < first + n; i++) {
        if (kind)
            *kind++ = g->kind[i];
        for (int j = 0; x && j < g->dim; j++)
            *x++ = fmb_generators_coordinate(g, i, j);
    }
    return FMB_OK;
}
