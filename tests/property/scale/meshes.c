/* meshes.c: the law of meshes (law.h): cells on a small grid, coordinate j times 2^power[j]. */
#include <math.h>

#include <fmb/mesh.h>

#include "property/scale/law.h"

enum { VERTICES = 9, CELLS = 8, LOWEST = -1074, HIGHEST = 1019 };

/* Overlaps in a plane are not told apart from crossings beyond some size (<fmb/mesh.h>). */
static fmb_mesh_how plain_kind(fmb_mesh_how h)
{
    return h == FMB_MESH_COPLANAR ? FMB_MESH_CROSS : h;
}

static bool same_hits(const fmb_mesh *plain, const fmb_mesh *scaled, char why[LAW_WHY])
{
    fmb_mesh_options o = {.neighbours = true};
    fmb_mesh_answer a = {0}, b = {0};
    law_must(fmb_mesh_meet(plain, NULL, &o, &a));
    law_must(fmb_mesh_meet(scaled, NULL, &o, &b));
    bool same = a.hits == b.hits || law_broken(why, "hits", (int)a.hits, (int)b.hits);
    for (size_t i = 0; same && i < a.hits; i++) {
        const fmb_mesh_hit *x = &a.hit[i], *y = &b.hit[i];
        same = (x->a == y->a && x->b == y->b && x->shared == y->shared &&
                plain_kind(x->how) == plain_kind(y->how)) ||
               law_broken(why, "kind of a hit", (int)x->how, (int)y->how);
    }
    fmb_mesh_answer_clear(&a);
    fmb_mesh_answer_clear(&b);
    return same;
}

bool law_of_meshes(law_source *g, char why[LAW_WHY])
{
    double plain[VERTICES][3], scaled[VERTICES][3];
    int corners = law_draw(g, 3, 4), power[3], all = law_draw(g, LOWEST, HIGHEST);
    int uniform = law_draw(g, 0, 1), most = law_draw(g, 1, 7);
    uint32_t corner[CELLS * 4];
    fmb_mesh *mesh[2];
    for (int j = 0; j < 3; j++)
        power[j] = uniform ? all : law_draw(g, LOWEST, HIGHEST);
    for (int i = 0; i < VERTICES; i++)
        for (int j = 0; j < 3; j++) {
            plain[i][j] = law_draw(g, -most, most);
            scaled[i][j] = ldexp(plain[i][j], power[j]);
        }
    for (int k = 0; k < CELLS * corners; k++)
        corner[k] = (uint32_t)law_draw(g, 0, VERTICES - 1);
    law_must(fmb_mesh_new(corners, VERTICES, plain[0], CELLS, corner, NULL, &mesh[0]));
    law_must(fmb_mesh_new(corners, VERTICES, scaled[0], CELLS, corner, NULL, &mesh[1]));
    bool good = same_hits(mesh[0], mesh[1], why);
    fmb_mesh_free(mesh[0]);
    fmb_mesh_free(mesh[1]);
    return good;
}
