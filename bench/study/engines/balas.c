/* balas.c: Balas' projection: a cone whose extreme rays are the facets of the image.
 *
 * Block elimination gives rows v x <= c, redundant ones among them. Balas changes coordinates so
 * that (v, v0) are coordinates of the cone itself, and looks at its image {(v, v0)}: a row is a
 * facet if (v, v0) is an extreme ray of that. With v0 = c, as printed, this is wrong: of x <= 1 and
 * x <= 2 both are extreme rays, (1, 1) and (1, 2). v0 >= c mends it: (0, 1) is a ray then, and (1,
 * 2) = (1, 1) + (0, 1). This was found by Jing, Moreno Maza and Talaashrafi. As printed the rows
 * describe the image, but may not be minimal.
 *
 * If the image has full dimension the cone of all (v, v0) is pointed: if v x <= c and its reverse
 * were in it, v x = c would hold. A ray is extreme if no other ray lies on all facets that contain
 * it; the facets come from the hull of the rays. Source: Balas 1998, Projection with a minimal
 * system of inequalities; Jing and others 2020.
 *
 * A number to check: of x + y <= 1, y - x <= 1, y <= 2 without x: 2 rows as printed, 1 mended.
 */
#include "study/engines/engines.h"

#include <fmb/gmp.h>
#include <stdlib.h>

/* The dense entries of row i, its right side last. */
static void read_row(const fmb_system *s, size_t i, mpq_t *x, mpq_t a)
{
    int n = fmb_system_dim(s);
    for (int j = 0; j < n; j++)
        mpq_set_ui(x[j], 0, 1);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int j = fmb_system_term_q(s, i, k, a);
        mpq_set(x[j], a);
    }
    fmb_system_rhs_q(s, i, x[n]);
}

/* The apex, the rows as rays (v, v0), and last (0, 1) for the mended cone. */
static fmb_status add_rays(const fmb_system *s, study_balas how, mpq_t *x, fmb_generators *g)
{
    size_t rows = fmb_system_rows(s);
    int n = fmb_system_dim(s);
    fmb_status st = fmb_generators_add_q(g, FMB_VERTEX, x); /* all 0 */
    for (size_t i = 0; st == FMB_OK && i < rows; i++) {
        read_row(s, i, x, x[n + 1]);
        st = fmb_generators_add_q(g, FMB_RAY, x);
    }
    for (int j = 0; j <= n; j++)
        mpq_set_ui(x[j], j == n, 1);
    return st == FMB_OK && how == STUDY_BALAS_MENDED ? fmb_generators_add_q(g, FMB_RAY, x) : st;
}

/* The sign of facet f at generator i: 0 if i lies on f. */
static int measure(const fmb_system *faces, size_t f, const fmb_generators *g, size_t i, mpq_t *x)
{
    mpq_t *sum = x, *a = x + 1, *c = x + 2;
    mpq_set_ui(*sum, 0, 1);
    for (size_t k = 0; k < fmb_system_terms(faces, f); k++) {
        int j = fmb_system_term_q(faces, f, k, *a);
        fmb_generators_coordinate_q(g, i, j, *c);
        mpq_mul(*a, *a, *c);
        mpq_add(*sum, *sum, *a);
    }
    return mpq_sgn(*sum);
}

/* Does generator k lie on all facets that contain i? */
static bool lies_with(const bool *on, size_t faces, size_t i, size_t k)
{
    for (size_t f = 0; f < faces; f++)
        if (on[i * faces + f] && !on[k * faces + f])
            return false;
    return true;
}

/* The rows of s whose rays are extreme, each once. Generator 0 is the apex, row i generator i + 1.
 */
static fmb_status keep_extreme(const fmb_system *s, const fmb_generators *g, const bool *on,
                               size_t faces, mpq_t *x, fmb_system *out)
{
    size_t rays = fmb_generators_size(g) - 1;
    int n = fmb_system_dim(s);
    bool *gone = calloc(rays + 1, sizeof *gone);
    int *var = calloc((size_t)n + 1, sizeof *var);
    fmb_status st = gone && var ? FMB_OK : FMB_ERR_MEMORY;
    for (int j = 0; st == FMB_OK && j < n; j++)
        var[j] = j;
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++) {
        for (size_t k = 0; k < rays; k++)
            if (k != i && !gone[k] && lies_with(on, faces, i + 1, k + 1))
                gone[i] = true;
        read_row(s, i, x, x[n + 1]);
        if (!gone[i])
            st = fmb_system_add_q(out, (size_t)n, var, x, FMB_LE, x[n]);
    }
    free(var);
    free(gone);
    return st;
}

/* on: which generators lie on which facets, none of them an equation; false: not pointed. */
static bool find_faces(const fmb_system *faces, const fmb_generators *g, mpq_t *x, bool *on)
{
    size_t n = fmb_system_rows(faces), most = 0;
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        for (size_t f = 0; f < n; f++)
            on[i * n + f] = measure(faces, f, g, i, x) == 0;
    for (size_t i = 1; i < fmb_generators_size(g); i++) {
        size_t count = 0;
        for (size_t f = 0; f < n; f++)
            count += on[i * n + f];
        most = count > most ? count : most;
    }
    return most < n; /* a ray on all faces has its opposite in the cone */
}

static fmb_status reduce(const fmb_system *s, study_balas how, mpq_t *x, fmb_system **out)
{
    fmb_result res = {.size = sizeof res};
    fmb_generators *g = NULL;
    fmb_solver *v = NULL;
    fmb_system *faces = NULL, *image = NULL;
    bool *on = NULL;
    fmb_status st = fmb_generators_new(fmb_system_dim(s) + 1, NULL, &g);
    if (st == FMB_OK)
        st = add_rays(s, how, x, g);
    if (st == FMB_OK)
        st = fmb_solver_new(NULL, NULL, &v);
    if (st == FMB_OK)
        st = fmb_hull(v, g, &faces, &res);
    if (st == FMB_OK)
        on = calloc(fmb_generators_size(g) * fmb_system_rows(faces) + 1, sizeof *on);
    if (st == FMB_OK && !on)
        st = FMB_ERR_MEMORY;
    if (st == FMB_OK && find_faces(faces, g, x, on)) {
        st = fmb_system_new(fmb_system_dim(s), NULL, &image);
        if (st == FMB_OK)
            st = keep_extreme(s, g, on, fmb_system_rows(faces), x, image);
    }
    if (st == FMB_OK)
        *out = image;
    else
        fmb_system_free(image);
    free(on);
    fmb_system_free(faces);
    fmb_solver_free(v);
    fmb_generators_free(g);
    return st;
}

/* Rows of block elimination without 0 <= 0 and 0 <= positive: the ray (0, 1) replaces these, or is
 * not used. */
static fmb_status copy_rows(const fmb_system *from, mpq_t *x, fmb_system *to, bool *is_empty)
{
    int n = fmb_system_dim(from), *var = calloc((size_t)n + 1, sizeof *var);
    fmb_status st = var ? FMB_OK : FMB_ERR_MEMORY;
    for (int j = 0; st == FMB_OK && j < n; j++)
        var[j] = j;
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(from); i++) {
        bool names_one = false;
        read_row(from, i, x, x[n + 1]);
        for (int j = 0; j < n; j++)
            names_one = names_one || mpq_sgn(x[j]) != 0;
        *is_empty = *is_empty || (!names_one && mpq_sgn(x[n]) < 0);
        if (names_one)
            st = fmb_system_add_q(to, (size_t)n, var, x, FMB_LE, x[n]);
    }
    free(var);
    return st;
}

fmb_status study_balas_project(const fmb_system *s, const int *keep, int n, study_balas how,
                               fmb_system **out)
{
    fmb_system *block = NULL, *rows = NULL;
    bool is_empty = false;
    *out = NULL;
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        if (fmb_system_rel(s, i) != FMB_LE)
            return FMB_ERR_ARG;
    mpq_t *x = calloc((size_t)n + 4, sizeof *x);
    for (int j = 0; x && j < n + 4; j++)
        mpq_init(x[j]);
    fmb_status st = x ? study_block_project(s, keep, n, &block, NULL) : FMB_ERR_MEMORY;
    if (st == FMB_OK)
        st = fmb_system_new(n, NULL, &rows);
    if (st == FMB_OK)
        st = copy_rows(block, x, rows, &is_empty);
    for (int j = 0; x && j <= n; j++)
        mpq_set_ui(x[j], 0, 1);
    if (st == FMB_OK && !is_empty)
        st = reduce(rows, how, x, out);
    for (int j = 0; x && j < n + 4; j++)
        mpq_clear(x[j]);
    free(x);
    fmb_system_free(rows);
    fmb_system_free(block);
    return st;
}
