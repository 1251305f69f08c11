/* minors_signs.h: do two simplices of four to seven dimensions meet?
 *
 * Column j of M has the barycentric coordinates in A of B's corner j: n = D + 1 rows and columns,
 * and a point of B, with weights x >= 0, is in A iff M x >= 0. Eliminating x from these n rows
 * leaves, of rows R and k = |R| - 1 columns S, the combination y of R that is 0 on S: by Cramer's
 * rule y_r is a minor of S in R less r, and what y says of another column j is the minor of R with
 * j more. If all y_r have one sign, and all else the other, then B is beyond A's hyperplane y: the
 * two are apart. So signs tell, C(n, k + 1) C(n, k) tests of n + 1 signs a level. A face (k = 0) is
 * the row r, with y = 1.
 *
 * Complete: if A and B have no interior point in common then (Gordan) there is y >= 0, not 0, with
 * z = - y M >= 0. Take an extreme ray of these; let R be where y is positive, S0 where z is 0. Then
 * M has rank |R| - 1 in R and S0, and |R| - 1 columns S of S0 are a basis: y is made of minors, up
 * to a factor, and no sign of the test of R, S is wrong, though some may be 0. In B's view M is its
 * inverse, y and z change places, and the test is one of n - |S0| <= D + 2 - |R| rows. So levels up
 * to K there and up to K' here have them all if K + K' = D - 1; if all signs are certain, and no
 * test has them all right, the two meet. A test whose own signs are certain and right is enough for
 * apart, also closed: y is 0 at D - k corners of A and k of B alone, and a point of both faces
 * would have coordinates 0 in R, but S has k columns that are independent there. (The dual simplex
 * method would find one of these tests.)
 *
 * If B drifts by d from t = 0 to 1, y keeps all its places beyond A iff y d <= 0 and it keeps B so
 * at t = 0, or y (-d) <= 0 and B at t = 1. Each is the question above with a column more, d then or
 * -d then, which B's view has with the other sign. D of all n + n + 1 numbers y, z and that of the
 * drift are 0 in an extreme ray: k of z and D - k of y, levels k here and D - k there as before; or
 * the drift's, k - 1 of z and D - k of y, levels k here and D - k + 1 there. So K + K' = D, and one
 * of the last levels is asked for sets with the drift alone.
 *
 * Minors are those of columns in falling order, as minors_expand makes them: to j in front of S
 * belongs a minus for each larger column of S.
 *
 * Errors: docs/error-bounds.md, "Minors of simplices".
 */
#ifndef FMB_PAIR_MINORS_SIGNS_H
#define FMB_PAIR_MINORS_SIGNS_H

#include "pair/kernels/minors/minors_rows.h"

/* Signs of minors as bits of words; sets of columns are appended in order. */
typedef struct minors_signs {
    lane word[4];
    int last[4]; /* the place, in each word, of what was put there last: now it is the highest bit
                  */
    lane least;  /* absolute value */
} minors_signs;

FMB_INLINE minors_signs minors_no_signs(void)
{
    return (minors_signs){{lane_of(0), lane_of(0), lane_of(0), lane_of(0)}, {0}, lane_of(INFINITY)};
}

/* The set of those in `less`, all below j, and j: which word that is j tells alone, up to 6. */
FMB_INLINE void minors_put_sign(minors_signs *x, unsigned less, int j, lane minor)
{
    const unsigned with = 1U << j, set = less | with, w = (j > 6 ? set : with) / 64;
    const int place = (int)(set % 64);
    lane *word = &x->word[w];
    *word = lane_or_and(lane_shift_right(*word, place - x->last[w]), minor, lane_of(-0.0));
    x->last[w] = place;
    x->least = lane_min_abs(x->least, minor);
}

/* Each sign to its place, in words behind minors. */
FMB_INLINE void minors_end_signs(minors_kind d, minors_signs *x, lane *to)
{
    for (int w = 0; w < minors_words(d); w++)
        to[w] = x->word[w] = lane_shift_right(x->word[w], 63 - x->last[w]);
}

FMB_INLINE unsigned minors_set(int k, int s)
{
    return k == 1 ? FMB_MINORS_SET_1[s] : k == 2 ? FMB_MINORS_SET_2[s] : FMB_MINORS_SET_3[s];
}

/* The minors of these rows, kept or not, and their signs; where sets with the drift are asked alone
 * they are made alone. */
FMB_INLINE void minors_make_signs(minors_kind d, const minors_view *v, int k, minors_part part,
                                  const minors_rows *rows, lane *to, minors_signs *signs)
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
        }
    }
}

/* Word w of the tests of k columns that have a wrong sign. A shift brings the sign of S with j to
 * S. */
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

/* The tests of k columns in these rows. */
FMB_INLINE void minors_test_rows(minors_kind d, const minors_view *v, int k, minors_part part,
                                 const minors_rows *rows, lane *made, minors_said *said)
{
    minors_signs signs = minors_no_signs();
    lane passed = lane_of(0);
    minors_make_signs(d, v, k, part, rows, made, &signs);
    minors_end_signs(d, &signs, made + fmb_minors_choose(d.n, k + 1));
#pragma GCC unroll 4
    for (int w = 0; w < minors_words(d); w++)
        if (k >= fmb_minors_count((unsigned)w) && minors_tested(d, k, part, w))
            passed = lane_or_and_not(passed, lane_of_bits(minors_tested(d, k, part, w)),
                                     minors_wrong(d, k, rows, &signs, w));
    lane doubt = rows->less[0][minors_stride(d, k) - 1];
#pragma GCC unroll 4
    for (int i = 1; i <= k; i++)
        doubt = lane_max(doubt, rows->less[i][minors_stride(d, k) - 1]);
    made[minors_stride(d, k + 1) - 1] =
        minors_hear_signs(said, signs.least, lane_any_bit(passed),
                          lane_of(minors_sign_error(d, k) * 0x1p-53) * rows->g, doubt);
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

/* The corners of b, and its drift, in barycentric coordinates of a, those of a's origin last, as 1
 * (of the drift 0) less the others. */
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
