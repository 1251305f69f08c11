/* flat.c: the kernel for frames with any number of axes, in every width, against exact answers:
 * never wrong, and rarely undecided for frames in general position. */
#include <criterion/criterion.h>
#include <math.h>

#include "pair/block.h"
#include "pair/exact_box/exact_box.h"
#include "pair/kernels/packed_kernels.h"
#include "property/random/rows.h"
#include "study/draw/pairs.h"
#include "widths.h"

enum { LANES = FMB_BLOCK_MOST_LANES };

/* ---- kinds ----------------------------------------------------------------------------------- */

/* Of points and segments there is one shape, of frames with more axes there are two. */
enum { SHAPES_2D = 4, SHAPES_3D = 6 };

typedef struct kind {
    int dim;
    bool moves;
    int naxes[2], shape[2];
} kind;

static void set_side(kind *k, int side, int i)
{
    k->naxes[side] = i < 2 ? i : i / 2 + 1;
    k->shape[side] = i < 2 ? 0 : i % 2;
}

/* The next kind; false: there is none. i counts from 0. */
static bool kind_of(int i, kind *out)
{
    const int all[2] = {2 * SHAPES_2D * SHAPES_2D, 2 * SHAPES_3D * SHAPES_3D};
    int dim = i < all[0] ? 2 : 3, shapes = dim == 2 ? SHAPES_2D : SHAPES_3D;
    i -= dim == 3 ? all[0] : 0;
    *out = (kind){.dim = dim, .moves = i % 2};
    set_side(out, 0, i / 2 % shapes);
    set_side(out, 1, i / 2 / shapes);
    return i < all[dim - 2];
}

static study_pair_plan plan_of(study_pair_family family, const kind *k)
{
    return (study_pair_plan){
        .family = family, .dim = k->dim, .moves = k->moves, .shape = {k->shape[0], k->shape[1]}};
}

static void draw(const study_pair_plan *plan, const kind *k, uint64_t first, study_pair *pair,
                 fmb_frame *p, fmb_frame *q)
{
    for (int i = 0; i < LANES; i++) {
        study_pair_draw(plan, 9, first + (uint64_t)i, &pair[i]);
        p[i] = pair[i].p;
        q[i] = pair[i].q;
        p[i].naxes = k->naxes[0];
        q[i].naxes = k->naxes[1];
    }
}

/* ---- answers --------------------------------------------------------------------------------- */

static fmb_pair_bits ask(const fmb_pair_kernels *w, const kind *k, const fmb_frame *p,
                         const fmb_frame *q)
{
    fmb_pair_bits out = {0, 0};
    fmb_flat_kind flat;
    fmb_flat_kind_of(k->dim, k->moves, k->naxes, (bool[2]){k->shape[0], k->shape[1]}, &flat);
    for (int i = 0; i < LANES; i += w->width) {
        fmb_block b = {.lanes = 0};
        for (int lane = 0; lane < w->width; lane++)
            fmb_block_put_flat(&b, w->width, &p[i + lane], &q[i + lane], 0);
        fmb_pair_bits some = w->packed->flat(&flat, b.number);
        out.apart |= some.apart << i;
        out.meet |= some.meet << i;
    }
    return out;
}

typedef struct truth {
    fmb_pair *closed[4], *open[4]; /* by dim */
    fmb_mem mem;
    fmb_exact_boxer *boxer;
} truth;

static truth truth_new(void)
{
    truth t;
    for (int dim = 2; dim < 4; dim++) {
        fmb_pair_options o = {.size = sizeof o};
        o.method = FMB_PAIR_EXACT;
        must(fmb_pair_new(dim, &o, NULL, &t.closed[dim]));
        o.contact = FMB_CONTACT_OPEN;
        must(fmb_pair_new(dim, &o, NULL, &t.open[dim]));
    }
    fmb_mem_init(&t.mem, NULL, 0);
    t.boxer = fmb_exact_boxer_new(&t.mem, NULL);
    cr_assert(t.boxer);
    return t;
}

static void truth_free(truth *t)
{
    for (int dim = 2; dim < 4; dim++) {
        fmb_pair_free(t->closed[dim]);
        fmb_pair_free(t->open[dim]);
    }
    fmb_exact_boxer_free(t->boxer, &t->mem);
}

/* Which of the lanes asked for are apart when closed, which meet when open. */
static fmb_pair_bits truth_of(const truth *t, int dim, unsigned lanes, const fmb_frame *p,
                              const fmb_frame *q)
{
    fmb_pair_bits out = {0, 0};
    for (int i = 0; i < LANES; i++) {
        fmb_verdict closed = FMB_UNKNOWN, open = FMB_UNKNOWN;
        if (!(lanes >> i & 1))
            continue;
        must(fmb_pair_test(
            t->closed[dim], 1, &p[i], &q[i],
            &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &closed}));
        must(
            fmb_pair_test(t->open[dim], 1, &p[i], &q[i],
                          &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &open}));
        out.apart |= (unsigned)(closed == FMB_INFEASIBLE) << i;
        out.meet |= (unsigned)(open == FMB_FEASIBLE) << i;
    }
    return out;
}

/* Lanes that some width knows are held against the truth; those that all know. */
static unsigned check(const truth *t, const kind *k, const fmb_frame *p, const fmb_frame *q,
                      const char *what)
{
    const fmb_pair_kernels *w[WIDTHS];
    fmb_pair_bits says[WIDTHS];
    unsigned some = 0, all = (1U << LANES) - 1;
    int n = widths(w);
    for (int i = 0; i < n; i++) {
        says[i] = ask(w[i], k, p, q);
        some |= says[i].apart | says[i].meet;
        all &= says[i].apart | says[i].meet;
    }
    fmb_pair_bits is = truth_of(t, k->dim, some, p, q);
    for (int i = 0; i < n; i++)
        cr_expect((says[i].apart & ~is.apart) == 0 && (says[i].meet & ~is.meet) == 0,
                  "%s %dD %d: %d %d, %d %d: width %d: wrong", what, k->dim, k->moves, k->naxes[0],
                  k->shape[0], k->naxes[1], k->shape[1], w[i]->width);
    return all;
}

static void check_family(study_pair_family family, int pairs, bool all_known)
{
    static study_pair pair[LANES];
    truth t = truth_new();
    kind k;
    for (int i = 0; kind_of(i, &k); i++) {
        study_pair_plan plan = plan_of(family, &k);
        int known = 0;
        for (int first = 0; first < pairs; first += LANES) {
            fmb_frame p[LANES], q[LANES];
            draw(&plan, &k, (uint64_t)first, pair, p, q);
            known += __builtin_popcount(check(&t, &k, p, q, study_pair_family_text(family)));
        }
        if (all_known)
            cr_expect_eq(known, pairs, "%dD %d: %d %d, %d %d: %d of %d", k.dim, k.moves, k.naxes[0],
                         k.shape[0], k.naxes[1], k.shape[1], known, pairs);
    }
    truth_free(&t);
}

/* ---- at vertices ----------------------------------------------------------------------------- */

/* Verdicts at vertices where these decide, for both contacts; how many do. */
static int check_exact(const truth *t, const kind *k, const fmb_frame *p, const fmb_frame *q,
                       const char *what)
{
    int decided = 0;
    for (int contact = 0; contact < 2; contact++) {
        fmb_verdict is = FMB_UNKNOWN,
                    says = fmb_exact_box_decide(t->boxer, p, q, (fmb_contact)contact);
        fmb_pair *ask = contact ? t->open[k->dim] : t->closed[k->dim];
        if (says == FMB_UNKNOWN)
            continue;
        must(fmb_pair_test(ask, 1, p, q,
                           &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &is}));
        cr_expect_eq(says, is, "%s %dD %d: %d %d, %d %d, contact %d", what, k->dim, k->moves,
                     k->naxes[0], k->shape[0], k->naxes[1], k->shape[1], contact);
        decided++;
    }
    return decided;
}

/* The same frame by its corners, rounded. */
static void put_by_corners(fmb_frame *f, double number[9])
{
    for (int i = 0; i < f->naxes * f->dim; i++)
        number[i] = f->axes[i] + f->origin[i % f->dim];
    f->shape = f->shape == FMB_SIMPLEX ? FMB_SIMPLEX_BY_CORNERS : FMB_CUBOID_BY_CORNERS;
    f->axes = number;
}

/* Also all frames with all axes, and frames by corners. */
Test(pair_flat, vertices_of_all_families)
{
    static study_pair pair[LANES];
    truth t = truth_new();
    kind k;
    for (int family = 0; family < STUDY_PAIR_FAMILIES; family++)
        for (int i = 0, decided = 0; kind_of(i, &k); i++, decided = 0) {
            study_pair_plan plan = plan_of((study_pair_family)family, &k);
            fmb_frame p[LANES], q[LANES];
            double number[9];
            draw(&plan, &k, 0, pair, p, q);
            put_by_corners(&q[1], number);
            for (int lane = 0; lane < 4; lane++)
                decided += check_exact(&t, &k, &p[lane], &q[lane],
                                       study_pair_family_text((study_pair_family)family));
            if (family == STUDY_PAIR_ARTICLE)
                cr_expect_eq(decided, 8, "%dD %d: %d", k.dim, k.moves, decided);
        }
    truth_free(&t);
}

/* Two cubes, side by side in a common face, edge or corner: whether they touch, as their numbers
 * are rounded, the truth says; all are decided. */
Test(pair_flat, vertices_of_neighbours)
{
    static const double unit[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const double turned[9] = {0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1};
    const kind k = {3, false, {3, 3}, {0, 0}};
    truth t = truth_new();
    for (int i = 0; i < 2 * 7; i++) {
        const double *axes = i % 2 ? turned : unit;
        double origin[2][3] = {{0.1, 0.2, 0.3}};
        for (int j = 0; j < 3; j++) {
            origin[1][j] = origin[0][j];
            for (int a = 0; a < 3; a++)
                origin[1][j] += ((i / 2 + 1) >> a & 1) * axes[3 * a + j];
        }
        const fmb_frame p = {FMB_CUBOID, 3, 3, origin[0], axes, NULL};
        const fmb_frame q = {FMB_CUBOID, 3, 3, origin[1], axes, NULL};
        cr_expect_eq(check_exact(&t, &k, &p, &q, "neighbours"), 2, "%d", i);
    }
    truth_free(&t);
}

/* ---- tests ----------------------------------------------------------------------------------- */

Test(pair_flat, pairs_of_the_article_are_known_and_right)
{
    check_family(STUDY_PAIR_ARTICLE, 32, true);
}

Test(pair_flat, never_wrong_on_hard_families)
{
    for (int family = STUDY_PAIR_LATTICE; family < STUDY_PAIR_FAMILIES; family++)
        check_family((study_pair_family)family, 8, false);
}

/* A coordinate that is too large, or infinite after a difference, leaves its lane unknown. */
Test(pair_flat, large_numbers_are_unknown)
{
    static study_pair pair[LANES];
    const fmb_pair_kernels *w[WIDTHS];
    const kind k = {3, true, {2, 2}, {1, 1}};
    const study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, &k);
    for (int i = 0, n = widths(w); i < n; i++)
        for (int number = 0; number < 3 * 4; number++) {
            fmb_frame p[LANES], q[LANES];
            draw(&plan, &k, 0, pair, p, q);
            fmb_pair_bits before = ask(w[i], &k, p, q);
            pair[3].number[0][number < 9 ? number : number + 3] = number % 2 ? 1e308 : -1e31;
            fmb_pair_bits now = ask(w[i], &k, p, q);
            cr_expect_eq(now.apart, before.apart & ~8U, "%d %d", w[i]->width, number);
            cr_expect_eq(now.meet, before.meet & ~8U, "%d %d", w[i]->width, number);
        }
}
