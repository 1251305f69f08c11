/* meshes.c: the law of meshes (law.h): cells on a small grid, coordinate j times 2^power[j]; of one
 * mesh with itself, and with one that moves.
 */
#include <math.h>

#include <fmb/mesh.h>

#include "property/scale/law.h"

enum { VERTICES = 9, CELLS = 8, LOWEST = -1074, HIGHEST = 1019 };

/* Overlaps in a plane are not told apart from crossings beyond some size (<fmb/mesh.h>). */
static fmb_mesh_how plain_kind(fmb_mesh_how h)
{
    return h == FMB_MESH_COPLANAR ? FMB_MESH_CROSS : h;
}

/* Of both meshes with themselves, or with others that move so far. */
static bool same_hits(fmb_mesh *const mesh[2], fmb_mesh *const moving[2], double motion[2][3],
                      char why[LAW_WHY])
{
    fmb_mesh_answer of[2] = {{.size = sizeof of[0]}, {.size = sizeof of[0]}};
    for (int w = 0; w < 2; w++) {
        fmb_mesh_options o = {
            .size = sizeof o, .neighbours = true, .motion = moving ? motion[w] : NULL};
        must(fmb_mesh_meet(mesh[w], moving ? moving[w] : NULL, &o, &of[w]));
    }
    bool same =
        of[0].hits == of[1].hits || law_broken(why, moving ? "hits of a mesh that moves" : "hits",
                                               (int)of[0].hits, (int)of[1].hits);
    for (size_t i = 0; same && i < of[0].hits; i++) {
        const fmb_mesh_hit *x = &of[0].hit[i], *y = &of[1].hit[i];
        same = (x->a == y->a && x->b == y->b && x->shared == y->shared &&
                plain_kind(x->how) == plain_kind(y->how)) ||
               law_broken(why, "kind of a hit", (int)x->how, (int)y->how);
    }
    fmb_mesh_answer_clear(&of[0]);
    fmb_mesh_answer_clear(&of[1]);
    return same;
}

static void draw_vertices(law_source *g, int most, const int *power, double out[2][VERTICES][3])
{
    for (int i = 0; i < VERTICES; i++)
        for (int j = 0; j < 3; j++) {
            out[0][i][j] = law_draw(g, -most, most);
            out[1][i][j] = ldexp(out[0][i][j], power[j]);
        }
}

static void draw_mesh(law_source *g, int most, const int *power, fmb_mesh *out[2])
{
    double point[2][VERTICES][3];
    uint32_t corner[CELLS * 4];
    int corners = law_draw(g, 3, 4);
    draw_vertices(g, most, power, point);
    for (int k = 0; k < CELLS * corners; k++)
        corner[k] = (uint32_t)law_draw(g, 0, VERTICES - 1);
    for (int w = 0; w < 2; w++)
        must(fmb_mesh_new(corners, VERTICES, point[w][0], CELLS, corner, NULL, &out[w]));
}

bool law_of_meshes(law_source *g, char why[LAW_WHY])
{
    double motion[2][3];
    int power[3], all = law_draw(g, LOWEST, HIGHEST);
    int uniform = law_draw(g, 0, 1), most = law_draw(g, 1, 7);
    fmb_mesh *mesh[2], *other[2];
    for (int j = 0; j < 3; j++)
        power[j] = uniform ? all : law_draw(g, LOWEST, HIGHEST);
    draw_mesh(g, most, power, mesh);
    draw_mesh(g, most, power, other);
    for (int j = 0; j < 3; j++) {
        motion[0][j] = law_draw(g, -most, most);
        motion[1][j] = ldexp(motion[0][j], power[j]);
    }
    bool good = same_hits(mesh, NULL, motion, why) && same_hits(mesh, other, motion, why);
    for (int w = 0; w < 2; w++) {
        fmb_mesh_free(mesh[w]);
        fmb_mesh_free(other[w]);
    }
    return good;
}
