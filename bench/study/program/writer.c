/* writer.c: see writer.h. */
#include "study/program/writer.h"

#include <stdlib.h>

bool study_write_begin(study_writer *w, int variables)
{
    w->st = fmb_system_new(variables, NULL, &w->to->s);
    w->goal = calloc((size_t)variables + 1, sizeof *w->goal);
    if (w->st == FMB_OK && !w->goal)
        w->st = FMB_ERR_MEMORY;
    return w->st == FMB_OK;
}

bool study_write_image(study_writer *w, int variables, int keep)
{
    w->variables = variables;
    w->keep = keep;
    return study_write_begin(w, variables);
}

int study_draw(study_writer *w, int lo, int hi)
{
    return (int)study_random_between(&w->g, lo, hi);
}

int study_draw_size(study_writer *w, int lo, int hi)
{
    return study_draw(w, lo, hi) + w->larger;
}

/* Room for one more term. */
static bool has_room_for_term(study_writer *w)
{
    if (w->st != FMB_OK || w->terms < w->capacity)
        return w->st == FMB_OK;
    size_t more = w->capacity ? 2 * w->capacity : 16;
    int *var = realloc(w->var, more * sizeof *var);
    w->var = var ? var : w->var;
    mpq_t *coef = realloc(w->coef, more * sizeof *coef);
    w->coef = coef ? coef : w->coef;
    if (!var || !coef) {
        w->st = FMB_ERR_MEMORY;
        return false;
    }
    for (size_t k = w->capacity; k < more; k++)
        mpq_init(coef[k]);
    w->capacity = more;
    return true;
}

void study_write_term_q(study_writer *w, int var, int64_t num, uint64_t den)
{
    if (num == 0 || !has_room_for_term(w))
        return;
    w->var[w->terms] = var;
    mpq_set_si(w->coef[w->terms++], num, den);
}

void study_write_term(study_writer *w, int var, int64_t coef)
{
    study_write_term_q(w, var, coef, 1);
}

void study_write_end_q(study_writer *w, fmb_rel rel, int64_t num, uint64_t den)
{
    mpq_set_si(w->right, num, den);
    if (w->st == FMB_OK)
        w->st = fmb_system_add_q(w->to->s, w->terms, w->var, w->coef, rel, w->right);
    w->terms = 0;
}

void study_write_end(study_writer *w, fmb_rel rel, int64_t right)
{
    study_write_end_q(w, rel, right, 1);
}

void study_write_least(study_writer *w, int var, int64_t least)
{
    study_write_term(w, var, 1);
    study_write_end(w, FMB_GE, least);
}

void study_write_most(study_writer *w, int var, int64_t most)
{
    study_write_term(w, var, 1);
    study_write_end(w, FMB_LE, most);
}

void study_write_box(study_writer *w, int first, int count, int64_t lo, int64_t hi)
{
    for (int x = first; x < first + count; x++) {
        study_write_least(w, x, lo);
        study_write_most(w, x, hi);
    }
}

void study_write_sum(study_writer *w, int first, int count, int64_t coef)
{
    for (int x = first; x < first + count; x++)
        study_write_term(w, x, coef);
}

void study_write_best(study_writer *w, int64_t num, uint64_t den)
{
    w->to->has_best = true;
    mpq_set_si(w->to->best, num, den);
    mpq_canonicalize(w->to->best);
}

void study_write_any_goal(study_writer *w)
{
    for (int j = 0; w->st == FMB_OK && j < fmb_system_dim(w->to->s); j++)
        w->goal[j] = (double)study_random_between(&w->g, -9, 9);
}
