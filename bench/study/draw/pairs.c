/* pairs.c: see pairs.h. */
#include "study/draw/pairs.h"

#include <stdlib.h>
#include <string.h>

#include "study/draw/draft.h"

static const char *const FAMILY[STUDY_PAIR_FAMILIES] = {
    [STUDY_PAIR_ARTICLE] = "article",   [STUDY_PAIR_LATTICE] = "lattice",
    [STUDY_PAIR_TOUCHING] = "touching", [STUDY_PAIR_NEAR] = "near",
    [STUDY_PAIR_FLAT] = "flat",         [STUDY_PAIR_DEGENERATE] = "degenerate",
    [STUDY_PAIR_TINY_A] = "tiny-A",     [STUDY_PAIR_TINY_B] = "tiny-B",
    [STUDY_PAIR_FAR] = "far",           [STUDY_PAIR_DENORMAL] = "denormal",
    [STUDY_PAIR_SWEPT] = "swept",       [STUDY_PAIR_INTEGER] = "integer",
    [STUDY_PAIR_SCALED] = "scaled",     [STUDY_PAIR_SPREAD] = "spread",
    [STUDY_PAIR_RAGGED] = "ragged",     [STUDY_PAIR_UNEVEN] = "uneven",
};

const char *study_pair_family_text(study_pair_family family)
{
    return FAMILY[family];
}

bool study_pair_family_parse(const char *word, study_pair_family *out)
{
    for (int i = 0; i < STUDY_PAIR_FAMILIES; i++)
        if (strcmp(word, FAMILY[i]) == 0) {
            *out = (study_pair_family)i;
            return true;
        }
    return false;
}

/* ---- one pair -------------------------------------------------------------------------------- */

/* A seed of the stream: one step of splitmix64 mixes the inputs. */
static uint64_t scatter(uint64_t seed, uint64_t more)
{
    uint64_t state;
    study_splitmix.set(&state, seed ^ more);
    return study_splitmix.get(&state);
}

static uint64_t seed_of(const study_pair_plan *plan, uint64_t seed, uint64_t k)
{
    uint64_t key = plan->moves;
    int field[] = {(int)plan->family,  plan->dim,      plan->shape[0] + 1,
                   plan->shape[1] + 1, plan->naxes[0], plan->naxes[1]};
    for (size_t i = 0; i < sizeof field / sizeof *field; i++)
        key = key * 32 + (uint64_t)field[i];
    return scatter(scatter(scatter(0, seed), key), k);
}

void study_pair_draw(const study_pair_plan *plan, uint64_t seed, uint64_t k, study_pair *out)
{
    uint64_t state;
    gsl_rng g = {&study_splitmix, &state};
    study_draft d = {.g = &g, .dim = plan->dim, .moves = plan->moves, .still = -1, .haste = 1};
    gsl_rng_set(&g, seed_of(plan, seed, k));
    for (int f = 0; f < 2; f++) {
        for (int i = 0; i < plan->dim; i++)
            d.factor[f][i] = 1;
        d.naxes[f] = plan->naxes[f] ? plan->naxes[f] : plan->dim;
        d.origin[f] = out->number[f];
        d.axes[f] = d.origin[f] + d.dim;
        d.speed[f] = d.axes[f] + d.naxes[f] * d.dim;
        bool any = plan->shape[f] == STUDY_PAIR_ANY_SHAPE;
        d.shape[f] = any ? (fmb_shape)study_coin(&d) : (fmb_shape)plan->shape[f];
    }
    if (d.moves && plan->family != STUDY_PAIR_ARTICLE && study_coin(&d))
        d.still = study_choice(&d, 2);
    study_family_draws[plan->family](&d);
    for (int f = 0; f < 2; f++)
        *(f ? &out->q : &out->p) =
            (fmb_frame){d.shape[f],  d.dim,     d.naxes[f],
                        d.origin[f], d.axes[f], d.moves && f != d.still ? d.speed[f] : NULL};
}

/* ---- many ------------------------------------------------------------------------------------ */

static fmb_frame pack(const fmb_frame *f, double **to)
{
    fmb_frame out = *f;
    size_t dim = (size_t)f->dim, axes = (size_t)f->naxes * dim;
    out.origin = memcpy(*to, f->origin, dim * sizeof **to);
    out.axes = memcpy(*to + dim, f->axes, axes * sizeof **to);
    *to += dim + axes;
    if (f->speed) {
        out.speed = memcpy(*to, f->speed, dim * sizeof **to);
        *to += dim;
    }
    return out;
}

fmb_status study_pairs_room(const study_pair_plan *plan, size_t n, study_pairs *out)
{
    size_t most = (size_t)(plan->dim * (plan->dim + 2));
    *out = (study_pairs){.p = calloc(n + 1, sizeof *out->p),
                         .q = calloc(n + 1, sizeof *out->q),
                         .number = calloc(2 * n + 1, most * sizeof(double))};
    if (out->p && out->q && out->number)
        return FMB_OK;
    study_pairs_free(out);
    return FMB_ERR_MEMORY;
}

/* The first n pairs that keep accepts, from pair out->drawn on. */
static void fill(const study_pair_plan *plan, uint64_t seed, size_t n,
                 bool (*keep)(void *self, const fmb_frame *p, const fmb_frame *q), void *self,
                 study_pairs *out)
{
    study_pair one;
    double *to = out->number;
    out->n = 0;
    while (out->n < n) {
        study_pair_draw(plan, seed, out->drawn++, &one);
        if (keep && !keep(self, &one.p, &one.q))
            continue;
        out->p[out->n] = pack(&one.p, &to);
        out->q[out->n++] = pack(&one.q, &to);
    }
}

void study_pairs_fill(const study_pair_plan *plan, uint64_t seed, uint64_t first, size_t n,
                      study_pairs *out)
{
    out->drawn = first;
    fill(plan, seed, n, NULL, NULL, out);
}

fmb_status study_pairs_make(const study_pair_plan *plan, uint64_t seed, size_t n,
                            bool (*keep)(void *self, const fmb_frame *p, const fmb_frame *q),
                            void *self, study_pairs *out)
{
    fmb_status st = study_pairs_room(plan, n, out);
    if (st == FMB_OK)
        fill(plan, seed, n, keep, self, out);
    return st;
}

void study_pairs_free(study_pairs *s)
{
    free(s->p);
    free(s->q);
    free(s->number);
    *s = (study_pairs){0};
}
