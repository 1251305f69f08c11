/* line.c: the system of a pair of bodies; see fmb/gmp.h. */
#include "frame/frame_private.h"
#include "solve/query/solver.h"
#include "system/system_private.h"

/* [give] A system of the frames alone; without frames, one of the point without rows. */
static fmb_status start_from_frames(const fmb_frame_line *line, fmb_coordinates in,
                                    fmb_contact contact, const fmb_alloc *mem, fmb_run *run,
                                    fmb_system **out)
{
    fmb_frame_q f[2];
    size_t n = 0;
    for (int k = 0; k < 2; k++)
        if (!line->body[k].rows)
            f[n++] = line->body[k].frame;
    if (n < 2 && in != FMB_COORDINATES_ALL)
        return FMB_ERR_ARG;
    return n > 0 ? fmb_frames_within_limits(NULL, f, n, in, contact, mem, run, out)
                 : fmb_system_new(line->body[0].frame.dim, mem, out);
}

static fmb_status add_rows_of_polytope(fmb_system *s, const fmb_system *rows, fmb_contact contact)
{
    size_t before = s->rows;
    FMB_TRY(fmb_system_join(s, rows, NULL));
    for (size_t i = before; contact == FMB_CONTACT_OPEN && i < s->rows; i++)
        if (s->row[i].rel == FMB_LE)
            s->row[i].rel = FMB_LT;
    return FMB_OK;
}

static fmb_status make_system_of_line(const fmb_frame_line *line, fmb_coordinates in,
                                      fmb_contact contact, const fmb_alloc *mem, fmb_run *run,
                                      fmb_system **out)
{
    fmb_system *s = NULL;
    if (!line || !out || (unsigned)contact > FMB_CONTACT_OPEN)
        return FMB_ERR_ARG;
    fmb_status st = start_from_frames(line, in, contact, mem, run, &s);
    for (int k = 0; st == FMB_OK && k < 2; k++)
        if (line->body[k].rows)
            st = add_rows_of_polytope(s, line->body[k].rows, contact);
    if (st == FMB_OK)
        *out = s;
    else
        fmb_system_free(s);
    return st;
}

fmb_status fmb_system_from_line(const fmb_frame_line *line, fmb_contact contact,
                                const fmb_alloc *mem, fmb_system **out)
{
    return make_system_of_line(line, FMB_COORDINATES_ALL, contact, mem, NULL, out);
}

fmb_status fmb_system_from_line_within(const fmb_frame_line *line, fmb_coordinates in,
                                       fmb_contact contact, fmb_solver *v, fmb_system **out,
                                       fmb_stop *stop)
{
    fmb_system *s = NULL;
    fmb_mem mem;
    fmb_run run;
    if (!v || !out || !stop)
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, &v->mem.alloc, 0);
    fmb_run_begin(&run, &mem, &v->options, &v->cancel, (fmb_sink){0}, "frames");
    fmb_status st = make_system_of_line(line, in, contact, &v->mem.alloc, &run, &s);
    if (st != FMB_OK && st != FMB_LIMIT)
        return st;
    *stop = st == FMB_LIMIT && run.stop == FMB_STOP_DONE ? FMB_STOP_BYTES : run.stop;
    *out = s;
    return FMB_OK;
}
