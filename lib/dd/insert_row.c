/* insert_row.c: inserts one row into a cone; see insert.h.
 *
 * Rays that are negative in the row are removed; each pair of adjacent rays on its two sides makes
 * a new one, positive wherever one of the two is (except in the row itself). The old rays stay in
 * place until the last pair is done, so that the work may pause after any ray of the smaller side.
 */
#include "dd/insert.h"

#include <string.h>

#include "dd/adjacent.h"

void fmb_insertion_clear(fmb_insertion *s, fmb_mem *mem)
{
    fmb_insertion_dismiss_workers(s, mem);
    fmb_mem_put(mem, s->ray, s->ray_capacity, sizeof *s->ray);
    fmb_mem_put(mem, s->sign, s->sign_capacity, sizeof *s->sign);
    fmb_mem_put(mem, s->large_side.word, s->large_side.capacity, sizeof *s->large_side.word);
    fmb_mem_put(mem, s->rest.word, s->rest.capacity, sizeof *s->rest.word);
    fmb_mem_put(mem, s->crowd.word, s->crowd.capacity, sizeof *s->crowd.word);
    fmb_mem_put(mem, s->crowded, s->crowded_capacity, sizeof *s->crowded);
    fmb_ray_edges_clear(&s->edges, mem);
    fmb_adjacency_clear(&s->pairs, mem);
    *s = (fmb_insertion){0};
}

/* ---- rows that meet a line ------------------------------------------------------------------- */

static void count_all_negatives(fmb_cone *c, int sign)
{
    for (size_t i = 0; i < c->ray.size; i++)
        fmb_cone_count_negatives(c, &c->ray.v[i], sign, c->negatives);
}

/* Move v along the line to where the row is zero. */
static fmb_status move_along_line(fmb_cone *c, fmb_vec *v, const fmb_vec *line, size_t entry)
{
    if (fmb_vec_sgn(v, entry) == 0)
        return FMB_OK;
    fmb_status st = fmb_vec_cancel(v, v, line, c->line.width, entry, &c->num);
    fmb_run_count(c->run, fmb_work_of_ray(v, c->line.width));
    return st == FMB_OK ? fmb_run_poll_step(c->run, fmb_vec_is_wide(v)) : st;
}

/* Turn the line to where the row is positive and make it a ray: it is zero in all earlier rows. */
static fmb_status make_ray_of_line(fmb_cone *c, size_t row, size_t entry, size_t i)
{
    FMB_TRY(fmb_rays_reserve_bits(&c->ray, c->bits + 1));
    FMB_TRY(fmb_rays_add(&c->ray));
    fmb_vec *v = &c->ray.v[c->ray.size - 1];
    fmb_status st = fmb_vec_copy(v, &c->line.v[i], c->ray.width, c->run->mem);
    if (st == FMB_OK && fmb_vec_sgn(v, entry) < 0)
        fmb_vec_negate(v, c->ray.width);
    fmb_set_put(fmb_rays_support(&c->ray, c->ray.size - 1), c->bits);
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

/* List the rays by their signs in the row: those of the larger side, of the smaller one, zeros. */
static void list_sides_of_row(const fmb_cone *c, fmb_insertion *s)
{
    size_t rays[3] = {0}, at[3]; /* of each sign, from -1 on */
    for (size_t i = 0; i < c->ray.size; i++) {
        s->sign[i] = (int8_t)fmb_vec_sgn(&c->ray.v[i], s->entry);
        rays[s->sign[i] + 1]++;
    }
    s->small_is_positive = rays[2] <= rays[0];
    s->large = s->small_is_positive ? rays[0] : rays[2];
    s->small = s->small_is_positive ? rays[2] : rays[0];
    s->zeros = rays[1];
    at[0] = s->small_is_positive ? 0 : s->large;
    at[1] = s->small + s->large;
    at[2] = s->small_is_positive ? s->large : 0;
    for (size_t i = 0; i < c->ray.size; i++)
        s->ray[at[s->sign[i] + 1]++] = (uint32_t)i;
}

static void give_bit_to_positives(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    const uint32_t *positive = s->small_is_positive ? s->ray + s->large : s->ray;
    size_t n = s->small_is_positive ? s->small : s->large;
    for (size_t k = 0; k < n; k++)
        fmb_set_put(fmb_rays_support(&c->ray, positive[k]), c->bits);
    c->row_of_bit[c->bits++] = s->row;
}

static void remove_negatives(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    const uint32_t *negative = s->small_is_positive ? s->ray : s->ray + s->large;
    for (size_t k = s->small_is_positive ? s->large : s->small; k-- > 0;) {
        fmb_cone_count_negatives(c, &c->ray.v[negative[k]], -1, c->negatives);
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
    FMB_TRY(fmb_rays_reserve_bits(&c->ray, c->bits + 1));
    FMB_TRY(FMB_RESERVE(c->run->mem, &s->ray, &s->ray_capacity, rays));
    FMB_TRY(FMB_RESERVE(c->run->mem, &s->sign, &s->sign_capacity, rays));
    fmb_run_count(c->run, 300 + 6 * rays);
    s->entry = entry;
    s->row = row;
    s->rays = rays;
    s->next = 0;
    list_sides_of_row(c, s);
    s->running = true;
    s->large_side.ready = s->rest.ready = false;
    return FMB_OK;
}

static fmb_status add_ray_of_pair(fmb_cone *c, uint32_t a, uint32_t b)
{
    size_t at = c->ray.size;
    FMB_TRY(fmb_rays_add(&c->ray));
    FMB_TRY(fmb_insertion_combine(c, at, a, b, &c->num));
    fmb_cone_count_negatives(c, &c->ray.v[at], 1, c->negatives);
    c->made += fmb_ray_price(&c->ray.v[at]);
    fmb_run_count(c->run, fmb_work_of_ray(&c->ray.v[at], c->ray.width));
    return fmb_run_poll_step(c->run, fmb_vec_is_wide(&c->ray.v[at]));
}

static fmb_status pair_next_ray(fmb_cone *c)
{
    fmb_insertion *s = c->at;
    uint32_t a = s->ray[s->large + s->next];
    fmb_status st = fmb_run_poll(c->run);
    FMB_THEN(st, fmb_find_adjacent(c, c->run, &s->pairs, s->next));
    s->next++;
    for (size_t k = 0; st == FMB_OK && k < s->pairs.founds; k++)
        st = add_ray_of_pair(c, a, s->pairs.found[k]);
    return st;
}

/* ---- all pairs ------------------------------------------------------------------------------- */

static fmb_status prepare_pairs(fmb_cone *c)
{
    fmb_status st = fmb_adjacency_begin(c);
    size_t edges = c->at->by_edges ? (c->at->small + c->at->large) * c->rank : 0;
    fmb_run_count(c->run, 300 + 20 * edges + 8 * c->at->rays);
    return st == FMB_OK && edges > 0 ? fmb_insertion_find_edges(c) : st;
}

fmb_status fmb_insertion_run(fmb_cone *c, uint64_t most)
{
    fmb_insertion *s = c->at;
    if (s->large > 0 && !s->large_side.ready)
        FMB_TRY(prepare_pairs(c));
    while (s->next < s->small && s->large > 0 && c->made < most && !fmb_run_is_slice_over(c->run))
        FMB_TRY(fmb_insertion_is_work_for_workers(c) ? fmb_insertion_run_workers(c, most)
                                                     : pair_next_ray(c));
    if (s->next == s->small || s->large == 0)
        finish_insertion(c);
    return FMB_OK;
}
