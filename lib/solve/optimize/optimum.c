/* optimum.c: life and accessors of an fmb_optimum; see optimum.h. */
#include "solve/optimize/optimum.h"

#include "num/rationals.h"

fmb_status fmb_optimum_new(fmb_sense sense, size_t dim, const fmb_alloc *hook, fmb_optimum **out)
{
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_optimum *o;
    FMB_TRY(FMB_GET_ZERO(&mem, o, 1));
    o->mem = mem;
    o->sense = sense;
    o->dim = dim;
    mpq_init(o->best.value);
    fmb_status st = fmb_rationals_new(&o->point, dim, &o->mem);
    FMB_THEN(st, fmb_rationals_new(&o->ray, dim, &o->mem));
    if (st == FMB_OK)
        *out = o;
    else
        fmb_optimum_free(o);
    return st;
}

void fmb_optimum_free(fmb_optimum *o)
{
    if (!o)
        return;
    fmb_rationals_free(o->point, o->dim, &o->mem);
    fmb_rationals_free(o->ray, o->dim, &o->mem);
    mpq_clear(o->best.value);
    fmb_mem mem = o->mem;
    fmb_mem_put(&mem, o, 1, sizeof *o);
}

fmb_sense fmb_optimum_sense(const fmb_optimum *o)
{
    return o ? o->sense : FMB_SENSE_NONE;
}

static fmb_side side_of_sense(const fmb_optimum *o)
{
    return o->sense == FMB_SENSE_MAX ? FMB_UPPER : FMB_LOWER;
}

fmb_end fmb_optimum_end(const fmb_optimum *o)
{
    return o ? fmb_exact_side_end(&o->best, side_of_sense(o)) : (fmb_end){.kind = FMB_END_UNKNOWN};
}

bool fmb_optimum_value_q(const fmb_optimum *o, mpq_t value)
{
    bool known = o && value && fmb_exact_side_has_value(&o->best);
    if (known)
        mpq_set(value, o->best.value);
    return known;
}

/* Coordinate j of a point or ray; NULL where there is none. */
static mpq_srcptr coordinate_of(const fmb_optimum *o, mpq_t *x, int j)
{
    return j >= 0 && (size_t)j < o->dim ? x[j] : NULL;
}

/* Where o is NULL there is neither. */
static mpq_srcptr point_of_optimum(const fmb_optimum *o, int j)
{
    return o ? coordinate_of(o, o->point, j) : NULL;
}

static mpq_srcptr ray_of_optimum(const fmb_optimum *o, int j)
{
    return o ? coordinate_of(o, o->ray, j) : NULL;
}

void fmb_optimum_coordinate_q(const fmb_optimum *o, int j, mpq_t out)
{
    fmb_rational_give(point_of_optimum(o, j), out);
}

void fmb_optimum_ray_q(const fmb_optimum *o, int j, mpq_t out)
{
    fmb_rational_give(ray_of_optimum(o, j), out);
}

double fmb_optimum_coordinate(const fmb_optimum *o, int j)
{
    return fmb_nearest_double(point_of_optimum(o, j));
}

double fmb_optimum_ray(const fmb_optimum *o, int j)
{
    return fmb_nearest_double(ray_of_optimum(o, j));
}

size_t fmb_optimum_coordinate_text(const fmb_optimum *o, int j, char *text, size_t size)
{
    return fmb_rational_print(point_of_optimum(o, j), text, size);
}

size_t fmb_optimum_ray_text(const fmb_optimum *o, int j, char *text, size_t size)
{
    return fmb_rational_print(ray_of_optimum(o, j), text, size);
}

double fmb_optimum_nearest(const fmb_optimum *o)
{
    return o ? fmb_exact_side_nearest(&o->best, side_of_sense(o)) : 0;
}

size_t fmb_optimum_value_text(const fmb_optimum *o, char *text, size_t size)
{
    return fmb_exact_side_print(o ? &o->best : NULL, text, size);
}
