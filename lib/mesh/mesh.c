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

/* splitmix64 of the bits, with -0 as 0. */
static uint64_t hash_point(const double *p)
{
    uint64_t h = 0;
    for (int j = 0; j < 3; j++) {
        double x = p[j] + 0.0;
        uint64_t bits;
        memcpy(&bits, &x, sizeof bits);
        h = (h ^ bits) * UINT64_C(0x9E3779B97F4A7C15);
        h = (h ^ (h >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
        h ^= h >> 27;
    }
    return h;
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

fmb_status fmb_mesh_find_same(const fmb_mesh *m, const fmb_mesh *other, fmb_mem *mem, uint32_t *out)
{
    point_table t = {.size = 16};
    size_t offset = other ? other->vertices : 0;
    while (t.size < 2 * (m->vertices + offset))
        t.size *= 2;
    FMB_TRY(FMB_GET(mem, t.slot, t.size));
    memset(t.slot, 0xff, t.size * sizeof *t.slot);
    for (size_t v = 0; v < offset; v++)
        find_or_enter_point(&t, other, NULL, v, 0);
    for (size_t v = 0; v < m->vertices; v++)
        out[v] = find_or_enter_point(&t, m, other, v, offset);
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

static void look_at_cells(fmb_mesh *m)
{
    for (size_t i = 0; i < m->cells; i++) {
        fmb_cell c = fmb_mesh_cell_of(m, m->same, i);
        bool tame = fmb_cell_is_tame(&c);
        m->faults[i] = tame ? 0 : FMB_MESH_WILD;
        if (tame ? fmb_cell_is_flat(&c) : is_flat_at_any_size(&c))
            m->faults[i] |= FMB_MESH_FLAT;
    }
}

/* ---- life ------------------------------------------------------------------------------------ */

static bool are_mesh_arguments(int corners, size_t vertices, const double *point, size_t cells,
                               const uint32_t *corner)
{
    bool good = (corners == 3 || corners == 4) && vertices <= FMB_MESH_MOST &&
                cells <= FMB_MESH_MOST && (point || vertices == 0) && (corner || cells == 0);
    for (size_t i = 0; good && i < 3 * vertices; i++)
        good = isfinite(point[i]);
    for (size_t i = 0; good && i < (size_t)corners * cells; i++)
        good = corner[i] < vertices;
    return good;
}

static void *copy_array(fmb_mem *mem, const void *from, size_t n, size_t size)
{
    void *to = fmb_mem_get(mem, n, size);
    if (to && n > 0)
        memcpy(to, from, n * size);
    return to;
}

static fmb_status fill_mesh(fmb_mesh *m, const double *point, const uint32_t *corner,
                            const fmb_mesh_origin *from)
{
    fmb_mem *mem = &m->mem;
    m->point = copy_array(mem, point, 3 * m->vertices, sizeof *point);
    m->corner = copy_array(mem, corner, m->cells * (size_t)m->corners, sizeof *corner);
    m->names_size = from->names_size;
    m->face = from->face ? copy_array(mem, from->face, m->cells, sizeof *m->face) : NULL;
    m->group = from->group ? copy_array(mem, from->group, m->cells, sizeof *m->group) : NULL;
    m->names = from->group ? copy_array(mem, from->names, m->names_size, 1) : NULL;
    m->same = fmb_mem_get(mem, m->vertices, sizeof *m->same);
    m->faults = fmb_mem_get(mem, m->cells, sizeof *m->faults);
    if (!m->point || !m->corner || (from->face && !m->face) ||
        (from->group && !(m->group && m->names)) || !m->same || !m->faults)
        return fmb_mem_status(mem);
    FMB_TRY(fmb_mesh_find_same(m, NULL, mem, m->same));
    look_at_cells(m);
    return fmb_mesh_grow_tree(m);
}

fmb_status fmb_mesh_new_of_file(int corners, size_t vertices, const double *point, size_t cells,
                                const uint32_t *corner, const fmb_mesh_origin *origin,
                                const fmb_alloc *hook, fmb_mesh **out)
{
    fmb_mem mem;
    if (!out || !are_mesh_arguments(corners, vertices, point, cells, corner))
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, hook, 0);
    fmb_mesh *m;
    FMB_TRY(FMB_GET_ZERO(&mem, m, 1));
    m->mem = mem;
    m->corners = corners;
    m->vertices = vertices;
    m->cells = cells;
    fmb_status st = fill_mesh(m, point, corner, origin);
    if (st == FMB_OK)
        *out = m;
    else
        fmb_mesh_free(m);
    return st;
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
    FMB_ARRAYS_PUT(&mem, FMB_ARRAY(m->point, 3 * m->vertices),
                   FMB_ARRAY(m->corner, m->cells * (size_t)m->corners),
                   FMB_ARRAY(m->face, m->cells), FMB_ARRAY(m->group, m->cells),
                   FMB_ARRAY(m->names, m->names_size), FMB_ARRAY(m->same, m->vertices),
                   FMB_ARRAY(m->faults, m->cells), FMB_ARRAY(m->order, m->cells),
                   FMB_ARRAY(m->box, m->cells), FMB_ARRAY(m->node, m->nodes));
    fmb_mem_put(&mem, m, 1, sizeof *m);
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
