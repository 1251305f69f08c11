/* volume.c: see volume.h.
 *
 * An expansion is a sum of doubles, not 0, that do not overlap, from the smallest on: its sign is
 * that of the last one. The empty expansion is 0.
 */
#define FMB_LANES 1

#include "pair/corners/volume.h"

#include <math.h>

#include "pair/kernels/lane/double_double.h"

/* ---- expansions ------------------------------------------------------------------------------ */

/* Append x, unless it is 0. */
static int append_component(double *h, int n, double x)
{
    h[n] = x;
    return n + (x != 0);
}

/* h = e + f, n + m components at most (Shewchuk, "fast expansion sum"). */
static int add_expansions(const double *e, int n, const double *f, int m, double *h)
{
    int i = 0, j = 0, k = 0;
    double q = 0;
    while (i < n || j < m) {
        bool from_e = j == m || (i < n && fabs(e[i]) < fabs(f[j]));
        lane2 sum = two_sum(q, from_e ? e[i++] : f[j++]);
        k = append_component(h, k, sum.lo);
        q = sum.hi;
    }
    return append_component(h, k, q);
}

/* h = b e, 2 n components at most (Shewchuk, "scale expansion"). */
static int scale_expansion(const double *e, int n, double b, double *h)
{
    int k = 0;
    double q = 0;
    for (int i = 0; i < n; i++) {
        lane2 product = two_product(e[i], b), low = two_sum(q, product.lo);
        lane2 high = two_sum(product.hi, low.hi);
        k = append_component(h, k, low.lo);
        k = append_component(h, k, high.lo);
        q = high.hi;
    }
    return append_component(h, k, q);
}

enum { LINEAR = 2, QUADRATIC = 2 * LINEAR * LINEAR, CUBIC = 2 * LINEAR * QUADRATIC * 2 };

/* h = e (hi + lo), where the second factor has at most two components; scratch: as long as h. */
static int multiply_by_difference(const double *e, int n, const double *f, int m, double *scratch,
                                  double *h)
{
    if (m == 0)
        return 0;
    if (m == 1)
        return scale_expansion(e, n, f[0], h);
    double *upper = scratch + 2 * n;
    int low = scale_expansion(e, n, f[0], scratch), high = scale_expansion(e, n, f[1], upper);
    return add_expansions(scratch, low, upper, high, h);
}

/* One coordinate of a difference, exactly: at most two components. */
typedef struct linear {
    double c[LINEAR];
    int n;
} linear;

static linear exact_coordinate(fmb_difference u, int j)
{
    linear out = {.n = 0};
    lane2 difference = two_sum(u.to[j], -u.from[j]);
    out.n = append_component(out.c, out.n, difference.lo);
    if (difference.hi != 0)
        out.c[out.n++] = difference.hi;
    return out;
}

/* v_0 w_1 - v_1 w_0 */
static int exact_minor(const linear v[2], const linear w[2], double h[2 * QUADRATIC])
{
    double scratch[CUBIC], left[QUADRATIC], right[QUADRATIC];
    int l = multiply_by_difference(v[0].c, v[0].n, w[1].c, w[1].n, scratch, left);
    int r = multiply_by_difference(v[1].c, v[1].n, w[0].c, w[0].n, scratch, right);
    for (int i = 0; i < r; i++)
        right[i] = -right[i];
    return add_expansions(left, l, right, r, h);
}

/* u (v_0 w_1 - v_1 w_0) */
static int exact_part(linear u, const linear v[2], const linear w[2], double h[CUBIC])
{
    double scratch[CUBIC], minor[2 * QUADRATIC];
    int n = exact_minor(v, w, minor);
    return multiply_by_difference(minor, n, u.c, u.n, scratch, h);
}

/* The sign of an expansion of n components. */
static int sign_of_expansion(const double *e, int n)
{
    return n == 0 ? 0 : (e[n - 1] > 0) - (e[n - 1] < 0);
}

static int exact_sign(fmb_difference u, fmb_difference v, fmb_difference w)
{
    double part[CUBIC], sum[2][3 * CUBIC];
    int n = 0;
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        linear vs[2] = {exact_coordinate(v, i), exact_coordinate(v, j)};
        linear ws[2] = {exact_coordinate(w, i), exact_coordinate(w, j)};
        int m = exact_part(exact_coordinate(u, k), vs, ws, part);
        n = add_expansions(sum[k & 1], n, part, m, sum[(k + 1) & 1]);
    }
    return sign_of_expansion(sum[1], n);
}

/* The sign of u_0 v_1 - u_1 v_0: rounding is monotonic, so the larger of two products does not
 * round below the other, and rounding errors decide between equal ones. */
static int sign_of_short_minor(const double u[2], const double v[2])
{
    lane2 left = two_product(u[0], v[1]), right = two_product(u[1], v[0]);
    double more = left.hi == right.hi ? left.lo - right.lo : left.hi - right.hi;
    return (more > 0) - (more < 0);
}

/* The sign of coordinate k of the cross product of u and v. Differences of the numbers in files are
 * almost always exact doubles. */
static int exact_sign_of_minor(int k, fmb_difference u, fmb_difference v)
{
    int i = (k + 1) % 3, j = (k + 2) % 3;
    linear us[2] = {exact_coordinate(u, i), exact_coordinate(u, j)};
    linear vs[2] = {exact_coordinate(v, i), exact_coordinate(v, j)};
    double minor[2 * QUADRATIC];
    if (us[0].n < 2 && us[1].n < 2 && vs[0].n < 2 && vs[1].n < 2)
        return sign_of_short_minor((double[]){us[0].c[0], us[1].c[0]},
                                   (double[]){vs[0].c[0], vs[1].c[0]});
    return sign_of_expansion(minor, exact_minor(us, vs, minor));
}

int fmb_exact_sign_of_turn(int k, const double *p, const double *q, const double *r)
{
    return exact_sign_of_minor(k, (fmb_difference){q, p}, (fmb_difference){r, p});
}

/* ---- edges along an axis --------------------------------------------------------------------- */

/* The axis along which u points, -1 if along none. */
static int axis_along(fmb_difference u)
{
    bool same[3];
    for (int j = 0; j < 3; j++)
        same[j] = u.to[j] == u.from[j];
    return same[1] && same[2] ? 0 : same[0] && same[2] ? 1 : same[0] && same[1] ? 2 : -1;
}

/* If u points along axis k, det(u, v, w) is its coordinate times coordinate k of v x w. */
static bool find_sign_along_axis(fmb_difference u, fmb_difference v, fmb_difference w, int *sign)
{
    int k = axis_along(u);
    if (k < 0)
        return false;
    *sign = (u.to[k] > u.from[k]) - (u.to[k] < u.from[k]);
    *sign *= *sign != 0 ? exact_sign_of_minor(k, v, w) : 0;
    return true;
}

/* In files planes that are parallel to an axis abound, with edges along it; determinants of points
 * in them are 0. det(u, v, w) = det(u - v, v, w) = det(v, w, u). */
static bool find_sign_by_edge_along_axis(fmb_difference u, fmb_difference v, fmb_difference w,
                                         int *sign)
{
    const fmb_difference row[3] = {u, v, w};
    for (int i = 0; i < 3; i++) {
        const fmb_difference first = row[i], next = row[(i + 1) % 3], last = row[(i + 2) % 3];
        if (find_sign_along_axis(first, next, last, sign) ||
            (first.from == next.from &&
             find_sign_along_axis((fmb_difference){first.to, next.to}, next, last, sign)))
            return true;
    }
    return false;
}

/* ---- both ------------------------------------------------------------------------------------ */

/* Returns x and notes whether it is a double: *rest stays 0 if so. */
static lane2 noted(lane2 x, double *rest)
{
    *rest += fabs(x.lo);
    return x;
}

/* Six times the volume as a double-double, from differences without an error. A product of three
 * goes through two products and three sums, each within 2^-102 of what it adds or multiplies
 * (docs/error-bounds.md): all together within 5 (1 + 2^-99) 2^-102 times the sum of absolute
 * values, which was rounded by less than 2^-49 of itself. What adds or multiplies two doubles has
 * no error, so if all that arises are doubles (*rest 0), as with short numbers, nothing has one. */
static double fine_determinant(fmb_difference u, fmb_difference v, fmb_difference w, double *rest)
{
    lane2 a[3], b[3], c[3], det = lane2_of(0);
    *rest = 0;
    for (int j = 0; j < 3; j++) {
        a[j] = noted(two_sum(u.to[j], -u.from[j]), rest);
        b[j] = noted(two_sum(v.to[j], -v.from[j]), rest);
        c[j] = noted(two_sum(w.to[j], -w.from[j]), rest);
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        lane2 left = noted(lane2_times(true, b[i], c[j]), rest);
        lane2 right = noted(lane2_times(true, b[j], c[i]), rest);
        lane2 minor = noted(lane2_subtract(true, left, right), rest);
        det = noted(lane2_add(true, det, noted(lane2_times(true, a[k], minor), rest)), rest);
    }
    return det.hi;
}

FMB_NEVER_CLONED static int fine_sign(fmb_difference u, fmb_difference v, fmb_difference w,
                                      double sum)
{
    int sign;
    if (find_sign_by_edge_along_axis(u, v, w, &sign))
        return sign;
    double rest, det = fine_determinant(u, v, w, &rest);
    bool told = rest == 0 || fabs(det) > 0x1p-99 * sum;
    return told ? (det > 0) - (det < 0) : exact_sign(u, v, w);
}

/* The error is at most (7 + 56 e) e times the same sum of absolute values, e = 2^-53 (Shewchuk,
 * "the 3D orientation test", whose proof asks nothing of the differences but that each is rounded).
 */
int fmb_sign_of_determinant(fmb_difference u, fmb_difference v, fmb_difference w)
{
    double a[3], b[3], c[3], det = 0, sum = 0;
    for (int j = 0; j < 3; j++) {
        a[j] = u.to[j] - u.from[j];
        b[j] = v.to[j] - v.from[j];
        c[j] = w.to[j] - w.from[j];
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        double left = b[i] * c[j], right = b[j] * c[i];
        det += a[k] * (left - right);
        sum += fabs(a[k]) * (fabs(left) + fabs(right));
    }
    if (fabs(det) > 0x1p-50 * sum)
        return det > 0 ? 1 : -1;
    return sum == 0 ? 0 : fine_sign(u, v, w, sum);
}

/* ---- planes ---------------------------------------------------------------------------------- */

int fmb_side_of_triangle_plane(const fmb_triangle_plane *h, const double *s)
{
    double sum, det = fmb_plane_determinant(h, s, &sum);
    if (fabs(det) > 0x1p-50 * sum)
        return det > 0 ? 1 : -1;
    fmb_difference u = {s, h->p}, v = {h->q, h->p}, w = {h->r, h->p};
    return sum == 0 ? 0 : fine_sign(u, v, w, sum);
}
