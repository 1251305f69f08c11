/* insert_batch.c: combines pairs of rays by several threads; see adjacent.h.
 *
 * The rays of the smaller side are taken in batches. First each chunk finds the neighbours of its
 * rays; then new rays get their places, in the order of one thread; then each chunk computes its
 * own. A batch ends where one thread would have paused: new rays beyond that are removed.
 */
#include "dd/adjacent.h"

/* So many tests of rays of the larger side cost as much as a new ray. */
#define LOOKS_OF_RAY 64
/* About the number of new rays in a chunk. */
#define WORTH_A_CHUNK 1024

/* ---- neighbours ------------------------------------------------------------------------------ */

static fmb_status find_neighbours_of_chunk(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_insertion_chunk *p = &c->at->workers->chunk[k];
    fmb_status st = FMB_OK;
    p->founds = 0;
    for (size_t i = 0; st == FMB_OK && i < p->rays; i++) {
        st = fmb_run_poll(run);
        FMB_THEN(st, fmb_find_adjacent(c, run, &p->pairs, p->first + i));
        size_t n = st == FMB_OK ? p->pairs.founds : 0;
        FMB_THEN(st, FMB_RESERVE(run->mem, &p->found, &p->found_capacity, p->founds + n));
        for (size_t j = 0; st == FMB_OK && j < n; j++)
            p->found[p->founds++] = p->pairs.found[j];
        p->end[i] = p->founds;
    }
    return st;
}

/* The work for the next ray of the smaller side, counted in small new rays. */
static size_t work_of_ray(const fmb_cone *c)
{
    const fmb_insertion *s = c->at;
    size_t price = (size_t)fmb_ray_price(&c->ray.v[s->ray[s->large + s->next]]);
    return c->rank * price + (s->by_edges ? s->crowds : s->large) / LOOKS_OF_RAY;
}

static void divide_batch(fmb_cone *c, uint64_t most)
{
    fmb_insertion *s = c->at;
    size_t each = 1 + WORTH_A_CHUNK / work_of_ray(c), next = s->next, left = s->small - next;
    left = left < most - c->made ? left : (size_t)(most - c->made);
    each = each < FMB_INSERTION_CHUNK_RAYS ? each : FMB_INSERTION_CHUNK_RAYS;
    each = each < left / FMB_INSERTION_CHUNKS + 1 ? each : left / FMB_INSERTION_CHUNKS + 1;
    for (size_t k = 0; k < FMB_INSERTION_CHUNKS; k++) {
        size_t n = left < each ? left : each;
        s->workers->chunk[k].first = next;
        s->workers->chunk[k].rays = n;
        next += n;
        left -= n;
    }
}

/* ---- new rays -------------------------------------------------------------------------------- */

/* Add new rays up to the number at which a pause is due if all of them are small. */
static fmb_status make_room_for_rays(fmb_cone *c, uint64_t most)
{
    uint64_t made = c->made;
    size_t at = c->ray.size;
    for (size_t k = 0; k < FMB_INSERTION_CHUNKS; k++) {
        fmb_insertion_chunk *p = &c->at->workers->chunk[k];
        size_t rays = 0, n = 0;
        for (; rays < p->rays && made + n < most; rays++)
            n = p->end[rays];
        p->rays = rays;
        p->at = at;
        made += n;
        at += n;
    }
    return fmb_rays_add_many(&c->ray, at - c->ray.size);
}

static fmb_status make_rays_of_chunk(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_insertion_chunk *p = &c->at->workers->chunk[k];
    size_t at = p->at, j = 0, before = run->mem->used;
    fmb_status st = FMB_OK;
    for (size_t i = 0; i < c->lefts; i++)
        p->negatives[i] = 0;
    for (size_t i = 0; i < p->rays; i++) {
        uint32_t a = c->at->ray[c->at->large + p->first + i];
        for (; st == FMB_OK && j < p->end[i]; j++, at++) {
            st = fmb_insertion_combine(c, at, a, p->found[j], &p->num);
            if (st == FMB_OK)
                fmb_cone_count_negatives(c, &c->ray.v[at], 1, p->negatives);
            fmb_run_count(run, fmb_work_of_ray(&c->ray.v[at], c->ray.width));
            FMB_THEN(st, fmb_run_poll(run));
        }
    }
    p->bytes = run->mem->used - before;
    return st;
}

/* Charge the new rays to the cone, even after an error. */
static void take_over_rays(fmb_cone *c)
{
    fmb_insertion_workers *w = c->at->workers;
    for (size_t k = 0; k < FMB_INSERTION_CHUNKS; k++) {
        fmb_team_hand_over(&w->team, k, w->chunk[k].bytes);
        for (size_t i = 0; i < c->lefts; i++)
            c->negatives[i] += w->chunk[k].negatives[i];
        c->num.promotions += w->chunk[k].num.promotions;
        w->chunk[k].num.promotions = 0;
    }
}

static void count_rays_until_pause(fmb_cone *c, uint64_t most)
{
    size_t at = c->ray.size;
    for (size_t k = 0; k < FMB_INSERTION_CHUNKS; k++) {
        const fmb_insertion_chunk *p = &c->at->workers->chunk[k];
        at = p->at;
        for (size_t i = 0; i < p->rays && c->made < most; i++, c->at->next++)
            for (; at < p->at + p->end[i]; at++)
                c->made += fmb_ray_price(&c->ray.v[at]);
        if (c->made >= most)
            break;
    }
    while (c->ray.size > at) {
        fmb_cone_count_negatives(c, &c->ray.v[c->ray.size - 1], -1, c->negatives);
        fmb_rays_remove(&c->ray, c->ray.size - 1);
    }
}

static fmb_status make_rays_of_batch(fmb_cone *c, uint64_t most)
{
    FMB_TRY(make_room_for_rays(c, most));
    fmb_status st = fmb_insertion_do(c, make_rays_of_chunk);
    take_over_rays(c);
    if (st == FMB_OK)
        count_rays_until_pause(c, most);
    return st;
}

/* ---- a batch --------------------------------------------------------------------------------- */

bool fmb_insertion_is_work_for_workers(const fmb_cone *c)
{
    const fmb_insertion *s = c->at;
    return c->run->threads > 1 && s->next + FMB_INSERTION_CHUNKS <= s->small &&
           (s->small - s->next) * work_of_ray(c) >= 4 * WORTH_A_CHUNK;
}

fmb_status fmb_insertion_run_workers(fmb_cone *c, uint64_t most)
{
    fmb_insertion *s = c->at;
    FMB_TRY(s->workers ? FMB_OK : fmb_insertion_hire(c));
    if (!s->rest.ready)
        FMB_TRY(fmb_adjacency_gather_rest(c));
    divide_batch(c, most);
    FMB_TRY(fmb_insertion_do(c, find_neighbours_of_chunk));
    return make_rays_of_batch(c, most);
}
