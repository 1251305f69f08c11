/* frame.c: from frames to a system; see fmb/frame.h and maker.h. */
#include "frame/frame.h"

#include <math.h>

#include "frame/maker.h"
#include "system/system.h"

/* ---- arguments ------------------------------------------------------------------------------- */

static bool are_finite(const double *a, int n)
{
    bool good = a || n == 0;
    for (int i = 0; good && i < n; i++)
        good = isfinite(a[i]);
    return good;
}

static bool is_outline(fmb_shape shape, int naxes, int dim)
{
    return dim >= 0 && naxes >= 0 && naxes <= dim && (unsigned)shape <= FMB_SIMPLEX;
}

bool fmb_frame_is_good(const fmb_frame *f, int dim)
{
    return f->dim == dim && is_outline(f->shape, f->naxes, dim) && are_finite(f->origin, dim) &&
           are_finite(f->axes, f->naxes * dim) && (!f->speed || are_finite(f->speed, dim));
}

static bool is_good_q(const fmb_frame_q *f, int dim)
{
    return f->dim == dim && is_outline(f->shape, f->naxes, dim) && (f->origin || dim == 0) &&
           (f->axes || f->naxes == 0);
}

/* ---- variables ------------------------------------------------------------------------------- */

/* "c2", or "c1_2" where several frames have some */
static fmb_status add_coordinates(const fmb_maker *m, size_t k)
{
    fmb_status st = FMB_OK;
    for (int i = 1; st == FMB_OK && i <= m->scene.frame[k].naxes; i++) {
        char name[48];
        if (m->in == FMB_COORDINATES_LAST)
            snprintf(name, sizeof name, "c%d", i);
        else
            snprintf(name, sizeof name, "c%zu_%d", k + 1, i);
        st = fmb_system_add_variable(m->s, name, NULL);
    }
    return st;
}

/* The point has the names that variables have anyway. */
static fmb_status add_names(const fmb_maker *m)
{
    bool point = m->in == FMB_COORDINATES_WORLD || m->in == FMB_COORDINATES_ALL;
    fmb_status st = FMB_OK;
    for (int j = 0; point && st == FMB_OK && j < m->dim; j++)
        st = fmb_system_add_variable(m->s, NULL, NULL);
    for (size_t k = m->in == FMB_COORDINATES_LAST ? m->scene.frames - 1 : 0;
         st == FMB_OK && m->in != FMB_COORDINATES_WORLD && k < m->scene.frames; k++)
        st = add_coordinates(m, k);
    return st == FMB_OK && m->time >= 0 ? fmb_system_add_variable(m->s, "t", NULL) : st;
}

static void count_columns(fmb_maker *m)
{
    const fmb_scene *w = &m->scene;
    bool moves = false;
    int axes = 0, most = 0;
    for (size_t k = 0; k < w->frames; k++) {
        const fmb_whole *f = &w->frame[k];
        moves |= f->moves;
        axes += f->naxes;
        most = f->naxes > most ? f->naxes : most;
    }
    m->dim = w->dim;
    m->vars = m->in == FMB_COORDINATES_WORLD  ? w->dim
              : m->in == FMB_COORDINATES_LAST ? w->frame[w->frames - 1].naxes
              : m->in == FMB_COORDINATES_ALL  ? w->dim + axes
                                              : axes;
    m->time = moves ? m->vars++ : -1;
    m->width = most + m->vars + 1;
}

/* ---- the system ------------------------------------------------------------------------------ */

static fmb_status open_work(fmb_maker *m, fmb_mem *mem)
{
    size_t table = (size_t)m->dim * (size_t)m->width, form = (size_t)m->vars + 1;
    m->cells = table + 3 * form + 3;
    m->cell = fmb_mem_get(mem, m->cells, sizeof *m->cell);
    m->var = fmb_mem_get(mem, (size_t)m->vars, sizeof *m->var);
    for (size_t i = 0; m->cell && i < m->cells; i++)
        mpz_init(m->cell[i]);
    if (!m->cell || !m->var)
        return fmb_mem_status(mem);
    m->form = m->cell + table;
    m->sum = m->form + form;
    m->row = m->sum + form;
    m->scale = m->row + form + 1;
    return FMB_OK;
}

static void close_work(fmb_maker *m, fmb_mem *mem)
{
    for (size_t i = 0; m->cell && i < m->cells; i++)
        mpz_clear(m->cell[i]);
    fmb_mem_put(mem, m->cell, m->cells, sizeof *m->cell);
    fmb_mem_put(mem, m->var, (size_t)m->vars, sizeof *m->var);
}

static fmb_status make(fmb_maker *m)
{
    count_columns(m);
    fmb_status st = open_work(m, &m->s->mem);
    if (st == FMB_OK)
        st = add_names(m);
    if (st == FMB_OK)
        st = fmb_maker_rows(m);
    close_work(m, &m->s->mem);
    return st;
}

/* One of f and q is given. */
static fmb_status make_from(const fmb_frame *f, const fmb_frame_q *q, size_t n, fmb_coordinates in,
                            fmb_contact contact, const fmb_alloc *hook, fmb_system **out)
{
    fmb_maker m = {.in = in, .inside = contact == FMB_CONTACT_OPEN ? FMB_LT : FMB_LE};
    if (!out || (unsigned)in > FMB_COORDINATES_ALL || (unsigned)contact > FMB_CONTACT_OPEN)
        return FMB_ERR_ARG;
    fmb_status st = fmb_system_new(0, hook, &m.s);
    if (st != FMB_OK)
        return st;
    fmb_mem *mem = &m.s->mem;
    st =
        f ? fmb_scene_of_doubles(&m.scene, f, n, mem) : fmb_scene_of_rationals(&m.scene, q, n, mem);
    if (st == FMB_OK)
        st = make(&m);
    fmb_scene_clear(&m.scene);
    if (st == FMB_OK)
        *out = m.s;
    else
        fmb_system_free(m.s);
    return st;
}

fmb_status fmb_system_from_frames(const fmb_frame *f, size_t n, fmb_coordinates in,
                                  fmb_contact contact, const fmb_alloc *mem, fmb_system **out)
{
    bool good = f && n > 0;
    for (size_t k = 0; good && k < n; k++)
        good = fmb_frame_is_good(&f[k], f[0].dim);
    return good ? make_from(f, NULL, n, in, contact, mem, out) : FMB_ERR_ARG;
}

fmb_status fmb_system_from_frames_q(const fmb_frame_q *f, size_t n, fmb_coordinates in,
                                    fmb_contact contact, const fmb_alloc *mem, fmb_system **out)
{
    bool good = f && n > 0;
    for (size_t k = 0; good && k < n; k++)
        good = is_good_q(&f[k], f[0].dim);
    return good ? make_from(NULL, f, n, in, contact, mem, out) : FMB_ERR_ARG;
}
