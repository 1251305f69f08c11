/* support_symmetry.c: support queries, one of each orbit; see support.h.
 *
 * A symmetry of the program that keeps the kept columns maps the projection to itself: points to
 * points, rows to rows, and the proof of a row to one of its image (symmetry/group.h). So all
 * images of a point found are added, and a facet whose row is the image of a proved one stands
 * without a query. Images are proved like any other row: a checker need not know of symmetries.
 */
#include "hull/support/support_private.h"
#include "symmetry/orbits.h"

struct fmb_symmetry {
    fmb_group group;
    fmb_orbits points, rows; /* rows: normals of facets; tag: number in s->row, if it is there */
};

/* ---- points ---------------------------------------------------------------------------------- */

/* Add the images of a vector of the hull. */
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

fmb_status fmb_support_take_images(fmb_support *s)
{
    if (!s->symmetry)
        return FMB_OK;
    return take_images_of_point(s, &s->hull.generator[s->hull.generators - 1]);
}

/* ---- rows ------------------------------------------------------------------------------------ */

fmb_status fmb_support_note_images(fmb_support *s, const fmb_vec *normal)
{
    if (!s->symmetry)
        return FMB_OK;
    fmb_orbits *o = &s->symmetry->rows;
    fmb_status st = fmb_orbits_add(o, normal, s->rows - 1);
    if (st == FMB_OK) /* it may be there as an image of another row */
        o->item[fmb_orbits_find(o, normal)].tag = s->rows - 1;
    return st;
}

/* Write the row of an item from another one of its orbit, and keep it. */
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

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_support_use_symmetry(fmb_support *s, fmb_group *group)
{
    fmb_symmetry *y;
    FMB_TRY(FMB_GET_ZERO(s->run->mem, y, 1));
    s->symmetry = y;
    y->group = *group;
    *group = (fmb_group){0};
    FMB_TRY(fmb_orbits_init(&y->points, s->run, &y->group, s->kept, s->k));
    return fmb_orbits_init(&y->rows, s->run, &y->group, s->kept, s->k);
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
