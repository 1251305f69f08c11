// error_bounds.cpp: every error bound of the kernels, counted anew by machine
// (docs/error-bounds.md).
//
// The kernels' headers are compiled with numbers that count (counted.h). Bounds made of the sizes
// of frames are counted on majorants: those sizes are drawn at random over many magnitudes, so that
// each is the largest by far in some draw. Bounds made of a pair's own numbers are counted on
// random pairs. No bound may be less than what is counted; none may be so large that an eighth of
// it would do, or this test would not notice what it is there for.
#include "counted.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "pair/kernels/verdict/verdict_gaps.h"

/* ---- what was claimed, what is needed -------------------------------------------------------- */

static std::map<std::string, double> most; // needed, as a part of what is claimed
static std::string kernel;

static void claim(const std::string &what, double needed, double claimed)
{
    double part = needed == 0 ? 0 : needed / claimed;
    double &worst = most[kernel + what];
    worst = std::max(worst, part);
}

static bool single; // numbers of frames were rounded to floats

static std::string flavour(const char *what, int dim, bool moves)
{
    return std::string(what) + ", " + std::to_string(dim) + (moves ? "D moving" : "D") +
           (single ? ", floats: " : ": ");
}

static bool report()
{
    bool good = !most.empty();
    for (const auto &m : most) {
        bool fits = m.second <= 1 && m.second > 1.0 / 8;
        std::printf("%-44s %6.3f of the bound%s\n", m.first.c_str(), m.second,
                    fits ? "" : "  <-- wrong");
        good &= fits;
    }
    return good;
}

/* ---- random sizes ---------------------------------------------------------------------------- */

static uint64_t state = 1;

static double uniform() // 0 ... 1
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) * 0x1p-53;
}

static double some_size()
{
    return std::ldexp(1 + uniform(), (int)(uniform() * 40) - 20);
}

static const double *rows;                  // of a block
static double alpha[3], beta, delta, omega; // alpha: of each axis
static int dimension;
static bool moving;

/* A number of that size that was given, or a rounded difference of two. */
static lane given_number(double size, bool differs)
{
    const double off = single ? 0x1p-24 / UNIT : 0;
    return {size, (off + differs) * size};
}

static lane lane_load(const double *a)
{
    if (!rows)
        return {*a, 0};
    const int row = (int)(a - rows), d = dimension, last = d + 2 * d * d + (moving ? d : 0);
    if (single && row >= last) {
        const double bound[3] = {delta, omega, FMB_SINGLE_ERROR};
        return {bound[row - last], 0};
    }
    if (row < d)
        return given_number(delta, true);
    if (row < d + d * d)
        return given_number(alpha[(row - d) / d], false);
    return row < d + 2 * d * d ? given_number(beta, false) : given_number(omega, true);
}

/* ---- verdicts: the local frame --------------------------------------------------------------- */

static double answer[64];
static lane stored[64]; // in answer

static void lane_store(double *a, lane x)
{
    stored[a - answer] = x;
}

/* Of what is given to a float a two hundredth is left for what gaps are off by in second order. */
static double error_of_local_frame(lane input)
{
    return (LOCAL_FRAME_ERROR + (single ? 0.995 * input.v : 0)) / UNIT;
}

static void claim_number(const char *what, const local_frame *f, lane x, lane bound)
{
    claim(std::string(what) + " is at most", size_of(x), bound.v * (1 + 1e-12));
    claim(std::string(what) + " is off by", x.e, error_of_local_frame(f->input_error) * bound.v);
}

static void count_local_frame(int dim, bool moves)
{
    static const double block[40] = {0};
    local_frame f;
    rows = block;
    dimension = dim;
    moving = moves;
    kernel = flavour("local frame", dim, moves);
    local_frame_make(dim, moves, true, single, block, &f);
    claim_number("size", &f, f.size, f.most_size);
    for (int i = 0; i < dim; i++) {
        claim_number("shift", &f, f.shift[i], f.most_shift);
        claim_number("edge", &f, f.e[i % dim][i], f.most_e);
        if (moves)
            claim_number("drift", &f, f.drift[i], f.most_drift);
    }
}

/* What the kernels below take for the numbers of a block: bounds, and errors as claimed above. */
static void make_bounds(int dim, bool, bool, bool, const double *, local_frame *f)
{
    f->single = single;
    f->input_error = {dim * FMB_SINGLE_ERROR, 0};
    const double count = error_of_local_frame(f->input_error);
    double bound[4];
    for (double &b : bound)
        b = some_size();
    lane *const is[4] = {&f->most_size, &f->most_e, &f->most_shift, &f->most_drift};
    lane *const found[4] = {&f->found_size, &f->found_e, &f->found_shift, &f->found_drift};
    lane x[4];
    for (int i = 0; i < 4; i++) {
        *is[i] = {bound[i], 0};
        const double size = single ? std::ldexp(bound[i], -(int)(uniform() * 8)) : bound[i];
        x[i] = {size, count * bound[i]};
        *found[i] = {size, 0};
    }
    f->size = f->volume = x[0];
    for (int i = 0; i < 3; i++) {
        f->shift[i] = x[2];
        f->drift[i] = x[3];
        for (int k = 0; k < 3; k++)
            f->e[k][i] = x[1];
    }
    f->known = true;
}

/* A gap, and what was made of the sign of a determinant: if that sign is wrong, the determinant is
 * less than its error, which comes on top. */
static std::string text_of_error(const char *what, double count, double times)
{
    const std::string rounding = what + (" to " + std::to_string((int)count)) + " u";
    return single ? rounding + " and " + std::to_string((int)times) + " input" : rounding;
}

static void count_class(fmb_gaps *, lane gap, double count, double times, fmb_bound bound)
{
    claim(text_of_error("gap", count, times), gap.e + counted_sign,
          fmb_gaps_error(count, times, bound).v / UNIT);
    counted_sign = 0;
}

static fmb_gaps count_first(lane gap, double count, double times, fmb_bound bound)
{
    count_class(nullptr, gap, count, times, bound);
    return fmb_gaps_none();
}

static void count_certain(fmb_gaps *, lane size, double count, double times, fmb_bound bound)
{
    claim(text_of_error("det B", count, times), size.e,
          fmb_gaps_error(count, times, bound).v / UNIT);
}

#define local_frame_make make_bounds
#define fmb_gaps_class   count_class
#define fmb_gaps_first   count_first
#define fmb_gaps_certain count_certain
#include "pair/kernels/verdict/verdict_kernel.h"
#undef local_frame_make

/* ---- verdicts: minors ------------------------------------------------------------------------ */

#include "pair/kernels/minors/minors_said.h"

static void hear_minors(minors_said *, lane gap, lane error)
{
    claim("gap", gap.e, error.v / UNIT);
}

static lane hear_signs(minors_said *, lane least, lane, lane error, lane)
{
    claim("sign", least.e, error.v / UNIT);
    return lane_of(0);
}

#define minors_hear       hear_minors
#define minors_hear_signs hear_signs
#include "pair/kernels/minors/minors_kernel.h"
#undef minors_hear
#undef minors_hear_signs

/* One corner of b, seen from a. */
static void count_point(minors_kind d, const lane *a, const lane *b, lane size)
{
    minors_view v;
    minors_point p;
    for (lane &x : p.x)
        x = lane_of(1);
    minors_look(d, a, b, b, b + d.dim * (d.dim + 1), size, nullptr, &v);
    kernel.insert(0, "point of ");
    (void)minors_check_point(d, &v, &p);
}

/* Records of frames of one size; inverses are off as kernels/inverse.h has it. */
static void count_minors(int dim, int what)
{
    static const char *const name[3] = {"minors", "minors of simplices", "minors of one of each"};
    const bool moves = what % 2 == 1, simplices = what / 2 == 1;
    static lane record[2][200], room[8600];
    const int inverse = dim * (dim + 2), reach = 2 * dim * (dim + 1), speed = dim * (dim + 1);
    const double size = some_size();
    kernel = flavour(name[what / 2], dim, moves);
    for (int side = 0; side < 2; side++) {
        lane *x = record[side];
        for (int j = 0; j < dim; j++) { /* rounded differences of the two are of this size */
            x[j] = x[speed + j] = side ? lane{size, size} : lane{0, 0};
            x[reach + j] = {some_size(), 0};
        }
        for (int j = 0; j < dim * dim; j++) {
            x[dim + j] = {size, 0};
            double part = x[reach + j / dim].v / dim;
            x[inverse + j] = {part, 2 * part};
        }
        x[dim * (2 * dim + 3)] = {size, 0};
        x[dim * (2 * dim + 3) + 1] = x[dim * (2 * dim + 3) + 2] = lane_of(0);
    }
    const minors_kind d = minors_kind_of(dim, what);
    minors_said said = minors_silent();
    const minors_asked at[2] = {{MINORS_AT_0, 0, nullptr}, {MINORS_AT_1, 0, nullptr}};
    (void)minors_ask(d, &at[0], record[0], record[1], (double *)room, &said);
    if (moves && simplices)
        (void)minors_ask(d, &at[1], record[0], record[1], (double *)room, &said);
    if (!simplices)
        count_point(minors_side(d, 0), record[0], record[1], {size, 0});
}

/* ---- verdicts: any axes ---------------------------------------------------------------------- */

#include "frame/flat.c"
#include "pair/kernels/verdict/verdict_flat.h"

/* Directions of any size; differences of axes are rounded, and so are shift and drift. */
static void make_flat_pair(const fmb_flat_kind *k, flat_pair *p)
{
    const double shift = some_size();
    p->reach = {shift, 0};
    for (lane &x : p->shift)
        x = {shift, shift};
    for (int i = 0; i < FMB_FLAT_DIRECTIONS; i++) {
        const int side = i / FMB_FLAT_MOST_EDGES, edge = i % FMB_FLAT_MOST_EDGES;
        const bool is_axis = side < 2 && edge < k->side[side].naxes;
        const double size = i < FMB_FLAT_WORLD ? some_size() : 1;
        for (lane &x : p->direction[i])
            x = {size, i >= FMB_FLAT_WORLD || is_axis ? 0 : size};
        p->size[i] = {size, 0};
        if (is_axis || (k->moves && i == FMB_FLAT_DRIFT))
            p->reach.v += size;
    }
}

static void count_flat(int dim, bool moves, int shapes)
{
    const int naxes[2] = {shapes % (dim + 1), shapes / (dim + 1) % (dim + 1)};
    const bool simplex[2] = {shapes % 2 == 1, shapes / 2 % 2 == 1};
    fmb_flat_kind k;
    flat_pair p;
    fmb_flat_kind_of(dim, moves, naxes, simplex, &k);
    kernel = flavour("any axes", dim, moves);
    make_flat_pair(&k, &p);
    for (int i = 0; i < k.normals; i++) {
        lane n[3];
        double bound = flat_normal(dim, &k, &p, i, n).v * p.reach.v;
        claim("gap", flat_gap(dim, &k, &p, n).e,
              (dim == 2 ? int{FLAT_ERROR_PLANE} : int{FLAT_ERROR_SPACE}) * bound);
    }
}

/* ---- contacts -------------------------------------------------------------------------------- */

#include "pair/kernels/contact/contact_overlap.h"

/* Of frames that are no cuboids the overlap is the gap above. The square of a length is rounded by
 * 3 u, and its root by half of that and u. */
static void count_depth(int dim)
{
    const int naxes[2] = {dim, dim};
    const bool simplex[2] = {false, false};
    const int most = dim == 2 ? int{FLAT_ERROR_PLANE} : int{FLAT_ERROR_SPACE};
    const int far = dim == 2 ? int{CONTACT_LENGTH_PLANE} : int{CONTACT_LENGTH_SPACE};
    fmb_flat_kind k;
    flat_pair p;
    lane middle[3], n[3], side;
    fmb_flat_kind_of(dim, false, naxes, simplex, &k);
    make_flat_pair(&k, &p);
    contact_between_middles(dim, &p, middle);
    kernel = flavour("contact of cuboids", dim, false);
    for (int i = 0; i < k.normals; i++) {
        double size = flat_normal(dim, &k, &p, i, n).v, off = 0, length = 0;
        claim("overlap", contact_of_cuboids(dim, &p, middle, n, &side).e, most * size * p.reach.v);
        for (int j = 0; j < dim; j++) {
            off = std::hypot(off, n[j].e);
            length = std::hypot(length, size_of(n[j]));
        }
        claim("length", off + 2.5 * length, far * size);
    }
}

/* ---- verdicts: separating axes --------------------------------------------------------------- */

#include "study/sat/axes.h"

static void count_overlap(sat_state *, lane least, lane error)
{
    claim("overlap", least.e, error.v / UNIT);
}

#define sat_learn count_overlap
#include "study/sat/kernels.h"

static void count_axes(int dim, bool moves, bool a, bool b)
{
    const sat_kind kind = {dim, moves, a, b};
    kernel = flavour(!b  ? "axes, two cuboids"
                     : a ? "axes, two simplices"
                         : "axes, one of each",
                     dim, moves);
    dim == 2 ? sat_decide_flat(kind, rows) : sat_decide(kind, FMB_ASK_ALL, rows);
}

/* ---- boxes of frames that stand still -------------------------------------------------------- */

#include "pair/kernels/box/box_kernel.h"

static double some_number() // of either sign; often a small one
{
    return uniform() < 0.2 ? std::ldexp(uniform() - 0.5, -20) : 2 * uniform() - 1;
}

static still_frame some_frame(int dim)
{
    still_frame f = {};
    for (int j = 0; j < dim; j++) {
        for (int l = 0; l < dim; l++) {
            f.axes[l][j] = {some_number(), 0};
            f.extent[j] = f.extent[j] + lane_abs(f.axes[l][j]);
        }
    }
    return f;
}

/* A point on the edge along axis `ahead`, from the end of axis `back` (-1: from corner y), and what
 * clipping rounds. The errors of the two axes count by halves, as the point is between their ends.
 */
static void claim_wide(const still_view *v, bool simplex, int i, lane y, int back, int ahead)
{
    const double half = simplex ? 0 : v->half.v, bound = simplex ? 0 : v->half.e;
    lane d = v->edge[ahead][i];
    double axes = d.e, corner = y.e, twice = 0;
    if (back >= 0) {
        d = d - v->edge[back][i];
        twice = v->edge[back][i].e;
        corner -= twice;
        axes = std::max(v->edge[ahead][i].e, twice);
    }
    double rounding = d.e - v->edge[ahead][i].e - twice;
    double needed = corner + axes + rounding + bound;
    needed += 2 * (std::fabs(y.v) + std::fabs(d.v)) + 3 * half;
    claim("wide", needed * (1 + 0x1p-10), v->wide[i].v / UNIT);
}

static void count_still_view(int dim, int host, int guest)
{
    const box_kind kind = {dim, false, false, {host, guest}}, *k = &kind;
    const still_frame a = some_frame(dim), b = some_frame(dim);
    lane shift[3];
    still_view v;
    for (int j = 0; j < dim; j++)
        shift[j] = lane{4 * some_number(), 0} - lane{4 * some_number(), 0};
    still_view_of(k, &a, &b, shift, &v);
    kernel = flavour(counted_fused ? "still view, fused" : "still view", dim, false) +
             (host ? "simplex host, " : "cuboid host, ");
    const bool simplex = guest == FMB_SIMPLEX;
    for (int c = 0; c < (simplex ? dim + 1 : 1 << dim); c++)
        for (int i = 0; i < box_values(k, STILL_HOST); i++) {
            lane y = v.start[i];
            for (int l = 0; l < dim; l++)
                if (simplex ? c == l + 1 : c >> l & 1)
                    y = y + v.edge[l][i];
            for (int l = 0; l < dim; l++)
                if (simplex ? c != l + 1 : !(c >> l & 1))
                    claim_wide(&v, host == FMB_SIMPLEX, i, y, simplex ? c - 1 : -1, l);
        }
}

/* ---- boxes of any frames --------------------------------------------------------------------- */

static box_frame moving_frame(int dim, bool moves)
{
    box_frame f = {};
    for (int j = 0; j < dim; j++) {
        f.origin[j] = {4 * some_number(), 0};
        f.speed[j] = {moves ? some_number() : 0, 0};
        for (int l = 0; l < dim; l++)
            f.axes[l][j] = {some_number(), 0};
    }
    return f;
}

static double off(lane2 x)
{
    return x.hi.e + x.lo.e;
}

/* If its lower half is dropped. */
static lane upper_half_of(lane2 x)
{
    return {x.hi.v, off(x) + size_of(x.lo) / UNIT};
}

/* What y (a simplex host), or else size - y, and then d are off by where lines are clipped. */
static double off_in_clipping(bool fine, bool simplex, lane2 size, lane2 y, lane2 d)
{
    lane from = upper_half_of(y), rest = upper_half_of(size) - from;
    if (fine)
        return off(simplex ? y : lane2_subtract(true, size, y)) + off(d);
    return (simplex ? from : rest).e + upper_half_of(d).e;
}

/* A coordinate in the host of a point on an edge, in doubles, but for its last rounding. */
static double off_inside(lane rho, lane2 y, lane2 d)
{
    lane from = upper_half_of(y) * rho, along = upper_half_of(d) * rho;
    return from.e + along.e + size_of(along) / 2;
}

static void count_view(int dim, bool moves, bool fine, int host, int guest)
{
    const box_kind kind = {dim, moves, fine, {guest, host}}, *k = &kind;
    const box_frame a = moving_frame(dim, moves), b = moving_frame(dim, moves);
    box_view v;
    box_guest g;
    box_view_of(k, 0, &a, &b, &v);
    box_guest_of(k, 0, &v, &b, &g);
    const lane rho = {1 / v.size.hi.v, 0};
    kernel = flavour(fine ? "view, fine" : "view", dim, moves) +
             (host ? "simplex host, " : "cuboid host, ");
    for (int at = 0; at <= moves; at++) {
        for (int n = 0; n < box_directions(k, 0); n++) {
            box_direction e;
            box_direction_of(k, 0, &v, &b, n, &e);
            for (int c = 0; c < box_corners(k, 0); c++)
                for (int i = 0; box_starts(k, 0, n, c) && i < box_values(k, 1); i++) {
                    const bool simplex = host == FMB_SIMPLEX;
                    const double error = v.error[i].v / UNIT;
                    lane2 y = g.y[c][i];
                    claim("edge", off_in_clipping(fine, simplex, v.size, y, e.d[i]), error);
                    if (!fine)
                        claim("inside", off_inside(rho, y, e.d[i]), 2.25 * error * rho.v);
                    if (at == 0) /* paths start there */
                        claim("path", off_in_clipping(fine, simplex, v.size, y, v.drift[i]), error);
                }
        }
        box_guest_move(k, 0, &v, &b, &g);
    }
}

/* Edges that meet, on majorants: values are at most `most`, and off by 14 times that. */
static void count_contact()
{
    const box_kind kind = {3, true, false, {FMB_CUBOID, FMB_CUBOID}}, *k = &kind;
    box_view v = {};
    lane2 value[3];
    for (int i = 0; i < 3; i++) {
        v.most[i] = {some_size(), 0};
        v.drift[i] = value[i] = {{v.most[i].v, 14 * v.most[i].v}, {0, 0}};
    }
    double least = std::min(v.most[0].v, std::min(v.most[1].v, v.most[2].v));
    v.size = {{least, 14 * least}, {0, 0}};
    const box_cross x = box_cross_of(k, &v, value, 0, 1, 2);
    lane2 det = box_det(k, value[0], value[1], value[0], value[1]);
    lane2 w = lane2_times(false, det, value[2]);
    w = lane2_add(false, lane2_add(false, w, w), w);
    kernel = "edges that meet: ";
    claim("plane", 2 * det.hi.e, x.far_plane.v / UNIT);
    claim("along", w.hi.e, x.far_along.v / UNIT);
    claim("size along", lane2_subtract(false, x.whole, w).hi.e, x.far_along.v / UNIT);
    claim("parameter", 2 * det.hi.e, 121 * v.most[0].v * v.most[1].v);
}

/* Ends |s| <= 2 of a part of a line, but for the error of values. */
static void count_clipping()
{
    lane d = {some_size(), 0}, r = lane_of(1) / d;
    lane2 y = lane2_of({2 * d.v * (1 - uniform() / 8), 0});
    lane2 s = lane2_over(false, y, lane2_of(d), r);
    kernel = "clipping: ";
    claim("end", lane2_subtract(false, s, lane2_of({0x1p-20, 0})).hi.e, 16);
}

/* ---- boxes in the world ---------------------------------------------------------------------- */

/* Numbers of a block, and the rows that only boxes have. */
static void some_block(double *block)
{
    double part[4];
    for (double &p : part)
        p = std::ldexp(1, -(int)(uniform() * 30));
    for (int i = 0; i < FMB_BLOCK_MOST_ROWS; i++)
        block[i] = part[(int)(uniform() * 4)] * some_number();
}

/* The largest coordinate of a corner of a frame, from its origin. */
template <class F> static double farthest(int dim, bool simplex, const F &f, const lane *from)
{
    double most = 0;
    for (int j = 0; j < dim; j++)
        for (int c = 0; c < (simplex ? dim + 1 : 1 << dim); c++) {
            double x = from[j].v;
            for (int l = 0; l < dim; l++)
                if (simplex ? c == l + 1 : c >> l & 1)
                    x += f.axes[l][j].v;
            most = std::max(most, std::fabs(x));
        }
    return most;
}

/* What is stored as a coordinate in the world; ends exceed the exact ones for this, and as gaps
 * allow. */
static void claim_world(int dim, double out, double far, double largest, double most, double gaps)
{
    for (int j = 0; j < 2 * dim; j++)
        claim("world", stored[j].e, out * far * (1 - 1e-12));
    claim("far", far * (1 - 1e-12), most * largest);
    claim("excess", 2 * out * most * UNIT + gaps, 1e-12);
}

/* A part of an edge or path in doubles: the lower halves of its ends are left out. */
static box_part some_part(bool fine)
{
    double lo = uniform() / 2, hi = lo + uniform() / 2;
    box_part p = {lane2_of({lo, 0}), lane2_of({hi, 0}), {0, 0}, {0, 0}, {0, 0}};
    box_measure(&p);
    claim("middle and half", p.middle.e + p.half.e, 2 * (1 + 1e-12));
    p.middle.e = 0;
    p.half.e = fine;
    return p;
}

static void count_world(int dim, bool moves, bool fine, int one, int two)
{
    const box_kind kind = {dim, moves, fine, {one, two}}, *k = &kind;
    double block[FMB_BLOCK_MOST_ROWS], largest = 0;
    const lane blur[3] = {};
    box_pair p;
    box_hull h;
    some_block(block);
    box_pair_of(k, block, &p);
    box_hull_empty(&h);
    h.time[0] = h.time[1] = {0.5, 0};
    kernel = flavour(fine ? "box, fine" : "box", dim, moves);
    for (int guest = 0; guest < 2; guest++) {
        const box_frame *f = &p.frame[guest];
        const box_view v = {};
        box_guest g;
        box_guest_of(k, guest, &v, f, &g);
        for (int n = 0; n < box_directions(k, guest); n++) {
            box_direction e;
            box_direction_of(k, guest, &v, f, n, &e);
            for (int c = 0; c < box_corners(k, guest); c++) {
                if (!box_starts(k, guest, n, c))
                    continue;
                box_part part = some_part(fine);
                box_cover_world(k, &h, g.world[c], e.world, part.middle, part.half);
                box_cover_world(k, &h, g.world[c], f->speed, part.middle, part.half);
                if (guest == 1 && dim == 3 && moves) { /* off by the lower halves */
                    const box_contact x = {{uniform(), 1}, {uniform(), 1}, {0, 0}};
                    const box_cross of = {};
                    box_cover_contact(k, &x, &of, f, &g, c, &e, &h);
                }
            }
        }
        lane end[3];
        for (int j = 0; j < dim; j++)
            end[j] = f->origin[j] + f->speed[j];
        largest = std::max(largest, farthest(dim, k->shape[guest], *f, f->origin));
        largest = std::max(largest, farthest(dim, k->shape[guest], *f, end));
        box_guest_move(k, guest, &v, f, &g);
        for (int c = 0; moves && c < box_corners(k, guest); c++)
            box_cover_world(k, &h, g.world[c], f->axes[0], {0, 0}, {0, 0});
    }
    box_store(k, &p, &h, blur, answer);
    claim_world(dim, 12, p.far.v, largest, 21, 9e-13);
    if (dim == 3 && moves)
        claim("time", stored[4 * dim].e, 8);
}

static void count_still_world(int dim, int one, int two)
{
    const box_kind kind = {dim, false, false, {one, two}}, *k = &kind;
    double block[FMB_BLOCK_MOST_ROWS], largest = 0;
    const still_view v = {};
    still_pair p;
    still_hull h;
    some_block(block);
    still_pair_of(k, block, &p);
    still_hull_empty(&h);
    kernel = flavour("still box", dim, false);
    for (int guest = 0; guest < 2; guest++) {
        still_frame *f = &p.frame[guest];
        lane from[3];
        for (int j = 0; j < dim; j++)
            from[j] = p.place[j] + f->origin[j];
        largest = std::max(largest, farthest(dim, k->shape[guest], *f, from));
        for (int n = 0; n < dim; n++) { /* from the corner farthest from the origin */
            const int next = (n + 1) % dim, last = (n + 2) % dim;
            still_direction e;
            still_direction_of(k, &v, f, n, k->shape[guest] ? next : -1, &e);
            lane start[3];
            for (int j = 0; j < dim; j++) {
                start[j] = f->origin[j] + f->axes[next][j];
                if (!k->shape[guest] && dim == 3)
                    start[j] = start[j] + f->axes[last][j];
            }
            still_part part = {{uniform() / 2, 0}, {(1 + uniform()) / 2, 0}};
            part.length = part.upper - part.lower;
            part.sum = part.upper + part.lower;
            part.some = true;
            still_cover_parts(k, &e, 1, &part, start, nullptr, nullptr, &h);
        }
    }
    still_store(k, &p, &h, answer);
    claim_world(dim, 16, p.far.v, largest, 15, 9.4e-13);
}

/* Ends in coordinates of B, points of edges of A being exact. */
static void count_still_inside()
{
    const box_kind kind = {3, false, true, {FMB_CUBOID, FMB_CUBOID}}, *k = &kind;
    still_view v = {};
    still_hull h;
    still_hull_empty(&h);
    const double size = some_size();
    v.size = {size, size}; // its lower half is left out
    v.half = lane_of(0.5) * v.size;
    h.guest[0][0] = {size * (uniform() - 0.5), 0};
    h.guest[1][0] = {size / 2, 0};
    still_inside(k, &v, lane_of(1) / v.size, 0, &h);
    kernel = "still box: ";
    claim("inside", std::max(h.own[0][0].e, h.own[1][0].e), 8);
    claim("excess inside", 9.9e-13 + 2 * 8 * UNIT, 1e-12);
}

/* Where edges meet, t and u are off by the margin: the world's ends are out by both. */
static void count_contact_world()
{
    const box_kind kind = {3, true, true, {FMB_CUBOID, FMB_CUBOID}}, *k = &kind;
    const box_contact x = {{uniform(), 0}, {uniform(), 0}, {0x1p-42, 0}};
    box_frame b = moving_frame(3, true);
    box_cross of = {};
    box_direction e = {};
    box_guest g = {};
    box_hull h;
    of.margin = {0x1p-43, 0};
    for (int j = 0; j < 3; j++)
        e.world[j] = {some_number(), 0};
    box_hull_empty(&h);
    box_cover_contact(k, &x, &of, &b, &g, 0, &e, &h);
    kernel = "edges that meet: ";
    for (int j = 0; j < 3; j++) {
        double at = x.t.v * b.speed[j].v + x.u.v * e.world[j].v;
        double off = of.margin.v * (size_of(b.speed[j]) + size_of(e.world[j])) - 0x1p-50;
        claim("ends in the world", off, at - h.world[0][j].v);
        claim("ends in the world", off, h.world[1][j].v - at);
        claim("excess of them", off + (at - h.world[0][j].v),
              h.gap.v * std::max(size_of(b.speed[j]), size_of(e.world[j])) + 0x1p-50);
    }
    const lane u = {x.u.v, 0}, r = lane_of(1) / lane_of(3);
    lane2 quotient = lane2_over(false, lane2_of(lane_of(3) * u), lane2_of(lane_of(3)), r);
    claim("rounding of a parameter", (quotient.hi - of.margin).e, 16);
}

/* Verdicts on frames with all their axes. */
static void count_frames(int dim, bool moves)
{
    counted_sign = 0;
    count_local_frame(dim, moves);
    counted_sign = 0;
    kernel = flavour("cuboids", dim, moves);
    dim == 2 ? fmb_cuboids_2d(nullptr, moves) : fmb_cuboids_3d(nullptr, moves, single, FMB_ASK_ALL);
    for (int simplex = 0; simplex < 2; simplex++) {
        kernel = flavour(simplex ? "two simplices" : "cuboid, simplex", dim, moves);
        dim == 2 ? fmb_simplices_2d(nullptr, moves, simplex)
                 : fmb_simplices_3d(nullptr, moves, simplex, single, FMB_ASK_ALL);
    }
}

int main()
{
    counted_majorant = true;
    for (int i = 0; i < 4000; i++) {
        counted_fused = i & 1;
        for (double &a : alpha)
            a = some_size();
        beta = some_size();
        delta = some_size();
        omega = some_size();
        for (int dim = 2; dim <= 3; dim++)
            for (int moves = 0; moves < 2; moves++) {
                count_frames(dim, moves);
                single = dim == 3;
                if (single)
                    count_frames(dim, moves);
                single = false;
                count_flat(dim, moves, i);
                count_depth(dim);
                count_axes(dim, moves, false, false);
                count_axes(dim, moves, false, true);
                count_axes(dim, moves, true, true);
            }
    }
    for (int i = 0; i < 40; i++) {
        counted_fused = i & 1;
        for (int dim = 4; dim <= 8; dim++)
            for (int what = 0; what < FMB_MINORS_WHATS; what++)
                if (fmb_minors_decide(dim, static_cast<fmb_minors_what>(what)))
                    count_minors(dim, what);
    }
    for (int i = 0; i < 4000; i++)
        count_contact();
    counted_majorant = false;
    for (int i = 0; i < 1000; i++) {
        counted_fused = i & 1;
        count_clipping();
        count_contact_world();
        count_still_inside();
        for (int shapes = 0; shapes < 4; shapes++)
            for (int fine = 0; fine < 2; fine++)
                for (int dim = 2; dim <= 3; dim++) {
                    rows = nullptr;
                    count_still_world(dim, shapes / 2, shapes % 2);
                    count_world(dim, false, fine, shapes / 2, shapes % 2);
                    count_world(dim, true, fine, shapes / 2, shapes % 2);
                    count_still_view(dim, shapes / 2, shapes % 2);
                    count_view(dim, false, fine, shapes / 2, shapes % 2);
                    count_view(dim, true, fine, shapes / 2, shapes % 2);
                }
    }
    return report() ? 0 : 1;
}
