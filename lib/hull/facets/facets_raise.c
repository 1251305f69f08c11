/* facets_raise.c: adds a generator outside the span: the cone becomes a pyramid; see facets.h.
 *
 * Let e be the equation with e.g > 0. The old cone is the base of the pyramid, a facet with the
 * normal e. A facet h of the old cone and g span a facet: h - (h.g / e.g) e is 0 on g and unchanged
 * on all others, where e is 0. The other equations become 0 on g in the same way. Facets that
 * shared a ridge now share that and g; each meets the base in the old facet.
 */
#include "hull/facets/facets_private.h"

/* Wide vectors are in lowest terms already; one that was wide because of its last entry alone need
 * not be wide any more. */
fmb_status fmb_facets_tidy(fmb_facets *f, fmb_vec *v)
{
    size_t bits = 0;
    if (!v->z) {
        v->s[f->d] = 0;
        return fmb_vec_reduce(v, f->d + 1, &f->num);
    }
    mpz_set_ui(v->z[f->d], 0);
    for (size_t j = 0; j < f->d; j++) {
        size_t b = mpz_sizeinbase(v->z[j], 2);
        bits = b > bits ? b : bits;
    }
    return bits > FMB_SMALL_BITS ? FMB_OK : fmb_vec_reduce(v, f->d + 1, &f->num);
}

/* Make v 0 on the new generator by adding a multiple of e. */
static fmb_status lift_to_generator(fmb_facets *f, fmb_vec *v, const fmb_vec *e)
{
    fmb_status st = fmb_facets_evaluate(f, v);
    if (st == FMB_OK && fmb_vec_sgn(v, f->d) != 0)
        st = fmb_vec_cancel(v, v, e, f->d + 1, f->d, &f->num);
    fmb_run_count(f->run, fmb_vec_work(v, f->d + 1));
    return st == FMB_OK ? fmb_facets_tidy(f, v) : st;
}

static fmb_status lift_facets_and_equations(fmb_facets *f, size_t e, size_t generator)
{
    fmb_status st = FMB_OK;
    for (size_t a = 0; st == FMB_OK && a < f->slots; a++) {
        fmb_facet *t = &f->facet[a];
        if (!t->alive)
            continue;
        st = lift_to_generator(f, &t->normal, &f->equation[e]);
        fmb_facets_round_normal(f, t);
        fmb_facet_put_on(t, generator);
        t->note = 0;
    }
    for (size_t i = 0; st == FMB_OK && i < f->d - f->rank; i++)
        if (i != e)
            st = lift_to_generator(f, &f->equation[i], &f->equation[e]);
    return st;
}

/* Make the old cone the base of the pyramid. */
static fmb_status open_base(fmb_facets *f, size_t e, size_t generator)
{
    uint32_t base;
    size_t slots = f->slots;
    FMB_TRY(fmb_facets_open_slot(f, &base));
    fmb_facet *b = &f->facet[base];
    fmb_status st = fmb_vec_copy(&b->normal, &f->equation[e], f->d + 1, f->num.mem);
    FMB_THEN(st, fmb_facets_tidy(f, &b->normal));
    b->known = st == FMB_OK;
    fmb_facets_round_normal(f, b);
    for (size_t i = 0; i < generator; i++)
        fmb_facet_put_on(b, i);
    for (size_t a = 0; st == FMB_OK && a < slots; a++)
        if (f->facet[a].alive && a != base)
            st = fmb_facets_join(f, (uint32_t)a, base);
    return st;
}

fmb_status fmb_facets_raise(fmb_facets *f, size_t e, size_t generator)
{
    fmb_vec *equation = &f->equation[e], *last = &f->equation[f->d - f->rank - 1], t;
    if (fmb_vec_product_sign(equation, &f->g, f->d, &f->num) < 0)
        fmb_vec_negate(equation, f->d + 1);
    fmb_status st = fmb_facets_evaluate(f, equation);
    FMB_THEN(st, lift_facets_and_equations(f, e, generator));
    FMB_THEN(st, open_base(f, e, generator));
    t = *equation;
    *equation = *last;
    *last = t;
    f->rank++;
    return st;
}
