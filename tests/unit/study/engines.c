/* engines.c: block elimination and Balas' projection against fmb_project, on random systems of
 * every family; known counts. FMB_ENGINE_SYSTEMS: the number of seeds of each family. */
#include <criterion/criterion.h>
#include <string.h>

#include "study/engines/engines.h"
#include "support/must.h"
#include "support/support.h"

static const size_t USUAL_SEEDS = 40;

static size_t seeds(void)
{
    const char *text = getenv("FMB_ENGINE_SYSTEMS");
    return text ? strtoul(text, NULL, 10) : USUAL_SEEDS;
}

/* The projection on the last n variables; its form is canonical. */
static fmb_system *project(const fmb_system *s, int n)
{
    fmb_system *out = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_solver *v = must_open((fmb_options){.evidence = FMB_EVIDENCE_NONE});
    int keep[8];
    for (int k = 0; k < n; k++)
        keep[k] = fmb_system_dim(s) - n + k;
    must(fmb_project(v, s, keep, n, &out, &res));
    fmb_solver_free(v);
    return out;
}

static bool is_same_row(const fmb_system *a, const fmb_system *b, size_t i)
{
    mpq_t x, y;
    mpq_inits(x, y, NULL);
    bool same = fmb_system_rel(a, i) == fmb_system_rel(b, i) &&
                fmb_system_terms(a, i) == fmb_system_terms(b, i);
    for (size_t k = 0; same && k < fmb_system_terms(a, i); k++)
        same = fmb_system_term_q(a, i, k, x) == fmb_system_term_q(b, i, k, y) && mpq_equal(x, y);
    fmb_system_rhs_q(a, i, x);
    fmb_system_rhs_q(b, i, y);
    same = same && mpq_equal(x, y);
    mpq_clears(x, y, NULL);
    return same;
}

static bool is_same(const fmb_system *a, const fmb_system *b)
{
    bool same = fmb_system_rows(a) == fmb_system_rows(b);
    for (size_t i = 0; same && i < fmb_system_rows(a); i++)
        same = is_same_row(a, b, i);
    return same;
}

/* Does `found`, whatever form it has, describe what the canonical system describes? */
static bool describes(const fmb_system *found, const fmb_system *canonical)
{
    fmb_system *again = project(found, fmb_system_dim(found));
    bool same = is_same(again, canonical);
    fmb_system_free(again);
    return same;
}

static bool has_relation(const fmb_system *s, fmb_rel rel)
{
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        if (fmb_system_rel(s, i) == rel)
            return true;
    return false;
}

static bool is_empty(const fmb_system *canonical)
{
    return fmb_system_rows(canonical) == 1 && fmb_system_terms(canonical, 0) == 0;
}

static bool is_full(const fmb_system *canonical)
{
    return !has_relation(canonical, FMB_EQ) && !is_empty(canonical);
}

/* Balas' ways, of a system of "<=" alone: right, and the mended one as small as the projection. */
static void judge_balas(const fmb_system *s, const int *keep, int n, const fmb_system *truth)
{
    for (int how = STUDY_BALAS_PRINTED; how <= STUDY_BALAS_MENDED; how++) {
        fmb_system *found = NULL;
        must(study_balas_project(s, keep, n, (study_balas)how, &found));
        cr_assert(!found == !is_full(truth) || (how == STUDY_BALAS_PRINTED && is_empty(truth)));
        if (found) {
            cr_assert(describes(found, truth), "balas, %d", how);
            cr_assert(fmb_system_rows(found) == fmb_system_rows(truth) || how != STUDY_BALAS_MENDED,
                      "%zu rows", fmb_system_rows(found));
            cr_assert(fmb_system_rows(found) >= fmb_system_rows(truth));
        }
        fmb_system_free(found);
    }
}

static void judge(const fmb_system *s, int n)
{
    int keep[8];
    for (int k = 0; k < n; k++)
        keep[k] = fmb_system_dim(s) - n + k;
    fmb_system *truth = project(s, n), *found = NULL;
    must(study_block_project(s, keep, n, &found, NULL));
    cr_assert(describes(found, truth), "block elimination");
    if (!has_relation(s, FMB_LT) && !has_relation(s, FMB_EQ))
        judge_balas(s, keep, n, truth);
    fmb_system_free(found);
    fmb_system_free(truth);
}

Test(engines, are_right_on_random_systems)
{
    for (size_t seed = 0; seed < seeds(); seed++)
        for (int family = 0; family < SUPPORT_FAMILIES; family++) {
            support_case c = support_make((support_family)family, seed, NULL);
            fmb_system *closed = support_closure(c.s);
            for (int n = 1; n <= 2 && n < fmb_system_dim(c.s); n++) {
                judge(c.s, n);
                judge(closed, n);
            }
            fmb_system_free(closed);
            support_case_clear(&c);
        }
}

/* |x1| + ... + |x4| <= 1 in 16 rows: 48 minimal sets, of which 28 name x4 (block.c); 2 facets. */
Test(engines, count_the_diamond)
{
    fmb_system *s = NULL, *found = NULL;
    size_t rays, named = 0;
    must(fmb_system_new(4, NULL, &s));
    for (int i = 0; i < 16; i++) {
        int64_t a[4];
        for (int j = 0; j < 4; j++)
            a[j] = 1 - 2 * (i >> j & 1);
        must(fmb_system_add_int(s, a, FMB_LE, 1));
    }
    must(study_block_project(s, (int[]){3}, 1, &found, &rays));
    for (size_t i = 0; i < fmb_system_rows(found); i++)
        named += fmb_system_terms(found, i) > 0;
    cr_assert(rays == 48 && named == 28, "%zu rays, %zu name x4", rays, named);
    fmb_system_free(found);
    must(study_balas_project(s, (int[]){3}, 1, STUDY_BALAS_MENDED, &found));
    cr_assert(fmb_system_rows(found) == 2);
    fmb_system_free(found);
    fmb_system_free(s);
}

/* Where the cone as printed is not minimal: of x <= 1, by a pair, and x <= 2 both are extreme. */
Test(engines, balas_as_printed_keeps_a_redundant_row)
{
    fmb_system *s = NULL, *printed = NULL, *mended = NULL;
    must(fmb_system_new(2, NULL, &s));
    must(fmb_system_add_int(s, (int64_t[]){1, 1}, FMB_LE, 1));
    must(fmb_system_add_int(s, (int64_t[]){-1, 1}, FMB_LE, 1));
    must(fmb_system_add_int(s, (int64_t[]){0, 1}, FMB_LE, 2));
    must(study_balas_project(s, (int[]){1}, 1, STUDY_BALAS_PRINTED, &printed));
    must(study_balas_project(s, (int[]){1}, 1, STUDY_BALAS_MENDED, &mended));
    cr_assert(fmb_system_rows(printed) == 2);
    cr_assert(fmb_system_rows(mended) == 1);
    fmb_system_free(printed);
    fmb_system_free(mended);
    fmb_system_free(s);
}

Test(engines, balas_takes_no_strict_row)
{
    fmb_system *s = NULL, *found = NULL;
    must(fmb_system_new(1, NULL, &s));
    must(fmb_system_add_int(s, (int64_t[]){1}, FMB_LT, 1));
    cr_assert(study_balas_project(s, (int[]){0}, 1, STUDY_BALAS_MENDED, &found) == FMB_ERR_ARG);
    cr_assert(!found);
    fmb_system_free(s);
}
