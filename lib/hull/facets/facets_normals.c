/* facets_normals.c: the normals of all facets, by several threads; see facets.h.
 *
 * Slots are divided into shares that are the same for any number of threads. Wide normals are
 * charged to the memory of their share until all are found.
 */
#include "hull/facets/facets_private.h"
#include "trace/team.h"

enum { CHUNKS = 16 };

/* With fewer facets than this, threads wait longer than they work. */
#define FACETS_FOR_THREADS 256

typedef struct normals {
    fmb_facets *f;
    size_t bytes[CHUNKS]; /* held by the normals of a share */
} normals;

static fmb_status find_normals_by(normals *w, size_t k, fmb_num *num, fmb_run *run)
{
    fmb_facets *f = w->f;
    fmb_normal_tools tools = {.num = num};
    size_t before = run->mem->used;
    fmb_status st = FMB_OK;
    for (size_t i = f->slots * k / CHUNKS; st == FMB_OK && i < f->slots * (k + 1) / CHUNKS; i++) {
        if (f->facet[i].alive && !f->facet[i].known)
            st = fmb_facets_find_normal(f, &f->facet[i], &tools);
        FMB_THEN(st, fmb_run_poll(run));
    }
    fmb_normal_tools_clear(f, &tools);
    w->bytes[k] = run->mem->used - before;
    return st;
}

static fmb_status find_normals_of_chunk(void *self, size_t k, fmb_run *run)
{
    normals *w = self;
    fmb_num num;
    FMB_TRY(fmb_run_open_num(run, &num, w->f->d + 1, false));
    fmb_status st = find_normals_by(w, k, &num, run);
    fmb_num_clear(&num);
    return st;
}

static fmb_status find_normals_together(fmb_facets *f)
{
    fmb_team team;
    normals w = {.f = f};
    fmb_status st = fmb_team_open(&team, f->run, CHUNKS);
    if (st == FMB_OK) {
        st = fmb_team_do(&team, CHUNKS, find_normals_of_chunk, &w);
        for (size_t k = 0; k < CHUNKS; k++)
            fmb_team_hand_over(&team, k, w.bytes[k]);
    }
    fmb_team_close(&team);
    return st;
}

fmb_status fmb_facets_need_all_normals(fmb_facets *f)
{
    if (f->run->threads > 1 && f->d <= FMB_FACETS_FEW && f->alive >= FACETS_FOR_THREADS)
        return find_normals_together(f);
    for (size_t i = 0; i < f->slots; i++) {
        if (f->facet[i].alive)
            FMB_TRY(fmb_facets_need_normal(f, i));
        FMB_TRY(fmb_run_poll(f->run));
    }
    return FMB_OK;
}
