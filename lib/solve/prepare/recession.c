/* recession.c: see recession.h.
 *
 * Let z be a direction in the space of the eliminated variables with a.z < 0 for all rows a that
 * name one of them. Whatever values the other variables have, far enough along z all these rows
 * hold strictly, so none of them restricts the projection. For a single variable this means that it
 * has no upper or no lower bound. A random cone of m rows in k dimensions has such a z with
 * probability 1/2 where m = 2k (Wendel 1962); then eliminations, rays and queries may take long to
 * find that the projection has no rows.
 *
 * z is a strictly interior point of the rows with right sides 0
 * (lp/redundancy/active_set/leading_rows.h): found by a quick try in doubles or, where that fails
 * and the engines are expected to take long, by a search; proved in integers. Small systems have a
 * test in integers alone: columns of one sign are removed with all rows that name them, repeatedly;
 * then a perceptron (Rosenblatt 1958) searches for z by subtracting from z each row that does not
 * decrease along it. If all rows decrease, z is proved.
 */
#include "solve/prepare/recession.h"

#include <string.h>

#include "lp/redundancy/active_set/leading_rows.h"
#include "system/system_private.h"

/* The rows that name eliminated variables, restricted to these variables. */
typedef struct cone {
    fmb_elim *e;
    fmb_leading_rows rows;
} cone;

static const fmb_derived *live_row_of_cone(const cone *c, size_t i)
{
    return &c->e->row[c->e->live.row[i]];
}

static bool names_column_of_cone(const cone *c, const fmb_derived *r)
{
    for (size_t j = 0; j < c->rows.n; j++)
        if (fmb_vec_sgn(&r->v, c->rows.column[j]) != 0)
            return true;
    return false;
}

static void list_columns_of_cone(cone *c, const bool *drop)
{
    for (int j = 0; j < c->e->n; j++) {
        bool nonzero = false;
        for (size_t i = 0; drop[j] && !nonzero && i < c->e->live.size; i++)
            nonzero = fmb_vec_sgn(&live_row_of_cone(c, i)->v, (size_t)j) != 0;
        if (nonzero)
            c->rows.column[c->rows.n++] = (size_t)j;
    }
}

/* The rows that name these columns. False: there are equalities among them, or no columns. */
static bool list_rows_of_cone(cone *c, fmb_lp_row *row, size_t *rows)
{
    bool possible = c->rows.n > 0;
    *rows = 0;
    for (size_t i = 0; possible && i < c->e->live.size; i++) {
        const fmb_derived *r = live_row_of_cone(c, i);
        if (!names_column_of_cone(c, r))
            continue;
        possible = !r->equality;
        row[(*rows)++] = (fmb_lp_row){&r->v, FMB_LE};
    }
    return possible;
}

/* *possible false: the cone is not looked at. */
static fmb_status write_rows_of_cone(cone *c, bool *possible)
{
    size_t most = c->e->live.size, rows;
    fmb_lp_row *row;
    FMB_TRY(FMB_GET(c->e->run->mem, row, most));
    *possible = list_rows_of_cone(c, row, &rows);
    fmb_status st = *possible ? fmb_leading_rows_choose_units(&c->rows, rows, row) : FMB_OK;
    for (size_t i = 0; st == FMB_OK && *possible && i < rows; i++)
        fmb_leading_rows_add(&c->rows, row[i].v, c->e->num.t);
    fmb_mem_put(c->e->run->mem, row, most, sizeof *row);
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

fmb_status fmb_recession_drop_rows(fmb_elim *e, const bool *drop, double patience, bool *recedes)
{
    cone c = {.e = e};
    bool possible = false;
    *recedes = false;
    fmb_status st = fmb_leading_rows_open(&c.rows, e->run->mem, (size_t)e->n, e->live.size);
    if (st == FMB_OK)
        list_columns_of_cone(&c, drop);
    FMB_THEN(st, write_rows_of_cone(&c, &possible));
    if (st == FMB_OK && possible)
        st = fmb_leading_rows_find_inside(&c.rows, e->run, patience, recedes);
    if (st == FMB_OK && *recedes)
        leave_rows_behind(&c);
    fmb_leading_rows_close(&c.rows);
    return st;
}

/* ---- a small system -------------------------------------------------------------------------- */

#define SMALL_ROWS      64
#define SMALL_VARIABLES 16
/* With entries of at most so many bits and so many passes, sums of products stay within 62 bits. */
#define SMALL_BITS  20
#define SMALL_LOOKS 8

/* The rows, restricted to the eliminated variables. */
typedef struct small_system {
    size_t n, m;
    int64_t a[SMALL_ROWS][SMALL_VARIABLES];
} small_system;

static bool is_row_small(const fmb_sysrow *r)
{
    return !fmb_vec_is_wide(&r->val) && r->val.bits <= SMALL_BITS && r->rel != FMB_EQ;
}

/* Append the row, restricted to the variables with number[var] >= 0. False: it names none. */
static bool put_row_in_small_system(small_system *g, const fmb_sysrow *r, const int8_t *number)
{
    int64_t *a = g->a[g->m++];
    bool any = false;
    memset(a, 0, g->n * sizeof *a);
    for (size_t k = 0; k < r->nnz; k++) {
        int8_t j = number[r->var[k]];
        any |= j >= 0;
        if (j >= 0)
            a[j] = r->val.s[k];
    }
    return any;
}

/* False: the system is too large for this test, or a row names kept variables only. */
static bool put_in_small_system(small_system *g, const fmb_system *s, const int *place)
{
    int8_t number[SMALL_ROWS];
    g->n = g->m = 0;
    if (fmb_system_dim(s) > SMALL_ROWS || s->rows > SMALL_ROWS)
        return false;
    for (int j = 0; j < fmb_system_dim(s); j++) {
        number[j] = place[j] < 0 ? (int8_t)g->n : -1;
        g->n += place[j] < 0;
    }
    bool good = g->n <= SMALL_VARIABLES;
    for (size_t i = 0; good && i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        good = is_row_small(r) && (r->nnz == 0 || put_row_in_small_system(g, r, number));
    }
    return good;
}

/* If column j has entries of one sign only, remove the rows that name it. */
static bool leave_rows_of_one_sign(small_system *g, size_t j)
{
    bool sign[2] = {false, false};
    size_t left = 0;
    for (size_t i = 0; i < g->m; i++)
        if (g->a[i][j] != 0)
            sign[g->a[i][j] > 0] = true;
    if (sign[0] == sign[1])
        return false;
    for (size_t i = 0; i < g->m; i++)
        if (g->a[i][j] == 0)
            memmove(g->a[left++], g->a[i], g->n * sizeof **g->a); /* perhaps onto itself */
    g->m = left;
    return true;
}

/* One perceptron pass: every row that does not decrease along z is subtracted from z. True: all
 * rows decrease along z. */
static bool do_all_rows_go_down(const small_system *g, int64_t *z)
{
    bool all = true;
    for (size_t i = 0; i < g->m; i++) {
        int64_t growth_bound = 0;
        for (size_t j = 0; j < g->n; j++)
            growth_bound += g->a[i][j] * z[j];
        for (size_t j = 0; growth_bound >= 0 && j < g->n; j++)
            z[j] -= g->a[i][j];
        all &= growth_bound < 0;
    }
    return all;
}

bool fmb_recession_drops_all_at_sight(const fmb_system *s, const int *place)
{
    small_system g;
    int64_t z[SMALL_VARIABLES] = {0};
    bool more = put_in_small_system(&g, s, place), down = false;
    if (!more)
        return false;
    while (more) {
        more = false;
        for (size_t j = 0; j < g.n; j++)
            more |= leave_rows_of_one_sign(&g, j);
    }
    for (int k = 0; !down && k < SMALL_LOOKS; k++)
        down = do_all_rows_go_down(&g, z);
    return down;
}
