/* symmetries.c: see symmetries.h, and fmb/symmetry.h. */
#include "solve/portfolio/symmetries.h"

#include <string.h>

#include "base/arrays.h"
#include "symmetry/group.h"
#include "symmetry/row_images.h"
#include "system/system_private.h"

/* ---- given ----------------------------------------------------------------------------------- */

fmb_status fmb_solver_set_symmetries(fmb_solver *v, const fmb_permutations *p)
{
    fmb_permutations *copy = NULL;
    if (!v)
        return FMB_ERR_ARG;
    fmb_status st = p ? fmb_permutations_new(p->dim, &v->mem.alloc, &copy) : FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < fmb_permutations_size(p); i++)
        st = fmb_permutations_add(copy, p->image[i]);
    if (st != FMB_OK) {
        fmb_permutations_free(copy);
        return st;
    }
    fmb_permutations_free(v->symmetries);
    v->symmetries = copy;
    return FMB_OK;
}

/* The images of variables and rows under permutation g; ARG if it is no symmetry. */
static fmb_status move_all(fmb_solver *v, fmb_row_images *t, const int *place, size_t g,
                           uint32_t *moved)
{
    const int *image = v->symmetries->image[g];
    int dim = v->symmetries->dim;
    for (int j = 0; j < dim; j++) {
        moved[j] = (uint32_t)image[j];
        if ((place[j] < 0) != (place[image[j]] < 0))
            return fmb_solver_refuse(v, FMB_ERR_ARG,
                                     "permutation %zu takes variable %d to %d: only one is kept", g,
                                     j, image[j]);
    }
    for (size_t i = 0; i < fmb_system_rows(t->s); i++) {
        size_t found;
        fmb_status st = fmb_row_images_find(t, i, image, &found);
        if (st == FMB_OK && found == SIZE_MAX)
            st = fmb_solver_refuse(v, FMB_ERR_ARG,
                                   "permutation %zu is no symmetry: row %zu has no image", g, i);
        if (st != FMB_OK)
            return st;
        moved[(size_t)dim + i] = (uint32_t)found;
    }
    return FMB_OK;
}

fmb_status fmb_symmetries_enter(fmb_solver *v, const fmb_system *s, const int *place)
{
    fmb_row_images t;
    size_t length = (size_t)fmb_system_dim(s) + fmb_system_rows(s);
    size_t size = fmb_permutations_size(v->symmetries);
    if (!v->symmetries || v->options.symmetry == FMB_SYMMETRY_NONE)
        return FMB_OK;
    if (v->symmetries->dim != fmb_system_dim(s) && size > 0)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "symmetries of %d variables, but there are %d",
                                 v->symmetries->dim, fmb_system_dim(s));
    v->moved = fmb_mem_get(&v->mem, size * length, sizeof *v->moved);
    if (!v->moved)
        return FMB_ERR_MEMORY;
    fmb_status st = fmb_row_images_init(&t, s, &v->mem);
    for (size_t g = 0; st == FMB_OK && g < size; g++)
        st = move_all(v, &t, place, g, v->moved + g * length);
    fmb_row_images_clear(&t);
    return st;
}

void fmb_symmetries_leave(fmb_solver *v, const fmb_system *s)
{
    size_t length = (size_t)fmb_system_dim(s) + fmb_system_rows(s);
    fmb_mem_put(&v->mem, v->moved, fmb_permutations_size(v->symmetries) * length, sizeof *v->moved);
    v->moved = NULL;
}

/* ---- of a part ------------------------------------------------------------------------------- */

typedef struct part_images {
    fmb_query *q;
    const fmb_part *p;
    int part;
    bool *keeps;     /* [n] */
    uint32_t *image; /* [n + m] images under a symmetry, as columns and rows of the part */
    uint32_t *row;   /* [rows] the part's row for each row of the system; UINT32_MAX: none */
} part_images;

static fmb_status hold_part_images(part_images *x, bool get)
{
    const size_t n = (size_t)x->p->n;
    return FMB_ARRAYS(x->q->run.mem, get, FMB_ARRAY_ZERO(x->keeps, n),
                      FMB_ARRAY(x->image, n + x->p->m),
                      FMB_ARRAY(x->row, fmb_system_rows(x->q->s)));
}

static fmb_status open_part_images(part_images *x, const int *column, size_t k)
{
    size_t rows = fmb_system_rows(x->q->s);
    FMB_TRY(hold_part_images(x, true));
    for (size_t j = 0; j < k; j++)
        x->keeps[column[j]] = true;
    for (size_t i = 0; i < rows; i++)
        x->row[i] = UINT32_MAX;
    for (size_t i = 0; i < x->p->m; i++)
        x->row[x->p->source[i]] = (uint32_t)i;
    return FMB_OK;
}

/* Set x->image from moved[]; false if the symmetry leads out of the part. */
static bool is_moved_within_part(part_images *x, const uint32_t *moved)
{
    const fmb_parts *parts = &x->q->parts;
    size_t n = (size_t)x->p->n, dim = (size_t)fmb_system_dim(x->q->s);
    for (size_t j = 0; j < n; j++) {
        uint32_t to = moved[x->p->var[j]];
        if (parts->of_var[to] != x->part)
            return false;
        x->image[j] = (uint32_t)parts->place[to];
    }
    for (size_t i = 0; i < x->p->m; i++) {
        x->image[n + i] = x->row[moved[dim + x->p->source[i]]];
        if (x->image[n + i] == UINT32_MAX)
            return false;
    }
    return true;
}

/* Parallel or equal rows cannot be distinguished; fmb_group_add rejects a symmetry that would need
 * that. */
fmb_status fmb_symmetries_of_part(fmb_query *q, int part, const int *column, size_t k,
                                  fmb_group *out)
{
    part_images x = {.q = q, .p = &q->parts.part[part], .part = part};
    size_t length = (size_t)fmb_system_dim(q->s) + fmb_system_rows(q->s);
    bool fits;
    fmb_group_init(out, q->run.mem, (size_t)x.p->n, x.p->m);
    fmb_status st = open_part_images(&x, column, k);
    for (size_t g = 0; st == FMB_OK && g < q->v->symmetries->size; g++)
        if (is_moved_within_part(&x, q->v->moved + g * length))
            st = fmb_group_add(out, &q->program[part], x.keeps, x.image, &fits);
    (void)hold_part_images(&x, false);
    return st;
}

/* ---- found ----------------------------------------------------------------------------------- */

static fmb_status copy_group(const fmb_group *g, fmb_permutations *to)
{
    fmb_status st = FMB_OK;
    int *image;
    FMB_TRY(FMB_GET(&to->mem, image, g->n));
    for (size_t i = 0; st == FMB_OK && i < g->size; i++) {
        for (size_t j = 0; j < g->n; j++)
            image[j] = (int)g->image[i][j];
        st = fmb_permutations_add(to, image);
    }
    fmb_mem_put(&to->mem, image, g->n, sizeof *image);
    return st;
}

static fmb_status find_symmetries_of_all(fmb_query *q, const int *keep, int n, fmb_permutations *to)
{
    size_t dim = (size_t)fmb_system_dim(q->s);
    fmb_program p;
    fmb_group group;
    fmb_program_init(&p, q->run.mem, (int)dim);
    fmb_group_init(&group, q->run.mem, 0, 0);
    bool *keeps = fmb_mem_zero(q->run.mem, dim, sizeof *keeps);
    fmb_status st = keeps ? FMB_OK : fmb_mem_status(q->run.mem);
    for (int i = 0; st == FMB_OK && i < n; i++)
        keeps[keep[i]] = true;
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(q->s); i++) {
        const fmb_sysrow *r = fmb_system_row(q->s, i);
        st = fmb_program_add(&p, r->nnz, r->var, NULL, &r->val, r->rel);
    }
    FMB_THEN(st, fmb_symmetry_find(&q->run, &p, keeps, &group));
    FMB_THEN(st, copy_group(&group, to));
    fmb_group_clear(&group);
    fmb_mem_put(q->run.mem, keeps, dim, sizeof *keeps);
    fmb_program_clear(&p);
    return st;
}

fmb_status fmb_symmetries_find(fmb_solver *v, const fmb_system *s, const int *keep, int n,
                               fmb_permutations **out, fmb_result *res)
{
    fmb_query q;
    fmb_permutations *found = NULL;
    fmb_status st = fmb_solver_expect(v, s, out != NULL, res);
    if (st == FMB_OK && !keep && n > 0)
        st = fmb_solver_refuse(v, FMB_ERR_ARG, "keep is NULL, but n is %d", n);
    FMB_THEN(st, fmb_solver_expect_variables(v, s, "keep", keep, n));
    if (st != FMB_OK)
        return st;
    st = fmb_query_begin(&q, v, s, "symmetries");
    fmb_status opened = fmb_permutations_new(fmb_system_dim(s), &v->mem.alloc, &found);
    if (st == FMB_OK || st == FMB_LIMIT)
        st = opened == FMB_OK ? st : opened;
    FMB_THEN(st, find_symmetries_of_all(&q, keep, n, found));
    bool done = st == FMB_OK;
    st = fmb_query_end(&q, st, FMB_UNKNOWN, res);
    if (v)
        v->answered = false;
    if (st == FMB_OK)
        *out = done ? found : NULL;
    if (st != FMB_OK || !done)
        fmb_permutations_free(found);
    return st;
}

/* ---- classes --------------------------------------------------------------------------------- */

/* Restrict permutation i to the kept variables, as image[n]; false if one has an image that is not
 * kept. place[dim of p]: -1 if not kept. */
static bool restrict_to_kept(const fmb_permutations *p, size_t i, const int *keep, int n,
                             const int *place, int *image)
{
    bool kept = true;
    for (int j = 0; kept && j < n; j++) {
        image[j] = place[p->image[i][keep[j]]];
        kept = image[j] >= 0;
    }
    return kept;
}

static fmb_status class_rows(fmb_row_images *t, const fmb_permutations *p, const int *keep, int n,
                             int *place, int *image, size_t *class_of)
{
    fmb_status st = FMB_OK;
    for (int j = 0; j < p->dim; j++)
        place[j] = -1;
    for (int j = 0; j < n; j++)
        place[keep[j]] = j;
    for (size_t i = 0; st == FMB_OK && i < p->size; i++)
        st = restrict_to_kept(p, i, keep, n, place, image)
                 ? fmb_row_images_classes(t, image, class_of)
                 : FMB_ERR_ARG;
    return st;
}

static bool are_class_arguments_good(const fmb_system *projection, const fmb_permutations *p,
                                     const int *keep, int n, const size_t *class_of)
{
    bool good = projection && p && n >= 0 && (keep || n == 0) && class_of &&
                fmb_system_dim(projection) == n;
    for (int j = 0; good && j < n; j++)
        good = keep[j] >= 0 && keep[j] < p->dim;
    return good;
}

fmb_status fmb_rows_classes(const fmb_system *projection, const fmb_permutations *p,
                            const int *keep, int n, size_t *class_of)
{
    fmb_mem mem;
    fmb_row_images t;
    if (!are_class_arguments_good(projection, p, keep, n, class_of))
        return FMB_ERR_ARG;
    size_t dim = (size_t)p->dim, m = fmb_system_rows(projection);
    fmb_mem_init(&mem, &projection->mem.alloc, 0);
    int *place = NULL, *image = NULL;
    size_t *found = NULL;
    const fmb_array arrays[] = {FMB_ARRAY(place, dim), FMB_ARRAY(image, (size_t)n),
                                FMB_ARRAY(found, m)};
    fmb_status st = fmb_row_images_init(&t, projection, &mem);
    FMB_THEN(st, fmb_arrays(&mem, true, FMB_ALL(arrays)));
    for (size_t i = 0; st == FMB_OK && i < m; i++)
        found[i] = i;
    FMB_THEN(st, class_rows(&t, p, keep, n, place, image, found));
    if (st == FMB_OK && m > 0)
        memcpy(class_of, found, m * sizeof *found);
    fmb_row_images_clear(&t);
    (void)fmb_arrays(&mem, false, FMB_ALL(arrays));
    return st;
}
