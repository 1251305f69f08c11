/* farther.c: what the judge of depths concludes about normals in doubles holds in integers. */
#include <criterion/criterion.h>
#include <stdlib.h>

#include "fmb-validate/farther.h"
#include "study/draw/pairs.h"

enum { MOST = VALIDATE_MOST_DIM, CHOICES = 40 };

static validate_difference m;
static mpz_t minor[1 << MOST], least, most;
static mpq_t square, part;
static long told, asked;

/* Minors of the edges chosen, by sets of coordinates. Are all of the last edge's 0? */
static bool expand(const validate_edge *e, int level)
{
    bool any = false;
    for (int set = 1; set < 1 << m.dim; set++) {
        if (__builtin_popcount((unsigned)set) != level + 1)
            continue;
        int sign = 1;
        mpz_set_ui(minor[set], 0);
        for (int j = 0; j < m.dim; j++)
            if (set >> j & 1) {
                (sign > 0 ? mpz_addmul : mpz_submul)(minor[set], e->x[j], minor[set ^ 1 << j]);
                sign = -sign;
            }
        any |= mpz_sgn(minor[set]) != 0;
    }
    return any;
}

/* To `square`: that of how far M reaches along the normal, there or back, but 0 if not beyond 0. */
static void measure_reach(void)
{
    mpz_t n[MOST];
    int all = (1 << m.dim) - 1;
    mpq_set_ui(square, 0, 1);
    for (int j = 0; j < m.dim; j++) {
        mpz_init_set(n[j], minor[all ^ 1 << j]);
        if (j % 2)
            mpz_neg(n[j], n[j]);
        mpq_set_z(part, n[j]);
        mpq_mul(part, part, part);
        mpq_div_2exp(part, part, 2 * (mp_bitcnt_t)m.finer[j]);
        mpq_add(square, square, part);
    }
    validate_ends(&m, n, least, most);
    mpz_neg(least, least);
    if (mpz_cmp(least, most) < 0)
        mpz_set(most, least);
    mpz_mul(least, most, most);
    mpq_set_z(part, least);
    mpq_div(square, part, square);
    if (mpz_sgn(most) <= 0)
        mpq_set_ui(square, 0, 1);
    for (int j = 0; j < m.dim; j++)
        mpz_clear(n[j]);
}

/* With that choice of edges: is the reach itself never said to be farther than it is, and mostly
 * farther than a little less? */
static void try_choice(const int *chosen, const char *family, uint64_t k)
{
    static validate_farther f;
    bool sure = true, any = true;
    validate_farther_load(&f, &m, square);
    for (int i = 0; i < m.dim - 1 && any; i++) {
        const validate_edge *e = &m.edge[chosen[i]];
        any = expand(e, i);
        sure = sure && validate_farther_choose(&f, i, e);
        cr_assert(any || !sure, "%s %d: dependent edges", family, (int)k);
    }
    if (!any)
        return;
    measure_reach();
    validate_farther_load(&f, &m, square);
    cr_assert_not(sure && validate_is_farther(&f), "%s %d", family, (int)k);
    mpq_set_d(part, 1 - 0x1p-12);
    mpq_mul(square, square, part);
    validate_farther_load(&f, &m, square);
    asked += mpq_sgn(square) > 0;
    told += mpq_sgn(square) > 0 && sure && validate_is_farther(&f);
}

static void choose_some(const char *family, uint64_t k)
{
    for (int i = 0; i < CHOICES; i++) {
        int chosen[MOST], n = 0;
        for (int e = 0; e < m.edges && n < m.dim - 1; e++)
            if (rand() % (m.edges - e) < m.dim - 1 - n)
                chosen[n++] = e;
        if (n == m.dim - 1)
            try_choice(chosen, family, k);
    }
}

Test(farther, beside_whole_numbers)
{
    for (int set = 0; set < 1 << MOST; set++)
        mpz_init_set_ui(minor[set], set == 0);
    mpz_inits(least, most, NULL);
    mpq_inits(square, part, NULL);
    validate_difference_init(&m);
    srand(20261127);
    for (int family = 0; family < STUDY_PAIR_FAMILIES; family++)
        for (uint64_t k = 0; k < 10; k++) {
            study_pair pair;
            study_pair_plan plan = {.dim = 4 + (int)k / 2, .moves = k % 2};
            plan.family = (study_pair_family)family;
            plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
            plan.naxes[k % 2] = k % 4 == 3 ? plan.dim - 1 : 0;
            study_pair_draw(&plan, 20261127245, k, &pair);
            validate_difference_load(&m, &pair.p, &pair.q);
            choose_some(study_pair_family_text(plan.family), k);
        }
    cr_expect(told > asked * 3 / 4 && asked > 2000, "%ld of %ld", told, asked);
    validate_difference_clear(&m);
    mpq_clears(square, part, NULL);
    mpz_clears(least, most, NULL);
    for (int set = 0; set < 1 << MOST; set++)
        mpz_clear(minor[set]);
}
