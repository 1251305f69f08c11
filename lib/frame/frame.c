/* frame.c: from frames to a system; see fmb/frame.h.
 *
 * Everything is an affine form of the variables: vars coefficients, then the constant. A point p of
 * R^D is D forms. Its coordinates in a frame solve A c = p - origin - t speed; Gauss and Jordan's
 * elimination on [A | p - origin - t speed] leaves them as forms in the rows with pivots, and one
 * equality 0 = form in each row without.
 */
#include <fmb/frame.h>

#include <math.h>

#include "frame/frame.h"
#include "system/system.h"

typedef struct maker {
    const fmb_frame *frame;
    size_t frames;
    fmb_system *s;
    int dim;
    int vars, time; /* columns; the one of t, or -1 */
    fmb_rel inside; /* of the rows that hold a frame's coordinates */
    mpq_t *cell;    /* the work table: [dim][width], then a spare row */
    int width;      /* most axes + vars + 1 */
    int *var;       /* [vars] 0, 1, ... */
} maker;

static mpq_t *row(const maker *m, int i)
{
    return m->cell + (size_t)i * (size_t)m->width;
}

/* ---- arguments ------------------------------------------------------------------------------- */

static bool are_finite(const double *a, int n)
{
    bool good = a || n == 0;
    for (int i = 0; good && i < n; i++)
        good = isfinite(a[i]);
    return good;
}

bool fmb_frame_is_good(const fmb_frame *f, int dim)
{
    return f->dim == dim && dim >= 0 && f->naxes >= 0 && f->naxes <= dim &&
           (f->shape == FMB_CUBOID || f->shape == FMB_SIMPLEX) && are_finite(f->origin, dim) &&
           are_finite(f->axes, f->naxes * dim) && (!f->speed || are_finite(f->speed, dim));
}

static bool are_frames(const fmb_frame *f, size_t n)
{
    bool good = f && n > 0;
    for (size_t i = 0; good && i < n; i++)
        good = fmb_frame_is_good(&f[i], f[0].dim);
    return good;
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* sign form REL bound. Spoils the form. */
static fmb_status add_form(const maker *m, mpq_t *form, int sign, fmb_rel rel, int bound)
{
    mpq_t b, c;
    mpq_inits(b, c, NULL);
    mpq_set_si(b, bound, 1);
    mpq_set_si(c, -sign, 1);
    mpq_mul(c, c, form[m->vars]);
    mpq_add(b, b, c);
    for (int j = 0; sign < 0 && j < m->vars; j++)
        mpq_neg(form[j], form[j]);
    fmb_status st = fmb_system_add_q(m->s, (size_t)m->vars, m->var, form, rel, b);
    mpq_clears(b, c, NULL);
    return st;
}

/* out = in, or out = 0 if in is NULL; forms. */
static void set_form(const maker *m, mpq_t *out, mpq_t *in)
{
    for (int j = 0; j <= m->vars; j++)
        if (in)
            mpq_set(out[j], in[j]);
        else
            mpq_set_ui(out[j], 0, 1);
}

/* The i-th coordinate of a frame, as a form. */
typedef void coordinate(const maker *m, int i, int from, mpq_t *out);

/* It is variable number from + i. */
static void as_variable(const maker *m, int i, int from, mpq_t *out)
{
    set_form(m, out, NULL);
    mpq_set_ui(out[from + i], 1, 1);
}

/* It stands in row i of the work table, from column from. */
static void as_solved(const maker *m, int i, int from, mpq_t *out)
{
    set_form(m, out, row(m, i) + from);
}

static fmb_status add_upper_ends(const maker *m, const fmb_frame *f, coordinate *get, int from)
{
    mpq_t *form = row(m, m->dim), *sum = row(m, m->dim + 1);
    fmb_status st = FMB_OK;
    set_form(m, sum, NULL);
    for (int i = 0; st == FMB_OK && i < f->naxes; i++) {
        get(m, i, from, form);
        for (int j = 0; j <= m->vars; j++)
            mpq_add(sum[j], sum[j], form[j]);
        if (f->shape == FMB_CUBOID)
            st = add_form(m, form, 1, m->inside, 1);
    }
    return st == FMB_OK && f->shape == FMB_SIMPLEX && f->naxes > 0
               ? add_form(m, sum, 1, m->inside, 1)
               : st;
}

static fmb_status add_inside(const maker *m, const fmb_frame *f, coordinate *get, int from)
{
    mpq_t *form = row(m, m->dim);
    fmb_status st = FMB_OK;
    for (int i = 0; st == FMB_OK && i < f->naxes; i++) {
        get(m, i, from, form);
        st = add_form(m, form, -1, m->inside, 0);
    }
    return st == FMB_OK ? add_upper_ends(m, f, get, from) : st;
}

/* ---- points ---------------------------------------------------------------------------------- */

/* form[column] += sign * value */
static void add_to(mpq_t cell, int sign, double value)
{
    mpq_t t;
    mpq_init(t);
    mpq_set_d(t, value);
    if (sign < 0)
        mpq_neg(t, t);
    mpq_add(cell, cell, t);
    mpq_clear(t);
}

/* form += sign (origin + t speed) of world axis j */
static void add_place(const maker *m, const fmb_frame *f, int j, int sign, mpq_t *form)
{
    add_to(form[m->vars], sign, f->origin[j]);
    if (f->speed)
        add_to(form[m->time], sign, f->speed[j]);
}

/* form += sign times coordinate j of the point of f whose coordinates are variables from `from`. */
static void add_point(const maker *m, const fmb_frame *f, int from, int j, int sign, mpq_t *form)
{
    for (int i = 0; i < f->naxes; i++)
        add_to(form[from + i], sign, f->axes[i * f->dim + j]);
    add_place(m, f, j, sign, form);
}

/* ---- solving for coordinates ----------------------------------------------------------------- */

static void swap_rows(const maker *m, int a, int b)
{
    for (int j = 0; a != b && j < m->width; j++)
        mpq_swap(row(m, a)[j], row(m, b)[j]);
}

/* Make column c the unit vector with its one in row c, using a row from c on; false if none has the
 * column. */
static bool pivot(const maker *m, int c)
{
    int p = c;
    while (p < m->dim && mpq_sgn(row(m, p)[c]) == 0)
        p++;
    if (p == m->dim)
        return false;
    swap_rows(m, c, p);
    mpq_t t, u;
    mpq_inits(t, u, NULL);
    mpq_set(u, row(m, c)[c]);
    for (int j = 0; j < m->width; j++)
        mpq_div(row(m, c)[j], row(m, c)[j], u);
    for (int i = 0; i < m->dim; i++) {
        if (i == c || mpq_sgn(row(m, i)[c]) == 0)
            continue;
        mpq_set(u, row(m, i)[c]);
        for (int j = 0; j < m->width; j++) {
            mpq_mul(t, u, row(m, c)[j]);
            mpq_sub(row(m, i)[j], row(m, i)[j], t);
        }
    }
    mpq_clears(t, u, NULL);
    return true;
}

/* The rows of a frame whose coordinates are no variables: last is the frame whose point is looked
 * at, or NULL if the point is the variables. */
static fmb_status add_solved(const maker *m, const fmb_frame *f, const fmb_frame *last)
{
    for (int j = 0; j < m->dim; j++) {
        mpq_t *r = row(m, j), *form = r + f->naxes;
        for (int k = 0; k < m->width; k++)
            mpq_set_ui(r[k], 0, 1);
        for (int i = 0; i < f->naxes; i++)
            mpq_set_d(r[i], f->axes[i * f->dim + j]);
        if (last)
            add_point(m, last, 0, j, 1, form);
        else
            mpq_set_ui(form[j], 1, 1);
        add_place(m, f, j, -1, form);
    }
    for (int c = 0; c < f->naxes; c++)
        if (!pivot(m, c))
            return FMB_ERR_ARG;
    fmb_status st = add_inside(m, f, as_solved, f->naxes);
    for (int i = f->naxes; st == FMB_OK && i < m->dim; i++)
        st = add_form(m, row(m, i) + f->naxes, 1, FMB_EQ, 0);
    return st;
}

/* The point of frame k is the point of frame 0, or the one that is variables. */
static fmb_status add_meeting(const maker *m, size_t k, int from, bool is_variables)
{
    fmb_status st = FMB_OK;
    for (int j = 0; st == FMB_OK && j < m->dim; j++) {
        mpq_t *form = row(m, j);
        set_form(m, form, NULL);
        if (is_variables)
            mpq_set_ui(form[j], 1, 1);
        else
            add_point(m, &m->frame[0], 0, j, 1, form);
        add_point(m, &m->frame[k], from, j, -1, form);
        st = add_form(m, form, 1, FMB_EQ, 0);
    }
    return st;
}

static fmb_status add_time(const maker *m)
{
    mpq_t *form = row(m, m->dim);
    as_variable(m, 0, m->time, form);
    fmb_status st = add_form(m, form, -1, FMB_LE, 0);
    as_variable(m, 0, m->time, form);
    return st == FMB_OK ? add_form(m, form, 1, FMB_LE, 1) : st;
}

static fmb_status add_all(const maker *m, fmb_coordinates in)
{
    const fmb_frame *last = in == FMB_COORDINATES_LAST ? &m->frame[m->frames - 1] : NULL;
    bool each = in == FMB_COORDINATES_EACH, all = in == FMB_COORDINATES_ALL;
    fmb_status st = FMB_OK;
    int from = all ? m->dim : 0;
    for (size_t k = 0; st == FMB_OK && k < m->frames; k++) {
        const fmb_frame *f = &m->frame[k];
        if (!each && !all && f != last) {
            st = add_solved(m, f, last);
            continue;
        }
        st = add_inside(m, f, as_variable, from);
        if (st == FMB_OK && (all || (each && k > 0)))
            st = add_meeting(m, k, from, all);
        from += f->naxes;
    }
    return st == FMB_OK && m->time >= 0 ? add_time(m) : st;
}

/* ---- the system ------------------------------------------------------------------------------ */

/* "x3", "c2", "c1_2" and "t"; x are the names that variables have anyway. */
static fmb_status name_variables(const maker *m, fmb_coordinates in)
{
    fmb_status st = FMB_OK;
    char name[48];
    int j = in == FMB_COORDINATES_ALL ? m->dim : 0;
    for (size_t k = in == FMB_COORDINATES_LAST ? m->frames - 1 : 0;
         in != FMB_COORDINATES_WORLD && k < m->frames; k++)
        for (int i = 0; st == FMB_OK && i < m->frame[k].naxes; i++) {
            if (in == FMB_COORDINATES_LAST)
                snprintf(name, sizeof name, "c%d", i + 1);
            else
                snprintf(name, sizeof name, "c%zu_%d", k + 1, i + 1);
            st = fmb_system_set_name(m->s, j++, name);
        }
    return st == FMB_OK && m->time >= 0 ? fmb_system_set_name(m->s, m->time, "t") : st;
}

static void count_columns(maker *m, fmb_coordinates in)
{
    bool moves = false;
    int axes = 0, most = 0;
    for (size_t k = 0; k < m->frames; k++) {
        const fmb_frame *f = &m->frame[k];
        moves |= f->speed != NULL;
        axes += f->naxes;
        most = f->naxes > most ? f->naxes : most;
    }
    m->dim = m->frame[0].dim;
    m->vars = in == FMB_COORDINATES_WORLD  ? m->dim
              : in == FMB_COORDINATES_LAST ? m->frame[m->frames - 1].naxes
              : in == FMB_COORDINATES_ALL  ? m->dim + axes
                                           : axes;
    m->time = moves ? m->vars++ : -1;
    m->width = most + m->vars + 1;
}

static fmb_status fill(maker *m, fmb_coordinates in)
{
    fmb_mem *mem = &m->s->mem;
    size_t cells = (size_t)(m->dim + 2) * (size_t)m->width;
    m->cell = fmb_mem_get(mem, cells, sizeof *m->cell);
    m->var = fmb_mem_get(mem, (size_t)m->vars, sizeof *m->var);
    fmb_status st = m->cell && m->var ? name_variables(m, in) : FMB_ERR_MEMORY;
    for (size_t i = 0; m->cell && i < cells; i++)
        mpq_init(m->cell[i]);
    for (int j = 0; m->var && j < m->vars; j++)
        m->var[j] = j;
    if (st == FMB_OK)
        st = add_all(m, in);
    for (size_t i = 0; m->cell && i < cells; i++)
        mpq_clear(m->cell[i]);
    fmb_mem_put(mem, m->cell, cells, sizeof *m->cell);
    fmb_mem_put(mem, m->var, (size_t)m->vars, sizeof *m->var);
    return st;
}

fmb_status fmb_system_from_frames(const fmb_frame *f, size_t n, fmb_coordinates in,
                                  fmb_contact contact, const fmb_alloc *mem, fmb_system **out)
{
    maker m = {.frame = f, .frames = n, .inside = contact == FMB_CONTACT_OPEN ? FMB_LT : FMB_LE};
    if (!out || !are_frames(f, n) || (unsigned)in > FMB_COORDINATES_ALL ||
        (unsigned)contact > FMB_CONTACT_OPEN)
        return FMB_ERR_ARG;
    count_columns(&m, in);
    fmb_status st = fmb_system_new(m.vars, mem, &m.s);
    if (st == FMB_OK)
        st = fill(&m, in);
    if (st == FMB_OK)
        *out = m.s;
    else
        fmb_system_free(m.s);
    return st;
}
