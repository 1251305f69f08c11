/* minors.c: kernels of cuboids, simplices and one of each in four to eight dimensions
 * (pair/kernels/minors) in every width, one pair at a time too: never wrong, and decide nearly all
 * random pairs; their tables recomputed; contents of records. */
#include <criterion/criterion.h>
#include <gmp.h>
#include <math.h>
#include <string.h>

#include <fmb/frames.h>

#include "pair/kernels/inverse.h"
#include "pair/kernels/minors/minors_table.h"
#include "pair/kernels/minors_kernels.h"
#include "pair/kernels/pair_kernels.h"
#include "property/random/rows.h"
#include "study/draw/draft.h"
#include "study/draw/pairs.h"

/* ---- tables ---------------------------------------------------------------------------------- */

static int rank_of(unsigned set)
{
    int rank = 0;
    for (unsigned less = 0; less < set; less++)
        rank += __builtin_popcount(less) == __builtin_popcount(set);
    return rank;
}

static int with(int k, int s, int j)
{
    return k == 0   ? FMB_MINORS_WITH_0[s][j]
           : k == 1 ? FMB_MINORS_WITH_1[s][j]
           : k == 2 ? FMB_MINORS_WITH_2[s][j]
           : k == 3 ? FMB_MINORS_WITH_3[s][j]
                    : FMB_MINORS_WITH_4[s][j];
}

/* Those of four numbers are of numbers below 6 alone. */
static bool is_in_table(int k, unsigned set)
{
    return k <= 3 || (k == 4 && set < 1U << 6);
}

/* Bits of sets of numbers below 6, in their places: without j; with an even number above j. */
static void check_words(void)
{
    for (unsigned set = 0; set < 64; set++) {
        for (unsigned j = 0; j < 6; j++) {
            cr_expect_eq(FMB_MINORS_WITHOUT[j] >> set & 1, !(set >> j & 1));
            cr_expect_eq(FMB_MINORS_EVEN_ABOVE[j] >> set & 1,
                         __builtin_popcount(set >> j >> 1) % 2 == 0);
        }
        for (int size = 0; size <= 3; size++)
            cr_expect_eq(FMB_MINORS_OF_SIZE[size] >> set & 1, __builtin_popcount(set) == size);
    }
}

Test(minors, tables)
{
    for (unsigned set = 0; set < 1U << FMB_MINORS_MOST; set++) {
        int k = __builtin_popcount(set), place = 0;
        cr_expect_eq(FMB_MINORS_RANK[set], rank_of(set));
        if (k >= 1 && k <= 3)
            cr_expect_eq((k == 1   ? FMB_MINORS_SET_1
                          : k == 2 ? FMB_MINORS_SET_2
                                   : FMB_MINORS_SET_3)[rank_of(set)],
                         set);
        for (unsigned j = 0; is_in_table(k, set) && j < (k == 4 ? 6 : FMB_MINORS_MOST); j++)
            if (!(set >> j & 1))
                cr_expect_eq(with(k, rank_of(set), place++), rank_of(set | 1U << j));
    }
    check_words();
    for (int n = 0; n <= FMB_MINORS_MOST; n++)
        for (int size = 0; size <= 5; size++) {
            int count = 0;
            for (unsigned set = 0; set < 1U << n; set++)
                count += __builtin_popcount(set) == size;
            cr_expect_eq(fmb_minors_choose(n, size), count);
        }
}

static bool is_there(int dim, int what)
{
    return fmb_minors_decide(dim, (fmb_minors_what)what);
}

Test(minors, room)
{
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++) {
        int most = 0;
        for (int what = 0; what < FMB_MINORS_WHATS; what++) {
            if (!is_there(dim, what))
                continue;
            int simplices = what / 2 == 1, n = dim + simplices + what % 2;
            int last = what / 2 == 2 ? dim - 2 + what % 2 : (n - 1) / 2, lanes = 0;
            int rows = dim + (what / 2 > 0);
            int words = !simplices ? 0 : n > 6 ? (1 << (n - 6)) + 1 : 2;
            for (int k = 2; k <= last; k++)
                lanes += fmb_minors_choose(rows, k) * (fmb_minors_choose(n, k) + words);
            lanes = what / 2 == 2 ? (lanes + 1) / 2 : lanes; /* one view has it all */
            most = lanes > most ? lanes : most;
        }
        cr_expect_eq(fmb_minors_room(dim), (size_t)(2 * FMB_BLOCK_MOST_LANES * most));
    }
}

/* ---- records --------------------------------------------------------------------------------- */

enum { MOST = FMB_MINORS_MOST_DIM, NUMBERS = 2 * MOST * MOST + 3 * MOST + 8 };

typedef mpq_t rows[MOST][2 * MOST];

/* Gauss and Jordan: [A | 1] becomes [1 | inverse of A], and A is regular. */
static void invert(int dim, rows x)
{
    mpq_t t;
    mpq_init(t);
    for (int c = 0; c < dim; c++) {
        int p = c;
        while (mpq_sgn(x[p][c]) == 0)
            p++;
        for (int j = 0; j < 2 * dim; j++)
            mpq_swap(x[p][j], x[c][j]);
        for (int j = 2 * dim - 1; j >= c; j--)
            mpq_div(x[c][j], x[c][j], x[c][c]);
        for (int r = 0; r < dim; r++)
            for (int j = 2 * dim - 1; r != c && j >= c; j--) {
                mpq_mul(t, x[r][c], x[c][j]);
                mpq_sub(x[r][j], x[r][j], t);
            }
    }
    mpq_clear(t);
}

/* Is x a multiple of that power of two? */
static bool is_multiple(double x, double of)
{
    return x / of == rint(x / of);
}

/* What stands behind the size, of whole numbers: is it as kernels/inverse.h says? */
static void expect_whole(const fmb_frame *f, const double *more)
{
    for (int j = 0; j < f->dim * f->dim; j++)
        cr_expect(is_multiple(f->axes[j], more[1]));
    for (int j = 0; j < f->dim; j++)
        cr_expect(is_multiple(f->origin[j], more[1]));
    for (int j = 0; f->speed && j < f->dim; j++)
        cr_expect(is_multiple(f->speed[j], more[1]));
    cr_expect(is_multiple(more[0], more[1]));
}

/* Are all of these multiples of 2^unit, and not all of twice that? */
static bool is_unit(int unit, const double *x, int n)
{
    bool even = true, whole = true;
    for (int i = 0; i < n; i++) {
        whole &= is_multiple(x[i], ldexp(1, unit));
        even &= is_multiple(x[i], ldexp(2, unit));
    }
    return whole && !even;
}

static void expect_units(const fmb_frame *f, double both)
{
    int axes, origin;
    fmb_minors_split_units(both, &axes, &origin);
    cr_expect(is_unit(origin, f->origin, f->dim));
    cr_expect(f->speed || is_unit(axes, f->axes, f->dim * f->dim));
    for (int j = 0; f->speed && j < f->dim * f->dim; j++)
        cr_expect(is_multiple(f->axes[j], ldexp(1, axes)));
    for (int j = 0; f->speed && j < f->dim; j++)
        cr_expect(is_multiple(f->speed[j], ldexp(1, axes)));
}

/* Against the exact one. */
static void expect_inverse(const fmb_frame *f, const double *record)
{
    const int dim = f->dim;
    const double *inverse = record + dim * (dim + 2), *reach = record + 2 * dim * (dim + 1);
    const double *more = record + dim * (2 * dim + 3) + 1;
    rows x;
    mpq_t off;
    mpq_init(off);
    if (more[1] > 0)
        expect_whole(f, more);
    expect_units(f, more[2]);
    for (int r = 0; r < dim; r++)
        for (int c = 0; c < 2 * dim; c++) {
            mpq_init(x[r][c]);
            mpq_set_d(x[r][c], c < dim ? f->axes[c * dim + r] : c - dim == r);
        }
    invert(dim, x);
    for (int r = 0; r < dim; r++) {
        double error = 0, sum[2] = {0, 0};
        for (int j = 0; j < dim; j++) {
            mpq_set_d(off, more[0]);
            mpq_mul(off, x[r][dim + j], off);
            cr_expect(mpz_cmp_ui(mpq_denref(off), 1) == 0);
            mpq_set_d(off, inverse[r * dim + j]);
            sum[0] += fabs(mpq_get_d(off));
            sum[1] += fabs(mpq_get_d(x[r][dim + j]));
            mpq_sub(off, off, x[r][dim + j]);
            error += fabs(mpq_get_d(off));
        }
        cr_expect_leq(error, 0x1p-52 * reach[r]);
        cr_expect(sum[0] <= reach[r] && sum[1] <= reach[r]);
    }
    for (int r = 0; r < dim; r++)
        for (int c = 0; c < 2 * dim; c++)
            mpq_clear(x[r][c]);
    mpq_clear(off);
}

extern const fmb_minor_kernels minors_plain;

/* The kernels of one width. */
typedef struct kernel_table {
    const fmb_minor_kernels *kernels;
    unsigned width;
} kernel_table;

/* Tables of this processor. */
static size_t find_tables(kernel_table out[4])
{
    const fmb_simd level[3] = {FMB_SIMD_PLAIN, FMB_SIMD_AVX2, FMB_SIMD_AVX512};
    size_t n = 0;
#ifdef HAVE_PLAIN
    out[n++] = (kernel_table){&minors_plain, 1};
#endif
    for (int i = 0; i < 3; i++) {
        const fmb_pair_kernels *k = fmb_pair_kernels_choose(level[i]);
        if (k)
            out[n++] = (kernel_table){k->minors, (unsigned)k->width};
    }
    return n;
}

/* The record of f alone, by these kernels; does it have one? */
static bool make_record(const fmb_minor_kernels *kernels, const fmb_frame *f, double *record)
{
    fmb_inverse_write_frame(f, record);
    if (kernels->invert(f->dim, &record, 1) != 1)
        return false;
    fmb_inverse_write_integers(f->dim, record);
    return true;
}

/* Is a record of a block the same as alone? Every other frame of the block is flat. */
static void expect_same_in_block(kernel_table t, const fmb_frame *f, const double *alone)
{
    double number[8][NUMBERS], *record[8];
    for (unsigned l = 0; l < t.width; l++) {
        record[l] = number[l];
        fmb_inverse_write_frame(f, record[l]);
        for (int j = 0; j < f->dim && l % 2 == 1; j++)
            record[l][f->dim + j] = 0;
    }
    const unsigned good = t.kernels->invert(f->dim, record, t.width);
    cr_expect_eq(good, 0x55U & ((1U << t.width) - 1));
    for (unsigned l = 0; l < t.width; l += 2) {
        fmb_inverse_write_integers(f->dim, record[l]);
        cr_expect_arr_eq(record[l], alone, (size_t)fmb_minors_record(f->dim) * sizeof *alone);
    }
}

Test(minors, records)
{
    int made = 0, whole = 0;
    kernel_table t[4];
    const size_t tables = find_tables(t);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++)
        for (int i = 0; i < 40; i++) {
            static const study_pair_family family[] = {STUDY_PAIR_ARTICLE, STUDY_PAIR_LATTICE,
                                                       STUDY_PAIR_TOUCHING, STUDY_PAIR_INTEGER};
            const study_pair_plan plan = {.family = family[i % 4], .dim = dim, .moves = i / 4 % 2};
            const kernel_table *by = &t[(size_t)i % tables];
            study_pair p;
            double record[NUMBERS];
            study_pair_draw(&plan, 5, (uint64_t)i, &p);
            if (!make_record(by->kernels, &p.p, record))
                continue;
            made++;
            whole += record[dim * (2 * dim + 3) + 2] > 0;
            expect_inverse(&p.p, record);
            expect_same_in_block(*by, &p.p, record);
        }
    cr_expect_gt(made, 150);
    cr_expect_gt(whole, 40);
}

/* Frames that have no record: too large, too small, too slender, and numbers that are none. */
Test(minors, no_records)
{
    const double bad[] = {NAN, INFINITY, -INFINITY, 0x1p301, 0x1p1023};
    kernel_table t[4];
    const size_t tables = find_tables(t);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++)
        for (size_t i = 0; i < tables; i++) {
            const study_pair_plan plan = {.family = STUDY_PAIR_ARTICLE, .dim = dim, .moves = true};
            study_pair p;
            double record[NUMBERS];
            study_pair_draw(&plan, 6, i, &p);
            cr_expect(make_record(t[i].kernels, &p.p, record));
            for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
                for (int j = 0; j < dim * (dim + 2); j++) {
                    const double kept = p.number[0][j];
                    p.number[0][j] = bad[k];
                    cr_expect(!make_record(t[i].kernels, &p.p, record));
                    p.number[0][j] = kept;
                }
            double *axes = p.number[0] + (p.p.axes - p.number[0]);
            for (int j = 0; j < dim; j++) /* nearly the second axis */
                axes[j] = axes[dim + j] * (1 + 0x1p-40 * (j == 0));
            cr_expect(!make_record(t[i].kernels, &p.p, record));
            for (int j = 0; j < dim * dim; j++)
                axes[j] = j % (dim + 1) == 0 ? 0x1p-301 : 0;
            cr_expect(!make_record(t[i].kernels, &p.p, record));
        }
}

/* ---- verdicts -------------------------------------------------------------------------------- */

enum { PAIRS = 100 };

typedef struct drawn {
    study_pair pair[PAIRS];
    double record[2][PAIRS * NUMBERS];
    fmb_frames_pair index[PAIRS];
    fmb_verdict is[PAIRS];
    size_t n;
    int dim;
    fmb_minors_what what;
    fmb_contact contact;
} drawn;

/* All axes along those of the world, so that most rows are 0 = 0, and longer, so that many meet. */
static void align(int dim, const fmb_frame *f, double *number)
{
    double *axes = number + (f->axes - number);
    for (int i = 0; i < dim * dim; i++)
        axes[i] = i / dim == i % dim ? 4 * axes[i] : 0;
}

/* How pairs are changed once they are drawn. */
typedef enum twist {
    AS_DRAWN,
    ALIGNED, /* above */
    NUDGED,  /* a number of B's origin becomes the next double, up or down */
    SCALED   /* all numbers are times a power of two */
} twist;

static void scale(const fmb_frame *f, double *number, double by)
{
    const int numbers = f->dim * f->dim;
    double *part[] = {number + (f->origin - number), number + (f->axes - number),
                      f->speed ? number + (f->speed - number) : NULL};
    for (int i = 0; i < 3; i++)
        for (int j = 0; part[i] && j < (i == 1 ? numbers : f->dim); j++)
            part[i][j] *= by;
}

static void change(twist how, uint64_t i, study_pair *p)
{
    const int dim = p->p.dim, j = (int)(i * 7 % (uint64_t)dim);
    double *number = p->number[1] + (p->q.origin - p->number[1]) + j;
    if (how == NUDGED)
        *number = nextafter(*number, i % 2 ? INFINITY : -INFINITY);
    for (int f = 0; f < 2; f++) {
        const fmb_frame *frame = f == 0 ? &p->p : &p->q;
        if (how == ALIGNED)
            align(dim, frame, p->number[f]);
        if (how == SCALED)
            scale(frame, p->number[f], ldexp(1, (int)(i * 37 % 400) - 200));
    }
}

static void draw(study_pair_family family, twist how, int dim, fmb_minors_what what,
                 fmb_contact contact, size_t count, drawn *d)
{
    const study_pair_plan plan = {.family = family,
                                  .dim = dim,
                                  .moves = what % 2 == 1,
                                  .shape = {(int)what / 2 == 1, (int)what / 2 > 0}};
    const size_t stride = (size_t)fmb_minors_record(dim);
    const fmb_minor_kernels *narrow = fmb_pair_kernels_choose(FMB_SIMD_PLAIN)->minors;
    fmb_pair_options o = {.size = sizeof o, .method = FMB_PAIR_EXACT, .contact = contact};
    fmb_pair *k = NULL;
    must(fmb_pair_new(dim, &o, NULL, &k));
    d->n = 0;
    d->dim = dim;
    d->what = what;
    d->contact = contact;
    for (uint64_t i = 0; i < count; i++) {
        study_pair *p = &d->pair[d->n];
        study_pair_draw(&plan, 7, i, p);
        change(how, i, p);
        if (!make_record(narrow, &p->p, d->record[0] + stride * d->n) ||
            !make_record(narrow, &p->q, d->record[1] + stride * d->n))
            continue;
        must(fmb_pair_test(
            k, 1, &p->p, &p->q,
            &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &d->is[d->n]}));
        d->index[d->n] = (fmb_frames_pair){(uint32_t)d->n, (uint32_t)d->n};
        d->n++;
    }
    fmb_pair_free(k);
}

/* How many the kernels of a table are sure of. */
static size_t check(const fmb_minor_kernels *t, const drawn *d)
{
    static _Alignas(64) double room[FMB_BLOCK_MOST_LANES * 8600];
    fmb_verdict says[PAIRS];
    const fmb_packed_pairs x = {.record = {d->record[0], d->record[1]},
                                .index = {&d->index->a, &d->index->b},
                                .n = d->n,
                                .closed = d->contact == FMB_CONTACT_CLOSED};
    size_t sure = 0;
    bool known = t->pairs(d->dim, d->what, &x, room, says);
    for (size_t i = 0; i < d->n; i++) {
        sure += says[i] != FMB_UNKNOWN;
        cr_expect(says[i] == FMB_UNKNOWN || says[i] == d->is[i], "pair %zu: %d, not %d", i, says[i],
                  d->is[i]);
    }
    cr_expect_eq(known, sure == d->n);
    return sure;
}

Test(minors, verdicts)
{
    static const study_pair_family family[] = {
        STUDY_PAIR_ARTICLE, STUDY_PAIR_LATTICE, STUDY_PAIR_TOUCHING, STUDY_PAIR_NEAR,
        STUDY_PAIR_FLAT,    STUDY_PAIR_SCALED,  STUDY_PAIR_RAGGED,   STUDY_PAIR_SWEPT};
    static drawn d;
    kernel_table table[4];
    size_t tables = find_tables(table);
    for (size_t f = 0; f < sizeof family / sizeof *family; f++)
        for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++)
            for (int what = 0; what < FMB_MINORS_WHATS; what++) {
                if (!is_there(dim, what))
                    continue;
                draw(family[f], AS_DRAWN, dim, (fmb_minors_what)what, FMB_CONTACT_CLOSED,
                     dim < 7 ? 40 : 12, &d);
                for (size_t t = 0; t < tables; t++) {
                    size_t sure = d.n > 0 ? check(table[t].kernels, &d) : 0;
                    cr_expect(family[f] != STUDY_PAIR_ARTICLE || sure + 1 >= d.n, "%zu of %zu",
                              sure, d.n);
                }
            }
}

/* Where numbers are small and whole nothing is left, whether the frames touch or edges are
 * parallel; with open contact some may be, and nothing is wrong. */
Test(minors, whole_numbers)
{
    static drawn d;
    kernel_table table[4];
    size_t tables = find_tables(table);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= 6; dim++)
        for (int kind = 0; kind < 2 * FMB_MINORS_WHATS; kind++) {
            const fmb_minors_what what = (fmb_minors_what)(kind / 2);
            const int mixed = (int)what / 2 == 2;
            if ((int)what / 2 == 1 || dim + (int)what % 2 > 6 - mixed)
                continue;
            draw(STUDY_PAIR_LATTICE, AS_DRAWN, dim, what, (fmb_contact)(kind % 2), 60, &d);
            for (size_t t = 0; t < tables; t++) {
                size_t sure = check(table[t].kernels, &d);
                cr_expect(kind % 2 || sure == d.n, "%dD %d: %zu of %zu", dim, (int)what, sure, d.n);
            }
        }
}

/* Rows that doubles leave open are decided in whole numbers where these are short: nearly nothing
 * is left of what touches, with closed and with open contact, of simplices less than half. What is
 * an ulp off has numbers that are too long, and is not wrong. */
Test(minors, touching)
{
    static const twist how[] = {AS_DRAWN, NUDGED, SCALED};
    static drawn d;
    kernel_table table[4];
    size_t tables = find_tables(table);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++)
        for (int kind = 0; kind < 6 * FMB_MINORS_WHATS; kind++) {
            const fmb_minors_what what = (fmb_minors_what)(kind / 6);
            const bool simplices = (int)what / 2 == 1;
            if (!is_there(dim, (int)what))
                continue;
            draw(STUDY_PAIR_TOUCHING, how[kind / 2 % 3], dim, what, (fmb_contact)(kind % 2),
                 dim < 7 ? PAIRS : 16, &d);
            cr_expect_gt(d.n, dim < 7 ? PAIRS / 2u : 4u);
            for (size_t t = 0; t < tables; t++) {
                size_t sure = check(table[t].kernels, &d);
                cr_expect(what == FMB_MINORS_MOVING_SIMPLICES || how[kind / 2 % 3] == NUDGED ||
                              (simplices ? 2 * sure > d.n : 10 * sure >= 9 * d.n),
                          "%dD %d: %zu of %zu", dim, kind, sure, d.n);
            }
        }
}

/* Signs that are certain decide, whatever others are: where many are 0 few simplices are left. */
Test(minors, few_signs)
{
    static drawn d;
    kernel_table table[4];
    size_t tables = find_tables(table);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= 5; dim++)
        for (int moves = 0; moves < 2; moves++) {
            draw(STUDY_PAIR_LATTICE, AS_DRAWN, dim, (fmb_minors_what)(FMB_MINORS_SIMPLICES + moves),
                 FMB_CONTACT_CLOSED, 60, &d);
            for (size_t t = 0; t < tables; t++) {
                size_t sure = check(table[t].kernels, &d);
                cr_expect(4 * sure >= 3 * d.n, "%zu of %zu", sure, d.n);
            }
        }
}

/* Rows tell nothing of those that meet, but points do: of all, if nothing moves, else of nine in
 * ten. */
Test(minors, parallel_edges)
{
    static drawn d;
    kernel_table table[4];
    size_t tables = find_tables(table), meeting = 0;
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++)
        for (int moves = 0; moves < 2 && dim + moves <= FMB_MINORS_MOST; moves++) {
            draw(STUDY_PAIR_ARTICLE, ALIGNED, dim, (fmb_minors_what)moves, FMB_CONTACT_CLOSED, 40,
                 &d);
            for (size_t i = 0; i < d.n; i++)
                meeting += d.is[i] == FMB_FEASIBLE;
            for (size_t t = 0; t < tables; t++) {
                size_t sure = check(table[t].kernels, &d);
                cr_expect(moves ? 10 * sure >= 9 * d.n : sure == d.n, "%zu of %zu", sure, d.n);
            }
        }
    cr_expect_gt(meeting, 30u);
}
