/* normals.c: the least overlap of two frames, against a search in integers. */
#include <criterion/criterion.h>

#include "proximity/proximity_private.h"
#include "study/draw/pairs.h"
#include "support/must.h"

/* ---- without doubles ------------------------------------------------------------------------- */

#define fmb_has_normals           plain_has_normals
#define fmb_least_overlap_init    plain_least_overlap_init
#define fmb_least_overlap_clear   plain_least_overlap_clear
#define fmb_find_least_overlap    plain_find_least_overlap
#define fmb_normal_search_scale   plain_normal_search_scale
#define fmb_normal_search_take    plain_normal_search_take
#define fmb_normal_is_independent plain_normal_is_independent
#define fmb_normal_is_surely_more plain_normal_is_surely_more
#define fmb_normal_bound          plain_normal_bound
#include "proximity/least_overlap.c"

void plain_normal_search_scale(fmb_normal_search *x)
{
    for (int j = 0; j < x->m->dim; j++)
        x->coarsest = x->unit[j] > x->coarsest ? x->unit[j] : x->coarsest;
}

void plain_normal_search_take(fmb_normal_search *x, const fmb_least_overlap *least)
{
    (void)x, (void)least;
}

bool plain_normal_is_independent(fmb_normal_search *x, int chosen)
{
    (void)x, (void)chosen;
    return false;
}

bool plain_normal_is_surely_more(const fmb_normal_search *x)
{
    (void)x;
    return false;
}

fmb_normal_bounds plain_normal_bound(const fmb_normal_search *x)
{
    (void)x;
    return (fmb_normal_bounds){0, 0};
}

#undef fmb_find_least_overlap
fmb_status fmb_find_least_overlap(fmb_minkowski *m, fmb_norm norm, fmb_run *run,
                                  fmb_least_overlap *out);

/* ---- both ------------------------------------------------------------------------------------ */

static bool plainly;
static fmb_least_overlap least[2];

static fmb_status answer(fmb_minkowski *m, fmb_run *run, fmb_proximity *out, fmb_verdict *verdict)
{
    *verdict = FMB_FEASIBLE;
    return (plainly ? plain_find_least_overlap : fmb_find_least_overlap)(m, out->norm, run,
                                                                         &least[plainly]);
}

static fmb_status ask(fmb_solver *v, fmb_minkowski *m, fmb_proximity *out, fmb_result *res)
{
    return fmb_proximity_ask(v, m, "normals", answer, out, res);
}

/* least[1] < 0, or both are the same: a / b and c / d, whose numerators may be squared first. */
static bool are_equal(fmb_norm norm)
{
    fmb_least_overlap *x = &least[0], *y = &least[1];
    if (x->found != y->found || mpz_sgn(x->overlap) != mpz_sgn(y->overlap))
        return false;
    if (!x->found || mpz_sgn(x->overlap) <= 0)
        return true;
    for (int k = 0; k < 2; k++)
        if (norm == FMB_NORM_EUCLIDEAN)
            mpz_mul(least[k].overlap, least[k].overlap, least[k].overlap);
    mpz_mul(x->overlap, x->overlap, y->size);
    mpz_mul(y->overlap, y->overlap, x->size);
    return mpz_cmp(x->overlap, y->overlap) == 0;
}

static void try_pair(fmb_solver *v, const fmb_frame *f, fmb_norm norm, const char *family,
                     uint64_t k)
{
    for (int i = 0; i < 2; i++) {
        fmb_proximity *p = NULL;
        plainly = i == 1;
        fmb_least_overlap_init(&least[i]);
        must(fmb_proximity_find(v, &(fmb_two){.f = f}, norm, true, ask, &p, NULL));
        fmb_proximity_free(p);
    }
    cr_expect(are_equal(norm), "%s %d", family, (int)k);
    for (int i = 0; i < 2; i++)
        fmb_least_overlap_clear(&least[i]);
}

Test(normals, beside_whole_numbers)
{
    fmb_solver *v = must_open((fmb_options){0});
    for (int family = 0; family < STUDY_PAIR_FAMILIES; family++)
        for (uint64_t k = 0; k < 90; k++) {
            study_pair pair;
            study_pair_plan plan = {.dim = 2 + (int)k % 3 + (k > 80), .moves = k % 2};
            plan.family = (study_pair_family)family;
            plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
            plan.naxes[k % 2] = k % 5 == 3 ? plan.dim - 1 : 0;
            study_pair_draw(&plan, 20261127310, k, &pair);
            const fmb_frame f[2] = {pair.p, pair.q};
            try_pair(v, f, k % 4 == 1 ? FMB_NORM_MAX : FMB_NORM_EUCLIDEAN,
                     study_pair_family_text(plan.family), k);
        }
    fmb_solver_free(v);
}

/* A zero of a direction that is divided by 2^1073 stays 0. */
Test(normals, one_coordinate_in_denormals)
{
    static const double origin_p[] = {-1, -3, -1}, origin_q[] = {-7, -4.5, 0x3p-1074},
                        axes_p[] = {-2, 0, 1, -2, 0, 1, 2, -3, -2},
                        axes_q[] = {3, 0, 0, 0, 3, 0, 0, 0, 3};
    const fmb_frame f[2] = {{FMB_CUBOID, 3, 3, origin_p, axes_p, NULL},
                            {FMB_CUBOID, 3, 3, origin_q, axes_q, NULL}};
    fmb_solver *v = must_open((fmb_options){0});
    try_pair(v, f, FMB_NORM_EUCLIDEAN, "denormals", 0);
    try_pair(v, f, FMB_NORM_MAX, "denormals", 1);
    fmb_solver_free(v);
}

/* ---- depth and distance ---------------------------------------------------------------------- */

static fmb_verdict verdict_of(fmb_solver *v, const fmb_frame *f, bool deep)
{
    fmb_proximity *p = NULL;
    fmb_result r = {.size = sizeof r};
    must((deep ? fmb_depth : fmb_distance)(v, f, FMB_NORM_EUCLIDEAN, &p, &r));
    fmb_proximity_free(p);
    return r.verdict;
}

/* One that touches another may lose all vertices of its corral where doubles look for the nearest
 * point. */
Test(normals, verdicts_of_both)
{
    fmb_solver *v = must_open((fmb_options){0});
    for (int family = 0; family < STUDY_PAIR_FAMILIES; family++)
        for (uint64_t k = 0; k < 48; k++) {
            study_pair pair;
            study_pair_plan plan = {.dim = k % 4 < 2 ? 3 : 6, .moves = k % 2};
            plan.family = (study_pair_family)family;
            plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
            study_pair_draw(&plan, 20261127006, k / 4, &pair);
            for (int order = 0; order < 2; order++) {
                const fmb_frame f[2] = {order ? pair.q : pair.p, order ? pair.p : pair.q};
                cr_expect(verdict_of(v, f, true) == verdict_of(v, f, false), "%s %d",
                          study_pair_family_text(plan.family), (int)k);
            }
        }
    fmb_solver_free(v);
}
