/* block.c: block elimination: all variables at once, by the rays of a cone.
 *
 * The multipliers that cancel the eliminated variables form the projection cone {y : y_i >= 0
 * unless row i is an equation, y A_gone = 0}. Its rays and lines are found by double description,
 * and each makes a row y A_kept x <= y b: strict if y is positive on a strict row, an equation for
 * a line. Every combination of rows that cancels these variables is a nonnegative sum of such rows,
 * so they describe the projection (Farkas' lemma); a sum is strict only if a summand is. No ray has
 * its support inside another's, so these are the rows that Chernikov's rule keeps in the end, some
 * of them redundant. Source: Chernikov 1960; Balas, Pulleyblank 1983; the name after Jing and
 * others 2020.
 *
 * A number to check: of |x1| + ... + |x4| <= 1, written as 16 rows, without x1, x2, x3: 48 rays, of
 * which 28 name x4 (lib/rule/chernikov.c counts them).
 */
#include "study/engines/engines.h"

#include <fmb/gmp.h>
#include <stdlib.h>

/* A row of the cone: column j of the system, or y_i >= 0 where j is no variable. */
static fmb_status add_column(const fmb_system *s, int j, fmb_system *cone, int *var, mpq_t *coef,
                             mpq_t zero)
{
    size_t n = 0;
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        for (size_t k = 0; k < fmb_system_terms(s, i); k++)
            if (fmb_system_term_q(s, i, k, coef[n]) == j)
                var[n++] = (int)i;
    return fmb_system_add_q(cone, n, var, coef, FMB_EQ, zero);
}

static fmb_status add_sign(int i, fmb_system *cone, mpq_t *coef, mpq_t zero)
{
    mpq_set_si(coef[0], -1, 1);
    return fmb_system_add_q(cone, 1, &i, coef, FMB_LE, zero);
}

static bool is_kept(int j, const int *keep, int n)
{
    for (int k = 0; k < n; k++)
        if (keep[k] == j)
            return true;
    return false;
}

static fmb_status build_cone(const fmb_system *s, const int *keep, int n, fmb_system *cone,
                             int *var, mpq_t *coef, mpq_t zero)
{
    fmb_status st = FMB_OK;
    for (int j = 0; st == FMB_OK && j < fmb_system_dim(s); j++)
        if (!is_kept(j, keep, n))
            st = add_column(s, j, cone, var, coef, zero);
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++)
        if (fmb_system_rel(s, i) != FMB_EQ)
            st = add_sign((int)i, cone, coef, zero);
    return st;
}

/* The row whose multipliers are generator g. entry[n + 1], and three more numbers as scratch. */
static fmb_status add_combination(const fmb_system *s, const int *keep, int n,
                                  const fmb_generators *of, size_t g, int *var, mpq_t *entry,
                                  fmb_system *out)
{
    mpq_t *y = entry + n + 1, *a = y + 1;
    bool is_strict = false;
    for (int k = 0; k <= n; k++)
        mpq_set_ui(entry[k], 0, 1);
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        fmb_generators_coordinate_q(of, g, (int)i, *y);
        is_strict = is_strict || (mpq_sgn(*y) > 0 && fmb_system_rel(s, i) == FMB_LT);
        for (size_t t = 0; mpq_sgn(*y) && t < fmb_system_terms(s, i); t++) {
            int j = fmb_system_term_q(s, i, t, *a);
            mpq_mul(*a, *a, *y);
            for (int k = 0; k < n; k++)
                if (keep[k] == j)
                    mpq_add(entry[k], entry[k], *a);
        }
        fmb_system_rhs_q(s, i, *a);
        mpq_mul(*a, *a, *y);
        mpq_add(entry[n], entry[n], *a);
    }
    for (int k = 0; k < n; k++)
        var[k] = k;
    fmb_rel rel = fmb_generators_kind(of, g) == FMB_LINE ? FMB_EQ : is_strict ? FMB_LT : FMB_LE;
    return fmb_system_add_q(out, (size_t)n, var, entry, rel, entry[n]);
}

static fmb_status generate(const fmb_system *cone, fmb_generators **out)
{
    fmb_options o = {.size = sizeof o, .evidence = FMB_EVIDENCE_NONE};
    fmb_result res = {.size = sizeof res};
    fmb_solver *v = NULL;
    fmb_status st = fmb_solver_new(&o, NULL, &v);
    if (st == FMB_OK)
        st = fmb_generate(v, cone, out, &res);
    fmb_solver_free(v);
    return st;
}

fmb_status study_block_project(const fmb_system *s, const int *keep, int n, fmb_system **out,
                               size_t *rays)
{
    size_t rows = fmb_system_rows(s), most = rows + (size_t)n + 3;
    fmb_system *cone = NULL, *image = NULL;
    fmb_generators *g = NULL;
    int *var = calloc(most, sizeof *var);
    mpq_t *number = calloc(most + 1, sizeof *number);
    for (size_t i = 0; number && i <= most; i++)
        mpq_init(number[i]);
    fmb_status st = var && number ? FMB_OK : FMB_ERR_MEMORY;
    if (st == FMB_OK)
        st = fmb_system_new((int)rows, NULL, &cone);
    if (st == FMB_OK)
        st = build_cone(s, keep, n, cone, var, number, number[most]);
    if (st == FMB_OK)
        st = generate(cone, &g);
    if (st == FMB_OK)
        st = fmb_system_new(n, NULL, &image);
    size_t made = 0;
    for (size_t i = 0; st == FMB_OK && i < fmb_generators_size(g); i++)
        if (fmb_generators_kind(g, i) != FMB_VERTEX) {
            st = add_combination(s, keep, n, g, i, var, number, image);
            made++;
        }
    for (size_t i = 0; number && i <= most; i++)
        mpq_clear(number[i]);
    free(number);
    free(var);
    fmb_generators_free(g);
    fmb_system_free(cone);
    if (rays)
        *rays = made;
    if (st != FMB_OK)
        fmb_system_free(image);
    else
        *out = image;
    return st;
}
