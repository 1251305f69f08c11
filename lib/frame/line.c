/* line.c: the system of a pair of bodies; see fmb/gmp.h. */
#include "system/system.h"

/* [give] The frames alone; without any, no rows over the point. */
static fmb_status start(const fmb_frames_line *line, fmb_contact contact, const fmb_alloc *mem,
                        fmb_system **out)
{
    fmb_frame_q f[2];
    size_t n = 0;
    for (int k = 0; k < 2; k++)
        if (!line->body[k].rows)
            f[n++] = line->body[k].frame;
    return n > 0 ? fmb_system_from_frames_q(f, n, FMB_COORDINATES_ALL, contact, mem, out)
                 : fmb_system_new(line->body[0].frame.dim, mem, out);
}

static fmb_status add_polytope(fmb_system *s, const fmb_system *rows, fmb_contact contact)
{
    size_t before = s->rows;
    fmb_status st = fmb_system_join(s, rows, NULL);
    for (size_t i = before; st == FMB_OK && contact == FMB_CONTACT_OPEN && i < s->rows; i++)
        if (s->row[i].rel == FMB_LE)
            s->row[i].rel = FMB_LT;
    return st;
}

fmb_status fmb_system_from_line(const fmb_frames_line *line, fmb_contact contact,
                                const fmb_alloc *mem, fmb_system **out)
{
    fmb_system *s = NULL;
    if (!line || !out)
        return FMB_ERR_ARG;
    fmb_status st = start(line, contact, mem, &s);
    for (int k = 0; st == FMB_OK && k < 2; k++)
        if (line->body[k].rows)
            st = add_polytope(s, line->body[k].rows, contact);
    if (st == FMB_OK)
        *out = s;
    else
        fmb_system_free(s);
    return st;
}
