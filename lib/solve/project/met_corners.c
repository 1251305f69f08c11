/* met_corners.c: see met_corners.h.
 *
 * Forms are b t - a.x of each inequality, and t. If cone G is the cone P on which no form is
 * negative, then g of G is on an extreme ray of P, up to the lines of P, if and only if all vectors
 * of G that are 0 on all forms that are 0 at g are lines, or multiples of g up to lines. For those
 * y of P where these forms are 0 are the least face with g, which is spanned by what G has of it.
 * Such multiples are 0 on the same forms; one of them is enough. Lines are 0 on all forms. So
 * corners are told by sets. If G spans less than P, or where there are lines, too many may be taken
 * for corners; who asks finds that out.
 */
#include "solve/project/met_corners.h"

#include <string.h>

#include "num/bitset.h"
#include "solve/query/lifted.h"

typedef struct corner_search {
    fmb_query *q;
    const fmb_system *image;
    fmb_image *m;
    size_t forms, words; /* words of a set of vectors */
    uint64_t *zero;      /* [forms][words] where the form is 0 */
    uint64_t *face;      /* [words] scratch */
    size_t *zeros;       /* [vectors] forms that are 0 there */
    bool *stays;         /* [vectors] it is a corner */
    fmb_vec form;        /* scratch */
} corner_search;

/* Is each kept variable one of that part? Another one is free, or makes products of corners. */
static bool holds_part_all_kept(const fmb_query *q, const int *place)
{
    bool all = q->met.size > 0;
    for (int j = 0; all && j < fmb_system_dim(q->s); j++)
        all = place[j] < 0 || q->parts.of_var[j] == q->met.part;
    return all;
}

/* The points that were met, each once. */
static fmb_status list_met_vectors(corner_search *c)
{
    const fmb_met_points *met = &c->q->met;
    fmb_mem *mem = c->q->run.mem;
    fmb_vec *v = fmb_mem_get(mem, met->size, sizeof *v);
    bool *line = fmb_mem_zero(mem, met->size, sizeof *line);
    fmb_status st = v && line ? FMB_OK : fmb_mem_status(mem);
    for (size_t i = 0; st == FMB_OK && i < met->size; i++)
        v[i] = met->point[i].y;
    if (st == FMB_OK)
        st = fmb_image_init_vectors(c->m, &c->q->run, met->width, met->size, v, line,
                                    fmb_query_is_wide(c->q));
    fmb_mem_put(mem, v, met->size, sizeof *v);
    fmb_mem_put(mem, line, met->size, sizeof *line);
    return st;
}

static fmb_status find_zeros_of_forms(corner_search *c, mpz_t *z)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i <= c->image->rows; i++) {
        const fmb_sysrow *r = i < c->image->rows ? &c->image->row[i] : NULL;
        if (r && r->rel == FMB_EQ)
            continue;
        uint64_t *zero = c->zero + c->forms++ * c->words;
        fmb_lifted_write_form(r, c->m->n, z);
        st = fmb_vec_set_z(&c->form, c->m->n, z, c->q->run.mem);
        for (size_t g = 0; st == FMB_OK && g < c->m->rays; g++)
            if (fmb_image_value_sign(c->m, &c->form, &c->m->ray[g]) == 0)
                fmb_set_put(zero, g);
        if (st == FMB_OK)
            st = fmb_run_poll(&c->q->run);
    }
    return st;
}

/* How many forms are 0 at each vector; where all are, it is a line. */
static void count_zeros(corner_search *c)
{
    for (size_t g = 0; g < c->m->rays; g++) {
        c->zeros[g] = 0;
        for (size_t i = 0; i < c->forms; i++)
            c->zeros[g] += fmb_set_has(c->zero + i * c->words, g);
    }
}

/* c->face = the vectors on all forms that are 0 at g. */
static void find_least_face(corner_search *c, size_t g)
{
    memset(c->face, 0xff, c->words * sizeof *c->face);
    for (size_t i = 0; i < c->forms; i++) {
        const uint64_t *zero = c->zero + i * c->words;
        for (size_t w = 0; fmb_set_has(zero, g) && w < c->words; w++)
            c->face[w] &= zero[w];
    }
}

/* Is g all that there is of its face, up to lines, or the first of those that are? */
static bool is_corner(const corner_search *c, size_t g)
{
    bool only = true;
    for (size_t i = 0; only && i < c->m->rays; i++)
        if (i != g && fmb_set_has(c->face, i) && c->zeros[i] < c->forms)
            only = c->zeros[i] == c->zeros[g] && i > g;
    return only;
}

/* Those that are no corners go, and lines go over to the lines. */
static fmb_status keep_corners(corner_search *c, bool *found)
{
    fmb_status st = FMB_OK;
    fmb_image *m = c->m;
    size_t left = 0;
    count_zeros(c);
    for (size_t g = 0; g < m->rays && st == FMB_OK; g++) {
        find_least_face(c, g);
        c->stays[g] = c->zeros[g] < c->forms && is_corner(c, g);
        st = fmb_run_poll(&c->q->run);
    }
    for (size_t g = 0; g < m->rays; g++) {
        if (c->stays[g])
            m->ray[left++] = m->ray[g];
        else if (c->zeros[g] == c->forms)
            m->line[m->lines++] = m->ray[g];
        else
            fmb_vec_clear(&m->ray[g], m->n, c->q->run.mem);
    }
    m->rays = left;
    *found = left > 0;
    return st;
}

static fmb_status search_corners(corner_search *c, bool *found)
{
    fmb_mem *mem = c->q->run.mem;
    fmb_status st = list_met_vectors(c);
    if (st != FMB_OK)
        return st;
    size_t n = c->m->n, most = c->image->rows + 1, size = c->m->rays;
    c->words = fmb_set_words(c->m->rays);
    mpz_t *z = fmb_vec_block(n, mem);
    c->form.s = fmb_mem_get(mem, n, sizeof *c->form.s);
    c->zero = fmb_mem_zero(mem, most, c->words * sizeof *c->zero);
    c->face = fmb_mem_get(mem, c->words, sizeof *c->face);
    c->zeros = fmb_mem_zero(mem, size, sizeof *c->zeros);
    c->stays = fmb_mem_zero(mem, size, sizeof *c->stays);
    if (!z || !c->form.s || !c->zero || !c->face || !c->zeros || !c->stays)
        st = fmb_mem_status(mem);
    if (st == FMB_OK)
        st = find_zeros_of_forms(c, z);
    if (st == FMB_OK)
        st = keep_corners(c, found);
    fmb_vec_block_free(z, n, mem);
    if (c->form.s)
        fmb_vec_clear(&c->form, n, mem);
    fmb_mem_put(mem, c->form.s, n, sizeof *c->form.s);
    fmb_mem_put(mem, c->zero, most, c->words * sizeof *c->zero);
    fmb_mem_put(mem, c->face, c->words, sizeof *c->face);
    fmb_mem_put(mem, c->zeros, size, sizeof *c->zeros);
    fmb_mem_put(mem, c->stays, size, sizeof *c->stays);
    return st;
}

fmb_status fmb_met_corners(fmb_query *q, const int *place, const fmb_system *image, fmb_image *m,
                           bool *found)
{
    corner_search c = {.q = q, .image = image, .m = m};
    *found = holds_part_all_kept(q, place);
    if (!*found)
        fmb_met_points_clear(&q->met);
    return *found ? search_corners(&c, found) : FMB_OK;
}
