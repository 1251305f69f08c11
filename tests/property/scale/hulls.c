/* hulls.c: the law of hulls, images, sums and unions (law.h): points whose coordinate j is times
 * 2^power[j].
 */
#include <math.h>

#include <fmb/lift.h>

#include "property/scale/law.h"

enum { MOST_DIM = 3, MOST_POINTS = 12, BITS = 4 };

/* Powers of coordinates with which no number of so many bits is rounded. */
static void draw_powers(law_source *g, int dim, int power[MOST_DIM])
{
    int all = law_draw(g, -1074, 1023 - BITS);
    bool uniform = law_draw(g, 0, 1) == 0;
    for (int j = 0; j < dim; j++)
        power[j] = uniform ? all : law_draw(g, -1074, 1023 - BITS);
}

static void draw_points(law_source *g, int dim, const int *power, fmb_generators *out[2])
{
    int n = law_draw(g, 1, MOST_POINTS), most = law_draw(g, 1, 7);
    for (int w = 0; w < 2; w++)
        must(fmb_generators_new(dim, NULL, &out[w]));
    for (int i = 0; i < n; i++) {
        fmb_generator_kind kind = i > 0 && law_draw(g, 0, 7) == 0 ? FMB_RAY : FMB_VERTEX;
        double x[MOST_DIM], y[MOST_DIM];
        for (int j = 0; j < dim; j++) {
            x[j] = law_draw(g, -most, most);
            y[j] = ldexp(x[j], power[j]);
        }
        must(fmb_generators_add(out[0], kind, x));
        must(fmb_generators_add(out[1], kind, y));
    }
}

static bool are_alike(const fmb_system *a, const fmb_system *b, const int *power)
{
    int back[MOST_DIM];
    for (int j = 0; j < fmb_system_dim(a); j++)
        back[j] = -power[j];
    return law_same_rows(a, b, back);
}

static bool compare_free(fmb_system *s[2], const int *power, const char *what, char why[LAW_WHY])
{
    bool same = are_alike(s[0], s[1], power);
    int rows[2] = {(int)fmb_system_rows(s[0]), (int)fmb_system_rows(s[1])};
    fmb_system_free(s[0]);
    fmb_system_free(s[1]);
    return same || law_broken(why, what, rows[0], rows[1]);
}

static bool same_sums(fmb_solver *v, fmb_system *s[2], const int *power, char why[LAW_WHY])
{
    fmb_system *out[2];
    for (int w = 0; w < 2; w++)
        must(fmb_sum(v, (const fmb_system *const[]){s[w], s[w]}, 2, NULL, &out[w], NULL));
    return compare_free(out, power, "sum", why);
}

/* Of the hull and of a point. */
static bool same_unions(law_source *g, fmb_solver *v, fmb_system *s[2], const int *power,
                        char why[LAW_WHY])
{
    fmb_system *out[2], *point[2];
    int dim = fmb_system_dim(s[0]), x[MOST_DIM];
    for (int j = 0; j < dim; j++)
        x[j] = law_draw(g, -7, 7);
    for (int w = 0; w < 2; w++) {
        must(fmb_system_new(dim, NULL, &point[w]));
        for (int j = 0; j < dim; j++) {
            double row[MOST_DIM] = {0};
            row[j] = 1;
            must(fmb_system_add(point[w], row, FMB_EQ, ldexp(x[j], w ? power[j] : 0)));
        }
        must(
            fmb_hull_union(v, (const fmb_system *const[]){s[w], point[w]}, 2, NULL, &out[w], NULL));
        fmb_system_free(point[w]);
    }
    return compare_free(out, power, "hull of a union", why);
}

/* Under y = x_1 - x_2 + x_3 - x_4, in the scale of x_1. */
static bool same_images(fmb_solver *v, fmb_system *s[2], const int *power, char why[LAW_WHY])
{
    fmb_system *out[2];
    int dim = fmb_system_dim(s[0]);
    for (int w = 0; w < 2; w++) {
        fmb_system *graph = NULL;
        mpq_t coef[MOST_DIM + 1], right;
        int var[MOST_DIM + 1] = {dim};
        must(fmb_system_new(dim + 1, NULL, &graph));
        mpq_init(right);
        mpq_init(coef[dim]);
        mpq_set_si(coef[dim], -1, 1);
        var[dim] = dim;
        for (int j = 0; j < dim; j++) {
            var[j] = j;
            mpq_init(coef[j]);
            mpq_set_si(coef[j], j % 2 ? -1 : 1, 1);
            law_shift(coef[j], w ? power[0] - power[j] : 0);
        }
        must(fmb_system_add_q(graph, (size_t)dim + 1, var, coef, FMB_EQ, right));
        must(fmb_image(v, s[w], graph, NULL, &out[w], NULL));
        for (int j = 0; j <= dim; j++)
            mpq_clear(coef[j]);
        mpq_clear(right);
        fmb_system_free(graph);
    }
    return compare_free(out, power, "image", why);
}

/* Elimination alone would take for ever over the many variables of a sum. */
bool law_of_hulls(law_source *g, char why[LAW_WHY])
{
    static const fmb_method method[] = {FMB_METHOD_AUTO, FMB_METHOD_LP, FMB_METHOD_HULL,
                                        FMB_METHOD_DD};
    int dim = law_draw(g, 1, MOST_DIM), power[MOST_DIM];
    fmb_options o = {.size = sizeof o};
    fmb_generators *points[2];
    fmb_system *hull[2];
    fmb_solver *v = NULL;
    o.method = method[law_draw(g, 0, 3)];
    draw_powers(g, dim, power);
    draw_points(g, dim, power, points);
    must(fmb_solver_new(&o, NULL, &v));
    for (int w = 0; w < 2; w++)
        must(fmb_hull(v, points[w], &hull[w], NULL));
    bool good = same_sums(v, hull, power, why) && same_images(v, hull, power, why) &&
                same_unions(g, v, hull, power, why);
    good = compare_free(hull, power, "hull", why) && good;
    fmb_generators_free(points[0]);
    fmb_generators_free(points[1]);
    fmb_solver_free(v);
    return good;
}
