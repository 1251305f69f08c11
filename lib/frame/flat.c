/* flat.c: see flat.h. */
#include "frame/flat.h"

static void add_normal(fmb_flat_kind *k, int first, int second)
{
    k->normal[k->normals][0] = (uint8_t)first;
    k->normal[k->normals++][1] = (uint8_t)second;
}

/* Add the normal of each 2-dimensional face, by two of its edges. Faces of a tetrahedron: those at
 * its origin, and the one opposite, whose edges are differences. */
static void add_normals_of_faces(fmb_flat_kind *k, int side)
{
    const fmb_flat_side *s = &k->side[side];
    int base = side * FMB_FLAT_MOST_EDGES;
    for (int i = 0; i < s->naxes; i++)
        for (int j = i + 1; j < s->naxes; j++)
            add_normal(k, base + i, base + j);
    if (s->simplex && s->naxes == 3)
        add_normal(k, base + 3, base + 4);
}

/* Add the normals of all edges of one side (or the drift) with all edges of the other. */
static void add_normals_across(fmb_flat_kind *k)
{
    for (int i = 0; i < k->side[0].edges; i++)
        for (int j = 0; j < k->side[1].edges; j++)
            add_normal(k, i, FMB_FLAT_MOST_EDGES + j);
    for (int side = 0; k->moves && side < 2; side++)
        for (int i = 0; i < k->side[side].edges; i++)
            add_normal(k, side * FMB_FLAT_MOST_EDGES + i, FMB_FLAT_DRIFT);
}

static int count_directions(const fmb_flat_kind *k)
{
    return k->side[0].naxes + k->side[1].naxes + k->moves;
}

static void add_normals_in_plane(fmb_flat_kind *k)
{
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < k->side[side].edges; i++)
            add_normal(k, side * FMB_FLAT_MOST_EDGES + i, 0);
    if (k->moves)
        add_normal(k, FMB_FLAT_DRIFT, 0);
    for (int j = 0; count_directions(k) == 0 && j < 2; j++)
        add_normal(k, FMB_FLAT_WORLD + j, 0);
}

/* The direction of a kind that has only one. */
static int find_only_direction(const fmb_flat_kind *k)
{
    return k->side[0].naxes > 0 ? 0 : k->side[1].naxes > 0 ? FMB_FLAT_MOST_EDGES : FMB_FLAT_DRIFT;
}

static void add_normals_in_space(fmb_flat_kind *k)
{
    add_normals_of_faces(k, 0);
    add_normals_of_faces(k, 1);
    add_normals_across(k);
    for (int j = 0; count_directions(k) == 0 && j < 3; j++)
        add_normal(k, FMB_FLAT_WORLD + j, FMB_FLAT_WORLD + (j + 1) % 3);
    for (int j = 0; count_directions(k) == 1 && j < 3; j++)
        add_normal(k, find_only_direction(k), FMB_FLAT_WORLD + j);
}

void fmb_flat_kind_of(int dim, bool moves, const int naxes[2], const bool simplex[2],
                      fmb_flat_kind *out)
{
    static const int edges_of_simplex[4] = {0, 1, 3, 6};
    *out = (fmb_flat_kind){.dim = dim, .moves = moves};
    for (int side = 0; side < 2; side++)
        out->side[side] = (fmb_flat_side){
            naxes[side], simplex[side] ? edges_of_simplex[naxes[side]] : naxes[side],
            simplex[side]};
    out->may_meet = count_directions(out) >= dim;
    out->needs_world = count_directions(out) < dim - 1;
    if (dim == 2)
        add_normals_in_plane(out);
    else
        add_normals_in_space(out);
}
