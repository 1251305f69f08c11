/* corners.c: frames by corners are those by edges that are exact differences of the corners. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/pair.h>

#include "meet.h"
#include "property/random/rows.h"
#include "support/support.h"

enum { MOST = 4 };

/* A frame by corners and its numbers. */
typedef struct body {
    double origin[MOST], axes[MOST * MOST], speed[MOST];
    fmb_frame frame;
} body;

static double coordinate(support_rng *g, bool coarse)
{
    double x = (double)support_between(g, -4, 4);
    return coarse ? x
                  : ldexp(x + (double)support_between(g, 1, 999) / 997, -support_between(g, 0, 2));
}

static void draw(support_rng *g, body *b, int dim, bool coarse)
{
    for (int j = 0; j < MOST; j++) {
        b->origin[j] = coordinate(g, coarse);
        b->speed[j] = coordinate(g, coarse);
    }
    for (int j = 0; j < MOST * MOST; j++)
        b->axes[j] = coordinate(g, coarse);
    b->frame = (fmb_frame){.shape = support_between(g, 0, 1) ? FMB_CUBOID_BY_CORNERS
                                                             : FMB_SIMPLEX_BY_CORNERS,
                           .dim = dim,
                           .naxes = support_between(g, 0, dim),
                           .origin = b->origin,
                           .axes = b->axes,
                           .speed = support_between(g, 0, 3) == 0 ? b->speed : NULL};
}

/* The same by edges. */
static fmb_frame_q by_edges(const fmb_frame *f)
{
    fmb_frame_q q = rational_of(f);
    for (int i = 0; i < f->naxes * f->dim; i++)
        mpq_sub(q.axes[i], q.axes[i], q.origin[i % f->dim]);
    q.shape = f->shape == FMB_CUBOID_BY_CORNERS ? FMB_CUBOID : FMB_SIMPLEX;
    return q;
}

static fmb_verdict truth(const fmb_frame *f, fmb_contact contact)
{
    fmb_frame_q q[2] = {by_edges(&f[0]), by_edges(&f[1])};
    fmb_system *s = NULL;
    must(fmb_system_from_frames_q(q, 2, FMB_COORDINATES_EACH, contact, NULL, &s));
    fmb_verdict v = is_feasible(s) ? FMB_FEASIBLE : FMB_INFEASIBLE;
    fmb_system_free(s);
    rational_free(&q[0]);
    rational_free(&q[1]);
    return v;
}

Test(corners, systems_and_pairs)
{
    support_rng g = {12};
    int count[3] = {0};
    for (int round = 0; round < 400; round++) {
        body b[2];
        int dim = support_between(&g, 1, MOST);
        fmb_contact contact = (fmb_contact)(round & 1);
        draw(&g, &b[0], dim, (round & 2) != 0);
        draw(&g, &b[1], dim, (round & 2) != 0);
        if (round & 4) /* they share a corner */
            memcpy(b[1].origin, b[0].origin, sizeof b[1].origin);
        fmb_frame f[2] = {b[0].frame, b[1].frame};
        fmb_verdict want = truth(f, contact), got;
        cr_expect((contact ? meet_open : meet)(f, 2, FMB_COORDINATES_ALL) ==
                  (want == FMB_FEASIBLE));
        for (int method = 0; method < 2; method++) {
            fmb_pair_options o = {.size = sizeof o};
            fmb_pair *k = NULL;
            double world[2 * MOST];
            o.contact = contact;
            o.method = (fmb_pair_method)method;
            must(fmb_pair_new(dim, &o, NULL, &k));
            must(fmb_pair_test(k, 1, &f[0], &f[1],
                               &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                                   .verdict = &got,
                                                   .world = world}));
            cr_expect(got == want, "round %d, method %d", round, method);
            for (int j = 0; got == FMB_FEASIBLE && j < dim; j++)
                cr_expect(world[2 * j] <= world[2 * j + 1]);
            fmb_pair_free(k);
        }
        count[want]++;
    }
    cr_expect(count[FMB_FEASIBLE] > 40 && count[FMB_INFEASIBLE] > 40);
}

/* Triangles of a scan around one vertex, which any corner may be. */
Test(corners, neighbours_meet)
{
    support_rng g = {13};
    fmb_pair *k = NULL;
    int rounded_apart = 0;
    must(fmb_pair_new(3, NULL, NULL, &k));
    for (int round = 0; round < 300; round++) {
        double p[2][3][3], edges[2][2][3], shared[3];
        fmb_frame corners[2], rounded[2];
        fmb_verdict v;
        for (int j = 0; j < 3; j++)
            shared[j] = coordinate(&g, false);
        for (int i = 0; i < 2; i++) {
            for (int j = 0; j < 9; j++)
                p[i][j / 3][j % 3] = shared[j % 3] + 0.3 * coordinate(&g, false);
            memcpy(p[i][(i == 0 ? round : round / 3) % 3], shared, sizeof shared);
            for (int j = 0; j < 6; j++)
                edges[i][j / 3][j % 3] = p[i][1 + j / 3][j % 3] - p[i][0][j % 3];
            corners[i] = (fmb_frame){.shape = FMB_SIMPLEX_BY_CORNERS,
                                     .dim = 3,
                                     .naxes = 2,
                                     .origin = p[i][0],
                                     .axes = p[i][1]};
            rounded[i] = corners[i];
            rounded[i].shape = FMB_SIMPLEX;
            rounded[i].axes = edges[i][0];
        }
        must(fmb_pair_test(k, 1, &corners[0], &corners[1],
                           &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &v}));
        cr_expect(v == FMB_FEASIBLE, "round %d", round);
        must(fmb_pair_test(k, 1, &rounded[0], &rounded[1],
                           &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &v}));
        rounded_apart += v == FMB_INFEASIBLE;
    }
    cr_expect(rounded_apart > 0);
    fmb_pair_free(k);
}

/* A simplex by corners may have any number of them: closed and open, it is their hull. */
enum { CORNERS = 7 };

static fmb_verdict truth_of_hulls(int dim, const int *corners, double p[2][CORNERS][3], bool open)
{
    int n = corners[0] + corners[1];
    fmb_system *s = NULL;
    must(fmb_system_new(n, NULL, &s));
    for (int j = 0; j <= dim + 1; j++) {
        double row[2 * CORNERS] = {0};
        for (int i = 0; i < n; i++) {
            int which = i >= corners[0];
            double x = p[which][which ? i - corners[0] : i][j < dim ? j : 0];
            row[i] = j < dim ? (which ? -x : x) : which == j - dim;
        }
        must(fmb_system_add(s, row, FMB_EQ, j < dim ? 0 : 1));
    }
    for (int i = 0; i < n; i++) {
        double row[2 * CORNERS] = {0};
        row[i] = -1;
        must(fmb_system_add(s, row, open ? FMB_LT : FMB_LE, 0));
    }
    fmb_verdict v = is_feasible(s) ? FMB_FEASIBLE : FMB_INFEASIBLE;
    fmb_system_free(s);
    return v;
}

Test(corners, hulls)
{
    support_rng g = {14};
    int count[3] = {0};
    for (int round = 0; round < 200; round++) {
        double p[2][CORNERS][3], number[2][CORNERS * 3], world[6];
        int corners[2], dim = support_between(&g, 1, 3);
        fmb_frame f[2];
        for (int k = 0; k < 2; k++) {
            corners[k] = support_between(&g, 1, CORNERS);
            for (int i = 0; i < corners[k] * dim; i++)
                number[k][i] = p[k][i / dim][i % dim] = support_between(&g, -3, 3) + 3 * k;
            f[k] = (fmb_frame){.shape = FMB_SIMPLEX_BY_CORNERS,
                               .dim = dim,
                               .naxes = corners[k] - 1,
                               .origin = number[k],
                               .axes = number[k] + dim};
        }
        fmb_pair_options o = {.size = sizeof o};
        fmb_pair *k = NULL;
        fmb_verdict got, want = truth_of_hulls(dim, corners, p, round & 1);
        o.contact = round & 1 ? FMB_CONTACT_OPEN : FMB_CONTACT_CLOSED;
        must(fmb_pair_new(dim, &o, NULL, &k));
        must(fmb_pair_test(k, 1, &f[0], &f[1],
                           &(fmb_pair_answers){
                               .size = sizeof(fmb_pair_answers), .verdict = &got, .world = world}));
        cr_expect(got == want, "round %d", round);
        for (int j = 0; got == FMB_FEASIBLE && j < dim; j++)
            cr_expect(world[2 * j] <= world[2 * j + 1]);
        fmb_pair_free(k);
        count[want]++;
    }
    cr_expect(count[FMB_FEASIBLE] > 20 && count[FMB_INFEASIBLE] > 20);
}
