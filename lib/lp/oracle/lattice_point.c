/* lattice_point.c: solutions on a grid, found without solving anything exactly.
 *
 * Theorem. If a_i.x <= b_i - g |a_i|_1 for every row, x may be rounded to multiples of g: that
 * changes a_i.x by g/2 |a_i|_1 at most, so the rows hold, and strict ones strictly. (Coordinates
 * may have grids of their own: then g |a_i|_1 is the sum of g_j |a_ij|.)
 *
 * Such an x is a vertex of rows with lowered right sides, which doubles find from the current
 * vertex, mostly in a few pivots. Its numbers are as short as the grid is coarse, while those of a
 * vertex are determinants. Doubles guess; the given rows decide.
 */
#include <math.h>

#include "lp/oracle/oracle_state.h"

/* Grids of 2^-fine: the coarsest for which right sides are lowered, the difference to the next one,
 * and the finest. */
#define COARSE 10
#define FINER  20
#define FINEST 30
/* Coarser grids are tried before a grid, with this difference. */
#define STRIDE 5

/* Try the guess rounded to coarser grids first, beginning with integers. */
static fmb_status try_rounded(fmb_oracle *o, int finest, bool *found)
{
    for (int fine = 0; !*found && fine <= finest; fine += STRIDE) {
        if (!fmb_backend_point(o->backend, fine, o->point.z, o->point_den))
            return FMB_OK;
        FMB_TRY(fmb_vertex_try_point(&o->v, o->point.z, o->point_den, o->price, found));
    }
    return fmb_integers_settle(&o->point, o->run->mem);
}

/* Lowered twice as much as the theorem requires: doubles accept rows that are violated a little. */
static fmb_status move_in_and_search(fmb_oracle *o, int fine, fmb_hint *h, bool *found)
{
    fmb_backend_move_in(o->backend, ldexp(1, -fine));
    fmb_status st = fmb_backend_search(o->backend, NULL, h);
    if (st == FMB_OK && h->kind == FMB_HINT_OPTIMUM)
        st = try_rounded(o, fine, found);
    fmb_backend_shift(o->backend, NULL);
    return st;
}

static bool has_equality(const fmb_program *p)
{
    for (size_t i = 0; i < p->m; i++)
        if (p->row[i].rel == FMB_EQ && !p->row[i].off)
            return true;
    return false;
}

fmb_status fmb_oracle_try_lattice_point(fmb_oracle *o, fmb_hint *h, bool *found)
{
    fmb_status st = try_rounded(o, COARSE, found);
    if (*found || st != FMB_OK || o->tight || has_equality(o->p))
        return st;
    for (int fine = COARSE; st == FMB_OK && !*found && fine <= FINEST; fine += FINER)
        st = move_in_and_search(o, fine, h, found);
    return st == FMB_OK && !*found ? fmb_closure_guess(o, h) : st;
}
