/* exact_contact.c: see exact_contact.h.
 *
 * All normals of flat.h in integers. Of frames that meet every overlap is at least 0; the least of
 * o / |n| is found by comparing o^2 |m|^2 with p^2 |n|^2. A normal that is 0 does not count. If all
 * are 0 then M (minkowski.h) is at most a segment: the frames touch, and anything at right angles
 * to it is a normal.
 */
#include "pair/contact/exact_contact.h"

#include <math.h>

#include "num/rationals.h"
#include "pair/kernels/flat.h"
#include "proximity/minkowski.h"

typedef struct exact_contact {
    fmb_minkowski m;
    fmb_flat_kind kind;
    mpz_t direction[FMB_FLAT_DIRECTIONS][3];
    mpz_t normal[3], overlap, square; /* at hand */
    mpz_t least[3], depth, length;    /* the least: its normal, overlap, square of that normal */
    mpz_t low, high, t, s;
    bool found;
} exact_contact;

static void for_each_number(exact_contact *x, void (*what)(mpz_ptr))
{
    mpz_ptr one[] = {x->overlap, x->square, x->depth, x->length, x->low, x->high, x->t, x->s};
    for (size_t i = 0; i < sizeof one / sizeof *one; i++)
        what(one[i]);
    for (int j = 0; j < 3; j++) {
        what(x->normal[j]);
        what(x->least[j]);
        for (int i = 0; i < FMB_FLAT_DIRECTIONS; i++)
            what(x->direction[i][j]);
    }
}

static void start_number(mpz_ptr x)
{
    mpz_init(x);
}

static void end_number(mpz_ptr x)
{
    mpz_clear(x);
}

static mpz_t *row_of(const exact_contact *x, int side, int row)
{
    return x->m.frame[side].row + row * x->m.dim;
}

static void read_directions(exact_contact *x)
{
    for (int side = 0; side < 2; side++) {
        const fmb_flat_side *s = &x->kind.side[side];
        mpz_t(*to)[3] = x->direction + side * FMB_FLAT_MOST_EDGES;
        for (int i = 0; i < s->edges; i++) {
            const uint8_t *ends = i < s->naxes ? NULL : fmb_flat_ends(i, s->naxes);
            for (int j = 0; j < x->m.dim; j++) {
                if (ends)
                    mpz_sub(to[i][j], to[ends[1]][j], to[ends[0]][j]);
                else
                    mpz_set(to[i][j], row_of(x, side, 1 + i)[j]);
            }
        }
    }
    for (int j = 0; j < x->m.dim; j++) {
        mpz_set(x->direction[FMB_FLAT_DRIFT][j], x->m.drift[j]);
        mpz_set_ui(x->direction[FMB_FLAT_WORLD + j][j], 1);
    }
}

/* The normal of number i, and the square of its length. */
static void make_normal(exact_contact *x, int i)
{
    mpz_t *f = x->direction[x->kind.normal[i][0]], *g = x->direction[x->kind.normal[i][1]];
    if (x->m.dim == 2) {
        mpz_set(x->normal[0], f[1]);
        mpz_neg(x->normal[1], f[0]);
    }
    for (int j = 0; x->m.dim == 3 && j < 3; j++) {
        mpz_mul(x->normal[j], f[(j + 1) % 3], g[(j + 2) % 3]);
        mpz_submul(x->normal[j], f[(j + 2) % 3], g[(j + 1) % 3]);
    }
    fmb_minkowski_dot(&x->m, x->normal, x->normal, x->square);
}

/* Add sign times what a side spans along the normal to [low, high]. */
static void add_span(exact_contact *x, int side, int sign)
{
    const fmb_flat_side *s = &x->kind.side[side];
    mpz_t low, high;
    mpz_inits(low, high, NULL);
    for (int i = 0; i < s->naxes; i++) {
        fmb_minkowski_dot(&x->m, x->normal, row_of(x, side, 1 + i), x->t);
        if (sign < 0)
            mpz_neg(x->t, x->t);
        mpz_ptr end = mpz_sgn(x->t) < 0 ? low : high;
        if (!s->simplex)
            mpz_add(end, end, x->t);
        else if (mpz_cmpabs(x->t, end) > 0)
            mpz_set(end, x->t);
    }
    mpz_add(x->low, x->low, low);
    mpz_add(x->high, x->high, high);
    mpz_clears(low, high, NULL);
}

/* What M = A - B spans along the normal; the overlap is the smaller way from 0 out of it, and the
 * normal is turned to where that leads. */
static void measure_overlap(exact_contact *x)
{
    fmb_minkowski_dot(&x->m, x->normal, row_of(x, 0, 0), x->low);
    fmb_minkowski_dot(&x->m, x->normal, row_of(x, 1, 0), x->t);
    mpz_sub(x->low, x->low, x->t);
    mpz_set(x->high, x->low);
    add_span(x, 0, 1);
    add_span(x, 1, -1);
    fmb_minkowski_dot(&x->m, x->normal, x->m.drift, x->t);
    mpz_ptr end = mpz_sgn(x->t) < 0 ? x->low : x->high;
    mpz_add(end, end, x->t);
    bool back = mpz_cmpabs(x->low, x->high) < 0;
    mpz_abs(x->overlap, back ? x->low : x->high);
    for (int j = 0; back && j < x->m.dim; j++)
        mpz_neg(x->normal[j], x->normal[j]);
}

/* Is o^2 / n^2 less than the least? */
static bool is_less(exact_contact *x)
{
    if (!x->found)
        return true;
    mpz_mul(x->t, x->overlap, x->overlap);
    mpz_mul(x->t, x->t, x->length);
    mpz_mul(x->s, x->depth, x->depth);
    mpz_mul(x->s, x->s, x->square);
    return mpz_cmp(x->t, x->s) < 0;
}

static void take_normal(exact_contact *x)
{
    for (int j = 0; j < x->m.dim; j++)
        mpz_swap(x->least[j], x->normal[j]);
    mpz_swap(x->depth, x->overlap);
    mpz_swap(x->length, x->square);
    x->found = true;
}

/* At right angles to all directions, which are parallel. */
static void take_any_normal(exact_contact *x)
{
    mpz_t *f = x->direction[FMB_FLAT_WORLD];
    for (int i = 0; i <= FMB_FLAT_DRIFT; i++)
        for (int j = 0; j < x->m.dim; j++)
            f = mpz_sgn(x->direction[i][j]) != 0 ? x->direction[i] : f;
    int a = mpz_sgn(f[0]) != 0 ? 0 : 1, b = (a + 1) % x->m.dim;
    mpz_set(x->least[b], f[a]);
    mpz_neg(x->least[a], f[b]);
    if (mpz_sgn(x->least[a]) == 0 && mpz_sgn(x->least[b]) == 0)
        mpz_set_ui(x->least[0], 1);
    mpz_set_ui(x->depth, 0);
}

/* The direction of the least as doubles of length 1, whatever its numbers are. */
static void write_normal(const exact_contact *x, double *out)
{
    long most = 0, exponent[3];
    double length = 0;
    bool any = false;
    for (int j = 0; j < x->m.dim; j++) {
        out[j] = mpz_get_d_2exp(&exponent[j], x->least[j]);
        if (out[j] != 0 && (!any || exponent[j] > most))
            most = exponent[j];
        any |= out[j] != 0;
    }
    for (int j = 0; j < x->m.dim; j++) {
        long down = exponent[j] - most;
        out[j] = down < -2000 ? 0 : ldexp(out[j], (int)down);
        length += out[j] * out[j];
    }
    for (int j = 0; j < x->m.dim; j++)
        out[j] /= sqrt(length);
}

static double round_depth(exact_contact *x)
{
    mpq_t square;
    if (mpz_sgn(x->depth) == 0)
        return 0;
    mpq_init(square);
    mpz_mul(mpq_numref(square), x->depth, x->depth);
    mpz_mul(mpq_denref(square), x->m.unit, x->m.unit);
    mpz_mul(mpq_denref(square), mpq_denref(square), x->length);
    mpq_canonicalize(square);
    double depth = fmb_nearest_root(square);
    mpq_clear(square);
    return depth;
}

static void find_least(exact_contact *x)
{
    read_directions(x);
    for (int i = 0; i < x->kind.normals; i++) {
        make_normal(x, i);
        if (mpz_sgn(x->square) == 0)
            continue;
        measure_overlap(x);
        if (is_less(x))
            take_normal(x);
    }
    if (!x->found)
        take_any_normal(x);
}

fmb_status fmb_exact_contact(const fmb_frame *f, fmb_mem *mem, double *depth, double *normal)
{
    exact_contact x = {.found = false};
    for_each_number(&x, start_number);
    fmb_status st = fmb_minkowski_init(&x.m, &(fmb_two){.f = f}, mem);
    if (st == FMB_OK) {
        const int naxes[2] = {f[0].naxes, f[1].naxes};
        const bool simplex[2] = {x.m.frame[0].shape == FMB_SIMPLEX,
                                 x.m.frame[1].shape == FMB_SIMPLEX};
        fmb_flat_kind_of(f[0].dim, x.m.moves, naxes, simplex, &x.kind);
        find_least(&x);
        *depth = round_depth(&x);
        write_normal(&x, normal);
    }
    fmb_minkowski_clear(&x.m);
    for_each_number(&x, end_number);
    return st;
}
