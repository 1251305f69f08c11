/* rule_library.c: the rule of same_rows.c for --rule-library of the commands. */
#include "same_rows.h"

const fmb_rule *const fmb_rule_library[] = {&same_rows, NULL};
