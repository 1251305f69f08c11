/* article.c: the study: all cells of the article's Table 1; see article.h. */
#include "fmb-qualify/article/article.h"

#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/watch.h"

enum { CELLS = 24 };

static size_t count_wrong_of_ours(const article_cell *cell, size_t n)
{
    size_t wrong = 0;
    for (size_t i = 0; i < n; i++)
        wrong += cell[i].duel[ARTICLE_ASKED].wrong + cell[i].duel[ARTICLE_PACKED].wrong;
    return wrong;
}

static int run_article(const qualify_setup *o, qualify_page *page)
{
    article_cell *cell = app_need(calloc(CELLS, sizeof *cell));
    size_t n = 0;
    fmb_status st = FMB_OK;
    for (int i = 0; st == FMB_OK && i < CELLS && !qualify_watch_interrupted(); i++) {
        verdict_class c = {2 + i / 6 % 2, i / 12, i % 2 == 0, (verdict_kind)(i / 2 % 3)};
        qualify_watch_part((size_t)i, CELLS);
        st = article_cell_run(&c, o, &cell[n]);
        n += cell[n].complete;
    }
    int code = st == FMB_OK ? APP_YES : app_status_error(st);
    if (st == FMB_OK)
        article_report(cell, n, page);
    size_t wrong = count_wrong_of_ours(cell, n);
    free(cell);
    return wrong > 0 ? app_error(APP_NO, "%zu verdicts differ", wrong) : code;
}

const qualify_study qualify_study_article = {
    .name = "article",
    .title = "the article's Table 1: as published, its program's two ways, and ours",
    .doc = "The time of FMB over that of SAT in the 24 cells of the article's Table 1: as "
           "published; of its program's algorithms, written again at the same cost, by its method "
           "(each pair again and again) and on distinct pairs; of this library, from frames and "
           "on sets of frames. And what choosing between FMB and SAT would gain.",
    .alone = {16384, 5},
    .brief = {4096, 3},
    .run = run_article,
};
