/* table.c: see table.h. */
#define _DEFAULT_SOURCE /* glob */
#include "table.h"

#include <glob.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "common/machine.h"

static const struct {
    const char *name, *files, *about;
} WAY[] = {
#define WAY_ROW(id, name, files, about) {name, files, about},
    FMB_WAYS(WAY_ROW)
#undef WAY_ROW
        {"(all on, twice)", "", "noise"}};

/* A way pays if the mean loss without it, or the loss on one problem, is as large. */
#define PAYS_IN_THE_MEAN 1.05
#define PAYS_ON_ONE      2.0
/* [s] Shorter problems do not count for the worst ratio. */
#define LEAST_TIME 1e-3

const char *table_way_name(int way)
{
    return WAY[way].name;
}

void table_add(table *t, int way, const char *where, const table_cell *cell)
{
    table_row *r = &t->row[way];
    double ratio = cell->without / cell->with;
    r->problems++;
    r->unfinished += cell->unfinished;
    r->asked += cell->asked;
    r->answered += cell->answered;
    r->log_time += log(ratio);
    if (cell->peak_with > 0 && cell->peak_without > 0) {
        r->log_memory += log(cell->peak_without / cell->peak_with);
        r->memories++;
    }
    if (fmax(cell->with, cell->without) >= LEAST_TIME && ratio > r->worst) {
        r->worst = ratio;
        snprintf(r->worst_name, sizeof r->worst_name, "%s", where);
    }
}

/* Lines of a file; 0 if there is none. */
static unsigned count_lines(const char *path)
{
    unsigned lines = 0;
    FILE *in = fopen(path, "r");
    for (int c; in && (c = getc(in)) != EOF;)
        lines += c == '\n';
    if (in)
        fclose(in);
    return lines;
}

/* Lines of the files that only this way needs. */
static unsigned count_lines_of_way(int way)
{
    char list[1024], path[512];
    unsigned lines = 0;
    snprintf(list, sizeof list, "%s", WAY[way].files);
    for (char *name = strtok(list, " "); name; name = strtok(NULL, " ")) {
        glob_t found = {0};
        snprintf(path, sizeof path, "%s/lib/%s.[ch]", FMB_SOURCE_ROOT, name);
        if (glob(path, 0, NULL, &found) != 0)
            fprintf(stderr, "lib/%s: there is no such file\n", name);
        for (size_t i = 0; i < found.gl_pathc; i++)
            lines += count_lines(found.gl_pathv[i]);
        globfree(&found);
    }
    return lines;
}

static const char *judge_row(const table_row *r, int way)
{
    if (way == FMB_WAY_COUNT)
        return "";
    if (r->problems == 0)
        return "**not asked**";
    bool pays = exp(r->log_time / r->problems) >= PAYS_IN_THE_MEAN || r->worst >= PAYS_ON_ONE;
    return pays ? "yes" : "**no**";
}

static void print_row(const table *t, int way, unsigned problems)
{
    const table_row *r = &t->row[way];
    double n = r->problems > 0 ? r->problems : 1, m = r->memories > 0 ? r->memories : 1;
    printf("| %-22s | %5u | %4.0f %% | %4.0f %% | %5.2f | %6.2f | %-32s | %4u | %5.2f | %-13s | %s "
           "|\n",
           WAY[way].name, way < FMB_WAY_COUNT ? count_lines_of_way(way) : 0,
           100.0 * r->problems / problems,
           r->asked > 0 ? 100.0 * (double)r->answered / (double)r->asked : 0, exp(r->log_time / n),
           r->worst, r->worst_name, r->unfinished, exp(r->log_memory / m), judge_row(r, way),
           WAY[way].about);
}

void table_print(const table *t, unsigned problems, const subject_plan *plan)
{
    char day[16];
    time_t now = time(NULL);
    strftime(day, sizeof day, "%Y-%m-%d", gmtime(&now));
    printf("# What each way earns\n\nMade by `ninja -C build-ablate ways` on %s at commit %s: %u "
           "problems, of all families\n(seeds %" PRIu64 " to %" PRIu64 ") and of %zu files. "
           "*Asked*: on what share of the problems, and on what share of those\noccasions it "
           "answered. *Without*: time where it was asked, once it is switched off, over the time "
           "with it:\ngeometric mean, and the worst of the problems that take a millisecond. "
           "*Lost*: problems not finished then.\nA way pays if the mean is %.2f or the worst "
           "%.1f.\n\n",
           day, app_machine_find().commit, problems, plan->seed, plan->seed + plan->each - 1,
           plan->files, PAYS_IN_THE_MEAN, PAYS_ON_ONE);
    printf("| %-22s | lines | asked  | answered | without | worst | %-32s | lost | memory | pays | "
           "what "
           "it is |\n|---|---:|---:|---:|---:|---:|---|---:|---:|---|---|\n",
           "way", "where");
    for (int way = 0; way <= FMB_WAY_COUNT; way++)
        print_row(t, way, problems);
}

void table_clear(table *t)
{
    memset(t, 0, sizeof *t);
}
