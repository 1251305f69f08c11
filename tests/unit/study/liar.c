/* liar.c: a rule library with a rule that is wrong: it drops all rows of every round. */
#include <fmb/rule.h>

static fmb_status drop_all(void *state, const fmb_view *w, bool *drop)
{
    (void)state;
    for (size_t i = 0; i < fmb_view_rows(w); i++)
        drop[i] = true;
    return FMB_OK;
}

static const fmb_rule liar = {
    .name = "liar", .source = "none", .flags = FMB_RULE_BREAKS_HISTORY, .end_round = drop_all};

const fmb_rule *const fmb_rule_library[] = {&liar, NULL};
