/* minors_complements.h: signs of minors of one view of two simplices at rest as those of the other.
 *
 * Number the corners of both from 0, the origin first, and let N hold the barycentric coordinates
 * in A of B's corners, a row for each corner of A and a column for each of B. Then the coordinates
 * in B of A's corners are N^-1, and by Jacobi, with complements I' of I and J' of J,
 *
 *     det N^-1[I, J] = (-1)^(sum I + sum J) det N[J', I'] / det N.
 *
 * Adding the other rows of N to the first makes this all 1, and subtracting the first column from
 * the others then leaves det N = det(axes of B) / det(axes of A), which is positive, as the axes in
 * records all turn the same way (minors_inverse.h). So minors of k + 1 rows in one view have the
 * signs of minors of n - k - 1 rows in the other, and the last levels K and K' of both views
 * (minors_signs.h) have K + 1 + K' + 1 = D + 1 = n rows. Signs that one last level finds row by row
 * are put to the words that the other one asks for.
 *
 * A view has the row of corner r + 1 in place r, and of corner 0 in the last place: a set with that
 * row is in order after as many exchanges as it has other rows. Columns of minors stand in falling
 * order: after k (k + 1) / 2 exchanges k + 1 of them are in rising order.
 */
#ifndef FMB_PAIR_MINORS_COMPLEMENTS_H
#define FMB_PAIR_MINORS_COMPLEMENTS_H

#include "pair/kernels/minors/minors_rows.h"

/* Of each set of rows of the other view, the words of its signs, which change where `flip` has a
 * bit; so do all those of a set for which minors_is_odd. */
typedef struct minors_complements {
    lane word[70]; /* choose(7, 3), two words each */
    uint64_t flip[2];
    lane doubt; /* negative: all of them are certain */
} minors_complements;

FMB_INLINE void minors_no_complements(minors_kind d, int k, minors_complements *x)
{
    const int words = fmb_minors_choose(d.n, k + 1) * minors_words(d);
    for (int i = 0; i < words; i++)
        x->word[i] = lane_of(0);
    x->flip[0] = x->flip[1] = 0;
    x->doubt = lane_of(-INFINITY);
}

/* The corners of some rows, and the rows of some corners. */
FMB_INLINE unsigned minors_corners_of(minors_kind d, unsigned rows)
{
    return (rows << 1 & ((1U << d.n) - 1)) | rows >> (d.n - 1);
}
FMB_INLINE unsigned minors_rows_of(minors_kind d, unsigned corners)
{
    return corners >> 1 | (corners & 1) << (d.n - 1);
}
FMB_INLINE unsigned minors_without(minors_kind d, unsigned corners)
{
    return ~corners & ((1U << d.n) - 1);
}

/* Is the sum of these corners, plus the exchanges that put k + 1 rows in order, odd? */
FMB_INLINE bool minors_is_odd(minors_kind d, int k, unsigned rows, unsigned corners)
{
    return (__builtin_parity(corners & 0xaa) ^ (k & (int)(rows >> (d.n - 1)))) & 1;
}

/* Where the signs of minors in k + 1 rows belong: a bit of a word, for their set of columns in the
 * other view. */
typedef struct minors_target {
    minors_complements *of; /* NULL: nowhere */
    int word, bit;
} minors_target;

FMB_INLINE minors_target minors_find_target(minors_kind d, int k, unsigned rows,
                                            minors_complements *of)
{
    const unsigned columns = minors_without(d, minors_corners_of(d, rows));
    const minors_target to = {of, d.n > 6 ? (int)columns / 64 : 0, (int)columns % 64};
    if (of)
        of->flip[to.word] |= (uint64_t)minors_is_odd(d, k, rows, columns) << to.bit;
    return to;
}

FMB_INLINE void minors_put_complement(minors_kind d, minors_target to, unsigned set, lane minor)
{
    const unsigned rows = minors_rows_of(d, minors_without(d, set));
    lane *word = &to.of->word[FMB_MINORS_RANK[rows] * minors_words(d) + to.word];
    *word = lane_with_sign(*word, minor, to.bit);
}

#endif
