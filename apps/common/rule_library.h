/* rule_library.h: pruning rules of somebody else's, from a shared object that exports
 * fmb_rule_library (fmb/rule.h). */
#ifndef APP_RULE_LIBRARY_H
#define APP_RULE_LIBRARY_H

#include <fmb/rule.h>

enum { APP_MOST_ADDED = 16 };

/* All NULL: no library. */
typedef struct app_rule_library {
    void *handle;
    const fmb_rule *const *rule; /* NULL ends them */
} app_rule_library;

/* [give, app_rule_library_close] APP_YES, or an exit code after a message. The rules have names of
 * their own. */
int app_rule_library_open(const char *path, app_rule_library *out);
void app_rule_library_close(app_rule_library *l);

/* A set of rules, for a solver: words for options.rules, and rules to be added to it. */
typedef struct app_rule_set {
    char *words;                               /* [give, free()] NULL: the choice of the library */
    const fmb_rule *added[APP_MOST_ADDED + 1]; /* NULL ends them */
} app_rule_set;

/* Which words of a set ("mine,kohler"; NULL: the choice of the library and all of l) are rules of
 * l. APP_USAGE, after a message, if there are more than a set can hold. */
int app_rule_library_split(const app_rule_library *l, const char *set, app_rule_set *out);

/* Add the rules of a set to a solver. Errors: RULE. */
fmb_status app_rule_set_add(const app_rule_set *set, fmb_solver *v);

#endif
