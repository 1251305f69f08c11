/* frame.c: from frames to a system; see fmb/frame.h and maker.h. */
#include "frame/frame_private.h"

#include <math.h>

#include "frame/maker.h"
#include "system/system_private.h"

/* ---- arguments ------------------------------------------------------------------------------- */

/* The index of the first of n numbers that is not finite; n: there is none. */
static size_t find_infinite(const double *a, size_t n)
{
    size_t i = 0;
    while (i < n && isfinite(a[i]))
        i++;
    return i;
}

static int most_axes_of_shape(fmb_shape shape, int dim)
{
    return shape == FMB_SIMPLEX_BY_CORNERS ? FMB_FRAME_MOST_DIM : dim;
}

/* The arrays of a frame: [rows][dim] each. */
typedef struct part {
    const char *name;
    const double *number;
    size_t rows;
} part;

static bool describe_part(const part *a, size_t dim, char *text, size_t size)
{
    size_t n = a->rows * dim, i = a->number ? find_infinite(a->number, n) : 0;
    if (i == n)
        return false;
    if (!a->number)
        snprintf(text, size, "%s is NULL", a->name);
    else if (a->name[0] == 'a')
        snprintf(text, size, "axes[%zu][%zu] is not finite", i / dim, i % dim);
    else
        snprintf(text, size, "%s[%zu] is not finite", a->name, i);
    return true;
}

static bool describe_outline(const fmb_frame *f, int dim, char *text, size_t size)
{
    if (f->dim != dim)
        snprintf(text, size, "dim is %d, not %d", f->dim, dim);
    else if (dim < 0 || dim > FMB_FRAME_MOST_DIM)
        snprintf(text, size, "dim is %d, not 0 to %d", dim, (int)FMB_FRAME_MOST_DIM);
    else if (f->naxes < 0 || f->naxes > most_axes_of_shape(f->shape, dim))
        snprintf(text, size, "naxes is %d, not 0 to %d", f->naxes,
                 most_axes_of_shape(f->shape, dim));
    else if ((unsigned)f->shape > FMB_SIMPLEX_BY_CORNERS)
        snprintf(text, size, "shape is %d, which is none", (int)f->shape);
    else
        return false;
    return true;
}

bool fmb_frame_describe_fault(const fmb_frame *f, int dim, char *text, size_t size)
{
    if (describe_outline(f, dim, text, size))
        return true;
    const part parts[] = {{"origin", f->origin, 1},
                          {"axes", f->axes, (size_t)f->naxes},
                          {"speed", f->speed, f->speed != NULL}};
    bool found = false;
    for (int k = 0; !found && k < 3; k++)
        found = describe_part(&parts[k], (size_t)dim, text, size);
    return found;
}

bool fmb_frame_is_good(const fmb_frame *f, int dim)
{
    char text[FMB_FRAME_FAULT_SIZE];
    return !fmb_frame_describe_fault(f, dim, text, sizeof text);
}

static bool has_denominators(mpq_t *a, size_t n)
{
    size_t i = 0;
    while (a && i < n && mpz_sgn(mpq_denref(a[i])) != 0)
        i++;
    return i == n;
}

bool fmb_frame_q_is_good(const fmb_frame_q *f, int dim)
{
    const fmb_frame outline = {.dim = f->dim, .shape = f->shape, .naxes = f->naxes};
    char text[FMB_FRAME_FAULT_SIZE];
    size_t d = (size_t)dim;
    return !describe_outline(&outline, dim, text, sizeof text) && has_denominators(f->origin, d) &&
           has_denominators(f->axes, (size_t)f->naxes * d) &&
           (!f->speed || has_denominators(f->speed, d));
}

/* ---- variables ------------------------------------------------------------------------------- */

/* "c2", or "c1_2" where several frames have some */
static fmb_status add_coordinates(const fmb_maker *m, size_t k)
{
    for (int i = 1; i <= m->scene.frame[k].naxes; i++) {
        char name[48];
        if (m->in == FMB_COORDINATES_LAST)
            snprintf(name, sizeof name, "c%d", i);
        else
            snprintf(name, sizeof name, "c%zu_%d", k + 1, i);
        FMB_TRY(fmb_system_add_variable(m->s, name, NULL));
    }
    return FMB_OK;
}

/* Name the variables; those of the point have default names. */
static fmb_status add_names(const fmb_maker *m)
{
    bool point = m->in == FMB_COORDINATES_WORLD || m->in == FMB_COORDINATES_ALL;
    for (int j = 0; point && j < m->dim; j++)
        FMB_TRY(fmb_system_add_variable(m->s, NULL, NULL));
    for (size_t k = m->in == FMB_COORDINATES_LAST ? m->scene.frames - 1 : 0;
         m->in != FMB_COORDINATES_WORLD && k < m->scene.frames; k++)
        FMB_TRY(add_coordinates(m, k));
    return m->time >= 0 ? fmb_system_add_variable(m->s, "t", NULL) : FMB_OK;
}

/* Count the columns. False: more than a system can have. */
static bool count_columns(fmb_maker *m)
{
    const fmb_scene *w = &m->scene;
    bool moves = false;
    int64_t axes = 0, vars;
    int most = 0;
    for (size_t k = 0; k < w->frames && axes < INT32_MAX; k++) {
        const fmb_integer_frame *f = &w->frame[k];
        moves |= f->moves;
        axes += f->naxes;
        most = f->naxes > most ? f->naxes : most;
    }
    m->dim = w->dim;
    vars = m->in == FMB_COORDINATES_WORLD  ? w->dim
           : m->in == FMB_COORDINATES_LAST ? w->frame[w->frames - 1].naxes
           : m->in == FMB_COORDINATES_ALL  ? w->dim + axes
                                           : axes;
    if (vars >= INT32_MAX / 2)
        return false;
    m->vars = (int)vars;
    m->time = moves ? m->vars++ : -1;
    m->width = most + m->vars + 1;
    return true;
}

/* ---- the system ------------------------------------------------------------------------------ */

static fmb_status open_work(fmb_maker *m, fmb_mem *mem)
{
    bool solves = m->in == FMB_COORDINATES_WORLD || m->in == FMB_COORDINATES_LAST;
    size_t table = solves ? (size_t)m->dim * (size_t)m->width : 0, form = (size_t)m->vars + 1;
    m->cells = table + 2 * form + 3;
    m->cell = fmb_vec_block(m->cells, mem);
    m->var = fmb_mem_get(mem, form, sizeof *m->var);
    if (!m->cell || !m->var)
        return fmb_mem_status(mem);
    m->table = m->cell;
    m->sum = m->table + table;
    m->row = m->sum + form;
    m->scale = m->row + form + 1;
    m->spare = m->scale + 1;
    return FMB_OK;
}

static void close_work(fmb_maker *m, fmb_mem *mem)
{
    fmb_vec_block_free(m->cell, m->cells, mem);
    fmb_mem_put(mem, m->var, (size_t)m->vars + 1, sizeof *m->var);
}

static fmb_status make_system(fmb_maker *m)
{
    if (!count_columns(m))
        return FMB_ERR_ARG;
    fmb_status st = open_work(m, &m->s->mem);
    FMB_THEN(st, add_names(m));
    FMB_THEN(st, fmb_maker_rows(m));
    close_work(m, &m->s->mem);
    return st;
}

static bool are_good(const fmb_frame *f, const fmb_frame_q *q, size_t n)
{
    bool good = (f || q) && n > 0;
    for (size_t k = 0; good && k < n; k++)
        good = f ? fmb_frame_is_good(&f[k], f[0].dim) : fmb_frame_q_is_good(&q[k], q[0].dim);
    return good;
}

fmb_status fmb_frames_within_limits(const fmb_frame *f, const fmb_frame_q *q, size_t n,
                                    fmb_coordinates in, fmb_contact contact, const fmb_alloc *hook,
                                    fmb_run *run, fmb_system **out)
{
    fmb_maker m = {.in = in, .inside = contact == FMB_CONTACT_OPEN ? FMB_LT : FMB_LE, .run = run};
    if (!are_good(f, q, n) || !out || (unsigned)in > FMB_COORDINATES_ALL ||
        (unsigned)contact > FMB_CONTACT_OPEN)
        return FMB_ERR_ARG;
    FMB_TRY(fmb_system_new(0, hook, &m.s));
    fmb_mem *mem = &m.s->mem;
    mem->limit = run ? run->mem->limit : 0;
    fmb_status st = fmb_scene_open(&m.scene, f, q, n, mem, run);
    FMB_THEN(st, make_system(&m));
    fmb_scene_clear(&m.scene);
    if (st == FMB_ERR_MEMORY)
        st = fmb_mem_status(mem);
    mem->limit = 0;
    if (st == FMB_OK)
        *out = m.s;
    else
        fmb_system_free(m.s);
    return st;
}

fmb_status fmb_system_from_frames(const fmb_frame *f, size_t n, fmb_coordinates in,
                                  fmb_contact contact, const fmb_alloc *mem, fmb_system **out)
{
    return fmb_frames_within_limits(f, NULL, n, in, contact, mem, NULL, out);
}

fmb_status fmb_system_from_frames_q(const fmb_frame_q *f, size_t n, fmb_coordinates in,
                                    fmb_contact contact, const fmb_alloc *mem, fmb_system **out)
{
    return fmb_frames_within_limits(NULL, f, n, in, contact, mem, NULL, out);
}
