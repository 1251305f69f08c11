/* systems.c: the law of systems (law.h): x_j = 2^column[j] y_j in each row, and each row times
 * 2^row[i] of its own.
 */
#include <math.h>
#include <string.h>

#include "property/scale/law.h"

enum { MOST_DIM = 4, MOST_ROWS = 9 };

typedef struct drawn_system {
    int dim, rows, column[MOST_DIM];
    fmb_system *s, *scaled;
} drawn_system;

/* Entries are below 2^4, so these powers round nothing, even among subnormals. */
static void draw_powers(law_source *g, drawn_system *d, int row[MOST_ROWS])
{
    int reach = law_draw(g, 0, 2) * 240;
    bool uniform = law_draw(g, 0, 1) == 0;
    int all = law_draw(g, -1074, 1019);
    for (int j = 0; j < d->dim; j++)
        d->column[j] = uniform ? 0 : law_draw(g, -reach, reach);
    for (int i = 0; i < d->rows; i++) {
        int lo = -1074 + reach, hi = 1019 - reach;
        row[i] = uniform ? all : law_draw(g, lo, hi);
    }
}

static drawn_system draw_system(law_source *g)
{
    drawn_system d = {.dim = law_draw(g, 1, MOST_DIM), .rows = law_draw(g, 1, MOST_ROWS)};
    int row[MOST_ROWS], most = law_draw(g, 1, 7);
    draw_powers(g, &d, row);
    law_must(fmb_system_new(d.dim, NULL, &d.s));
    law_must(fmb_system_new(d.dim, NULL, &d.scaled));
    for (int i = 0; i < d.rows; i++) {
        static const fmb_rel rel[] = {FMB_LE, FMB_LE, FMB_LE, FMB_LE, FMB_LT, FMB_LE, FMB_EQ};
        double a[MOST_DIM], b[MOST_DIM];
        fmb_rel r = rel[law_draw(g, 0, 6)];
        int right = law_draw(g, -most, 2 * most > 15 ? 15 : 2 * most);
        for (int j = 0; j < d.dim; j++) {
            a[j] = law_draw(g, -most, most);
            b[j] = ldexp(a[j], row[i] + d.column[j]);
        }
        law_must(fmb_system_add(d.s, a, r, right));
        law_must(fmb_system_add(d.scaled, b, r, ldexp(right, row[i])));
    }
    return d;
}

static bool same_boxes(const drawn_system *d, fmb_solver *v, char why[LAW_WHY])
{
    fmb_box *box[2];
    fmb_result r[2];
    bool same = true;
    mpq_t end[2];
    mpq_inits(end[0], end[1], NULL);
    law_must(fmb_bound(v, d->s, NULL, 0, &box[0], &r[0]));
    law_must(fmb_bound(v, d->scaled, NULL, 0, &box[1], &r[1]));
    same = r[0].verdict == r[1].verdict;
    for (int j = 0; same && box[0] && j < 2 * d->dim; j++) {
        fmb_end x = fmb_box_end(box[0], j / 2, (fmb_side)(j % 2)),
                y = fmb_box_end(box[1], j / 2, (fmb_side)(j % 2));
        bool finite = fmb_box_end_q(box[0], j / 2, (fmb_side)(j % 2), end[0]);
        if (finite && fmb_box_end_q(box[1], j / 2, (fmb_side)(j % 2), end[1]))
            law_shift(end[1], d->column[j / 2]);
        same =
            x.kind == y.kind && x.attained == y.attained && (!finite || mpq_equal(end[0], end[1]));
    }
    fmb_box_free(box[0]);
    fmb_box_free(box[1]);
    mpq_clears(end[0], end[1], NULL);
    return same || law_broken(why, "bound", (int)r[0].verdict, (int)r[1].verdict);
}

static bool has_equality(const fmb_system *s)
{
    size_t i = 0;
    while (i < fmb_system_rows(s) && fmb_system_rel(s, i) != FMB_EQ)
        i++;
    return i < fmb_system_rows(s);
}

/* Rows beside an equality have more than one form. */
static bool are_alike(const fmb_system *a, const fmb_system *b, const int *power)
{
    if (has_equality(a) && has_equality(b))
        return fmb_system_rows(a) == fmb_system_rows(b);
    int back[MOST_DIM];
    for (int j = 0; j < fmb_system_dim(a); j++)
        back[j] = power[j];
    return law_same_rows(a, b, back);
}

static bool same_projections(const drawn_system *d, fmb_solver *v, int mask, char why[LAW_WHY])
{
    int keep[MOST_DIM], power[MOST_DIM], n = 0;
    fmb_system *out[2];
    for (int j = 0; j < d->dim; j++)
        if (mask >> j & 1) {
            power[n] = d->column[j];
            keep[n++] = j;
        }
    law_must(fmb_project(v, d->s, keep, n, &out[0], NULL));
    law_must(fmb_project(v, d->scaled, keep, n, &out[1], NULL));
    bool same = are_alike(out[0], out[1], power);
    int rows[2] = {(int)fmb_system_rows(out[0]), (int)fmb_system_rows(out[1])};
    fmb_system_free(out[0]);
    fmb_system_free(out[1]);
    return same || law_broken(why, "project", rows[0], rows[1]);
}

static bool same_optima(const drawn_system *d, fmb_solver *v, law_source *g, char why[LAW_WHY])
{
    double a[MOST_DIM], b[MOST_DIM];
    for (int j = 0; j < d->dim; j++) {
        a[j] = law_draw(g, -3, 3);
        b[j] = ldexp(a[j], d->column[j]);
    }
    fmb_optimum *out[2];
    mpq_t value[2];
    mpq_inits(value[0], value[1], NULL);
    law_must(fmb_optimize(v, d->s, &(fmb_objective){FMB_SENSE_MAX, a, 0}, &out[0], NULL));
    law_must(fmb_optimize(v, d->scaled, &(fmb_objective){FMB_SENSE_MAX, b, 0}, &out[1], NULL));
    fmb_end x = fmb_optimum_end(out[0]), y = fmb_optimum_end(out[1]);
    bool finite = fmb_optimum_value_q(out[0], value[0]);
    bool same = !out[0] == !out[1] && x.kind == y.kind && x.attained == y.attained &&
                fmb_optimum_value_q(out[1], value[1]) == finite &&
                (!finite || mpq_equal(value[0], value[1]));
    mpq_clears(value[0], value[1], NULL);
    fmb_optimum_free(out[0]);
    fmb_optimum_free(out[1]);
    return same || law_broken(why, "optimize", (int)x.kind, (int)y.kind);
}

static bool same_reductions(const drawn_system *d, fmb_solver *v, char why[LAW_WHY])
{
    fmb_system *out[2];
    law_must(fmb_reduce(v, d->s, NULL, &out[0], NULL));
    law_must(fmb_reduce(v, d->scaled, NULL, &out[1], NULL));
    int rows[2] = {(int)fmb_system_rows(out[0]), (int)fmb_system_rows(out[1])};
    bool strict = false;
    for (size_t i = 0; i < fmb_system_rows(d->s); i++)
        strict |= fmb_system_rel(d->s, i) == FMB_LT;
    bool same = strict ? true : are_alike(out[0], out[1], d->column);
    fmb_system_free(out[0]);
    fmb_system_free(out[1]);
    return same || law_broken(why, "reduce", rows[0], rows[1]);
}

static bool same_generators(const drawn_system *d, fmb_solver *v, char why[LAW_WHY])
{
    fmb_generators *out[2];
    size_t count[2][3] = {{0}};
    mpq_t sum[2][MOST_DIM], x;
    bool same = true;
    mpq_init(x);
    law_must(fmb_generate(v, d->s, &out[0], NULL));
    law_must(fmb_generate(v, d->scaled, &out[1], NULL));
    for (int j = 0; j < d->dim; j++)
        mpq_inits(sum[0][j], sum[1][j], NULL);
    for (int w = 0; w < 2; w++)
        for (size_t i = 0; out[w] && i < fmb_generators_size(out[w]); i++) {
            fmb_generator_kind kind = fmb_generators_kind(out[w], i);
            count[w][kind]++;
            for (int j = 0; kind == FMB_VERTEX && j < d->dim; j++) {
                fmb_generators_coordinate_q(out[w], i, j, x);
                law_shift(x, w ? d->column[j] : 0);
                mpq_add(sum[w][j], sum[w][j], x);
            }
        }
    same = memcmp(count[0], count[1], sizeof count[0]) == 0;
    for (int j = 0; same && count[0][FMB_LINE] == 0 && j < d->dim; j++)
        same = mpq_equal(sum[0][j], sum[1][j]) != 0;
    for (int j = 0; j < d->dim; j++)
        mpq_clears(sum[0][j], sum[1][j], NULL);
    mpq_clear(x);
    fmb_generators_free(out[0]);
    fmb_generators_free(out[1]);
    return same || law_broken(why, "vertices", (int)count[0][0], (int)count[1][0]);
}

bool law_of_systems(law_source *g, char why[LAW_WHY])
{
    drawn_system d = draw_system(g);
    fmb_options o = fmb_options_default();
    fmb_result r[2];
    fmb_solver *v = NULL;
    o.method = (fmb_method)law_draw(g, 0, FMB_METHOD_DD);
    o.arith = (fmb_arith)law_draw(g, 0, FMB_ARITH_GMP);
    law_must(fmb_solver_new(&o, NULL, &v));
    law_must(fmb_solve(v, d.s, &r[0]));
    law_must(fmb_solve(v, d.scaled, &r[1]));
    bool good = r[0].verdict == r[1].verdict ||
                law_broken(why, "solve", (int)r[0].verdict, (int)r[1].verdict);
    good = good && same_boxes(&d, v, why) &&
           same_projections(&d, v, law_draw(g, 0, (1 << d.dim) - 1), why) &&
           same_optima(&d, v, g, why) && same_reductions(&d, v, why) && same_generators(&d, v, why);
    fmb_solver_free(v);
    fmb_system_free(d.s);
    fmb_system_free(d.scaled);
    return good;
}
