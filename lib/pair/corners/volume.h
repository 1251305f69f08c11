/* volume.h: exact signs of determinants of differences of points.
 *
 * A coordinate is tame if it is 0 or 2^-200 <= |x| <= 2^200. Tame coordinates and their differences
 * are multiples of 2^-252, products of three of these multiples of 2^-756 and below 2^604: so
 * nothing here underflows or overflows.
 *
 * Source: Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates, Discrete & Computational Geometry 18, 1997.
 */
#ifndef FMB_PAIR_VOLUME_H
#define FMB_PAIR_VOLUME_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* A vector to - from. */
typedef struct fmb_difference {
    const double *to, *from;
} fmb_difference;

/* Without branches. */
static inline bool fmb_is_tame(double x)
{
    return (x == 0) | ((fabs(x) >= 0x1p-200) & (fabs(x) <= 0x1p200));
}

/* -1, 0 or 1, the sign of det(u, v, w); all coordinates are tame. */
int fmb_sign_of_determinant(fmb_difference u, fmb_difference v, fmb_difference w);

/* The plane through p, q, r, which are not collinear; a normal of it, rounded, and for each of its
 * coordinates the sum of the absolute values of its terms. */
typedef struct fmb_triangle_plane {
    const double *p, *q, *r;
    double normal[3], size[3];
} fmb_triangle_plane;

static inline fmb_triangle_plane fmb_triangle_plane_of(const double *p, const double *q,
                                                       const double *r)
{
    fmb_triangle_plane h = {.p = p, .q = q, .r = r};
    double u[3], v[3];
    for (int j = 0; j < 3; j++) {
        u[j] = q[j] - p[j];
        v[j] = r[j] - p[j];
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        double left = u[i] * v[j], right = u[j] * v[i];
        h.normal[k] = left - right;
        h.size[k] = fabs(left) + fabs(right);
    }
    return h;
}

/* What fmb_sign_of_determinant computes of s - p, q - p, r - p, in the same order; *sum of absolute
 * values. */
static inline double fmb_plane_determinant(const fmb_triangle_plane *h, const double *s,
                                           double *sum)
{
    double det = 0;
    *sum = 0;
    for (int k = 0; k < 3; k++) {
        double a = s[k] - h->p[k];
        det += a * h->normal[k];
        *sum += fabs(a) * h->size[k];
    }
    return det;
}

/* The side on which s is: fmb_sign_of_volume(p, q, r, s). Below: 0, too, if doubles are not
 * certain.
 */
int fmb_side_of_triangle_plane(const fmb_triangle_plane *h, const double *s);
static inline int fmb_certain_side_of_plane(const fmb_triangle_plane *h, const double *s)
{
    double sum, det = fmb_plane_determinant(h, s, &sum), least = 0x1p-50 * sum;
    return (det > least) - (det < -least);
}

/* The sign of det(q - p, r - p, unit vector k): seen along axis k, do p, q, r turn left? */
int fmb_exact_sign_of_turn(int k, const double *p, const double *q, const double *r);

/* That sign by doubles, where these are certain. The error is at most (3 + 16 e) e times the sum of
 * absolute values, e = 2^-53 (Shewchuk, "the 2D orientation test"). */
static inline int fmb_sign_of_turn(int k, const double *p, const double *q, const double *r)
{
    int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
    double left = (q[i] - p[i]) * (r[j] - p[j]), right = (q[j] - p[j]) * (r[i] - p[i]);
    double det = left - right, sum = fabs(left) + fabs(right);
    if (fabs(det) > 0x1p-51 * sum)
        return det > 0 ? 1 : -1;
    return sum == 0 ? 0 : fmb_exact_sign_of_turn(k, p, q, r);
}

/* The sign of the volume of the tetrahedron p, q, r, s: of det(q - p, r - p, s - p). */
static inline int fmb_sign_of_volume(const double *p, const double *q, const double *r,
                                     const double *s)
{
    return fmb_sign_of_determinant((fmb_difference){q, p}, (fmb_difference){r, p},
                                   (fmb_difference){s, p});
}

#endif
