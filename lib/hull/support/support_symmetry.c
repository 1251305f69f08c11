/* support_symmetry.c: support queries, one of each orbit; see support.h.
 *
 * A symmetry of the program that keeps the kept columns takes the projection to itself: points to
 * points, rows to rows, and what proves a row to what proves its image (symmetry/group.h). So all
 * images of a point that was found are taken in, and a facet whose row is the image of one that is
 * proved stands without a query. Images are proved like any other row: who checks them need not
 * know of symmetries. Symmetries are looked for when a few queries have not been enough.
 */
#include "hull/support/support_private.h"
#include "symmetry/orbits.h"

struct fmb_symmetry {
    fmb_group group;
    fmb_orbits points, rows; /* rows: normals of facets; tag: number in s->row, if it is there */
};

/* ---- points ---------------------------------------------------------------------------------- */

/* The images of a vector of the hull. */
static fmb_status take_images_of_point(fmb_support *s, const fmb_vec *v)
{
    fmb_orbits *o = &s->symmetry->points;
    size_t first = o->size;
    bool grown;
    FMB_TRY(fmb_orbits_add(o, v, 0));
    for (size_t i = first + 1; i < o->size; i++)
        FMB_TRY(fmb_facets_add_vec(&s->hull, &o->item[i].v, &grown));
    return FMB_OK;
}

bool fmb_support_is_symmetric(const fmb_support *s)
{
    return s->symmetry && s->symmetry->group.size > 0;
}

fmb_status fmb_support_take_images(fmb_support *s)
{
    if (!fmb_support_is_symmetric(s))
        return FMB_OK;
    return take_images_of_point(s, &s->hull.generator[s->hull.generators - 1]);
}

/* ---- rows ------------------------------------------------------------------------------------ */

fmb_status fmb_support_note_images(fmb_support *s, const fmb_vec *normal)
{
    if (!fmb_support_is_symmetric(s))
        return FMB_OK;
    fmb_orbits *o = &s->symmetry->rows;
    fmb_status st = fmb_orbits_add(o, normal, s->rows - 1);
    if (st == FMB_OK) /* an image of another one may have been asked about beside it */
        o->item[fmb_orbits_find(o, normal)].tag = s->rows - 1;
    return st;
}

/* The row of an item, from another one of its orbit; it is kept. */
static fmb_status keep_moved_row(fmb_support *s, size_t item)
{
    fmb_orbits *o = &s->symmetry->rows;
    const fmb_support_row *root = &s->row[o->item[fmb_orbits_root(o, item)].tag];
    fmb_support_row row = {.rel = root->rel};
    fmb_status st = fmb_support_write_row(s, &o->item[item].v, &row, s->run->mem);
    FMB_THEN(st, fmb_orbits_move_weights(o, item, &root->proof, &row.proof));
    if (st != FMB_OK) {
        fmb_support_drop(&row, s->run->mem);
        return st;
    }
    o->item[item].tag = s->rows;
    return fmb_support_keep(s, &row);
}

fmb_status fmb_support_recall(fmb_support *s, size_t facet, bool *known)
{
    fmb_facet *a = &s->hull.facet[facet];
    size_t item = s->symmetry ? fmb_orbits_find(&s->symmetry->rows, &a->normal) : SIZE_MAX;
    *known = item != SIZE_MAX;
    if (!*known)
        return FMB_OK;
    if (s->symmetry->rows.item[item].tag == SIZE_MAX)
        FMB_TRY(keep_moved_row(s, item));
    fmb_support_note_facet(s, facet, s->row[s->symmetry->rows.item[item].tag].rel);
    return FMB_OK;
}

fmb_status fmb_support_keep_images(fmb_support *s)
{
    for (size_t i = 0; s->symmetry && i < s->symmetry->rows.size; i++)
        if (s->symmetry->rows.item[i].tag == SIZE_MAX)
            FMB_TRY(keep_moved_row(s, i));
    return FMB_OK;
}

/* ---- the search ------------------------------------------------------------------------------ */

/* Those that were given, which go over to here; or those that are found. */
static fmb_status find_group(fmb_support *s)
{
    if (s->given) {
        s->symmetry->group = *s->given;
        *s->given = (fmb_group){0};
        return FMB_OK;
    }
    bool *keeps;
    FMB_TRY(FMB_GET_ZERO(s->run->mem, keeps, s->n));
    for (size_t j = 0; j < s->k; j++)
        keeps[s->kept[j]] = true;
    fmb_status st = fmb_symmetry_find(s->run, s->program, keeps, &s->symmetry->group);
    fmb_mem_put(s->run->mem, keeps, s->n, sizeof *keeps);
    return st;
}

/* The generators that the hull has. */
static fmb_status take_images_of_all_points(fmb_support *s)
{
    size_t size = s->hull.generators;
    for (size_t i = 0; i < size; i++)
        FMB_TRY(take_images_of_point(s, &s->hull.generator[i]));
    return FMB_OK;
}

/* The facets that stand; row i is no equality, and a.x <= b has the normal (b, -a). */
static fmb_status note_images_of_row(fmb_support *s, size_t i, fmb_vec *normal)
{
    const fmb_support_row *r = &s->row[i];
    mpz_set(s->g.z[0], r->z.z[s->k]);
    for (size_t j = 0; j < s->k; j++)
        mpz_neg(s->g.z[j + 1], r->z.z[j]);
    FMB_TRY(fmb_vec_set_z(normal, s->k + 1, s->g.z, s->run->mem));
    return fmb_orbits_add(&s->symmetry->rows, normal, i);
}

static fmb_status note_images_of_all_rows(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    fmb_vec normal = {.s = fmb_mem_get(mem, s->k + 1, sizeof *normal.s)};
    fmb_status st = normal.s ? FMB_OK : fmb_mem_status(mem);
    for (size_t i = 0; st == FMB_OK && i < s->rows; i++)
        if (s->row[i].rel != FMB_EQ)
            st = note_images_of_row(s, i, &normal);
    fmb_vec_clear(&normal, s->k + 1, mem);
    fmb_mem_put(mem, normal.s, s->k + 1, sizeof *normal.s);
    return st;
}

fmb_status fmb_support_find_symmetry(fmb_support *s)
{
    fmb_symmetry *y;
    FMB_TRY(FMB_GET_ZERO(s->run->mem, y, 1));
    s->symmetry = y;
    FMB_TRY(find_group(s));
    if (y->group.size == 0)
        return FMB_OK;
    FMB_TRY(fmb_orbits_init(&y->points, s->run, &y->group, s->kept, s->k));
    FMB_TRY(fmb_orbits_init(&y->rows, s->run, &y->group, s->kept, s->k));
    FMB_TRY(note_images_of_all_rows(s));
    return take_images_of_all_points(s);
}

void fmb_support_forget_symmetry(fmb_support *s)
{
    fmb_symmetry *y = s->symmetry;
    if (!y)
        return;
    fmb_orbits_clear(&y->points);
    fmb_orbits_clear(&y->rows);
    fmb_group_clear(&y->group);
    fmb_mem_put(s->run->mem, y, 1, sizeof *y);
    s->symmetry = NULL;
}
