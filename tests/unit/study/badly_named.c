/* badly_named.c: a rule library whose rule has the name of a built-in one. */
#include <fmb/rule.h>

static const fmb_rule kohler = {.name = "kohler", .source = "none"};

const fmb_rule *const fmb_rule_library[] = {&kohler, NULL};
