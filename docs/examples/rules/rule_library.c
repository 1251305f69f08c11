/* rule_library.c: the rule of same_rows.c and the order of look_ahead.c for --rule-library of the
 * commands. A library may also have rules alone, or orders. */
#include "look_ahead.h"
#include "same_rows.h"

const fmb_rule *const fmb_rule_library[] = {&same_rows, NULL};
const fmb_named_chooser *const fmb_chooser_library[] = {&look_ahead, NULL};
