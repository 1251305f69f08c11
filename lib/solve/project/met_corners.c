/* met_corners.c: see met_corners.h. */
#include "solve/project/met_corners.h"

#include "solve/query/lifted.h"

/* Are all kept variables in q->met.part? Others are free, or corners are products over parts. */
static bool holds_part_all_kept(const fmb_query *q, const int *place)
{
    bool all = q->met.size > 0;
    for (int j = 0; all && j < fmb_system_dim(q->s); j++)
        all = place[j] < 0 || q->parts.of_var[j] == q->met.part;
    return all;
}

/* Put the met points into m. */
static fmb_status list_met_vectors(fmb_query *q, fmb_image *m)
{
    const fmb_met_points *met = &q->met;
    fmb_mem *mem = q->run.mem;
    fmb_vec *v = fmb_mem_get(mem, met->size, sizeof *v);
    bool *line = fmb_mem_zero(mem, met->size, sizeof *line);
    fmb_status st = v && line ? FMB_OK : fmb_mem_status(mem);
    for (size_t i = 0; st == FMB_OK && i < met->size; i++)
        v[i] = met->point[i].y;
    FMB_THEN(st, fmb_image_init_vectors(m, &q->run, met->width, met->size, v, line,
                                        fmb_query_is_wide(q)));
    fmb_mem_put(mem, v, met->size, sizeof *v);
    fmb_mem_put(mem, line, met->size, sizeof *line);
    return st;
}

static fmb_status add_row_to_image(fmb_query *q, const fmb_sysrow *r, fmb_image *m)
{
    fmb_mem *mem = q->run.mem;
    mpz_t *z = fmb_vec_block(m->n, mem);
    fmb_vec form = {.s = fmb_mem_get(mem, m->n, sizeof *form.s)};
    fmb_status st = z && form.s ? FMB_OK : fmb_mem_status(mem);
    if (st == FMB_OK) {
        fmb_lifted_write_form(r, m->n, z);
        st = fmb_vec_set_z(&form, m->n, z, mem);
    }
    FMB_THEN(st, fmb_image_add_facet(m, &form, r->rel == FMB_EQ, true));
    fmb_vec_block_free(z, m->n, mem);
    if (form.s)
        fmb_vec_clear(&form, m->n, mem);
    fmb_mem_put(mem, form.s, m->n, sizeof *form.s);
    return st;
}

fmb_status fmb_met_corners(fmb_query *q, const int *place, const fmb_system *image, fmb_image *m,
                           bool *found)
{
    *found = holds_part_all_kept(q, place);
    if (!*found) {
        fmb_met_points_clear(&q->met);
        return FMB_OK;
    }
    fmb_status st = list_met_vectors(q, m);
    for (size_t i = 0; st == FMB_OK && i < image->rows; i++)
        st = add_row_to_image(q, &image->row[i], m);
    FMB_THEN(st, fmb_image_keep_corners(m));
    *found = m->rays > 0;
    return st;
}
