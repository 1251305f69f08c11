/* same_rows.h: the rule of same_rows.c. */
#include <fmb/rule.h>

extern const fmb_rule same_rows;
