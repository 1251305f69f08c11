/* least_overlap.c: see least_overlap.h.
 *
 * A facet of M is a face of P less a face of Q, with the drift or without. Its directions are those
 * of edges of the two faces, and the drift. Of a face of a cuboid the edges span all, of a face of
 * a simplex those from any one of its corners: so D - 1 independent ones among these span the
 * facet, and the normals of all such choices are those of all facets, and more. None of them tells
 * less than the depth: where M has an interior then its depth is the least of overlap / size.
 *
 * The coordinates of a normal are the minors of its D - 1 directions. They are made one direction
 * after the other, so that choices that begin alike share minors, in doubles first: only where
 * these do not tell that the overlap is larger than the least one known are whole numbers asked.
 *
 * Numbers are short where they can be: what all share of a coordinate is no part of it, and what
 * all numbers of a direction share is no part of that one. In doubles each direction is scaled so
 * that none of its numbers is larger than 1, and has its length beside it. Let size(S) be the sum
 * of all products that make up the minor of rows S, without signs, and 2^-900. A number read
 * differs from the exact one by 2^-52 of itself, or by 2^-1074; a minor of k <= 7 rows sums k
 * products; so each level adds less than (k + 4) 2^-52 size(S) to the error, all of them less than
 * 2^-46 size(S), and SHARE is four times that. The overlap is a sum of less than 30 products of
 * coordinates of the normal and numbers of the frames, whose sum without signs is `weight`; twice
 * SHARE bounds what they are off by. The surplus is far more than these bounds themselves are
 * rounded by.
 */
#include "proximity/least_overlap.h"

#include <math.h>

#include "num/vec.h"

#define SHARE 0x1p-44
#define LEAST 0x1p-900 /* far above what is lost where doubles end */
#define ABOVE (1 + 0x1p-40)

enum {
    MOST = FMB_NORMALS_MOST_DIM,
    MOST_DIRECTIONS = MOST * (MOST + 1) + 1 + MOST, /* edges, the drift, axes of the world */
    SETS = 1 << MOST
};

/* Edges of one side are chosen together if they belong to one group: those of a cuboid are one
 * group, those of a simplex that start at one corner. Those of Q are negated. */
typedef struct direction {
    int side, group; /* side 2: the drift; 3: the world */
    mpz_t *exact;    /* [dim] times 2^-power */
    double x[MOST];  /* the same scaled ... */
    double length;   /* ... by this share of the largest direction, or of `away` */
    mp_bitcnt_t power;
} direction;

/* P, Q and the drift: M is `away` and a point of each, which is a sum of shares of its axes, of a
 * simplex of all of them no more than 1. */
typedef struct summand {
    int axes, first; /* directions */
    bool simplex;
} summand;

typedef struct normal_search {
    fmb_minkowski *m;
    fmb_norm norm;
    fmb_run *run;
    fmb_mem *mem;
    int directions; /* without those of the world, which follow */
    direction direction[MOST_DIRECTIONS];
    summand of[3];
    mp_bitcnt_t unit[MOST], coarsest; /* coordinate j is 2^unit[j] as long as it is here */
    double share[MOST];               /* that of a normal is so many of the longest there can be */
    int chosen[MOST];
    double minor[SETS], size[SETS];  /* of the directions chosen: a set of k rows is about k */
    mpz_t *exact;                    /* [sets] the same minors in whole numbers ... */
    int known;                       /* ... of so many directions */
    mpz_t *away;                     /* [dim] origin of P - origin of Q */
    double near[MOST], weight[MOST]; /* the same scaled; the largest |coordinates| of M */
    double best;                     /* no less than the least overlap / size, scaled */
    fmb_least_overlap at;            /* the one at hand */
    mpz_t *cell;                     /* [cells] all numbers */
    size_t cells;
    mpz_t low, high, span[2], t, s;
} normal_search;

/* ---- life ------------------------------------------------------------------------------------ */

void fmb_least_overlap_init(fmb_least_overlap *x)
{
    x->found = false;
    mpz_inits(x->overlap, x->size, NULL);
    for (int j = 0; j < MOST; j++)
        mpz_init(x->normal[j]);
}

void fmb_least_overlap_clear(fmb_least_overlap *x)
{
    mpz_clears(x->overlap, x->size, NULL);
    for (int j = 0; j < MOST; j++)
        mpz_clear(x->normal[j]);
}

static direction *add_direction(normal_search *x, int side, int group)
{
    direction *d = &x->direction[x->directions];
    *d = (direction){.side = side, .group = group, .exact = x->cell + x->directions * x->m->dim};
    x->directions++;
    return d;
}

/* Edges of corner `group` of that side; of corner 0, the origin, they are the axes. */
static void add_edges(normal_search *x, int side, int group)
{
    const fmb_minkowski_frame *f = &x->m->frame[side];
    for (int i = group + 1; i <= f->naxes; i++) {
        direction *d = add_direction(x, side, group);
        for (int j = 0; j < x->m->dim; j++) {
            mpz_set(d->exact[j], f->row[i * x->m->dim + j]);
            if (group > 0)
                mpz_sub(d->exact[j], d->exact[j], f->row[group * x->m->dim + j]);
            if (side == 1)
                mpz_neg(d->exact[j], d->exact[j]);
        }
    }
}

static void add_directions(normal_search *x)
{
    for (int side = 0; side < 2; side++) {
        const fmb_minkowski_frame *f = &x->m->frame[side];
        x->of[side] = (summand){f->naxes, x->directions, f->shape == FMB_SIMPLEX};
        for (int group = 0; group == 0 || (x->of[side].simplex && group < f->naxes); group++)
            add_edges(x, side, group);
    }
    x->of[2] = (summand){x->m->moves, x->directions, false};
    direction *drift = x->m->moves ? add_direction(x, 2, 0) : NULL;
    int ours = x->directions;
    for (int j = 0; j < x->m->dim; j++) {
        if (drift)
            mpz_set(drift->exact[j], x->m->drift[j]);
        mpz_set_ui(add_direction(x, 3, 0)->exact[j], 1);
        mpz_sub(x->away[j], x->m->frame[0].row[j], x->m->frame[1].row[j]);
    }
    x->directions = ours;
}

/* What all numbers of a direction share of powers of 2 goes out of it. */
static void shorten(normal_search *x, direction *d)
{
    mpz_set_ui(x->t, 0);
    for (int j = 0; j < x->m->dim; j++)
        mpz_ior(x->t, x->t, d->exact[j]);
    d->power = mpz_sgn(x->t) == 0 ? 0 : mpz_scan1(x->t, 0);
    for (int j = 0; j < x->m->dim; j++)
        mpz_tdiv_q_2exp(d->exact[j], d->exact[j], d->power);
}

static size_t most_bits(mpz_t *v, int dim)
{
    size_t most = 1;
    for (int j = 0; j < dim; j++) {
        size_t bits = mpz_sizeinbase(v[j], 2);
        most = bits > most ? bits : most;
    }
    return most;
}

/* 0 where doubles end */
static double power_of_two(long exponent)
{
    return exponent < -1100 ? 0 : ldexp(1, (int)exponent);
}

static double scaled(const mpz_t z, size_t top)
{
    long exponent;
    double x = mpz_get_d_2exp(&exponent, z);
    return x * power_of_two(exponent - (long)top);
}

/* The doubles of all numbers. */
static void scale_numbers(normal_search *x)
{
    int dim = x->m->dim;
    size_t bits[MOST_DIRECTIONS], top = most_bits(x->away, dim);
    mp_bitcnt_t finest = x->unit[0];
    for (int j = 0; j < dim; j++) {
        x->coarsest = x->unit[j] > x->coarsest ? x->unit[j] : x->coarsest;
        finest = x->unit[j] < finest ? x->unit[j] : finest;
    }
    for (int i = 0; i < x->directions; i++) {
        shorten(x, &x->direction[i]);
        bits[i] = most_bits(x->direction[i].exact, dim);
        if (bits[i] + x->direction[i].power > top)
            top = bits[i] + x->direction[i].power;
    }
    for (int j = 0; j < dim; j++) {
        x->near[j] = scaled(x->away[j], top);
        x->weight[j] = fabs(x->near[j]);
        x->share[j] = power_of_two((long)finest - (long)x->unit[j]);
    }
    for (direction *d = x->direction; d < x->direction + x->directions; d++) {
        size_t most = bits[d - x->direction];
        d->length = power_of_two((long)(most + d->power) - (long)top);
        for (int j = 0; j < dim; j++) {
            d->x[j] = scaled(d->exact[j], most);
            x->weight[j] += d->group == 0 ? d->length * fabs(d->x[j]) : 0;
        }
    }
}

static fmb_status open_search(normal_search *x)
{
    size_t dim = (size_t)x->m->dim, edges = 2 + dim; /* away, the drift, the world */
    for (int side = 0; side < 2; side++)
        edges += (size_t)x->m->frame[side].naxes * ((size_t)x->m->frame[side].naxes + 1) / 2;
    x->cells = edges * dim + ((size_t)1 << dim);
    fmb_least_overlap_init(&x->at);
    mpz_inits(x->low, x->high, x->span[0], x->span[1], x->t, x->s, NULL);
    x->cell = fmb_vec_block(x->cells, x->mem);
    if (!x->cell)
        return fmb_mem_status(x->mem);
    x->exact = x->cell + edges * dim;
    x->away = x->exact - dim;
    x->best = INFINITY;
    fmb_minkowski_shorten(x->m, x->unit);
    add_directions(x);
    scale_numbers(x);
    x->minor[0] = x->size[0] = 1;
    mpz_set_ui(x->exact[0], 1);
    return FMB_OK;
}

static void close_search(normal_search *x)
{
    fmb_least_overlap_clear(&x->at);
    fmb_vec_block_free(x->cell, x->cells, x->mem);
    mpz_clears(x->low, x->high, x->span[0], x->span[1], x->t, x->s, NULL);
}

/* ---- minors ---------------------------------------------------------------------------------- */

/* The next larger set of as many rows. */
static unsigned next_set(unsigned set)
{
    unsigned low = set & -set, carry = set + low;
    return carry | (set ^ carry) >> (2 + __builtin_ctz(low));
}

/* All minors of one direction more, by Laplace expansion along it: their signs are right, or all of
 * them are wrong. */
static void find_minors(normal_search *x, int level)
{
    const double *d = x->direction[x->chosen[level]].x;
    for (unsigned set = (2U << level) - 1; set < 1U << x->m->dim; set = next_set(set)) {
        double sum = 0, size = LEAST, sign = 1;
        for (unsigned rest = set; rest != 0; rest &= rest - 1, sign = -sign) {
            unsigned row = (unsigned)__builtin_ctz(rest), less = set & ~(1U << row);
            sum += sign * d[row] * x->minor[less];
            size += fabs(d[row]) * x->size[less];
        }
        x->minor[set] = sum;
        x->size[set] = size;
    }
}

/* The same in whole numbers. Are they all 0? */
static bool find_exact_minors(normal_search *x, int level)
{
    bool zero = true;
    mpz_t *d = x->direction[x->chosen[level]].exact;
    for (unsigned set = (2U << level) - 1; set < 1U << x->m->dim; set = next_set(set)) {
        mpz_ptr sum = x->exact[set];
        bool minus = false;
        mpz_set_ui(sum, 0);
        for (unsigned rest = set; rest != 0; rest &= rest - 1, minus = !minus) {
            unsigned row = (unsigned)__builtin_ctz(rest), less = set & ~(1U << row);
            (minus ? mpz_submul : mpz_addmul)(sum, d[row], x->exact[less]);
        }
        zero &= mpz_sgn(sum) == 0;
    }
    x->known = level + 1;
    return zero;
}

/* Does the direction chosen last depend on those before? */
static bool is_dependent(normal_search *x, int level)
{
    bool zero = false;
    x->known = x->known < level ? x->known : level;
    find_minors(x, level);
    for (unsigned set = (2U << level) - 1; set < 1U << x->m->dim; set = next_set(set))
        if (fabs(x->minor[set]) > SHARE * x->size[set])
            return false;
    while (x->known <= level)
        zero = find_exact_minors(x, x->known);
    return zero;
}

/* ---- overlaps in doubles --------------------------------------------------------------------- */

/* Coordinates beyond those of the space are 0. */
static double along(const double *n, const double *v)
{
    double sum[2] = {0, 0};
    for (int j = 0; j < MOST; j += 2) {
        sum[0] += n[j] * v[j];
        sum[1] += n[j + 1] * v[j + 1];
    }
    return sum[0] + sum[1];
}

/* What M spans along n. */
static void find_ends(const normal_search *x, const double *n, double end[2])
{
    end[0] = end[1] = along(n, x->near);
    for (const summand *f = x->of; f < x->of + 3; f++) {
        double span[2] = {0, 0};
        for (int i = 0; i < f->axes; i++) {
            const direction *d = &x->direction[f->first + i];
            double at = along(n, d->x) * d->length, *most = &span[at > 0];
            *most = !f->simplex ? *most + at : fabs(at) > fabs(*most) ? at : *most;
        }
        end[0] += span[0];
        end[1] += span[1];
    }
}

/* The length of n >= 0: of a minor as small as 2^-944 (SHARE times LEAST) the square would be lost.
 */
static double length_of_doubles(const double *n, int dim)
{
    double top = 0, sum = 0;
    int exponent;
    for (int j = 0; j < dim; j++)
        top = fmax(top, n[j]);
    (void)frexp(top, &exponent);
    for (int j = 0; j < dim; j++) {
        double part = ldexp(n[j], -exponent);
        sum += part * part;
    }
    return ldexp(sqrt(sum), exponent);
}

static double size_of_doubles(const normal_search *x, const double *n)
{
    double sum = 0;
    if (x->norm == FMB_NORM_EUCLIDEAN)
        return length_of_doubles(n, x->m->dim);
    for (int j = 0; j < x->m->dim; j++)
        sum += n[j];
    return sum;
}

/* Bounds for overlap and size of the normal at hand, and whether it has no less than the best. */
static bool is_surely_more(const normal_search *x, double *bound)
{
    int dim = x->m->dim, all = (1 << dim) - 1;
    double n[MOST] = {0}, up[MOST], down[MOST], end[2], off = LEAST;
    for (int j = 0; j < dim; j++) {
        double fuzz = SHARE * x->size[all & ~(1 << j)];
        n[j] = (j & 1 ? -1 : 1) * x->minor[all & ~(1 << j)];
        up[j] = (fabs(n[j]) + fuzz) * x->share[j];
        down[j] = fmax(fabs(n[j]) - fuzz, 0) * x->share[j];
        off += 2 * fuzz * x->weight[j];
    }
    find_ends(x, n, end);
    double overlap = fmin(end[1], -end[0]);
    *bound = ABOVE * (fmax(overlap, 0) + off) / size_of_doubles(x, down);
    return overlap - off > x->best * size_of_doubles(x, up);
}

/* ---- overlaps in whole numbers --------------------------------------------------------------- */

/* What M spans along the normal at hand; the overlap is the smaller way from 0 out of it, and the
 * normal is turned to where that leads. */
static void measure_overlap(normal_search *x)
{
    fmb_least_overlap *n = &x->at;
    int all = (1 << x->m->dim) - 1;
    for (int j = 0; j < x->m->dim; j++)
        (j & 1 ? mpz_neg : mpz_set)(n->normal[j], x->exact[all & ~(1 << j)]);
    fmb_minkowski_dot(x->m, n->normal, x->away, x->low);
    mpz_set(x->high, x->low);
    for (const summand *f = x->of; f < x->of + 3; f++) {
        mpz_set_ui(x->span[0], 0);
        mpz_set_ui(x->span[1], 0);
        for (int i = 0; i < f->axes; i++) {
            const direction *d = &x->direction[f->first + i];
            fmb_minkowski_dot(x->m, n->normal, d->exact, x->t);
            mpz_mul_2exp(x->t, x->t, d->power);
            mpz_ptr most = x->span[mpz_sgn(x->t) > 0];
            if (!f->simplex)
                mpz_add(most, most, x->t);
            else if (mpz_cmpabs(x->t, most) > 0)
                mpz_set(most, x->t);
        }
        mpz_add(x->low, x->low, x->span[0]);
        mpz_add(x->high, x->high, x->span[1]);
    }
    mpz_neg(x->low, x->low);
    bool back = mpz_cmp(x->low, x->high) < 0;
    mpz_mul_2exp(n->overlap, back ? x->low : x->high, x->coarsest);
    for (int j = 0; back && j < x->m->dim; j++)
        mpz_neg(n->normal[j], n->normal[j]);
}

/* The normal at hand, as it is in the units of the space. */
static void measure_normal(normal_search *x)
{
    fmb_least_overlap *n = &x->at;
    for (int j = 0; j < x->m->dim; j++)
        mpz_mul_2exp(n->normal[j], n->normal[j], x->coarsest - x->unit[j]);
    if (x->norm == FMB_NORM_EUCLIDEAN) {
        fmb_minkowski_dot(x->m, n->normal, n->normal, n->size);
        return;
    }
    mpz_set_ui(n->size, 0);
    for (int j = 0; j < x->m->dim; j++) {
        mpz_abs(x->t, n->normal[j]);
        mpz_add(n->size, n->size, x->t);
    }
}

/* Is what is at hand less than the least? Neither is less than 0, but where that decides. */
static bool is_less(normal_search *x, const fmb_least_overlap *least)
{
    if (!least->found || mpz_sgn(x->at.overlap) < 0)
        return true;
    mpz_set(x->t, x->at.overlap);
    mpz_set(x->s, least->overlap);
    if (x->norm == FMB_NORM_EUCLIDEAN) {
        mpz_mul(x->t, x->t, x->t);
        mpz_mul(x->s, x->s, x->s);
    }
    mpz_mul(x->t, x->t, least->size);
    mpz_mul(x->s, x->s, x->at.size);
    return mpz_cmp(x->t, x->s) < 0;
}

static void swap_overlaps(fmb_least_overlap *a, fmb_least_overlap *b)
{
    fmb_least_overlap t = *a;
    *a = *b;
    *b = t;
}

/* ---- all normals ----------------------------------------------------------------------------- */

/* The normal of dim - 1 directions, which are independent. */
static fmb_status look_at_normal(normal_search *x, fmb_least_overlap *out)
{
    double bound;
    if (is_surely_more(x, &bound))
        return FMB_OK;
    while (x->known < x->m->dim - 1)
        find_exact_minors(x, x->known);
    measure_overlap(x);
    measure_normal(x);
    x->at.found = true;
    if (is_less(x, out)) {
        swap_overlaps(&x->at, out);
        x->best = fmin(x->best, bound);
    }
    return fmb_run_poll(x->run);
}

/* Is 0 known not to be inside of M? Then no other normal tells more. */
static bool is_on_boundary(const fmb_least_overlap *x)
{
    return x->found && mpz_sgn(x->overlap) <= 0;
}

/* All choices that go on from the first `level`. */
static fmb_status choose(normal_search *x, int level, int from, fmb_least_overlap *out)
{
    fmb_status st = fmb_run_poll(x->run);
    if (level == x->m->dim - 1)
        return st == FMB_OK ? look_at_normal(x, out) : st;
    const direction *last = level > 0 ? &x->direction[x->chosen[level - 1]] : NULL;
    for (int i = from; st == FMB_OK && i < x->directions && !is_on_boundary(out); i++) {
        const direction *next = &x->direction[i];
        if (last && last->side == next->side && last->group != next->group)
            continue;
        x->chosen[level] = i;
        if (!is_dependent(x, level))
            st = choose(x, level + 1, i + 1, out);
    }
    return st;
}

/* At right angles to all directions, of which less than dim - 1 are independent: axes of the world
 * are taken in for the others. */
static void take_any_normal(normal_search *x, fmb_least_overlap *out)
{
    int level = 0;
    x->known = 0;
    for (int i = 0; level < x->m->dim - 1; i++) {
        x->chosen[level] = i;
        level += !find_exact_minors(x, level);
    }
    measure_overlap(x);
    measure_normal(x);
    swap_overlaps(&x->at, out);
    out->found = false;
}

bool fmb_has_normals(const fmb_minkowski *m)
{
    return m->dim <= MOST && m->frame[0].naxes <= m->dim && m->frame[1].naxes <= m->dim;
}

fmb_status fmb_find_least_overlap(fmb_minkowski *m, fmb_norm norm, fmb_run *run,
                                  fmb_least_overlap *out)
{
    normal_search x = {.m = m, .norm = norm, .run = run, .mem = m->mem};
    fmb_status st = open_search(&x);
    FMB_THEN(st, choose(&x, 0, 0, out));
    if (st == FMB_OK && !out->found)
        take_any_normal(&x, out);
    close_search(&x);
    return st;
}
