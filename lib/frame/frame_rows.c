/* frame_rows.c: the constraints of frames as rows of a system; see maker.h. */
#include "frame/jordan.h"
#include "frame/maker.h"
#include "system/system_private.h"

/* ---- rows ------------------------------------------------------------------------------------ */

/* Append row[0..n) REL row[n]; if it has a term, after division by the common divisor. */
static fmb_status append_row(const fmb_maker *m, size_t n, fmb_rel rel)
{
    mpz_ptr g = m->spare[0];
    mpz_set_ui(g, n == 0);
    for (size_t k = 0; k <= n && mpz_cmp_ui(g, 1) != 0; k++)
        mpz_gcd(g, g, m->row[k]);
    for (size_t k = 0; k <= n && mpz_cmp_ui(g, 1) != 0; k++)
        mpz_divexact(m->row[k], m->row[k], g);
    mpz_set_ui(m->row[n + 1], 1);
    FMB_TRY(fmb_system_append(m->s, n, m->var, m->row, rel));
    return fmb_poll_if_limited(m->run);
}

/* Append sign (the sum of n variables from number `from` on) REL bound. */
static fmb_status bound_sum(const fmb_maker *m, int from, int n, int sign, fmb_rel rel,
                            unsigned bound)
{
    for (int k = 0; k < n; k++) {
        m->var[k] = from + k;
        mpz_set_si(m->row[k], sign);
    }
    mpz_set_ui(m->row[n], bound);
    return append_row(m, (size_t)n, rel);
}

/* ---- frames whose coordinates are variables, numbered from `from` ---------------------------- */

static fmb_status bound_variables(const fmb_maker *m, const fmb_integer_frame *f, int from)
{
    for (int i = 0; i < f->naxes; i++)
        FMB_TRY(bound_sum(m, from + i, 1, -1, m->inside, 0));
    for (int i = 0; f->shape == FMB_CUBOID && i < f->naxes; i++)
        FMB_TRY(bound_sum(m, from + i, 1, 1, m->inside, 1));
    return f->shape == FMB_SIMPLEX && f->naxes > 0 ? bound_sum(m, from, f->naxes, 1, m->inside, 1)
                                                   : FMB_OK;
}

static void add_number(const fmb_maker *m, const fmb_integer_frame *f, int i, int j, int sign,
                       mpz_t cell)
{
    fmb_scene_number(&m->scene, f, i, j, m->spare[0]);
    if (sign > 0)
        mpz_add(cell, cell, m->spare[0]);
    else
        mpz_sub(cell, cell, m->spare[0]);
}

/* Append coordinate j of the edges of f after the n terms of the row; returns the new number. */
static size_t put_edges(const fmb_maker *m, const fmb_integer_frame *f, int from, int j, int sign,
                        size_t n)
{
    for (int i = 0; i < f->naxes; i++) {
        mpz_set_ui(m->row[n], 0);
        add_number(m, f, 1 + i, j, sign, m->row[n]);
        m->var[n] = from + i;
        n += mpz_sgn(m->row[n]) != 0;
    }
    return n;
}

/* Append, for coordinate j: the point of frame f equals that of `first`; or variable j. */
static fmb_status add_meeting_row(const fmb_maker *m, const fmb_integer_frame *first,
                                  const fmb_integer_frame *f, int from, int j)
{
    size_t n = 0;
    if (first) {
        n = put_edges(m, first, 0, j, 1, n);
    } else {
        m->var[n] = j;
        mpz_set(m->row[n++], m->scene.unit[j]);
    }
    n = put_edges(m, f, from, j, -1, n);
    mpz_set_ui(m->row[n], 0);
    if (first && first->moves)
        add_number(m, first, 1 + first->naxes, j, 1, m->row[n]);
    if (f->moves)
        add_number(m, f, 1 + f->naxes, j, -1, m->row[n]);
    if (mpz_sgn(m->row[n]) != 0)
        m->var[n++] = m->time;
    mpz_set_ui(m->row[n], 0);
    add_number(m, f, 0, j, 1, m->row[n]);
    if (first)
        add_number(m, first, 0, j, -1, m->row[n]);
    return append_row(m, n, FMB_EQ);
}

static fmb_status add_frame(const fmb_maker *m, size_t k, int from)
{
    const fmb_integer_frame *f = &m->scene.frame[k];
    bool point = m->in == FMB_COORDINATES_ALL, meets = point || k > 0;
    FMB_TRY(bound_variables(m, f, from));
    for (int j = 0; m->in != FMB_COORDINATES_LAST && meets && j < m->dim; j++)
        FMB_TRY(add_meeting_row(m, point ? NULL : &m->scene.frame[0], f, from, j));
    return FMB_OK;
}

/* ---- frames whose coordinates are solved for ------------------------------------------------- */

static mpz_t *line_of_table(const fmb_maker *m, int i)
{
    return m->table + (size_t)i * (size_t)m->width;
}

/* sign form REL bound */
static fmb_status append_form(const fmb_maker *m, mpz_t *form, int sign, fmb_rel rel,
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
    if (bound)
        mpz_add(m->row[n], m->row[n], bound);
    return append_row(m, n, rel);
}

static fmb_status bound_solved(const fmb_maker *m, const fmb_integer_frame *f)
{
    fmb_status st = FMB_OK;
    for (int i = 0; st == FMB_OK && i < f->naxes; i++)
        st = append_form(m, line_of_table(m, i) + f->naxes, -1, m->inside, NULL);
    for (int j = 0; j <= m->vars; j++)
        mpz_set_ui(m->sum[j], 0);
    for (int i = 0; st == FMB_OK && i < f->naxes; i++) {
        mpz_t *form = line_of_table(m, i) + f->naxes;
        if (f->shape == FMB_CUBOID)
            st = append_form(m, form, 1, m->inside, m->scale[0]);
        for (int j = 0; f->shape == FMB_SIMPLEX && j <= m->vars; j++)
            mpz_add(m->sum[j], m->sum[j], form[j]);
    }
    return st == FMB_OK && f->shape == FMB_SIMPLEX && f->naxes > 0
               ? append_form(m, m->sum, 1, m->inside, m->scale[0])
               : st;
}

/* form += sign (origin + t speed) */
static void add_place(const fmb_maker *m, const fmb_integer_frame *f, int j, int sign, mpz_t *form)
{
    add_number(m, f, 0, j, sign, form[m->vars]);
    if (f->moves)
        add_number(m, f, 1 + f->naxes, j, sign, form[m->time]);
}

/* Add the rows of f for its solved coordinates of the point of `last`, or of the variable point. */
static fmb_status add_solved(const fmb_maker *m, const fmb_integer_frame *f,
                             const fmb_integer_frame *last)
{
    for (int j = 0; j < m->dim; j++) {
        mpz_t *r = line_of_table(m, j), *form = r + f->naxes;
        for (int k = 0; k < m->width; k++)
            mpz_set_ui(r[k], 0);
        for (int i = 0; i < f->naxes; i++)
            add_number(m, f, 1 + i, j, 1, r[i]);
        for (int i = 0; last && i < last->naxes; i++)
            add_number(m, last, 1 + i, j, 1, form[i]);
        if (last)
            add_place(m, last, j, 1, form);
        else
            mpz_set(form[j], m->scene.unit[j]);
        add_place(m, f, j, -1, form);
        FMB_TRY(fmb_poll_if_limited(m->run));
    }
    FMB_TRY(fmb_jordan(m->table, m->dim, m->width, f->naxes, m->scale[0], m->run));
    FMB_TRY(bound_solved(m, f));
    for (int i = f->naxes; i < m->dim; i++)
        FMB_TRY(append_form(m, line_of_table(m, i) + f->naxes, 1, FMB_EQ, NULL));
    return FMB_OK;
}

/* ---- all ------------------------------------------------------------------------------------- */

fmb_status fmb_maker_rows(const fmb_maker *m)
{
    const fmb_integer_frame *frame = m->scene.frame, *end = frame + m->scene.frames;
    const fmb_integer_frame *last = m->in == FMB_COORDINATES_LAST ? end - 1 : NULL;
    bool each = m->in == FMB_COORDINATES_EACH, all = m->in == FMB_COORDINATES_ALL;
    int from = all ? m->dim : 0;
    for (const fmb_integer_frame *f = frame; f < end; f++) {
        bool is_solved = !each && !all && f != last;
        FMB_TRY(is_solved ? add_solved(m, f, last) : add_frame(m, (size_t)(f - frame), from));
        from += is_solved ? 0 : f->naxes;
    }
    if (m->time >= 0)
        FMB_TRY(bound_sum(m, m->time, 1, -1, FMB_LE, 0));
    return m->time >= 0 ? bound_sum(m, m->time, 1, 1, FMB_LE, 1) : FMB_OK;
}
