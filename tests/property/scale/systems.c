/* systems.c: the law of systems (law.h): x_j = 2^column[j] y_j in each row, and each row times
 * 2^row[i] of its own.
 */
#include <math.h>

#include "property/scale/table.h"

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
    must(fmb_system_new(d.dim, NULL, &d.s));
    must(fmb_system_new(d.dim, NULL, &d.scaled));
    for (int i = 0; i < d.rows; i++) {
        static const fmb_rel rel[] = {FMB_LE, FMB_LE, FMB_LE, FMB_LE, FMB_LT, FMB_LE, FMB_EQ};
        double a[MOST_DIM], b[MOST_DIM];
        fmb_rel r = rel[law_draw(g, 0, 6)];
        int right = law_draw(g, -most, 2 * most > 15 ? 15 : 2 * most);
        for (int j = 0; j < d.dim; j++) {
            a[j] = law_draw(g, -most, most);
            b[j] = ldexp(a[j], row[i] + d.column[j]);
        }
        must(fmb_system_add(d.s, a, r, right));
        must(fmb_system_add(d.scaled, b, r, ldexp(right, row[i])));
    }
    return d;
}

static bool same_boxes(const drawn_system *d, fmb_solver *v, char why[LAW_WHY])
{
    fmb_box *box[2];
    fmb_result r[2] = {{.size = sizeof r[0]}, {.size = sizeof r[0]}};
    bool same = true;
    mpq_t end[2];
    mpq_inits(end[0], end[1], NULL);
    must(fmb_bound(v, d->s, NULL, 0, &box[0], &r[0]));
    must(fmb_bound(v, d->scaled, NULL, 0, &box[1], &r[1]));
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

/* [give] b, with y_j in place of 2^power[j] y_j. */
static fmb_system *scaled_back(const fmb_system *b, const int *power)
{
    fmb_system *t;
    int dim = fmb_system_dim(b), var[MOST_DIM];
    mpq_t coef[MOST_DIM], right;
    mpq_init(right);
    for (int j = 0; j < MOST_DIM; j++)
        mpq_init(coef[j]);
    must(fmb_system_new(dim, NULL, &t));
    for (size_t i = 0; i < fmb_system_rows(b); i++) {
        size_t terms = fmb_system_terms(b, i);
        for (size_t k = 0; k < terms; k++) {
            var[k] = fmb_system_term_q(b, i, k, coef[k]);
            law_shift(coef[k], -power[var[k]]);
        }
        fmb_system_rhs_q(b, i, right);
        must(fmb_system_add_q(t, terms, var, coef, fmb_system_rel(b, i), right));
    }
    for (int j = 0; j < MOST_DIM; j++)
        mpq_clear(coef[j]);
    mpq_clear(right);
    return t;
}

/* Equal sets have the same projection on all of their variables, row by row. */
static bool are_same_sets(fmb_solver *v, const fmb_system *a, const fmb_system *b, const int *power)
{
    static const int all[MOST_DIM] = {0, 1, 2, 3};
    fmb_system *back = scaled_back(b, power), *form[2];
    must(fmb_project(v, a, all, fmb_system_dim(a), &form[0], NULL));
    must(fmb_project(v, back, all, fmb_system_dim(a), &form[1], NULL));
    bool same = law_same_rows(form[0], form[1], NULL);
    fmb_system_free(back);
    fmb_system_free(form[0]);
    fmb_system_free(form[1]);
    return same;
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
    must(fmb_project(v, d->s, keep, n, &out[0], NULL));
    must(fmb_project(v, d->scaled, keep, n, &out[1], NULL));
    bool same = are_same_sets(v, out[0], out[1], power);
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
    must(fmb_optimize(v, d->s, &(fmb_objective){FMB_SENSE_MAX, a, 0}, &out[0], NULL));
    must(fmb_optimize(v, d->scaled, &(fmb_objective){FMB_SENSE_MAX, b, 0}, &out[1], NULL));
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
    must(fmb_reduce(v, d->s, NULL, &out[0], NULL));
    must(fmb_reduce(v, d->scaled, NULL, &out[1], NULL));
    int rows[2] = {(int)fmb_system_rows(out[0]), (int)fmb_system_rows(out[1])};
    bool same = are_same_sets(v, out[0], out[1], d->column);
    fmb_system_free(out[0]);
    fmb_system_free(out[1]);
    return same || law_broken(why, "reduce", rows[0], rows[1]);
}

/* Times 2^power[j] each, as rows (1, x) of vertices and (0, x) of rays and lines. */
static void take_generators(const fmb_generators *g, const int *power, int dim, law_table *out)
{
    law_table_open(out, dim + 1);
    for (size_t i = 0; g && i < fmb_generators_size(g); i++) {
        fmb_generator_kind kind = fmb_generators_kind(g, i);
        int of = kind == FMB_LINE ? LAW_SPANS : kind == FMB_VERTEX ? 1 : 2;
        mpq_t *row = law_table_append(out, of);
        mpq_set_ui(row[0], kind == FMB_VERTEX, 1);
        for (int j = 0; j < dim; j++) {
            fmb_generators_coordinate_q(g, i, j, row[j + 1]);
            law_shift(row[j + 1], power ? power[j] : 0);
        }
    }
}

static bool same_generators(const drawn_system *d, fmb_solver *v, char why[LAW_WHY])
{
    fmb_generators *out[2];
    law_table table[2];
    must(fmb_generate(v, d->s, &out[0], NULL));
    must(fmb_generate(v, d->scaled, &out[1], NULL));
    take_generators(out[0], NULL, d->dim, &table[0]);
    take_generators(out[1], d->column, d->dim, &table[1]);
    int size[2] = {(int)table[0].size, (int)table[1].size};
    bool same = size[0] == size[1] && law_same_tables(&table[0], &table[1]);
    for (int w = 0; w < 2; w++) {
        law_table_close(&table[w]);
        fmb_generators_free(out[w]);
    }
    return same || law_broken(why, "generators", size[0], size[1]);
}

bool law_of_systems(law_source *g, char why[LAW_WHY])
{
    drawn_system d = draw_system(g);
    fmb_options o = {.size = sizeof o};
    fmb_result r[2] = {{.size = sizeof r[0]}, {.size = sizeof r[0]}};
    fmb_solver *v = NULL;
    o.method = (fmb_method)law_draw(g, 0, FMB_METHOD_DD);
    o.arith = (fmb_arith)law_draw(g, 0, FMB_ARITH_GMP);
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, d.s, &r[0]));
    must(fmb_solve(v, d.scaled, &r[1]));
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
