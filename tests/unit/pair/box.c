/* box.c: boxes, times and witnesses of meeting pairs: the kernels of every width, and fmb_pair_test
 * as a whole, against exact boxes. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include "box_check.h"
#include "pair/block.h"
#include "pair/kernels/pair_kernels.h"
#include "rows.h"
#include "study/draw/pairs.h"
#include "support/pair_counts.h"

enum { LEVELS = FMB_BOX_LEVELS, WIDTHS = 4 };

/* One pair at a time, as on processors without vectors. */
extern const fmb_pair_kernels kernels_plain;

static const fmb_pair_kernels *kernels_of(int width)
{
    static const fmb_simd level[WIDTHS] = {FMB_SIMD_AUTO, FMB_SIMD_PLAIN, FMB_SIMD_AVX2,
                                           FMB_SIMD_AVX512};
#ifdef HAVE_PLAIN
    if (width == 0)
        return &kernels_plain;
#endif
    return width == 0 ? NULL : fmb_pair_kernels_choose(level[width]);
}

static void read_lane(const double *from, int width, int dim, box_answer *a)
{
    memset(a, 0, sizeof *a);
    for (int j = 0; j < dim; j++) {
        a->world[j][0] = from[j * width];
        a->world[j][1] = from[(dim + j) * width];
        a->inside[j][0] = from[(2 * dim + j) * width];
        a->inside[j][1] = from[(3 * dim + j) * width];
        a->witness[j] = from[(4 * dim + 2 + j) * width];
    }
    a->time[0] = from[4 * dim * width];
    a->time[1] = from[(4 * dim + 1) * width];
}

/* Does that kernel answer the pair, put into one lane among others? */
static bool ask(const fmb_pair_kernels *k, int level, int lane, const fmb_frame *other,
                const fmb_frame *p, const fmb_frame *q, box_answer *a)
{
    const bool moves = p->speed || q->speed;
    fmb_box_kernel *kernel = k->box[level][p->dim - 2][moves];
    double answer[FMB_BOX_MOST_ROWS * FMB_BLOCK_MOST_LANES];
    fmb_block b = {.lanes = 0};
    if (!kernel)
        return false;
    for (int i = 0; i < k->width; i++)
        fmb_block_put(&b, k->width, i == lane ? p : other, i == lane ? q : other, moves, true, 0);
    unsigned sure = kernel(moves, (int)p->shape, (int)q->shape, b.number, answer);
    read_lane(answer + lane, k->width, p->dim, a);
    return sure >> lane & 1;
}

/* All kernels on one pair; counts how many answered. */
static void ask_all(box_check *c, const fmb_frame *p, const fmb_frame *q, uint64_t number,
                    uint64_t answered[LEVELS])
{
    box_answer a[LEVELS * WIDTHS];
    size_t n = 0;
    for (int width = 0; width < WIDTHS; width++) {
        const fmb_pair_kernels *k = kernels_of(width);
        for (int level = 0; k && level < LEVELS; level++)
            if (ask(k, level, (int)(number % (unsigned)k->width), p, p, q, &a[n])) {
                answered[level]++;
                n++;
            }
    }
    cr_assert(box_check_pair(c, p, q, a, n, false), "pair %llu in %d dimensions: %s",
              (unsigned long long)number, p->dim, c->why);
}

static bool meet(fmb_pair *k, const study_pair *s)
{
    fmb_verdict v;
    must(fmb_pair_test(k, 1, &s->p, &s->q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &v}));
    return v == FMB_FEASIBLE;
}

/* The first `want` pairs of a plan that meet. */
static void kernels_against_exact(box_check *c, const study_pair_plan *plan, int want,
                                  uint64_t answered[LEVELS])
{
    static study_pair s;
    fmb_pair *k = NULL;
    must(fmb_pair_new(plan->dim, NULL, NULL, &k));
    for (uint64_t i = 0; want > 0 && i < 500; i++) {
        study_pair_draw(plan, 11, i, &s);
        if (!meet(k, &s))
            continue;
        ask_all(c, &s.p, &s.q, i, answered);
        want--;
    }
    fmb_pair_free(k);
}

static void all_kinds(study_pair_family family, int dim, int want, uint64_t answered[LEVELS])
{
    box_check c;
    box_check_open(&c);
    for (int kind = 0; kind < 8; kind++) {
        const study_pair_plan plan = {
            .family = family, .dim = dim, .moves = kind >> 2, .shape = {kind >> 1 & 1, kind & 1}};
        kernels_against_exact(&c, &plan, want, answered);
    }
    box_check_close(&c);
}

/* How many widths this build and processor have. */
static unsigned count_widths(void)
{
    unsigned n = 0;
    for (int width = 0; width < WIDTHS; width++)
        n += kernels_of(width) != NULL;
    return n;
}

Test(box, kernels_in_the_plane)
{
    for (int f = 0; f < STUDY_PAIR_FAMILIES; f++) {
        uint64_t answered[LEVELS] = {0};
        all_kinds((study_pair_family)f, 2, 4, answered);
        if (f == STUDY_PAIR_ARTICLE)
            cr_expect(answered[0] > 15 * count_widths() && answered[1] > 15 * count_widths());
    }
}

Test(box, kernels_in_space)
{
    for (int f = 0; f < STUDY_PAIR_FAMILIES; f++) {
        uint64_t answered[LEVELS] = {0};
        all_kinds((study_pair_family)f, 3, 2, answered);
        if (f == STUDY_PAIR_ARTICLE)
            cr_expect(answered[0] > 7 * count_widths() && answered[1] > 4 * count_widths());
    }
}

/* Aligned cubes, whose edges lie along each other's faces, are
 * answered by plain doubles. */
Test(box, aligned_cubes)
{
    const double zero[3] = {0}, place[3] = {0.5, 0.25, -0.75},
                 unit[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const fmb_frame p = {FMB_CUBOID, 3, 3, zero, unit, NULL},
                    q = {FMB_CUBOID, 3, 3, place, unit, NULL};
    box_check c;
    box_check_open(&c);
    for (int width = 0; width < WIDTHS; width++) {
        const fmb_pair_kernels *k = kernels_of(width);
        box_answer a;
        cr_assert(!k || ask(k, 0, 0, &p, &p, &q, &a));
        cr_assert(!k || box_check_pair(&c, &p, &q, &a, 1, false), "%s", c.why);
    }
    box_check_close(&c);
}

/* The kernels never answer about a lane whose numbers they cannot bear: a flat frame, huge ones. */
Test(box, lanes_that_kernels_leave_alone)
{
    const double zero[3] = {0}, unit[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double flat[9] = {1, 0, 0, 0, 1, 0, 1, 1, 0}, far[3] = {0x1p300, 0, 0};
    const fmb_frame p = {FMB_CUBOID, 3, 3, zero, unit, NULL};
    const fmb_frame q[2] = {{FMB_CUBOID, 3, 3, zero, flat, NULL},
                            {FMB_CUBOID, 3, 3, far, unit, NULL}};
    for (int width = 0; width < WIDTHS; width++) {
        const fmb_pair_kernels *k = kernels_of(width);
        box_answer a;
        for (int level = 0; k && level < LEVELS; level++)
            for (int i = 0; i < 2; i++) {
                cr_expect_not(ask(k, level, 0, &p, &p, &q[i], &a));
                cr_expect_not(ask(k, level, 0, &p, &q[i], &p, &a));
            }
    }
}

/* All of fmb_pair_test, many pairs a call, in any dimension. Returns how many were asked exactly.
 */
static uint64_t whole_plan(const study_pair_plan *plan, size_t n, bool tightest)
{
    int dim = plan->dim;
    study_pairs s;
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    box_check c;
    box_check_open(&c);
    o.tightest = tightest;
    must(fmb_pair_new(dim, &o, NULL, &k));
    must(study_pairs_make(plan, 3, n, NULL, NULL, &s));
    size_t d = (size_t)dim;
    fmb_verdict *v = calloc(n, sizeof *v);
    double *number = calloc(n * (5 * d + 2), sizeof *number);
    cr_assert(v && number);
    const fmb_pair_answers out = {.size = sizeof(fmb_pair_answers),
                                  .verdict = v,
                                  .world = number,
                                  .inside = number + 2 * d * n,
                                  .time = number + 4 * d * n,
                                  .witness = number + (4 * d + 2) * n};
    must(fmb_pair_test(k, n, s.p, s.q, &out));
    for (size_t i = 0; i < n; i++) {
        box_answer a = {0};
        if (v[i] != FMB_FEASIBLE)
            continue;
        memcpy(a.world, out.world + 2 * d * i, 2 * d * sizeof(double));
        memcpy(a.inside, out.inside + 2 * d * i, 2 * d * sizeof(double));
        memcpy(a.time, out.time + 2 * i, 2 * sizeof(double));
        memcpy(a.witness, out.witness + d * i, d * sizeof(double));
        cr_assert(box_check_pair(&c, &s.p[i], &s.q[i], &a, 1, tightest), "pair %zu: %s", i, c.why);
    }
    free(number);
    free(v);
    study_pairs_free(&s);
    uint64_t asked = counts_of_pairs(k).exact_boxes;
    fmb_pair_free(k);
    box_check_close(&c);
    return asked;
}

static uint64_t whole(study_pair_family family, int dim, bool moves, size_t n, bool tightest)
{
    return whole_plan(&(study_pair_plan){.family = family,
                                         .dim = dim,
                                         .moves = moves,
                                         .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}},
                      n, tightest);
}

Test(box, together_and_in_any_dimension)
{
    for (int dim = 1; dim <= 4; dim++)
        for (int moves = 0; moves < 2; moves++) {
            whole(STUDY_PAIR_ARTICLE, dim, moves, 40, false);
            whole(STUDY_PAIR_LATTICE, dim, moves, 10, false);
            whole(STUDY_PAIR_DENORMAL, dim, moves, 10, false);
        }
}

Test(box, tightest)
{
    for (int dim = 1; dim <= 3; dim++)
        for (int moves = 0; moves < 2; moves++)
            for (int f = 0; f < STUDY_PAIR_FAMILIES; f++)
                whole((study_pair_family)f, dim, moves, 8, true);
}

/* Edges and faces, too; nearly flat ones need care for a witness. */
Test(box, tightest_of_flat_frames)
{
    static const study_pair_family family[] = {STUDY_PAIR_LATTICE, STUDY_PAIR_FLAT};
    for (int dim = 2; dim <= 3; dim++)
        for (int axes = 1; axes < dim * dim; axes++)
            for (int i = 0; i < 4; i++)
                whole_plan(&(study_pair_plan){.family = family[i / 2],
                                              .dim = dim,
                                              .moves = i % 2,
                                              .shape = {STUDY_PAIR_ANY_SHAPE, FMB_SIMPLEX},
                                              .naxes = {1 + axes % dim, 1 + axes / dim}},
                           12, true);
}

/* ---- ends next to a double ------------------------------------------------------------------- */

/* s d - t b = 1, for coprime b, d (Euclid). */
static void bezout(int64_t b, int64_t d, int64_t *s, int64_t *t)
{
    int64_t r[2] = {d, b}, x[2] = {1, 0}, y[2] = {0, -1};
    while (r[1] != 0) {
        int64_t q = r[0] / r[1], *all[3] = {r, x, y};
        for (int i = 0; i < 3; i++) {
            int64_t next = all[i][0] - q * all[i][1];
            all[i][0] = all[i][1];
            all[i][1] = next;
        }
    }
    cr_assert_eq(r[0], 1);
    *s = x[0] < 0 ? x[0] + b : x[0];
    *t = x[0] < 0 ? y[0] + d : y[0];
}

/* Frame (2 a, 2 c), (2 b, 2 d), of determinant 4 D, and the point (a, c) + (b, d) + sign (s, t)
 * with s d - t b = 1: in its coordinates this is 1/2 + sign / (2 D) on the first axis, by Cramer's
 * rule. */
static void expect_ends_around_a_half(int64_t a, int64_t b, int64_t c, int64_t d, int sign)
{
    int64_t s, t;
    bezout(b, d, &s, &t);
    double point[2] = {(double)(a + b + sign * s), (double)(c + d + sign * t)};
    double corner[2] = {0, 0}, ends[2][2];
    double axes[4] = {2 * (double)a, 2 * (double)c, 2 * (double)b, 2 * (double)d};
    fmb_frame p = {FMB_CUBOID, 2, 0, point, axes, NULL};
    fmb_frame q = {FMB_CUBOID, 2, 2, corner, axes, NULL};
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    fmb_verdict verdict;
    o.tightest = true;
    cr_assert_eq(fmb_pair_new(2, &o, NULL, &k), FMB_OK);
    cr_assert_eq(fmb_pair_test(k, 1, &p, &q,
                               &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                                   .verdict = &verdict,
                                                   .inside = ends[0]}),
                 FMB_OK);
    cr_assert_eq(verdict, FMB_FEASIBLE);
    cr_expect_eq(ends[0][0], sign > 0 ? 0.5 : nextafter(0.5, 0), "%.17g", ends[0][0]);
    cr_expect_eq(ends[0][1], sign > 0 ? nextafter(0.5, 1) : 0.5, "%.17g", ends[0][1]);
    fmb_pair_free(k);
}

/* D has twice as many bits as the edges: from where a double-double tells to where it does not. */
Test(box, tightest_next_to_a_double)
{
    for (int bits = 28; bits <= 50; bits++) {
        int64_t one = INT64_C(1) << bits;
        for (int sign = -1; sign <= 1; sign += 2)
            expect_ends_around_a_half(one - 1, one / 2 + 1, one / 4 + 1, one + 1, sign);
    }
}

/* No pair of these is left to the exact way: degenerate ones are not, nor are those that touch. */
Test(box, tightest_without_asking_exactly)
{
    static const study_pair_family family[] = {STUDY_PAIR_ARTICLE, STUDY_PAIR_LATTICE,
                                               STUDY_PAIR_TOUCHING, STUDY_PAIR_DEGENERATE,
                                               STUDY_PAIR_INTEGER};
    for (int dim = 1; dim <= 3; dim++)
        for (int moves = 0; moves < 2; moves++)
            for (size_t f = 0; f < sizeof family / sizeof *family; f++)
                cr_expect(whole(family[f], dim, moves, 10, true) == 0, "%s, %d dimensions",
                          study_pair_family_text(family[f]), dim);
}

/* In eight dimensions nearly each of the 32 ends of these simplices is at a vertex of its own, and
 * doubles miss many of them: once those vertices were kept, too, beyond the room for them. */
Test(box, tightest_at_as_many_vertices_as_ends)
{
    static const double origin[2][8] = {
        {2015413.4773615811, 431827.19452503085, 982655.86455043801, -541064.95405616763,
         -1052374.6582306416, -191350.24395325032, -2417012.8051997116, -209164.66507237524},
        {417483.82830209518, 716323.79951587995, 600283.55954489554, 27888.671523161698,
         -187037.74719202355, -731301.93668286572, -819663.26825059974, 895892.95757364063}};
    static const double axes[2][64] = {
        {-1027240.099718878,  462500.77193745342,  -478870.83931556903, -1042165.1892710987,
         980149.75729505206,  280322.0600414807,   119867.00906797894,  -995016.54485881352,
         -405558.847727796,   -822700.73827397369, -855101.27484606695, 319774.57528823568,
         -385758.21605705866, 975255.78273909702,  1309615.1454206402,  867578.34405031567,
         -1315519.9424414269, 194575.2708189085,   -76341.623958387529, 231330.61850346642,
         815564.64224119589,  -575320.79212519107, 1475032.0345278576,  1497548.2068501539,
         121109.16423315299,  57680.959651716636,  -858792.61682730564, 393323.92644568195,
         -132921.25276128357, -259306.80164205795, 1297315.8074536789,  -283318.99388074223,
         -765773.8715955345,  160041.33171790047,  -669617.3918143746,  115286.25234770938,
         111940.89574839757,  203048.77320785751,  752620.980751378,    679557.46919097495,
         -1042800.0876658333, 449975.75273437722,  -906857.69934592792, 381544.36064379022,
         364319.84772134654,  1238026.5496918138,  432388.99888514105,  574534.12111770071,
         -1807213.4996073763, 934277.87629896426,  94460.923850760795,  -509497.43078866124,
         -815935.68586644344, 728418.52679912082,  752733.4318970443,   1325885.2764990865,
         1007992.2000618405,  -44679.412414467195, -1047967.8418402367, 671361.60054365452,
         -377783.40127096471, -721662.37649197341, 1842010.6341559801,  -1246195.4569524594},
        {-410662.30728004244, -178600.94407138927, -448864.80162115977, -272878.18704695045,
         25600.46321021812,   -63395.47065816517,  -941875.44696608,    518378.40946559468,
         988379.71538077143,  -249320.84377859478, 235662.07593398102,  -553536.57466934132,
         -514886.3714574863,  329542.08109031233,  -585267.55611819646, 74650.261175773805,
         549746.07084589242,  -34533.939101008029, -593275.76785598707, -116044.36615575704,
         -703623.74649279832, 778369.56533304858,  -722411.05377647956, -817990.73765917891,
         814162.30796269444,  801485.72412779555,  494832.20403972175,  432628.68499459303,
         -188553.54402711522, -841169.96046836791, -33988.42550622928,  38263.570555864368,
         886883.03582868748,  -102360.37206618383, -189175.22501293107, 278037.67409797257,
         -244862.14850968114, -462355.57484991546, 544694.82670230104,  -962876.46307171718,
         -427185.01095029153, -252663.36656569596, -717190.41727198241, 370479.91626074607,
         508880.0886634721,   925186.97982272203,  314030.71297797374,  968271.71968553937,
         145634.25738710118,  427755.75661791838,  -569197.03327346314, -444285.49599469546,
         -170221.94439093285, -564647.62457152631, 787662.36117195711,  -407709.68865726632,
         377441.00248381775,  432495.86092517874,  -816715.43302202015, -74642.625146994367,
         350478.01017128583,  477243.2717741488,   269023.45931959688,  6993.8094986816868}};
    fmb_frame p = {FMB_SIMPLEX, 8, 8, origin[0], axes[0], NULL};
    fmb_frame q = {FMB_SIMPLEX, 8, 8, origin[1], axes[1], NULL};
    fmb_pair_options o = {.size = sizeof o, .tightest = true};
    fmb_pair *k = NULL;
    fmb_verdict verdict;
    box_answer a = {0};
    box_check c;
    box_check_open(&c);
    must(fmb_pair_new(8, &o, NULL, &k));
    fmb_pair_answers out = box_answer_places(&a, &verdict);
    must(fmb_pair_test(k, 1, &p, &q, &out));
    cr_assert_eq(verdict, FMB_FEASIBLE);
    cr_expect(box_check_pair(&c, &p, &q, &a, 1, true), "%s", c.why);
    cr_expect_eq(counts_of_pairs(k).exact_boxes, 0);
    fmb_pair_free(k);
    box_check_close(&c);
}
