/* pairs.c: trees find the same as tests of all pairs of cells, for any boxes, at any scale. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/mesh.h>

#include "mesh/box.h"

#include "soup.h"

/* All pairs, in two portions of rows, find what trees find, and ask about each pair once. */
static void compare_pairs_with_trees(const fmb_mesh *m, const fmb_mesh *n,
                                     const fmb_mesh_options *o)
{
    size_t cells = fmb_mesh_cells(m), cut[] = {0, cells / 3, cells}, next = 0;
    fmb_mesh_answer trees = {.size = sizeof trees};
    uint64_t tested = 0;
    must(fmb_mesh_meet(m, n, o, &trees));
    for (int i = 0; i < 2; i++) {
        fmb_mesh_answer pairs = {.size = sizeof pairs};
        must(fmb_mesh_meet_pairs(m, cut[i], cut[i + 1], n, o, &pairs));
        tested += pairs.tested;
        cr_assert(next + pairs.hits <= trees.hits && pairs.stop == FMB_STOP_DONE);
        for (size_t k = 0; k < pairs.hits; k++, next++)
            cr_expect(memcmp(&pairs.hit[k], &trees.hit[next], sizeof *pairs.hit) == 0);
        fmb_mesh_answer_clear(&pairs);
    }
    cr_expect(next == trees.hits && next > 10);
    cr_expect(tested == (n ? cells * fmb_mesh_cells(n) : cells * (cells - 1) / 2));
    fmb_mesh_answer_clear(&trees);
}

Test(meet, all_pairs)
{
    const double motion[3] = {0.5, -3, 1.25};
    support_rng g = {12};
    soup s, t;
    draw_soup(&g, 3, CELLS, &s);
    draw_soup(&g, 4, 30, &t);
    fmb_mesh *m = mesh_of(&s), *n = mesh_of(&t);
    fmb_mesh_answer answer = {.size = sizeof answer};
    for (size_t threads = 1; threads < 4; threads += 2) {
        fmb_mesh_options o = {.size = sizeof o, .neighbours = true, .threads = threads};
        compare_pairs_with_trees(m, NULL, &o);
        compare_pairs_with_trees(n, m, &o);
    }
    compare_pairs_with_trees(
        m, n, &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .motion = motion});
    cr_expect(fmb_mesh_meet_pairs(m, 3, 3, n, NULL, &answer) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_meet_pairs(m, 0, CELLS + 1, n, NULL, &answer) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_meet_pairs(NULL, 0, 1, n, NULL, &answer) == FMB_ERR_ARG);
    fmb_mesh_free(m);
    fmb_mesh_free(n);
}

/* Boxes are of floats, and cells of doubles that floats cannot tell apart, or not hold. */
Test(meet, scales)
{
    static const double scale[] = {0x1p-1040, 0x1p-148, 0x1p-126, 1.0 / 3,
                                   0x1p125,   0x1p127,  0x1p1000};
    for (size_t i = 0; i < sizeof scale / sizeof *scale; i++) {
        support_rng g = {21};
        soup s, t;
        draw_soup(&g, 3, 24, &s);
        draw_soup(&g, 3, 24, &t);
        double motion[3] = {0.3 * scale[i], -3 * scale[i], 1.25 * scale[i]};
        for (int k = 0; k < 3 * VERTICES; k++) {
            s.point[k] = (s.point[k] - (i % 2 ? 2.5 : 0)) * scale[i];
            t.point[k] = (t.point[k] - (i % 2 ? 2.5 : 0)) * scale[i] * (1 + 0x1p-50);
        }
        fmb_mesh *m = mesh_of(&s), *n = mesh_of(&t);
        fmb_mesh_options o = {.size = sizeof o, .neighbours = true};
        compare_pairs_with_trees(m, NULL, &o);
        compare_pairs_with_trees(m, n, &o);
        o.motion = motion;
        compare_pairs_with_trees(n, m, &o);
        fmb_mesh_free(m);
        fmb_mesh_free(n);
    }
}

enum { MANY = 120 };

/* A coordinate in a law of its own: even, ever denser towards 0, few values, one value, all but one
 * value, beyond floats. */
static double draw_unevenly(support_rng *g, int law)
{
    double x = support_between(g, 1, 1 << 20) * 0x1p-20;
    double laws[] = {x,
                     ldexp(x, -(int)support_between(g, 0, 150)),
                     (double)support_between(g, 0, 2),
                     1,
                     support_between(g, 0, 99) == 0 ? x : 1,
                     ldexp(x, (int)support_between(g, -180, 180)) *
                         (double)(2 * support_between(g, 0, 1) - 1)};
    return laws[law];
}

enum { LAWS = 6 };

/* The boxes of all triangles, rounded outward one number at a time: how many pairs of them meet? */
static uint64_t count_boxes_that_meet(const double *point, const uint32_t *corner)
{
    fmb_mesh_box box[MANY] = {0};
    uint64_t meet = 0;
    for (int c = 0; c < MANY; c++)
        for (int j = 0; j < 3; j++) {
            double lower = INFINITY, upper = -INFINITY;
            for (int k = 0; k < 3; k++) {
                lower = fmin(lower, point[3 * corner[3 * c + k] + (uint32_t)j]);
                upper = fmax(upper, point[3 * corner[3 * c + k] + (uint32_t)j]);
            }
            box[c].lower[j] = fmb_float_below(lower);
            box[c].upper[j] = fmb_float_above(upper);
        }
    for (int c = 0; c < MANY; c++)
        for (int d = c + 1; d < MANY; d++)
            meet += fmb_mesh_boxes_meet(&box[c], &box[d]);
    return meet;
}

/* Whatever plane divides the cells, trees find all pairs, and ask about no more than boxes say. */
Test(meet, uneven)
{
    for (int i = 0; i < 2 * LAWS; i++) {
        support_rng g = {(uint64_t)i + 77};
        double point[3 * 3 * MANY];
        uint32_t corner[3 * MANY];
        for (int k = 0; k < 3 * MANY; k++) {
            bool near = k % 3 != 0 && k % 6 < 3;
            for (int j = 0; j < 3; j++)
                point[3 * k + j] = near ? point[3 * (k - 1) + j] * (1 + 0x1p-6 * (j + k % 5))
                                        : draw_unevenly(&g, (j == 0 ? i : i + i / LAWS) % LAWS);
            corner[k] = (uint32_t)(support_between(&g, 0, 4) == 0 ? support_between(&g, 0, k) : k);
        }
        fmb_mesh *m = NULL;
        fmb_mesh_options o = {.size = sizeof o, .neighbours = true};
        fmb_mesh_answer answer = {.size = sizeof answer};
        must(fmb_mesh_new(3, (size_t)3 * MANY, point, MANY, corner, NULL, &m));
        compare_pairs_with_trees(m, NULL, &o);
        must(fmb_mesh_meet(m, NULL, &o, &answer));
        cr_expect(answer.tested == count_boxes_that_meet(point, corner));
        fmb_mesh_answer_clear(&answer);
        fmb_mesh_free(m);
    }
}
