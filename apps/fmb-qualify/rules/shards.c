/* shards.c: a run in parts: the file of each part, and their merge.
 *
 * A part holds its options ("arguments"), the number of systems in each sample ("sizes"), the
 * existing ways ("known") and its runs, a list of numbers each:
 *   sample, item, way, outcome, stop, verdict, pairs, made, kept, lived, peak, held, solved,
 *   seconds, rows dropped by each rule.
 */
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/parts.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/rules/files.h"
#include "fmb-qualify/rules/plan.h"

/* ---- a part ---------------------------------------------------------------------------------- */

static json_t *run_json(const study_grid *g, size_t k, size_t i, size_t w)
{
    const study_run *r = study_grid_at(g, k, i, w);
    json_t *dropped = json_object();
    for (size_t n = 0; n < g->names.size; n++)
        if (r->dropped[n] > 0)
            app_json_set(dropped, g->names.name[n], qualify_count_json(r->dropped[n]));
    return json_pack("[I, I, I, i, i, i, I, I, I, I, I, I, i, f, o]", (json_int_t)k, (json_int_t)i,
                     (json_int_t)w, (int)r->outcome, (int)r->stop, (int)r->verdict,
                     (json_int_t)r->pairs, (json_int_t)r->made, (json_int_t)r->kept,
                     (json_int_t)r->lived, (json_int_t)r->peak, (json_int_t)r->held, (int)r->solved,
                     r->seconds, dropped);
}

void qualify_runs_json(const qualify_plan *p, json_t *obj)
{
    const study_grid *g = &p->grid;
    json_t *runs = json_array(), *sizes = json_array(), *known = json_array();
    for (size_t k = 0; k < g->complete; k++)
        for (size_t i = 0; i < g->sample[k].size; i++)
            for (size_t w = 0; w < g->ways; w++)
                if (study_grid_at(g, k, i, w)->outcome != STUDY_NOT_RUN)
                    app_json_append(runs, run_json(g, k, i, w));
    for (size_t k = 0; k < g->samples; k++)
        app_json_append(sizes, qualify_count_json(g->sample[k].size));
    for (size_t w = 0; w < g->ways; w++)
        app_json_append(known, json_boolean(g->known[w]));
    app_json_set(obj, "shard", json_pack("[I, I]", (json_int_t)p->shard, (json_int_t)p->shards));
    app_json_set(obj, "arguments", json_incref(p->arguments));
    app_json_set(obj, "rejected", qualify_count_json(g->rejected));
    app_json_set(obj, "sizes", sizes);
    app_json_set(obj, "known", known);
    app_json_set(obj, "runs", runs);
}

/* ---- all of them ----------------------------------------------------------------------------- */

/* The number of a rule's name, which lives as long as the parts; false if there are too many. */
static bool find_name(study_names *names, const char *name, size_t *out)
{
    for (*out = 0; *out < names->size; ++*out)
        if (strcmp(names->name[*out], name) == 0)
            return true;
    if (names->size == STUDY_MOST_NAMES)
        return false;
    names->name[names->size++] = name;
    return true;
}

static bool read_run(study_grid *g, json_t *from)
{
    json_int_t k, i, w, count[6];
    int outcome, stop, verdict, solved;
    double seconds;
    json_t *dropped, *rows;
    const char *name;
    size_t n;
    if (json_unpack(from, "[I, I, I, i, i, i, I, I, I, I, I, I, i, F, o]", &k, &i, &w, &outcome,
                    &stop, &verdict, &count[0], &count[1], &count[2], &count[3], &count[4],
                    &count[5], &solved, &seconds, &dropped) != 0 ||
        k < 0 || (size_t)k >= g->samples || i < 0 || (size_t)i >= g->sample[k].size || w < 0 ||
        (size_t)w >= g->ways || outcome < 0 || outcome > STUDY_WRONG || solved < 0 ||
        solved > STUDY_WRONG)
        return false;
    study_run *r = study_grid_at(g, (size_t)k, (size_t)i, (size_t)w);
    *r = (study_run){.outcome = (study_outcome)outcome,
                     .stop = (fmb_stop)stop,
                     .verdict = (fmb_verdict)verdict,
                     .pairs = (uint64_t)count[0],
                     .made = (uint64_t)count[1],
                     .kept = (uint64_t)count[2],
                     .lived = (uint64_t)count[3],
                     .peak = (uint64_t)count[4],
                     .held = (uint64_t)count[5],
                     .solved = (study_outcome)solved,
                     .seconds = seconds};
    json_object_foreach(dropped, name, rows)
    {
        if (!find_name(&g->names, name, &n))
            return false;
        r->dropped[n] = (uint64_t)json_integer_value(rows);
    }
    return true;
}

/* Empty samples, of the sizes on which the parts agree, with room for their runs. */
static bool make_room(study_grid *g, const json_t *part)
{
    const json_t *sizes = json_object_get(part, "sizes"), *known = json_object_get(part, "known");
    enum { MOST = 1000000 };
    g->most = 1;
    if (json_array_size(sizes) != g->samples || json_array_size(known) != g->ways)
        return false;
    for (size_t k = 0; k < g->samples; k++) {
        json_int_t size = json_integer_value(json_array_get(sizes, k));
        while (g->sample[k].size < (size_t)size && size <= MOST)
            if (study_sample_put(&g->sample[k], NULL, NULL, 0) != FMB_OK)
                app_need(NULL);
        g->most = g->sample[k].size > g->most ? g->sample[k].size : g->most;
    }
    g->known = app_need(calloc(g->ways, sizeof *g->known));
    for (size_t w = 0; w < g->ways; w++)
        g->known[w] = json_is_true(json_array_get(known, w));
    g->run = app_need(calloc(g->samples * g->most * g->ways + 1, sizeof *g->run));
    g->prepared = g->complete = g->samples;
    return true;
}

static bool add_runs(study_grid *g, const json_t *part)
{
    const json_t *runs = json_object_get(part, "runs");
    bool good = json_is_true(json_object_get(part, "complete")) && json_is_array(runs);
    for (size_t r = 0; good && r < json_array_size(runs); r++)
        good = read_run(g, json_array_get(runs, r));
    g->rejected += (size_t)json_integer_value(json_object_get(part, "rejected"));
    return good;
}

/* Parses the common arguments of the parts into a plan. */
static void parse_again(const json_t *arguments, qualify_plan *out)
{
    size_t n = json_array_size(arguments);
    const char **word = app_need(calloc(n + 2, sizeof *word));
    word[0] = "fmb-qualify rules";
    for (size_t i = 0; i < n; i++) {
        word[i + 1] = json_string_value(json_array_get(arguments, i));
        word[i + 1] = word[i + 1] ? word[i + 1] : "";
    }
    argp_parse(&qualify_plan_argp, (int)n + 1, (char **)word, 0, NULL, out);
    free(word);
}

int qualify_plan_merge(const qualify_plan *p, qualify_plan *out)
{
    static const char *const SAME[] = {"study", "version", "arguments", "sizes", "known", NULL};
    qualify_plan_init(out);
    int code = app_parts_read((char **)p->file, p->files, SAME, &out->part);
    if (code != APP_YES)
        return code;
    out->parts = p->files;
    parse_again(json_object_get(out->part[0], "arguments"), out);
    out->out = p->out;
    out->json = p->json;
    out->quiet = p->quiet;
    out->detail = p->detail;
    code = qualify_plan_make(out);
    if (code == APP_YES && !make_room(&out->grid, out->part[0]))
        code = app_error(APP_BAD_INPUT, "%s: not the output of a shard", p->file[0]);
    for (size_t i = 0; code == APP_YES && i < out->parts; i++)
        if (!add_runs(&out->grid, out->part[i]))
            code = app_error(APP_BAD_INPUT, "%s: an unfinished shard", p->file[i]);
    return code;
}
