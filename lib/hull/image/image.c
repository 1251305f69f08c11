/* image.c: the image of a cone, and its facets; see image.h. */
#include "hull/image/image.h"

#include <string.h>

#include "num/gcd.h"
#include "num/residue.h"
#include "trace/sort.h"

/* ---- rays of the image ----------------------------------------------------------------------- */

static bool is_zero_vector(const fmb_vec *v, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (fmb_vec_sgn(v, k) != 0)
            return false;
    return true;
}

/* The coordinates of a ray or line, in lowest terms. */
fmb_status fmb_image_copy_coordinates(fmb_image *m, fmb_vec *to, const fmb_vec *from)
{
    *to = (fmb_vec){.s = fmb_arena_get(&m->arena, m->n, sizeof *to->s)};
    if (!to->s)
        return fmb_mem_status(m->run->mem);
    FMB_TRY(fmb_vec_copy(to, from, m->n, m->run->mem));
    if (!to->z)
        fmb_vec_measure(to, m->n);
    return fmb_vec_reduce(to, m->n, &m->num);
}

static void unite_supports(fmb_image *m, uint64_t *to, const uint64_t *from)
{
    for (size_t k = 0; k < m->words; k++)
        to[k] |= from[k];
}

typedef struct sorted_ray {
    fmb_vec v;
    uint64_t *support;
    const fmb_vec *above;
    size_t n;
    int64_t first; /* first entry, or the nearest int64: mostly decides the order */
} sorted_ray;

static int64_t first_entry_or_near(const fmb_vec *v)
{
    if (!v->z)
        return v->s[0];
    if (fmb_integer_is_i64(v->z[0]))
        return fmb_integer_get_i64(v->z[0]);
    return mpz_sgn(v->z[0]) < 0 ? INT64_MIN : INT64_MAX;
}

static int compare_rays_lexicographically(const void *x, const void *y)
{
    const sorted_ray *a = x, *b = y;
    if (a->first != b->first)
        return a->first < b->first ? -1 : 1;
    return fmb_vec_compare(&a->v, &b->v, a->n);
}

/* Sort the rays and merge equal ones. */
static fmb_status sort_rays_of_image(fmb_image *m)
{
    fmb_mem *mem = m->run->mem;
    size_t rays = m->rays, left = 0;
    sorted_ray *list;
    FMB_TRY(FMB_GET(mem, list, rays));
    for (size_t i = 0; i < rays; i++)
        list[i] = (sorted_ray){m->ray[i], m->support[i], m->above[i], m->n,
                               first_entry_or_near(&m->ray[i])};
    fmb_status st = fmb_run_sort(m->run, list, rays, sizeof *list, compare_rays_lexicographically);
    for (size_t i = 0; st == FMB_OK && i < rays; i++) {
        bool is_same = i > 0 && fmb_vec_equal(&m->ray[left - 1], &list[i].v, m->n);
        if (is_same) {
            unite_supports(m, m->support[left - 1], list[i].support);
            fmb_vec_clear(&list[i].v, m->n, mem);
            continue;
        }
        m->ray[left] = list[i].v;
        m->above[left] = list[i].above;
        m->support[left++] = list[i].support;
    }
    m->rays = st == FMB_OK ? left : rays;
    fmb_mem_put(mem, list, rays, sizeof *list);
    return st;
}

/* Add a ray to the image; one that is 0 there is above each of its points. */
static fmb_status add_ray_to_image(fmb_image *m, const fmb_vec *v, const uint64_t *support)
{
    if (is_zero_vector(v, m->n)) {
        unite_supports(m, m->everywhere, support);
        return FMB_OK;
    }
    uint64_t *own;
    FMB_TRY(FMB_ARENA_GET(&m->arena, own, m->words));
    memcpy(own, support, m->words * sizeof *own);
    m->support[m->rays] = own;
    m->above[m->rays] = m->of ? v : NULL;
    fmb_status st = fmb_image_copy_coordinates(m, &m->ray[m->rays], v);
    m->has_point |= st == FMB_OK && fmb_vec_sgn(&m->ray[m->rays], m->n - 1) > 0;
    fmb_run_count(m->run, 150 + fmb_vec_work(&m->ray[m->rays], m->n));
    m->rays++;
    return st == FMB_OK ? fmb_run_poll(m->run) : st;
}

static fmb_status add_line_to_image(fmb_image *m, const fmb_vec *v)
{
    m->line_above[m->lines] = m->of ? v : NULL;
    return is_zero_vector(v, m->n) ? FMB_OK
                                   : fmb_image_copy_coordinates(m, &m->line[m->lines++], v);
}

/* Memory for so many rays and lines; rays may become lines. */
static fmb_status open_image(fmb_image *m, fmb_run *run, size_t n, size_t words, size_t rays,
                             size_t lines, bool wide_only)
{
    lines += rays;
    *m = (fmb_image){.run = run, .n = n, .words = words};
    fmb_arena_init(&m->arena, run->mem);
    FMB_TRY(fmb_run_open_num(run, &m->num, n, wide_only));
    FMB_TRY(FMB_ARENA_GET(&m->arena, m->ray, rays));
    FMB_TRY(FMB_ARENA_GET(&m->arena, m->support, rays));
    FMB_TRY(FMB_ARENA_GET(&m->arena, m->above, rays));
    FMB_TRY(FMB_ARENA_GET(&m->arena, m->line, lines));
    FMB_TRY(FMB_ARENA_GET(&m->arena, m->line_above, lines));
    FMB_TRY(FMB_ARENA_GET(&m->arena, m->everywhere, words));
    memset(m->everywhere, 0, words * sizeof *m->everywhere);
    return FMB_OK;
}

fmb_status fmb_image_init(fmb_image *m, fmb_run *run, const fmb_cone *of, size_t n, bool wide_only)
{
    size_t rays = of->ray.size, lines = of->line.size;
    fmb_status st = open_image(m, run, n, of->ray.words, rays, lines, wide_only);
    m->of = of;
    for (size_t i = 0; st == FMB_OK && i < lines; i++)
        st = add_line_to_image(m, &of->line.v[i]);
    for (size_t i = 0; st == FMB_OK && i < rays; i++)
        st = add_ray_to_image(m, &of->ray.v[i], fmb_rays_support(&of->ray, i));
    return st == FMB_OK ? sort_rays_of_image(m) : st;
}

fmb_status fmb_image_init_vectors(fmb_image *m, fmb_run *run, size_t n, size_t vectors,
                                  const fmb_vec *v, const bool *line, bool wide_only)
{
    static const uint64_t none;
    FMB_TRY(open_image(m, run, n, 1, vectors, vectors, wide_only));
    for (size_t i = 0; i < vectors; i++)
        FMB_TRY(line[i] ? add_line_to_image(m, &v[i]) : add_ray_to_image(m, &v[i], &none));
    return sort_rays_of_image(m);
}

void fmb_image_clear(fmb_image *m)
{
    if (!m->run)
        return;
    fmb_mem *mem = m->run->mem;
    for (size_t i = 0; i < m->rays; i++)
        fmb_vec_clear(&m->ray[i], m->n, mem);
    for (size_t i = 0; i < m->lines; i++)
        fmb_vec_clear(&m->line[i], m->n, mem);
    for (size_t i = 0; i < m->facets; i++)
        fmb_vec_clear(&m->facet[i].v, m->n, mem);
    fmb_mem_put(mem, m->facet, m->facet_capacity, sizeof *m->facet);
    fmb_arena_clear(&m->arena);
    fmb_num_clear(&m->num);
    m->run = NULL;
}

/* ---- rows and rays --------------------------------------------------------------------------- */

static fmb_status find_residues_of_rays(fmb_image *m)
{
    m->residue = fmb_arena_get(&m->arena, m->rays + 1, m->n * sizeof *m->residue);
    for (size_t i = 0; m->residue && i < m->rays; i++)
        for (size_t k = 0; k < m->n; k++)
            m->residue[i * m->n + k] = fmb_residue_of_entry(&m->ray[i], k);
    return m->residue ? FMB_OK : fmb_mem_status(m->run->mem);
}

fmb_status fmb_image_find_zeros(fmb_image *m, const fmb_vec *row, uint64_t *zero)
{
    FMB_TRY(m->residue ? FMB_OK : find_residues_of_rays(m));
    uint32_t *of_row = m->residue + m->rays * m->n;
    for (size_t k = 0; k < m->n; k++)
        of_row[k] = fmb_residue_of_entry(row, k);
    for (size_t i = 0; i < m->rays; i++)
        if (fmb_residues_vanish(of_row, m->residue + i * m->n, m->n) &&
            fmb_image_value_sign(m, row, &m->ray[i]) == 0)
            fmb_set_put(zero, i);
    return fmb_run_poll(m->run);
}

int fmb_image_value_sign(fmb_image *m, const fmb_vec *row, const fmb_vec *ray)
{
    return fmb_vec_product_sign(row, ray, m->n, &m->num);
}
