/* gauge.c: see gauge.h.
 *
 * Each point j allows w the half-space w.q_j <= 1; a basis is n points whose walls meet in the
 * vertex w, and the rows of its inverse, turned round, are the edges there. For a new q the dual
 * method walks from vertex to vertex, always up: along the edge that rises most for its length
 * (steepest edge: Goldfarb and Reid 1977, Forrest and Goldfarb 1992), until the next wall. A vertex
 * above 1 is answer enough, and so is one from where no edge rises. A point that is added may cut
 * the vertex off: the primal method then finds one that is left, the highest in a direction that
 * the old one was highest in.
 */
#include "lp/float/gauge.h"

#include <math.h>
#include <string.h>

/* Less is taken for the rounding error of 0: points are not longer than about 1, and w neither. */
#define ROUNDING 1e-9
/* Pivots are larger than this, where edges have length 1. */
#define LEAST_PIVOT 1e-8
/* Pivots after which errors have gathered. */
#define STALE 64

/* Room for hull points at first. */
#define FIRST_POINTS 64

/* ---- life ------------------------------------------------------------------------------------ */

static void start_from_cube(fmb_gauge *g, const double *q);
static fmb_status reserve_hull_points(fmb_gauge *g, size_t capacity);

fmb_status fmb_gauge_init(fmb_gauge *g, fmb_mem *mem, const fmb_kernels *kernels, size_t n,
                          double cube)
{
    *g = (fmb_gauge){.mem = mem, .kernels = kernels, .n = n, .cube = cube, .zero = ROUNDING};
    g->basic = fmb_mem_get(mem, n, sizeof *g->basic);
    g->inverse = fmb_mem_get(mem, n * n, sizeof *g->inverse);
    g->length = fmb_mem_get(mem, n, sizeof *g->length);
    g->value = fmb_mem_get(mem, n, sizeof *g->value);
    g->w = fmb_mem_get(mem, n, sizeof *g->w);
    g->entry = fmb_mem_get(mem, n, sizeof *g->entry);
    g->work = fmb_mem_get(mem, 2 * n * n, sizeof *g->work);
    if (!g->basic || !g->inverse || !g->length || !g->value || !g->w || !g->entry || !g->work)
        return fmb_mem_status(mem);
    fmb_status st = reserve_hull_points(g, FIRST_POINTS);
    if (st == FMB_OK)
        start_from_cube(g, NULL);
    return st;
}

static void free_hull_points(fmb_gauge *g)
{
    fmb_mem_put(g->mem, g->at, g->n * g->capacity, sizeof *g->at);
    fmb_mem_put(g->mem, g->name, g->capacity, sizeof *g->name);
    fmb_mem_put(g->mem, g->reduced, g->capacity, sizeof *g->reduced);
    fmb_mem_put(g->mem, g->along, g->capacity, sizeof *g->along);
}

void fmb_gauge_clear(fmb_gauge *g)
{
    size_t n = g->n;
    if (!g->mem)
        return;
    free_hull_points(g);
    fmb_mem_put(g->mem, g->basic, n, sizeof *g->basic);
    fmb_mem_put(g->mem, g->inverse, n * n, sizeof *g->inverse);
    fmb_mem_put(g->mem, g->length, n, sizeof *g->length);
    fmb_mem_put(g->mem, g->value, n, sizeof *g->value);
    fmb_mem_put(g->mem, g->w, n, sizeof *g->w);
    fmb_mem_put(g->mem, g->entry, n, sizeof *g->entry);
    fmb_mem_put(g->mem, g->work, 2 * n * n, sizeof *g->work);
    g->mem = NULL;
}

/* Points lie by coordinate, so each coordinate moves. */
static fmb_status reserve_hull_points(fmb_gauge *g, size_t capacity)
{
    fmb_gauge old = *g;
    g->capacity = capacity;
    g->at = fmb_mem_get(g->mem, g->n * capacity, sizeof *g->at);
    g->name = fmb_mem_get(g->mem, capacity, sizeof *g->name);
    g->reduced = fmb_mem_get(g->mem, capacity, sizeof *g->reduced);
    g->along = fmb_mem_get(g->mem, capacity, sizeof *g->along);
    if (!g->at || !g->name || !g->reduced || !g->along) {
        fmb_status st = fmb_mem_status(g->mem);
        free_hull_points(g);
        *g = old;
        return st;
    }
    for (size_t k = 0; old.size > 0 && k < g->n; k++)
        memcpy(&g->at[k * capacity], &old.at[k * old.capacity], old.size * sizeof *g->at);
    if (old.size > 0) {
        memcpy(g->name, old.name, old.size * sizeof *g->name);
        memcpy(g->reduced, old.reduced, old.size * sizeof *g->reduced);
    }
    free_hull_points(&old);
    return FMB_OK;
}

/* ---- walls of the cube ----------------------------------------------------------------------- */

/* Wall 2 k is the point e_k / cube, wall 2 k + 1 its mirror image. */
#define WALLS (SIZE_MAX / 2)

static bool is_wall(size_t j)
{
    return j >= WALLS;
}

static double wall_coordinate(const fmb_gauge *g, size_t j)
{
    return ((j - WALLS) % 2 == 0 ? 1 : -1) / g->cube;
}

static size_t wall_axis(size_t j)
{
    return (j - WALLS) / 2;
}

size_t fmb_gauge_name(const fmb_gauge *g, size_t r)
{
    return is_wall(g->basic[r]) ? SIZE_MAX : g->name[g->basic[r]];
}

/* ---- the basis ------------------------------------------------------------------------------- */

/* w is where all basic walls meet: w.q_j = 1. */
static void find_vertex(fmb_gauge *g)
{
    size_t n = g->n;
    memset(g->w, 0, n * sizeof *g->w);
    for (size_t r = 0; r < n; r++)
        for (size_t k = 0; k < n; k++)
            g->w[k] += g->inverse[r * n + k];
}

static void reduce_point_range(fmb_gauge *g, size_t from)
{
    for (size_t j = from; j < g->size; j++)
        g->reduced[j] = 1;
    for (size_t k = 0; k < g->n; k++)
        if (g->w[k] != 0)
            g->kernels->accumulate(&g->reduced[from], &g->at[k * g->capacity + from],
                                   g->size - from, -g->w[k]);
    for (size_t r = 0; r < g->n; r++)
        if (!is_wall(g->basic[r]) && g->basic[r] >= from)
            g->reduced[g->basic[r]] = 0;
}

/* In four sums, so that none waits for the other. */
static double dot_product(const double *a, const double *b, size_t n)
{
    double sum[4] = {0};
    size_t k = 0;
    for (; k + 4 <= n; k += 4)
        for (size_t i = 0; i < 4; i++)
            sum[i] += a[k + i] * b[k + i];
    for (; k < n; k++)
        sum[0] += a[k] * b[k];
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

static void measure_edges(fmb_gauge *g)
{
    for (size_t r = 0; r < g->n; r++)
        g->length[r] = dot_product(&g->inverse[r * g->n], &g->inverse[r * g->n], g->n);
}

/* The corner of the cube on the side of q. */
static void start_from_cube(fmb_gauge *g, const double *q)
{
    memset(g->inverse, 0, g->n * g->n * sizeof *g->inverse);
    for (size_t k = 0; k < g->n; k++) {
        bool mirrored = q && q[k] < 0;
        g->basic[k] = WALLS + 2 * k + mirrored;
        g->inverse[k * g->n + k] = mirrored ? -g->cube : g->cube;
    }
    g->pivots = 0;
    find_vertex(g);
    measure_edges(g);
    reduce_point_range(g, 0);
}

/* entry = point j, written in the basis. */
static void write_in_basis(fmb_gauge *g, size_t j)
{
    size_t n = g->n;
    double *point = g->work;
    if (is_wall(j)) {
        for (size_t r = 0; r < n; r++)
            g->entry[r] = g->inverse[r * n + wall_axis(j)] * wall_coordinate(g, j);
        return;
    }
    for (size_t k = 0; k < n; k++)
        point[k] = g->at[k * g->capacity + j];
    for (size_t r = 0; r < n; r++)
        g->entry[r] = dot_product(&g->inverse[r * n], point, n);
}

static void find_hull_values(fmb_gauge *g, const double *q)
{
    for (size_t r = 0; r < g->n; r++)
        g->value[r] = dot_product(&g->inverse[r * g->n], q, g->n);
}

/* along = row r of the inverse times each point. */
static void price_points(fmb_gauge *g, size_t r)
{
    const double *row = &g->inverse[r * g->n];
    memset(g->along, 0, g->size * sizeof *g->along);
    for (size_t k = 0; k < g->n; k++)
        if (row[k] != 0)
            g->kernels->accumulate(g->along, &g->at[k * g->capacity], g->size, row[k]);
}

/* Point j, just written, takes place r; along is the row that has just been priced, and gap is the
 * distance of w from the wall of j. */
static void take_into_basis(fmb_gauge *g, size_t r, size_t j, double gap)
{
    size_t n = g->n, old = g->basic[r];
    double *row = &g->inverse[r * n], pivot = g->entry[r], way = gap / pivot;
    double value = g->value[r] / pivot;
    for (size_t k = 0; k < n; k++)
        g->w[k] += way * row[k];
    g->kernels->accumulate(g->reduced, g->along, g->size, -way);
    for (size_t k = 0; k < n; k++)
        row[k] /= pivot;
    g->length[r] /= pivot * pivot;
    for (size_t i = 0; i < n; i++) {
        double f = i == r ? 0 : g->entry[i];
        if (f == 0)
            continue;
        g->kernels->accumulate(&g->inverse[i * n], row, n, -f);
        g->length[i] = dot_product(&g->inverse[i * n], &g->inverse[i * n], n);
        g->value[i] -= f * value;
    }
    g->value[r] = value;
    g->basic[r] = j;
    if (!is_wall(j))
        g->reduced[j] = 0;
    if (!is_wall(old))
        g->reduced[old] = -way;
    g->pivots++;
}

/* ---- the inverse afresh ---------------------------------------------------------------------- */

static void load_basis_matrix(fmb_gauge *g)
{
    size_t n = g->n, wide = 2 * n;
    memset(g->work, 0, n * wide * sizeof *g->work);
    for (size_t r = 0; r < n; r++) { /* points are the columns */
        size_t j = g->basic[r];
        if (is_wall(j))
            g->work[wall_axis(j) * wide + r] = wall_coordinate(g, j);
        for (size_t k = 0; !is_wall(j) && k < n; k++)
            g->work[k * wide + r] = g->at[k * g->capacity + j];
        g->work[r * wide + n + r] = 1;
    }
}

static void swap_work_rows(fmb_gauge *g, size_t a, size_t b)
{
    size_t wide = 2 * g->n;
    for (size_t k = 0; a != b && k < wide; k++) {
        double t = g->work[a * wide + k];
        g->work[a * wide + k] = g->work[b * wide + k];
        g->work[b * wide + k] = t;
    }
}

static size_t find_pivot_row(const fmb_gauge *g, size_t c)
{
    size_t best = c, wide = 2 * g->n;
    for (size_t r = c; r < g->n; r++)
        if (fabs(g->work[r * wide + c]) > fabs(g->work[best * wide + c]))
            best = r;
    return best;
}

/* Gauss and Jordan. False if the basis is singular. */
static bool invert_basis_matrix(fmb_gauge *g)
{
    size_t n = g->n, wide = 2 * n;
    load_basis_matrix(g);
    for (size_t c = 0; c < n; c++) {
        swap_work_rows(g, c, find_pivot_row(g, c));
        double *row = &g->work[c * wide], pivot = row[c];
        if (!(fabs(pivot) > ROUNDING / g->cube))
            return false;
        for (size_t k = c; k < wide; k++)
            row[k] /= pivot;
        for (size_t r = 0; r < n; r++) {
            double f = r == c ? 0 : g->work[r * wide + c];
            if (f != 0)
                g->kernels->accumulate(&g->work[r * wide + c], row + c, wide - c, -f);
        }
    }
    for (size_t r = 0; r < n; r++)
        memcpy(&g->inverse[r * n], &g->work[r * wide + n], n * sizeof *g->inverse);
    return true;
}

static void refresh_inverse(fmb_gauge *g)
{
    if (!invert_basis_matrix(g)) {
        start_from_cube(g, NULL);
        return;
    }
    g->pivots = 0;
    find_vertex(g);
    measure_edges(g);
    reduce_point_range(g, 0);
}

/* ---- the dual method: up along edges --------------------------------------------------------- */

/* The place whose edge rises most for its length. */
static size_t find_steepest_rise(const fmb_gauge *g)
{
    size_t best = SIZE_MAX;
    double most = 0;
    for (size_t r = 0; r < g->n; r++) {
        double v = g->value[r];
        if (v < -g->zero && v * v > most * g->length[r]) {
            most = v * v / g->length[r];
            best = r;
        }
    }
    return best;
}

/* The wall, of points and of the cube, that an edge meets first; of those that are met nearly at
 * once, the one that is met most squarely. */
typedef struct first_wall {
    size_t wall;
    double gap, along;
} first_wall;

static double cube_gap(const fmb_gauge *g, size_t j)
{
    return 1 - g->w[wall_axis(j)] * wall_coordinate(g, j);
}

static double cube_along(const fmb_gauge *g, size_t r, size_t j)
{
    return g->inverse[r * g->n + wall_axis(j)] * wall_coordinate(g, j);
}

/* How far the edge goes if walls may be passed by as little as rounding errors: rates of approach
 * are counted from `least` on. */
static double find_longest_step(const fmb_gauge *g, size_t r, double least)
{
    double step = INFINITY;
    for (size_t j = 0; j < g->size; j++)
        if (g->along[j] < -least && g->reduced[j] + ROUNDING < step * -g->along[j])
            step = (g->reduced[j] + ROUNDING) / -g->along[j];
    for (size_t j = WALLS; j < WALLS + 2 * g->n; j++) {
        double along = cube_along(g, r, j);
        if (along < -least / g->cube && cube_gap(g, j) + ROUNDING < step * -along)
            step = (cube_gap(g, j) + ROUNDING) / -along;
    }
    return step;
}

static first_wall find_first_wall(const fmb_gauge *g, size_t r)
{
    double least = LEAST_PIVOT * sqrt(g->length[r]), step = find_longest_step(g, r, least);
    first_wall f = {SIZE_MAX, 0, -least};
    for (size_t j = 0; j < g->size; j++)
        if (g->along[j] < f.along && g->reduced[j] <= step * -g->along[j])
            f = (first_wall){j, g->reduced[j], g->along[j]};
    for (size_t j = WALLS; f.wall == SIZE_MAX && j < WALLS + 2 * g->n; j++)
        if (cube_along(g, r, j) < -least / g->cube && cube_gap(g, j) <= step * -cube_along(g, r, j))
            f = (first_wall){j, cube_gap(g, j), cube_along(g, r, j)};
    f.gap = f.gap > 0 ? f.gap : 0;
    return f;
}

static double sum_of_values(const fmb_gauge *g)
{
    double sum = 0;
    for (size_t r = 0; r < g->n; r++)
        sum += g->value[r];
    return sum;
}

static fmb_status climb(fmb_gauge *g, const double *q, fmb_run *run, fmb_side_of_hull *out)
{
    fmb_status st = FMB_OK;
    *out = FMB_HULL_NONE;
    find_hull_values(g, q);
    for (size_t steps = 0; st == FMB_OK && steps < 64 + 16 * g->n; steps++) {
        if (sum_of_values(g) > 1 + ROUNDING) {
            *out = FMB_HULL_OUTSIDE;
            return FMB_OK;
        }
        size_t r = find_steepest_rise(g);
        if (r == SIZE_MAX) {
            *out = FMB_HULL_INSIDE;
            return FMB_OK;
        }
        price_points(g, r);
        first_wall f = find_first_wall(g, r);
        if (f.wall == SIZE_MAX)
            return FMB_OK;
        write_in_basis(g, f.wall);
        take_into_basis(g, r, f.wall, f.gap);
        st = run ? fmb_run_poll(run) : FMB_OK;
    }
    return st;
}

/* ---- the primal method: back behind new walls ------------------------------------------------ */

/* The wall, of points and of the cube, that w is farthest beyond. */
static size_t find_most_broken_wall(const fmb_gauge *g, double *gap)
{
    size_t best = SIZE_MAX;
    *gap = -ROUNDING;
    for (size_t j = 0; j < g->size; j++)
        if (g->reduced[j] < *gap) {
            *gap = g->reduced[j];
            best = j;
        }
    for (size_t j = WALLS; j < WALLS + 2 * g->n; j++)
        if (cube_gap(g, j) < *gap) {
            *gap = cube_gap(g, j);
            best = j;
        }
    return best;
}

/* The basic point that comes down to 0 first when j, just written, goes up. */
static size_t find_leaving_point(const fmb_gauge *g, size_t j)
{
    size_t best = SIZE_MAX;
    double room = INFINITY, least = is_wall(j) ? LEAST_PIVOT / g->cube : LEAST_PIVOT;
    for (size_t r = 0; r < g->n; r++)
        if (g->entry[r] > least * sqrt(g->length[r]) && g->value[r] < room * g->entry[r]) {
            room = g->value[r] / g->entry[r];
            best = r;
        }
    return best;
}

/* A target that w is the highest vertex for: a sum of all basic points, no two of them alike. */
static void aim_at_vertex(fmb_gauge *g)
{
    uint32_t h = 1;
    for (size_t r = 0; r < g->n; r++) {
        h = h * 1664525u + 1013904223u;
        g->value[r] = 1 + (double)(h >> 8) / (1 << 24);
    }
}

static fmb_status return_behind_walls(fmb_gauge *g, fmb_run *run, bool *done)
{
    fmb_status st = FMB_OK;
    aim_at_vertex(g);
    *done = false;
    for (size_t steps = 0; st == FMB_OK && steps < 64 + 16 * g->n; steps++) {
        double gap;
        size_t j = find_most_broken_wall(g, &gap);
        *done = j == SIZE_MAX;
        if (*done)
            return FMB_OK;
        write_in_basis(g, j);
        size_t r = find_leaving_point(g, j);
        if (r == SIZE_MAX)
            return FMB_OK;
        price_points(g, r);
        take_into_basis(g, r, j, gap);
        st = run ? fmb_run_poll(run) : FMB_OK;
    }
    return st;
}

/* ---- questions ------------------------------------------------------------------------------- */

fmb_status fmb_gauge_add(fmb_gauge *g, const double *q, size_t name)
{
    fmb_status st = FMB_OK;
    if (g->size == g->capacity)
        st = reserve_hull_points(g, 2 * g->capacity);
    if (st != FMB_OK)
        return st;
    for (size_t k = 0; k < g->n; k++)
        g->at[k * g->capacity + g->size] = q[k];
    g->name[g->size] = name;
    g->size++;
    reduce_point_range(g, g->size - 1);
    return FMB_OK;
}

void fmb_gauge_forget(fmb_gauge *g)
{
    size_t left = 0;
    for (size_t j = 0; j < g->size; j++)
        g->along[j] = 0;
    for (size_t r = 0; r < g->n; r++)
        if (!is_wall(g->basic[r]))
            g->along[g->basic[r]] = 1;
    for (size_t j = 0; j < g->size; j++) {
        if (g->along[j] == 0)
            continue;
        for (size_t k = 0; k < g->n; k++)
            g->at[k * g->capacity + left] = g->at[k * g->capacity + j];
        for (size_t r = 0; r < g->n; r++)
            if (g->basic[r] == j)
                g->basic[r] = left;
        g->name[left++] = g->name[j];
    }
    g->size = left;
    reduce_point_range(g, 0);
}

void fmb_gauge_resize_cube(fmb_gauge *g, double cube)
{
    g->cube = cube;
    start_from_cube(g, NULL);
}

/* Once more from the cube if the search is stuck: errors may have gathered. */
fmb_status fmb_gauge_ask(fmb_gauge *g, const double *q, fmb_run *run, fmb_side_of_hull *out)
{
    fmb_status st = FMB_OK;
    *out = FMB_HULL_NONE;
    for (int tries = 0; st == FMB_OK && *out == FMB_HULL_NONE && tries < 2; tries++) {
        bool done;
        if (tries > 0)
            start_from_cube(g, q);
        else if (g->pivots > STALE)
            refresh_inverse(g);
        st = return_behind_walls(g, run, &done);
        if (st == FMB_OK && done)
            st = climb(g, q, run, out);
    }
    return st;
}
