/* wrong.c: the first wrong answer of a study, and a minimal system that shows it. */
#include "study/grid/wrong.h"

#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/rules/files.h"
#include "fmb-qualify/rules/report.h"

static bool is_wrong_run(const study_run *r)
{
    return r->outcome == STUDY_WRONG || r->solved == STUDY_WRONG;
}

/* The first wrong run; false if there is none. */
static bool find_wrong(const study_grid *g, size_t *sample, size_t *item, size_t *way)
{
    for (size_t k = 0; k < g->complete; k++)
        for (size_t i = 0; i < g->sample[k].size; i++)
            for (size_t w = 0; w < g->ways; w++)
                if (is_wrong_run(study_grid_at(g, k, i, w))) {
                    *sample = k;
                    *item = i;
                    *way = w;
                    return true;
                }
    return false;
}

static void put_text(FILE *f, const void *text)
{
    fputs(text, f);
}

static const qualify_column ROW[] = {{"row", "row", NULL}, {0}};

static void show_system(qualify_page *page, const char *text)
{
    json_t *rows = json_array();
    char *copy = app_need(strdup(text)), *rest = copy, *line;
    while ((line = strsep(&rest, "\n")) != NULL)
        if (*line) {
            json_t *row = json_object();
            app_json_set(row, "row", app_json_text(line));
            app_json_append(rows, row);
        }
    free(copy);
    app_json_set(qualify_page_json(page), "wrong_system", rows);
    qualify_page_table(page, "wrong", "A system that goes wrong", ROW, "wrong_system");
    qualify_page_file(page, "wrong.fmb", put_text, text);
}

void qualify_show_wrong(const qualify_plan *p, qualify_page *page)
{
    size_t k, i, w;
    if (p->part || !find_wrong(&p->grid, &k, &i, &w))
        return;
    fmb_system *s = NULL;
    const study_case *c = &p->grid.sample[k].item[i];
    if (study_smallest_wrong(c, &p->way[w], &p->grid.limits, &s) != FMB_OK || !s)
        return;
    char *text = qualify_system_text(s, c);
    qualify_page_text(page,
                      "Wrong: rules %s in order %s, asked for a verdict, or for the projection on "
                      "the kept variables. The system that shows it, with only the rows that it "
                      "needs:",
                      p->way[w].name, qualify_order_of(p, w)->name);
    show_system(page, text);
    free(text);
    fmb_system_free(s);
}
