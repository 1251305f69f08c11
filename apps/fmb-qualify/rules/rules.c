/* rules.c: fmb-qualify rules. */
#include <stdlib.h>

#include "common/message.h"
#include "common/ranks.h"
#include "fmb-qualify/rules/counts.h"
#include "fmb-qualify/rules/report.h"
#include "fmb-qualify/share.h"
#include "fmb-qualify/watch.h"

static void add_title(const qualify_plan *p, qualify_page *page)
{
    const study_grid *g = &p->grid;
    char *text;
    size_t size;
    FILE *f = app_need(open_memstream(&text, &size));
    if (p->files == 0 || p->frames_asked)
        fprintf(f, "%s frames, %zu pairs of each class, seed %lu, ", study_family_text(p->family),
                g->per_class, g->seed);
    if (p->files > 0)
        fprintf(f, "%zu files, ", p->files);
    fprintf(f, "at most %zu rows, presolve %s", g->limits.max_rows, g->limits.presolve);
    fclose(f);
    qualify_page_text(page, "%s", text);
    free(text);
    if (g->complete < g->samples)
        qualify_page_text(page, "Interrupted after %zu of %zu classes.", g->complete, g->samples);
}

static int report(const qualify_plan *p, qualify_page *page)
{
    int code = APP_YES;
    add_title(p, page);
    qualify_numbers(p, page);
    qualify_tables(p, page);
    if (!p->json && !p->brief && p->files == 0 && p->shards == 0 && !p->part &&
        !qualify_watch_interrupted())
        code = qualify_counts(p, page);
    qualify_claims(p, page);
    qualify_runs_csv(p, page);
    qualify_show_wrong(p, page);
    return code;
}

static int judge(const qualify_plan *p)
{
    size_t wrong = qualify_wrong(p);
    if (p->grid.rejected > 0)
        return app_error(APP_INTERNAL, "%zu exact answers failed their check", p->grid.rejected);
    if (wrong > 0)
        return app_error(APP_NO, "%zu wrong answers", wrong);
    return qualify_watch_interrupted() ? APP_UNDECIDED : APP_YES;
}

static int study(qualify_plan *p, qualify_page *page)
{
    p->grid.step = qualify_watch_step;
    p->grid.running = qualify_watch_solver();
    fmb_status st = p->part ? FMB_OK : study_grid_run(&p->grid);
    if (st == FMB_ERR_ARG && p->library.chooser)
        return app_rule_library_refuse_choice(p->rule_library);
    if (st != FMB_OK)
        return app_status_error(st);
    if (p->shards > 0)
        qualify_runs_json(p, qualify_page_json(page));
    int code = report(p, page);
    return code != APP_YES ? code : judge(p);
}

static int run_page(qualify_plan *p)
{
    qualify_watch_begin(p->quiet);
    qualify_page *page = qualify_page_open(p->out, p->json);
    int code = APP_YES;
    if (qualify_page_is_good(page)) {
        qualify_page_begin(page, qualify_study_rules.name, qualify_study_rules.title);
        qualify_watch_name(qualify_study_rules.name);
        code = p->counts ? qualify_counts(p, page) : study(p, page);
        qualify_page_end(page);
    }
    int written = qualify_page_close(page);
    qualify_watch_end();
    return code != APP_YES ? code : written;
}

static int run_merged(const qualify_plan *p)
{
    qualify_plan *all = app_need(malloc(sizeof *all));
    int code = qualify_plan_merge(p, all);
    if (code == APP_YES)
        code = run_page(all);
    qualify_plan_clear(all);
    free(all);
    return code;
}

int qualify_rules(int argc, char **argv)
{
    qualify_plan *p = app_need(malloc(sizeof *p));
    qualify_plan_init(p);
    argp_parse(&qualify_plan_argp, argc, argv, 0, NULL, p);
    int code = qualify_join_ranks();
    bool joined = code == APP_YES, works = joined && app_rank() == 0;
    if (works && !p->counts && !p->merge)
        code = qualify_plan_make(p);
    if (works && code == APP_YES)
        code = p->merge ? run_merged(p) : run_page(p);
    code = joined ? qualify_leave_ranks(code) : code;
    qualify_plan_clear(p);
    free(p);
    return code;
}

/* As one of all studies: small frames of two to four dimensions, the sets of rules that differ
 * most. */
static int run_brief(const qualify_setup *o, qualify_page *page)
{
    static const char *const SETS[] = {"kohler", "chernikov", "imbert", "kohler,box"};
    qualify_plan *p = app_need(malloc(sizeof *p));
    qualify_plan_init(p);
    p->dim[5] = p->dim[6] = false;
    p->orders = 1;
    p->grid.per_class = o->pairs;
    p->grid.passes = o->passes;
    p->grid.seed = (unsigned long)o->seed;
    p->grid.limits.max_rows = 2000;
    p->brief = true;
    for (size_t i = 0; i < sizeof SETS / sizeof *SETS; i++)
        p->set[p->sets++] = SETS[i];
    int code = qualify_plan_make(p);
    if (code == APP_YES)
        code = study(p, page);
    qualify_plan_clear(p);
    free(p);
    return code;
}

const qualify_study qualify_study_rules = {
    .name = "rules",
    .title = "which pruning rules pay, and from which dimension on",
    .alone = {16, 3},
    .brief = {8, 3},
    .run = run_brief,
};
