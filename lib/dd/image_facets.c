/* image_facets.c: the rows of an image; see image.h.
 *
 * They are the facets of the cone that its rays and lines span. In few coordinates rays come one
 * after another to the facets so far (facets.h), those farthest beyond one of them first, as
 * quickhull has it; a guess in doubles, as in the end every ray comes. Else they are the rays of
 * the dual cone, whose rows are the rays of the image in lexicographic order.
 */
#include <math.h>
#include <string.h>

#include "dd/facets.h"
#include "dd/image.h"

/* With more coordinates, rays often are on very many facets. */
#define FEW_COORDINATES 7

/* ---- what is above a facet ------------------------------------------------------------------- */

static void add_to_slack(fmb_image *m, uint64_t *to, const uint64_t *from)
{
    for (size_t k = 0; k < m->words; k++)
        to[k] |= from[k];
}

/* y.(x, t) >= 0 as a.x <= b. */
static void turn_to_row(fmb_vec *v, size_t n)
{
    for (size_t k = 0; k + 1 < n; k++) {
        if (v->z)
            mpz_neg(v->z[k], v->z[k]);
        else
            v->s[k] = -v->s[k];
    }
}

/* Unite the supports above the facet. */
static fmb_status look_above_facet(fmb_image *m, fmb_image_row *f)
{
    f->slack = fmb_arena_get(&m->arena, m->words, sizeof *f->slack);
    if (!f->slack)
        return fmb_mem_status(m->run->mem);
    memcpy(f->slack, m->everywhere, m->words * sizeof *f->slack);
    for (size_t i = 0; i < m->rays; i++)
        if (fmb_image_side(m, f, &m->ray[i]) == 0)
            add_to_slack(m, f->slack, m->support[i]);
    return fmb_run_poll(m->run);
}

/* y.(x, t) >= 0, or = 0, is a row of the image. */
static fmb_status add_facet(fmb_image *m, const fmb_vec *y, bool equality, bool slacks)
{
    fmb_status st = fmb_mem_reserve(m->run->mem, (void **)&m->facet, &m->facet_capacity,
                                    m->facets + 1, sizeof *m->facet);
    if (st != FMB_OK)
        return st;
    fmb_image_row *f = &m->facet[m->facets++];
    *f = (fmb_image_row){.equality = equality};
    st = fmb_image_copy_coordinates(m, &f->v, y);
    if (st != FMB_OK)
        return st;
    turn_to_row(&f->v, m->n);
    return slacks ? look_above_facet(m, f) : FMB_OK;
}

/* ---- ray by ray -------------------------------------------------------------------------------
 */

typedef struct ray_by_ray {
    fmb_image *m;
    fmb_facets facets;
    double *near; /* [rays][n] roughly the rays: points at t = 1, directions of length 1 */
    mpz_t *z;     /* [n] scratch */
} ray_by_ray;

static fmb_status add_generator(ray_by_ray *h, const fmb_vec *v, int sign, bool *grown)
{
    size_t n = h->m->n;
    for (size_t k = 0; k < n; k++) {
        fmb_vec_get(v, k, h->z[k]);
        if (sign < 0)
            mpz_neg(h->z[k], h->z[k]);
    }
    fmb_status st = fmb_run_poll(h->m->run);
    return st == FMB_OK ? fmb_facets_add(&h->facets, h->z, grown) : st;
}

static double entry_as_double(const fmb_vec *v, size_t k)
{
    return v->z ? mpz_get_d(v->z[k]) : (double)v->s[k];
}

static void round_rays(ray_by_ray *h)
{
    size_t n = h->m->n;
    for (size_t i = 0; i < h->m->rays; i++) {
        const fmb_vec *v = &h->m->ray[i];
        double *x = h->near + i * n, size = entry_as_double(v, n - 1);
        for (size_t k = 0; fmb_vec_sgn(v, n - 1) == 0 && k < n; k++)
            size = fmax(size, fabs(entry_as_double(v, k)));
        for (size_t k = 0; k < n; k++)
            x[k] = entry_as_double(v, k) / size;
    }
}

/* The ray with the least product with a. */
static size_t find_farthest_ray(const ray_by_ray *h, const double *a, double *least)
{
    size_t n = h->m->n, best = 0;
    *least = INFINITY;
    for (size_t i = 0; i < h->m->rays; i++) {
        const double *x = h->near + i * n;
        double sum = 0;
        for (size_t k = 0; k < n; k++)
            sum += a[k] * x[k];
        if (sum < *least) {
            *least = sum;
            best = i;
        }
    }
    return best;
}

/* The rays farthest out both ways in each coordinate. */
static fmb_status add_outermost_rays(ray_by_ray *h)
{
    double a[FEW_COORDINATES] = {0}, least;
    bool grown;
    fmb_status st = FMB_OK;
    for (size_t k = 0; k < h->m->n; k++) {
        for (int sign = -1; st == FMB_OK && sign <= 1; sign += 2) {
            a[k] = sign;
            st = add_generator(h, &h->m->ray[find_farthest_ray(h, a, &least)], 1, &grown);
        }
        a[k] = 0;
    }
    return st;
}

/* What is farthest beyond each facet, until nothing seems to be. */
static fmb_status add_rays_beyond_facets(ray_by_ray *h)
{
    fmb_facets *f = &h->facets;
    bool any = true, grown;
    fmb_status st = FMB_OK;
    while (any) {
        any = false;
        for (size_t i = 0; st == FMB_OK && i < f->slots; i++) {
            double least;
            if (!f->facet[i].alive || f->facet[i].note)
                continue;
            size_t ray = find_farthest_ray(h, f->facet[i].roughly, &least);
            f->facet[i].note = 1;
            if (least < 0)
                st = add_generator(h, &h->m->ray[ray], 1, &grown);
            any |= least < 0 && grown;
        }
        any &= st == FMB_OK;
    }
    return st;
}

static fmb_status add_all_rays(ray_by_ray *h)
{
    const fmb_image *m = h->m;
    bool grown;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < 2 * m->lines; i++)
        st = add_generator(h, &m->line[i / 2], i % 2 ? 1 : -1, &grown);
    if (st == FMB_OK)
        st = add_outermost_rays(h);
    if (st == FMB_OK)
        st = add_rays_beyond_facets(h);
    for (size_t i = 0; st == FMB_OK && i < m->rays; i++)
        st = add_generator(h, &m->ray[i], 1, &grown);
    return st;
}

/* Or is it the face at infinity? Whatever spans it is among the generators that are known on it. */
static bool holds_facet_a_point(const fmb_facets *f, const fmb_facet *a)
{
    for (size_t i = 0; i < f->generators; i++)
        if (fmb_facet_holds(a, i) && fmb_vec_sgn(&f->generator[i], f->d - 1) > 0)
            return true;
    return false;
}

static fmb_status find_facets_ray_by_ray(fmb_image *m, bool slacks)
{
    ray_by_ray h = {.m = m};
    fmb_mem *mem = m->run->mem;
    fmb_status st = fmb_facets_init(&h.facets, m->run, m->n);
    h.near = fmb_mem_get(mem, m->rays * m->n, sizeof *h.near);
    h.z = fmb_vec_block(m->n, mem);
    if (st == FMB_OK && (!h.near || !h.z))
        st = fmb_mem_status(mem);
    if (st == FMB_OK)
        round_rays(&h);
    if (st == FMB_OK)
        st = add_all_rays(&h);
    for (size_t e = 0; st == FMB_OK && e < m->n - h.facets.rank; e++)
        st = add_facet(m, &h.facets.equation[e], true, slacks);
    for (size_t i = 0; st == FMB_OK && i < h.facets.slots; i++)
        if (h.facets.facet[i].alive && holds_facet_a_point(&h.facets, &h.facets.facet[i]))
            st = add_facet(m, &h.facets.facet[i].normal, false, slacks);
    for (size_t k = 0; h.z && k < m->n; k++)
        mpz_clear(h.z[k]);
    fmb_mem_put(mem, h.z, m->n, sizeof *h.z);
    fmb_mem_put(mem, h.near, m->rays * m->n, sizeof *h.near);
    fmb_facets_clear(&h.facets);
    return st;
}

/* ---- all at once ------------------------------------------------------------------------------
 */

/* The same of a ray of the dual: rows left out of supports are implied by others. */
static bool holds_dual_ray_a_point(const fmb_image *m, const fmb_cone *dual, size_t i)
{
    for (size_t b = 0; b < dual->bits; b++)
        if (!fmb_cone_is_positive(dual, i, b) &&
            fmb_vec_sgn(dual->of.row[dual->row_of_bit[b]].v, m->n - 1) > 0)
            return true;
    return false;
}

static fmb_status take_facets_of_dual(fmb_image *m, const fmb_cone *dual, bool slacks)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < dual->line.size; i++)
        st = add_facet(m, &dual->line.v[i], true, slacks);
    for (size_t i = 0; st == FMB_OK && i < dual->ray.size; i++)
        if (holds_dual_ray_a_point(m, dual, i))
            st = add_facet(m, &dual->ray.v[i], false, slacks);
    return st;
}

/* The rows of the dual cone: lines are equalities; rays come in lexicographic order. */
static fmb_status find_facets_as_dual_rays(fmb_image *m, bool slacks)
{
    size_t rows = m->lines + m->rays;
    fmb_cone dual = {0};
    fmb_cone_row *row = fmb_mem_get(m->run->mem, rows, sizeof *row);
    if (!row)
        return fmb_mem_status(m->run->mem);
    for (size_t i = 0; i < m->lines; i++)
        row[i] = (fmb_cone_row){.v = &m->line[i], .equality = true};
    for (size_t i = 0; i < m->rays; i++)
        row[m->lines + i] = (fmb_cone_row){.v = &m->ray[i]};
    fmb_cone_problem of = {.d = m->n, .m = rows, .row = row, .wide_only = m->num.wide_only};
    bool done;
    fmb_status st = fmb_cone_init(&dual, m->run, &of);
    if (st == FMB_OK)
        st = fmb_cone_run(&dual, 0, &done);
    if (st == FMB_OK)
        st = take_facets_of_dual(m, &dual, slacks);
    fmb_cone_clear(&dual);
    fmb_mem_put(m->run->mem, row, rows, sizeof *row);
    return st;
}

fmb_status fmb_image_find_facets(fmb_image *m, bool slacks)
{
    return m->n <= FEW_COORDINATES ? find_facets_ray_by_ray(m, slacks)
                                   : find_facets_as_dual_rays(m, slacks);
}
