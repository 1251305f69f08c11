/* main.c: do FMB, separating axes and the exact way agree on random pairs of frames? */
#include <stdlib.h>

#include <fmb/base.h>

#include "common/file.h"
#include "common/json.h"
#include "common/message.h"
#include "common/need.h"
#include "common/ranks.h"
#include "fmb-validate/report.h"

enum { SHOWN = 10 }; /* disagreements, where no file was asked for */

/* One a line. */
static void write_line(json_t *obj, FILE *out)
{
    if (json_dumpf(obj, out, JSON_COMPACT) != 0 && !ferror(out))
        exit(app_status_error(FMB_ERR_MEMORY));
    fputc('\n', out);
    json_decref(obj);
}

static void write_failures(const validate_plan *p, uint64_t most, FILE *out)
{
    uint64_t n = 0;
    for (size_t i = 0; i < p->jobs; i++)
        for (size_t k = 0; k < p->job[i].findings.n && n < most; k++, n++)
            write_line(validate_failure(&p->job[i], &p->job[i].findings.item[k]), out);
}

/* The files that were asked for, or NULL. */
typedef struct files {
    FILE *json, *failures;
} files;

/* Before the run: one that cannot be written must not cost an hour. */
static int open_files(const validate_plan *p, files *f)
{
    int code = p->json ? app_file_create(p->json, &f->json) : APP_YES;
    if (p->failures && code == APP_YES)
        code = app_file_create(p->failures, &f->failures);
    return code;
}

static int close_files(const validate_plan *p, files *f)
{
    int code = app_file_close(f->json, p->json);
    return app_first_code(code, app_file_close(f->failures, p->failures));
}

static int report(const validate_plan *p, const files *f)
{
    uint64_t wrong = validate_disagreements(p);
    bool only_json = f->json == stdout;
    if (!only_json)
        validate_table(p);
    if (!only_json && !f->failures)
        write_failures(p, SHOWN, stdout);
    if (f->json)
        write_line(validate_json(p), f->json);
    if (f->failures)
        write_failures(p, UINT64_MAX, f->failures);
    if (wrong > 0)
        return app_error(APP_NO, "%llu pairs with answers that differ", (unsigned long long)wrong);
    return p->complete ? APP_YES : APP_UNDECIDED;
}

static int ask_pairs(validate_plan *p)
{
    fmb_status st = validate_run(p);
    if (st == FMB_OK)
        return APP_YES;
    return app_ranks_fail(app_status_error(st));
}

static int run(validate_plan *p, const files *f)
{
    int code = p->merge ? validate_merge(p) : ask_pairs(p);
    if (code == APP_YES)
        code = report(p, f);
    return code;
}

/* Rank 0. */
static int answer(validate_plan *p)
{
    files f = {NULL, NULL};
    int code = app_ranks_agree(open_files(p, &f));
    if (code == APP_YES)
        code = run(p, &f);
    return app_first_code(close_files(p, &f), code);
}

/* Any other rank. */
static int help(validate_plan *p)
{
    int code = APP_YES;
    if (app_ranks_agree(code) == APP_YES && !p->merge)
        code = ask_pairs(p);
    return code;
}

static void print_version(FILE *out, struct argp_state *state)
{
    fprintf(out, "%s %s\n", state->name, fmb_version());
}

int main(int argc, char **argv)
{
    validate_plan plan;
    argp_program_version_hook = print_version;
    argp_err_exit_status = APP_USAGE;
    app_file_guard_output();
    app_need_limbs();
    validate_plan_init(&plan);
    argp_parse(&validate_argp, argc, argv, 0, NULL, &plan);
    int code = app_ranks_begin(VALIDATE_MOST_JOBS);
    if (code != APP_YES)
        return code;
    code = app_rank() == 0 ? answer(&plan) : help(&plan);
    validate_clear(&plan);
    app_ranks_end();
    return code;
}
