/* ours.c: the library itself, and the algorithms of bench/study, as drivers. */
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/peers/peer.h"
#include "study/rivals/article.h"
#include "study/rivals/gpr.h"
#include "study/rivals/seidel.h"
#include "study/sat/sat.h"

typedef struct ours {
    peer_work work;
    fmb_pair *k;
    study_article *article;
    uint64_t random;
} ours;

static fmb_status open_work(const peer_work *w, void **self)
{
    ours *s = app_need(calloc(1, sizeof *s));
    s->work = *w;
    s->random = 1;
    *self = s;
    return FMB_OK;
}

static void close_ours(void *self)
{
    ours *s = self;
    fmb_pair_free(s->k);
    study_article_free(s->article);
    free(s);
}

/* ---- the library ----------------------------------------------------------------------------- */

static fmb_status open_fmb(const peer_work *w, void **self)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_status st = open_work(w, self);
    ours *s = *self;
    o.simd = w->simd;
    return st == FMB_OK ? fmb_pair_new(3, &o, NULL, &s->k) : st;
}

static fmb_status open_sat(const peer_work *w, void **self)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_status st = open_work(w, self);
    ours *s = *self;
    o.simd = w->simd;
    return st == FMB_OK ? study_sat_new(3, &o, &s->k) : st;
}

static fmb_status ask_pair(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    ours *s = self;
    return fmb_pair_test(s->k, n, s->work.p + first, s->work.q + first,
                         &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = verdict});
}

const peer_driver peer_fmb = {.name = "FMB",
                              .how = "this library, all pairs in one call",
                              .open = open_fmb,
                              .ask = ask_pair,
                              .close = close_ours};
const peer_driver peer_sat = {.name = "SAT",
                              .how = "separating axes (bench/study), all pairs in one call",
                              .open = open_sat,
                              .ask = ask_pair,
                              .close = close_ours};

/* ---- the algorithms of bench/study -------------------------------------------------------------
 */

static fmb_status open_article(const peer_work *w, void **self)
{
    fmb_status st = open_work(w, self);
    ours *s = *self;
    return st == FMB_OK ? study_article_new(&s->article) : st;
}

static fmb_status ask_article(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    ours *s = self;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        st = study_article_test(s->article, &s->work.p[first + i], &s->work.q[first + i],
                                STUDY_ARTICLE_PUBLISHED, NULL, &verdict[i]);
    return st;
}

static fmb_status ask_seidel(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    ours *s = self;
    for (size_t i = 0; i < n; i++)
        verdict[i] = study_seidel_decide(&s->work.p[first + i], &s->work.q[first + i], &s->random);
    return FMB_OK;
}

static fmb_status ask_tetra(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    ours *s = self;
    for (size_t i = 0; i < n; i++)
        verdict[i] = study_gpr_meet(&s->work.p[first + i], &s->work.q[first + i]) ? FMB_FEASIBLE
                                                                                  : FMB_INFEASIBLE;
    return FMB_OK;
}

const peer_driver peer_article = {.name = "article",
                                  .how = "FMB as published, for any dimension (bench/study)",
                                  .open = open_article,
                                  .ask = ask_article,
                                  .close = close_ours};
const peer_driver peer_seidel = {.name = "Seidel",
                                 .how = "randomised linear program on the rows (bench/study)",
                                 .open = open_work,
                                 .ask = ask_seidel,
                                 .close = close_ours};
const peer_driver peer_tetra = {.name = "Ganovelli",
                                .how = "tetrahedra by Ganovelli, Ponchio, Rocchini (bench/study)",
                                .takes = PEER_TAKES_SIMPLICES,
                                .open = open_work,
                                .ask = ask_tetra,
                                .close = close_ours};
