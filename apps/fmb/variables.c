/* variables.c: see variables.h. */
#include "fmb/variables.h"

#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/nearest.h"

bool app_names_add(app_names *names, const char *list)
{
    if (names->lists == APP_MOST_LISTS)
        return false;
    names->list[names->lists++] = list;
    return true;
}

static int unknown_variable(const app_names *names, const fmb_system *s, const char *name)
{
    char hint[APP_HINT_SIZE];
    app_nearest near = app_nearest_to(name);
    for (int j = 0; j < fmb_system_dim(s); j++)
        app_nearest_try(&near, fmb_system_name(s, j));
    return app_error(APP_USAGE, "%s: no variable is called '%s'%s", names->option, name,
                     app_nearest_hint(&near, hint));
}

static int mark_one(const app_names *names, const fmb_system *s, const char *name, bool *mark)
{
    int j = fmb_system_find(s, name);
    if (j < 0)
        return unknown_variable(names, s, name);
    if (mark[j])
        return app_error(APP_USAGE, "%s: variable '%s' is named twice", names->option, name);
    mark[j] = true;
    return APP_YES;
}

static int mark_list(const app_names *names, const fmb_system *s, const char *list, bool *mark)
{
    if (*list == '\0')
        return APP_YES;
    if (fmb_system_find(s, list) >= 0)
        return mark_one(names, s, list, mark);
    char *copy = app_need(strdup(list));
    int code = APP_YES;
    for (char *rest = copy, *name; code == APP_YES && (name = strsep(&rest, ","));)
        code = mark_one(names, s, name, mark);
    free(copy);
    return code;
}

int app_names_select(const app_names *names, const fmb_system *s, bool named, int **vars, int *n)
{
    size_t dim = (size_t)fmb_system_dim(s);
    bool *mark = app_need(calloc(dim + 1, sizeof *mark));
    int code = APP_YES;
    for (int i = 0; code == APP_YES && i < names->lists; i++)
        code = mark_list(names, s, names->list[i], mark);
    if (code == APP_YES) {
        *vars = app_need(malloc((dim + 1) * sizeof **vars));
        *n = 0;
        for (int j = 0; j < (int)dim; j++)
            if (mark[j] == named)
                (*vars)[(*n)++] = j;
    }
    free(mark);
    return code;
}
