/* exact_contact.c: see exact_contact.h. */
#include "pair/contact/exact_contact.h"

#include <math.h>

#include "num/rationals.h"
#include "proximity/least_overlap.h"

/* The direction of the least as doubles of length 1, whatever its numbers are. */
static void write_normal(int dim, const fmb_least_overlap *x, double *out)
{
    long most = 0, exponent[3];
    double length = 0;
    bool any = false;
    for (int j = 0; j < dim; j++) {
        out[j] = mpz_get_d_2exp(&exponent[j], x->normal[j]);
        if (out[j] != 0 && (!any || exponent[j] > most))
            most = exponent[j];
        any |= out[j] != 0;
    }
    for (int j = 0; j < dim; j++) {
        long down = exponent[j] - most;
        out[j] = down < -2000 ? 0 : ldexp(out[j], (int)down);
        length += out[j] * out[j];
    }
    for (int j = 0; j < dim; j++)
        out[j] /= sqrt(length);
}

static double round_depth(const fmb_minkowski *m, const fmb_least_overlap *x)
{
    mpq_t square;
    if (mpz_sgn(x->overlap) == 0)
        return 0;
    mpq_init(square);
    mpz_mul(mpq_numref(square), x->overlap, x->overlap);
    mpz_mul(mpq_denref(square), m->unit, m->unit);
    mpz_mul(mpq_denref(square), mpq_denref(square), x->size);
    mpq_canonicalize(square);
    double depth = fmb_nearest_root(square);
    mpq_clear(square);
    return depth;
}

fmb_status fmb_exact_contact(const fmb_frame *f, fmb_mem *mem, double *depth, double *normal)
{
    fmb_minkowski m;
    fmb_least_overlap x;
    fmb_status st = fmb_minkowski_init(&m, &(fmb_two){.f = f}, mem);
    fmb_least_overlap_init(&x);
    if (st == FMB_OK) {
        fmb_find_least_overlap(&m, FMB_NORM_EUCLIDEAN, &x);
        *depth = round_depth(&m, &x);
        write_normal(m.dim, &x, normal);
    }
    fmb_least_overlap_clear(&x);
    fmb_minkowski_clear(&m);
    return st;
}
