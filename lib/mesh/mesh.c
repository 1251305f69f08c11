/* mesh.c: a mesh from arrays; see fmb/mesh.h. */
#include "mesh/mesh_private.h"

#include <gmp.h>
#include <math.h>
#include <string.h>

#include "base/arrays.h"

/* ---- equal points ---------------------------------------------------------------------------- */

/* A hash table of points, with open addressing; UINT32_MAX: an empty slot. */
typedef struct point_table {
    uint32_t *slot;
    size_t size; /* a power of two */
} point_table;

/* Multiplicative hashing of the bits, with -0 as 0: the highest bits of a product depend on all. */
static uint64_t hash_point(const double *p)
{
    static const uint64_t odd[3] = {UINT64_C(0x9E3779B97F4A7C15), UINT64_C(0xBF58476D1CE4E5B9),
                                    UINT64_C(0x94D049BB133111EB)};
    uint64_t h = 0;
    for (int j = 0; j < 3; j++) {
        double x = p[j] + 0.0;
        uint64_t bits;
        memcpy(&bits, &x, sizeof bits);
        h += bits * odd[j];
    }
    return (h ^ h >> 32) * odd[0] >> 32;
}

static bool are_equal_points(const double *p, const double *q)
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* The first vertex at the point of vertex v of m; v + offset if v is the first. Numbers below
 * `offset` are vertices of `other`. */
static uint32_t find_or_enter_point(point_table *t, const fmb_mesh *m, const fmb_mesh *other,
                                    size_t v, size_t offset)
{
    const double *p = m->point + 3 * v;
    size_t at = (size_t)hash_point(p) & (t->size - 1);
    for (; t->slot[at] != UINT32_MAX; at = (at + 1) & (t->size - 1)) {
        uint32_t id = t->slot[at];
        const double *q =
            id < offset ? other->point + 3 * (size_t)id : m->point + 3 * (id - offset);
        if (are_equal_points(p, q))
            return id;
    }
    return t->slot[at] = (uint32_t)(v + offset);
}

enum { SMALL_TABLE = 64 };

fmb_status fmb_mesh_find_same(const fmb_mesh *m, const fmb_mesh *other, fmb_mem *mem, uint32_t *out)
{
    uint32_t small[SMALL_TABLE];
    size_t offset = other ? other->vertices : 0;
    point_table t = {small, 8};
    while (t.size < 2 * (m->vertices + offset))
        t.size *= 2;
    if (t.size > SMALL_TABLE)
        FMB_TRY(FMB_GET(mem, t.slot, t.size));
    memset(t.slot, 0xff, t.size * sizeof *t.slot);
    for (size_t v = 0; v < offset; v++)
        find_or_enter_point(&t, other, NULL, v, 0);
    for (size_t v = 0; v < m->vertices; v++)
        out[v] = find_or_enter_point(&t, m, other, v, offset);
    if (t.size > SMALL_TABLE)
        fmb_mem_put(mem, t.slot, t.size, sizeof *t.slot);
    return FMB_OK;
}

/* ---- cells ----------------------------------------------------------------------------------- */

/* Entry j of difference k of corners as an integer multiple of 2^-1074; it is below 2^1025. */
static void set_difference(mpz_t out, const fmb_cell *c, int k, int j)
{
    mpq_t x, y;
    mpq_inits(x, y, NULL);
    mpq_set_d(x, c->point[k + 1][j]);
    mpq_set_d(y, c->point[0][j]);
    mpq_sub(x, x, y);
    mpq_mul_2exp(x, x, 1074);
    mpz_set(out, mpq_numref(x));
    mpq_clears(x, y, NULL);
}

/* Are the differences linearly dependent? Decided by fraction-free elimination. */
static bool is_flat_at_any_size(const fmb_cell *c)
{
    mpz_t e[3][3];
    int n = c->corners - 1, rank = 0;
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            mpz_init(e[k][j]);
    for (int k = 0; k < n; k++)
        for (int j = 0; j < 3; j++)
            set_difference(e[k][j], c, k, j);
    for (int j = 0; j < 3 && rank < n; j++) {
        int p = rank;
        while (p < n && mpz_sgn(e[p][j]) == 0)
            p++;
        if (p == n)
            continue;
        for (int i = 0; i < 3; i++)
            mpz_swap(e[p][i], e[rank][i]);
        for (int k = rank + 1; k < n; k++)
            for (int i = 2; i >= j; i--) {
                mpz_mul(e[k][i], e[k][i], e[rank][j]);
                mpz_submul(e[k][i], e[k][j], e[rank][i]);
            }
        rank++;
    }
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            mpz_clear(e[k][j]);
    return rank < n;
}

/* Does a projection of a tame triangle certainly have an area (see fmb_sign_of_turn)? */
static bool has_clear_area(const fmb_mesh *m, const uint32_t *corner)
{
    const double *point = m->point;
    fmb_triangle_plane h =
        fmb_triangle_plane_of(point + 3 * (size_t)corner[0], point + 3 * (size_t)corner[1],
                              point + 3 * (size_t)corner[2]);
    bool clear = false;
    for (int k = 0; k < 3; k++)
        clear |= fabs(h.normal[k]) > 0x1p-51 * h.size[k];
    return clear;
}

static uint8_t faults_of_cell(const fmb_mesh *m, size_t i)
{
    fmb_cell c = fmb_mesh_cell_of(m, m->same, i);
    bool tame = fmb_cell_is_tame(&c), flat = tame ? fmb_cell_is_flat(&c) : is_flat_at_any_size(&c);
    return (uint8_t)((tame ? 0 : FMB_MESH_WILD) | (flat ? FMB_MESH_FLAT : 0));
}

/* tame: all coordinates are. */
static void look_at_cells(fmb_mesh *m, bool tame)
{
    tame = tame && m->corners == 3;
    for (size_t i = 0; i < m->cells; i++)
        m->faults[i] = tame && has_clear_area(m, m->corner + 3 * i) ? 0 : faults_of_cell(m, i);
}

/* ---- life ------------------------------------------------------------------------------------ */

/* As whole numbers, to be vectorized. */
static bool are_tame(const double *x, size_t n)
{
    int64_t wild = 0;
    for (size_t i = 0; i < n; i++)
        wild |= !fmb_is_tame(x[i]);
    return wild == 0;
}

static bool are_finite(const double *x, size_t n)
{
    size_t i = 0;
    while (i < n && isfinite(x[i]))
        i++;
    return i == n;
}

static bool are_below(uint32_t end, const uint32_t *x, size_t n)
{
    uint32_t beyond = 0;
    for (size_t i = 0; i < n; i++)
        beyond |= x[i] >= end;
    return beyond == 0;
}

/* *tame: see look_at_cells. */
static bool are_mesh_arguments(int corners, size_t vertices, const double *point, size_t cells,
                               const uint32_t *corner, bool *tame)
{
    bool good = (corners == 3 || corners == 4) && vertices <= FMB_MESH_MOST &&
                cells <= FMB_MESH_MOST && (point || vertices == 0) && (corner || cells == 0);
    *tame = good && are_tame(point, 3 * vertices);
    return good && (*tame || are_finite(point, 3 * vertices)) &&
           are_below((uint32_t)vertices, corner, (size_t)corners * cells);
}

/* Copy an array to its place `to`; returns that, or NULL if there is no array. */
static void *copy_array(void *to, const void *from, size_t bytes)
{
    return from && bytes > 0 ? memcpy(to, from, bytes) : from ? to : NULL;
}

/* [give] A mesh with its arrays in one block, which is all that its mem counts; those from a file
 * are copied, the others are not filled. Errors: MEMORY. */
static fmb_status allocate_mesh(int corners, size_t vertices, size_t cells,
                                const fmb_mesh_origin *from, const fmb_alloc *hook, fmb_mesh **out)
{
    const size_t n = cells * (size_t)corners, names = from->group ? from->names_size : 0;
    fmb_mesh *m;
    fmb_mem mem;
    double *point;
    fmb_mesh_box *box;
    fmb_mesh_node *node;
    uint32_t *number;
    uint8_t *byte;
    fmb_mem_init(&mem, hook, 0);
    FMB_TRY(FMB_ARRAYS_IN_BLOCK(&mem, true, FMB_ARRAY(m, 1), FMB_ARRAY(point, 3 * vertices),
                                FMB_ARRAY(box, cells), FMB_ARRAY(node, fmb_mesh_most_nodes(cells)),
                                FMB_ARRAY(number, n + vertices + 3 * cells),
                                FMB_ARRAY(byte, cells + names)));
    uint32_t *order = number + n + vertices, *face = order + cells;
    *m = (fmb_mesh){
        .mem = mem,
        .corners = corners,
        .vertices = vertices,
        .cells = cells,
        .point = point,
        .same = number + n,
        .corner = number,
        .face = copy_array(face, from->face, cells * sizeof *face),
        .group = copy_array(face + cells, from->group, cells * sizeof *face),
        .names = copy_array(byte + cells, from->group ? from->names : NULL, names),
        .names_size = from->names_size,
        .faults = byte,
        .order = order,
        .box = box,
        .node = node,
    };
    *out = m;
    return FMB_OK;
}

fmb_status fmb_mesh_new_of_file(int corners, size_t vertices, const double *point, size_t cells,
                                const uint32_t *corner, const fmb_mesh_origin *origin,
                                const fmb_alloc *hook, fmb_mesh **out)
{
    fmb_mesh *m;
    bool tame;
    if (!out || !are_mesh_arguments(corners, vertices, point, cells, corner, &tame))
        return FMB_ERR_ARG;
    FMB_TRY(allocate_mesh(corners, vertices, cells, origin, hook, &m));
    copy_array(m->point, point, 3 * vertices * sizeof *point);
    copy_array(m->corner, corner, cells * (size_t)corners * sizeof *corner);
    fmb_status st = fmb_mesh_find_same(m, NULL, &m->mem, m->same);
    if (st != FMB_OK) {
        fmb_mesh_free(m);
        return st;
    }
    look_at_cells(m, tame);
    fmb_mesh_grow_tree(m);
    *out = m;
    return FMB_OK;
}

fmb_status fmb_mesh_new(int corners, size_t vertices, const double *point, size_t cells,
                        const uint32_t *corner, const fmb_alloc *mem, fmb_mesh **out)
{
    return fmb_mesh_new_of_file(corners, vertices, point, cells, corner, &(fmb_mesh_origin){0}, mem,
                                out);
}

void fmb_mesh_free(fmb_mesh *m)
{
    if (!m)
        return;
    fmb_mem mem = m->mem;
    fmb_mem_put(&mem, m, mem.used, 1);
}

/* ---- placing --------------------------------------------------------------------------------- */

fmb_status fmb_mesh_placed(const fmb_mesh *m, const fmb_mesh_place *place, const fmb_alloc *hook,
                           fmb_mesh **out)
{
    fmb_mem mem;
    if (!m || !place || !out)
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, hook, 0);
    double *point;
    FMB_TRY(FMB_GET(&mem, point, 3 * m->vertices));
    for (size_t i = 0; i < 3 * m->vertices; i++)
        point[i] = fma(place->scale[i % 3], m->point[i], place->move[i % 3]);
    const fmb_mesh_origin origin = {m->face, m->group, m->names, m->names_size};
    fmb_status st = fmb_mesh_new_of_file(m->corners, m->vertices, point, m->cells, m->corner,
                                         &origin, hook, out);
    fmb_mem_put(&mem, point, 3 * m->vertices, sizeof *point);
    return st;
}

/* ---- what a mesh says of itself -------------------------------------------------------------- */

int fmb_mesh_corners(const fmb_mesh *m)
{
    return m ? m->corners : 0;
}

size_t fmb_mesh_vertices(const fmb_mesh *m)
{
    return m ? m->vertices : 0;
}

size_t fmb_mesh_cells(const fmb_mesh *m)
{
    return m ? m->cells : 0;
}

const double *fmb_mesh_points(const fmb_mesh *m)
{
    return m ? m->point : NULL;
}

const uint32_t *fmb_mesh_indices(const fmb_mesh *m)
{
    return m ? m->corner : NULL;
}

size_t fmb_mesh_face(const fmb_mesh *m, size_t c)
{
    return m && m->face && c < m->cells ? m->face[c] : m ? c : 0;
}

const char *fmb_mesh_group(const fmb_mesh *m, size_t c)
{
    return m && m->group && c < m->cells && m->group[c] > 0 ? m->names + m->group[c] : NULL;
}
