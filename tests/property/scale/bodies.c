/* bodies.c: see bodies.h. */
#include "property/scale/bodies.h"

#include <math.h>

/* Numbers are at most 15 = 2^4 - 1, and scaled ones at most 2^1020: a sum of a few is finite, and
 * at the other end every one is a multiple of the least double. */
enum { LOWEST = -1074, HIGHEST = 1016 };

/* Often near one of the ends, as there is little room between them and an error. */
static int draw_power(law_source *g)
{
    switch (law_draw(g, 0, 3)) {
    case 0:
        return law_draw(g, LOWEST, LOWEST + 60);
    case 1:
        return law_draw(g, HIGHEST - 60, HIGHEST);
    case 2:
        return law_draw(g, -560, -320);
    default:
        return law_draw(g, LOWEST, HIGHEST);
    }
}

void bodies_draw(law_source *g, bool uniform, bool moves, bodies *out)
{
    int dim = out->dim = law_draw(g, 1, BODIES_MOST_DIM), all = draw_power(g);
    int most = law_draw(g, 1, 7);
    uniform = uniform || law_draw(g, 0, 1) == 0;
    for (int j = 0; j < dim; j++)
        out->power[j] = uniform ? all : draw_power(g);
    for (int f = 0; f < 2; f++) {
        fmb_shape shape = (fmb_shape)law_draw(g, 0, FMB_SIMPLEX_BY_CORNERS);
        int naxes = law_draw(g, 0, 3) == 0 ? law_draw(g, 0, dim) : dim;
        bool speed = moves && law_draw(g, 0, 2) == 0;
        for (int k = 0; k < dim * (dim + 2); k++) {
            out->number[0][f][k] = law_draw(g, -most, most);
            out->number[1][f][k] = ldexp(out->number[0][f][k], out->power[k % dim]);
        }
        for (int w = 0; w < 2; w++) {
            const double *x = out->number[w][f];
            (w ? out->scaled : out->plain)[f] =
                (fmb_frame){shape, dim, naxes, x, x + dim, speed ? x + dim * (dim + 1) : NULL};
        }
    }
}
