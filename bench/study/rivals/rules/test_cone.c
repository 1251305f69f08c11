/* test_cone.c: redundancy tests by the rays of a cone, without a linear program.
 *
 * The cone of a system a.x <= b is {(x, t) : a.x <= b t, t >= 0}. Its rays are found once, by
 * double description; without the eliminated coordinates they span the cone of the projection, so
 * the same rays serve all rounds. Let Z(r) be the rays on which row r is tight. A row with all rays
 * in Z is an implied equality and is kept. Any other row defines a face of the cone, determined by
 * Z; it is dropped if Z lies inside the Z of a kept row that is no equality, or of t >= 0, which is
 * always kept: then its face lies in the face of that row. So the kept rows are the equalities and
 * one row for each facet. In the paper the test is whether Z spans a space of one dimension less
 * than the cone, by a rank, and rows are compared; on a cone of full dimension that is the same.
 *
 * Rows with "<" or "=" are beyond the paper. For such systems the rule drops nothing in the whole
 * elimination, nor if numbers are too long, or there are more than MOST_RAYS rays. Source: Jing,
 * Moreno Maza, Talaashrafi 2020, sections 3 and 4; implemented in BPAS.
 *
 * A number to check: of |x1| + ... + |x4| <= 1, written as 16 rows, k rounds leave 2^(4 - k) rows:
 * none is redundant.
 */
#include "study/rivals/rules/rivals.h"

#include <fmb/gmp.h>
#include <stdlib.h>

enum { MOST_RAYS = 10000 };

typedef struct cone {
    bool is_tried;
    size_t rays, width; /* width: variables of the system, and t */
    mpz_t *ray;         /* [rays][width], by variable, t last; NULL: the rule is off */
} cone;

static void clear_cone(void *state)
{
    cone *c = state;
    for (size_t i = 0; c->ray && i < c->rays * c->width; i++)
        mpz_clear(c->ray[i]);
    free(c->ray);
    *c = (cone){.is_tried = true};
}

/* Has the row "<=", short integers, and variables below width - 1? */
static bool is_plain(const fmb_view *w, size_t row, size_t width)
{
    if (!fmb_view_int64(w, row) || fmb_view_rel(w, row) != FMB_LE)
        return false;
    for (int j = 0; j < fmb_view_dim(w); j++)
        if (fmb_view_sign(w, row, j) &&
            (fmb_view_variable(w, j) < 0 || (size_t)fmb_view_variable(w, j) + 1 >= width))
            return false;
    return fmb_view_int64(w, row)[fmb_view_dim(w)] != INT64_MIN;
}

static bool are_plain(const fmb_view *w, size_t width)
{
    for (size_t i = 0; i < fmb_view_rows(w); i++)
        if (!is_plain(w, fmb_view_row(w, i), width))
            return false;
    return true;
}

/* a.x - b t <= 0 for all rows, and -t <= 0. */
static fmb_status build_cone(const fmb_view *w, size_t width, fmb_system *s)
{
    int64_t *a = fmb_view_scratch(w, width * sizeof *a);
    fmb_status st = a ? FMB_OK : FMB_ERR_MEMORY;
    for (size_t i = 0; st == FMB_OK && i <= fmb_view_rows(w); i++) {
        for (size_t j = 0; j < width; j++)
            a[j] = 0;
        a[width - 1] = -1;
        if (i < fmb_view_rows(w)) {
            const int64_t *u = fmb_view_int64(w, fmb_view_row(w, i));
            for (int j = 0; j < fmb_view_dim(w); j++)
                if (u[j])
                    a[fmb_view_variable(w, j)] = u[j];
            a[width - 1] = -u[fmb_view_dim(w)];
        }
        st = fmb_system_add_int(s, a, FMB_LE, 0);
    }
    return st;
}

/* Rays once, lines once in each direction. */
static fmb_status keep_rays(cone *c, const fmb_generators *g)
{
    mpq_t q;
    mpq_init(q);
    c->ray = malloc((2 * fmb_generators_size(g) + 1) * c->width * sizeof *c->ray);
    for (size_t i = 0; c->ray && i < fmb_generators_size(g); i++)
        for (int back = 0; back <= (fmb_generators_kind(g, i) == FMB_LINE); back++) {
            mpz_t *to = c->ray + c->rays * c->width;
            if (fmb_generators_kind(g, i) == FMB_VERTEX)
                continue; /* the apex */
            for (size_t j = 0; j < c->width; j++) {
                fmb_generators_coordinate_q(g, i, (int)j, q);
                mpz_init_set(to[j], mpq_numref(q));
                if (back)
                    mpz_neg(to[j], to[j]);
            }
            c->rays++;
        }
    mpq_clear(q);
    return c->ray ? FMB_OK : FMB_ERR_MEMORY;
}

static fmb_status make_cone(cone *c, const fmb_view *w)
{
    fmb_options o = {.size = sizeof o, .evidence = FMB_EVIDENCE_NONE, .max_rows = MOST_RAYS};
    fmb_result res = {.size = sizeof res};
    fmb_system *s = NULL;
    fmb_solver *v = NULL;
    fmb_generators *g = NULL;
    c->is_tried = true;
    c->width = 1;
    for (int j = 0; j < fmb_view_dim(w); j++)
        if (fmb_view_variable(w, j) + 2 > (int)c->width)
            c->width = (size_t)fmb_view_variable(w, j) + 2;
    if (!are_plain(w, c->width))
        return FMB_OK;
    fmb_status st = fmb_system_new((int)c->width, NULL, &s);
    if (st == FMB_OK)
        st = build_cone(w, c->width, s);
    if (st == FMB_OK)
        st = fmb_solver_new(&o, NULL, &v);
    if (st == FMB_OK)
        st = fmb_generate(v, s, &g, &res);
    if (st == FMB_OK && g && res.stop == FMB_STOP_DONE)
        st = keep_rays(c, g);
    fmb_generators_free(g);
    fmb_solver_free(v);
    fmb_system_free(s);
    return st;
}

/* The sign of b t - a.x at a ray. */
static int measure(const cone *c, const fmb_view *w, const int64_t *u, size_t ray, mpz_t sum)
{
    const mpz_t *r = (const mpz_t *)(c->ray + ray * c->width);
    mpz_mul_si(sum, r[c->width - 1], u[fmb_view_dim(w)]);
    for (int j = 0; j < fmb_view_dim(w); j++)
        if (u[j] > 0)
            mpz_submul_ui(sum, r[fmb_view_variable(w, j)], (unsigned long)u[j]);
        else if (u[j] < 0)
            mpz_addmul_ui(sum, r[fmb_view_variable(w, j)], 0 - (unsigned long)u[j]);
    return mpz_sgn(sum);
}

/* z[i]: the rays on which row i is tight; z[rows]: rays with t = 0. False if a ray violates a row.
 */
static bool find_tight_rays(const cone *c, const fmb_view *w, uint64_t *z, size_t words)
{
    size_t rows = fmb_view_rows(w);
    bool is_inside = true;
    mpz_t sum;
    mpz_init(sum);
    for (size_t r = 0; r < c->rays; r++) {
        const uint64_t bit = UINT64_C(1) << r % 64;
        for (size_t i = 0; i < rows; i++) {
            int sign = measure(c, w, fmb_view_int64(w, fmb_view_row(w, i)), r, sum);
            is_inside = is_inside && sign >= 0;
            z[i * words + r / 64] |= sign == 0 ? bit : 0;
        }
        if (mpz_sgn(c->ray[r * c->width + c->width - 1]) == 0)
            z[rows * words + r / 64] |= bit;
    }
    mpz_clear(sum);
    return is_inside;
}

static bool is_inside_of(const uint64_t *a, const uint64_t *b, size_t words)
{
    for (size_t k = 0; k < words; k++)
        if (a[k] & ~b[k])
            return false;
    return true;
}

static void drop_faces_in_others(const fmb_view *w, const uint64_t *z, size_t words, size_t rays,
                                 bool *drop)
{
    size_t rows = fmb_view_rows(w);
    for (size_t k = 0; k < rows && !fmb_view_stop(w); k++)
        for (size_t i = 0; rival_count(z + k * words, words) < (int)rays && i <= rows; i++)
            if (i != k && (i == rows || !drop[i]) &&
                rival_count(z + i * words, words) < (int)rays &&
                is_inside_of(z + k * words, z + i * words, words)) {
                drop[k] = true;
                break;
            }
}

static fmb_status drop_redundant_rows(void *state, const fmb_view *w, bool *drop)
{
    cone *c = state;
    fmb_status st = c->is_tried ? FMB_OK : make_cone(c, w);
    if (st != FMB_OK || !c->ray || !are_plain(w, c->width))
        return st;
    size_t words = c->rays / 64 + 1;
    uint64_t *z = fmb_view_scratch(w, (fmb_view_rows(w) + 1) * words * sizeof *z);
    if (!z)
        return FMB_ERR_MEMORY;
    for (size_t i = 0; i < (fmb_view_rows(w) + 1) * words; i++)
        z[i] = 0;
    if (find_tight_rays(c, w, z, words))
        drop_faces_in_others(w, z, words, c->rays, drop);
    return FMB_OK;
}

const fmb_rule rival_test_cone = {
    .name = "test-cone",
    .source = "JingMorenoMaza2020",
    .flags = FMB_RULE_BREAKS_HISTORY,
    .state_bytes = sizeof(cone),
    .end_round = drop_redundant_rows,
    .clear = clear_cone,
};
