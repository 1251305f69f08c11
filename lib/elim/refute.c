/* refute.c: the article's inconsistency test.
 *
 * If the least value of a.x over the box is more than b, then the row and the rows that make those
 * ends combine to a row 0 <= negative: one combination for each variable of the row. Source:
 * Baillehache 2020.
 */
#include "elim/elim.h"

fmb_status fmb_elim_refute(fmb_elim *e, uint32_t r)
{
    fmb_status st = FMB_OK;
    for (size_t c = 0; st == FMB_OK && c < (size_t)e->n && e->clash == FMB_NO_ROW; c++) {
        int sign = fmb_vec_sgn(&e->row[r].v, c);
        if (sign == 0)
            continue;
        st = fmb_elim_derive_row(e, r, e->box.row[sign < 0][c], (int)c, &r);
    }
    return st;
}
