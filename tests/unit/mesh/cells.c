/* cells.c: how two cells meet, against exact systems: triangles and tetrahedra on a coarse grid,
 * where touching, common corners, common planes and flat cells abound. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/mesh.h>
#include <fmb/pair.h>
#include <fmb/solve.h>

#include "property/random/rows.h"
#include "support/support.h"

typedef struct cell {
    int corners;
    double p[4][3];
} cell;

static bool same_point(const double *p, const double *q)
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

static bool has(const cell *c, const double *p)
{
    bool found = false;
    for (int i = 0; i < c->corners; i++)
        found |= same_point(c->p[i], p);
    return found;
}

/* Corner 2 comes on the line of corners 0 and 1. */
static void flatten(support_rng *g, cell *c)
{
    int times = support_between(g, -1, 2);
    for (int j = 0; j < 3; j++)
        c->p[2][j] = c->p[0][j] + times * (c->p[1][j] - c->p[0][j]);
}

/* The corners that the other one has come first. */
static int shared_first(cell *c, const cell *other)
{
    int n = 0;
    for (int i = 0; i < c->corners; i++)
        if (has(other, c->p[i])) {
            double t[3];
            memcpy(t, c->p[i], sizeof t);
            memcpy(c->p[i], c->p[n], sizeof t);
            memcpy(c->p[n++], t, sizeof t);
        }
    return n;
}

static fmb_frame frame_of(const cell *c)
{
    return (fmb_frame){.shape = FMB_SIMPLEX_BY_CORNERS,
                       .dim = 3,
                       .naxes = c->corners - 1,
                       .origin = c->p[0],
                       .axes = c->p[1]};
}

static bool ask(const cell *a, const cell *b, fmb_contact contact, int beyond)
{
    fmb_frame f[2] = {frame_of(a), frame_of(b)};
    fmb_options o = {.size = sizeof o};
    fmb_system *s = NULL;
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    int64_t row[8] = {0};
    o.evidence = FMB_EVIDENCE_NONE;
    for (int i = beyond - 1; i >= 0 && i < f[0].naxes; i++)
        row[i] = -1;
    must(fmb_system_from_frames(f, 2, FMB_COORDINATES_EACH, contact, NULL, &s));
    if (beyond > 0)
        must(fmb_system_add_int(s, row, FMB_LT, 0));
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &r));
    fmb_solver_free(v);
    fmb_system_free(s);
    return r.verdict == FMB_FEASIBLE;
}

static double triple(const double *o, const double *p, const double *q, const double *r)
{
    double u[3], v[3], w[3];
    for (int j = 0; j < 3; j++) {
        u[j] = p[j] - o[j];
        v[j] = q[j] - o[j];
        w[j] = r[j] - o[j];
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/* On the grid, where doubles are exact. */
static bool is_flat(const cell *c)
{
    if (c->corners == 4)
        return triple(c->p[0], c->p[1], c->p[2], c->p[3]) == 0;
    bool flat = true;
    for (int k = 0; k < 3; k++) {
        double s[3] = {c->p[0][0], c->p[0][1], c->p[0][2]};
        s[k] += 1;
        flat &= triple(c->p[0], c->p[1], c->p[2], s) == 0;
    }
    return flat;
}

static fmb_mesh_how truth(cell a, cell b)
{
    /* Not the same where a corner comes twice. */
    int shared[2] = {shared_first(&a, &b), shared_first(&b, &a)};
    bool flat = is_flat(&a) || is_flat(&b), swap = !is_flat(&b);
    if (!ask(&a, &b, FMB_CONTACT_CLOSED, 0))
        return FMB_MESH_APART;
    if (ask(&a, &b, FMB_CONTACT_OPEN, 0)) {
        bool plane = a.corners == 3 && b.corners == 3 && !flat;
        for (int i = 0; plane && i < 3; i++)
            plane = triple(a.p[0], a.p[1], a.p[2], b.p[i]) == 0;
        return plane ? FMB_MESH_COPLANAR : FMB_MESH_CROSS;
    }
    return shared[swap] > 0 &&
                   !ask(swap ? &b : &a, swap ? &a : &b, FMB_CONTACT_CLOSED, shared[swap])
               ? FMB_MESH_SHARE
               : FMB_MESH_TOUCH;
}

static fmb_mesh *mesh_of(const cell *c)
{
    static const uint32_t corner[4] = {0, 1, 2, 3};
    fmb_mesh *m = NULL;
    must(fmb_mesh_new(c->corners, (size_t)c->corners, c->p[0], 1, corner, NULL, &m));
    return m;
}

static fmb_mesh_how answer(const cell *a, const cell *b, int *shared)
{
    fmb_mesh *m = mesh_of(a), *n = mesh_of(b);
    fmb_mesh_answer out = {.size = sizeof out};
    must(fmb_mesh_meet(
        m, n, &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .neighbours = true}, &out));
    fmb_mesh_how how = out.hits ? out.hit[0].how : FMB_MESH_APART;
    *shared = out.hits ? out.hit[0].shared : 0;
    cr_assert(out.hits <= 1);
    fmb_mesh_answer_clear(&out);
    fmb_mesh_free(m);
    fmb_mesh_free(n);
    return how;
}

static void draw_cell(support_rng *g, int corners, int most, cell *c)
{
    c->corners = corners;
    for (int i = 0; i < 12; i++)
        c->p[i / 3][i % 3] = support_between(g, 0, most);
}

static void compare(int corners_a, int corners_b, uint64_t seed, int rounds, int *count)
{
    support_rng g = {seed};
    for (int round = 0; round < rounds; round++) {
        cell a, b;
        int most = support_between(&g, 1, 4);
        draw_cell(&g, corners_a, most, &a);
        draw_cell(&g, corners_b, most, &b);
        if (corners_a == 3 && support_chance(&g, 20))
            flatten(&g, &a);
        if (corners_b == 3 && support_chance(&g, 10))
            flatten(&g, &b);
        for (int k = 0; k < 2; k++)
            if (support_chance(&g, 40))
                memcpy(b.p[k], a.p[support_between(&g, 0, corners_a - 1)], sizeof b.p[k]);
        int shared;
        fmb_mesh_how want = truth(a, b), got = answer(&a, &b, &shared);
        cr_expect(got == want, "%d %d, round %d: %s, not %s (%d shared)", corners_a, corners_b,
                  round, fmb_mesh_how_text(got), fmb_mesh_how_text(want), shared);
        count[want]++;
        /* The same twice as large and turned in space, so that differences round. */
        if (round % 4 == 0 && !is_flat(&a) && !is_flat(&b)) {
            for (int i = 0; i < 12; i++) {
                a.p[i / 3][i % 3] *= 3;
                b.p[i / 3][i % 3] *= 3;
            }
            cr_expect(answer(&b, &a, &shared) == want);
        }
    }
}

Test(cells, triangles)
{
    int count[5] = {0};
    compare(3, 3, 1, 5000, count);
    for (int how = 0; how < 5; how++)
        cr_expect(count[how] > 60, "%s: %d", fmb_mesh_how_text((fmb_mesh_how)how), count[how]);
}

Test(cells, tetrahedra)
{
    int count[5] = {0};
    compare(4, 4, 2, 1500, count);
    for (int how = 0; how < 4; how++)
        cr_expect(count[how] > 60, "%s: %d", fmb_mesh_how_text((fmb_mesh_how)how), count[how]);
}

Test(cells, both)
{
    int count[5] = {0};
    compare(3, 4, 3, 600, count);
    compare(4, 3, 4, 600, count);
}
