/* facets_add.c: adds a generator: inside, beyond some facets, or outside the span; see facets.h.
 */
#include <string.h>

#include "hull/facets/facets_private.h"

/* The new generator is outside the cone: give it a number. */
static fmb_status number_generator(fmb_facets *f)
{
    fmb_mem *mem = f->num.mem;
    FMB_TRY(FMB_RESERVE(mem, &f->generator, &f->generator_capacity, f->generators + 1));
    FMB_TRY(FMB_RESERVE(mem, &f->rounded, &f->rounded_capacity, (f->generators + 1) * f->d));
    if (f->generators == 64 * f->words)
        FMB_TRY(fmb_facets_widen_sets(f));
    fmb_vec v = {.s = fmb_mem_get(mem, f->d, sizeof *v.s)};
    if (!v.s)
        return fmb_mem_status(mem);
    memcpy(f->rounded + f->generators * f->d, f->near, f->d * sizeof *f->near);
    fmb_facets_scale_down(f->rounded + f->generators * f->d, f->d);
    f->generator[f->generators++] = v;
    return fmb_vec_copy(&f->generator[f->generators - 1], &f->g, f->d, mem);
}

/* An equation that v does not satisfy; f->d: none. */
static size_t find_equation_off(fmb_facets *f, const fmb_vec *v)
{
    for (size_t e = 0; e < f->d - f->rank; e++)
        if (fmb_vec_product_sign(&f->equation[e], v, f->d, &f->num) != 0)
            return e;
    return f->d;
}

bool fmb_facets_is_off_span(fmb_facets *f, const fmb_vec *v)
{
    return find_equation_off(f, v) < f->d;
}

/* Find the side of facet `at` on which the new generator is; list visible and touched facets. */
static fmb_status find_side(fmb_facets *f, uint32_t at)
{
    fmb_facet *a = &f->facet[at];
    a->round = f->round;
    fmb_run_count(f->run, 20 + 2 * f->d);
    FMB_TRY(fmb_facets_side(f, at, &f->g, f->near, &a->side));
    if (a->side < 0)
        FMB_TRY(fmb_facets_list(f, &f->seen, &f->seens, &f->seen_capacity, at));
    else if (a->side == 0)
        FMB_TRY(fmb_facets_list(f, &f->touched, &f->toucheds, &f->touched_capacity, at));
    return FMB_OK;
}

/* From one visible facet, find all visible ones and their neighbours. */
static fmb_status list_visible_facets(fmb_facets *f)
{
    for (size_t i = 0; i < f->seens; i++) {
        uint32_t v = f->seen[i];
        for (size_t k = 0; k < f->facet[v].nexts; k++) {
            uint32_t n = f->facet[v].next[k];
            if (f->facet[n].round != f->round)
                FMB_TRY(find_side(f, n));
        }
    }
    return FMB_OK;
}

/* Facets are the vertices of a polytope in the dual space, ridges its edges, and the new generator
 * is a linear form there. By the simplex method, at a vertex where the form is not least, some edge
 * decreases it: so if any facet is visible, a touched facet is adjacent to a visible one; and the
 * visible facets are connected, as a descent from each ends where the form is least, and the least
 * vertices form a face. The search for a visible facet begins at slot number first. */
static fmb_status find_sides(fmb_facets *f, size_t first)
{
    f->seens = f->toucheds = 0;
    f->round++;
    for (size_t k = 0; k < f->slots && f->seens == 0; k++) {
        size_t i = (first + k) % f->slots;
        if (f->facet[i].alive)
            FMB_TRY(find_side(f, (uint32_t)i));
    }
    return list_visible_facets(f);
}

static fmb_status load_generator(fmb_facets *f, fmb_status st)
{
    FMB_THEN(st, fmb_vec_reduce(&f->g, f->d, &f->num));
    if (st == FMB_OK)
        fmb_facets_round(&f->g, f->d, f->near);
    return st;
}

/* Add the generator that has been loaded, which may be beyond facet `at`. */
static fmb_status add_generator_at_hand(fmb_facets *f, size_t at, bool *grown)
{
    fmb_status st = FMB_OK;
    size_t e = find_equation_off(f, &f->g);
    if (e == f->d)
        st = find_sides(f, at);
    *grown = st == FMB_OK && (e < f->d || f->seens > 0);
    if (!*grown)
        return st;
    st = number_generator(f);
    FMB_THEN(st, e < f->d ? fmb_facets_raise(f, e, f->generators - 1)
                          : fmb_facets_cut(f, f->generators - 1));
    return st;
}

fmb_status fmb_facets_add_near(fmb_facets *f, size_t at, mpz_t *g, bool *grown)
{
    FMB_TRY(load_generator(f, fmb_vec_set_z(&f->g, f->d, g, f->num.mem)));
    return add_generator_at_hand(f, at, grown);
}

fmb_status fmb_facets_add_vec(fmb_facets *f, const fmb_vec *v, bool *grown)
{
    FMB_TRY(load_generator(f, fmb_vec_copy(&f->g, v, f->d, f->num.mem)));
    return add_generator_at_hand(f, 0, grown);
}

fmb_status fmb_facets_add_beyond(fmb_facets *f, const fmb_vec *v, size_t at)
{
    FMB_TRY(load_generator(f, fmb_vec_copy(&f->g, v, f->d, f->num.mem)));
    FMB_TRY(find_sides(f, at));
    FMB_TRY(number_generator(f));
    return fmb_facets_cut(f, f->generators - 1);
}
