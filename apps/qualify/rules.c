/* rules.c: fmb-qualify rules. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/file.h"
#include "common/json.h"
#include "common/message.h"
#include "qualify/commands.h"
#include "qualify/counts.h"
#include "qualify/report.h"
#include "qualify/watch.h"

static int make_folder(const char *path)
{
    if (!path || mkdir(path, 0777) == 0 || errno == EEXIST)
        return APP_YES;
    return app_error(APP_CANNOT_WRITE, "%s: %s", path, strerror(errno));
}

static int write_json(const qualify_plan *p)
{
    FILE *f = NULL;
    char *path;
    int code = qualify_create(p, "report.json", &f, &path);
    if (code == APP_YES) {
        json_t *obj = qualify_json(p);
        bool failed = json_dumpf(obj, f, JSON_INDENT(2)) != 0;
        json_decref(obj);
        fputc('\n', f);
        code = app_file_close(f, path);
        if (code == APP_YES && failed)
            code = app_status_error(FMB_ERR_MEMORY);
    }
    free(path);
    return code;
}

static int write_folder(const qualify_plan *p)
{
    int code = qualify_write_csv(p);
    if (code == APP_YES)
        code = write_json(p);
    return code == APP_YES ? qualify_write_plots(p) : code;
}

static void print_title(const qualify_plan *p)
{
    const study_grid *g = &p->grid;
    printf("fmb-qualify rules, fmb %s: ", fmb_version());
    if (p->files == 0 || p->frames_asked)
        printf("%s frames, %zu pairs of each class, seed %lu, ", study_family_text(p->family),
               g->per_class, g->seed);
    if (p->files > 0)
        printf("%zu files, ", p->files);
    printf("at most %zu rows, presolve %s\n", g->limits.max_rows, g->limits.presolve);
    if (g->complete < g->samples)
        printf("Interrupted after %zu of %zu classes.\n", g->complete, g->samples);
}

static int report(const qualify_plan *p)
{
    int code = APP_YES;
    if (p->json) {
        app_json_print(qualify_json(p));
    } else {
        print_title(p);
        qualify_tables(p);
        if (p->files == 0 && !qualify_watch_interrupted())
            code = qualify_counts(p);
        qualify_claims(p);
    }
    int written = p->out ? write_folder(p) : APP_YES;
    return written != APP_YES ? written : code;
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

static int study(qualify_plan *p)
{
    int code = qualify_plan_make(p);
    if (code != APP_YES)
        return code;
    p->grid.step = qualify_watch_step;
    p->grid.running = qualify_watch_solver();
    fmb_status st = study_grid_run(&p->grid);
    if (st != FMB_OK)
        return app_status_error(st);
    code = report(p);
    return code != APP_YES ? code : judge(p);
}

int qualify_rules(int argc, char **argv)
{
    qualify_plan *p = app_need(malloc(sizeof *p));
    qualify_plan_init(p);
    argp_parse(&qualify_plan_argp, argc, argv, 0, NULL, p);
    int code = make_folder(p->out);
    if (code == APP_YES) {
        qualify_watch_begin(p->quiet);
        code = p->counts ? qualify_counts(p) : study(p);
        qualify_watch_end();
    }
    study_grid_clear(&p->grid);
    free(p);
    return code;
}
