/* demand.c: are the claims of a proof an answer to a given demand? Whether they hold is checked
 * elsewhere (check.c); here they are only read. */
#include <stdarg.h>
#include <stdio.h>

#include "proof/complete.h"
#include "proof/evidence/guard.h"
#include "proof/integral.h"
#include "system/system_private.h"

/* State of a demand. Once st is a limit, nothing more is found, and nothing reported missing. */
typedef struct asker {
    const fmb_evidence *e;
    const fmb_system *s, *image;
    fmb_mem mem;
    fmb_guard guard;
    fmb_poll poll;
    fmb_status st;
    char *why;
    size_t size;
} asker;

/* Poll before another claim or row is read. */
static bool has_time(asker *a)
{
    if (a->st == FMB_OK)
        a->st = fmb_poll_ask(&a->poll);
    return a->st == FMB_OK;
}

/* Report what is missing in `why`; always false. */
__attribute__((format(printf, 2, 3))) static bool miss(const asker *a, const char *format, ...)
{
    va_list args;
    if (a->st != FMB_OK)
        return false;
    va_start(args, format);
    vsnprintf(a->why, a->size, format, args);
    va_end(args);
    return false;
}

static bool has_claim(asker *a, fmb_claim_kind kind)
{
    for (size_t i = 0; i < a->e->claims && has_time(a); i++)
        if (a->e->claim[i].kind == kind)
            return true;
    return false;
}

/* Is there a solution, integral as the system requires? Else one may exist over the reals only. */
static bool names_solution(asker *a)
{
    bool any = false;
    for (size_t i = 0; i < a->e->claims && has_time(a); i++) {
        const fmb_claim *c = &a->e->claim[i];
        if (c->kind == FMB_CLAIM_FEASIBLE && fmb_point_is_integral(a->s, &c->point))
            return true;
        any = any || c->kind == FMB_CLAIM_FEASIBLE;
    }
    return any ? miss(a, "it is feasible over the reals, but no claim has a point of integers")
               : miss(a, "no claim is feasible");
}

/* Are both bounds of each variable claimed? `seen` has two marks for each variable. */
static bool names_all_ends(asker *a, bool *seen)
{
    for (size_t i = 0; i < a->e->claims && has_time(a); i++) {
        const fmb_claim *c = &a->e->claim[i];
        bool is_end = c->kind == FMB_CLAIM_BOUND || c->kind == FMB_CLAIM_UNBOUNDED;
        if (is_end && c->var >= 0 && c->var < a->e->dim)
            seen[2 * c->var + (c->side == FMB_UPPER)] = true;
    }
    for (int j = 0; j < a->e->dim && has_time(a); j++)
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++)
            if (!seen[2 * j + side])
                return miss(a, "no claim is about the %s end of %.80s",
                            side == FMB_LOWER ? "lower" : "upper", fmb_system_name(a->s, j));
    return true;
}

/* Is there a claim for each row but equalities? `seen` has a mark for each row. */
static bool names_all_rows(asker *a, bool *seen)
{
    for (size_t i = 0; i < a->e->claims && has_time(a); i++)
        if (a->e->claim[i].row < a->e->rows)
            seen[a->e->claim[i].row] = true;
    for (size_t i = 0; i < a->e->rows && has_time(a); i++)
        if (!seen[i] && fmb_system_rel(a->s, i) != FMB_EQ)
            return miss(a, "no claim is about row %zu", i + 1);
    return true;
}

/* ---- projections ----------------------------------------------------------------------------- */

/* Is row i of the image a multiple of the claim's left side, times *factor? A claim without terms
 * never is. */
static bool is_multiple(const asker *a, const fmb_claim *c, size_t i, mpq_t factor, mpq_t t)
{
    size_t n = fmb_system_terms(a->image, i);
    bool good = n > 0 && n == c->terms.size;
    for (size_t k = 0; good && k < n; k++) {
        int j =
            fmb_system_find(a->s, fmb_system_name(a->image, fmb_system_term_q(a->image, i, k, t)));
        mpq_srcptr g = j >= 0 ? fmb_sparse_find(&c->terms, (size_t)j) : NULL;
        good = g && mpq_sgn(g) != 0;
        if (good)
            mpq_div(t, t, g);
        if (good && k == 0)
            mpq_set(factor, t);
        good = good && mpq_equal(factor, t);
    }
    return good;
}

/* Is the claim's inequality, times that factor, as tight as row i? */
static bool is_as_tight(const asker *a, const fmb_claim *c, size_t i, const mpq_t factor, mpq_t t)
{
    fmb_rel wanted = fmb_system_rel(a->image, i);
    if ((c->rel != FMB_EQ && mpq_sgn(factor) < 0) || (wanted == FMB_EQ && c->rel != FMB_EQ))
        return false;
    mpq_t right;
    mpq_init(right);
    mpq_mul(right, c->value, factor);
    fmb_system_rhs_q(a->image, i, t);
    int order = mpq_cmp(right, t);
    mpq_clear(right);
    bool equal_will_do = wanted != FMB_LT || c->rel == FMB_LT;
    return order == 0 ? equal_will_do : order < 0 && wanted != FMB_EQ;
}

/* Does every point satisfy 0 REL value? Otherwise none does. */
static bool is_true(fmb_rel rel, mpq_srcptr value)
{
    int sign = mpq_sgn(value);
    return rel == FMB_EQ ? sign == 0 : rel == FMB_LT ? sign > 0 : sign >= 0;
}

/* Is row i of the image constant, and true if `wanted`, else false? */
static bool is_constant(const asker *a, size_t i, bool wanted, mpq_t t)
{
    fmb_system_rhs_q(a->image, i, t);
    return fmb_system_terms(a->image, i) == 0 && is_true(fmb_system_rel(a->image, i), t) == wanted;
}

/* Is each row of the image implied by a claim, or trivial? Rows and claims mostly are in the same
 * order. */
static bool names_image(asker *a)
{
    bool good = true;
    size_t at = 0, claims = a->e->claims;
    mpq_t factor, t;
    mpq_inits(factor, t, NULL);
    for (size_t i = 0; good && i < fmb_system_rows(a->image) && has_time(a); i++) {
        bool found = is_constant(a, i, true, t);
        for (size_t k = 0; !found && k < claims && has_time(a); k++, at = (at + 1) % claims) {
            const fmb_claim *c = &a->e->claim[at];
            found = c->kind == FMB_CLAIM_IMPLIED && is_multiple(a, c, i, factor, t) &&
                    is_as_tight(a, c, i, factor, t);
        }
        good = found || miss(a, "no claim implies row %zu of the projection", i + 1);
    }
    mpq_clears(factor, t, NULL);
    return good;
}

static bool has_false_row(asker *a)
{
    bool found = false;
    mpq_t t;
    mpq_init(t);
    for (size_t i = 0; !found && i < fmb_system_rows(a->image) && has_time(a); i++)
        found = is_constant(a, i, false, t);
    mpq_clear(t);
    return found;
}

/* Row i of the image has the claim's left side times that factor: is it as tight as the claim?
 */
static bool says_as_much(const asker *a, const fmb_claim *c, size_t i, const mpq_t factor, mpq_t t)
{
    fmb_rel rel = fmb_system_rel(a->image, i);
    if (rel != FMB_EQ && (mpq_sgn(factor) < 0 || c->rel == FMB_EQ))
        return false;
    fmb_system_rhs_q(a->image, i, t);
    mpq_div(t, t, factor);
    int order = mpq_cmp(t, c->value);
    bool equal_will_do = c->rel != FMB_LT || rel == FMB_LT;
    return order == 0 ? equal_will_do : order < 0 && c->rel != FMB_EQ;
}

/* Is the claim a row of the image? Row *at is tried first, as claims and rows mostly are in the
 * same order. */
static bool is_in_image(asker *a, const fmb_claim *c, size_t *at)
{
    bool found = c->terms.size == 0 && is_true(c->rel, c->value);
    size_t rows = fmb_system_rows(a->image);
    mpq_t factor, t;
    mpq_inits(factor, t, NULL);
    for (size_t k = 0; !found && k < rows && has_time(a); k++, *at = (*at + 1) % rows)
        found = is_multiple(a, c, *at, factor, t) && says_as_much(a, c, *at, factor, t);
    mpq_clears(factor, t, NULL);
    return found;
}

/* kept[dim]: the variables of the image. Is there a claim WHOLE for them? */
static bool names_complete(asker *a, bool *kept)
{
    size_t size = (size_t)fmb_system_dim(a->image);
    bool found = false, known = true;
    for (size_t i = 0; known && i < size && has_time(a); i++) {
        int j = fmb_system_find(a->s, fmb_system_name(a->image, (int)i));
        known = j >= 0;
        if (known)
            kept[j] = true;
    }
    for (size_t i = 0; known && !found && i < a->e->claims && has_time(a); i++) {
        const fmb_claim *c = &a->e->claim[i];
        found = c->kind == FMB_CLAIM_WHOLE && c->terms.size == size &&
                fmb_complete_names_only(c, a->e->dim, kept);
    }
    return found || miss(a, "no claim is about the whole projection");
}

/* A system that asks for a projection stands for the projection, not for its rows. */
static bool keeps_all_variables(asker *a)
{
    for (int j = 0; j < fmb_system_dim(a->image) && has_time(a); j++)
        if (!fmb_system_keeps(a->image, j))
            return miss(a, "the projection itself asks to eliminate %.80s",
                        fmb_system_name(a->image, j));
    return true;
}

/* An image without integer variables is one over the reals. Otherwise it must have those of the
 * system, all kept: then the integer points of the image are the image of the integer points. */
static bool keeps_integers(asker *a)
{
    int first = fmb_system_first_integer(a->image);
    for (int j = 0; first >= 0 && j < fmb_system_dim(a->s) && has_time(a); j++) {
        int k = fmb_system_find(a->image, fmb_system_name(a->s, j));
        if (fmb_system_is_integer(a->s, j) != (k >= 0 && fmb_system_is_integer(a->image, k)))
            return miss(a, "%.80s is integer in the %s alone", fmb_system_name(a->s, j),
                        fmb_system_is_integer(a->s, j) ? "system" : "projection");
    }
    return true;
}

/* The claims on which the claim WHOLE relies must be in the image. */
static bool names_complete_image(asker *a, bool *kept)
{
    bool good =
        keeps_all_variables(a) && keeps_integers(a) && names_image(a) && names_complete(a, kept);
    size_t at = 0;
    for (size_t i = 0; good && i < a->e->claims && has_time(a); i++) {
        const fmb_claim *c = &a->e->claim[i];
        if (c->kind == FMB_CLAIM_IMPLIED && fmb_complete_names_only(c, a->e->dim, kept))
            good = is_in_image(a, c, &at) || miss(a, "the projection lacks claim %zu", i + 1);
    }
    return good;
}

/* ---- optima ---------------------------------------------------------------------------------- */

/* Is the form of the claim, its variable or terms, the objective of that system? */
static bool is_about_objective(const asker *a, const fmb_claim *c, const fmb_system *of, mpq_t t)
{
    size_t n = fmb_system_objective_terms(of);
    bool upper = fmb_system_sense(of) == FMB_SENSE_MAX;
    bool good = n == (c->var >= 0 ? 1 : c->terms.size) && upper == (c->side == FMB_UPPER);
    for (size_t k = 0; good && k < n; k++) {
        int j = fmb_system_find(a->s, fmb_system_name(of, fmb_system_objective_term_q(of, k, t)));
        mpq_srcptr g = c->var < 0 && j >= 0 ? fmb_sparse_find(&c->terms, (size_t)j) : NULL;
        good = c->var >= 0 ? j == c->var && mpq_cmp_ui(t, 1, 1) == 0 : g && mpq_equal(g, t);
    }
    return good;
}

static bool names_optimum(asker *a)
{
    const fmb_system *of = a->image ? a->image : a->s;
    bool any = fmb_system_sense(of) == FMB_SENSE_NONE, found = false, real = false,
         solution = false;
    bool integers = fmb_system_first_integer(a->s) >= 0;
    mpq_t t;
    mpq_init(t);
    for (size_t i = 0; i < a->e->claims && has_time(a); i++) {
        const fmb_claim *c = &a->e->claim[i];
        solution =
            solution || (c->kind == FMB_CLAIM_FEASIBLE && fmb_point_is_integral(a->s, &c->point));
    }
    for (size_t i = 0; !found && i < a->e->claims && has_time(a); i++) {
        const fmb_claim *c = &a->e->claim[i];
        bool about = (c->kind == FMB_CLAIM_BOUND || c->kind == FMB_CLAIM_UNBOUNDED) &&
                     (any || is_about_objective(a, c, of, t));
        found = about && (!integers || fmb_claim_is_integral(a->s, c, solution));
        real = real || about;
    }
    mpq_clear(t);
    if (!found && real)
        return miss(a, "the optimum is one over the reals");
    return found || miss(a, "no claim is about %s optimum", any ? "an" : "that");
}

/* ---- all ------------------------------------------------------------------------------------- */

static bool meets_demand(asker *a, fmb_demand what, bool *seen)
{
    switch (what) {
    case FMB_DEMAND_FEASIBLE:
        return names_solution(a);
    case FMB_DEMAND_INFEASIBLE:
        return has_claim(a, FMB_CLAIM_INFEASIBLE) || miss(a, "no claim is infeasible");
    case FMB_DEMAND_BOUNDS: /* the empty set lies in any box */
        return has_claim(a, FMB_CLAIM_INFEASIBLE) || names_all_ends(a, seen);
    case FMB_DEMAND_REDUCED:
        return names_all_rows(a, seen);
    case FMB_DEMAND_PROJECTION: /* any row holds on the empty set */
        return has_claim(a, FMB_CLAIM_INFEASIBLE) || names_image(a);
    case FMB_DEMAND_WHOLE:
        return has_claim(a, FMB_CLAIM_INFEASIBLE)
                   ? has_false_row(a) || miss(a, "the projection of the empty set is empty")
                   : names_complete_image(a, seen);
    case FMB_DEMAND_OPTIMUM:
        return has_claim(a, FMB_CLAIM_INFEASIBLE) || names_optimum(a);
    case FMB_DEMAND_NOTHING:
        break;
    }
    return true;
}

/* A limit is a result: claims not found by then are not reported missing. */
static fmb_status ask_to_limit(asker *a, fmb_demand what, fmb_stop *stop, bool *meets)
{
    size_t marks = 2 * (size_t)a->e->dim + a->e->rows;
    fmb_mem_take(&a->mem, a->e->mem.used);
    bool *seen = fmb_mem_zero(&a->mem, marks, sizeof *seen);
    if (!seen)
        a->st = fmb_mem_status(&a->mem);
    bool found = seen && meets_demand(a, what, seen);
    fmb_mem_put(&a->mem, seen, marks, sizeof *seen);
    if (a->st != FMB_OK && a->st != FMB_LIMIT)
        return a->st;
    *stop = a->st == FMB_LIMIT ? fmb_guard_stop(&a->guard) : FMB_STOP_DONE;
    *meets = found && a->st == FMB_OK;
    return FMB_OK;
}

fmb_status fmb_evidence_meets_within(const fmb_evidence *e, const fmb_system *s, fmb_demand what,
                                     const fmb_system *image, const fmb_patience *patience,
                                     fmb_stop *stop, bool *meets, char *why, size_t size)
{
    bool of_image = what == FMB_DEMAND_PROJECTION || what == FMB_DEMAND_WHOLE;
    if (!stop || !meets || !fmb_evidence_fits(e, s) || (of_image && !image) ||
        what < FMB_DEMAND_NOTHING || what > FMB_DEMAND_OPTIMUM)
        return FMB_ERR_ARG;
    char unwanted[1];
    asker a = {.e = e, .s = s, .image = image, .why = why ? why : unwanted, .size = why ? size : 1};
    fmb_mem_init(&a.mem, &s->mem.alloc, 0);
    fmb_status st = fmb_guard_begin(&a.guard, patience, &a.mem);
    a.poll = fmb_guard_poll(&a.guard);
    return st == FMB_OK ? ask_to_limit(&a, what, stop, meets) : st;
}

fmb_status fmb_evidence_meets(const fmb_evidence *e, const fmb_system *s, fmb_demand what,
                              const fmb_system *image, bool *meets, char *why, size_t size)
{
    fmb_stop stop;
    return fmb_evidence_meets_within(e, s, what, image, NULL, &stop, meets, why, size);
}
