/* build.c: the systems of the table, with their variables renumbered. */
#include "property/random/agree.h"
#include "systems.h"

fmb_system *regress_build(const regress *r, const int *place)
{
    fmb_system *s = rows_none(r->dim);
    for (int i = 0; i < r->rows; i++) {
        int64_t a[REGRESS_DIM];
        for (int j = 0; j < r->dim; j++)
            a[place[j]] = r->row[i][j];
        must(fmb_system_add_int(s, a, FMB_LE, r->row[i][r->dim]));
    }
    return s;
}
