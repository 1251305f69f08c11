/* cells_as_frames.c: flat, wild and moving cells as frames given by their corners. */
#include <math.h>
#include <string.h>

#include <fmb/solve.h>

#include "mesh/cells_as_frames.h"
#include "pair/contact/contact_near.h"
#include "proximity/proximity_private.h"

void fmb_mesh_frames_open(fmb_mesh_frames *x, const fmb_alloc *hook, const double *motion)
{
    *x = (fmb_mesh_frames){.motion = motion};
    x->mem = hook ? *hook : (fmb_alloc){0};
}

static const fmb_alloc *hook_of(const fmb_mesh_frames *x)
{
    return x->mem.resize ? &x->mem : NULL;
}

/* [keep] The pair query for this kind of contact, opened on first use. Errors: MEMORY. */
static fmb_status open_pair(fmb_mesh_frames *x, fmb_contact contact, fmb_pair **k)
{
    fmb_pair_options o = {.size = sizeof o};
    o.max_bytes = SIZE_MAX;
    o.contact = contact;
    return *k ? FMB_OK : fmb_pair_new(3, &o, hook_of(x), k);
}

/* Errors: MEMORY. */
static fmb_status open_solver(fmb_mesh_frames *x)
{
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_NONE;
    return x->solver ? FMB_OK : fmb_solver_new(&o, hook_of(x), &x->solver);
}

void fmb_mesh_frames_close(fmb_mesh_frames *x)
{
    fmb_pair_free(x->closed);
    fmb_pair_free(x->open);
    fmb_solver_free(x->solver);
}

/* A cell as a frame; its numbers. */
typedef struct framed_cell {
    double number[FMB_CELL_MOST_CORNERS][3];
    fmb_frame frame;
} framed_cell;

/* The corners that c shares with another cell come first. */
static void frame_cell(const fmb_cell *c, const fmb_cell *other, const double *speed,
                       framed_cell *out)
{
    int n = 0;
    for (int shared = 1; shared >= 0; shared--)
        for (int k = 0; k < c->corners; k++)
            if (fmb_cell_has(other, c->id[k]) == shared)
                memcpy(out->number[n++], c->point[k], sizeof out->number[0]);
    out->frame = (fmb_frame){.shape = FMB_SIMPLEX_BY_CORNERS,
                             .dim = 3,
                             .naxes = c->corners - 1,
                             .origin = out->number[0],
                             .axes = out->number[1],
                             .speed = speed};
}

/* Have f[0] and f[1] a common point outside their common face? The first corners of f[0] are the
 * shared ones: can the sum of c_i over the other corners be positive? */
static fmb_status ask_beyond_shared(fmb_mesh_frames *x, const fmb_frame f[2], int shared, bool *out)
{
    int64_t row[2 * FMB_CELL_MOST_CORNERS] = {0};
    fmb_system *s = NULL;
    fmb_result result = {.size = sizeof result};
    for (int i = shared - 1; i < f[0].naxes; i++)
        row[i] = -1;
    fmb_status st = open_solver(x);
    FMB_THEN(
        st, fmb_system_from_frames(f, 2, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, hook_of(x), &s));
    FMB_THEN(st, fmb_system_add_int(s, row, FMB_LT, 0));
    FMB_THEN(st, fmb_solve(x->solver, s, &result));
    if (st == FMB_OK)
        *out = result.verdict == FMB_FEASIBLE;
    fmb_system_free(s);
    return st;
}

static fmb_status ask_pair(fmb_mesh_frames *x, fmb_contact contact, const fmb_frame f[2],
                           bool *meet)
{
    fmb_pair **k = contact == FMB_CONTACT_OPEN ? &x->open : &x->closed;
    fmb_verdict v;
    fmb_status st = open_pair(x, contact, k);
    FMB_THEN(st,
             fmb_pair_test(*k, 1, &f[0], &f[1],
                           &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &v}));
    *meet = st == FMB_OK && v == FMB_FEASIBLE;
    return st;
}

/* If one cell is flat, the other one must come first: coordinates in a flat cell are not unique.
 * Its corners are counted that are shared: of a flat cell one may come twice. */
fmb_status fmb_mesh_decide_frames(fmb_mesh_frames *x, const fmb_cell *a, const fmb_cell *b,
                                  bool flat_b, fmb_mesh_how *out)
{
    bool swap = !x->motion && !flat_b, meet = true, cross = false, beyond = false;
    const fmb_cell *first = swap ? b : a, *second = swap ? a : b;
    int shared = fmb_cell_count(fmb_cell_common(first, second));
    framed_cell p, q;
    frame_cell(first, second, NULL, &p);
    frame_cell(second, first, x->motion, &q);
    const fmb_frame f[2] = {p.frame, q.frame};
    fmb_status st = FMB_OK;
    if (shared == 0)
        st = ask_pair(x, FMB_CONTACT_CLOSED, f, &meet);
    if (st == FMB_OK && meet && !x->motion)
        st = ask_pair(x, FMB_CONTACT_OPEN, f, &cross);
    if (st == FMB_OK && shared > 0 && !cross && !x->motion)
        st = ask_beyond_shared(x, f, shared, &beyond);
    if (st != FMB_OK)
        return st;
    *out = !meet                                 ? FMB_MESH_APART
           : cross                               ? FMB_MESH_CROSS
           : shared > 0 && !beyond && !x->motion ? FMB_MESH_SHARE
                                                 : FMB_MESH_TOUCH;
    return FMB_OK;
}

/* ---- how far apart --------------------------------------------------------------------------- */

void fmb_mesh_cells_range(const fmb_cell *a, const fmb_cell *b, const double *motion, double enough,
                          double range[2])
{
    framed_cell p, q;
    frame_cell(a, b, NULL, &p);
    frame_cell(b, a, motion, &q);
    if (!fmb_contact_range(&p.frame, &q.frame, enough, range)) {
        range[0] = 0;
        range[1] = INFINITY;
    }
}

fmb_status fmb_mesh_measure_cells(fmb_mesh_frames *x, const fmb_cell *a, const fmb_cell *b,
                                  fmb_proximity **out)
{
    framed_cell p, q;
    fmb_result result = {.size = sizeof result};
    frame_cell(a, b, NULL, &p);
    frame_cell(b, a, x->motion, &q);
    const fmb_frame f[2] = {p.frame, q.frame};
    FMB_TRY(open_solver(x));
    return fmb_distance(x->solver, f, FMB_NORM_EUCLIDEAN, out, &result);
}

fmb_status fmb_mesh_cells_are_near(fmb_mesh_frames *x, const fmb_cell *a, const fmb_cell *b,
                                   const fmb_mesh_clearance *m, bool *exactly, bool *out)
{
    double range[2];
    fmb_proximity *found = NULL;
    fmb_mesh_cells_range(a, b, x->motion, m->above, range);
    *out = range[1] <= m->below;
    *exactly = !*out && !(range[0] > m->above);
    if (!*exactly)
        return FMB_OK;
    fmb_status st = fmb_mesh_measure_cells(x, a, b, &found);
    if (st == FMB_OK)
        *out = mpq_cmp(found->measure, m->square) <= 0;
    fmb_proximity_free(found);
    return st;
}
