/* polytope.c: see polytope.h. Polytopes known by their points are given by the rows of their polar,
 * whose vertices are the input of the hull question. */
#include <stdlib.h>
#include <string.h>

#include "polytope.h"
#include "study/program/random.h"

/* A system under construction. */
typedef struct pen {
    const polytope_plan *plan;
    fmb_system *s;
    study_random random;
    int64_t *a; /* [dim] the current row */
} pen;

static void begin(pen *w, int dim)
{
    w->s = system_of_dim(dim);
    w->a = need(calloc((size_t)dim + 1, sizeof *w->a));
}

/* Append the current row and clear it. */
static void put(pen *w, fmb_rel rel, int64_t right)
{
    if (fmb_system_add_int(w->s, w->a, rel, right) != FMB_OK)
        need(NULL);
    memset(w->a, 0, (size_t)fmb_system_dim(w->s) * sizeof *w->a);
}

static int64_t between(pen *w, int64_t least, int64_t most)
{
    return least + (int64_t)(study_random_next(&w->random) % (uint64_t)(most - least + 1));
}

/* ---- known ----------------------------------------------------------------------------------- */

static void draw_cube(pen *w)
{
    int n = w->plan->size;
    begin(w, n);
    for (int j = 0; j < 2 * n; j++) {
        w->a[j / 2] = j % 2 ? 1 : -1;
        put(w, FMB_LE, 1);
    }
}

static void draw_cross(pen *w)
{
    int n = w->plan->size;
    begin(w, n);
    for (unsigned signs = 0; signs < 1u << n; signs++) {
        for (int j = 0; j < n; j++)
            w->a[j] = signs >> j & 1 ? 1 : -1;
        put(w, FMB_LE, 1);
    }
}

/* Points p[m][n] as rows of their polar about the centre: (m p - sum).x <= m. */
static void put_polar(pen *w, const int64_t *p, int m, int n)
{
    for (int i = 0; i < m; i++) {
        for (int j = 0; j < n; j++) {
            int64_t sum = 0;
            for (int k = 0; k < m; k++)
                sum += p[k * n + j];
            w->a[j] = m * p[i * n + j] - sum;
        }
        put(w, FMB_LE, m);
    }
}

/* Points (t, t^2, ..., t^n) of the moment curve. */
static void draw_cyclic(pen *w)
{
    int n = w->plan->size, m = w->plan->rows;
    int64_t *p = need(calloc((size_t)m * (size_t)n + 1, sizeof *p));
    begin(w, n);
    for (int i = 0; i < m; i++)
        for (int j = 0; j < n; j++)
            p[i * n + j] = (j ? p[i * n + j - 1] : 1) * (i - m / 2);
    put_polar(w, p, m, n);
    free(p);
}

/* Each set of variables sums to 1 + 2 + ... + its size at least. */
static void draw_permutahedron(pen *w)
{
    int n = w->plan->size;
    begin(w, n);
    for (unsigned set = 1; set < 1u << n; set++) {
        int size = __builtin_popcount(set);
        for (int j = 0; j < n; j++)
            w->a[j] = set >> j & 1 ? -1 : 0;
        put(w, size == n ? FMB_EQ : FMB_LE, -size * (size + 1) / 2);
    }
}

static int pair_index(int n, int i, int j)
{
    int a = i < j ? i : j, b = i < j ? j : i;
    return a * (2 * n - a - 1) / 2 + b - a - 1;
}

/* d_ij <= d_ik + d_jk */
static void draw_metric(pen *w)
{
    int n = w->plan->size;
    begin(w, n * (n - 1) / 2);
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++)
            for (int k = 0; k < n; k++) {
                if (k == i || k == j)
                    continue;
                w->a[pair_index(n, i, j)] = 1;
                w->a[pair_index(n, i, k)] = w->a[pair_index(n, j, k)] = -1;
                put(w, FMB_LE, 0);
            }
}

/* Which pairs does a set of points separate? */
static void draw_cut(pen *w)
{
    int n = w->plan->size, pairs = n * (n - 1) / 2, m = 1 << (n - 1);
    int64_t *p = need(calloc((size_t)m * (size_t)pairs + 1, sizeof *p));
    begin(w, pairs);
    for (int set = 0; set < m; set++)
        for (int i = 0; i < n; i++)
            for (int j = i + 1; j < n; j++)
                p[set * pairs + pair_index(n, i, j)] = (set >> i & 1) != (set >> j & 1);
    put_polar(w, p, m, pairs);
    free(p);
}

/* Doubly stochastic matrices. */
static void draw_assignment(pen *w)
{
    int n = w->plan->size;
    begin(w, n * n);
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++)
                w->a[side ? j * n + i : i * n + j] = 1;
            put(w, FMB_EQ, 1);
        }
    for (int j = 0; j < n * n; j++) {
        w->a[j] = -1;
        put(w, FMB_LE, 0);
    }
}

/* ---- random ---------------------------------------------------------------------------------- */

/* Rows that touch a sphere, nearly. */
static void draw_sphere(pen *w)
{
    int n = w->plan->size;
    begin(w, n);
    for (int i = 0; i < w->plan->rows; i++) {
        int64_t square = 0, length = 1;
        for (int j = 0; j < n; j++) {
            int64_t sum = 0;
            for (int k = 0; k < 6; k++)
                sum += between(w, -500, 500);
            w->a[j] = sum;
            square += sum * sum;
        }
        while ((length + 1) * (length + 1) <= square)
            length++;
        put(w, FMB_LE, length);
    }
}

/* Small numbers, so that many rows meet in a point; perhaps unbounded. */
static void draw_small(pen *w)
{
    int n = w->plan->size;
    begin(w, n);
    for (int i = 0; i < w->plan->rows; i++) {
        for (int j = 0; j < n; j++)
            w->a[j] = between(w, -1, 1);
        put(w, FMB_LE, between(w, 1, 2));
    }
}

/* Points with small coordinates, many of them on a facet. */
static void draw_lattice(pen *w)
{
    int n = w->plan->size, m = w->plan->rows;
    int64_t *p = need(calloc((size_t)m * (size_t)n + 1, sizeof *p));
    begin(w, n);
    for (int i = 0; i < m * n; i++)
        p[i] = between(w, -3, 3);
    put_polar(w, p, m, n);
    free(p);
}

/* All sums of vectors or their opposites: as many of them as there are rows, and 16 at most. */
static void draw_zonotope(pen *w)
{
    int n = w->plan->size, vectors = w->plan->rows < 16 ? w->plan->rows : 16;
    int64_t *v = need(calloc((size_t)vectors * (size_t)n + 1, sizeof *v));
    begin(w, n);
    for (int k = 0; k < vectors * n; k++)
        v[k] = between(w, -4, 4);
    for (unsigned signs = 0; signs < 1u << vectors; signs++) {
        for (int k = 0; k < vectors * n; k++)
            w->a[k % n] += signs >> (k / n) & 1 ? v[k] : -v[k];
        put(w, FMB_LE, 1);
    }
    free(v);
}

/* Polygons, one for each pair of variables, of that many sides together. */
static void draw_product(pen *w)
{
    int polygons = w->plan->size / 2;
    begin(w, 2 * polygons);
    for (int i = 0; i < w->plan->rows && polygons > 0; i++) {
        int j = 2 * (i % polygons);
        w->a[j] = between(w, -9, 9);
        w->a[j + 1] = between(w, -9, 9);
        put(w, FMB_LE, 10);
    }
}

/* Rows through an orthant: unbounded. */
static void draw_blocking(pen *w)
{
    int n = w->plan->size;
    begin(w, n);
    for (int j = 0; j < n; j++) {
        w->a[j] = -1;
        put(w, FMB_LE, 0);
    }
    for (int i = n; i < w->plan->rows; i++) {
        for (int j = 0; j < n; j++)
            w->a[j] = -between(w, 0, 20);
        put(w, FMB_LE, -between(w, 10, 60));
    }
}

/* A polytope on the sum of all variables, written as an equality, between 0 and bounds. */
static void draw_slice(pen *w)
{
    int n = w->plan->size;
    begin(w, n);
    for (int j = 0; j < n; j++)
        w->a[j] = 1;
    put(w, FMB_EQ, 3 * n);
    for (int j = 0; j < 2 * n; j++) {
        w->a[j / 2] = j % 2 ? 1 : -1;
        put(w, FMB_LE, j % 2 ? between(w, 4, 9) : 0);
    }
}

/* ---- the door -------------------------------------------------------------------------------- */

static const struct family {
    const char *name;
    void (*draw)(pen *w);
} families[] = {
    {"cube", draw_cube},         {"cross", draw_cross},
    {"cyclic", draw_cyclic},     {"permutahedron", draw_permutahedron},
    {"metric", draw_metric},     {"cut", draw_cut},
    {"sphere", draw_sphere},     {"assignment", draw_assignment},
    {"small", draw_small},       {"blocking", draw_blocking},
    {"slice", draw_slice},       {"lattice", draw_lattice},
    {"zonotope", draw_zonotope}, {"product", draw_product},
};

bool polytope_parse(const char *text, polytope_plan *plan)
{
    char name[32];
    int words = sscanf(text, "%31[a-z]:%d:%d", name, &plan->size, &plan->rows);
    if (words < 2 || plan->size < 1 || plan->size > 100)
        return false;
    plan->rows = words == 3 ? plan->rows : 2 * plan->size;
    for (size_t i = 0; i < sizeof families / sizeof *families; i++)
        if (strcmp(name, families[i].name) == 0) {
            plan->family = (int)i;
            return plan->rows > 0;
        }
    return false;
}

void polytope_draw(const polytope_plan *plan, problem *p, const char *name)
{
    pen w = {.plan = plan, .random = {plan->seed}};
    families[plan->family].draw(&w);
    problem_of_system(p, name, w.s);
    snprintf(p->family, sizeof p->family, "%s", families[plan->family].name);
    free(w.a);
}
