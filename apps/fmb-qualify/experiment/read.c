/* read.c: an experiment from its plan. See experiment.h. */
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "fmb-qualify/benchmark/sha256.h"
#include "fmb-qualify/experiment/experiment.h"
#include "fmb-qualify/rules/plan.h"
#include "study/benchmark/benchmark.h"

/* The keys of a plan and their defaults. Lists of words, and of numbers from least to most; the
 * family "all" means all families. */
typedef struct key {
    const char *name, *usual; /* JSON */
    json_type item;           /* of the list */
    int least, most;          /* of a number */
} key;

static const key KEY[] = {
    {"rules", "[\"none\", \"default\"]", JSON_STRING, 0, 0},
    {"orders", "[\"pairs\"]", JSON_STRING, 0, 0},
    {"methods", "[\"fm\"]", JSON_STRING, 0, 0},
    {"evidence", "[\"all\"]", JSON_STRING, 0, 0},
    {"families", "[\"all\"]", JSON_STRING, 0, 0},
    {"files", "[]", JSON_STRING, 0, 0},
    {"sizes", "[1, 2, 3, 4, 5]", JSON_INTEGER, 1, STUDY_BENCHMARK_SIZES},
    {"digits", "[0]", JSON_INTEGER, 0, 18},
    {"density", "[100]", JSON_INTEGER, 1, 100},
    {"seeds", "[1, 2, 3]", JSON_INTEGER, 1, 1000000},
};
enum { KEYS = sizeof KEY / sizeof *KEY };

static int refuse(const char *path, const char *what, const char *expected)
{
    return app_error_at((app_place){.file = path}, APP_BAD_INPUT, "\"%s\": expected %s", what,
                        expected);
}

static bool is_in_range(const key *k, const json_t *item)
{
    json_int_t n = json_integer_value(item);
    return json_typeof(item) == k->item &&
           (k->item == JSON_STRING || (n >= k->least && n <= k->most));
}

/* Requires the list, of the right type and range; fills in its default. */
static int need_list(const char *path, json_t *plan, const key *k)
{
    size_t i;
    json_t *item, *list = json_object_get(plan, k->name);
    bool good = true;
    if (!list) {
        app_need(list = json_loads(k->usual, 0, NULL));
        if (json_object_set_new(plan, k->name, list) != 0)
            app_need(NULL);
    }
    good = json_is_array(list);
    json_array_foreach(list, i, item) good = good && is_in_range(k, item);
    return good ? APP_YES
                : refuse(path, k->name,
                         k->item == JSON_STRING ? "a list of words" : "a list of numbers in range");
}

/* Refuses unknown keys. */
static int need_known_keys(const char *path, json_t *plan)
{
    static const char *const OTHER[] = {"question", "limits",       "passes",
                                        "presolve", "rule-library", "about"};
    const char *name;
    json_t *value;
    json_object_foreach(plan, name, value)
    {
        bool known = false;
        for (int k = 0; k < KEYS; k++)
            known = known || strcmp(name, KEY[k].name) == 0;
        for (size_t k = 0; k < sizeof OTHER / sizeof *OTHER; k++)
            known = known || strcmp(name, OTHER[k]) == 0;
        if (!known)
            return app_error_at((app_place){.file = path}, APP_BAD_INPUT, "\"%s\": no such key",
                                name);
    }
    return APP_YES;
}

static const char *word_at(const qualify_experiment *e, const char *name, size_t i)
{
    return json_string_value(json_array_get(json_object_get(e->plan, name), i));
}

static int number_at(const qualify_experiment *e, const char *name, size_t i)
{
    return (int)json_integer_value(json_array_get(json_object_get(e->plan, name), i));
}

static size_t count_of(const qualify_experiment *e, const char *name)
{
    return json_array_size(json_object_get(e->plan, name));
}

/* ---- blocks ---------------------------------------------------------------------------------- */

/* Adds the block with each number of digits and each density. */
static void add_blocks(qualify_experiment *e, qualify_block b)
{
    for (size_t d = 0; d < count_of(e, "digits"); d++)
        for (size_t t = 0; t < count_of(e, "density"); t++) {
            b.digits = number_at(e, "digits", d);
            b.density = number_at(e, "density", t);
            e->block[e->blocks++] = b;
        }
}

static void add_family(qualify_experiment *e, int family)
{
    for (size_t s = 0; s < count_of(e, "sizes"); s++)
        add_blocks(e, (qualify_block){.family = family, .size = number_at(e, "sizes", s)});
}

static int make_blocks(const char *path, qualify_experiment *e)
{
    size_t families = count_of(e, "families"), files = count_of(e, "files");
    size_t most = (size_t)study_benchmark_families() * families * count_of(e, "sizes") + files;
    most *= count_of(e, "digits") * count_of(e, "density");
    e->block = app_need(calloc(most + 1, sizeof *e->block));
    for (size_t i = 0; i < families; i++) {
        const char *word = word_at(e, "families", i);
        int found = study_benchmark_find(word);
        if (found < 0 && strcmp(word, "all") != 0)
            return refuse(path, "families", "families of the benchmark, or all");
        for (int f = 0; f < study_benchmark_families(); f++)
            if (found < 0 || f == found)
                add_family(e, f);
    }
    for (size_t i = 0; i < files; i++)
        add_blocks(e, (qualify_block){.file = word_at(e, "files", i), .family = -1});
    return e->blocks > 0 ? APP_YES : refuse(path, "families", "something to do");
}

/* ---- ways ------------------------------------------------------------------------------------ */

static int add_way(qualify_experiment *e, qualify_way_names names)
{
    qualify_order found = {.name = ""};
    int code = APP_YES;
    size_t w = e->ways++;
    e->way_names[w] = names;
    if (*names.order)
        code = qualify_order_find(&e->library, "orders", names.order, &found);
    if (code == APP_YES && *names.rules && strcmp(names.rules, "default") != 0)
        code = app_rule_library_split(&e->library, names.rules, &e->set[w]);
    e->way[w] = (study_way){.name = names.rules,
                            .rules = e->set[w].words,
                            .added = e->set[w].added,
                            .order = found.order,
                            .chooser = found.chooser,
                            .method = names.method,
                            .evidence = names.evidence};
    return code;
}

/* Rules and orders concern elimination only: another method is a single way. */
static int add_ways(const char *path, qualify_experiment *e, const char *method,
                    const char *evidence)
{
    size_t orders = count_of(e, "orders"), sets = count_of(e, "rules");
    fmb_options o = {.size = sizeof o};
    int code = APP_YES;
    if (fmb_options_set(&o, "method", method) != FMB_OK)
        return refuse(path, "methods", "auto, fm, lp, hull, dd");
    if (fmb_options_set(&o, "evidence", evidence) != FMB_OK)
        return refuse(path, "evidence", "all, none, verdict, whole");
    if (o.method != FMB_METHOD_FM)
        return add_way(e, (qualify_way_names){method, "", "", evidence});
    for (size_t k = 0; k < orders; k++)
        for (size_t r = 0; code == APP_YES && r < sets; r++)
            code = add_way(e, (qualify_way_names){method, word_at(e, "orders", k),
                                                  word_at(e, "rules", r), evidence});
    return code;
}

static int make_ways(const char *path, qualify_experiment *e)
{
    size_t methods = count_of(e, "methods"), kinds = count_of(e, "evidence");
    size_t most = methods * kinds * (count_of(e, "orders") * count_of(e, "rules") + 1) + 1;
    int code = APP_YES;
    e->way = app_need(calloc(most, sizeof *e->way));
    e->way_names = app_need(calloc(most, sizeof *e->way_names));
    e->set = app_need(calloc(most, sizeof *e->set));
    for (size_t m = 0; m < methods; m++)
        for (size_t k = 0; code == APP_YES && k < kinds; k++)
            code = add_ways(path, e, word_at(e, "methods", m), word_at(e, "evidence", k));
    return code == APP_YES && e->ways == 0 ? refuse(path, "methods", "something to do") : code;
}

/* ---- the rest -------------------------------------------------------------------------------- */

static int read_rest(const char *path, qualify_experiment *e, const char **library)
{
    const char *question = "project", *presolve = "bounds";
    double seconds = 10, rows = 10000;
    int passes = 3;
    json_error_t why;
    *library = NULL;
    if (json_unpack_ex(e->plan, &why, 0, "{s?s, s?s, s?i, s?s, s?{s?F, s?F !}}", "question",
                       &question, "presolve", &presolve, "passes", &passes, "rule-library", library,
                       "limits", "seconds", &seconds, "rows", &rows) != 0)
        return app_error_at((app_place){.file = path}, APP_BAD_INPUT, "%s", why.text);
    e->projects = strcmp(question, "project") == 0;
    if (!e->projects && strcmp(question, "solve") != 0)
        return refuse(path, "question", "project or solve");
    if (passes < 0 || passes > 9)
        return refuse(path, "passes", "0 to 9");
    if (!(seconds >= 0 && rows >= 0 && rows < 1e15))
        return refuse(path, "limits", "numbers that are not negative");
    e->passes = passes;
    e->limits = (study_limits){(size_t)rows, seconds, presolve};
    return APP_YES;
}

static void name_plan(qualify_experiment *e)
{
    char digest[QUALIFY_SHA256_TEXT];
    char *text = app_need(json_dumps(e->plan, JSON_SORT_KEYS | JSON_COMPACT));
    qualify_sha256(text, strlen(text), digest);
    memcpy(e->name, digest, sizeof e->name - 1);
    free(text);
}

/* Of the plan that e holds. */
static int read_plan(const char *path, qualify_experiment *e)
{
    const char *library = NULL;
    int code =
        json_is_object(e->plan) ? need_known_keys(path, e->plan) : refuse(path, "", "an object");
    for (int k = 0; code == APP_YES && k < KEYS; k++)
        code = need_list(path, e->plan, &KEY[k]);
    if (code == APP_YES)
        code = read_rest(path, e, &library);
    if (code == APP_YES && library)
        code = app_rule_library_open(library, &e->library);
    if (code == APP_YES)
        code = make_blocks(path, e);
    if (code == APP_YES)
        code = make_ways(path, e);
    if (code != APP_YES)
        return code;
    name_plan(e);
    e->seeds = count_of(e, "seeds");
    e->seed = app_need(calloc(e->seeds + 1, sizeof *e->seed));
    for (size_t i = 0; i < e->seeds; i++)
        e->seed[i] = number_at(e, "seeds", i);
    return e->seeds > 0 ? APP_YES : refuse(path, "seeds", "something to do");
}

int qualify_experiment_take(json_t *plan, const char *path, qualify_experiment *e)
{
    *e = (qualify_experiment){.plan = plan};
    return read_plan(path, e);
}

int qualify_experiment_read(const char *path, qualify_experiment *e)
{
    json_error_t why;
    *e = (qualify_experiment){.plan = json_load_file(path, JSON_REJECT_DUPLICATES, &why)};
    if (!e->plan && why.line <= 0)
        return app_error(APP_CANNOT_OPEN, "%s", why.text);
    if (!e->plan)
        return app_error_at((app_place){path, why.line, why.column}, APP_BAD_INPUT, "%s", why.text);
    return read_plan(path, e);
}

void qualify_experiment_clear(qualify_experiment *e)
{
    for (size_t w = 0; w < e->ways; w++)
        free(e->set[w].words);
    free(e->set);
    free(e->way_names);
    free(e->way);
    free(e->seed);
    free(e->block);
    app_rule_library_close(&e->library);
    json_decref(e->plan);
}
