/* benchmark.c: see benchmark.h.
 *
 * Most families draw their sizes: for each instance a pool of candidates is drawn and sorted by
 * rows times variables, and size k is the middle candidate of the k-th fifth. Some families grow
 * with the size as well. Verdicts and frames have a fixed shape for each size.
 */
#include "study/benchmark/benchmark.h"

#include <stdio.h>
#include <string.h>

#include "study/benchmark/frames.h"
#include "study/program/program.h"

typedef struct description {
    const char *name, *field;
    int larger;                 /* growth at size 5 (projection.h) */
    study_benchmark_bodies *of; /* frames alone */
    const char *with,
        *without; /* verdicts alone: families of programs with and without solutions */
} description;

static const description FAMILY[] = {
    {.name = "frames-still", .field = "collision", .of = study_benchmark_cuboids},
    {.name = "frames-moving", .field = "collision", .of = study_benchmark_moving_cuboids},
    {.name = "frames-simplices", .field = "collision", .of = study_benchmark_moving_simplices},
    {.name = "control", .field = "control", .larger = 1},
    {.name = "value", .field = "control"},
    {.name = "stages", .field = "control"},
    {.name = "clocks", .field = "verification"},
    {.name = "octagon", .field = "program analysis"},
    {.name = "loops", .field = "program analysis"},
    {.name = "chain", .field = "program analysis"},
    {.name = "petri", .field = "program analysis"},
    {.name = "schedule", .field = "scheduling"},
    {.name = "hydro", .field = "scheduling"},
    {.name = "flow", .field = "networks"},
    {.name = "transport", .field = "networks"},
    {.name = "power", .field = "networks"},
    {.name = "tree", .field = "networks"},
    {.name = "entropy", .field = "information theory"},
    {.name = "metric", .field = "information theory"},
    {.name = "local", .field = "information theory"},
    {.name = "relu", .field = "machine learning", .larger = 2},
    {.name = "games", .field = "economics"},
    {.name = "packing", .field = "economics"},
    {.name = "points", .field = "geometry"},
    {.name = "slice", .field = "geometry"},
    {.name = "sum", .field = "geometry", .larger = 2},
    {.name = "zonotope", .field = "geometry", .larger = 4},
    {.name = "cone", .field = "geometry"},
    {.name = "union", .field = "extended formulations", .larger = 2},
    {.name = "orbit", .field = "extended formulations"},
    {.name = "parity", .field = "extended formulations", .larger = 2},
    {.name = "knapsack", .field = "extended formulations"},
    {.name = "conflict",
     .field = "infeasible cores",
     .with = "dense-point",
     .without = "dense-conflict"},
    {.name = "conflict-sparse",
     .field = "infeasible cores",
     .with = "sparse-point",
     .without = "sparse-conflict"},
    {.name = "none", .field = "infeasible cores"},
    {.name = "dense", .field = "random", .larger = 2},
    {.name = "sparse", .field = "random"},
    {.name = "strict", .field = "random"},
    {.name = "long", .field = "random", .larger = 1},
    {.name = "redundant", .field = "random"},
};

enum { FAMILIES = sizeof FAMILY / sizeof *FAMILY, POOL = 25 };

int study_benchmark_families(void)
{
    return FAMILIES;
}

const char *study_benchmark_name(int family)
{
    return FAMILY[family].name;
}

const char *study_benchmark_field(int family)
{
    return FAMILY[family].field;
}

int study_benchmark_find(const char *name)
{
    for (int f = 0; f < FAMILIES; f++)
        if (strcmp(FAMILY[f].name, name) == 0)
            return f;
    return -1;
}

/* The family of projections of the same name. */
static int projection_of(int family)
{
    int f = 0;
    while (f < study_projections() && strcmp(study_projection_name(f), FAMILY[family].name) != 0)
        f++;
    return f;
}

const char *study_benchmark_about(int family)
{
    const description *f = &FAMILY[family];
    if (f->of)
        return "two bodies, as many dimensions as the size and one more: where they share points";
    if (f->with)
        return "rows around a planted point, or some of them in conflict: is there a solution?";
    return study_projection_about(projection_of(family));
}

void study_benchmark_problem_name(int family, int size, int instance, char *out)
{
    snprintf(out, STUDY_BENCHMARK_NAME, "%s-%d-%d", FAMILY[family].name, size, instance);
}

/* ---- one problem ----------------------------------------------------------------------------- */

static size_t measure(const fmb_system *s)
{
    return fmb_system_rows(s) * (size_t)fmb_system_dim(s);
}

static fmb_status draw_candidate(int family, int size, uint64_t seed, study_projection *out)
{
    int larger = FAMILY[family].larger * (size - 1) / (STUDY_BENCHMARK_SIZES - 1);
    return study_projection_draw_larger(projection_of(family), seed, larger, out);
}

/* The candidate at this place of the order by size; of equal sizes the lower number is first. */
static int candidate_at(const size_t of[POOL], int place)
{
    for (int c = 0; c < POOL; c++) {
        int before = 0;
        for (int other = 0; other < POOL; other++)
            before += of[other] < of[c] || (of[other] == of[c] && other < c);
        if (before == place)
            return c;
    }
    return 0;
}

static fmb_status draw_from_pool(int family, int size, int instance, study_projection *out)
{
    size_t of[POOL];
    uint64_t first = (uint64_t)instance * POOL;
    for (int c = 0; c < POOL; c++) {
        study_projection p;
        fmb_status st = draw_candidate(family, size, first + (uint64_t)c, &p);
        if (st != FMB_OK)
            return st;
        of[c] = measure(p.s);
        fmb_system_free(p.s);
    }
    int fifth = POOL / STUDY_BENCHMARK_SIZES;
    int chosen = candidate_at(of, fifth * (size - 1) + fifth / 2);
    return draw_candidate(family, size, first + (uint64_t)chosen, out);
}

/* Odd instances are infeasible. */
static fmb_status draw_verdict(const description *f, int size, int instance, study_projection *out)
{
    study_program_plan plan;
    study_program p;
    const char *bad;
    if (!study_program_plan_parse(instance % 2 ? f->without : f->with, &plan, &bad))
        return FMB_ERR_ARG;
    plan.variables = 3 + 2 * size;
    plan.rows = 4 * plan.variables;
    plan.seed = (uint64_t)(instance * STUDY_BENCHMARK_SIZES + size);
    fmb_status st = study_program_draw(&plan, &p);
    if (st != FMB_OK)
        return st;
    *out = (study_projection){p.s, 0};
    p.s = NULL;
    study_program_clear(&p);
    return fmb_system_set_objective(out->s, NULL);
}

fmb_status study_benchmark_draw(int family, int size, int instance, study_projection *out)
{
    const description *f = &FAMILY[family];
    study_projection p;
    fmb_status st = f->of     ? f->of(size, instance, &p)
                    : f->with ? draw_verdict(f, size, instance, &p)
                              : draw_from_pool(family, size, instance, &p);
    if (st != FMB_OK)
        return st;
    for (int j = 0; j < p.keep; j++)
        fmb_system_set_kept(p.s, j, true);
    *out = p;
    return FMB_OK;
}
