/* subjects.c: see subjects.h. */
#include "subjects.h"

#include <inttypes.h>
#include <stdio.h>

#include "../peers/polytope.h"
#include "../shapes.h"
#include "pairs.h"
#include "study/program/program.h"
#include "study/program/projection.h"
#include "study/program/random.h"

const char *subject_word(const problem *p, peer_question question)
{
    static const char *const WORD[PEER_QUESTIONS] = {
        [PEER_PROJECT] = "project",  [PEER_VERTICES] = "vertices", [PEER_HULL] = "hull",
        [PEER_DECIDE] = "decide",    [PEER_BOX] = "box",           [PEER_REDUCE] = "reduce",
        [PEER_OPTIMIZE] = "optimize"};
    return p && p->own ? "pairs" : WORD[question];
}

typedef struct asking {
    subject_ask *ask;
    void *self;
} asking;

/* Numbers of systems: as drawn (0), or fractions of so many digits. */
static const int DIGITS[] = {0, 9};

enum { DRESSES = sizeof DIGITS / sizeof *DIGITS };

/* Takes over s. */
static fmb_system *dress_numbers(fmb_system *s, int digits, uint64_t seed)
{
    fmb_system *dressed = NULL;
    if (digits == 0)
        return s;
    if (study_system_fractions(s, digits, seed, &dressed) != FMB_OK)
        need(NULL);
    fmb_system_free(s);
    return dressed;
}

static void ask_projection(int family, uint64_t seed, int digits, const asking *a)
{
    study_projection drawn;
    problem p;
    char name[sizeof p.name];
    if (study_projection_draw(family, seed, &drawn) != FMB_OK)
        need(NULL);
    snprintf(name, sizeof name, "project %s%s_%" PRIu64, study_projection_name(family),
             digits > 0 ? "/" : "", seed);
    problem_of_system(&p, name, dress_numbers(drawn.s, digits, seed));
    p.keep = drawn.keep;
    a->ask(a->self, &p, PEER_PROJECT);
}

static void ask_projections(uint64_t seed, const asking *a)
{
    for (int f = 0; f < study_projections(); f++)
        for (int k = 0; k < DRESSES; k++)
            ask_projection(f, seed, DIGITS[k], a);
}

/* Draws the program anew for each question, as the callback takes it over. */
static void ask_program(const study_program_plan *plan, int digits, peer_question question,
                        const asking *a)
{
    study_program drawn;
    problem p;
    char text[48], name[sizeof p.name];
    if (study_program_draw(plan, &drawn) != FMB_OK)
        need(NULL);
    study_program_plan_text(plan, text, sizeof text);
    snprintf(name, sizeof name, "%s %.36s%s_%" PRIu64, subject_word(NULL, question), text,
             digits > 0 ? "/" : "", plan->seed);
    problem_of_system(&p, name, dress_numbers(drawn.s, digits, plan->seed));
    drawn.s = NULL;
    study_program_clear(&drawn);
    a->ask(a->self, &p, question);
}

/* A quarter to twice the default size of the family. */
static study_program_plan draw_program_plan(int family, uint64_t seed)
{
    study_random g = {.state = seed * 1000003 + (uint64_t)family};
    study_program_plan plan;
    const char *bad;
    if (!study_program_plan_parse(study_program_name(family), &plan, &bad))
        need(NULL);
    double by = 0.25 * (double)study_random_between(&g, 1, 8);
    plan.seed = seed;
    plan.rows = (int)(by * plan.rows);
    plan.variables = plan.variables > 8 ? (int)(by * plan.variables) : plan.variables;
    return plan;
}

/* Boxes of large programs are many optima. */
#define MOST_ROWS_OF_BOX 200

static void ask_programs(uint64_t seed, const asking *a)
{
    for (int f = 0; f < study_program_families(); f++) {
        study_program_plan plan = draw_program_plan(f, seed);
        for (int k = 0; k < DRESSES; k++) {
            ask_program(&plan, DIGITS[k], PEER_DECIDE, a);
            ask_program(&plan, DIGITS[k], PEER_OPTIMIZE, a);
            if (plan.rows <= MOST_ROWS_OF_BOX)
                ask_program(&plan, DIGITS[k], PEER_BOX, a);
            ask_program(&plan, DIGITS[k], PEER_REDUCE, a);
        }
    }
}

/* The system of the common points of two bodies, of each kind. */
static void ask_pair_systems(uint64_t seed, const asking *a)
{
    for (unsigned kind = 0; kind < SHAPE_KINDS; kind++) {
        problem p;
        char shape[16], name[sizeof p.name];
        fmb_system *s = need(shape_pair(kind + SHAPE_KINDS * (unsigned)(seed % 1000000), shape));
        snprintf(name, sizeof name, "decide %s_%" PRIu64, shape, seed);
        problem_of_system(&p, name, s);
        a->ask(a->self, &p, PEER_DECIDE);
    }
}

/* Verdicts on systems of a few rows, as in inner loops of programs. */
static void ask_tiny_programs(uint64_t seed, const asking *a)
{
    static const char *const NAME[] = {"dense-origin", "dense-point", "dense-conflict", "strict"};
    study_random g = {.state = seed * 104729};
    for (size_t f = 0; f < sizeof NAME / sizeof *NAME; f++) {
        study_program_plan plan;
        const char *bad;
        if (!study_program_plan_parse(NAME[f], &plan, &bad))
            need(NULL);
        plan.seed = seed;
        plan.variables = (int)study_random_between(&g, 2, 5);
        plan.rows = plan.variables * (int)study_random_between(&g, 2, 3);
        ask_program(&plan, 0, PEER_DECIDE, a);
    }
}

/* Families of polytopes, the sizes between which the seed chooses, and rows. */
static const struct {
    const char *name;
    int least, most, rows; /* rows: a multiple of the size; 0: given by the family */
} POLYTOPE[] = {
    {"cube", 5, 10, 0},
    {"cross", 4, 9, 0},
    {"cyclic", 4, 9, 5},
    {"metric", 4, 5, 0},
    {"cut", 4, 5, 0},
    {"small", 3, 7, 10},
    {"sphere", 3, 7, 12},
    {"blocking", 3, 7, 4},
    {"slice", 4, 8, 0},
    {"lattice", 3, 7, 10},
    {"zonotope", 3, 6, 3},
    {"product", 4, 7, 0},
    {"assignment", 3, 4, 0},
    /* and those that take a twentieth of a second and more: many rays, long adjacency */
    {"cube", 14, 15, 0},
    {"cyclic", 7, 8, 6},
    {"small", 8, 9, 8},
    {"sphere", 6, 7, 12},
    {"blocking", 10, 11, 4},
    {"lattice", 8, 9, 8},
    {"zonotope", 5, 6, 2},
    {"permutahedron", 6, 6, 0},
    {"product", 12, 13, 0},
};

static void ask_polytope(size_t family, uint64_t seed, bool hull, const asking *a)
{
    study_random g = {.state = seed * 7919 + family};
    polytope_plan plan = {.seed = seed};
    problem p;
    char text[32], name[sizeof p.name];
    int size = (int)study_random_between(&g, POLYTOPE[family].least, POLYTOPE[family].most);
    int rows = POLYTOPE[family].rows * size;
    if (rows > 0)
        snprintf(text, sizeof text, "%s:%d:%d", POLYTOPE[family].name, size, rows);
    else
        snprintf(text, sizeof text, "%s:%d", POLYTOPE[family].name, size);
    if (!polytope_parse(text, &plan))
        need(NULL);
    peer_question question = hull ? PEER_HULL : PEER_VERTICES;
    snprintf(name, sizeof name, "%s %s_%" PRIu64, subject_word(NULL, question), text, seed);
    polytope_draw(&plan, &p, name);
    if (!hull)
        a->ask(a->self, &p, PEER_VERTICES);
    else if (problem_turn_over(&p))
        a->ask(a->self, &p, PEER_HULL);
    else
        problem_clear(&p);
}

static void ask_polytopes(uint64_t seed, const asking *a)
{
    for (size_t k = 0; k < sizeof POLYTOPE / sizeof *POLYTOPE; k++)
        for (int hull = 0; hull < 2; hull++)
            ask_polytope(k, seed, hull, a);
}

static void ask_pairs(uint64_t seed, const asking *a)
{
    for (size_t k = 0; k < 2 * pair_blocks(); k++) {
        pair_block block;
        problem p;
        pair_block_draw(k / 2, seed, &block, &p);
        a->ask(a->self, &p, k % 2 ? PEER_BOX : PEER_DECIDE);
    }
}

static bool ask_file(const char *path, peer_question question, const asking *a)
{
    problem p;
    if (!problem_read(&p, path))
        return false;
    if (question == PEER_PROJECT && p.keep == p.n)
        problem_clear(&p);
    else
        a->ask(a->self, &p, question);
    return true;
}

static bool ask_files(const subject_plan *plan, const asking *a)
{
    bool good = true;
    for (size_t i = 0; i < plan->files; i++)
        good &= ask_file(plan->file[i], PEER_DECIDE, a) &&
                ask_file(plan->file[i], PEER_PROJECT, a) && ask_file(plan->file[i], PEER_REDUCE, a);
    return good;
}

bool subjects_each(const subject_plan *plan, subject_ask *ask, void *self)
{
    asking a = {ask, self};
    for (uint64_t seed = plan->seed; seed < plan->seed + plan->each; seed++) {
        ask_projections(seed, &a);
        ask_programs(seed, &a);
        ask_pair_systems(seed, &a);
        ask_tiny_programs(seed, &a);
        ask_polytopes(seed, &a);
        ask_pairs(seed, &a);
    }
    return ask_files(plan, &a);
}
