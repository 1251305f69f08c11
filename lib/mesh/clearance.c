/* clearance.c: see clearance.h. */
#include "mesh/clearance.h"

#include <float.h>

#include "num/rationals.h"

void fmb_mesh_clearance_init(fmb_mesh_clearance *m)
{
    *m = (fmb_mesh_clearance){.gap = 0};
    mpq_init(m->square);
}

void fmb_mesh_clearance_clear(fmb_mesh_clearance *m)
{
    mpq_clear(m->square);
}

/* The square of `above` has a relative error of one unit, or an absolute one below DBL_MIN if it
 * underflows; the gap of boxes that do not touch is more than twice that. */
void fmb_mesh_clearance_set(fmb_mesh_clearance *m, mpq_srcptr square)
{
    double root = fmb_nearest_root(square);
    mpq_set(m->square, square);
    m->below = nextafter(root, -INFINITY);
    m->above = nextafter(root, INFINITY);
    m->gap = mpq_sgn(square) > 0 ? m->above * m->above * (1 + 16 * DBL_EPSILON) + DBL_MIN : 0;
}

bool fmb_mesh_clearance_read(fmb_mesh_clearance *m, const char *text)
{
    mpq_t x;
    if (!text)
        return true;
    mpq_init(x);
    bool good = (mpq_set_str(x, text, 10) == 0 && mpz_sgn(mpq_denref(x)) > 0 && mpq_sgn(x) >= 0);
    if (good) {
        mpq_canonicalize(x);
        mpq_mul(x, x, x);
        fmb_mesh_clearance_set(m, x);
    }
    mpq_clear(x);
    return good;
}
