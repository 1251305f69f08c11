/* permutations.c: lists of permutations of variables; see fmb/symmetry.h. */
#include "symmetry/group.h"

#include <stdio.h>
#include <string.h>

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_permutations_new(int dim, const fmb_alloc *hook, fmb_permutations **out)
{
    fmb_mem mem;
    if (dim < 0 || !out)
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, hook, 0);
    fmb_permutations *p;
    FMB_TRY(FMB_GET_ZERO(&mem, p, 1));
    p->mem = mem;
    p->dim = dim;
    *out = p;
    return FMB_OK;
}

void fmb_permutations_free(fmb_permutations *p)
{
    if (!p)
        return;
    for (size_t i = 0; i < p->size; i++)
        fmb_mem_put(&p->mem, p->image[i], (size_t)p->dim, sizeof **p->image);
    fmb_mem_put(&p->mem, p->image, p->capacity, sizeof *p->image);
    fmb_mem mem = p->mem;
    fmb_mem_put(&mem, p, 1, sizeof *p);
}

/* ---- one more -------------------------------------------------------------------------------- */

/* Are all images, where defined, distinct? met[n] becomes the set of these. */
static bool goes_to_places_of_its_own(const int *image, int n, bool *met)
{
    memset(met, 0, (size_t)n * sizeof *met);
    for (int j = 0; j < n; j++) {
        if (image[j] < 0)
            continue;
        if (image[j] >= n || met[image[j]])
            return false;
        met[image[j]] = true;
    }
    return true;
}

bool fmb_permutation_complete(int *image, int n, bool *met)
{
    if (!goes_to_places_of_its_own(image, n, met))
        return false;
    for (int j = 0; j < n; j++) {
        int end = j;
        if (image[j] < 0 || met[j])
            continue;
        while (image[end] >= 0)
            end = image[end];
        image[end] = j;
        met[j] = true;
    }
    for (int j = 0; j < n; j++)
        image[j] = image[j] < 0 ? j : image[j];
    return true;
}

static fmb_status append_permutation(fmb_permutations *p, const int *image)
{
    fmb_status st = FMB_RESERVE(&p->mem, &p->image, &p->capacity, p->size + 1);
    int *copy = st == FMB_OK ? fmb_mem_get(&p->mem, (size_t)p->dim, sizeof *copy) : NULL;
    if (!copy)
        return st == FMB_OK ? fmb_mem_status(&p->mem) : st;
    memcpy(copy, image, (size_t)p->dim * sizeof *copy);
    p->image[p->size++] = copy;
    return FMB_OK;
}

/* Report a variable whose image is no variable, or that of another one; FMB_OK if all images are
 * distinct. from[n]: the variable that has this image, initially -1. */
static fmb_status expect_permutation(fmb_permutations *p, const int *image, int *from)
{
    for (int j = 0; j < p->dim; j++)
        from[j] = -1;
    for (int j = 0; j < p->dim; j++) {
        int to = image[j];
        if (to < 0 || to >= p->dim)
            snprintf(p->error, sizeof p->error, "variable %d goes to %d, but there are %d", j, to,
                     p->dim);
        else if (from[to] >= 0)
            snprintf(p->error, sizeof p->error, "variables %d and %d both go to %d", from[to], j,
                     to);
        else
            from[to] = j;
        if (p->error[0])
            return FMB_ERR_ARG;
    }
    return FMB_OK;
}

fmb_status fmb_permutations_add(fmb_permutations *p, const int *image)
{
    if (!p)
        return FMB_ERR_ARG;
    p->error[0] = '\0';
    if (p->dim == 0)
        return FMB_OK; /* there are no variables to permute */
    if (!image) {
        snprintf(p->error, sizeof p->error, "image is NULL");
        return FMB_ERR_ARG;
    }
    int *from = fmb_mem_get(&p->mem, (size_t)p->dim, sizeof *from);
    if (!from)
        return FMB_ERR_MEMORY;
    fmb_status st = expect_permutation(p, image, from);
    fmb_mem_put(&p->mem, from, (size_t)p->dim, sizeof *from);
    return st == FMB_OK ? append_permutation(p, image) : st;
}

const char *fmb_permutations_trouble(const fmb_permutations *p)
{
    return p ? p->error : "";
}

/* ---- reading --------------------------------------------------------------------------------- */

int fmb_permutations_dim(const fmb_permutations *p)
{
    return p ? p->dim : 0;
}

size_t fmb_permutations_size(const fmb_permutations *p)
{
    return p ? p->size : 0;
}

int fmb_permutations_image(const fmb_permutations *p, size_t i, int j)
{
    return i < fmb_permutations_size(p) && j >= 0 && j < p->dim ? p->image[i][j] : -1;
}
