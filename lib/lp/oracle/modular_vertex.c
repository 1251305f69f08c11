/* modular_vertex.c: the vertex of a guessed basis, where its numbers are short; see oracle.h.
 *
 * Rows of the basis are solved modulo one prime; or where columns are many, the point of the guess
 * is rounded to integers, as vertices of networks are. If the point that comes out satisfies all
 * rows, it is a solution of the closure, and that is all that is claimed: no factor is needed, nor
 * lifting.
 */
#include "base/ways.h"
#include "lp/oracle/oracle_state.h"

/* More columns take longer than a sparse factor. */
#define MOST_COLUMNS 32
/* Numbers that are long so many times more often than short stay so. */
#define MOST_MISSES 8

/* Row i of the basis as row r of the system; false: its numbers are long. */
static bool put_basis_row(fmb_oracle *o, size_t r, size_t i)
{
    if (i >= o->p->m) {
        fmb_modular_kernel_put(&o->few, r, i - o->p->m, 1);
        return true;
    }
    const fmb_program_row *row = &o->p->row[i];
    if (row->value->z)
        return false;
    for (size_t k = 0; k < row->size; k++)
        fmb_modular_kernel_put(&o->few, r, (size_t)row->column[k], row->value->s[k]);
    fmb_modular_kernel_put(&o->few, r, o->n, -row->value->s[row->size]);
    return true;
}

static bool solve_basis(fmb_oracle *o)
{
    fmb_modular_kernel_zero(&o->few, o->n + 1);
    for (size_t r = 0; r < o->n; r++)
        if (!put_basis_row(o, r, o->hint[r]))
            return false;
    return fmb_modular_kernel_find(&o->few) && o->few.v[o->n] != 0;
}

static void take_short_point(fmb_oracle *o)
{
    const int64_t *v = o->few.v;
    for (size_t j = 0; j < o->n; j++)
        fmb_integer_set_i64(o->point.z[j], v[o->n] < 0 ? -v[j] : v[j]);
    fmb_integer_set_i64(o->point_den, v[o->n] < 0 ? -v[o->n] : v[o->n]);
}

static fmb_status find_short_point(fmb_oracle *o, bool *found)
{
    fmb_status st = FMB_OK;
    *found = false;
    if (o->n > MOST_COLUMNS) {
        *found = fmb_backend_point(o->backend, 0, o->point.z, o->point_den);
        return FMB_OK;
    }
    if (!o->few.a)
        st = fmb_modular_kernel_init(&o->few, o->run->mem, o->n);
    fmb_run_count(o->run, o->n * o->n * (o->n + 4));
    *found = st == FMB_OK && solve_basis(o);
    if (*found)
        take_short_point(o);
    return st;
}

fmb_status fmb_oracle_try_modular_vertex(fmb_oracle *o, bool *seen)
{
    *seen = false;
    if (o->misses > MOST_MISSES || !fmb_way(FMB_WAY_MODULAR_VERTEX))
        return FMB_OK;
    fmb_status st = find_short_point(o, seen);
    if (st == FMB_OK && *seen)
        st = fmb_vertex_try_point(&o->v, o->point.z, o->point_den, o->price, false, seen);
    fmb_way_answered(FMB_WAY_MODULAR_VERTEX, *seen);
    o->misses += *seen ? -(o->misses > 0) : 1;
    return st == FMB_OK ? fmb_integers_settle(&o->point, o->run->mem) : st;
}
