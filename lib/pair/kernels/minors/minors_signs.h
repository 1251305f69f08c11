/* minors_signs.h: do two simplices of four to seven dimensions meet?
 *
 * Notation: column j of M holds the barycentric coordinates in A of B's corner j; M has n = D + 1
 * rows and columns, and is regular. The point of B with weights x >= 0 is in A iff M x >= 0. R is a
 * set of k + 1 rows, S a set of k columns.
 *
 * Test of R and S: let y be 0 outside R, and y_r = +-(minor of S in R - r) in it. By Cramer's rule
 * (y M)_j is 0 for j in S, and +-(minor of S + j in R) for other j. If all y_r >= 0 and all (y M)_j
 * <= 0, or all of this with opposite signs, the hyperplane y separates A and B. So signs of minors
 * suffice: C(n, k + 1) C(n, k) tests of n + 1 signs at level k. For k = 0, y is a face of A.
 *
 * Completeness:
 * 1. If A and B have no common interior point then, by Gordan's theorem, some y >= 0, y != 0, has
 *    z = -y M >= 0. In an extreme ray (y, z) of this cone let R be the support of y, S0 the zeros
 *    of z.
 * 2. M has rank |R| - 1 on R and S0. With S a basis of these columns, y is a multiple of the y of
 *    the test of R and S: no sign of this test is wrong, though some may be 0.
 * 3. If A and B change places then M becomes its inverse, and y and z change places: the test is
 *    one of n - |S0| <= D + 2 - |R| rows. So the levels of the two tests sum to at most D, and all
 *    levels k <= K in A's view and k <= K' in B's include one of them if K + K' = D - 1.
 * 4. So if all signs are certain and no test has them all right, A and B meet.
 * One test with certain signs, all right, proves that even the closed A and B are apart: y is 0 on
 * A only at the D - k corners outside R, and on B only at the k corners S; a common point of these
 * two faces would be a combination of the columns S that is 0 in R, where they are independent.
 *
 * Motion: if B drifts by d from t = 0 to 1, then y separates A from B at all times iff it separates
 * them at t = 0 and y d <= 0, or at t = 1 and y (-d) <= 0. Each is the test above with one more
 * column, d or -d (in B's view with the other sign). In an extreme ray, D of the 2 n numbers of y
 * and z and of y d are 0. Either these are k numbers of z and D - k of y: levels k and D - k, as
 * before. Or they are y d, k - 1 of z and D - k of y: levels k and D - k + 1, with the drift in S.
 * So K + K' = D suffices, and one of the two last levels needs only the sets S with the drift.
 *
 * Signs: a minor has its columns in falling order, as minors_expand makes it, so (y M)_j has the
 * factor -1 for each column of S that is larger than j.
 *
 * At rest the signs of the last level of B's view tell those of the last one of A's, which has
 * larger minors: minors_complements.h.
 *
 * Errors: docs/error-bounds.md, "Minors of simplices".
 */
#ifndef FMB_PAIR_MINORS_SIGNS_H
#define FMB_PAIR_MINORS_SIGNS_H

#include "pair/kernels/minors/minors_complements.h"

/* Signs of minors as bits of words; sets of columns are appended in order. */
typedef struct minors_signs {
    lane word[4];
    int last[4]; /* place, in each word, of the set appended last: now the highest bit */
    lane least;  /* absolute value */
} minors_signs;

FMB_INLINE minors_signs minors_no_signs(void)
{
    return (minors_signs){{lane_of(0), lane_of(0), lane_of(0), lane_of(0)}, {0}, lane_of(INFINITY)};
}

/* Append the sign of the set `less` and j, all of `less` below j. Up to j = 6 the word depends on j
 * only. */
FMB_INLINE void minors_put_sign(minors_signs *x, unsigned less, int j, lane minor)
{
    const unsigned with = 1U << j, set = less | with, w = (j > 6 ? set : with) / 64;
    const int place = (int)(set % 64);
    lane *word = &x->word[w];
    *word = lane_or_and(lane_shift_right(*word, place - x->last[w]), minor, lane_of(-0.0));
    x->last[w] = place;
    x->least = lane_min_abs(x->least, minor);
}

/* Shift each sign to its place, and store the words behind the minors. */
FMB_INLINE void minors_end_signs(minors_kind d, minors_signs *x, lane *to)
{
    for (int w = 0; w < minors_words(d); w++)
        to[w] = x->word[w] = lane_shift_right(x->word[w], 63 - x->last[w]);
}

FMB_INLINE unsigned minors_set(int k, int s)
{
    return k == 1 ? FMB_MINORS_SET_1[s] : k == 2 ? FMB_MINORS_SET_2[s] : FMB_MINORS_SET_3[s];
}

/* The minors of these rows, kept or not, and their signs; for MINORS_DRIFTED only those of sets
 * with the drift. */
FMB_INLINE void minors_make_signs(minors_kind d, const minors_view *v, int k, minors_part part,
                                  const minors_rows *rows, minors_target target, lane *to,
                                  minors_signs *signs)
{
    lane factor[4];
#pragma GCC unroll 8
    for (int j = part == MINORS_DRIFTED ? d.n - 1 : k; j < d.n; j++) {
#pragma GCC unroll 4
        for (int i = 0; i <= k; i++)
            factor[i] = v->e[rows->row[i] * minors_stride(d, 1) + j];
        MINORS_UNROLL
        for (int s = 0; s < fmb_minors_choose(j, k); s++) {
            lane minor = minors_expand(k, factor, rows->less, s);
            if (part == MINORS_KEPT)
                to[fmb_minors_choose(j, k + 1) + s] = minor;
            minors_put_sign(signs, minors_set(k, s), j, minor);
            if (target.of)
                minors_put_complement(d, target, minors_set(k, s) | 1U << j, minor);
        }
    }
}

/* Word w of the tests of k columns: a set bit means that the test of this set S has a wrong sign. A
 * shift moves the sign of S + j to the place of S. */
FMB_INLINE lane minors_wrong(minors_kind d, int k, const minors_rows *rows,
                             const minors_signs *signs, int w)
{
    const int behind = fmb_minors_choose(d.n, k) + w, within = d.n < 6 ? d.n : 6;
    const lane first = rows->less[0][behind];
    lane wrong = lane_of(0);
#pragma GCC unroll 4
    for (int i = 1; i <= k; i++)
        wrong = i % 2 ? lane_or_same(wrong, rows->less[i][behind], first)
                      : lane_or_xor(wrong, rows->less[i][behind], first);
#pragma GCC unroll 6
    for (int j = 0; j < within; j++) {
        const uint64_t even =
            FMB_MINORS_EVEN_ABOVE[j] ^ (fmb_minors_count((unsigned)w) % 2 ? UINT64_MAX : 0);
        lane with = lane_shift_right(signs->word[w], 1 << j);
        wrong = lane_or_and(wrong, lane_xor_xor(with, first, lane_of_bits(even)),
                            lane_of_bits(FMB_MINORS_WITHOUT[j]));
    }
#pragma GCC unroll 2
    for (int j = 6; j < d.n; j++)
        if (!(w >> (j - 6) & 1))
            wrong = fmb_minors_count((unsigned)w >> (j - 5)) % 2
                        ? lane_or_xor(wrong, signs->word[w | 1 << (j - 6)], first)
                        : lane_or_same(wrong, signs->word[w | 1 << (j - 6)], first);
    return wrong;
}

/* The sets of word w that are tested. */
FMB_INLINE uint64_t minors_tested(minors_kind d, int k, minors_part part, int w)
{
    uint64_t sets = FMB_MINORS_OF_SIZE[k - fmb_minors_count((unsigned)w)];
    if (part == MINORS_DRIFTED && d.n > 6 && !(w >> (d.n - 7)))
        return 0;
    if (d.n < 6)
        sets &= (UINT64_C(1) << (1 << d.n)) - 1;
    return part == MINORS_DRIFTED && d.n <= 6 ? sets & ~FMB_MINORS_WITHOUT[d.n - 1] : sets;
}

/* Has any bit: a test of k columns in these rows has no wrong sign. */
FMB_INLINE lane minors_passed(minors_kind d, int k, minors_part part, const minors_rows *rows,
                              const minors_signs *signs)
{
    lane passed = lane_of(0);
#pragma GCC unroll 4
    for (int w = 0; w < minors_words(d); w++)
        if (k >= fmb_minors_count((unsigned)w) && minors_tested(d, k, part, w))
            passed = lane_or_and_not(passed, lane_of_bits(minors_tested(d, k, part, w)),
                                     minors_wrong(d, k, rows, signs, w));
    return passed;
}

/* Negative: the signs of the level before in these rows are certain. */
FMB_INLINE lane minors_doubt(minors_kind d, int k, const minors_rows *rows)
{
    lane doubt = rows->less[0][minors_stride(d, k) - 1];
#pragma GCC unroll 4
    for (int i = 1; i <= k; i++)
        doubt = lane_max(doubt, rows->less[i][minors_stride(d, k) - 1]);
    return doubt;
}

/* The tests of k columns in these rows. */
FMB_INLINE void minors_test_rows(minors_kind d, const minors_view *v, int k, minors_part part,
                                 const minors_rows *rows, minors_target target, lane *made,
                                 minors_said *said)
{
    minors_signs signs = minors_no_signs();
    minors_make_signs(d, v, k, part, rows, target, made, &signs);
    minors_end_signs(d, &signs, made + fmb_minors_choose(d.n, k + 1));
    const lane passed = minors_passed(d, k, part, rows, &signs);
    const lane doubt = made[minors_stride(d, k + 1) - 1] = minors_hear_signs(
        said, signs.least, lane_any_bit(passed),
        lane_of(minors_sign_error(d, k) * 0x1p-53) * rows->g, minors_doubt(d, k, rows));
    if (target.of)
        target.of->doubt = lane_max(target.of->doubt, doubt);
}

/* The tests of k columns in these rows by signs of minors of the other view, of level + 1 columns.
 */
FMB_INLINE void minors_test_complements(minors_kind d, int k, int level, unsigned set,
                                        const minors_rows *rows, const minors_complements *of,
                                        minors_said *said)
{
    const bool rising = (k * (k + 1) / 2 + level * (level + 1) / 2) % 2;
    const uint64_t all =
        minors_is_odd(d, k, set, minors_corners_of(d, set)) != rising ? UINT64_MAX : 0;
    minors_signs signs = minors_no_signs();
    for (int w = 0; w < minors_words(d); w++)
        signs.word[w] = lane_xor_xor(of->word[FMB_MINORS_RANK[set] * minors_words(d) + w],
                                     lane_of_bits(of->flip[w] ^ all), lane_of(0));
    const lane passed = lane_any_bit(minors_passed(d, k, MINORS_LAST, rows, &signs));
    const lane doubt = lane_max(of->doubt, minors_doubt(d, k, rows));
    said->apart = lane_max_where(lane_negative(passed), said->apart, lane_of(0) - doubt);
}

/* The tests of single rows: are all corners of B beyond a face of A? */
FMB_INLINE void minors_corners(minors_kind d, minors_view *v, minors_said *said)
{
    for (int r = 0; r < minors_count_rows(d); r++) {
        lane *row = v->e + r * minors_stride(d, 1), most = row[0],
             size = lane_of(0x1p-20) * v->g[r];
        minors_signs signs = minors_no_signs();
#pragma GCC unroll 8
        for (int j = 0; j < d.n; j++) {
            most = lane_max(most, row[j]);
            size = lane_max_abs(size, row[j]);
            minors_put_sign(&signs, 0, j, row[j]);
        }
        minors_end_signs(d, &signs, row + d.n);
        v->size[r] = size;
        row[minors_stride(d, 1) - 1] = minors_hear_signs(
            said, signs.least, most, lane_of(minors_sign_error(d, 0) * 0x1p-53) * v->g[r],
            lane_of(-INFINITY));
    }
}

/* The corners of b, and its drift, in barycentric coordinates of a; the last coordinate, of a's
 * origin, is 1 (for the drift 0) less the others. */
FMB_INLINE void minors_look_at_corners(minors_kind d, const lane *a, const lane *b,
                                       const lane *shift, const lane *drift, lane most, lane *room,
                                       minors_view *v)
{
    const lane *inverse = a + d.dim * (d.dim + 2), *reach = a + 2 * d.dim * (d.dim + 1);
    MINORS_UNROLL_ROWS
    for (int r = 0; r < d.dim; r++) {
        lane *e = v->e + r * minors_stride(d, 1);
        e[0] = minors_coordinate(d, inverse, r, shift);
#pragma GCC unroll 8
        for (int j = 1; j < d.n; j++) {
            e[j] = minors_coordinate(d, inverse, r, j <= d.dim ? b + d.dim * j : drift);
            if (j <= d.dim)
                e[j] = e[0] + e[j];
        }
        v->g[r] = lane_of(2) * lane_max(lane_of(1), reach[r] * most);
    }
    minors_add_last_row(d, v);
    v->from = v->e;
    v->to = room;
}

#endif
