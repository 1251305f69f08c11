/* pairs.c: see pairs.h. */
#include "pairs.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Dimensions, motion, and the kind of contact; the number of pairs, so that each block takes about
 * as long. */
static const struct {
    const char *name;
    int dim, naxes;
    bool moves, by_corners;
    fmb_contact contact;
    size_t pairs;
} CASE[] = {{"2D", 2, 0, false, false, FMB_CONTACT_CLOSED, 400},
            {"3D", 3, 0, false, false, FMB_CONTACT_CLOSED, 400},
            {"3D moving", 3, 0, true, false, FMB_CONTACT_CLOSED, 200},
            {"3D few axes", 3, 2, false, false, FMB_CONTACT_CLOSED, 200},
            {"3D corners", 3, 0, false, true, FMB_CONTACT_CLOSED, 400},
            {"4D", 4, 0, false, false, FMB_CONTACT_CLOSED, 20},
            {"5D", 5, 0, false, false, FMB_CONTACT_CLOSED, 5},
            {"6D open", 6, 0, false, false, FMB_CONTACT_OPEN, 5},
            {"9D", 9, 0, false, false, FMB_CONTACT_CLOSED, 3}};

enum { CASES = sizeof CASE / sizeof *CASE };

size_t pair_blocks(void)
{
    return (size_t)CASES * STUDY_PAIR_FAMILIES;
}

void pair_block_draw(size_t number, uint64_t seed, pair_block *block, problem *p)
{
    const int k = (int)(number % CASES),
              shape = CASE[k].by_corners ? FMB_SIMPLEX : STUDY_PAIR_ANY_SHAPE;
    study_pair_family family = (study_pair_family)(number / CASES);
    *block = (pair_block){.plan = {.family = family,
                                   .dim = CASE[k].dim,
                                   .moves = CASE[k].moves,
                                   .shape = {shape, shape},
                                   .naxes = {CASE[k].naxes, CASE[k].naxes}},
                          .seed = seed,
                          .by_corners = CASE[k].by_corners,
                          .contact = CASE[k].contact,
                          .pairs = CASE[k].pairs};
    *p = (problem){.n = CASE[k].dim, .own = block};
    snprintf(p->name, sizeof p->name, "pairs %s:%s_%" PRIu64, study_pair_family_text(family),
             CASE[k].name, seed);
}

/* ---- the driver ------------------------------------------------------------------------------ */

typedef struct state {
    fmb_pair *solver;
    study_pairs pairs;
    fmb_verdict *verdict;
    double *box; /* [pairs][dim][2]; NULL: verdicts alone */
    double sum[3];
    peer_numbers numbers;
} state;

/* Simplices are given by their rounded corners. */
static void write_by_corners(study_pairs *s, fmb_frame *f)
{
    double *axes = s->number + (f->axes - s->number);
    for (int k = 0; k < f->naxes * f->dim; k++)
        axes[k] += f->origin[k % f->dim];
    f->shape = FMB_SIMPLEX_BY_CORNERS;
}

static void *open_pairs(const problem *p, const peer_setup *setup)
{
    const pair_block *b = p->own;
    state *s = need(calloc(1, sizeof *s));
    fmb_pair_options options = {.size = sizeof options, .contact = b->contact, .tightest = true};
    if (fmb_pair_new(p->n, &options, NULL, &s->solver) != FMB_OK ||
        study_pairs_make(&b->plan, b->seed, b->pairs, NULL, NULL, &s->pairs) != FMB_OK)
        need(NULL);
    for (size_t i = 0; b->by_corners && i < b->pairs; i++) {
        write_by_corners(&s->pairs, &s->pairs.p[i]);
        write_by_corners(&s->pairs, &s->pairs.q[i]);
    }
    s->verdict = need(calloc(b->pairs, sizeof *s->verdict));
    if (setup->question == PEER_BOX)
        s->box = need(calloc(b->pairs * (size_t)p->n, 2 * sizeof *s->box));
    s->numbers.value = s->sum;
    return s;
}

static void ready_pairs(void *self)
{
    (void)self;
}

static fmb_verdict ask_pairs(void *self)
{
    state *s = self;
    fmb_pair_answers out = {.size = sizeof out, .verdict = s->verdict, .world = s->box};
    return fmb_pair_test(s->solver, s->pairs.n, s->pairs.p, s->pairs.q, &out) == FMB_OK
               ? FMB_FEASIBLE
               : FMB_UNKNOWN;
}

/* Ends do not depend on the way that finds them, so their sums in a fixed order do not, either. */
static const peer_numbers *sum_answers(void *self)
{
    state *s = self;
    size_t dim = (size_t)s->pairs.p[0].dim;
    memset(s->sum, 0, sizeof s->sum);
    for (size_t i = 0; i < s->pairs.n; i++) {
        s->sum[0] += s->verdict[i] == FMB_FEASIBLE;
        for (size_t k = 0; s->box && s->verdict[i] == FMB_FEASIBLE && k < 2 * dim; k++)
            s->sum[1 + k % 2] += s->box[2 * dim * i + k];
    }
    s->numbers.n = s->box ? 3 : 1;
    return &s->numbers;
}

static void close_pairs(void *self)
{
    state *s = self;
    fmb_pair_free(s->solver);
    study_pairs_free(&s->pairs);
    free(s->verdict);
    free(s->box);
    free(s);
}

const peer peer_pairs = {
    .name = "pairs",
    .library = "fmb",
    .ours = true,
    .open = open_pairs,
    .ready = ready_pairs,
    .decide = ask_pairs,
    .box = ask_pairs,
    .numbers = sum_answers,
    .close = close_pairs,
};
