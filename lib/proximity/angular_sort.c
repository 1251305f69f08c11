/* angular_sort.c: vertices of a polygon in their order around it; see angular_sort.h.
 *
 * Seen from a coordinate plane where it has an area, a convex polygon keeps the order of its
 * vertices. Around one of them, o, the others lie within less than half a turn, so "b is to the
 * left of the line from o to a" sorts them; no two lie in one direction, as vertices do not.
 */
#include "proximity/angular_sort.h"

#include "num/rationals.h"
#include "system/generators_private.h"

typedef struct common_polygon {
    size_t n, dim;
    mpq_t *x;      /* [n][dim] */
    size_t *order; /* [n] */
    size_t a, b;   /* the coordinate plane of the projection */
    mpq_t t[3];    /* scratch */
} common_polygon;

static mpq_t *vertex_of(const common_polygon *p, size_t i)
{
    return p->x + i * p->dim;
}

/* Twice the signed area of the triangle of vertices o, i and k in coordinates a and b; its sign. */
static int area_sign(common_polygon *p, size_t o, size_t i, size_t k, size_t a, size_t b, mpq_t out)
{
    mpq_t *v[3] = {vertex_of(p, o), vertex_of(p, i), vertex_of(p, k)};
    mpq_sub(p->t[0], v[1][a], v[0][a]);
    mpq_sub(p->t[1], v[2][b], v[0][b]);
    mpq_mul(out, p->t[0], p->t[1]);
    mpq_sub(p->t[0], v[1][b], v[0][b]);
    mpq_sub(p->t[1], v[2][a], v[0][a]);
    mpq_mul(p->t[0], p->t[0], p->t[1]);
    mpq_sub(out, out, p->t[0]);
    return mpq_sgn(out);
}

/* Vertices 0, 1, 2 are never in line: some pair of coordinates shows that. */
static bool find_view(common_polygon *p)
{
    for (p->a = 0; p->a < p->dim; p->a++)
        for (p->b = p->a + 1; p->b < p->dim; p->b++)
            if (area_sign(p, 0, 1, 2, p->a, p->b, p->t[2]) != 0)
                return true;
    return false;
}

/* Is vertex k in the plane of 0, 1, 2? Then each of its coordinates c is the same affine form of a
 * and b as theirs: (area of 0 1 2) (c_k - c_0) = (area of 0 k 2) (c_1 - c_0) + (area of 0 1 k)
 * (c_2 - c_0). */
static bool is_in_plane(common_polygon *p, size_t k, mpq_t *scratch)
{
    bool in = true;
    mpq_t *v = vertex_of(p, 0);
    for (size_t c = 0; in && c < p->dim; c++) {
        const size_t triangle[3][3] = {{1, 2, k}, {k, 2, 1}, {1, k, 2}};
        for (int i = 0; i < 3; i++) {
            area_sign(p, 0, triangle[i][0], triangle[i][1], p->a, p->b, scratch[i]);
            mpq_sub(p->t[0], vertex_of(p, triangle[i][2])[c], v[c]);
            mpq_mul(scratch[i], scratch[i], p->t[0]);
        }
        mpq_sub(scratch[0], scratch[0], scratch[1]);
        in = mpq_equal(scratch[0], scratch[2]);
    }
    return in;
}

static bool are_in_plane(common_polygon *p)
{
    mpq_t scratch[3];
    bool in = true;
    mpq_inits(scratch[0], scratch[1], scratch[2], NULL);
    for (size_t k = 3; in && k < p->n; k++)
        in = is_in_plane(p, k, scratch);
    mpq_clears(scratch[0], scratch[1], scratch[2], NULL);
    return in;
}

/* By insertion: polygons are short. */
static void sort_by_angle(common_polygon *p)
{
    for (size_t i = 0; i < p->n; i++)
        p->order[i] = i;
    for (size_t i = 2; i < p->n; i++)
        for (size_t k = i;
             k > 1 && area_sign(p, 0, p->order[k - 1], p->order[k], p->a, p->b, p->t[2]) < 0; k--) {
            size_t other = p->order[k];
            p->order[k] = p->order[k - 1];
            p->order[k - 1] = other;
        }
}

/* [give] The vertices in that order. */
static fmb_status write_in_order(common_polygon *p, const fmb_alloc *mem, fmb_generators **out)
{
    fmb_generators *g = NULL;
    fmb_status st = fmb_generators_new((int)p->dim, mem, &g);
    for (size_t i = 0; st == FMB_OK && i < p->n; i++)
        st = fmb_generators_add_q(g, FMB_VERTEX, vertex_of(p, p->order[i]));
    if (st == FMB_OK)
        *out = g;
    else
        fmb_generators_free(g);
    return st;
}

static fmb_status sort_vertices(common_polygon *p, fmb_generators **g, const fmb_alloc *mem)
{
    fmb_generators *sorted = NULL;
    for (size_t i = 0; i < p->n * p->dim; i++)
        fmb_generators_coordinate_q(*g, i / p->dim, (int)(i % p->dim), p->x[i]);
    if (!find_view(p) || !are_in_plane(p))
        return FMB_OK;
    sort_by_angle(p);
    FMB_TRY(write_in_order(p, mem, &sorted));
    fmb_generators_free(*g);
    *g = sorted;
    return FMB_OK;
}

fmb_status fmb_angular_sort(fmb_generators **g, fmb_mem *mem)
{
    common_polygon p = {.n = fmb_generators_size(*g), .dim = (size_t)fmb_generators_dim(*g)};
    if (p.n < 4 || p.dim < 2)
        return FMB_OK;
    mpq_inits(p.t[0], p.t[1], p.t[2], NULL);
    fmb_status st = fmb_rationals_new(&p.x, p.n * p.dim, mem);
    p.order = fmb_mem_get(mem, p.n, sizeof *p.order);
    FMB_THEN(st, p.order ? sort_vertices(&p, g, &mem->alloc) : fmb_mem_status(mem));
    fmb_mem_put(mem, p.order, p.n, sizeof *p.order);
    fmb_rationals_free(p.x, p.n * p.dim, mem);
    mpq_clears(p.t[0], p.t[1], p.t[2], NULL);
    return st;
}
