/* article.c: the study: all cells of the article's Table 1; see article.h. */
#include "fmb-qualify/article/article.h"

#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/share.h"

enum { CELLS = 24 };

static size_t count_wrong_of_ours(const article_cell *cell, size_t n)
{
    size_t wrong = 0;
    for (size_t i = 0; i < n; i++)
        wrong += cell[i].duel[ARTICLE_ASKED].wrong + cell[i].duel[ARTICLE_PACKED].wrong;
    return wrong;
}

/* Reports the complete cells. */
static int report_cells(article_cell *cell, qualify_page *page)
{
    size_t n = 0;
    for (size_t i = 0; i < CELLS; i++)
        if (cell[i].complete)
            cell[n++] = cell[i];
    article_report(cell, n, page);
    size_t wrong = count_wrong_of_ours(cell, n);
    return wrong > 0 ? app_error(APP_NO, "%zu verdicts differ", wrong) : APP_YES;
}

static int run_article(const qualify_setup *o, qualify_page *page)
{
    article_cell *cell = app_need(calloc(CELLS, sizeof *cell));
    fmb_status st = FMB_OK;
    qualify_share share = qualify_share_begin(o, CELLS);
    for (size_t i; st == FMB_OK && qualify_share_next(&share, &i);) {
        verdict_class c = {2 + (int)i / 6 % 2, i / 12, i % 2 == 0, (verdict_kind)(i / 2 % 3)};
        st = article_cell_run(&c, o, &cell[i]);
    }
    if (st == FMB_OK)
        qualify_share_collect(&share, cell, sizeof *cell);
    bool reports = qualify_share_end(&share);
    int code = st != FMB_OK ? app_status_error(st) : reports ? report_cells(cell, page) : APP_YES;
    free(cell);
    return code;
}

const qualify_study qualify_study_article = {
    .name = "article",
    .title = "the article's Table 1: as published, its program's two ways, and ours",
    .doc = "The time of FMB over that of SAT in the 24 cells of the article's Table 1: as "
           "published; of its program's algorithms, written again at the same cost, by its method "
           "(each pair again and again) and on distinct pairs; of this library, from frames and "
           "on sets of frames. And what choosing between FMB and SAT would gain.",
    .shared = true,
    .alone = {16384, 5},
    .brief = {4096, 3},
    .run = run_article,
};
