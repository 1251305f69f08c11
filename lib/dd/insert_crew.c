/* insert_crew.c: pairs of rays by several threads; see insert.h.
 *
 * Rays of the smaller side come in batches, a batch in shares that are the same for any number of
 * threads. First each share finds the neighbours of its rays; then new rays get their places, in
 * the order of one thread; then each share fills in its own. A batch ends where one thread would
 * have paused: what was made beyond that goes again.
 */
#include "dd/adjacent.h"
#include "trace/team.h"

enum {
    SHARES = 16,
    MOST_RAYS = 64 /* of the smaller side, in a share */
};

/* What costs as much as a new ray: looks at so many rays of the larger side. */
#define LOOKS_OF_RAY 64
/* New rays in a share, about; simple rays whose edges are worth a crew; and rays of which an entry
 * is looked at. */
#define WORTH_A_SHARE 1024
#define WORTH_A_CREW  2048
#define WORTH_A_LOOK  16384

typedef struct crew_share {
    size_t first, rays; /* on the smaller side */
    fmb_adjacency pairs;
    uint32_t *found; /* neighbours of its rays, one ray after another, */
    size_t founds, found_capacity;
    size_t end[MOST_RAYS]; /* up to there */
    size_t at;             /* the place of its first new ray */
    fmb_num num;
    size_t *negatives;    /* [m] what its new rays add to those of the cone */
    size_t bytes;         /* that its new rays hold */
    size_t before, after; /* what its part of all rays held and holds [bytes] */
} crew_share;

struct fmb_insertion_crew {
    fmb_team team;
    size_t m;
    const fmb_vec *row; /* whose values are taken */
    crew_share share[SHARES];
};

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status equip_share(fmb_cone *c, crew_share *p, fmb_mem *mem)
{
    p->negatives = fmb_mem_get(mem, c->of.m, sizeof *p->negatives);
    if (!p->negatives)
        return fmb_mem_status(mem);
    fmb_status st = fmb_num_init(&p->num, mem, c->ray.width, c->of.wide_only);
    p->num.kernels = c->run->kernels;
    return st;
}

static fmb_status hire_crew(fmb_cone *c)
{
    fmb_insertion_crew *w = fmb_mem_zero(c->run->mem, 1, sizeof *w);
    if (!w)
        return fmb_mem_status(c->run->mem);
    c->at->crew = w;
    w->m = c->of.m;
    fmb_status st = fmb_team_open(&w->team, c->run, SHARES);
    for (size_t k = 0; st == FMB_OK && k < SHARES; k++)
        st = equip_share(c, &w->share[k], &w->team.share[k].mem);
    return st;
}

static void dismiss_share(crew_share *p, size_t m, fmb_mem *mem)
{
    fmb_adjacency_clear(&p->pairs, mem);
    fmb_mem_put(mem, p->found, p->found_capacity, sizeof *p->found);
    fmb_mem_put(mem, p->negatives, m, sizeof *p->negatives);
    fmb_num_clear(&p->num);
}

void fmb_insertion_dismiss_crew(fmb_insertion *s, fmb_mem *mem)
{
    fmb_insertion_crew *w = s->crew;
    if (!w)
        return;
    for (size_t k = 0; k < w->team.size; k++)
        dismiss_share(&w->share[k], w->m, &w->team.share[k].mem);
    fmb_team_close(&w->team);
    fmb_mem_put(mem, w, 1, sizeof *w);
    s->crew = NULL;
}

static fmb_status do_shares(fmb_cone *c, fmb_team_job job)
{
    fmb_status st = c->at->crew ? FMB_OK : hire_crew(c);
    return st == FMB_OK ? fmb_team_do(&c->at->crew->team, SHARES, job, c) : st;
}

/* ---- an entry of each ray -------------------------------------------------------------------- */

static fmb_side_part part_of_side(size_t rays, size_t k)
{
    return (fmb_side_part){rays * k / SHARES, rays * (k + 1) / SHARES};
}

static fmb_status find_signs_of_share(void *self, size_t k, fmb_run *run)
{
    const fmb_cone *c = self;
    fmb_side_part part = part_of_side(c->ray.size, k);
    for (size_t i = part.from; i < part.to; i++)
        c->at->sign[i] = (int8_t)fmb_vec_sgn(&c->ray.v[i], c->at->entry);
    return fmb_run_poll(run);
}

static bool is_a_look_for_crew(const fmb_cone *c)
{
    size_t price = c->ray.size > 0 ? (size_t)fmb_ray_price(&c->ray.v[c->ray.size - 1]) : 0;
    return c->at->crew && c->ray.size * price >= WORTH_A_LOOK;
}

fmb_status fmb_insertion_find_signs(fmb_cone *c)
{
    if (is_a_look_for_crew(c))
        return do_shares(c, find_signs_of_share);
    for (size_t i = 0; i < c->ray.size; i++)
        c->at->sign[i] = (int8_t)fmb_vec_sgn(&c->ray.v[i], c->at->entry);
    return FMB_OK;
}

/* What rays hold is counted aside while a share works on them, with as much room as it has. */
static fmb_mem count_rays_aside(const fmb_cone *c, fmb_side_part part, const fmb_mem *share)
{
    fmb_mem aside;
    size_t bytes = fmb_rays_bytes_of(&c->ray, part.from, part.to);
    fmb_mem_init(&aside, &share->alloc, 0);
    fmb_mem_take(&aside, bytes);
    if (share->limit > 0)
        aside.limit = bytes + (share->limit > share->used ? share->limit - share->used : 1);
    return aside;
}

static void note_bytes_of_share(fmb_cone *c, size_t k, size_t before, size_t after)
{
    c->at->crew->share[k].before = before;
    c->at->crew->share[k].after = after;
}

static void count_rays_again(fmb_cone *c)
{
    for (size_t k = 0; k < SHARES; k++) {
        fmb_mem_take(c->run->mem, c->at->crew->share[k].after);
        fmb_mem_refund(c->run->mem, c->at->crew->share[k].before);
    }
}

static fmb_status drop_entry_of_share(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_side_part part = part_of_side(c->ray.size, k);
    fmb_mem aside = count_rays_aside(c, part, run->mem);
    size_t before = aside.used;
    fmb_status st = fmb_rays_drop_entry_of(&c->ray, c->at->entry, part.from, part.to, &aside);
    note_bytes_of_share(c, k, before, aside.used);
    return st;
}

fmb_status fmb_insertion_drop_entry(fmb_cone *c, size_t entry)
{
    if (!is_a_look_for_crew(c))
        return fmb_rays_drop_entry(&c->ray, entry);
    c->at->entry = entry;
    fmb_status st = do_shares(c, drop_entry_of_share);
    count_rays_again(c);
    c->ray.width--;
    return st;
}

static fmb_status set_values_of_share(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_insertion_crew *w = c->at->crew;
    fmb_side_part part = part_of_side(c->ray.size, k);
    fmb_mem aside = count_rays_aside(c, part, run->mem);
    size_t before = aside.used;
    fmb_status st = FMB_OK;
    w->share[k].num.mem = &aside;
    for (size_t i = part.from; st == FMB_OK && i < part.to; i++) {
        st = fmb_insertion_set_value(c, &c->ray.v[i], w->row, &w->share[k].num);
        if (st == FMB_OK)
            st = fmb_run_poll(run);
    }
    w->share[k].num.mem = run->mem;
    note_bytes_of_share(c, k, before, aside.used);
    return st;
}

static fmb_status set_values_of_rays(fmb_cone *c, const fmb_vec *row)
{
    fmb_status st = FMB_OK;
    if (is_a_look_for_crew(c)) {
        c->at->crew->row = row;
        st = do_shares(c, set_values_of_share);
        count_rays_again(c);
        return st;
    }
    for (size_t i = 0; st == FMB_OK && i < c->ray.size; i++) {
        st = fmb_insertion_set_value(c, &c->ray.v[i], row, &c->num);
        if (st == FMB_OK)
            st = fmb_run_poll(c->run);
    }
    return st;
}

fmb_status fmb_insertion_set_values(fmb_cone *c, const fmb_vec *row)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < c->line.size; i++)
        st = fmb_insertion_set_value(c, &c->line.v[i], row, &c->num);
    return st == FMB_OK ? set_values_of_rays(c, row) : st;
}

/*-- --edges-- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -- -* /

    static fmb_status enter_edges_of_share(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_edge_sides of = fmb_adjacency_sides(c);
    return fmb_ray_edges_enter(&c->at->edges, &of, part_of_side(of.smalls, k), run);
}

static fmb_status look_up_edges_of_share(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    fmb_edge_sides of = fmb_adjacency_sides(c);
    return fmb_ray_edges_look_up(&c->at->edges, &of, part_of_side(of.larges, k), run);
}

fmb_status fmb_insertion_find_edges(fmb_cone *c)
{
    fmb_edge_sides of = fmb_adjacency_sides(c);
    if (c->run->threads < 2 || of.smalls + of.larges < WORTH_A_CREW)
        return fmb_ray_edges_find(&c->at->edges, &of, c->run);
    fmb_status st = fmb_ray_edges_begin(&c->at->edges, &of, c->run);
    if (st == FMB_OK)
        st = do_shares(c, enter_edges_of_share);
    return st == FMB_OK ? do_shares(c, look_up_edges_of_share) : st;
}

/* ---- neighbours ------------------------------------------------------------------------------ */

static fmb_status find_neighbours_of_share(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    crew_share *p = &c->at->crew->share[k];
    fmb_status st = FMB_OK;
    p->founds = 0;
    for (size_t i = 0; st == FMB_OK && i < p->rays; i++) {
        st = fmb_run_poll(run);
        if (st == FMB_OK)
            st = fmb_find_adjacent(c, run, &p->pairs, p->first + i);
        size_t n = st == FMB_OK ? p->pairs.founds : 0;
        if (st == FMB_OK)
            st = fmb_mem_reserve(run->mem, (void **)&p->found, &p->found_capacity, p->founds + n,
                                 sizeof *p->found);
        for (size_t j = 0; st == FMB_OK && j < n; j++)
            p->found[p->founds++] = p->pairs.found[j];
        p->end[i] = p->founds;
    }
    return st;
}

/* The next ray of the smaller side, as so many small new rays. */
static size_t work_of_ray(const fmb_cone *c)
{
    const fmb_insertion *s = c->at;
    size_t price = (size_t)fmb_ray_price(&c->ray.v[s->ray[s->large + s->next]]);
    return c->rank * price + (s->by_edges ? s->crowds : s->large) / LOOKS_OF_RAY;
}

static void divide_batch(fmb_cone *c, uint64_t most)
{
    fmb_insertion *s = c->at;
    size_t each = 1 + WORTH_A_SHARE / work_of_ray(c), next = s->next, left = s->small - next;
    left = left < most - c->made ? left : (size_t)(most - c->made);
    each = each < MOST_RAYS ? each : MOST_RAYS;
    each = each < left / SHARES + 1 ? each : left / SHARES + 1;
    for (size_t k = 0; k < SHARES; k++) {
        size_t n = left < each ? left : each;
        s->crew->share[k].first = next;
        s->crew->share[k].rays = n;
        next += n;
        left -= n;
    }
}

/* ---- new rays -------------------------------------------------------------------------------- */

/* Up to where a pause is due if all of them are small. */
static fmb_status make_room_for_rays(fmb_cone *c, uint64_t most)
{
    uint64_t made = c->made;
    size_t at = c->ray.size;
    for (size_t k = 0; k < SHARES; k++) {
        crew_share *p = &c->at->crew->share[k];
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

static fmb_status make_rays_of_share(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    crew_share *p = &c->at->crew->share[k];
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
            if (st == FMB_OK)
                st = fmb_run_poll(run);
        }
    }
    p->bytes = run->mem->used - before;
    return st;
}

/* New rays are the cone's own, whatever has happened. */
static void take_over_rays(fmb_cone *c)
{
    fmb_insertion_crew *w = c->at->crew;
    for (size_t k = 0; k < SHARES; k++) {
        fmb_team_hand_over(&w->team, k, w->share[k].bytes);
        for (size_t i = 0; i < c->lefts; i++)
            c->negatives[i] += w->share[k].negatives[i];
        c->num.promotions += w->share[k].num.promotions;
        w->share[k].num.promotions = 0;
    }
}

static void count_rays_until_pause(fmb_cone *c, uint64_t most)
{
    size_t at = c->ray.size;
    for (size_t k = 0; k < SHARES; k++) {
        const crew_share *p = &c->at->crew->share[k];
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
    fmb_status st = make_room_for_rays(c, most);
    if (st != FMB_OK)
        return st;
    st = do_shares(c, make_rays_of_share);
    take_over_rays(c);
    if (st == FMB_OK)
        count_rays_until_pause(c, most);
    return st;
}

/* ---- a batch --------------------------------------------------------------------------------- */

bool fmb_insertion_is_work_for_crew(const fmb_cone *c)
{
    const fmb_insertion *s = c->at;
    return c->run->threads > 1 && s->next + SHARES <= s->small &&
           (s->small - s->next) * work_of_ray(c) >= 4 * WORTH_A_SHARE;
}

fmb_status fmb_insertion_run_crew(fmb_cone *c, uint64_t most)
{
    fmb_insertion *s = c->at;
    fmb_status st = s->crew ? FMB_OK : hire_crew(c);
    if (st == FMB_OK && !s->rest.ready)
        st = fmb_adjacency_gather_rest(c);
    if (st != FMB_OK)
        return st;
    divide_batch(c, most);
    st = do_shares(c, find_neighbours_of_share);
    return st == FMB_OK ? make_rays_of_batch(c, most) : st;
}
