/* hulls.c: is a point in a hull? The claims of the search in doubles are recomputed from the points
 * alone. And exact combinations, recomputed from the rows. */
#include <criterion/criterion.h>
#include <math.h>

#include "lp/linalg/exact/combination.h"
#include "lp/redundancy/ray_shooting/membership.h"
#include "scene.h"
#include "support/dense.h"

/* ---- hulls ----------------------------------------------------------------------------------- */

enum { MOST_D = 6, MOST_POINTS = 60 };

typedef struct cloud {
    size_t d, n;
    double at[MOST_POINTS][MOST_D];
} cloud;

static void draw_point(support_rng *g, const cloud *p, double *q)
{
    int most = support_chance(g, 30) ? 1 : 100; /* some of them degenerate */
    for (size_t k = 0; k < p->d; k++)
        q[k] = (double)support_between(g, -most, most) / most;
}

static double times(const cloud *p, const double *a, const double *b)
{
    double sum = 0;
    for (size_t k = 0; k < p->d; k++)
        sum += a[k] * b[k];
    return sum;
}

/* z >= 0 makes up the target, and adds up to 1 at most. */
static void check_inside(const cloud *p, const fmb_membership *g, const double *q)
{
    double sum = 0, left[MOST_D];
    for (size_t k = 0; k < p->d; k++)
        left[k] = q[k];
    for (size_t r = 0; r < p->d; r++) {
        size_t j = fmb_membership_name(g, r);
        double z = fmb_membership_value(g, r);
        cr_assert(j == SIZE_MAX ? fabs(z) < 1e-8 : z > -1e-8);
        sum += j != SIZE_MAX ? z : 0;
        for (size_t k = 0; j != SIZE_MAX && k < p->d; k++)
            left[k] -= z * p->at[j][k];
    }
    cr_assert_leq(sum, 1 + 1e-7);
    cr_assert_leq(times(p, left, left), 1e-14);
}

static void check_outside(const cloud *p, const fmb_membership *g, const double *q, const bool *in)
{
    const double error = 1e-6;
    cr_assert_gt(times(p, g->way, q), 1 - error);
    for (size_t j = 0; j < p->n; j++)
        cr_assert(!in[j] || times(p, g->way, p->at[j]) < 1 + error);
}

/* Points come and are forgotten between questions. */
static void question_cloud(support_rng *g, size_t *answers)
{
    cloud p = {.d = (size_t)support_between(g, 1, MOST_D)};
    bool in[MOST_POINTS] = {0};
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    fmb_membership gauge;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    cr_assert_eq(fmb_membership_init(&gauge, &run, p.d), FMB_OK);
    for (int k = 0; k < 80; k++) {
        double q[MOST_D];
        fmb_side_of_hull side;
        if (p.n < MOST_POINTS && support_chance(g, 60)) {
            draw_point(g, &p, p.at[p.n]);
            in[p.n] = true;
            cr_assert_eq(fmb_membership_add(&gauge, p.at[p.n], p.n), FMB_OK);
            p.n++;
        }
        if (support_chance(g, 5)) {
            cr_assert_eq(fmb_membership_forget(&gauge), FMB_OK);
            for (size_t j = 0; j < p.n; j++)
                in[j] = false;
            for (size_t j = 0; j < fmb_membership_size(&gauge); j++)
                in[gauge.name[j]] = true;
        }
        draw_point(g, &p, q);
        cr_assert_eq(fmb_membership_ask(&gauge, q, support_chance(g, 10), &side), FMB_OK);
        if (side == FMB_HULL_OUTSIDE)
            check_outside(&p, &gauge, q, in);
        if (side == FMB_HULL_INSIDE)
            check_inside(&p, &gauge, q);
        answers[side]++;
    }
    fmb_membership_clear(&gauge);
    cr_expect_eq(mem.used, 0);
}

Test(hulls, inside_or_outside)
{
    support_rng g = {3};
    size_t answers[FMB_HULL_OUTSIDE + 1] = {0};
    for (int k = 0; k < 400; k++)
        question_cloud(&g, answers);
    cr_expect_gt(answers[FMB_HULL_INSIDE], 3000);
    cr_expect_gt(answers[FMB_HULL_OUTSIDE], 3000);
    cr_expect_lt(answers[FMB_HULL_NONE], 100, "%zu", answers[FMB_HULL_NONE]);
}

/* ---- combinations ---------------------------------------------------------------------------- */

/* all (row i) = sum of part_k (row k), in every column; left is what the right sides leave. */
static void check_combination(const scene *c, const fmb_combination *f, size_t i)
{
    mpz_t sum, t, product;
    mpz_inits(sum, t, product, NULL);
    cr_assert_gt(mpz_sgn(f->all), 0);
    for (size_t j = 0; j <= c->n; j++) {
        fmb_vec_get(c->row[i].v, j, sum);
        mpz_mul(sum, sum, f->all);
        for (size_t k = 0; k < f->size; k++) {
            fmb_vec_get(c->row[f->index[k]].v, j, t);
            mpz_submul(sum, t, f->part[k]);
        }
        cr_assert_eq(j < c->n ? mpz_sgn(sum) : mpz_cmp(sum, f->left), 0);
    }
    mpz_clears(sum, t, product, NULL);
}

/* Drawn like the others; a combination of them; or that but for the prime in one column, which
 * remainders do not tell. */
typedef enum last_row { ANY_ROW, PLANTED_ROW, HIDDEN_ROW } last_row;

static bool combine_drawn_rows(support_rng *g, int n, int size, int bits, last_row last)
{
    dense d = dense_new(n, size + 1);
    mpz_t z;
    mpz_init(z);
    for (int i = 0; i <= size; i++)
        for (int j = 0; j <= n; j++) {
            if (i < size || last == ANY_ROW) {
                support_integer(g, bits, z);
                mpq_set_z(dense_row(&d, i)[j], z);
                continue;
            }
            for (int k = 0; k < size; k++) {
                mpq_t t;
                mpq_init(t);
                mpq_set_si(t, 3 * k - 4, (unsigned long)k + 1);
                mpq_canonicalize(t);
                mpq_mul(t, t, dense_row(&d, k)[j]);
                mpq_add(dense_row(&d, i)[j], dense_row(&d, i)[j], t);
                mpq_clear(t);
            }
        }
    mpz_ui_pow_ui(z, 2, 61);
    mpz_sub_ui(z, z, 1);
    if (last == HIDDEN_ROW)
        mpz_addmul(mpq_numref(dense_row(&d, size)[0]), z, mpq_denref(dense_row(&d, size)[0]));
    fmb_system *s = dense_system(&d);
    scene c;
    bool found = false;
    if (scene_open(&c, s) && c.m == (size_t)size + 1) {
        fmb_combination f;
        size_t support[16];
        for (size_t k = 0; k < (size_t)size; k++)
            support[k] = k;
        cr_assert_eq(fmb_combination_init(&f, &c.mem, c.n, c.row), FMB_OK);
        cr_assert_eq(fmb_combine(&f, &c.run, (size_t)size, support, (size_t)size, &found), FMB_OK);
        if (found)
            check_combination(&c, &f, (size_t)size);
        fmb_combination_clear(&f);
    }
    scene_close(&c);
    fmb_system_free(s);
    dense_free(&d);
    mpz_clear(z);
    return found;
}

Test(hulls, exact_combinations)
{
    static const int bits[] = {0, 31, 62, 63, 200, 600, 1100};
    support_rng g = {9};
    int found = 0, square = 0;
    for (int k = 0; k < 300; k++) {
        int n = support_between(&g, 1, 12), size = support_between(&g, 1, n);
        found += combine_drawn_rows(&g, n, size, bits[k % 7], PLANTED_ROW);
        square += combine_drawn_rows(&g, n, n, bits[k % 7], ANY_ROW);
        if (n >= 3) { /* a row that is no combination is none */
            cr_expect(!combine_drawn_rows(&g, n, n - 2, bits[k % 7], ANY_ROW));
            cr_expect(!combine_drawn_rows(&g, n, n - 2, bits[k % 7], HIDDEN_ROW));
        }
    }
    cr_expect_gt(found, 270, "%d", found); /* where the rows are independent */
    cr_expect_gt(square, 270, "%d", square);
}

/* ---- what combinations prove ----------------------------------------------------------------- */

enum { PROVED_ROWS = 4 };

/* Rows x <= 1, y <= 1, x - y <= 1 with these relations; then the row that two of them shall prove.
 */
static bool is_row_proved(const fmb_rel *rel, int64_t a, int64_t b, int64_t right, fmb_rel wanted,
                          const size_t support[2])
{
    int64_t number[PROVED_ROWS][3] = {{1, 0, 1}, {0, 1, 1}, {1, -1, 1}, {a, b, right}};
    fmb_vec v[PROVED_ROWS];
    fmb_lp_row row[PROVED_ROWS];
    fmb_combination f;
    fmb_mem mem;
    fmb_run run;
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    bool found, proves;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (int i = 0; i < PROVED_ROWS; i++) {
        v[i] = (fmb_vec){.s = number[i]};
        fmb_vec_measure(&v[i], 3);
        row[i] = (fmb_lp_row){&v[i], i == PROVED_ROWS - 1 ? wanted : rel[i]};
    }
    cr_assert_eq(fmb_combination_init(&f, &mem, 2, row), FMB_OK);
    cr_assert_eq(fmb_combine(&f, &run, PROVED_ROWS - 1, support, 2, &found), FMB_OK);
    cr_assert(found);
    proves = fmb_combination_proves(&f);
    fmb_combination_clear(&f);
    cr_assert_eq(mem.used, 0);
    return proves;
}

/* a x + b y by two of the rows: factors that are negative want equalities, and a strict row a
 * smaller right side or a strict row that counts. */
Test(hulls, combinations_prove_what_signs_and_relations_allow)
{
    static const fmb_rel RELS[] = {FMB_LE, FMB_LT, FMB_EQ};
    static const int64_t ROWS[3][2] = {{1, 0}, {0, 1}, {1, -1}};
    int proved = 0, refused = 0;
    for (int code = 0; code < 27 * 3 * 25 * 3; code++) {
        const fmb_rel rel[3] = {RELS[code % 3], RELS[code / 3 % 3], RELS[code / 9 % 3]};
        const size_t p = (size_t)(code / 27 % 3), support[2] = {p, (p + 1) % 3};
        const int64_t f[2] = {code / 81 % 5 - 2, code / 405 % 5 - 2};
        const int shift = code / 2025 - 1;
        int64_t a = 0, b = 0;
        bool allowed = true, strict = false;
        for (int k = 0; k < 2; k++) {
            a += f[k] * ROWS[support[k]][0];
            b += f[k] * ROWS[support[k]][1];
            allowed = allowed && (f[k] >= 0 || rel[support[k]] == FMB_EQ);
            strict = strict || (f[k] > 0 && rel[support[k]] == FMB_LT);
        }
        if (a == 0 && b == 0)
            continue;
        for (int wanted = 0; wanted < 2; wanted++) {
            bool truth = allowed && (shift > 0 || (shift == 0 && (wanted == 0 || strict)));
            bool says = is_row_proved(rel, a, b, f[0] + f[1] + shift, RELS[wanted], support);
            cr_assert_eq(says, truth, "%d", code);
            proved += says;
            refused += !says;
        }
    }
    cr_expect(proved > 1000 && refused > 1000, "%d, %d", proved, refused);
}
