/* minors_view.h: one cuboid in coordinates of another, with error bounds; see minors_kernel.h. */
#ifndef FMB_PAIR_MINORS_VIEW_H
#define FMB_PAIR_MINORS_VIEW_H

#include "pair/kernels/minors/minors_said.h"
#include "pair/kernels/minors/minors_table.h"

/* What is constant in a kernel. */
typedef struct minors_kind {
    int dim, n; /* n columns, the last one the drift if there is one */
    bool simplices, moves;
    /* of a cuboid and a simplex (minors_mixed.h): this view is that of the cuboid from the simplex,
     * that of the simplex from the cuboid */
    bool from_simplex, from_cuboid;
} minors_kind;

/* what: fmb_minors_what. */
FMB_INLINE minors_kind minors_kind_of(int dim, int what)
{
    const bool simplices = what / 2 == 1, moves = what % 2 == 1;
    return (minors_kind){dim, dim + simplices + moves, simplices, moves, what / 2 == 2, false};
}

/* The kind of the view of one side; of a cuboid and a simplex, A is the simplex. */
FMB_INLINE minors_kind minors_side(minors_kind d, int side)
{
    d.from_cuboid = d.from_simplex && side == 1;
    d.from_simplex = d.from_simplex && side == 0;
    return d;
}

FMB_INLINE int minors_count_rows(minors_kind d)
{
    return d.dim + (d.simplices || d.from_simplex);
}

/* For simplices, the number of words with a bit for each set of columns. */
FMB_INLINE int minors_words(minors_kind d)
{
    return d.n > 6 ? 1 << (d.n - 6) : 1;
}
/* Lanes of the minors of k columns in one set of rows; for simplices followed by the words of their
 * signs and a lane that is negative iff all signs are certain. */
FMB_INLINE int minors_stride(minors_kind d, int k)
{
    return fmb_minors_choose(d.n, k) + (d.simplices ? minors_words(d) + 1 : 0);
}

/* One frame seen from another. */
typedef struct minors_view {
    lane e[(int)FMB_MINORS_MOST_DIM * ((int)FMB_MINORS_MOST + 5)]; /* [row][column] */
    /* absolute values of these; from a simplex the largest of each row */
    lane size[(int)FMB_MINORS_MOST_DIM * (int)FMB_MINORS_MOST];
    lane center[FMB_MINORS_MOST_DIM + 1];
    lane g[FMB_MINORS_MOST_DIM + 1]; /* bounds of a row: docs/error-bounds.md */
    lane unit; /* the frame whose coordinates are used is |z_r| <= unit: 1, except as below */
    const lane *from; /* minors of the level before: [rows][columns] */
    lane *to;         /* room for the next ones */
} minors_view;

/* Errors, in units of u and of a row's bound. */
FMB_INLINE double minors_entry_error(minors_kind d)
{
    return d.from_simplex || d.from_cuboid ? 2 * d.dim + 4 : d.dim + 3;
}
FMB_INLINE double minors_center_error(minors_kind d)
{
    return (d.n + 2) * minors_entry_error(d) + d.n * (d.n + 1) + 4;
}

/* The error of the gap of a row of k columns, in units of u times the bounds of its coordinates. */
FMB_INLINE double minors_error(minors_kind d, int k)
{
    const double entry = minors_entry_error(d), center = minors_center_error(d), n = d.n;
    const double less = k == 0 ? 0 : k * entry + k * (k + 1) / 2 - 1;
    const double more = (k + 1) * entry + (k + 1) * (k + 2) / 2 - 1;
    const double factorial = k == 4 ? 120 : k == 3 ? 24 : k == 2 ? 6 : k + 1;
    const double middle = d.from_simplex || d.from_cuboid ? n + 7 : 0;
    return 1.01 * factorial *
           (center + (n + 3) * (less + k + 1) + less + 1 + (n - k) * more + n * (n - k + 1) + n +
            3 + middle);
}

/* Likewise the error of minors of k + 1 columns of two simplices. */
FMB_INLINE double minors_sign_error(minors_kind d, int k)
{
    const double entry = 2 * d.dim + (d.moves ? 6 : 4);
    const double factorial = k == 3 ? 24 : k == 2 ? 6 : k + 1;
    return 1.01 * factorial * ((k + 1) * entry + (k + 1) * (k + 2) / 2 - 1);
}

#endif
