/* shapes.c: pairs of frames as systems, see shapes.h.
 *
 * The unknowns are the coordinates x of a point in the frame of B, and the time t if something
 * moves; B is the unit cuboid or simplex. A stands at o, turned by a rotation R with rational
 * entries (products of Pythagorean triples) and scaled by s along its axes; it moves by V. A point
 * lies in A if its coordinates y = diag(1/s) R (x - o - V t) do; rows are scaled to whole numbers.
 * With o, V and s in tenths: y_i = (10 R_i x - R_i o - R_i V t) / (q s_i), where R_i / q is row i
 * of the rotation.
 */
#include <stdio.h>

#include "shapes.h"

#define MOST  9 /* variables */
#define TURNS 3 /* of the rotation, so that its entries stay small */

typedef struct pair {
    int dim, n;
    bool moving, a_simplex, b_simplex;
    int64_t r[MOST][MOST], q;
    int64_t o[MOST], speed[MOST], s[MOST];
} pair;

/* Steele, Lea and Flood's splitmix64. */
static uint64_t next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static int64_t between(uint64_t *state, int64_t low, int64_t high)
{
    return low + (int64_t)(next(state) % (uint64_t)(high - low + 1));
}

/* Turn the rows i and j of the rotation by the angle of a triple. */
static void turn(pair *p, int i, int j, const int64_t triple[3])
{
    for (int k = 0; k < p->dim; k++) {
        int64_t a = p->r[i][k], b = p->r[j][k];
        p->r[i][k] = triple[0] * a - triple[1] * b;
        p->r[j][k] = triple[1] * a + triple[0] * b;
    }
    for (int row = 0; row < p->dim; row++)
        for (int k = 0; row != i && row != j && k < p->dim; k++)
            p->r[row][k] *= triple[2];
    p->q *= triple[2];
}

static void draw(pair *p, uint64_t *state)
{
    static const int64_t triple[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}};
    for (int i = 0; i < p->dim; i++)
        for (int k = 0; k < p->dim; k++)
            p->r[i][k] = i == k;
    p->q = 1;
    for (int k = 0; k < p->dim && k < TURNS; k++) {
        int i = (int)between(state, 0, p->dim - 1);
        int j = (i + (int)between(state, 1, p->dim - 1)) % p->dim;
        turn(p, i, j, triple[next(state) % 4]);
    }
    int64_t far = between(state, 0, 1) ? 8 : 30;
    for (int i = 0; i < p->dim; i++) {
        p->s[i] = between(state, 8, 16);
        p->o[i] = between(state, -far / 2, far);
        p->speed[i] = between(state, -10, 10);
    }
}

/* Row i of y, times q s_i: coefficients and constant. */
static void coordinate(const pair *p, int i, int64_t a[MOST], int64_t *constant)
{
    *constant = 0;
    a[p->dim] = 0;
    for (int k = 0; k < p->dim; k++) {
        a[k] = 10 * p->r[i][k];
        *constant -= p->r[i][k] * p->o[k];
        a[p->dim] -= p->r[i][k] * p->speed[k];
    }
}

/* The least common multiple of s. */
static int64_t common_multiple(const pair *p)
{
    int64_t all = 1;
    for (int i = 0; i < p->dim; i++) {
        int64_t a = all, b = p->s[i];
        while (b != 0) {
            int64_t rest = a % b;
            a = b;
            b = rest;
        }
        all *= p->s[i] / a;
    }
    return all;
}

static bool add_a(const pair *p, fmb_system *s)
{
    int64_t sum[MOST] = {0}, sum_constant = 0, scale = p->q * common_multiple(p);
    bool good = true;
    for (int i = 0; i < p->dim; i++) {
        int64_t a[MOST] = {0}, minus[MOST], c;
        coordinate(p, i, a, &c);
        for (int k = 0; k < p->n; k++) {
            minus[k] = -a[k];
            sum[k] += scale / (p->q * p->s[i]) * a[k];
        }
        sum_constant += scale / (p->q * p->s[i]) * c;
        good = good && fmb_system_add_int(s, minus, FMB_LE, c) == FMB_OK;
        if (!p->a_simplex)
            good = good && fmb_system_add_int(s, a, FMB_LE, p->q * p->s[i] - c) == FMB_OK;
    }
    if (p->a_simplex)
        good = good && fmb_system_add_int(s, sum, FMB_LE, scale - sum_constant) == FMB_OK;
    return good;
}

/* B and the time, which runs from 0 to 1. */
static bool add_b(const pair *p, fmb_system *s)
{
    int64_t sum[MOST] = {0};
    bool good = true;
    for (int i = 0; i < p->n; i++) {
        int64_t unit[MOST] = {0};
        unit[i] = -1;
        good = good && fmb_system_add_int(s, unit, FMB_LE, 0) == FMB_OK;
        unit[i] = 1;
        if (!p->b_simplex || i == p->dim)
            good = good && fmb_system_add_int(s, unit, FMB_LE, 1) == FMB_OK;
        sum[i] = i < p->dim;
    }
    if (p->b_simplex)
        good = good && fmb_system_add_int(s, sum, FMB_LE, 1) == FMB_OK;
    return good;
}

fmb_system *shape_pair(unsigned i, char name[16])
{
    uint64_t state = i;
    unsigned kind = i % SHAPE_KINDS, shapes = i / SHAPE_KINDS;
    pair p = {.dim = 2 + (int)kind / 2,
              .moving = kind % 2 != 0,
              .a_simplex = (shapes & 1) != 0,
              .b_simplex = (shapes & 2) != 0};
    p.n = p.dim + p.moving;
    draw(&p, &state);
    snprintf(name, 16, "%dd-%s", p.dim, p.moving ? "moving" : "still");
    fmb_system *s = NULL;
    if (fmb_system_new(p.n, NULL, &s) == FMB_OK && add_a(&p, s) && add_b(&p, s))
        return s;
    fmb_system_free(s);
    return NULL;
}
