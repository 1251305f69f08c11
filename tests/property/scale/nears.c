/* nears.c: the law of nearness (law.h): distance, depth, common points and separating rows, in a
 * scale common to all coordinates; common points and rows in any.
 */
#include "property/scale/bodies.h"

/* The length or its square, -1 without any; and the nearest double does not vanish or overflow. */
static void take_measure(fmb_proximity *p, mpq_t out)
{
    mpq_set_si(out, -1, 1);
    if (p)
        fmb_proximity_measure_q(p, out);
    fmb_proximity_free(p);
}

static bool same_measures(fmb_solver *v, const bodies *b, fmb_norm norm, char why[LAW_WHY])
{
    bool same = true;
    mpq_t measure[2];
    mpq_inits(measure[0], measure[1], NULL);
    for (int depth = 0; same && depth < 2; depth++) {
        for (int w = 0; w < 2; w++) {
            fmb_proximity *p = NULL;
            const fmb_frame *f = w ? b->scaled : b->plain;
            must(depth ? fmb_depth(v, f, norm, &p, NULL) : fmb_distance(v, f, norm, &p, NULL));
            take_measure(p, measure[w]);
        }
        if (mpq_sgn(measure[0]) >= 0)
            law_shift(measure[0], norm == FMB_NORM_MAX ? b->power[0] : 2 * b->power[0]);
        same = mpq_equal(measure[0], measure[1]) != 0;
        if (!same)
            law_broken(why, depth ? "depth, sign of the measure" : "distance, sign of the measure",
                       mpq_sgn(measure[0]), mpq_sgn(measure[1]));
    }
    mpq_clears(measure[0], measure[1], NULL);
    return same;
}

static bool same_common_points(fmb_solver *v, const bodies *b, char why[LAW_WHY])
{
    fmb_generators *out[2] = {NULL, NULL};
    must(fmb_common(v, b->plain, &out[0], NULL));
    must(fmb_common(v, b->scaled, &out[1], NULL));
    int n[2] = {out[0] ? (int)fmb_generators_size(out[0]) : -1,
                out[1] ? (int)fmb_generators_size(out[1]) : -1};
    fmb_generators_free(out[0]);
    fmb_generators_free(out[1]);
    return n[0] == n[1] || law_broken(why, "common points", n[0], n[1]);
}

static bool same_separations(fmb_solver *v, const bodies *b, fmb_contact contact, char why[LAW_WHY])
{
    fmb_system *row[2] = {NULL, NULL};
    must(fmb_separate(v, b->plain, contact, &row[0], NULL));
    must(fmb_separate(v, b->scaled, contact, &row[1], NULL));
    bool same = !row[0] == !row[1];
    same = same && (!row[1] || fmb_separates(b->scaled, contact, row[1]));
    int found[2] = {row[0] != NULL, row[1] != NULL};
    fmb_system_free(row[0]);
    fmb_system_free(row[1]);
    return same || law_broken(why, "separating row", found[0], found[1]);
}

bool law_of_nears(law_source *g, char why[LAW_WHY])
{
    bodies b;
    fmb_solver *v = NULL;
    bodies_draw(g, true, true, &b);
    must(fmb_solver_new(NULL, NULL, &v));
    bool good = b.dim > 3 || (same_measures(v, &b, FMB_NORM_EUCLIDEAN, why) &&
                              same_measures(v, &b, FMB_NORM_MAX, why));
    if (good) {
        bodies_draw(g, false, true, &b);
        good = same_common_points(v, &b, why) && same_separations(v, &b, FMB_CONTACT_CLOSED, why) &&
               same_separations(v, &b, FMB_CONTACT_OPEN, why);
    }
    fmb_solver_free(v);
    return good;
}
