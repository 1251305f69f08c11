/* whole_pair.c: see whole_pair.h. */
#include "pair/kernels/whole_pair.h"

/* What numbers of a pair are multiples of, as exponents of two. */
typedef struct units {
    int axes, origins;
} units;

static units units_of_pair(const whole_records *x, unsigned l)
{
    const int at = (x->dim * (2 * x->dim + 3) + 3) * x->width + (int)l;
    units of[2];
    for (int k = 0; k < 2; k++)
        fmb_minors_split_units(x->record[k][at], &of[k].axes, &of[k].origins);
    const int axes = of[0].axes < of[1].axes ? of[0].axes : of[1].axes;
    const int origins = of[0].origins < of[1].origins ? of[0].origins : of[1].origins;
    return (units){axes, origins < axes ? origins : axes};
}

/* The largest absolute value of n numbers of both frames, from number `from` on. */
static double find_largest(const whole_records *x, unsigned l, int from, int n)
{
    double most = 0;
    for (int k = 0; k < 2; k++)
        for (int i = from; i < from + n; i++)
            most = fmax(most, fabs(x->record[k][i * x->width + (int)l]));
    return most;
}

bool fmb_whole_pair_is_short(const whole_records *x, unsigned l)
{
    const int dim = x->dim, speed = dim * (dim + 1), size = dim * (2 * dim + 3);
    const units unit = units_of_pair(x, l);
    const double edges = find_largest(x, l, size, 1), shift = find_largest(x, l, 0, dim);
    const double drift = x->moves ? find_largest(x, l, speed, dim) : 0;
    const double all = 2 * (dim * edges + drift + shift);
    return unit.axes - unit.origins < 56 && all < ldexp(0x1p56, unit.origins);
}

static int64_t whole_of(const whole_records *x, unsigned l, int k, int number, double scale)
{
    return (int64_t)(x->record[k][number * x->width + (int)l] * scale);
}

static void begin_vector(normal_vector *v)
{
    v->most = 0;
}
static void put_number(normal_vector *v, int j, int64_t x)
{
    v->whole[j] = x;
    v->near[j] = (double)x;
    v->most = fabs(v->near[j]) > v->most ? fabs(v->near[j]) : v->most;
}

/* Read the difference of B's number and A's. */
static void read_difference(const whole_records *x, unsigned l, int from, double scale,
                            normal_vector *out)
{
    begin_vector(out);
    for (int j = 0; j < x->dim; j++)
        put_number(out, j, whole_of(x, l, 1, from + j, scale) - whole_of(x, l, 0, from + j, scale));
}

static void read_body(const whole_records *x, unsigned l, int k, double scale, whole_body *out)
{
    const int dim = x->dim;
    out->simplex = x->simplex[k];
    out->n = 0;
    if (out->simplex) {
        normal_vector *v = &out->edge[out->n++];
        begin_vector(v);
        for (int j = 0; j < dim; j++)
            put_number(v, j, 0);
    }
    for (int i = 1; i <= dim; i++) {
        normal_vector *v = &out->edge[out->n++];
        begin_vector(v);
        for (int j = 0; j < dim; j++)
            put_number(v, j, whole_of(x, l, k, dim * i + j, scale));
    }
}

void fmb_whole_pair_read(const whole_records *x, unsigned l, whole_pair *out)
{
    const units unit = units_of_pair(x, l);
    const double axes = ldexp(1, -unit.axes);
    out->dim = x->dim;
    for (int k = 0; k < 2; k++)
        read_body(x, l, k, axes, &out->body[k]);
    if (x->moves) {
        whole_body *b = &out->body[1];
        read_difference(x, l, x->dim * (x->dim + 1), axes, &b->edge[b->n++]);
    }
    read_difference(x, l, 0, ldexp(1, -unit.origins), &out->shift);
    out->finer = INT64_C(1) << (unit.axes - unit.origins);
}

const normal_vector *fmb_whole_pair_edge(const whole_pair *p, int body, int first, int number,
                                         normal_vector *room)
{
    const normal_vector *v = &p->body[body].edge[number];
    if (first == 0)
        return v;
    begin_vector(room);
    for (int j = 0; j < p->dim; j++)
        put_number(room, j, v->whole[j] - p->body[body].edge[first].whole[j]);
    return room;
}

/* sum += by times the low or the high corner. */
static void add_whole_corner(int dim, const whole_body *b, const whole_span *s, bool high,
                             int64_t by, int64_t *sum)
{
    for (int i = 0; i < b->n; i++) {
        const bool has =
            b->simplex ? i == (high ? s->highest : s->lowest) : s->sign[i] == (high ? 1 : -1);
        for (int j = 0; has && j < dim; j++)
            sum[j] += by * b->edge[i].whole[j];
    }
}

void fmb_whole_pair_between(const whole_pair *p, const whole_span s[2], bool b_below,
                            normal_vector *out)
{
    int64_t sum[NORMAL_MOST_DIM] = {0};
    add_whole_corner(p->dim, &p->body[0], &s[0], !b_below, -1, sum);
    add_whole_corner(p->dim, &p->body[1], &s[1], b_below, 1, sum);
    begin_vector(out);
    for (int j = 0; j < p->dim; j++)
        put_number(out, j, sum[j] * p->finer + p->shift.whole[j]);
}

int fmb_whole_pair_trim(const whole_pair *p, whole_faces *faces)
{
    int n = 0;
    for (int k = 0; k < 2; k++) {
        unsigned left = faces->of[k];
        for (left &= p->body[k].simplex ? left - 1 : left; left; left &= left - 1) {
            if (n == p->dim - 1)
                faces->of[k] &= ~(left & -left);
            else
                n++;
        }
    }
    return n;
}
