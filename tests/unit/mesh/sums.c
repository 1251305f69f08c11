/* sums.c: meshes whose meeting pairs can be counted by hand. */
#include <criterion/criterion.h>

#include <fmb/mesh.h>

#include "property/random/rows.h"

enum { MOST_VERTICES = 1000, MOST_CELLS = 3000 };

/* A mesh on its way. */
typedef struct draft {
    int corners;
    size_t vertices, cells;
    double point[MOST_VERTICES][3];
    uint32_t corner[4 * MOST_CELLS];
} draft;

static uint32_t put_vertex(draft *d, double x, double y, double z)
{
    double *to = d->point[d->vertices];
    to[0] = x;
    to[1] = y;
    to[2] = z;
    return (uint32_t)d->vertices++;
}

static void put_cell(draft *d, const uint32_t *corner)
{
    for (int k = 0; k < d->corners; k++)
        d->corner[(size_t)d->corners * d->cells + (size_t)k] = corner[k];
    d->cells++;
}

static fmb_mesh *mesh_of(const draft *d)
{
    fmb_mesh *m = NULL;
    must(fmb_mesh_new(d->corners, d->vertices, d->point[0], d->cells, d->corner, NULL, &m));
    return m;
}

/* Pairs of that kind. */
static size_t count(const fmb_mesh_answer *a, fmb_mesh_how how)
{
    size_t n = 0;
    for (size_t i = 0; i < a->hits; i++)
        n += a->hit[i].how == how;
    return n;
}

/* n by n unit squares in z = 0, each cut along its diagonal from the least corner. */
static void draw_floor(draft *d, int n)
{
    uint32_t place[32][32];
    *d = (draft){.corners = 3};
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++)
            place[i][j] = put_vertex(d, i, j, 0);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            put_cell(d, (uint32_t[]){place[i][j], place[i + 1][j], place[i + 1][j + 1]});
            put_cell(d, (uint32_t[]){place[i][j], place[i][j + 1], place[i + 1][j + 1]});
        }
}

/* The rectangle 0 <= y <= n, -1 <= z <= 1 in x = 1/2, cut along a diagonal. */
static void draw_wall(draft *d, int n)
{
    *d = (draft){.corners = 3};
    uint32_t a = put_vertex(d, 0.5, 0, -1), b = put_vertex(d, 0.5, n, -1);
    uint32_t c = put_vertex(d, 0.5, n, 1), e = put_vertex(d, 0.5, 0, 1);
    put_cell(d, (uint32_t[]){a, b, c});
    put_cell(d, (uint32_t[]){a, e, c});
}

/* Floor and wall share the segment 0 <= y <= n of x = 1/2, z = 0. Each half unit of it belongs to
 * one triangle of the floor, that is 2 n pieces; each half of it to one triangle of the wall. So
 * there are n pieces in each half, which cross, and the one behind the middle touches the other
 * half. */
Test(sums, a_wall_on_a_floor)
{
    static draft d[2];
    for (int n = 2; n <= 20; n += 2) {
        draw_floor(&d[0], n);
        draw_wall(&d[1], n);
        fmb_mesh *floor = mesh_of(&d[0]), *wall = mesh_of(&d[1]);
        fmb_mesh_answer a = {.size = sizeof a};
        must(fmb_mesh_meet(floor, wall, NULL, &a));
        cr_expect_eq(a.hits, 2 * (size_t)n + 2);
        cr_expect_eq(count(&a, FMB_MESH_CROSS), 2 * (size_t)n);
        cr_expect_eq(count(&a, FMB_MESH_TOUCH), 2);
        fmb_mesh_answer_clear(&a);
        fmb_mesh_free(floor);
        fmb_mesh_free(wall);
    }
}

/* 4 by 4 by 4 unit cubes in six tetrahedra each: one for each order in which the coordinates go
 * from 0 to 1 (Freudenthal 1942, Kuhn 1960). */
static void draw_cubes(draft *d)
{
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    *d = (draft){.corners = 4};
    for (int v = 0; v < 125; v++)
        put_vertex(d, v / 25, v / 5 % 5, v % 5);
    for (int cube = 0; cube < 64; cube++)
        for (int k = 0; k < 6; k++) {
            int at[3] = {cube / 16, cube / 4 % 4, cube % 4};
            uint32_t corner[4];
            for (int step = 0; step < 4; step++) {
                corner[step] = (uint32_t)(25 * at[0] + 5 * at[1] + at[2]);
                if (step < 3)
                    at[order[k][step]]++;
            }
            put_cell(d, corner);
        }
}

/* A small tetrahedron around a point. */
static void draw_around(draft *d, double x, double y, double z)
{
    const double r = 1.0 / 64;
    *d = (draft){.corners = 4};
    put_vertex(d, x + r, y + r, z + r);
    put_vertex(d, x + r, y - r, z - r);
    put_vertex(d, x - r, y + r, z - r);
    put_vertex(d, x - r, y - r, z + r);
    put_cell(d, (uint32_t[]){0, 1, 2, 3});
}

/* It meets the tetrahedra that its middle belongs to. Of these there are 24 around an inner vertex
 * (of the eight cubes two have it at the ends of their main diagonal, 6 each, and six at another
 * corner, 2 each), 6 around a main diagonal, 4 around a diagonal of a face, 6 around an edge of a
 * cube (2 + 1 + 2 + 1), 2 at a triangle, 1 inside of one. */
Test(sums, stars_of_cubes)
{
    static const struct {
        double at[3];
        size_t hits;
    } star[] = {{{2, 2, 2}, 24},  {{1.5, 1.5, 1.5}, 6}, {{1.5, 1.5, 2}, 4},
                {{1.5, 2, 2}, 6}, {{1.75, 1.5, 1}, 2},  {{1.75, 1.5, 1.25}, 1},
                {{0, 0, 0}, 6},   {{4, 4, 0}, 2},       {{0.5, 0.5, 0}, 2}};
    static draft d;
    draw_cubes(&d);
    fmb_mesh *cubes = mesh_of(&d);
    for (size_t i = 0; i < sizeof star / sizeof *star; i++) {
        fmb_mesh_answer a = {.size = sizeof a};
        draw_around(&d, star[i].at[0], star[i].at[1], star[i].at[2]);
        fmb_mesh *small = mesh_of(&d);
        must(fmb_mesh_meet(cubes, small, NULL, &a));
        cr_expect(a.hits == star[i].hits && count(&a, FMB_MESH_CROSS) == a.hits, "%zu: %zu", i,
                  a.hits);
        fmb_mesh_answer_clear(&a);
        fmb_mesh_free(small);
    }
    fmb_mesh_free(cubes);
}
