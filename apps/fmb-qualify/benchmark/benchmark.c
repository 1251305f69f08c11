/* benchmark.c: fmb-qualify benchmark: the benchmark of the field, in a folder. */
#include <argp.h>
#include <stdlib.h>
#include <string.h>

#include "common/json.h"
#include "common/message.h"
#include "common/value.h"
#include "fmb-qualify/benchmark/answer.h"
#include "fmb-qualify/benchmark/readme.h"
#include "fmb-qualify/folder.h"
#include "fmb-qualify/study.h"
#include "fmb-qualify/watch.h"

typedef struct plan {
    const char *folder;
    bool *family; /* [families] which */
    bool quiet;
} plan;

/* One problem and its answer. */
typedef struct entry {
    char name[STUDY_BENCHMARK_NAME];
    int family, size, instance;
    study_projection problem;
    qualify_answer answer;
} entry;

/* ---- what is written ------------------------------------------------------------------------- */

static void put_system(FILE *f, const void *what)
{
    const entry *e = what;
    fprintf(f, "* %s %s\n", STUDY_BENCHMARK_VERSION, e->name);
    if (fmb_system_write(e->problem.s, FMB_FORMAT_INE, f) == FMB_ERR_MEMORY)
        app_need(NULL);
}

static void put_facts(FILE *f, const void *what)
{
    const entry *e = what;
    const qualify_answer *a = &e->answer;
    json_t *obj = json_object(), *answer = json_object();
    app_json_set(obj, "version", json_string(STUDY_BENCHMARK_VERSION));
    app_json_set(obj, "name", json_string(e->name));
    app_json_set(obj, "family", json_string(study_benchmark_name(e->family)));
    app_json_set(obj, "field", json_string(study_benchmark_field(e->family)));
    app_json_set(obj, "size", json_integer(e->size));
    app_json_set(obj, "instance", json_integer(e->instance));
    app_json_set(obj, "variables", json_integer(fmb_system_dim(e->problem.s)));
    app_json_set(obj, "rows", json_integer((json_int_t)fmb_system_rows(e->problem.s)));
    app_json_set(obj, "kept", json_integer(e->problem.keep));
    app_json_set(answer, "verdict", json_string(fmb_verdict_text(a->verdict)));
    if (e->problem.keep > 0) {
        app_json_set(answer, "equations", json_integer((json_int_t)a->equations));
        app_json_set(answer, "inequalities", json_integer((json_int_t)a->inequalities));
        app_json_set(answer, "strict", json_integer((json_int_t)a->strict));
    }
    app_json_set(answer, "sha256", json_string(a->digest));
    app_json_set(answer, "proved", json_true());
    app_json_set(obj, "answer", answer);
    if (json_dumpf(obj, f, JSON_INDENT(2) | JSON_PRESERVE_ORDER) != 0 && !ferror(f))
        app_need(NULL);
    fputc('\n', f);
    json_decref(obj);
}

static void put_line(FILE *f, const entry *e)
{
    const qualify_answer *a = &e->answer;
    fprintf(f, "%s,%s,%s,%d,%d,%zu,%d,%d,%s,", e->name, study_benchmark_name(e->family),
            study_benchmark_field(e->family), e->size, e->instance, fmb_system_rows(e->problem.s),
            fmb_system_dim(e->problem.s), e->problem.keep, fmb_verdict_text(a->verdict));
    if (e->problem.keep > 0)
        fprintf(f, "%zu,%zu,%zu,", a->equations, a->inequalities, a->strict);
    else
        fputs(",,,", f);
    fprintf(f, "%s\n", a->digest);
}

static int write_entry(const plan *p, const entry *e, const char *ending,
                       void (*put)(FILE *f, const void *what))
{
    char *file;
    if (asprintf(&file, "%s.%s", e->name, ending) < 0)
        app_need(NULL);
    int code = qualify_folder_write(p->folder, file, put, e);
    free(file);
    return code;
}

/* ---- all of it ------------------------------------------------------------------------------- */

static int make_entry(const plan *p, fmb_solver *v, entry *e, FILE *manifest)
{
    study_benchmark_problem_name(e->family, e->size, e->instance, e->name);
    fmb_status st = study_benchmark_draw(e->family, e->size, e->instance, &e->problem);
    if (st != FMB_OK)
        return app_status_error(st);
    int code = qualify_answer_find(v, e->name, &e->problem, &e->answer);
    if (code == APP_YES)
        code = write_entry(p, e, "ine", put_system);
    if (code == APP_YES)
        code = write_entry(p, e, "json", put_facts);
    if (code == APP_YES)
        put_line(manifest, e);
    fmb_system_free(e->problem.s);
    return code;
}

static int make_entries(const plan *p, fmb_solver *v, FILE *manifest)
{
    enum { OF_FAMILY = STUDY_BENCHMARK_SIZES * STUDY_BENCHMARK_INSTANCES };
    int all = study_benchmark_families() * OF_FAMILY, code = APP_YES;
    for (int k = 0; code == APP_YES && k < all; k++) {
        entry e = {.family = k / OF_FAMILY,
                   .size = k % OF_FAMILY / STUDY_BENCHMARK_INSTANCES + 1,
                   .instance = k % STUDY_BENCHMARK_INSTANCES + 1};
        if (!qualify_watch_step(NULL, (size_t)k, (size_t)all))
            return APP_UNDECIDED;
        if (p->family[e.family])
            code = make_entry(p, v, &e, manifest);
    }
    return code;
}

static void put_text(FILE *f, const void *what)
{
    fputs(what, f);
}

/* The manifest is written last: if it exists, the folder is complete. */
static int make_folder(const plan *p, fmb_solver *v)
{
    char *text = NULL;
    size_t size;
    FILE *manifest = app_need(open_memstream(&text, &size));
    fputs(
        "name,family,field,size,instance,rows,variables,kept,verdict,equations,inequalities,strict,"
        "sha256\n",
        manifest);
    int code = make_entries(p, v, manifest);
    fclose(manifest);
    if (code == APP_YES)
        code = qualify_folder_write(p->folder, "README.md", qualify_put_readme, NULL);
    if (code == APP_YES)
        code = qualify_folder_write(p->folder, "manifest.csv", put_text, app_need(text));
    free(text);
    return code;
}

static int run(const plan *p)
{
    fmb_options o = {.size = sizeof o, .evidence = FMB_EVIDENCE_WHOLE};
    fmb_solver *v = NULL;
    fmb_status st = fmb_solver_new(&o, NULL, &v);
    if (st != FMB_OK)
        return app_status_error(st);
    int code = qualify_folder_make(p->folder);
    if (code == APP_YES) {
        qualify_watch_begin(p->quiet);
        qualify_watch_name("benchmark");
        *qualify_watch_solver() = v;
        code = make_folder(p, v);
        qualify_watch_end();
    }
    fmb_solver_free(v);
    return code;
}

/* ---- the command line ------------------------------------------------------------------------ */

static bool *asked; /* plan.family while its words are read */

static void ask_family(const char *word, struct argp_state *state)
{
    int f = study_benchmark_find(word);
    if (f < 0)
        argp_error(state, "--families: expected families of the benchmark, found '%s'", word);
    else
        asked[f] = true;
}

static const struct argp_option options[] = {
    {"families", 'f', "WORD,...", 0, "Only these families [all]", 1},
    {"quiet", 'q', NULL, 0, "No progress bar", 2},
    {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    plan *p = state->input;
    switch (key) {
    case 'f':
        app_value_each("--families", arg, ask_family, state);
        return 0;
    case 'q':
        p->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (p->folder)
            argp_error(state, "expected one folder, found '%s'", arg);
        p->folder = arg;
        return 0;
    case ARGP_KEY_END:
        if (!p->folder)
            argp_error(state, "expected a folder");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] = "Write the benchmark " STUDY_BENCHMARK_VERSION
                          " into the folder DIR: 600 systems as .ine, what is known of "
                          "each as JSON, README.md and manifest.csv. Every answer is proved."
                          "\v"
                          "The same bytes on every machine. It takes about half a minute.\n"
                          "\n"
                          "Examples:\n"
                          "  fmb-qualify benchmark FMB-2026.1\n"
                          "  fmb-qualify benchmark --families relu,control some\n";

int qualify_benchmark(int argc, char **argv)
{
    const struct argp whole_line = {options, parse, "DIR", doc, NULL, NULL, NULL};
    size_t families = (size_t)study_benchmark_families();
    plan p = {.family = app_need(calloc(families, sizeof *p.family))};
    asked = p.family;
    argp_parse(&whole_line, argc, argv, 0, NULL, &p);
    if (!memchr(p.family, true, families))
        memset(p.family, true, families);
    int code = run(&p);
    free(p.family);
    return code;
}
