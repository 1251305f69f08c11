/* escape.c: see escape.h.
 *
 * Let z be a direction among the variables that go, in which all rows that name one of these go
 * down: a.z < 0. Whatever values the other variables have, far enough along z all of those rows
 * hold, strictly: none of them is left in the projection. For one variable, that is one that has no
 * upper or no lower bound. A cone of m rows in k dimensions, drawn around 0 at random, has such a z
 * with a chance of 1/2 where m = 2k (Wendel 1962), and then eliminations, rays and queries may take
 * long to find out that there is nothing to find.
 *
 * The direction is a point strictly inside the rows with right sides 0 (lp/redundancy/inside.h): a
 * glance in doubles, proved in integers.
 */
#include "solve/project/escape.h"

#include "lp/redundancy/inside.h"

/* The rows that name variables that go, in those. */
typedef struct cone {
    fmb_elim *e;
    size_t n, m;
    int *column;     /* [n] of e */
    fmb_vec *v;      /* [m] */
    fmb_lp_row *row; /* [m] */
} cone;

static const fmb_derived *live_row_of_cone(const cone *c, size_t i)
{
    return &c->e->row[c->e->live.row[i]];
}

static bool names_column_of_cone(const cone *c, const fmb_derived *r)
{
    for (size_t j = 0; j < c->n; j++)
        if (fmb_vec_sgn(&r->v, (size_t)c->column[j]) != 0)
            return true;
    return false;
}

static fmb_status list_columns_of_cone(cone *c, const bool *drop, fmb_arena *arena)
{
    c->column = fmb_arena_get(arena, (size_t)c->e->n, sizeof *c->column);
    for (int j = 0; c->column && j < c->e->n; j++) {
        bool named = false;
        for (size_t i = 0; drop[j] && !named && i < c->e->live.size; i++)
            named = fmb_vec_sgn(&live_row_of_cone(c, i)->v, (size_t)j) != 0;
        if (named)
            c->column[c->n++] = j;
    }
    return c->column ? FMB_OK : fmb_mem_status(arena->mem);
}

static void add_row_to_cone(cone *c, const fmb_vec *v, int64_t *value)
{
    for (size_t j = 0; j < c->n; j++)
        value[j] = v->s[c->column[j]];
    value[c->n] = 0;
    c->v[c->m] = (fmb_vec){.s = value, .bits = v->bits};
    c->row[c->m] = (fmb_lp_row){&c->v[c->m], FMB_LE};
    c->m++;
}

/* *possible false: there are equalities, or long numbers. */
static fmb_status list_rows_of_cone(cone *c, fmb_arena *arena, bool *possible)
{
    size_t rows = c->e->live.size, size = c->n + 1;
    c->v = fmb_arena_get(arena, rows, sizeof *c->v);
    c->row = fmb_arena_get(arena, rows, sizeof *c->row);
    int64_t *value = fmb_arena_get(arena, rows * size, sizeof *value);
    if (!c->v || !c->row || !value)
        return fmb_mem_status(arena->mem);
    *possible = c->n > 0;
    for (size_t i = 0; *possible && i < rows; i++) {
        const fmb_derived *r = live_row_of_cone(c, i);
        if (!names_column_of_cone(c, r))
            continue;
        *possible = !r->equality && !fmb_vec_is_wide(&r->v);
        if (*possible)
            add_row_to_cone(c, &r->v, &value[c->m * size]);
    }
    return FMB_OK;
}

static fmb_status look_for_direction(const cone *c, bool *found)
{
    fmb_inside p;
    bool possible;
    fmb_status st = fmb_inside_open(&p, c->e->run, c->n, c->m, c->row, &possible);
    if (st == FMB_OK && possible)
        st = fmb_inside_glance(&p, found);
    fmb_inside_clear(&p);
    return st;
}

static void leave_rows_behind(cone *c)
{
    size_t left = 0;
    for (size_t i = 0; i < c->e->live.size; i++)
        if (!names_column_of_cone(c, live_row_of_cone(c, i)))
            c->e->live.row[left++] = c->e->live.row[i];
    c->e->live.size = left;
}

fmb_status fmb_escape(fmb_elim *e, const bool *drop, fmb_arena *arena, bool *escapes)
{
    cone c = {.e = e};
    bool possible = false;
    *escapes = false;
    fmb_status st = list_columns_of_cone(&c, drop, arena);
    if (st == FMB_OK)
        st = list_rows_of_cone(&c, arena, &possible);
    if (st == FMB_OK && possible)
        st = look_for_direction(&c, escapes);
    if (st == FMB_OK && *escapes)
        leave_rows_behind(&c);
    return st;
}
