/* liar.c: a rule library with a wrong rule, which drops all rows of every round, and a wrong order,
 * which returns a column that was not offered. */
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

static int choose_none(void *self, const fmb_view *w, const int *col, size_t n)
{
    (void)self;
    (void)w;
    return col[n - 1] + 1;
}

static const fmb_named_chooser lost = {
    .name = "lost", .source = "none", .chooser = {.choose = choose_none}};

const fmb_named_chooser *const fmb_chooser_library[] = {&lost, NULL};
