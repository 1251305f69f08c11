/* section_rays.c: the result for a section as rays and lines of the cone; see section.h.
 *
 * A query may have found a point that is no vertex. A ray is extreme if and only if the rows that
 * are 0 on it have as their common zeros the lines of the cone and one dimension more.
 */
#include "hull/section/section.h"

/* ---- back to the cone ------------------------------------------------------------------------ */

/* The point (t, x) of the section, x / t, as a ray: z[d]. */
static void write_ray_above_point(fmb_section *c, const fmb_vec *v, mpz_t *z)
{
    mpz_ptr part = c->num.p, size = c->num.q;
    for (size_t j = 0; j < c->d; j++)
        mpz_set_ui(z[j], 0);
    fmb_vec_get(v, 0, z[c->gone]);
    mpz_abs(size, c->w.z[c->gone]);
    for (size_t k = 0; k + 1 < c->rank; k++) {
        size_t j = (size_t)c->column[k];
        fmb_vec_get(v, k + 1, part);
        mpz_submul(z[c->gone], part, c->w.z[j]);
        mpz_mul(z[j], part, size);
    }
    if (mpz_sgn(c->w.z[c->gone]) < 0)
        mpz_neg(z[c->gone], z[c->gone]);
}

/* A list of rays and lines being built. */
typedef struct ray_list {
    fmb_vec *v; /* [size] */
    bool *line;
    size_t size;
} ray_list;

static fmb_status put_ray_into_list(fmb_section *c, const fmb_vec *point, mpz_t *z, ray_list *to)
{
    fmb_vec *v = &to->v[to->size];
    *v = (fmb_vec){.s = fmb_arena_get(&c->arena, c->d, sizeof *v->s)};
    if (!v->s)
        return fmb_mem_status(c->run->mem);
    to->line[to->size++] = false;
    write_ray_above_point(c, point, z);
    return fmb_vec_set_z(v, c->d, z, c->run->mem);
}

/* If the cone has rank 1, its section is the point 1. */
static fmb_status put_all_rays_into_list(fmb_section *c, mpz_t *z, ray_list *to)
{
    const fmb_facets *f = &c->support.hull;
    const fmb_vec one = {.s = (int64_t[]){1}, .bits = 1};
    if (c->empty || c->rank == 0)
        return FMB_OK;
    if (!c->begun)
        return put_ray_into_list(c, &one, z, to);
    for (size_t g = 0; g < f->generators; g++)
        FMB_TRY(put_ray_into_list(c, &f->generator[g], z, to));
    return FMB_OK;
}

/* Find the lines on which all of n rows are 0. */
static fmb_status find_lines_of_rows(const fmb_section *c, fmb_cone *lines, fmb_cone_row *row,
                                     size_t n)
{
    bool done;
    fmb_cone_problem of = {.d = c->d, .m = n, .row = row};
    FMB_TRY(fmb_cone_init(lines, c->run, &of));
    return fmb_cone_run(lines, 0, &done);
}

/* Find the lines of the cone: they are 0 in the independent rows. */
static fmb_status find_lines_of_cone(const fmb_section *c, fmb_cone *lines, fmb_cone_row *row)
{
    for (size_t i = 0; i < c->rank; i++)
        row[i] = (fmb_cone_row){.v = &c->row[c->chosen[i]], .equality = true};
    return find_lines_of_rows(c, lines, row, c->rank);
}

/* ---- extreme rays ---------------------------------------------------------------------------- */

/* All rows are tested, whatever ended the queries. row[m] is scratch. */
static fmb_status is_ray_extreme(const fmb_section *c, fmb_image *image, const fmb_vec *ray,
                                 fmb_cone_row *row, bool *extreme)
{
    size_t n = 0;
    fmb_cone left = {0};
    *extreme = false;
    for (size_t i = 0; i < c->m; i++) {
        int sign = fmb_image_value_sign(image, &c->row[i], ray);
        if (sign < 0)
            return FMB_OK;
        if (sign == 0)
            row[n++] = (fmb_cone_row){.v = &c->row[i], .equality = true};
    }
    fmb_status st = find_lines_of_rows(c, &left, row, n);
    *extreme = left.line.size == c->d - c->rank + 1;
    fmb_cone_clear(&left);
    return st;
}

/* Remove rays that are not extreme. */
static fmb_status keep_extreme_rays(const fmb_section *c, fmb_image *image, fmb_cone_row *row)
{
    size_t kept = 0, i = 0;
    fmb_status st = FMB_OK;
    for (; st == FMB_OK && i < image->rays; i++) {
        bool extreme;
        st = fmb_run_poll(c->run);
        if (st != FMB_OK)
            break;
        st = is_ray_extreme(c, image, &image->ray[i], row, &extreme);
        if (st == FMB_OK && !extreme) {
            fmb_vec_clear(&image->ray[i], c->d, c->run->mem);
            continue;
        }
        image->support[kept] = image->support[i];
        image->ray[kept++] = image->ray[i];
    }
    for (; i < image->rays; i++)
        image->ray[kept++] = image->ray[i];
    image->rays = kept;
    return st;
}

static fmb_status take_rays_and_lines(fmb_section *c, const fmb_cone *lines, ray_list *all,
                                      fmb_image *image)
{
    mpz_t *z = fmb_vec_block(c->d, c->run->mem);
    if (!z)
        return fmb_mem_status(c->run->mem);
    fmb_status st = put_all_rays_into_list(c, z, all);
    size_t rays = all->size;
    for (size_t i = 0; i < lines->line.size; i++) {
        all->v[all->size] = lines->line.v[i];
        all->line[all->size++] = true;
    }
    FMB_THEN(st, fmb_image_init_vectors(image, c->run, c->d, all->size, all->v, all->line, false));
    for (size_t i = 0; i < rays; i++)
        fmb_vec_clear(&all->v[i], c->d, c->run->mem);
    fmb_vec_block_free(z, c->d, c->run->mem);
    return st;
}

fmb_status fmb_section_take_rays(fmb_section *c, fmb_image *image)
{
    fmb_mem *mem = c->run->mem;
    size_t most = c->d + 1 + (c->begun ? c->support.hull.generators : 0);
    fmb_cone lines = {0};
    size_t rows = c->m > c->d ? c->m : c->d;
    fmb_cone_row *row = fmb_mem_get(mem, rows, sizeof *row);
    ray_list all = {.v = fmb_mem_get(mem, most, sizeof *all.v),
                    .line = fmb_mem_get(mem, most, sizeof *all.line)};
    fmb_status st = row && all.v && all.line ? FMB_OK : fmb_mem_status(mem);
    FMB_THEN(st, find_lines_of_cone(c, &lines, row));
    FMB_THEN(st, take_rays_and_lines(c, &lines, &all, image));
    FMB_THEN(st, keep_extreme_rays(c, image, row));
    fmb_cone_clear(&lines);
    fmb_mem_put(mem, all.line, most, sizeof *all.line);
    fmb_mem_put(mem, all.v, most, sizeof *all.v);
    fmb_mem_put(mem, row, rows, sizeof *row);
    return st;
}
