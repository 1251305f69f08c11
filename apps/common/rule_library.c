/* rule_library.c: see rule_library.h. */
#include "common/rule_library.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/text.h"

static const char RULES[] = "fmb_rule_library", ORDERS[] = "fmb_chooser_library";

/* What dlopen says may hold a file's name, with whatever bytes that has. */
static int refuse_library(const char *path, const char *why)
{
    char *file = app_text(path, APP_TEXT_TERMINAL), *text = app_text(why, APP_TEXT_TERMINAL);
    app_error(APP_CANNOT_OPEN, "--rule-library '%s': %s", file, text);
    free(file);
    free(text);
    return APP_CANNOT_OPEN;
}

/* Has the rule a name that --rules can distinguish from other words? */
static bool has_name_of_its_own(const fmb_rule *rule)
{
    const char *name = rule->name;
    return name && *name && strcspn(name, ", \t\n") == strlen(name) && strcmp(name, "none") != 0 &&
           strcmp(name, "default") != 0 && !fmb_rule_find(name);
}

/* Has the order a name that file and column names may contain, and that is no word of --order? */
static bool is_order_of_its_own(const fmb_named_chooser *order)
{
    static const char SOUND[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
    enum { LONGEST = 31 };
    fmb_options o = {.size = sizeof o};
    const char *name = order->name;
    size_t length = name ? strlen(name) : 0;
    return length > 0 && length <= LONGEST && strspn(name, SOUND) == length &&
           order->chooser.choose && fmb_options_set(&o, "order", name) != FMB_OK;
}

/* What is wrong with a library, or NULL. */
static const char *fault_of_library(const app_rule_library *l)
{
    if (!l->rule && !l->chooser)
        return dlerror();
    if ((!l->rule || !*l->rule) && (!l->chooser || !*l->chooser))
        return "no rules in it, and no orders";
    for (size_t i = 0; l->rule && l->rule[i]; i++)
        if (!has_name_of_its_own(l->rule[i]))
            return "a rule without a name, or with one that the library uses";
    for (size_t i = 0; l->chooser && l->chooser[i]; i++)
        if (!is_order_of_its_own(l->chooser[i]))
            return "an order without a name of letters, digits, - and _, or with one that the "
                   "library uses, or without a function";
    return NULL;
}

/* A name without a slash might mean a file here, or one where the system keeps its libraries, or
 * where an environment variable says: code is not run on a guess. */
int app_rule_library_open(const char *path, app_rule_library *out)
{
    if (!strchr(path, '/'))
        return refuse_library(path, "a path with a slash is wanted, as ./mine.so");
    app_rule_library l = {.handle = dlopen(path, RTLD_NOW | RTLD_LOCAL)};
    if (!l.handle)
        return refuse_library(path, dlerror());
    l.chooser = dlsym(l.handle, ORDERS);
    l.rule = dlsym(l.handle, RULES);
    const char *why = fault_of_library(&l);
    if (why) {
        int code = refuse_library(path, why);
        app_rule_library_close(&l);
        return code;
    }
    *out = l;
    return APP_YES;
}

void app_rule_library_close(app_rule_library *l)
{
    if (l->handle)
        dlclose(l->handle);
    *l = (app_rule_library){0};
}

/* ---- orders ---------------------------------------------------------------------------------- */

const fmb_named_chooser *app_rule_library_order(const app_rule_library *l, const char *name)
{
    for (size_t i = 0; l->chooser && l->chooser[i]; i++)
        if (strcmp(l->chooser[i]->name, name) == 0)
            return l->chooser[i];
    return NULL;
}

int app_rule_library_refuse_order(const app_rule_library *l, const char *option, const char *word)
{
    char *known, *shown = app_text(word, APP_TEXT_TERMINAL);
    size_t size;
    FILE *f = app_need(open_memstream(&known, &size));
    const fmb_option_info *info;
    for (size_t i = 0; (info = fmb_options_describe(i)) != NULL; i++)
        if (strcmp(info->name, "order") == 0)
            fputs(info->values, f);
    for (size_t i = 0; l->chooser && l->chooser[i]; i++)
        fprintf(f, "|%s", l->chooser[i]->name);
    fclose(f);
    int code = app_error(APP_USAGE, "%s: expected %s, found '%s'", option, known, shown);
    free(known);
    free(shown);
    return code;
}

int app_rule_library_refuse_choice(const char *path)
{
    return app_error(APP_USAGE,
                     "--rule-library '%s': an order named a variable that was not on offer, or a "
                     "rule returned FMB_ERR_ARG",
                     path);
}

/* ---- sets ------------------------------------------------------------------------------------ */

static const fmb_rule *find_rule(const app_rule_library *l, const char *name)
{
    for (size_t i = 0; l->rule && l->rule[i]; i++)
        if (strcmp(l->rule[i]->name, name) == 0)
            return l->rule[i];
    return NULL;
}

/* False if there is no more room. */
static bool add_rule(app_rule_set *set, const fmb_rule *rule)
{
    for (size_t i = 0; i < APP_MOST_ADDED; i++)
        if (!set->added[i]) {
            set->added[i] = rule;
            return true;
        }
    return false;
}

/* Words that l does not know are kept, in order, also empty ones: the solver refuses them. If there
 * are none, only rules of l are used. */
static bool sort_words(const app_rule_library *l, const char *words, app_rule_set *out)
{
    char *copy = app_need(strdup(words)), *rest = copy, *word;
    bool room = true, others = false;
    out->words = app_need(calloc(strlen(words) + sizeof "none", 1));
    while ((word = strsep(&rest, ",")) != NULL) {
        const fmb_rule *rule = find_rule(l, word);
        if (rule)
            room = add_rule(out, rule) && room;
        else
            sprintf(out->words + strlen(out->words), "%s%s", others ? "," : "", word);
        others |= !rule;
    }
    if (!others)
        strcpy(out->words, "none");
    free(copy);
    return room;
}

int app_rule_library_split(const app_rule_library *l, const char *set, app_rule_set *out)
{
    bool room = true;
    *out = (app_rule_set){0};
    if (set)
        room = sort_words(l, set, out);
    for (size_t i = 0; !set && l->rule && l->rule[i]; i++)
        room = add_rule(out, l->rule[i]) && room;
    return room ? APP_YES
                : app_error(APP_USAGE, "--rules: more than %d rules of --rule-library",
                            APP_MOST_ADDED);
}

fmb_status app_rule_set_add(const app_rule_set *set, fmb_solver *v)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && set->added[i]; i++)
        st = fmb_solver_add_rule(v, set->added[i]);
    return st;
}
