/* frames.c: see frames.h. Small integers, as in the small pairs of draw.c, drawn by splitmix64. */
#include "study/benchmark/frames.h"

#include <fmb/frame.h>

#include "study/program/random.h"

enum { MOST_DIM = 6 };

typedef struct body {
    double origin[MOST_DIM], axes[MOST_DIM * MOST_DIM], speed[MOST_DIM];
} body;

static void draw_body(study_random *g, int dim, body *out)
{
    for (int i = 0; i < dim; i++) {
        out->origin[i] = (double)study_random_between(g, -1, 1);
        out->speed[i] = (double)study_random_between(g, -1, 1);
    }
    for (int i = 0; i < dim * dim; i++)
        out->axes[i] = (double)study_random_between(g, -3, 3);
}

static fmb_frame frame_of(const body *b, fmb_shape shape, int dim, bool moves)
{
    return (fmb_frame){shape, dim, dim, b->origin, b->axes, moves ? b->speed : NULL};
}

/* Two coordinates of B are kept, one in the plane. Bodies with dependent axes are drawn again. */
static fmb_status draw_pair(fmb_shape shape, bool moves, int size, int instance,
                            study_projection *out)
{
    int dim = size + 1;
    study_random g = {.state = 977 * (uint64_t)instance + 31 * (uint64_t)size +
                               7 * (uint64_t)shape + (uint64_t)moves};
    fmb_status st = FMB_ERR_ARG;
    while (st == FMB_ERR_ARG) {
        body b[2];
        draw_body(&g, dim, &b[0]);
        draw_body(&g, dim, &b[1]);
        const fmb_frame both[2] = {frame_of(&b[0], shape, dim, moves),
                                   frame_of(&b[1], shape, dim, moves)};
        st = fmb_system_from_frames(both, 2, FMB_COORDINATES_LAST, FMB_CONTACT_CLOSED, NULL,
                                    &out->s);
    }
    out->keep = dim > 2 ? 2 : 1;
    return st;
}

fmb_status study_benchmark_cuboids(int size, int instance, study_projection *out)
{
    return draw_pair(FMB_CUBOID, false, size, instance, out);
}

fmb_status study_benchmark_moving_cuboids(int size, int instance, study_projection *out)
{
    return draw_pair(FMB_CUBOID, true, size, instance, out);
}

fmb_status study_benchmark_moving_simplices(int size, int instance, study_projection *out)
{
    return draw_pair(FMB_SIMPLEX, true, size, instance, out);
}
