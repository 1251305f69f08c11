/* chernikov.c: Chernikov's rule.
 *
 * A row whose history contains that of another row is not needed. With A_k as in kohler.c, the
 * multipliers of a derived row are a ray of {y >= 0 : y A_k = 0}, and its history is the support.
 * If the support of z lies strictly inside that of y, then y - t z is in the cone for some t > 0,
 * so y is no extreme ray; and every ray is a sum of extreme ones. If every round keeps the extreme
 * rays and nothing else, then two rows make an extreme one if and only if no third history lies
 * inside the union of theirs (two extreme rays are adjacent if the least face with both has no
 * third): so the test comes before the row is made. It needs no other row of equal support, and
 * there is none: two rays of equal support would both have a smaller one inside.
 *
 * Trivial rows are rays, too; their histories are kept for this test. A row dropped because of one
 * is a sum of present rows and trivial rows: implied. Source: Chernikov 1960; Fukuda and Prodon
 * 1996 (the adjacency test).
 *
 * Numbers to check: of |x1| + ... + |x4| <= 1, written as 16 rows, 28 rows remain after three
 * rounds, in any order. The signs of three variables are corners of a cube, two rows at each; the
 * minimal sets around the middle are its 4 diagonals and 2 regular tetrahedra, in 4 * 2^2 + 2 * 2^4
 * ways, of which 8 + 20 still contain x4. Of |x_i - x_{i+1}| <= 1, |x_n| <= 1 exactly 2 (n - k)
 * rows remain after k rounds.
 */
#include "rule/rule_private.h"

static void drop_covering_pairs(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    (void)state;
    fmb_view_drop_larger(w, i, fmb_view_eliminated(w) + 1, drop); /* cheap, and implied */
    fmb_view_drop_covered(w, i, drop);
}

const fmb_rule fmb_rule_chernikov = {
    .name = "chernikov",
    .source = "Chernikov1960",
    .flags = FMB_RULE_NEEDS_HISTORY,
    .drop_pairs = drop_covering_pairs,
};
