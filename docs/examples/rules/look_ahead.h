/* look_ahead.h: the order of look_ahead.c. */
#include <fmb/rule.h>

extern const fmb_named_chooser look_ahead;
