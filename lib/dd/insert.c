/* insert.c: one row comes into a cone; see insert.h.
 *
 * Rays that are negative in the row go; each pair of adjacent rays on its two sides makes a new
 * one, positive wherever one of the two is (but for the row itself). Until the last pair is done
 * the old rays stay where they are, so that the work may stop after any ray of the smaller side.
 */
#include "dd/insert.h"

#include <string.h>

#include "dd/adjacent.h"

/* So many small rays take as long as one of GMP's integers. */
#define WIDE_RAY 16

static void dismiss_crew(fmb_insertion *s, fmb_mem *mem)
{
    if (!s->crew)
        return;
    for (size_t k = 0; k < s->crew->team.size; k++)
        fmb_adjacency_clear(&s->crew->pairs[k], &s->crew->team.share[k].mem);
    fmb_team_close(&s->crew->team);
    fmb_mem_put(mem, s->crew, 1, sizeof *s->crew);
}

void fmb_insertion_clear(fmb_insertion *s, fmb_mem *mem)
{
    dismiss_crew(s, mem);
    fmb_mem_put(mem, s->ray, s->ray_capacity, sizeof *s->ray);
    fmb_mem_put(mem, s->large_side.word, s->large_side.capacity, sizeof *s->large_side.word);
    fmb_mem_put(mem, s->rest.word, s->rest.capacity, sizeof *s->rest.word);
    fmb_mem_put(mem, s->crowd.word, s->crowd.capacity, sizeof *s->crowd.word);
    fmb_mem_put(mem, s->crowded, s->crowded_capacity, sizeof *s->crowded);
    fmb_ray_edges_clear(&s->edges, mem);
    fmb_adjacency_clear(&s->pairs, mem);
    *s = (fmb_insertion){0};
}

/* Add sign for each row to come where the ray is negative. */
static void count_negatives_of_ray(fmb_cone *c, const fmb_vec *v, int sign)
{
    if (v->z)
        for (size_t k = 0; k < c->lefts; k++)
            c->negatives[k] += (size_t)(sign * (mpz_sgn(v->z[c->coords + k]) < 0));
    else
        for (size_t k = 0; k < c->lefts; k++)
            c->negatives[k] += (size_t)(sign * (v->s[c->coords + k] < 0));
}

/* ---- rows that meet a line ------------------------------------------------------------------- */

static void count_all_negatives(fmb_cone *c, int sign)
{
    for (size_t i = 0; i < c->ray.size; i++)
        count_negatives_of_ray(c, &c->ray.v[i], sign);
}

/* Move v along the line to where the row is 0. */
static fmb_status move_along_line(fmb_cone *c, fmb_vec *v, const fmb_vec *line, size_t entry)
{
    if (fmb_vec_sgn(v, entry) == 0)
        return FMB_OK;
    return fmb_vec_cancel(v, v, line, c->line.width, entry, &c->num);
}

/* The line, turned to where the row is positive, becomes a ray: in all rows before it is 0. */
static fmb_status make_ray_of_line(fmb_cone *c, size_t row, size_t entry, size_t i)
{
    fmb_status st = fmb_rays_reserve_bits(&c->ray, c->bits + 1);
    if (st == FMB_OK)
        st = fmb_rays_add(&c->ray);
    if (st != FMB_OK)
        return st;
    fmb_vec *v = &c->ray.v[c->ray.size - 1];
    st = fmb_vec_copy(v, &c->line.v[i], c->ray.width, c->run->mem);
    if (st == FMB_OK && fmb_vec_sgn(v, entry) < 0)
        for (size_t k = 0; k < c->ray.width; k++) {
            if (v->z)
                mpz_neg(v->z[k], v->z[k]);
            else
                v->s[k] = -v->s[k];
        }
    fmb_rays_support(&c->ray, c->ray.size - 1)[c->bits / 64] |= (uint64_t)1 << (c->bits % 64);
    c->row_of_bit[c->bits++] = row;
    c->rank++;
    c->made++;
    return st;
}

fmb_status fmb_insertion_break_line(fmb_cone *c, size_t row, size_t entry, size_t i)
{
    fmb_status st = FMB_OK;
    count_all_negatives(c, -1);
    for (size_t k = 0; st == FMB_OK && k < c->line.size; k++)
        if (k != i)
            st = move_along_line(c, &c->line.v[k], &c->line.v[i], entry);
    for (size_t k = 0; st == FMB_OK && k < c->ray.size; k++)
        st = move_along_line(c, &c->ray.v[k], &c->line.v[i], entry);
    if (st == FMB_OK && !c->of.row[row].equality)
        st = make_ray_of_line(c, row, entry, i);
    fmb_rays_remove(&c->line, i);
    count_all_negatives(c, 1);
    return st;
}

/* ---- rows that separate rays ----------------------------------------------------------------- */

/* List rays of that sign in the row. */
static size_t list_rays_of_sign(const fmb_cone *c, fmb_insertion *s, size_t at, int sign)
{
    for (size_t i = 0; i < c->ray.size; i++)
        if (fmb_vec_sgn(&c->ray.v[i], s->entry) == sign)
            s->ray[at++] = (uint32_t)i;
    return at;
}

static void give_bit_to_positives(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    const uint32_t *positive = s->small_is_positive ? s->ray + s->large : s->ray;
    size_t n = s->small_is_positive ? s->small : s->large;
    for (size_t k = 0; k < n; k++)
        fmb_rays_support(&c->ray, positive[k])[c->bits / 64] |= (uint64_t)1 << (c->bits % 64);
    c->row_of_bit[c->bits++] = s->row;
}

static void remove_negatives(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    const uint32_t *negative = s->small_is_positive ? s->ray : s->ray + s->large;
    for (size_t k = s->small_is_positive ? s->large : s->small; k-- > 0;) {
        count_negatives_of_ray(c, &c->ray.v[negative[k]], -1);
        fmb_rays_remove(&c->ray, negative[k]);
    }
}

/* A row that no ray violates is left out of the supports: others imply it. */
static void finish_insertion(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    bool cuts = (s->small_is_positive ? s->large : s->small) > 0;
    s->running = false;
    if (cuts || c->of.row[s->row].wanted)
        give_bit_to_positives(c);
    remove_negatives(c);
}

fmb_status fmb_insertion_begin(fmb_cone *c, size_t row, size_t entry)
{
    fmb_insertion *s = c->at;
    size_t rays = c->ray.size;
    if (rays >= UINT32_MAX / 2)
        return FMB_ERR_MEMORY;
    fmb_status st = fmb_rays_reserve_bits(&c->ray, c->bits + 1);
    if (st == FMB_OK)
        st = fmb_mem_reserve(c->run->mem, (void **)&s->ray, &s->ray_capacity, rays, sizeof *s->ray);
    if (st != FMB_OK)
        return st;
    s->entry = entry;
    s->row = row;
    s->rays = rays;
    s->next = 0;
    s->large = list_rays_of_sign(c, s, 0, -1);
    s->small = list_rays_of_sign(c, s, s->large, 1) - s->large;
    s->small_is_positive = s->small <= s->large;
    if (!s->small_is_positive) {
        s->large = list_rays_of_sign(c, s, 0, 1);
        s->small = list_rays_of_sign(c, s, s->large, -1) - s->large;
    }
    size_t signs = s->small + s->large;
    s->zeros = list_rays_of_sign(c, s, signs, 0) - signs;
    s->running = true;
    s->large_side.ready = s->rest.ready = false;
    return FMB_OK;
}

static fmb_status combine_pair_of_rays(fmb_cone *c, uint32_t a, uint32_t b)
{
    fmb_insertion *s = c->at;
    fmb_status st = fmb_rays_add(&c->ray);
    if (st != FMB_OK)
        return st;
    fmb_vec *v = &c->ray.v[c->ray.size - 1];
    st = fmb_vec_cancel(v, &c->ray.v[a], &c->ray.v[b], c->ray.width, s->entry, &c->num);
    if (st != FMB_OK)
        return st;
    uint64_t *to = fmb_rays_support(&c->ray, c->ray.size - 1);
    const uint64_t *x = fmb_rays_support(&c->ray, a), *y = fmb_rays_support(&c->ray, b);
    for (size_t k = 0; k < c->ray.words; k++)
        to[k] = x[k] | y[k];
    count_negatives_of_ray(c, v, 1);
    c->made += v->z ? WIDE_RAY : 1;
    return fmb_run_poll(c->run);
}

static fmb_status combine_with_found(fmb_cone *c, uint32_t a, const fmb_adjacency *p)
{
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < p->founds; k++)
        st = combine_pair_of_rays(c, a, p->found[k]);
    return st;
}

static fmb_status pair_next_ray(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    uint32_t a = s->ray[s->large + s->next];
    fmb_status st = fmb_run_poll(c->run);
    if (st == FMB_OK)
        st = fmb_find_adjacent(c, c->run, &s->pairs, s->next);
    s->next++;
    return st == FMB_OK ? combine_with_found(c, a, &s->pairs) : st;
}

/* ---- by several threads ---------------------------------------------------------------------- */

/* With fewer pairs in a round, threads wait longer than they work. */
#define PAIRS_FOR_CREW ((size_t)1 << 15)

static fmb_status hire_crew(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    s->crew = fmb_mem_zero(c->run->mem, 1, sizeof *s->crew);
    return s->crew ? fmb_team_open(&s->crew->team, c->run, FMB_INSERTION_CREW)
                   : fmb_mem_status(c->run->mem);
}

static fmb_status find_neighbours_of_ray(void *self, size_t k, fmb_run *run)
{
    fmb_cone *c = self;
    const fmb_insertion *s = c->at;
    fmb_status st = fmb_run_poll(run);
    return st == FMB_OK ? fmb_find_adjacent(c, run, &s->crew->pairs[k], s->next + k) : st;
}

/* Neighbours of several rays are found at once; they are combined as if one after another. What a
 * pause leaves is looked for again. */
static fmb_status pair_next_rays_at_once(fmb_cone *c, uint64_t most)
{
    fmb_insertion *s = c->at;
    size_t left = s->small - s->next, n = left < FMB_INSERTION_CREW ? left : FMB_INSERTION_CREW;
    fmb_status st = s->crew ? FMB_OK : hire_crew(c);
    if (st == FMB_OK && !s->rest.ready)
        st = fmb_adjacency_gather_rest(c);
    if (st == FMB_OK)
        st = fmb_team_do(&s->crew->team, n, find_neighbours_of_ray, c);
    for (size_t k = 0; st == FMB_OK && k < n && c->made < most; k++) {
        uint32_t a = s->ray[s->large + s->next];
        s->next++;
        st = combine_with_found(c, a, &s->crew->pairs[k]);
    }
    return st;
}

/* ---- all pairs ------------------------------------------------------------------------------- */

static bool is_work_for_crew(const fmb_cone *c)
{
    const fmb_insertion *s = c->at;
    return c->run->threads > 1 && s->next + FMB_INSERTION_CREW <= s->small &&
           (s->by_edges ? s->crowds : s->large) * FMB_INSERTION_CREW >= PAIRS_FOR_CREW;
}

fmb_status fmb_insertion_run(fmb_cone *c, uint64_t most)
{
    fmb_insertion *s = c->at;
    fmb_status st = FMB_OK;
    if (s->large > 0 && !s->large_side.ready)
        st = fmb_adjacency_begin(c);
    while (st == FMB_OK && s->next < s->small && s->large > 0 && c->made < most)
        st = is_work_for_crew(c) ? pair_next_rays_at_once(c, most) : pair_next_ray(c);
    if (st == FMB_OK && (s->next == s->small || s->large == 0))
        finish_insertion(c);
    return st;
}
