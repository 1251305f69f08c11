/* rule_library.h: external pruning rules and orders, from a shared object that exports
 * fmb_rule_library, fmb_chooser_library or both (fmb/rule.h). */
#ifndef APP_RULE_LIBRARY_H
#define APP_RULE_LIBRARY_H

#include <fmb/rule.h>

enum { APP_MOST_ADDED = 16 };

/* All NULL: no library. */
typedef struct app_rule_library {
    void *handle;
    const fmb_rule *const *rule;             /* NULL ends them; or NULL */
    const fmb_named_chooser *const *chooser; /* the same */
} app_rule_library;

/* [give, app_rule_library_close] APP_YES, or an exit code after a message. Names of rules and
 * orders must be new. */
int app_rule_library_open(const char *path, app_rule_library *out);
void app_rule_library_close(app_rule_library *l);

/* The order of that name, or NULL. */
const fmb_named_chooser *app_rule_library_order(const app_rule_library *l, const char *name);
/* APP_USAGE after a message: option expected a word of the library, or one of l. */
int app_rule_library_refuse_order(const app_rule_library *l, const char *option, const char *word);

/* APP_USAGE after a message: with an order of the library at path a query returned FMB_ERR_ARG. */
int app_rule_library_refuse_choice(const char *path);

/* A set of rules, for a solver: words for options.rules, and rules to be added to it. */
typedef struct app_rule_set {
    char *words;                               /* [give, free()] NULL: the choice of the library */
    const fmb_rule *added[APP_MOST_ADDED + 1]; /* NULL ends them */
} app_rule_set;

/* Split a set ("mine,kohler"; NULL: the default rules and all of l) into rules of l and words for
 * options.rules. APP_USAGE, after a message, if there are more than a set can hold. */
int app_rule_library_split(const app_rule_library *l, const char *set, app_rule_set *out);

/* Add the rules of a set to a solver. Errors: RULE. */
fmb_status app_rule_set_add(const app_rule_set *set, fmb_solver *v);

#endif
