/* rules.c: the built-in rules, the rules in use, and whether they are compatible. */
#include "rule/rule_private.h"

#include <stdio.h>
#include <string.h>

#include "solve/query/rule_lp.h"
#include "solve/query/solver.h"

static const fmb_rule *const BUILT_IN[] = {
    &fmb_rule_duplicate, &fmb_rule_dominated, &fmb_rule_kohler, &fmb_rule_chernikov,
    &fmb_rule_imbert,    &fmb_rule_box,       &fmb_rule_lp,
};

const fmb_rule *fmb_rule_at(size_t i)
{
    return i < sizeof BUILT_IN / sizeof *BUILT_IN ? BUILT_IN[i] : NULL;
}

static const fmb_rule *find_built_in_rule(const char *name, size_t size)
{
    const fmb_rule *r;
    for (size_t i = 0; (r = fmb_rule_at(i)) != NULL; i++)
        if (strlen(r->name) == size && memcmp(r->name, name, size) == 0)
            return r;
    return NULL;
}

const fmb_rule *fmb_rule_find(const char *name)
{
    return name ? find_built_in_rule(name, strlen(name)) : NULL;
}

/* ---- lists of words -------------------------------------------------------------------------- */

/* Call take for each word of a comma-separated list. */
static fmb_status take_words_of_list(fmb_solver *v, const char *list,
                                     fmb_status (*take)(fmb_solver *v, const char *word,
                                                        size_t size))
{
    if (strcmp(list, "none") == 0)
        return FMB_OK;
    for (;; list++) {
        size_t size = strcspn(list, ",");
        FMB_TRY(take(v, list, size));
        list += size;
        if (!*list)
            return FMB_OK;
    }
}

/* A rule named twice is used once. */
static fmb_status take_named_rule(fmb_solver *v, const char *word, size_t size)
{
    const fmb_rule *rule = find_built_in_rule(word, size);
    for (int k = 0; k < v->rules; k++)
        if (v->rule[k] == rule)
            return FMB_OK;
    if (!rule)
        return fmb_solver_refuse(v, FMB_ERR_RULE, "rules: there is no rule \"%.*s\"",
                                 (int)(size < 64 ? size : 64), word);
    if (v->rules == FMB_MAX_RULES)
        return fmb_solver_refuse(v, FMB_ERR_RULE, "rules: more than %d", FMB_MAX_RULES);
    v->rule[v->rules++] = rule;
    return FMB_OK;
}

/* In the order of the bits of fmb_step. */
static const char *const STEP[] = {"equalities", "components", "onesided", "bounds", "refute"};

static fmb_status take_named_step(fmb_solver *v, const char *word, size_t size)
{
    for (size_t i = 0; i < sizeof STEP / sizeof *STEP; i++)
        if (strlen(STEP[i]) == size && memcmp(STEP[i], word, size) == 0) {
            v->steps |= 1u << i;
            return FMB_OK;
        }
    return fmb_solver_refuse(v, FMB_ERR_ARG, "presolve: there is no step \"%.*s\"",
                             (int)(size < 64 ? size : 64), word);
}

fmb_status fmb_rules_read(fmb_solver *v, const fmb_options *o)
{
    FMB_TRY(
        take_words_of_list(v, o->rules ? o->rules : fmb_options_initial("rules"), take_named_rule));
    return take_words_of_list(v, o->presolve ? o->presolve : fmb_options_initial("presolve"),
                              take_named_step);
}

fmb_status fmb_solver_add_rule(fmb_solver *v, const fmb_rule *rule)
{
    if (!v || !rule || !rule->name || !*rule->name)
        return fmb_solver_refuse(v, FMB_ERR_ARG, rule ? "the rule has no name" : "rule is NULL");
    for (int k = 0; k < v->rules; k++)
        if (strcmp(v->rule[k]->name, rule->name) == 0)
            return fmb_solver_refuse(v, FMB_ERR_RULE, "rule \"%s\" is in use", rule->name);
    if (v->rules == FMB_MAX_RULES)
        return fmb_solver_refuse(v, FMB_ERR_RULE, "more than %d rules", FMB_MAX_RULES);
    v->error[0] = '\0';
    v->rule[v->rules++] = rule;
    return FMB_OK;
}

/* ---- do they agree? -------------------------------------------------------------------------- */

static bool do_rules_disagree(const fmb_solver *v, const fmb_rule *a, const fmb_rule *b)
{
    bool never = v->options.rebase == FMB_REBASE_NEVER && (a->flags & FMB_RULE_NEEDS_HISTORY);
    return (never || (a->flags & FMB_RULE_ONE_BASE)) && (b->flags & FMB_RULE_BREAKS_HISTORY);
}

fmb_status fmb_rules_agree(fmb_solver *v, const char *query)
{
    v->error[0] = '\0';
    for (int i = 0; i < v->rules; i++) {
        const fmb_rule *a = v->rule[i];
        if ((a->flags & FMB_RULE_VERDICT_ONLY) && strcmp(query, "solve") != 0)
            return fmb_solver_refuse(v, FMB_ERR_RULE,
                                     "rule \"%s\" keeps the verdict only: unsound for %s", a->name,
                                     query);
        for (int j = 0; j < v->rules; j++)
            if (do_rules_disagree(v, a, v->rule[j]))
                return fmb_solver_refuse(v, FMB_ERR_RULE,
                                         "rule \"%s\" needs histories that rule \"%s\" breaks",
                                         a->name, v->rule[j]->name);
    }
    return FMB_OK;
}
