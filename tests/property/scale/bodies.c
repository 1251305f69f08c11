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

void bodies_draw_powers(law_source *g, int dim, bool uniform, int *power)
{
    int all = draw_power(g);
    uniform = uniform || law_draw(g, 0, 1) == 0;
    for (int j = 0; j < dim; j++)
        power[j] = uniform ? all : draw_power(g);
}

void bodies_draw_body(law_source *g, int dim, int most, bool moves, const int *power, body *out)
{
    fmb_shape shape = (fmb_shape)law_draw(g, 0, FMB_SIMPLEX_BY_CORNERS);
    int naxes = law_draw(g, 0, 3) == 0 ? law_draw(g, 0, dim) : dim;
    bool speed = moves && law_draw(g, 0, 2) == 0;
    for (int k = 0; k < dim * (dim + 2); k++) {
        out->number[0][k] = law_draw(g, -most, most);
        out->number[1][k] = ldexp(out->number[0][k], power[k % dim]);
    }
    for (int w = 0; w < 2; w++) {
        const double *x = out->number[w];
        out->frame[w] =
            (fmb_frame){shape, dim, naxes, x, x + dim, speed ? x + dim * (dim + 1) : NULL};
    }
}

void bodies_draw(law_source *g, bool uniform, bool moves, bodies *out)
{
    int dim = out->dim = law_draw(g, 1, BODIES_MOST_DIM), most = law_draw(g, 1, 7);
    bodies_draw_powers(g, dim, uniform, out->power);
    for (int f = 0; f < 2; f++) {
        bodies_draw_body(g, dim, most, moves, out->power, &out->body[f]);
        out->plain[f] = out->body[f].frame[0];
        out->scaled[f] = out->body[f].frame[1];
    }
}
