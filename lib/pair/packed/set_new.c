/* set_new.c: see set.h. */
#include "pair/packed/set.h"

#include <string.h>

#include "base/arrays.h"
#include "base/sized.h"
#include "frame/frame_private.h"
#include "pair/corner_edges.h"
#include "pair/kernels/inverse.h"
#include "pair/kernels/minors_kernels.h"
#include "pair/packed/bounds.h"
#include "pair/packed/single.h"

enum { LINE = FMB_RECORD_LINE };

/* ---- life ------------------------------------------------------------------------------------ */

/* Align to two cache lines, which are fetched together. */
static double *align_to_lines(double *p)
{
    return p + (2 * LINE - (uintptr_t)p / sizeof *p % (2 * LINE)) % (2 * LINE);
}

static fmb_status make_room_for_records(fmb_frames *s)
{
    s->stride = s->dim == 2                 ? LINE
                : s->dim == 3               ? 2 * LINE
                : fmb_minors_is_dim(s->dim) ? (size_t)fmb_minors_record(s->dim)
                                            : 0;
    s->kind = fmb_mem_get(&s->mem, s->n, sizeof *s->kind);
    s->order = s->kind ? fmb_mem_get(&s->mem, s->n, sizeof *s->order) : NULL;
    const size_t numbers = s->n * s->stride;
    if (s->stride > 0 && s->order) {
        s->room_size = numbers + (s->dim == 3 ? numbers / 2 : 0) + 2 * LINE;
        s->room = fmb_mem_get(&s->mem, s->room_size, sizeof *s->room);
    }
    bool good = s->order && (s->stride == 0 || s->room);
    s->record = s->room ? align_to_lines(s->room) : NULL;
    s->single = s->room && s->dim == 3 ? (float *)(s->record + numbers) : NULL;
    return good ? FMB_OK : fmb_mem_status(&s->mem);
}

/* Allocate the copies of frames as given, with so many numbers in all. */
static fmb_status make_room_beside(fmb_frames *s, size_t numbers)
{
    s->given = fmb_mem_zero(&s->mem, s->n, sizeof *s->given);
    s->beside_size = numbers;
    s->beside = s->given ? fmb_mem_get(&s->mem, numbers, sizeof *s->beside) : NULL;
    return s->beside ? FMB_OK : fmb_mem_status(&s->mem);
}

/* [give] */
static fmb_status open_set(int dim, size_t n, size_t numbers_beside, const fmb_alloc *hook,
                           fmb_frames **out)
{
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_frames *s;
    FMB_TRY(FMB_GET_ZERO(&mem, s, 1));
    s->mem = mem;
    s->dim = dim;
    s->n = n;
    fmb_status st = make_room_for_records(s);
    if (st == FMB_OK && numbers_beside > 0)
        st = make_room_beside(s, numbers_beside);
    if (st == FMB_OK)
        *out = s;
    else
        fmb_frames_free(s);
    return st;
}

static size_t count_ends(const fmb_frames *s)
{
    return s->dim > 3 ? 16 * (size_t)s->dim * s->eights : 0;
}

void fmb_frames_free(fmb_frames *s)
{
    if (!s)
        return;
    fmb_mem mem = s->mem;
    FMB_ARRAYS_PUT(
        &mem, FMB_ARRAY(s->kind, s->n), FMB_ARRAY(s->order, s->n), FMB_ARRAY(s->room, s->room_size),
        FMB_ARRAY(s->bounds, 2 * (size_t)s->dim * s->eights), FMB_ARRAY(s->ends, count_ends(s)),
        FMB_ARRAY(s->beside, s->beside_size), FMB_ARRAY(s->given, s->n));
    fmb_mem_put(&mem, s, 1, sizeof *s);
}

/* ---- frames ---------------------------------------------------------------------------------- */

static size_t count_numbers(const fmb_frame *f)
{
    return (size_t)f->dim * ((size_t)f->naxes + 1 + (f->speed != NULL));
}

/* Is f also stored as given? */
static bool stands_beside(const fmb_frame *f)
{
    return f->dim < 2 || f->dim > 3 || fmb_frame_is_by_corners(f->shape);
}

static void write_record(const fmb_frame *f, double *to)
{
    size_t dim = (size_t)f->dim, axes = dim * (size_t)f->naxes;
    memset(to, 0, (dim == 2 ? LINE : 2 * LINE) * sizeof *to);
    memcpy(to, f->origin, dim * sizeof *to);
    if (axes > 0)
        memcpy(to + dim, f->axes, axes * sizeof *to);
    if (f->speed)
        memcpy(to + dim + dim * dim, f->speed, dim * sizeof *to);
}

/* Append the numbers of f to `beside`, of which *used are in use. */
static void copy_beside(fmb_frames *s, size_t i, const fmb_frame *f, size_t *used)
{
    const double *const from[3] = {f->origin, f->axes, f->speed};
    const size_t dim = (size_t)f->dim, rows[3] = {1, (size_t)f->naxes, f->speed != NULL};
    const double *to[3];
    for (int k = 0; k < 3; k++) {
        to[k] = s->beside + *used;
        if (rows[k] > 0)
            memcpy(s->beside + *used, from[k], dim * rows[k] * sizeof(double));
        *used += dim * rows[k];
    }
    s->given[i] = *f;
    s->given[i].origin = to[0];
    s->given[i].axes = to[1];
    s->given[i].speed = f->speed ? to[2] : NULL;
}

/* Write frame i with these edges to its record; returns its kind. */
static int add_record(fmb_frames *s, size_t i, const fmb_frame *e)
{
    double *to = s->record + s->stride * i;
    int moves = e->speed ? FMB_KIND_MOVES : 0;
    if (s->dim <= 3) {
        write_record(e, to);
        if (s->single)
            fmb_single_add(s, i);
        return 2 * e->naxes + (int)e->shape + moves;
    }
    if (e->naxes != s->dim)
        return FMB_KIND_NONE;
    fmb_inverse_write_frame(e, to);
    return (int)e->shape + moves;
}

/* f is good. */
static void add_frame(fmb_frames *s, size_t i, const fmb_frame *f, size_t *used)
{
    fmb_corner_edges by_edges;
    int kind = FMB_KIND_NONE;
    if (s->stride > 0 && fmb_edges_of_frame(f, &by_edges))
        kind = add_record(s, i, &by_edges.frame);
    if (stands_beside(f))
        copy_beside(s, i, f, used);
    s->kind[i] = (uint8_t)kind;
}

/* Complete the records number[0 ... n - 1] in four to eight dimensions; a frame without an inverse
 * has none. */
static void complete_records(fmb_frames *s, const fmb_pair_kernels *kernels, const size_t *number,
                             unsigned n)
{
    double *record[FMB_BLOCK_MOST_LANES];
    for (unsigned l = 0; l < n; l++)
        record[l] = s->record + s->stride * number[l];
    const unsigned good = kernels->minors->invert(s->dim, record, n);
    for (unsigned l = 0; l < n; l++)
        if (good >> l & 1)
            fmb_inverse_write_integers(s->dim, record[l]);
        else
            s->kind[number[l]] = FMB_KIND_NONE;
}

static void complete_all_records(fmb_frames *s)
{
    const fmb_pair_kernels *kernels = fmb_pair_kernels_choose(FMB_SIMD_AUTO);
    size_t number[FMB_BLOCK_MOST_LANES];
    unsigned n = 0;
    for (size_t i = 0; i < s->n; i++) {
        if (s->kind[i] != FMB_KIND_NONE)
            number[n++] = i;
        if (n > 0 && (n == (unsigned)kernels->width || i + 1 == s->n)) {
            complete_records(s, kernels, number, n);
            n = 0;
        }
    }
}

static void find_only_kind(fmb_frames *s)
{
    for (size_t i = 0; i < s->n; i++)
        s->only = i == 0 || s->only == s->kind[i] ? s->kind[i] : -1;
}

/* Counting sort. */
static void order_by_kind(fmb_frames *s)
{
    size_t next[FMB_KINDS];
    for (size_t i = 0; i < s->n; i++)
        s->first[s->kind[i] + 1]++;
    for (int kind = 0; kind < FMB_KINDS; kind++) {
        s->first[kind + 1] += s->first[kind];
        next[kind] = s->first[kind];
    }
    for (size_t i = 0; i < s->n; i++)
        s->order[next[s->kind[i]]++] = (uint32_t)i;
}

/* Finish the order and bounds, after all frames were added. */
static fmb_status put_in_order(fmb_frames *s)
{
    if (fmb_minors_is_dim(s->dim))
        complete_all_records(s);
    find_only_kind(s);
    order_by_kind(s);
    for (int kind = 0; kind < FMB_KIND_NONE; kind++) {
        s->first_eight[kind] = s->eights;
        s->eights += (s->first[kind + 1] - s->first[kind] + 7) / 8;
    }
    if (s->eights > 0)
        s->bounds = fmb_mem_get(&s->mem, 2 * (size_t)s->dim * s->eights, sizeof *s->bounds);
    if (s->bounds && count_ends(s) > 0)
        s->ends = fmb_mem_get(&s->mem, count_ends(s), sizeof *s->ends);
    if ((s->eights > 0 && !s->bounds) || (count_ends(s) > 0 && !s->ends))
        return fmb_mem_status(&s->mem);
    fmb_bounds_of_eights(s);
    return FMB_OK;
}

/* Finish after adding the frames with status st. */
static fmb_status close_set(fmb_frames *s, fmb_status st, fmb_frames **out)
{
    FMB_THEN(st, put_in_order(s));
    if (st == FMB_OK)
        *out = s;
    else
        fmb_frames_free(s);
    return st;
}

static bool is_dimension(int dim)
{
    return dim >= 1 && dim <= FMB_FRAME_MOST_DIM;
}

fmb_status fmb_frames_new(int dim, size_t n, const fmb_frame *f, const fmb_alloc *mem,
                          fmb_frames **out)
{
    size_t beside = 0, used = 0;
    if (!out || !is_dimension(dim) || n > FMB_FRAMES_MOST || (n > 0 && !f))
        return FMB_ERR_ARG;
    for (size_t i = 0; i < n; i++) {
        if (!fmb_frame_is_good(&f[i], dim))
            return FMB_ERR_ARG;
        beside += stands_beside(&f[i]) ? count_numbers(&f[i]) : 0;
    }
    fmb_frames *s = NULL;
    fmb_status st = open_set(dim, n, beside, mem, &s);
    for (size_t i = 0; st == FMB_OK && i < n; i++)
        add_frame(s, i, &f[i], &used);
    return close_set(s, st, out);
}

/* ---- arrays ---------------------------------------------------------------------------------- */

/* Copy one part of frame i, `count` numbers per frame, as doubles to *to, which is advanced. */
static const double *take_part(const void *from, bool single, size_t i, size_t count, double **to)
{
    double *at = *to;
    if (!from)
        return NULL;
    *to += count;
    for (size_t j = 0; j < count; j++)
        at[j] = single ? (double)((const float *)from)[i * count + j]
                       : ((const double *)from)[i * count + j];
    return at;
}

/* number: scratch for one frame. */
static fmb_frame frame_of_arrays(int dim, const fmb_frame_arrays *a, size_t i, double *number)
{
    size_t d = (size_t)dim;
    fmb_frame f = {.shape = a->shape, .dim = dim, .naxes = a->naxes};
    f.origin = take_part(a->origin, a->single, i, d, &number);
    f.axes = take_part(a->axes, a->single, i, d * (size_t)a->naxes, &number);
    f.speed = take_part(a->speed, a->single, i, d, &number);
    return f;
}

fmb_status fmb_frames_from_arrays(int dim, size_t n, const fmb_frame_arrays *given,
                                  const fmb_alloc *mem, fmb_frames **out)
{
    fmb_frame_arrays ours, *a = &ours;
    if (!given || !fmb_sized_take(&ours, sizeof ours, given, "a", NULL, 0))
        return FMB_ERR_ARG;
    if (!out || !is_dimension(dim) || n > FMB_FRAMES_MOST || a->naxes < 0 ||
        a->naxes > FMB_FRAME_MOST_DIM || (unsigned)a->shape > FMB_SIMPLEX_BY_CORNERS ||
        (n > 0 && (!a->origin || (a->naxes > 0 && !a->axes))))
        return FMB_ERR_ARG;
    const fmb_frame like = {.shape = a->shape, .dim = dim, .naxes = a->naxes, .speed = a->speed};
    size_t each = count_numbers(&like), used = 0;
    fmb_frames *s = NULL;
    FMB_TRY(open_set(dim, n, stands_beside(&like) ? n * each : 0, mem, &s));
    double *number = fmb_mem_get(&s->mem, each, sizeof *number);
    fmb_status st = number ? FMB_OK : fmb_mem_status(&s->mem);
    for (size_t i = 0; st == FMB_OK && i < n; i++) {
        fmb_frame f = frame_of_arrays(dim, a, i, number);
        st = fmb_frame_is_good(&f, dim) ? FMB_OK : FMB_ERR_ARG;
        if (st == FMB_OK)
            add_frame(s, i, &f, &used);
    }
    fmb_mem_put(&s->mem, number, each, sizeof *number);
    return close_set(s, st, out);
}

/* ---- questions ------------------------------------------------------------------------------- */

int fmb_frames_dim(const fmb_frames *s)
{
    return s ? s->dim : 0;
}

size_t fmb_frames_count(const fmb_frames *s)
{
    return s ? s->n : 0;
}

fmb_frame fmb_frames_at(const fmb_frames *s, size_t i)
{
    if (!s || i >= s->n)
        return (fmb_frame){.dim = 0};
    if (s->given && s->given[i].dim > 0)
        return s->given[i];
    size_t dim = (size_t)s->dim;
    int kind = s->kind[i];
    const double *from = fmb_frames_record(s, i);
    return (fmb_frame){.shape = fmb_kind_shape(kind),
                       .dim = s->dim,
                       .naxes = fmb_kind_naxes(s->dim, kind),
                       .origin = from,
                       .axes = from + dim,
                       .speed = kind & FMB_KIND_MOVES ? from + dim + dim * dim : NULL};
}
