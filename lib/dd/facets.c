/* facets.c: a generator more: inside, beyond some facets, or outside of the span; see facets.h. */
#include "dd/facets_inside.h"

static fmb_status load_generator(fmb_facets *f, mpz_t *g)
{
    fmb_status st = fmb_vec_set_z(&f->g, f->d, g, f->num.mem);
    if (st == FMB_OK)
        st = fmb_vec_reduce(&f->g, f->d, &f->num);
    if (st == FMB_OK)
        fmb_facets_round(&f->g, f->d, f->near);
    return st;
}

/* The one at hand is outside: it gets a number. */
static fmb_status number_generator(fmb_facets *f)
{
    fmb_mem *mem = f->num.mem;
    fmb_status st = fmb_mem_reserve(mem, (void **)&f->generator, &f->generator_capacity,
                                    f->generators + 1, sizeof *f->generator);
    if (st == FMB_OK && f->generators == 64 * f->words)
        st = fmb_facets_widen_sets(f);
    if (st != FMB_OK)
        return st;
    fmb_vec v = {.s = fmb_mem_get(mem, f->d, sizeof *v.s)};
    if (!v.s)
        return fmb_mem_status(mem);
    f->generator[f->generators++] = v;
    return fmb_vec_copy(&f->generator[f->generators - 1], &f->g, f->d, mem);
}

/* An equation that the generator at hand does not satisfy; f->d: none. */
static size_t find_equation_off(fmb_facets *f)
{
    for (size_t e = 0; e < f->d - f->rank; e++)
        if (fmb_facets_sign(f, &f->equation[e]) != 0)
            return e;
    return f->d;
}

/* The side of every facet, and lists of those that matter. */
static fmb_status find_sides(fmb_facets *f)
{
    fmb_status st = FMB_OK;
    f->seens = f->toucheds = 0;
    for (size_t i = 0; st == FMB_OK && i < f->slots; i++) {
        fmb_facet *a = &f->facet[i];
        if (!a->alive)
            continue;
        a->side = fmb_facets_side(f, a);
        if (a->side < 0)
            st = fmb_facets_list(f, &f->seen, &f->seens, &f->seen_capacity, (uint32_t)i);
        else if (a->side == 0)
            st = fmb_facets_list(f, &f->touched, &f->toucheds, &f->touched_capacity, (uint32_t)i);
    }
    return st;
}

fmb_status fmb_facets_add(fmb_facets *f, mpz_t *g, bool *grown)
{
    fmb_status st = load_generator(f, g);
    if (st != FMB_OK)
        return st;
    size_t e = find_equation_off(f);
    if (e == f->d)
        st = find_sides(f);
    *grown = st == FMB_OK && (e < f->d || f->seens > 0);
    if (!*grown)
        return st;
    st = number_generator(f);
    if (st == FMB_OK)
        st = e < f->d ? fmb_facets_raise(f, e, f->generators - 1)
                      : fmb_facets_cut(f, f->generators - 1);
    return st;
}
