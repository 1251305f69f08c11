/* box.c: rows that hold strictly in all of the box.
 *
 * The rows with one variable are a box. A row with max a.x < b over the box is dropped, together
 * with all that would be made from it. Why that is sound, beside history rules, too: let x be in
 * the box but not in the projection, and let y, with sum 1 over the rows outside the box, be the
 * combination that x violates most. If some part of y made a row that is strictly slack over the
 * box, then that row is also a combination of rows of the box plus 0 <= c, c > 0; put in its place,
 * it makes x violate y by more, with less weight outside the box. So no part of the y that is
 * violated most, which can be chosen extreme, was dropped by this rule or by a rule of histories.
 * With "at most" in place of "less" this fails: two rows could be dropped each because of the
 * other. Source: Baillehache 2020 (the inconsistency test, of which this is the twin).
 *
 * Numbers to check: 0 <= x, y <= 1, x + y < 3: gone before the first round; x + y <= 2 stays. The
 * cuboids of kohler.c need 27 rows with it and chernikov, 59 with chernikov alone.
 */
#include "rule/rule.h"

static bool drop_row(void *state, const fmb_view *w, size_t row)
{
    (void)state;
    return fmb_view_slack(w, row) > 0;
}

const fmb_rule fmb_rule_box = {
    .name = "box",
    .source = "Baillehache2020",
    .drop_row = drop_row,
};
