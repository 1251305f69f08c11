/* glpk_read.c: MPS and CPLEX LP files. GLPK says what is where, the text itself which numbers.
 *
 * Source: GLPK 5.0 Reference Manual, 2020, appendices B (MPS) and C (CPLEX LP).
 */
#include "io/glpk_lp.h"
#include "io/glpk_mps.h"
#include "io/glpk_rows.h"
#include "io/glpk_run.h"

/* ---- MPS ------------------------------------------------------------------------------------- */

typedef struct mps {
    fmb_glpk g;
    fmb_decimals numbers;
    fmb_mps_edit edit;
    bool fixed;
    glp_prob *p, *ranges;
} mps;

/* *line is how far GLPK came. */
static fmb_status try_form(mps *m, bool fixed, long *line)
{
    m->fixed = fixed;
    fmb_status st = fmb_mps_edit_run(&m->edit, fixed, false);
    if (st != FMB_OK)
        return st;
    fmb_span text = {m->edit.text, m->edit.size};
    st = fmb_glpk_read(&m->g, fixed ? FMB_GLPK_FIXED : FMB_GLPK_FREE, text, &m->p);
    if (st != FMB_ERR_PARSE)
        return st;
    *line = fmb_glpk_line(&m->g);
    return fmb_glpk_fail(&m->g);
}

/* Fixed form is tried first: it is the stricter one. If neither will do, the one that GLPK read
 * further as is the one that was meant. */
static fmb_status read_either(mps *m)
{
    long fixed_line = 0, free_line = 0;
    fmb_status st = try_form(m, true, &fixed_line);
    if (st != FMB_ERR_PARSE)
        return st;
    fmb_where fixed = *m->g.c->where;
    if (m->p)
        glp_delete_prob(m->p);
    m->p = NULL;
    st = try_form(m, false, &free_line);
    if (st == FMB_ERR_PARSE && fixed_line > free_line && free_line > 0)
        *m->g.c->where = fixed;
    return st;
}

/* The ranges themselves: GLPK gives only where they end, rounded. */
static fmb_status read_ranges(mps *m)
{
    if (!m->edit.has_ranges)
        return FMB_OK;
    fmb_status st = fmb_mps_edit_run(&m->edit, m->fixed, true);
    if (st != FMB_OK)
        return st;
    fmb_span text = {m->edit.text, m->edit.size};
    st = fmb_glpk_read(&m->g, m->fixed ? FMB_GLPK_FIXED : FMB_GLPK_FREE, text, &m->ranges);
    return st == FMB_ERR_PARSE ? fmb_glpk_fail(&m->g) : st;
}

static fmb_status read_mps(mps *m, fmb_system *s)
{
    fmb_status st = read_either(m);
    if (st == FMB_OK)
        st = fmb_glpk_warn(&m->g);
    if (st == FMB_OK)
        st = read_ranges(m);
    if (st == FMB_OK && m->edit.has_integers && glp_get_num_int(m->p) == 0)
        fmb_io_warn(m->g.c, NULL, "integrality is ignored");
    return st == FMB_OK ? fmb_glpk_rows(m->g.c, &m->numbers, m->p, m->ranges, s) : st;
}

fmb_status fmb_read_mps(fmb_cursor *c, fmb_system *s)
{
    mps m = {.p = NULL};
    fmb_status st = fmb_glpk_open(&m.g, c);
    if (st != FMB_OK)
        return st;
    st = fmb_decimals_init(&m.numbers, c);
    fmb_mps_edit_init(&m.edit, c, &m.numbers);
    if (st == FMB_OK)
        st = read_mps(&m, s);
    if (m.p)
        glp_delete_prob(m.p);
    if (m.ranges)
        glp_delete_prob(m.ranges);
    fmb_mps_edit_clear(&m.edit);
    fmb_decimals_clear(&m.numbers);
    fmb_glpk_close(&m.g);
    return st;
}

/* ---- CPLEX LP -------------------------------------------------------------------------------- */

static fmb_status read_lp(fmb_glpk *g, fmb_lp_edit *edit, glp_prob **p)
{
    fmb_status st = fmb_lp_edit_run(edit);
    if (st != FMB_OK)
        return st;
    st = fmb_glpk_read(g, FMB_GLPK_LP, (fmb_span){edit->text, edit->size}, p);
    if (st == FMB_OK)
        st = fmb_glpk_warn(g);
    else if (st == FMB_ERR_PARSE)
        st = fmb_glpk_fail(g);
    return st;
}

fmb_status fmb_read_lp(fmb_cursor *c, fmb_system *s)
{
    fmb_glpk g;
    fmb_decimals numbers;
    fmb_lp_edit edit;
    glp_prob *p = NULL;
    fmb_status st = fmb_glpk_open(&g, c);
    if (st != FMB_OK)
        return st;
    st = fmb_decimals_init(&numbers, c);
    fmb_lp_edit_init(&edit, c, &numbers);
    if (st == FMB_OK)
        st = read_lp(&g, &edit, &p);
    if (st == FMB_OK)
        st = fmb_glpk_rows(c, &numbers, p, NULL, s);
    if (p)
        glp_delete_prob(p);
    fmb_lp_edit_clear(&edit);
    fmb_decimals_clear(&numbers);
    fmb_glpk_close(&g);
    return st;
}
