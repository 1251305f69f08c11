/* minors.c: kernels of cuboids, simplices and one of each in four to eight dimensions
 * (pair/kernels/minors) in every width, one pair at a time too: never wrong, and decide nearly all
 * random pairs; their tables recomputed. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/frames.h>

#include "pair/kernels/minors/minors_table.h"
#include "pair/kernels/minors_kernels.h"
#include "property/random/rows.h"
#include "study/draw/draft.h"
#include "study/draw/pairs.h"
#include "tables.h"

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

/* ---- verdicts -------------------------------------------------------------------------------- */

enum { PAIRS = 100 };

typedef struct drawn {
    study_pair pair[PAIRS];
    double record[2][PAIRS * FMB_MINORS_MOST_RECORD];
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
    SCALED,  /* all numbers are times a power of two */
    NEEDLE   /* B becomes a simplex with a far corner, whose facet touches A's origin */
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

static double draw_whole(uint64_t *state, int most)
{
    return (double)(study_splitmix.get(state) % (2 * (unsigned)most + 1)) - most;
}

/* Axis of A: x, or -x, beyond the plane perpendicular to n, or of B's facet: x made perpendicular
 * to n, times `by`. All numbers are whole. */
static void draw_beyond(uint64_t *state, int dim, const double *n, double *x)
{
    double along = 0;
    for (int j = 0; j < dim; j++)
        along += n[j] * (x[j] = draw_whole(state, 40));
    for (int j = 0; j < dim; j++)
        x[j] *= along < 0 ? -1 : 1;
}
/* One that is perpendicular to n, a multiple of `by`. */
static void draw_level(uint64_t *state, int dim, const double *n, double by, double *x)
{
    double along = 0, nn = 0;
    for (int j = 0; j < dim; j++) {
        along += n[j] * (x[j] = draw_whole(state, 40));
        nn += n[j] * n[j];
    }
    for (int j = 0; j < dim; j++)
        x[j] = (nn * x[j] - along * n[j]) * by;
}

/* The facet is opposite to B's origin, below which it lies along n; A's axes point upwards. */
static void make_needle(uint64_t i, study_pair *p)
{
    const int dim = p->p.dim;
    double *a = p->number[0], *b = p->number[1], n[STUDY_PAIR_MOST_DIM], to[STUDY_PAIR_MOST_DIM];
    uint64_t state;
    int left = 16;
    study_splitmix.set(&state, i);
    for (int j = 0; j < dim; j++)
        n[j] = draw_whole(&state, 3) + (j == 0 ? 4 : 0);
    for (int j = 0; j < dim; j++)
        a[j] = b[j] = draw_whole(&state, 1000);
    draw_beyond(&state, dim, n, to);
    for (int k = 0; k < dim; k++) {
        double *axis = b + dim * (k + 1);
        const int part =
            k == dim - 1 ? left : (int)(study_splitmix.get(&state) % (unsigned)(left + 1));
        left -= part;
        draw_beyond(&state, dim, n, a + dim * (k + 1));
        draw_level(&state, dim, n, k == 0 ? 0x1p20 : 1, axis);
        for (int j = 0; j < dim; j++) {
            axis[j] += to[j];
            a[j] += part / 16.0 * axis[j];
        }
    }
}

static void change(twist how, uint64_t i, study_pair *p)
{
    const int dim = p->p.dim, j = (int)(i * 7 % (uint64_t)dim);
    double *number = p->number[1] + (p->q.origin - p->number[1]) + j;
    if (how == NEEDLE)
        make_needle(i, p);
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

/* Vectors between a far corner and the others are all long, whatever their ends are. */
Test(minors, far_corners)
{
    static drawn d;
    kernel_table table[4];
    size_t tables = find_tables(table);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= 6; dim++)
        for (int kind = 0; kind < 4; kind++) {
            const fmb_minors_what what = kind < 2 ? FMB_MINORS_SIMPLICES : FMB_MINORS_MIXED;
            draw(STUDY_PAIR_ARTICLE, NEEDLE, dim, what, (fmb_contact)(kind % 2), PAIRS, &d);
            cr_expect_gt(d.n, PAIRS / 2u);
            for (size_t i = 0; i < d.n; i++)
                cr_expect_eq(d.is[i], kind % 2 ? FMB_INFEASIBLE : FMB_FEASIBLE);
            for (size_t t = 0; t < tables; t++)
                check(table[t].kernels, &d);
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
