/* insert_workers.c: jobs on each ray of a cone by several threads; see adjacent.h. */
#include "dd/adjacent.h"

/* So many simple rays, or rays of which an entry is processed, are worth several threads. */
#define WORTH_WORKERS 2048
#define WORTH_A_LOOK  16384

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status equip_chunk(fmb_cone *c, fmb_insertion_chunk *p, fmb_run *run)
{
    FMB_TRY(FMB_GET(run->mem, p->negatives, c->of.m));
    return fmb_run_open_num(run, &p->num, c->ray.width, c->of.wide_only);
}

fmb_status fmb_insertion_hire(fmb_cone *c)
{
    fmb_insertion_workers *w;
    FMB_TRY(FMB_GET_ZERO(c->run->mem, w, 1));
    c->at->workers = w;
    w->m = c->of.m;
    FMB_TRY(fmb_team_open(&w->team, c->run, FMB_INSERTION_CHUNKS));
    for (size_t k = 0; k < FMB_INSERTION_CHUNKS; k++)
        FMB_TRY(equip_chunk(c, &w->chunk[k], &w->team.share[k].run));
    return FMB_OK;
}

static void dismiss_chunk(fmb_insertion_chunk *p, size_t m, fmb_mem *mem)
{
    fmb_adjacency_clear(&p->pairs, mem);
    fmb_mem_put(mem, p->found, p->found_capacity, sizeof *p->found);
    fmb_mem_put(mem, p->negatives, m, sizeof *p->negatives);
    fmb_num_clear(&p->num);
}

void fmb_insertion_dismiss_workers(fmb_insertion *s, fmb_mem *mem)
{
    fmb_insertion_workers *w = s->workers;
    if (!w)
        return;
    for (size_t k = 0; k < w->team.size; k++)
        dismiss_chunk(&w->chunk[k], w->m, &w->team.share[k].mem);
    fmb_team_close(&w->team);
    fmb_mem_put(mem, w, 1, sizeof *w);
    s->workers = NULL;
}

fmb_status fmb_insertion_do(fmb_cone *c, fmb_team_job job)
{
    FMB_TRY(c->at->workers ? FMB_OK : fmb_insertion_hire(c));
    return fmb_team_do(&c->at->workers->team, FMB_INSERTION_CHUNKS, job, c);
}

/* ---- an entry of each ray -------------------------------------------------------------------- */

static fmb_side_part part_of_side(size_t rays, size_t k)
{
    return (fmb_side_part){rays * k / FMB_INSERTION_CHUNKS, rays * (k + 1) / FMB_INSERTION_CHUNKS};
}

static bool is_a_look_for_workers(const fmb_cone *c)
{
    size_t price = c->ray.size > 0 ? (size_t)fmb_ray_price(&c->ray.v[c->ray.size - 1]) : 0;
    return c->at->workers && c->ray.size * price >= WORTH_A_LOOK;
}

/* While a chunk works on rays their memory is counted separately, with the chunk's own limit. */
static fmb_mem count_rays_aside(const fmb_cone *c, fmb_side_part part, const fmb_mem *chunk)
{
    fmb_mem aside;
    size_t bytes = fmb_rays_bytes_of(&c->ray, part.from, part.to);
    fmb_mem_init(&aside, &chunk->alloc, 0);
    fmb_mem_take(&aside, bytes);
    if (chunk->limit > 0)
        aside.limit = bytes + (chunk->limit > chunk->used ? chunk->limit - chunk->used : 1);
    return aside;
}

static fmb_status set_values_of_chunk(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_insertion_workers *w = c->at->workers;
    fmb_side_part part = part_of_side(c->ray.size, k);
    fmb_mem aside = count_rays_aside(c, part, run->mem);
    size_t before = aside.used;
    fmb_status st = FMB_OK;
    w->chunk[k].num.mem = &aside;
    for (size_t i = part.from; st == FMB_OK && i < part.to; i++) {
        st = fmb_vec_set_product(&c->ray.v[i], c->coords, c->ray.width, w->row, &w->chunk[k].num);
        FMB_THEN(st, fmb_run_poll(run));
    }
    w->chunk[k].num.mem = run->mem;
    w->chunk[k].before = before;
    w->chunk[k].after = aside.used;
    return st;
}

static fmb_status set_values_of_rays(fmb_cone *c, const fmb_vec *row)
{
    fmb_status st = FMB_OK;
    if (is_a_look_for_workers(c)) {
        c->at->workers->row = row;
        st = fmb_insertion_do(c, set_values_of_chunk);
        for (size_t k = 0; k < FMB_INSERTION_CHUNKS; k++) {
            fmb_mem_take(c->run->mem, c->at->workers->chunk[k].after);
            fmb_mem_refund(c->run->mem, c->at->workers->chunk[k].before);
        }
        return st;
    }
    for (size_t i = 0; st == FMB_OK && i < c->ray.size; i++) {
        st = fmb_vec_set_product(&c->ray.v[i], c->coords, c->ray.width, row, &c->num);
        FMB_THEN(st, fmb_run_poll(c->run));
    }
    return st;
}

fmb_status fmb_insertion_set_values(fmb_cone *c, const fmb_vec *row)
{
    for (size_t i = 0; i < c->line.size; i++)
        FMB_TRY(fmb_vec_set_product(&c->line.v[i], c->coords, c->ray.width, row, &c->num));
    return set_values_of_rays(c, row);
}

/* ---- edges ----------------------------------------------------------------------------------- */

static fmb_status enter_edges_of_chunk(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_edge_sides of = fmb_adjacency_sides(c);
    return fmb_ray_edges_enter(&c->at->edges, &of, part_of_side(of.smalls, k), run);
}

static fmb_status look_up_edges_of_chunk(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_edge_sides of = fmb_adjacency_sides(c);
    return fmb_ray_edges_look_up(&c->at->edges, &of, part_of_side(of.larges, k), run);
}

fmb_status fmb_insertion_find_edges(fmb_cone *c)
{
    fmb_edge_sides of = fmb_adjacency_sides(c);
    if (c->run->threads < 2 || of.smalls + of.larges < WORTH_WORKERS)
        return fmb_ray_edges_find(&c->at->edges, &of, c->run);
    FMB_TRY(fmb_ray_edges_begin(&c->at->edges, &of, c->run));
    FMB_TRY(fmb_insertion_do(c, enter_edges_of_chunk));
    return fmb_insertion_do(c, look_up_edges_of_chunk);
}
