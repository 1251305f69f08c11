/* soup.h: small cells on a grid, and the mesh of them. */
#ifndef UNIT_MESH_SOUP_H
#define UNIT_MESH_SOUP_H

#include <fmb/mesh.h>

#include "property/random/rows.h"
#include "support/support.h"

enum { VERTICES = 60, CELLS = 90 };

typedef struct soup {
    double point[3 * VERTICES];
    uint32_t corner[4 * CELLS];
    int corners;
    size_t cells;
} soup;

/* Small cells on a grid: many touch, share corners, are flat. */
static inline void draw_soup(support_rng *g, int corners, size_t cells, soup *s)
{
    s->corners = corners;
    s->cells = cells;
    for (int i = 0; i < 3 * VERTICES; i++)
        s->point[i] = support_between(g, 0, 5);
    for (size_t i = 0; i < cells * (size_t)corners; i++)
        s->corner[i] = (uint32_t)support_between(g, 0, VERTICES - 1);
}

static inline fmb_mesh *mesh_of(const soup *s)
{
    fmb_mesh *m = NULL;
    must(fmb_mesh_new(s->corners, VERTICES, s->point, s->cells, s->corner, NULL, &m));
    return m;
}

#endif
