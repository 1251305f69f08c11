/* box.c: drops rows that hold strictly in the whole box.
 *
 * The rows with one variable form a box, perhaps with a budget (a simplex). A row with max a.x < b
 * over the box is dropped, and with it everything that would be derived from it; rows of the box
 * itself, and rows derived from these only, are not. This is sound, also beside history rules: let
 * x be outside the projection. If it is outside the projection of the box, rows derived from rows
 * of the box exclude it. Otherwise let y, with sum 1 over the other rows, be the combination that x
 * violates most. If some part of y made a row that is strictly slack over the box, then that row is
 * also a combination of rows of the box plus 0 <= c, c > 0 (Farkas); in place of that part, this
 * makes x violate y by more, with less weight outside the box, which is impossible. So no part of
 * the y that is violated most, which can be chosen extreme, was dropped by this rule or by a
 * history rule. With "at most" in place of "less" this fails: each of two rows could be dropped
 * because of the other. Only before histories start may a row be dropped that touches the box: the
 * box, which is kept, implies it. Source: Baillehache 2020 (the inconsistency test: rows that fail
 * in the whole box).
 *
 * Numbers to check: 0 <= x, y <= 1, x + y <= 2: dropped before the first round; x + y < 2 is kept.
 * The cuboids of kohler.c need 26 rows with this rule and chernikov, 59 with chernikov alone.
 */
#include "rule/rule_private.h"

static bool drop_row_slack_in_box(void *state, const fmb_view *w, size_t row)
{
    bool started = fmb_view_column(w) >= 0;
    (void)state;
    int slack = fmb_view_slack(w, row);
    return slack > 0 || (slack == 0 && !started && fmb_view_rel(w, row) == FMB_LE);
}

const fmb_rule fmb_rule_box = {
    .name = "box",
    .source = "Baillehache2020",
    .drop_row = drop_row_slack_in_box,
};
