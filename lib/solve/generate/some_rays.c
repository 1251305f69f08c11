/* some_rays.c: some rays of a cone, by support queries of a section; see some_rays.h. */
#include "solve/generate/some_rays.h"

#include "hull/section/section.h"

/* Bounds of a search without a clock: rays per coordinate, and pairs of facets of their hull. */
#define RAYS_OF_COORDINATE 4
#define PAIRS_OF_SEARCH    ((uint64_t)1 << 12)

static size_t count_equalities(const fmb_cone_row *row, size_t rows)
{
    size_t n = 0;
    for (size_t i = 0; i < rows; i++)
        n += row[i].equality;
    return n;
}

static fmb_status copy_row(const fmb_vec *from, bool turned, size_t d, fmb_arena *arena,
                           fmb_vec *to)
{
    to->s = fmb_arena_get(arena, d, sizeof *to->s);
    FMB_TRY(to->s ? fmb_vec_copy(to, from, d, arena->mem) : fmb_mem_status(arena->mem));
    if (turned)
        fmb_vec_negate(to, d);
    return FMB_OK;
}

/* An equality is two rows. v[] is zero. */
static fmb_status copy_rows(const fmb_cone_row *row, size_t rows, size_t d, fmb_arena *arena,
                            fmb_vec *v)
{
    for (size_t i = 0; i < rows; i++) {
        FMB_TRY(copy_row(row[i].v, false, d, arena, v++));
        if (row[i].equality)
            FMB_TRY(copy_row(row[i].v, true, d, arena, v++));
    }
    return FMB_OK;
}

/* Query the section, then take the rays found so far without a deadline. */
static fmb_status ask_and_take(fmb_run *run, const fmb_vec *v, size_t m, size_t d, fmb_image *image)
{
    fmb_section c;
    bool done, timed = run->deadline > 0;
    size_t most = timed ? 0 : RAYS_OF_COORDINATE * d;
    fmb_status st = fmb_section_open(&c, run, v, m, d);
    bool open = st == FMB_OK;
    if (open)
        st = fmb_section_ask(&c, most, timed ? 0 : PAIRS_OF_SEARCH, &done);
    run->deadline = 0;
    if (open && (st == FMB_OK || st == FMB_LIMIT) && fmb_run_go_on(run))
        st = fmb_section_take_rays(&c, image);
    fmb_section_close(&c);
    return st;
}

fmb_status fmb_find_some_rays(fmb_run *run, const fmb_cone_row *row, size_t rows, size_t d,
                              fmb_image *image)
{
    fmb_arena arena;
    fmb_stop why = run->stop;
    *image = (fmb_image){0};
    if (!fmb_run_go_on(run))
        return FMB_OK;
    size_t m = rows + count_equalities(row, rows);
    fmb_arena_init(&arena, run->mem);
    fmb_vec *v = fmb_mem_zero(run->mem, m, sizeof *v);
    fmb_status st = v ? copy_rows(row, rows, d, &arena, v) : fmb_mem_status(run->mem);
    FMB_THEN(st, ask_and_take(run, v, m, d, image));
    for (size_t i = 0; v && i < m; i++)
        fmb_vec_clear(&v[i], d, run->mem);
    fmb_mem_put(run->mem, v, m, sizeof *v);
    fmb_arena_clear(&arena);
    if (st == FMB_LIMIT) /* the image may be incomplete */
        fmb_image_clear(image);
    run->stop = run->stop == FMB_STOP_CANCELLED ? FMB_STOP_CANCELLED : why;
    return st == FMB_LIMIT ? FMB_OK : st;
}
