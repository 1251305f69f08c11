/* glpk_rows.c: rows from a problem that GLPK has read; see glpk_rows.h.
 *
 * Each side of a row and each bound of a column is one row a.x <= b; where both sides are equal
 * they are one row a.x = b.
 */
#include "io/glpk_rows.h"

#include <math.h>
#include <string.h>

typedef struct reader {
    fmb_cursor *c;
    fmb_decimals *numbers;
    glp_prob *p, *ranges;
    fmb_system *s;
    fmb_draft row;
    mpq_t low, high, range;
    int *index; /* scratch: terms of a row of p */
    double *value;
    size_t room;
    bool warned;
} reader;

/* Bytes of a name that a message shows, whole characters only. */
static int shown(const char *name)
{
    size_t n = strlen(name);
    for (n = n < 40 ? n : 40; n > 0 && ((unsigned char)name[n] & 0xC0) == 0x80;)
        n--;
    return (int)n;
}

static fmb_status add_variables(reader *r)
{
    fmb_status st = FMB_OK;
    for (int j = 1; st == FMB_OK && j <= glp_get_num_cols(r->p); j++) {
        const char *name = glp_get_col_name(r->p, j);
        st = fmb_system_add_variable(r->s, name, NULL);
        if (st == FMB_ERR_ARG)
            st = fmb_io_fail_whole(r->c, "expected different names of columns, found '%.*s' twice",
                                   shown(name), name);
    }
    return st;
}

/* ---- sides ----------------------------------------------------------------------------------- */

/* The finite ends of an interval, exactly. */
typedef struct sides {
    bool has_low, has_high;
} sides;

static bool has_low(int type)
{
    return type == GLP_LO || type == GLP_DB || type == GLP_FX;
}

static bool has_high(int type)
{
    return type == GLP_UP || type == GLP_DB || type == GLP_FX;
}

static void warn_infinite(reader *r)
{
    if (!r->warned)
        fmb_io_warn(r->c, NULL, "bounds of 1e30 and more are read as infinite");
    r->warned = true;
}

/* Ends as GLPK has them, both numbers of the text. */
static fmb_status plain_sides(reader *r, int type, double low, double high, sides *out)
{
    fmb_status st = FMB_OK;
    out->has_low = has_low(type);
    out->has_high = has_high(type);
    if (type != GLP_FX && ((out->has_low && low <= -FMB_GLPK_INFINITY) ||
                           (out->has_high && high >= FMB_GLPK_INFINITY))) {
        warn_infinite(r);
        out->has_low = out->has_low && low > -FMB_GLPK_INFINITY;
        out->has_high = out->has_high && high < FMB_GLPK_INFINITY;
    }
    if (out->has_low)
        st = fmb_decimals_exact(r->numbers, low, r->low);
    if (st == FMB_OK && out->has_high)
        st = fmb_decimals_exact(r->numbers, high, r->high);
    return st;
}

/* Ends of row i with a range R: rhs and rhs + |R| (G), rhs - |R| and rhs (L), rhs and rhs + R (E).
 */
static fmb_status range_sides(reader *r, int i, sides *out)
{
    int type = glp_get_row_type(r->ranges, i);
    double R = type == GLP_LO ? glp_get_row_lb(r->ranges, i) : glp_get_row_ub(r->ranges, i);
    bool up = type == GLP_LO || (type == GLP_FX && R > 0);
    double rhs = up ? glp_get_row_lb(r->p, i) : glp_get_row_ub(r->p, i);
    fmb_status st = fmb_decimals_exact(r->numbers, fabs(R), r->range);
    if (st == FMB_OK)
        st = fmb_decimals_exact(r->numbers, rhs, up ? r->low : r->high);
    if (st != FMB_OK)
        return st;
    if (up)
        mpq_add(r->high, r->low, r->range);
    else
        mpq_sub(r->low, r->high, r->range);
    bool infinite = fabs(R) >= FMB_GLPK_INFINITY;
    if (infinite)
        warn_infinite(r);
    *out = (sides){.has_low = up || !infinite, .has_high = !up || !infinite};
    return FMB_OK;
}

/* ---- rows ------------------------------------------------------------------------------------ */

static fmb_status append(reader *r, fmb_rel rel, const char *label)
{
    fmb_status st = fmb_draft_append(r->c, r->c->begin, &r->row, rel, r->s);
    if (st == FMB_OK && label)
        st = fmb_system_set_label(r->s, fmb_system_rows(r->s) - 1, label);
    return st;
}

/* low <= terms <= high, the terms being in r->row. */
static fmb_status append_sides(reader *r, int type, sides ends, const char *label)
{
    fmb_status st = FMB_OK;
    if (type == GLP_FX) {
        mpq_set(r->row.rhs, r->low);
        return append(r, FMB_EQ, label);
    }
    if (ends.has_low) {
        mpq_set(r->row.rhs, r->low);
        fmb_draft_negate(&r->row);
        st = append(r, FMB_LE, label);
        fmb_draft_negate(&r->row);
    }
    if (st == FMB_OK && ends.has_high) {
        mpq_set(r->row.rhs, r->high);
        st = append(r, FMB_LE, label);
    }
    return st;
}

static fmb_status read_terms(reader *r, int i)
{
    fmb_status st = FMB_OK;
    int n = glp_get_mat_row(r->p, i, r->index, r->value);
    fmb_draft_reset(&r->row);
    for (int k = 1; st == FMB_OK && k <= n; k++) {
        mpq_ptr slot;
        st = fmb_draft_term(&r->row, r->index[k] - 1, &slot);
        if (st == FMB_OK)
            st = fmb_decimals_exact(r->numbers, r->value[k], slot);
    }
    return st;
}

static fmb_status add_row(reader *r, int i)
{
    int type = glp_get_row_type(r->p, i);
    sides ends;
    if (type == GLP_FR)
        return FMB_OK;
    fmb_status st = type == GLP_DB && r->ranges ? range_sides(r, i, &ends)
                                                : plain_sides(r, type, glp_get_row_lb(r->p, i),
                                                              glp_get_row_ub(r->p, i), &ends);
    if (st == FMB_OK)
        st = read_terms(r, i);
    return st == FMB_OK ? append_sides(r, type, ends, glp_get_row_name(r->p, i)) : st;
}

static fmb_status add_bounds(reader *r, int j)
{
    int type = glp_get_col_type(r->p, j);
    const char *name = glp_get_col_name(r->p, j);
    double low = glp_get_col_lb(r->p, j), high = glp_get_col_ub(r->p, j);
    sides ends;
    mpq_ptr slot;
    if (type == GLP_FR)
        return FMB_OK;
    if (type == GLP_DB && low == 0 && high < 0)
        fmb_io_warn(r->c, NULL, "column '%.*s' has a negative upper bound; its lower bound stays 0",
                    shown(name), name);
    fmb_status st = plain_sides(r, type, low, high, &ends);
    fmb_draft_reset(&r->row);
    if (st == FMB_OK)
        st = fmb_draft_term(&r->row, j - 1, &slot);
    if (st != FMB_OK)
        return st;
    mpq_set_ui(slot, 1, 1);
    return append_sides(r, type, ends, NULL);
}

static void warn_ignored(const reader *r)
{
    bool objective = false;
    for (int j = 1; j <= glp_get_num_cols(r->p); j++)
        objective = objective || glp_get_obj_coef(r->p, j) != 0;
    if (objective)
        fmb_io_warn(r->c, NULL, "the objective is ignored");
    if (glp_get_num_int(r->p) > 0)
        fmb_io_warn(r->c, NULL, "integrality is ignored");
}

static fmb_status read_all(reader *r)
{
    fmb_status st = add_variables(r);
    for (int i = 1; st == FMB_OK && i <= glp_get_num_rows(r->p); i++)
        st = add_row(r, i);
    for (int j = 1; st == FMB_OK && j <= glp_get_num_cols(r->p); j++)
        st = add_bounds(r, j);
    if (st == FMB_OK)
        warn_ignored(r);
    return st;
}

fmb_status fmb_glpk_rows(fmb_cursor *c, fmb_decimals *numbers, glp_prob *p, glp_prob *ranges,
                         fmb_system *s)
{
    reader r = {.c = c, .numbers = numbers, .p = p, .ranges = ranges, .s = s};
    r.room = (size_t)glp_get_num_cols(p) + 1;
    r.index = fmb_mem_get(c->mem, r.room, sizeof *r.index);
    r.value = fmb_mem_get(c->mem, r.room, sizeof *r.value);
    fmb_status st = r.index && r.value ? FMB_OK : fmb_mem_status(c->mem);
    fmb_draft_init(&r.row, c->mem);
    mpq_inits(r.low, r.high, r.range, (mpq_ptr)NULL);
    if (st == FMB_OK)
        st = read_all(&r);
    mpq_clears(r.low, r.high, r.range, (mpq_ptr)NULL);
    fmb_draft_clear(&r.row);
    fmb_mem_put(c->mem, r.index, r.room, sizeof *r.index);
    fmb_mem_put(c->mem, r.value, r.room, sizeof *r.value);
    return st;
}
