/* subject.c: see subject.h. */
#include "subject.h"

#include <stdlib.h>
#include <string.h>

#include "study/program/random.h"

/* Bound on the entries of all variants together, for memory: the drivers get dense rows. */
static const double MOST_ENTRIES = 4e6;

/* An allocator that only counts. */
static void *count_bytes(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    size_t *bytes = self;
    *bytes += new_bytes - old_bytes;
    if (new_bytes == 0) {
        free(p);
        return NULL;
    }
    return realloc(p, new_bytes);
}

static size_t bytes_of(const fmb_system *s)
{
    size_t bytes = 0, all = 0;
    fmb_alloc count = {count_bytes, &bytes};
    fmb_system *copy = NULL;
    if (fmb_system_new(fmb_system_dim(s), &count, &copy) != FMB_OK ||
        fmb_system_join(copy, s, NULL) != FMB_OK)
        need(NULL);
    all = bytes;
    fmb_system_free(copy);
    return all;
}

static void must(fmb_status st)
{
    if (st != FMB_OK)
        need(NULL);
}

static fmb_system *dressed(fmb_system *s, subject_dress dress, uint64_t seed)
{
    fmb_system *other = NULL;
    if (dress == DRESS_NONE)
        return s;
    if (dress == DRESS_SCALES)
        must(study_system_rescale(s, 9, seed, NULL, &other));
    else
        must(study_system_fractions(s, 10, seed, &other));
    fmb_system_free(s);
    return other;
}

/* A file without an objective gets a random one. */
static void need_objective(fmb_system *s, uint64_t seed)
{
    study_random g = {seed};
    double *coef = need(calloc((size_t)fmb_system_dim(s) + 1, sizeof *coef));
    for (int j = 0; j < fmb_system_dim(s); j++)
        coef[j] = (double)study_random_between(&g, -9, 9);
    if (!fmb_system_sense(s))
        must(fmb_system_set_objective(s, &(fmb_objective){FMB_SENSE_MAX, coef, 0}));
    free(coef);
}

/* Takes s over. */
static void take_system(subject *to, fmb_system *s, subject_dress dress, uint64_t seed)
{
    need_objective(s, seed);
    s = dressed(s, dress, seed);
    to->n = fmb_system_dim(s);
    to->m = fmb_system_rows(s);
    to->bytes = bytes_of(s);
    for (size_t i = 0; i < to->m; i++)
        to->terms += fmb_system_terms(s, i);
    problem_of_system(&to->variant[0], to->name, s);
    double entries = (double)to->m * (to->n + 1);
    to->variants = 1;
    while (to->variants < CHILD_VARIANTS && (to->variants + 1) * entries <= MOST_ENTRIES) {
        problem_variant(&to->variant[to->variants], &to->variant[0], (unsigned)to->variants);
        to->variants++;
    }
}

bool subject_draw(subject *s, const study_program_plan *plan, subject_dress dress)
{
    study_program p;
    *s = (subject){0};
    must(study_program_draw(plan, &p));
    study_program_plan_text(plan, s->name, sizeof s->name);
    s->verdict = dress == DRESS_FRACTIONS ? FMB_UNKNOWN : p.verdict;
    s->has_best = p.has_best && dress == DRESS_NONE;
    s->best = mpq_get_d(p.best);
    fmb_system *system = p.s;
    p.s = NULL;
    study_program_clear(&p);
    take_system(s, system, dress, plan->seed);
    return true;
}

static bool subject_read(subject *s, const char *path, subject_dress dress, uint64_t seed)
{
    problem p;
    fmb_system *copy = NULL;
    *s = (subject){0};
    if (!problem_read(&p, path))
        return false;
    must(fmb_system_copy(p.system, &copy));
    snprintf(s->name, sizeof s->name, "%s", p.name);
    problem_clear(&p);
    take_system(s, copy, dress, seed);
    return true;
}

bool subject_open(subject *s, const char *what, subject_dress dress, uint64_t seed)
{
    study_program_plan plan = {.seed = seed};
    const char *bad = "";
    if (strchr(what, '.') || strchr(what, '/'))
        return subject_read(s, what, dress, seed);
    if (study_program_plan_parse(what, &plan, &bad))
        return subject_draw(s, &plan, dress);
    fprintf(stderr, "%s: %s\n", what, bad);
    return false;
}

void subject_close(subject *s)
{
    for (int v = 0; v < s->variants; v++)
        problem_clear(&s->variant[v]);
}
