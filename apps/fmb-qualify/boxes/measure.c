/* measure.c: see boxes.h. */
#include "fmb-qualify/boxes/boxes.h"

#include <math.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/watch.h"
#include "study/rivals/aabb.h"
#include "study/rivals/article.h"

enum { MOST_SIZED = 4096, MOST_DIM = 4 };

static const double allowed = 1e-12; /* beyond the exact end, of the largest coordinate */

/* ---- pairs ----------------------------------------------------------------------------------- */

static bool meets(void *self, const fmb_frame *p, const fmb_frame *q)
{
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = fmb_pair_test(
        self, 1, p, q, &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &verdict});
    return st == FMB_OK && verdict == FMB_FEASIBLE;
}

fmb_status boxes_draw(int dim, bool moves, uint64_t seed, size_t n, study_pairs *out)
{
    const study_pair_plan plan = {.family = STUDY_PAIR_ARTICLE,
                                  .dim = dim,
                                  .moves = moves,
                                  .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
    fmb_pair *k = NULL;
    fmb_status st = fmb_pair_new(dim, NULL, NULL, &k);
    if (st == FMB_OK)
        st = study_pairs_make(&plan, seed, n, meets, k, out);
    fmb_pair_free(k);
    return st;
}

/* ---- sizes ----------------------------------------------------------------------------------- */

/* The ways to find boxes, and all boxes of one pair. */
typedef struct sizing {
    fmb_pair *tightest, *usual;
    study_article *article;
    double box[BOXES_KINDS][2 * MOST_DIM];
    double tight[2][2 * MOST_DIM]; /* in the world; in B */
} sizing;

static void close_sizing(sizing *z)
{
    fmb_pair_free(z->tightest);
    fmb_pair_free(z->usual);
    study_article_free(z->article);
}

static fmb_status open_sizing(sizing *z, int dim, fmb_simd simd)
{
    fmb_pair_options o = {.size = sizeof o};
    *z = (sizing){0};
    o.simd = simd;
    fmb_status st = fmb_pair_new(dim, &o, NULL, &z->usual);
    o.tightest = true;
    if (st == FMB_OK)
        st = fmb_pair_new(dim, &o, NULL, &z->tightest);
    if (st == FMB_OK)
        st = study_article_new(&z->article);
    return st;
}

static void copy_box(const double (*from)[2], int dim, double *to)
{
    for (int j = 0; j < dim; j++) {
        to[2 * j] = from[j][0];
        to[2 * j + 1] = from[j][1];
    }
}

/* If the article finds no common point, its boxes are empty. */
static fmb_status ask_article(sizing *z, const fmb_frame *p, const fmb_frame *q)
{
    static const boxes_kind WORLD[2] = {BOXES_ARTICLE, BOXES_MENDED},
                            INSIDE[2] = {BOXES_ARTICLE_INSIDE, BOXES_MENDED_INSIDE};
    fmb_status st = FMB_OK;
    for (int kind = 0; st == FMB_OK && kind < 2; kind++) {
        study_article_box box = {0};
        fmb_verdict verdict;
        st = study_article_test(z->article, p, q, (study_article_box_kind)kind, &box, &verdict);
        copy_box((const double(*)[2])box.world, p->dim, z->box[WORLD[kind]]);
        copy_box((const double(*)[2])box.inside, p->dim, z->box[INSIDE[kind]]);
    }
    return st;
}

static fmb_status ask(sizing *z, const fmb_frame *p, const fmb_frame *q)
{
    double other[2 * MOST_DIM];
    fmb_verdict verdict;
    fmb_status st = fmb_pair_test(z->tightest, 1, p, q,
                                  &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                                      .verdict = &verdict,
                                                      .world = z->tight[0],
                                                      .inside = z->tight[1]});
    if (st == FMB_OK)
        st = fmb_pair_test(z->usual, 1, p, q,
                           &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                               .verdict = &verdict,
                                               .world = z->box[BOXES_OURS],
                                               .inside = z->box[BOXES_OURS_INSIDE]});
    if (st == FMB_OK)
        st = ask_article(z, p, q);
    study_aabb_of(p, z->box[BOXES_AABBS]);
    study_aabb_of(q, other);
    study_aabb_meet(p->dim, z->box[BOXES_AABBS], other, z->box[BOXES_AABBS]);
    study_aabb_meet(p->dim, z->box[BOXES_AABBS], z->box[BOXES_ARTICLE], z->box[BOXES_CLIPPED]);
    return st;
}

/* Take the boxes into account. Ours have no slack. */
static void note(const sizing *z, const fmb_frame *p, const fmb_frame *q, boxes_sizes *out)
{
    int dim = p->dim;
    double scale = fmax(study_aabb_scale(p), study_aabb_scale(q));
    double volume[2] = {study_aabb_volume(dim, z->tight[0]), study_aabb_volume(dim, z->tight[1])};
    bool ours_hold = study_aabb_holds(dim, z->box[BOXES_OURS], z->tight[0], 0) &&
                     study_aabb_holds(dim, z->box[BOXES_OURS_INSIDE], z->tight[1], 0);
    out->wrong +=
        !ours_hold || !study_aabb_holds(dim, z->tight[0], z->box[BOXES_OURS], allowed * scale);
    if (!(volume[0] > 0 && volume[1] > 0))
        return;
    for (int kind = 0; kind < BOXES_KINDS; kind++) {
        bool inside = kind >= BOXES_WORLD, ours = kind == BOXES_OURS || kind == BOXES_OURS_INSIDE;
        double slack = ours ? 0 : allowed * (inside ? 1 : scale);
        out->ratio[kind][out->n] = study_aabb_volume(dim, z->box[kind]) / volume[inside];
        out->holds[kind] += study_aabb_holds(dim, z->box[kind], z->tight[inside], slack);
    }
    out->n++;
}

fmb_status boxes_measure(const study_pairs *pairs, fmb_simd simd, boxes_sizes *out)
{
    size_t n = pairs->n < MOST_SIZED ? pairs->n : MOST_SIZED;
    sizing z;
    *out = (boxes_sizes){0};
    for (int kind = 0; kind < BOXES_KINDS; kind++)
        out->ratio[kind] = app_need(malloc(n * sizeof *out->ratio[kind]));
    fmb_status st = open_sizing(&z, pairs->p[0].dim, simd);
    for (size_t i = 0; st == FMB_OK && i < n && !out->interrupted; i++) {
        out->interrupted = !qualify_watch_step_within(NULL, i, n);
        st = ask(&z, &pairs->p[i], &pairs->q[i]);
        if (st == FMB_OK)
            note(&z, &pairs->p[i], &pairs->q[i], out);
    }
    close_sizing(&z);
    if (st != FMB_OK)
        boxes_sizes_clear(out);
    return st;
}

void boxes_sizes_clear(boxes_sizes *s)
{
    for (int kind = 0; kind < BOXES_KINDS; kind++)
        free(s->ratio[kind]);
}

/* ---- times ----------------------------------------------------------------------------------- */

typedef struct timing {
    const study_pairs *pairs;
    fmb_pair *k;
    fmb_pair_answers out;
} timing;

static fmb_status run(void *self, size_t first, size_t n)
{
    timing *t = self;
    size_t dim = (size_t)t->pairs->p[0].dim;
    fmb_pair_answers out = t->out;
    out.verdict += first;
    if (out.world) {
        out.world += 2 * dim * first;
        out.inside += 2 * dim * first;
        out.time += 2 * first;
        out.witness += dim * first;
    }
    return fmb_pair_test(t->k, n, t->pairs->p + first, t->pairs->q + first, &out);
}

fmb_status boxes_time(const study_pairs *pairs, const qualify_setup *o, study_clock *out)
{
    size_t n = pairs->n, dim = (size_t)pairs->p[0].dim;
    fmb_pair_options options = {.size = sizeof options};
    fmb_pair *k = NULL;
    fmb_verdict *verdict = app_need(malloc(n * sizeof *verdict));
    double *number = app_need(malloc(n * (5 * dim + 2) * sizeof *number));
    timing alone = {pairs, NULL, {.size = sizeof(fmb_pair_answers), .verdict = verdict}},
           all = {pairs,
                  NULL,
                  {.size = sizeof(fmb_pair_answers),
                   .verdict = verdict,
                   .world = number,
                   .inside = number + 2 * dim * n,
                   .time = number + 4 * dim * n,
                   .witness = number + (4 * dim + 2) * n}};
    const study_timed way[2] = {{run, &alone}, {run, &all}};
    options.simd = o->simd;
    fmb_status st = fmb_pair_new((int)dim, &options, NULL, &k);
    alone.k = all.k = k;
    *out = (study_clock){.way = way,
                         .ways = 2,
                         .queries = n,
                         .groups = 1,
                         .passes = o->passes,
                         .max_seconds = 3,
                         .step = qualify_watch_step_within};
    if (st == FMB_OK)
        st = study_clock_run(out);
    out->way = NULL;
    fmb_pair_free(k);
    free(verdict);
    free(number);
    return st;
}
