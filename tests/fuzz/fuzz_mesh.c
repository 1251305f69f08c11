/* fuzz_mesh.c: the readers of meshes on any bytes: a mesh whose cells can be asked about, or a
 * complaint. */
#include <stdlib.h>

#include <fmb/mesh.h>

#include "round.h"

static void demand(bool ok)
{
    if (!ok)
        abort();
}

static bool stop_at_once(void *self, double done)
{
    (void)self;
    return done < 0;
}

static void ask(const fmb_mesh *m)
{
    fmb_mesh_options o = {.size = sizeof o, .neighbours = true, .progress = stop_at_once};
    fmb_mesh_answer answer = {.size = sizeof answer};
    for (size_t c = 0; c < fmb_mesh_cells(m) * (size_t)fmb_mesh_corners(m); c++)
        demand(fmb_mesh_indices(m)[c] < fmb_mesh_vertices(m));
    demand(fmb_mesh_meet(m, NULL, &o, &answer) == FMB_OK);
    for (size_t i = 0; i < answer.hits; i++)
        demand(answer.hit[i].a < answer.hit[i].b && answer.hit[i].how != FMB_MESH_APART);
    fmb_mesh_answer_clear(&answer);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    for (int f = FMB_MESH_AUTO; f <= FMB_MESH_MEDIT; f++) {
        fmb_mesh *m = NULL;
        fmb_where where = {.line = -1};
        fmb_status st =
            fmb_mesh_parse((const char *)data, size, (fmb_mesh_format)f, NULL, &m, &where);
        demand(st == FMB_OK || (st == FMB_ERR_PARSE && where.line >= 0 && where.text[0]));
        if (st == FMB_OK)
            ask(m);
        fmb_mesh_free(m);
    }
    return 0;
}
