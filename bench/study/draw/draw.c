/* draw.c: see draw.h. */
#include "study/draw/draw.h"

#include <stdlib.h>
#include <string.h>

/* All numbers are uniform in -x ... x. */
typedef struct range {
    const char *name;
    double axes, origin, speed;
    bool whole;
} range;

static const range RANGE[] = {
    [STUDY_SMALL] = {"small", 3, 3, 1, true},
    [STUDY_FLOAT] = {"float", 10, 10, 10, false},
};
enum { FAMILIES = sizeof RANGE / sizeof *RANGE };

const char *study_family_text(study_family family)
{
    return RANGE[family].name;
}

bool study_family_parse(const char *word, study_family *out)
{
    for (int i = 0; i < FAMILIES; i++)
        if (strcmp(word, RANGE[i].name) == 0) {
            *out = (study_family)i;
            return true;
        }
    return false;
}

/* Meeting and disjoint pairs come from the same stream: a pair is drawn first and decided then. */
gsl_rng *study_draw_begin(const study_class *c, unsigned long seed)
{
    gsl_rng *g = gsl_rng_alloc(gsl_rng_mt19937);
    unsigned long key = (unsigned long)c->family;
    key = key * 64 + (unsigned long)c->dim;
    key = key * 2 + c->moves;
    key = key * 2 + (unsigned long)c->shape[0];
    key = key * 2 + (unsigned long)c->shape[1];
    if (g)
        gsl_rng_set(g, ((seed * 0x9e3779b1UL) ^ (key * 0x85ebca6bUL)) & 0xffffffffUL);
    return g;
}

static double draw(gsl_rng *g, double most, bool whole)
{
    if (!whole)
        return most * (2 * gsl_rng_uniform(g) - 1);
    return (double)gsl_rng_uniform_int(g, (unsigned long)(2 * most) + 1) - most;
}

/* number: [dim] origin, [dim][dim] axes, [dim] speed. */
static fmb_frame draw_frame(gsl_rng *g, const study_class *c, int which, double *number)
{
    const range *r = &RANGE[c->family];
    int d = c->dim;
    double *axes = number + d, *speed = axes + d * d;
    for (int i = 0; i < d; i++)
        number[i] = draw(g, r->origin, r->whole);
    for (int i = 0; i < d * d; i++)
        axes[i] = draw(g, r->axes, r->whole);
    for (int i = 0; c->moves && i < d; i++)
        speed[i] = draw(g, r->speed, r->whole);
    return (fmb_frame){c->shape[which], d, d, number, axes, c->moves ? speed : NULL};
}

fmb_status study_draw_pair(gsl_rng *g, const study_class *c, fmb_system **out)
{
    size_t numbers = (size_t)(c->dim * (c->dim + 2));
    double *number = calloc(2 * numbers, sizeof *number);
    fmb_status st = FMB_ERR_MEMORY;
    if (number)
        do {
            fmb_system *world = NULL;
            fmb_frame f[2];
            for (int i = 0; i < 2; i++)
                f[i] = draw_frame(g, c, i, number + (size_t)i * numbers);
            st = fmb_system_from_frames(f, 2, FMB_COORDINATES_WORLD, FMB_CONTACT_CLOSED, NULL,
                                        &world);
            fmb_system_free(world);
            if (st == FMB_OK)
                st = fmb_system_from_frames(f, 2, FMB_COORDINATES_LAST, FMB_CONTACT_CLOSED, NULL,
                                            out);
        } while (st == FMB_ERR_ARG);
    free(number);
    return st;
}
