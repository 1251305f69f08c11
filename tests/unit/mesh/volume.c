/* volume.c: signs of determinants, against rationals. */
#include <criterion/criterion.h>
#include <gmp.h>
#include <math.h>
#include <string.h>

#include "pair/corners/volume.h"
#include "support/support.h"

static int truth(double p[6][3])
{
    mpq_t d[3][3], sum, term;
    mpq_inits(sum, term, NULL);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            mpq_init(d[i][j]);
            mpq_set_d(d[i][j], p[2 * i][j]);
            mpq_set_d(term, p[2 * i + 1][j]);
            mpq_sub(d[i][j], d[i][j], term);
        }
    for (int k = 0; k < 3; k++)
        for (int sign = -1; sign < 2; sign += 2) {
            mpq_mul(term, d[0][k], d[1][(k + (sign > 0 ? 1 : 2)) % 3]);
            mpq_mul(term, term, d[2][(k + (sign > 0 ? 2 : 1)) % 3]);
            sign > 0 ? mpq_add(sum, sum, term) : mpq_sub(sum, sum, term);
        }
    int out = mpq_sgn(sum);
    for (int i = 0; i < 9; i++)
        mpq_clear(d[i / 3][i % 3]);
    mpq_clears(sum, term, NULL);
    return out;
}

static double draw_number(support_rng *g, int kind)
{
    double x = support_between(g, -3, 3);
    if (kind >= 1)
        x += support_between(g, -1000, 1000) / 997.0;
    if (kind >= 2 && support_chance(g, 30))
        x = ldexp(x, support_between(g, kind == 2 ? -60 : -180, kind == 2 ? 60 : 180));
    return support_chance(g, 10) ? 0 : x;
}

/* Often nearly, or exactly, dependent. */
static void draw_points(support_rng *g, double p[6][3])
{
    int kind = support_between(g, 0, 3), dependent = support_between(g, 0, 2);
    double s = draw_number(g, 1), t = draw_number(g, 0);
    for (int i = 0; i < 18; i++)
        p[i / 3][i % 3] = draw_number(g, kind);
    for (int j = 0; dependent > 0 && j < 3; j++) {
        double x = s * (p[0][j] - p[1][j]) + t * (p[2][j] - p[3][j]);
        p[4][j] = p[5][j] + (dependent == 1 ? x : x * (1 + 0x1p-52));
    }
}

/* Two of the points become the ends of an edge along an axis. */
static void draw_edge_along_axis(support_rng *g, double p[6][3])
{
    int i = support_between(g, 0, 5), k = support_between(g, 0, 5), axis = support_between(g, 0, 2);
    for (int j = 0; j < 3; j++)
        p[k][j] = j == axis ? p[k][j] : p[i][j];
}

/* As differences from one point, in half of the rounds. */
Test(volume, signs)
{
    support_rng g = {5};
    int count[3] = {0};
    for (int round = 0; round < 100000; round++) {
        double p[6][3];
        draw_points(&g, p);
        if (support_chance(&g, 30))
            draw_edge_along_axis(&g, p);
        int second = round % 2 ? 1 : 3, third = round % 2 ? 1 : 5;
        memcpy(p[3], p[second], sizeof p[3]);
        memcpy(p[5], p[third], sizeof p[5]);
        int want = truth(p);
        bool tame = true;
        for (int i = 0; i < 18; i++)
            tame &= fmb_is_tame(p[i / 3][i % 3]);
        if (!tame)
            continue;
        int got =
            fmb_sign_of_determinant((fmb_difference){p[0], p[1]}, (fmb_difference){p[2], p[second]},
                                    (fmb_difference){p[4], p[third]});
        cr_assert(got == want, "round %d: %d, not %d", round, got, want);
        count[want + 1]++;
    }
    cr_expect(count[0] > 20000 && count[1] > 4000 && count[2] > 20000, "%d %d %d", count[0],
              count[1], count[2]);
}

/* det(q - p, r - p, unit vector) for all three axes; r often on the line of p and q, or nearly. */
Test(volume, turns)
{
    support_rng g = {6};
    int count[3] = {0};
    for (int round = 0; round < 60000; round++) {
        double p[6][3], q[6][3] = {{0}};
        int k = round % 3, twice = support_between(&g, 0, 2);
        draw_points(&g, p);
        bool tame = true;
        for (int j = 0; j < 3; j++) {
            if (twice > 0)
                p[2][j] = p[0][j] + 2 * (p[1][j] - p[0][j]) * (twice == 1 ? 1 : 1 + 0x1p-52);
            q[0][j] = p[1][j];
            q[2][j] = p[2][j];
            q[1][j] = q[3][j] = p[0][j];
            for (int i = 0; i < 3; i++)
                tame &= fmb_is_tame(p[i][j]);
        }
        q[4][k] = 1;
        if (!tame)
            continue;
        int want = truth(q), got = fmb_sign_of_turn(k, p[0], p[1], p[2]);
        cr_assert(got == want, "round %d: %d, not %d", round, got, want);
        count[want + 1]++;
    }
    cr_expect(count[0] > 10000 && count[1] > 5000 && count[2] > 10000, "%d %d %d", count[0],
              count[1], count[2]);
}

Test(volume, tame)
{
    cr_expect(fmb_is_tame(0) && fmb_is_tame(-0.0) && fmb_is_tame(1) && fmb_is_tame(-0x1p200) &&
              fmb_is_tame(0x1p-200));
    cr_expect(!fmb_is_tame(0x1p201) && !fmb_is_tame(0x1p-201) && !fmb_is_tame(INFINITY) &&
              !fmb_is_tame(NAN));
}
