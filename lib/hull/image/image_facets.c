/* image_facets.c: the rows of an image; see image.h.
 *
 * They are the facets of the cone of its rays and lines. In few coordinates many rays are added one
 * after another to the facets so far (facets.h), the farthest ones first. Else the facets are the
 * rays of the dual cone, whose rows are the rays of the image in lexicographic order.
 */
#include <string.h>

#include "hull/facets/facets.h"
#include "hull/image/image.h"

/* With more coordinates, rays often are on very many facets. */
#define FEW_COORDINATES 7
/* Facets with so many bits by Hadamard's inequality mostly do not fit into 62 bits (measured).
 */
#define LONG_BITS 72
/* With fewer rays per coordinate than this, facets are cheaper as rays of the dual cone: up to
 * three times if numbers are short, which gain nothing from doubles (measured). */
#define MANY_RAYS      12
#define MANY_LONG_RAYS 5

/* ---- the preimage of a facet ----------------------------------------------------------------- */

static void add_to_slack(fmb_image *m, uint64_t *to, const uint64_t *from)
{
    for (size_t k = 0; k < m->words; k++)
        to[k] |= from[k];
}

/* Unite the supports above the facet, which still has the form y.(x, t) >= 0. */
static fmb_status look_above_facet(fmb_image *m, fmb_image_row *f)
{
    size_t words = fmb_set_words(m->rays);
    FMB_TRY(FMB_ARENA_GET(&m->arena, f->slack, m->words));
    FMB_TRY(FMB_ARENA_GET(&m->arena, f->on, words));
    memcpy(f->slack, m->everywhere, m->words * sizeof *f->slack);
    memset(f->on, 0, words * sizeof *f->on);
    FMB_TRY(fmb_image_find_zeros(m, &f->v, f->on));
    for (size_t i = 0; i < m->rays; i++)
        if (fmb_set_has(f->on, i))
            add_to_slack(m, f->slack, m->support[i]);
    return FMB_OK;
}

fmb_status fmb_image_add_facet(fmb_image *m, const fmb_vec *y, bool equality, bool slacks)
{
    FMB_TRY(FMB_RESERVE(m->run->mem, &m->facet, &m->facet_capacity, m->facets + 1));
    fmb_image_row *f = &m->facet[m->facets++];
    *f = (fmb_image_row){.equality = equality};
    fmb_status st = fmb_image_copy_coordinates(m, &f->v, y);
    if (st != FMB_OK)
        return st;
    if (slacks)
        st = look_above_facet(m, f);
    fmb_vec_negate(&f->v, m->n - 1);
    return st;
}

/* ---- ray by ray ------------------------------------------------------------------------------ */

/* Add each line as two opposite rays. */
static fmb_status add_lines_to_facets(const fmb_image *m, fmb_facets *f)
{
    bool grown;
    fmb_status st = FMB_OK;
    mpz_t *z = fmb_vec_block(m->n, f->num.mem);
    if (!z)
        return fmb_mem_status(f->num.mem);
    for (size_t i = 0; st == FMB_OK && i < 2 * m->lines; i++) {
        for (size_t k = 0; k < m->n; k++) {
            fmb_vec_get(&m->line[i / 2], k, z[k]);
            if (i % 2 == 0)
                mpz_neg(z[k], z[k]);
        }
        st = fmb_facets_add(f, z, &grown);
    }
    fmb_vec_block_free(z, m->n, f->num.mem);
    return st;
}

/* Is a point on the facet, or is it the face at infinity? Its generators span it. */
static bool holds_facet_a_point(const fmb_facets *f, const fmb_facet *a)
{
    for (size_t i = 0; i < f->generators; i++)
        if (fmb_facet_holds(a, i) && fmb_vec_sgn(&f->generator[i], f->d - 1) > 0)
            return true;
    return false;
}

static fmb_status take_facets(fmb_image *m, fmb_facets *f, bool slacks)
{
    for (size_t e = 0; e < m->n - f->rank; e++)
        FMB_TRY(fmb_image_add_facet(m, &f->equation[e], true, slacks));
    FMB_TRY(fmb_facets_need_all_normals(f));
    for (size_t i = 0; i < f->slots; i++)
        if (f->facet[i].alive && holds_facet_a_point(f, &f->facet[i]))
            FMB_TRY(fmb_image_add_facet(m, &f->facet[i].normal, false, slacks));
    return FMB_OK;
}

/* The facets of the cone of rays and lines. Call fmb_facets_clear even after an error. */
static fmb_status add_vectors_to_facets(const fmb_image *m, fmb_facets *f)
{
    FMB_TRY(fmb_facets_init(f, m->run, m->n));
    FMB_TRY(add_lines_to_facets(m, f));
    return fmb_facets_add_all(f, m->ray, m->rays, m->n - 1);
}

fmb_status fmb_image_hull_open(fmb_image_hull *h, fmb_image *m)
{
    *h = (fmb_image_hull){.of = m};
    FMB_TRY(fmb_facets_init(&h->facets, m->run, m->n));
    FMB_TRY(add_lines_to_facets(m, &h->facets));
    return fmb_facet_crowd_open(&h->facets, m->ray, m->rays, m->n - 1, &h->crowd);
}

fmb_status fmb_image_hull_find_facets(fmb_image_hull *h, bool slacks, bool *done)
{
    FMB_TRY(fmb_facet_crowd_go_on(h->crowd, done));
    return *done ? take_facets(h->of, &h->facets, slacks) : FMB_OK;
}

void fmb_image_hull_close(fmb_image_hull *h)
{
    if (!h->of)
        return;
    fmb_facet_crowd_close(h->crowd);
    fmb_facets_clear(&h->facets);
    h->of = NULL;
}

static fmb_status find_facets_ray_by_ray(fmb_image *m, bool slacks)
{
    fmb_image_hull h;
    bool done = false;
    fmb_status st = fmb_image_hull_open(&h, m);
    while (st == FMB_OK && !done)
        st = fmb_image_hull_find_facets(&h, slacks, &done);
    fmb_image_hull_close(&h);
    return st;
}

/* v[] and line[] have memory for all facets and equations. */
static fmb_status list_facets(fmb_facets *f, fmb_vec *v, bool *line, size_t *size)
{
    fmb_status st = fmb_facets_need_all_normals(f);
    for (size_t e = 0; e < f->d - f->rank; e++, ++*size) {
        v[*size] = f->equation[e];
        line[*size] = true;
    }
    for (size_t i = 0; st == FMB_OK && i < f->slots; i++) {
        if (!f->facet[i].alive)
            continue;
        v[*size] = f->facet[i].normal;
        line[(*size)++] = false;
    }
    return st;
}

fmb_status fmb_image_init_dual(fmb_image *m, const fmb_image *of)
{
    fmb_mem *mem = of->run->mem;
    fmb_facets f;
    size_t size = 0;
    fmb_status st = add_vectors_to_facets(of, &f);
    size_t most = st == FMB_OK ? f.slots + f.d : 0;
    fmb_vec *v = fmb_mem_get(mem, most, sizeof *v);
    bool *line = fmb_mem_get(mem, most, sizeof *line);
    if (st == FMB_OK && (!v || !line))
        st = fmb_mem_status(mem);
    FMB_THEN(st, list_facets(&f, v, line, &size));
    FMB_THEN(st, fmb_image_init_vectors(m, of->run, of->n, size, v, line, of->num.wide_only));
    fmb_mem_put(mem, line, most, sizeof *line);
    fmb_mem_put(mem, v, most, sizeof *v);
    fmb_facets_clear(&f);
    return st;
}

/* ---- all at once ----------------------------------------------------------------------------- */

/* The same for a ray of the dual cone: rows left out of supports are implied by others. */
static bool holds_dual_ray_a_point(const fmb_image *m, const fmb_cone *dual, size_t i)
{
    for (size_t b = 0; b < dual->bits; b++)
        if (!fmb_cone_is_positive(dual, i, b) &&
            fmb_vec_sgn(dual->of.row[dual->row_of_bit[b]].v, m->n - 1) > 0)
            return true;
    return false;
}

/* The same for a ray without known zeros. */
static bool holds_row_a_point(fmb_image *m, const fmb_vec *y)
{
    for (size_t i = 0; i < m->rays; i++)
        if (fmb_vec_sgn(&m->ray[i], m->n - 1) > 0 && fmb_image_value_sign(m, y, &m->ray[i]) == 0)
            return true;
    return false;
}

static fmb_status take_facets_of_dual(fmb_image *m, const fmb_cone *dual, bool slacks)
{
    for (size_t i = 0; i < dual->line.size; i++)
        FMB_TRY(fmb_image_add_facet(m, &dual->line.v[i], true, slacks));
    for (size_t i = 0; i < dual->ray.size; i++)
        if (holds_dual_ray_a_point(m, dual, i))
            FMB_TRY(fmb_image_add_facet(m, &dual->ray.v[i], false, slacks));
    return FMB_OK;
}

fmb_status fmb_dual_open(fmb_dual *d, fmb_image *m, bool sparse_first)
{
    fmb_mem *mem = m->run->mem;
    *d = (fmb_dual){.of = m, .rows = m->lines + m->rays};
    d->row = fmb_mem_get(mem, d->rows, sizeof *d->row);
    d->all = fmb_mem_get(mem, m->n, sizeof *d->all);
    if (!d->row || !d->all)
        return fmb_mem_status(mem);
    for (size_t i = 0; i < d->rows; i++)
        d->row[i] = i < m->lines ? (fmb_cone_row){.v = &m->line[i], .equality = true}
                                 : (fmb_cone_row){.v = &m->ray[i - m->lines]};
    for (size_t k = 0; k < m->n; k++)
        d->all[k] = k;
    fmb_cone_problem of = {.d = m->n, .m = d->rows, .row = d->row, .wide_only = m->num.wide_only};
    if (sparse_first) {
        of.keep = d->all;
        of.keeps = m->n;
        of.sparse_first = true;
    }
    return fmb_cone_init(&d->cone, m->run, &of);
}

void fmb_dual_close(fmb_dual *d)
{
    if (!d->of)
        return;
    fmb_mem *mem = d->of->run->mem;
    fmb_cone_clear(&d->cone);
    fmb_mem_put(mem, d->all, d->of->n, sizeof *d->all);
    fmb_mem_put(mem, d->row, d->rows, sizeof *d->row);
    *d = (fmb_dual){0};
}

fmb_status fmb_dual_find_facets(fmb_dual *d, uint64_t rays, bool slacks, bool *done)
{
    FMB_TRY(fmb_cone_run(&d->cone, rays, done));
    return *done ? take_facets_of_dual(d->of, &d->cone, slacks) : FMB_OK;
}

static fmb_status find_facets_as_dual_rays(fmb_image *m, bool slacks)
{
    fmb_dual d;
    bool done;
    fmb_status st = fmb_dual_open(&d, m, false);
    FMB_THEN(st, fmb_dual_find_facets(&d, 0, slacks, &done));
    fmb_dual_close(&d);
    return st;
}

static bool are_rays_many(const fmb_image *m)
{
    if (m->rays >= MANY_RAYS * m->n)
        return true;
    return m->rays >= MANY_LONG_RAYS * m->n &&
           fmb_vec_minor_bits(m->ray, m->rays, m->n) > LONG_BITS;
}

bool fmb_image_has_few_coordinates(const fmb_image *m)
{
    return m->n <= FEW_COORDINATES && are_rays_many(m);
}

fmb_status fmb_image_find_facets(fmb_image *m, bool slacks)
{
    return fmb_image_has_few_coordinates(m) ? find_facets_ray_by_ray(m, slacks)
                                            : find_facets_as_dual_rays(m, slacks);
}

fmb_status fmb_image_take_facets(fmb_image *m, const fmb_image *dual)
{
    for (size_t i = 0; i < dual->lines; i++)
        FMB_TRY(fmb_image_add_facet(m, &dual->line[i], true, false));
    for (size_t i = 0; i < dual->rays; i++)
        if (holds_row_a_point(m, &dual->ray[i]))
            FMB_TRY(fmb_image_add_facet(m, &dual->ray[i], false, false));
    return FMB_OK;
}
