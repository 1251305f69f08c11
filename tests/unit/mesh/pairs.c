/* pairs.c: trees find the same as tests of all pairs of cells, for any boxes, at any scale. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/mesh.h>

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
