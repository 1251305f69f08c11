/* box.c: rows that hold strictly in all of the box.
 *
 * The rows with one variable are a box, perhaps with a budget (a simplex). A row with max a.x < b
 * over it is dropped, together with all that would be made from it; rows of the box itself, and
 * rows made of nothing but these, are not. Why that is sound, beside history rules, too: let x be
 * outside the projection. If it is outside the projection of the box, rows made of rows of the box
 * tell. If not, let y, with sum 1 over the other rows, be the combination that x violates most. If
 * some part of y made a row that is strictly slack over the box, then that row is also a
 * combination of rows of the box plus 0 <= c, c > 0 (Farkas); put in its place, it makes x violate
 * y by more, with less weight outside the box, which is impossible. So no part of the y that is
 * violated most, which can be chosen extreme, was dropped by this rule or by a rule of histories.
 * With "at most" in place of "less" this fails: two rows could be dropped each because of the
 * other. Only before histories start does a row go that touches the box: the box, which stays,
 * implies it. Source: Baillehache 2020 (the inconsistency test, which asks the same of infeasible
 * rows).
 *
 * Numbers to check: 0 <= x, y <= 1, x + y <= 2: gone before the first round; x + y < 2 stays. The
 * cuboids of kohler.c need 26 rows with it and chernikov, 59 with chernikov alone.
 */
#include "rule/rule_private.h"

static bool drop_row_slack_in_box(void *state, const fmb_view *w, size_t row)
{
    bool started = fmb_view_column(w) >= 0;
    (void)state;
    if (!started && fmb_view_rel(w, row) == FMB_LE && fmb_view_slack(w, row) == 0)
        return true;
    return fmb_view_slack(w, row) > 0;
}

const fmb_rule fmb_rule_box = {
    .name = "box",
    .source = "Baillehache2020",
    .drop_row = drop_row_slack_in_box,
};
