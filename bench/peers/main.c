/* main.c: fmb beside other libraries, problem by problem. See ../README.md. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "bars.h"
#include "polytope.h"
#include "report.h"
#include "study/program/projection.h"

static const char USAGE[] =
    "usage: bench-peers [--decide | --vertices | --hull] [--drivers A,B] [--seconds S] [--bytes "
    "B]\n"
    "                   [--set NAME=VALUE] [--json FILE] [--quick] [--bars] [--methods]\n"
    "                   [--all-answer] [--list] [--families | --unseen] [--seed N] [--each N]\n"
    "                   FILE... | manifest.txt... | FAMILY:SIZE[:ROWS]...\n";

typedef struct setup {
    report report;
    fmb_options options;
    const char *json, *drivers;
    bool quick, list, all_answer, bars, methods;
    char **path; /* problems, owned */
    size_t paths;
    bool families, unseen; /* draw problems of families; of unseen families (projection.h) */
    uint64_t seed, each;
} setup;

/* ---- what to run ----------------------------------------------------------------------------- */

static void add_path(setup *s, const char *path)
{
    s->path = need(realloc(s->path, (s->paths + 1) * sizeof *s->path));
    s->path[s->paths++] = need(strdup(path));
}

/* The problems of a manifest: the first word of each line is a family's, or the name of a file
 * beside it. */
static bool add_manifest(setup *s, const char *path)
{
    FILE *in = fopen(path, "r");
    char line[512], name[128], file[1024];
    const char *slash = strrchr(path, '/');
    int folder = slash ? (int)(slash - path) + 1 : 0;
    if (!in)
        return false;
    while (fgets(line, sizeof line, in)) {
        if (line[0] == '#' || sscanf(line, "%127s", name) != 1)
            continue;
        snprintf(file, sizeof file, "%.*s%s.ine", folder, path, name);
        add_path(s, strchr(name, ':') ? name : file);
    }
    fclose(in);
    return true;
}

/* All able drivers: fmb always, its single methods with --methods, peers by request. */
static void choose_drivers(setup *s)
{
    report *r = &s->report;
    for (int i = 0; peers[i] && r->drivers < REPORT_DRIVERS; i++) {
        bool able = peer_is_list(r->limits.question)
                        ? peer_maker(peers[i], r->limits.question) != NULL
                        : peer_way(peers[i], r->limits.question) && !peers[i]->prove;
        bool wanted = peers[i]->ours || !s->drivers || peer_is_listed(s->drivers, peers[i]);
        if (able && wanted && (s->methods || !peers[i]->single))
            r->driver[r->drivers++] = peers[i];
    }
}

/* ---- running --------------------------------------------------------------------------------- */

/* Large problems have one variant: each is held in memory twice. */
static int count_variants(const problem *p)
{
    return p->m * (size_t)(p->n + 1) > 20000 ? 1 : CHILD_VARIANTS;
}

/* With --quick a driver gets four times the best time of its side so far, and not less than 0.2 s.
 */
static double patience(const setup *s, const entry *e, int driver)
{
    const report *r = &s->report;
    double limit = r->limits.seconds;
    for (int d = 0; s->quick && d < driver; d++) {
        double t = 4 * e->outcome[d].typical;
        bool beside = bars_same_side(r->limits.question, r->driver[d], r->driver[driver]);
        if (beside && e->outcome[d].end == CHILD_DONE && t < limit)
            limit = t < 0.2 ? 0.2 : t;
    }
    return limit;
}

static void run_drivers(const setup *s, entry *e)
{
    const report *r = &s->report;
    problem variants[CHILD_VARIANTS];
    int count = count_variants(&e->problem);
    for (int v = 0; v < count; v++)
        problem_variant(&variants[v], &e->problem, (unsigned)v);
    for (int d = 0; d < r->drivers; d++) {
        child_limits limits = r->limits;
        limits.seconds = patience(s, e, d);
        limits.variants = count;
        e->outcome[d] = child_run(r->driver[d], variants, &limits);
    }
    for (int v = 0; v < count; v++)
        problem_clear(&variants[v]);
}

/* A file, or a family of polytopes. */
static bool read_problem(const setup *s, problem *p, const char *path)
{
    polytope_plan plan = {.seed = s->seed};
    if (!polytope_parse(path, &plan))
        return problem_read(p, path);
    polytope_draw(&plan, p, path);
    return true;
}

/* Why the question cannot be asked; NULL if it can. */
static const char *reason_to_skip(peer_question question, problem *p)
{
    if (question == PEER_PROJECT && p->keep == p->n)
        return "nothing to eliminate (no line \"* keep K\")";
    if (question == PEER_HULL && !problem_turn_over(p))
        return "there are no generators, or too many";
    return question != PEER_HULL && !p->system ? "there are no rows" : NULL;
}

/* Runs all drivers, then frees the rows of p. */
static void run_problem(setup *s, problem *p)
{
    report *r = &s->report;
    entry e = {.problem = *p};
    run_drivers(s, &e);
    problem_clear(p);
    report_judge(r, &e);
    report_line(r, &e);
    r->list = need(realloc(r->list, (r->entries + 1) * sizeof *r->list));
    r->list[r->entries++] = e;
}

static bool run_path(setup *s, const char *path)
{
    problem p;
    if (!read_problem(s, &p, path))
        return false;
    const char *why = reason_to_skip(s->report.limits.question, &p);
    if (!why) {
        run_problem(s, &p);
        return true;
    }
    fprintf(stderr, "%s: %s\n", path, why);
    problem_clear(&p);
    return true;
}

/* Problems of each family, by several seeds. */
static void run_families(setup *s)
{
    int known = study_projections(), seen = known + study_projections_apart();
    int from = s->unseen ? seen : 0, to = s->unseen ? seen + study_projections_unseen() : known;
    for (int f = from; f < to; f++) {
        for (uint64_t seed = s->seed; seed < s->seed + s->each; seed++) {
            study_projection drawn;
            problem p;
            char name[sizeof p.name];
            if (study_projection_draw(f, seed, &drawn) != FMB_OK)
                need(NULL);
            snprintf(name, sizeof name, "%s_%" PRIu64, study_projection_name(f), seed);
            problem_of_system(&p, name, drawn.s);
            snprintf(p.family, sizeof p.family, "%s", study_projection_name(f));
            p.keep = drawn.keep;
            run_problem(s, &p);
        }
    }
}

/* ---- arguments ------------------------------------------------------------------------------- */

static bool set_option(setup *s, const char *text)
{
    const char *equal = strchr(text, '=');
    char name[64];
    if (!equal || (size_t)(equal - text) >= sizeof name)
        return false;
    snprintf(name, sizeof name, "%.*s", (int)(equal - text), text);
    return fmb_options_set(&s->options, name, equal + 1) == FMB_OK;
}

/* An option with a value; false if it is unknown or its value no good. */
static bool take_value(setup *s, const char *name, const char *value)
{
    if (strcmp(name, "--drivers") == 0)
        return peers_know_all(s->drivers = value);
    else if (strcmp(name, "--json") == 0)
        s->json = value;
    else if (strcmp(name, "--set") == 0)
        return set_option(s, value);
    else if (strcmp(name, "--seconds") == 0)
        return (s->report.limits.seconds = atof(value)) > 0;
    else if (strcmp(name, "--seed") == 0)
        s->seed = strtoull(value, NULL, 10);
    else if (strcmp(name, "--each") == 0)
        s->each = strtoull(value, NULL, 10);
    else if (strcmp(name, "--bytes") == 0)
        s->report.limits.bytes = (size_t)strtoull(value, NULL, 10);
    else
        return false;
    return true;
}

static bool take_arguments(setup *s, int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i], *dot = strrchr(a, '.');
        if (strcmp(a, "--decide") == 0)
            s->report.limits.question = PEER_DECIDE;
        else if (strcmp(a, "--vertices") == 0)
            s->report.limits.question = PEER_VERTICES;
        else if (strcmp(a, "--hull") == 0)
            s->report.limits.question = PEER_HULL;
        else if (strcmp(a, "--quick") == 0)
            s->quick = true;
        else if (strcmp(a, "--all-answer") == 0)
            s->all_answer = true;
        else if (strcmp(a, "--list") == 0)
            s->list = true;
        else if (strcmp(a, "--bars") == 0)
            s->bars = true;
        else if (strcmp(a, "--methods") == 0)
            s->methods = true;
        else if (strcmp(a, "--families") == 0)
            s->families = true;
        else if (strcmp(a, "--unseen") == 0)
            s->families = s->unseen = true;
        else if (a[0] == '-') {
            if (i + 1 >= argc || !take_value(s, a, argv[i + 1]))
                return false;
            i++;
        } else if (dot && strcmp(dot, ".txt") == 0) {
            if (!add_manifest(s, a))
                return false;
        } else
            add_path(s, a);
    }
    return s->list || s->families || s->paths > 0;
}

static void forget(setup *s)
{
    for (size_t i = 0; i < s->report.entries; i++) {
        for (int d = 0; d < s->report.drivers; d++)
            child_outcome_clear(&s->report.list[i].outcome[d]);
    }
    free(s->report.list);
    for (size_t i = 0; i < s->paths; i++)
        free(s->path[i]);
    free(s->path);
}

/* The exit code. */
static int finish(setup *s, bool good)
{
    bool fault = false;
    if (s->report.entries > 0)
        report_summary(&s->report);
    if (s->report.entries > 0 && s->bars)
        bars_print(&s->report);
    for (size_t i = 0; i < s->report.entries; i++) {
        const entry *e = &s->report.list[i];
        fault |= e->wrong || (s->all_answer && e->silent);
    }
    if (s->json && !report_json(&s->report, s->json)) {
        fprintf(stderr, "%s: cannot be written\n", s->json);
        return 74;
    }
    return !good ? 66 : fault ? 1 : 0;
}

int main(int argc, char **argv)
{
    setup s = {.options = (fmb_options){.size = sizeof(fmb_options)}, .seed = 1, .each = 4};
    bool good = true;
    s.options.evidence = FMB_EVIDENCE_NONE;
    s.report.limits = (child_limits){
        .seconds = 5, .bytes = (size_t)4 << 30, .later = 0.2, .variants = CHILD_VARIANTS};
    if (!take_arguments(&s, argc, argv)) {
        fputs(USAGE, stderr);
        return 64;
    }
    s.report.limits.options = &s.options;
    setenv("OMP_NUM_THREADS", "1", 1);
    choose_drivers(&s);
    for (int d = 0; s.list && d < s.report.drivers; d++)
        printf("%s\n", s.report.driver[d]->name);
    if (!s.list)
        report_head(&s.report);
    for (size_t i = 0; i < s.paths && !s.list; i++)
        good &= run_path(&s, s.path[i]);
    if (s.families && !s.list)
        run_families(&s);
    int code = finish(&s, good);
    forget(&s);
    return code;
}
