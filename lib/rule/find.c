/* find.c: the built-in rules by name. */
#include <string.h>

#include "rule/rule.h"

static const fmb_rule *const BUILT_IN[] = {&fmb_rule_duplicate, &fmb_rule_kohler};

const fmb_rule *fmb_rule_at(size_t i)
{
    return i < sizeof BUILT_IN / sizeof *BUILT_IN ? BUILT_IN[i] : NULL;
}

const fmb_rule *fmb_rule_find(const char *name, size_t size)
{
    const fmb_rule *r;
    for (size_t i = 0; (r = fmb_rule_at(i)) != NULL; i++)
        if (strlen(r->name) == size && memcmp(r->name, name, size) == 0)
            return r;
    return NULL;
}
