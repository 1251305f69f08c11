/* rows.c: what frames say, as rows of a system; see maker.h. */
#include "frame/jordan.h"
#include "frame/maker.h"
#include "system/system.h"

static mpz_t *line(const fmb_maker *m, int i)
{
    return m->cell + (size_t)i * (size_t)m->width;
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* Divide the n terms of row and its right side by what they have in common. */
static void reduce(const fmb_maker *m, size_t n)
{
    mpz_ptr g = m->scale[1];
    mpz_abs(g, m->row[0]);
    for (size_t k = 1; k <= n && mpz_cmp_ui(g, 1) != 0; k++)
        mpz_gcd(g, g, m->row[k]);
    for (size_t k = 0; k <= n && mpz_cmp_ui(g, 1) != 0; k++)
        mpz_divexact(m->row[k], m->row[k], g);
}

/* sign form REL bound */
static fmb_status add_form(const fmb_maker *m, mpz_t *form, int sign, fmb_rel rel,
                           const mpz_t bound)
{
    size_t n = 0;
    for (int j = 0; j < m->vars; j++)
        if (mpz_sgn(form[j]) != 0) {
            m->var[n] = j;
            mpz_set(m->row[n++], form[j]);
        }
    mpz_neg(m->row[n], form[m->vars]);
    for (size_t k = 0; sign < 0 && k <= n; k++)
        mpz_neg(m->row[k], m->row[k]);
    mpz_add(m->row[n], m->row[n], bound);
    if (n > 0)
        reduce(m, n);
    mpz_set_ui(m->row[n + 1], 1);
    return fmb_system_append(m->s, n, m->var, m->row, rel);
}

static fmb_status add_zero(const fmb_maker *m, mpz_t *form, int sign, fmb_rel rel)
{
    mpz_t zero;
    mpz_init(zero);
    fmb_status st = add_form(m, form, sign, rel, zero);
    mpz_clear(zero);
    return st;
}

static void clear_form(const fmb_maker *m, mpz_t *form)
{
    for (int j = 0; j <= m->vars; j++)
        mpz_set_ui(form[j], 0);
}

/* The i-th coordinate of a frame, times m->scale[0], as a form. */
typedef mpz_t *coordinate(const fmb_maker *m, int i, int from);

/* It is variable number from + i. */
static mpz_t *as_variable(const fmb_maker *m, int i, int from)
{
    clear_form(m, m->form);
    mpz_set_ui(m->form[from + i], 1);
    return m->form;
}

/* It stands in line i of the work table, from column from. */
static mpz_t *as_solved(const fmb_maker *m, int i, int from)
{
    return line(m, i) + from;
}

static fmb_status add_upper_ends(const fmb_maker *m, const fmb_whole *f, coordinate *get, int from)
{
    fmb_status st = FMB_OK;
    clear_form(m, m->sum);
    for (int i = 0; st == FMB_OK && i < f->naxes; i++) {
        mpz_t *form = get(m, i, from);
        for (int j = 0; f->shape == FMB_SIMPLEX && j <= m->vars; j++)
            mpz_add(m->sum[j], m->sum[j], form[j]);
        if (f->shape == FMB_CUBOID)
            st = add_form(m, form, 1, m->inside, m->scale[0]);
    }
    return st == FMB_OK && f->shape == FMB_SIMPLEX && f->naxes > 0
               ? add_form(m, m->sum, 1, m->inside, m->scale[0])
               : st;
}

static fmb_status add_inside(const fmb_maker *m, const fmb_whole *f, coordinate *get, int from)
{
    fmb_status st = FMB_OK;
    for (int i = 0; st == FMB_OK && i < f->naxes; i++)
        st = add_zero(m, get(m, i, from), -1, m->inside);
    return st == FMB_OK ? add_upper_ends(m, f, get, from) : st;
}

/* Those of a frame whose coordinates are variables. */
static fmb_status add_variables(const fmb_maker *m, const fmb_whole *f, int from)
{
    mpz_set_ui(m->scale[0], 1);
    return add_inside(m, f, as_variable, from);
}

/* ---- points, in units of world axis j -------------------------------------------------------- */

/* number (i, j) of a frame onto a cell, or off it. */
static void add_number(const fmb_maker *m, const fmb_whole *f, int i, int j, int sign, mpz_t cell)
{
    mpz_srcptr number = f->number[i * m->dim + j];
    if (sign > 0)
        mpz_add(cell, cell, number);
    else
        mpz_sub(cell, cell, number);
}

/* form += sign (origin + t speed) */
static void add_place(const fmb_maker *m, const fmb_whole *f, int j, int sign, mpz_t *form)
{
    add_number(m, f, 0, j, sign, form[m->vars]);
    if (f->moves)
        add_number(m, f, 1 + f->naxes, j, sign, form[m->time]);
}

/* form += sign times coordinate j of the point of f whose coordinates are variables from `from`. */
static void add_point(const fmb_maker *m, const fmb_whole *f, int from, int j, int sign,
                      mpz_t *form)
{
    for (int i = 0; i < f->naxes; i++)
        add_number(m, f, 1 + i, j, sign, form[from + i]);
    add_place(m, f, j, sign, form);
}

/* The rows of a frame whose coordinates are no variables: last is the frame whose point is looked
 * at, or NULL if the point is the variables. */
static fmb_status add_solved(const fmb_maker *m, const fmb_whole *f, const fmb_whole *last)
{
    for (int j = 0; j < m->dim; j++) {
        mpz_t *r = line(m, j), *form = r + f->naxes;
        for (int k = 0; k < m->width; k++)
            mpz_set_ui(r[k], 0);
        for (int i = 0; i < f->naxes; i++)
            add_number(m, f, 1 + i, j, 1, r[i]);
        if (last)
            add_point(m, last, 0, j, 1, form);
        else
            mpz_set(form[j], m->scene.unit[j]);
        add_place(m, f, j, -1, form);
    }
    if (!fmb_jordan(m->cell, m->dim, m->width, f->naxes, m->scale[0]))
        return FMB_ERR_ARG;
    fmb_status st = add_inside(m, f, as_solved, f->naxes);
    for (int i = f->naxes; st == FMB_OK && i < m->dim; i++)
        st = add_zero(m, line(m, i) + f->naxes, 1, FMB_EQ);
    return st;
}

/* The point of frame f is the point of frame 0, or the one that is variables. */
static fmb_status add_meeting(const fmb_maker *m, const fmb_whole *f, int from)
{
    fmb_status st = FMB_OK;
    for (int j = 0; st == FMB_OK && j < m->dim; j++) {
        clear_form(m, m->form);
        if (m->in == FMB_COORDINATES_ALL)
            mpz_set(m->form[j], m->scene.unit[j]);
        else
            add_point(m, &m->scene.frame[0], 0, j, 1, m->form);
        add_point(m, f, from, j, -1, m->form);
        st = add_zero(m, m->form, 1, FMB_EQ);
    }
    return st;
}

static fmb_status add_time(const fmb_maker *m)
{
    mpz_set_ui(m->scale[0], 1);
    fmb_status st = add_zero(m, as_variable(m, 0, m->time), -1, FMB_LE);
    return st == FMB_OK ? add_form(m, as_variable(m, 0, m->time), 1, FMB_LE, m->scale[0]) : st;
}

fmb_status fmb_maker_rows(const fmb_maker *m)
{
    const fmb_whole *frame = m->scene.frame;
    const fmb_whole *last = m->in == FMB_COORDINATES_LAST ? &frame[m->scene.frames - 1] : NULL;
    bool each = m->in == FMB_COORDINATES_EACH, all = m->in == FMB_COORDINATES_ALL;
    fmb_status st = FMB_OK;
    int from = all ? m->dim : 0;
    for (size_t k = 0; st == FMB_OK && k < m->scene.frames; k++) {
        const fmb_whole *f = &frame[k];
        if (!each && !all && f != last) {
            st = add_solved(m, f, last);
            continue;
        }
        st = add_variables(m, f, from);
        if (st == FMB_OK && (all || (each && k > 0)))
            st = add_meeting(m, f, from);
        from += f->naxes;
    }
    return st == FMB_OK && m->time >= 0 ? add_time(m) : st;
}
