/* completeness.c: projections proved complete, and changes of proof or projection, which must be
 * detected. */
#include <criterion/criterion.h>
#include <stdlib.h>

#include <fmb/gmp.h>

#include "proof/evidence/evidence.h"
#include "support/dense.h"
#include "support/must.h"

/* A projection with its proof. */
typedef struct proved {
    support_rng g;
    fmb_system *s, *image;
    fmb_evidence *e;
    bool bounded, strict; /* the rows say so at once */
} proved;

static size_t any(proved *p, size_t n)
{
    return (size_t)(support_next(&p->g) % n);
}

/* A box around everything where it shall be bounded, and rows of small numbers. */
static fmb_system *random_system(proved *p, int dim)
{
    int rows = support_between(&p->g, 3, 9), boxes = p->bounded ? 2 * dim : 0;
    dense d = dense_new(dim, rows + boxes);
    for (int i = 0; i < rows; i++) {
        for (int j = 0; j < dim; j++)
            mpq_set_si(dense_row(&d, i)[j], support_between(&p->g, -4, 4), 1);
        mpq_set_si(dense_rhs(&d, i), support_between(&p->g, 0, 7), 1);
        if (p->strict && support_chance(&p->g, 40))
            d.rel[i] = FMB_LT;
    }
    if (support_chance(&p->g, 20)) {
        d.rel[0] = FMB_EQ;
        mpq_set_ui(dense_rhs(&d, 0), 0, 1);
    }
    for (int i = 0; i < boxes; i++) {
        mpq_set_si(dense_row(&d, rows + i)[i / 2], i % 2 ? 1 : -1, 1);
        mpq_set_si(dense_rhs(&d, rows + i), support_between(&p->g, 1, 9), 1);
    }
    fmb_system *s = dense_system(&d);
    dense_free(&d);
    return s;
}

static proved prove(uint64_t seed, fmb_method method)
{
    proved p = {.g = {seed}};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    int dim = support_between(&p.g, 2, 6), keep[] = {0, 1, 2, 3};
    int kept = support_between(&p.g, 1, dim < 4 ? dim : 4);
    p.bounded = seed % 4 != 3;
    p.strict = seed % 4 >= 2;
    p.s = random_system(&p, dim);
    o.evidence = FMB_EVIDENCE_WHOLE;
    o.method = method;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_project(v, p.s, keep, kept, &p.image, &r));
    must(fmb_solver_evidence(v, &p.e));
    fmb_solver_free(v);
    return p;
}

static void forget(proved *p)
{
    fmb_evidence_free(p->e);
    fmb_system_free(p->image);
    fmb_system_free(p->s);
}

/* Is the proof accepted, and is it one of that projection, whole? */
static bool convinces(const fmb_system *s, const fmb_evidence *e, const fmb_system *image)
{
    fmb_judgement j = {.size = sizeof j};
    bool meets = false;
    must(fmb_check(s, e, &j));
    must(fmb_evidence_meets(e, s, FMB_DEMAND_WHOLE, image, &meets, NULL, 0));
    return j.accepted && meets;
}

static void complain(const proved *p, const fmb_evidence *e, const fmb_system *image,
                     const char *what)
{
    support_print(p->s, what, stderr);
    support_print(image, "the projection", stderr);
    must(fmb_evidence_write(e, p->s, stderr));
    cr_assert_fail("%s", what);
}

/* What is written of the proof can be read, and convinces, too. */
static bool convinces_as_text(const proved *p)
{
    char *text = NULL;
    size_t size;
    fmb_where where;
    fmb_evidence *e = NULL;
    FILE *out = open_memstream(&text, &size);
    must(out ? fmb_evidence_write(p->e, p->s, out) : FMB_ERR_MEMORY);
    fclose(out);
    bool good =
        fmb_evidence_parse(text, size, p->s, &e, &where) == FMB_OK && convinces(p->s, e, p->image);
    fmb_evidence_free(e);
    free(text);
    return good;
}

/* All small projections are proved whole, by every method. */
Test(whole, proofs)
{
    static const fmb_method methods[] = {FMB_METHOD_AUTO, FMB_METHOD_FM, FMB_METHOD_HULL,
                                         FMB_METHOD_DD};
    for (uint64_t seed = 0; seed < 400; seed++) {
        proved p = prove(seed, methods[seed / 4 % 4]);
        if (!convinces(p.s, p.e, p.image) || !convinces_as_text(&p))
            complain(&p, p.e, p.image, "not whole");
        forget(&p);
    }
}

/* ---- changes --------------------------------------------------------------------------------- */

/* The claims but number `without` (SIZE_MAX: all), to be changed. */
static fmb_evidence *copy_claims(const proved *p, size_t without)
{
    fmb_evidence *e;
    must(fmb_evidence_new(p->e->dim, p->e->rows, NULL, &e));
    for (size_t i = 0; i < p->e->claims; i++) {
        const fmb_claim *from = &p->e->claim[i];
        const fmb_sparse_vector *lists[] = {&from->terms, &from->multipliers, &from->reverse,
                                            &from->point, &from->ray};
        fmb_claim *to;
        if (i == without)
            continue;
        must(fmb_evidence_claim(e, from->kind, &to));
        to->row = from->row;
        to->var = from->var;
        to->side = from->side;
        to->rel = from->rel;
        mpq_set(to->value, from->value);
        fmb_sparse_vector *copies[] = {&to->terms, &to->multipliers, &to->reverse, &to->point,
                                       &to->ray};
        for (size_t l = 0; l < 5; l++)
            for (size_t k = 0; k < lists[l]->size; k++)
                must(fmb_evidence_push(e, copies[l], lists[l]->index[k], lists[l]->value[k]));
    }
    return e;
}

/* Number of a claim of that kind, SIZE_MAX: there is none. */
static size_t any_claim(proved *p, fmb_claim_kind kind)
{
    size_t first = any(p, p->e->claims);
    for (size_t k = 0; k < p->e->claims; k++)
        if (p->e->claim[(first + k) % p->e->claims].kind == kind)
            return (first + k) % p->e->claims;
    return SIZE_MAX;
}

/* The image without row i; or with that row once more, moved inwards; or with it moved so. */
static fmb_system *other_image(const proved *p, int i, int rows)
{
    dense d = dense_of(p->image), e = dense_new(d.dim, d.rows + rows);
    mpq_t t;
    mpq_init(t);
    mpq_set_si(t, 1, 3);
    for (int k = 0, from = 0; k < e.rows; k++, from++) {
        from += rows < 0 && from == i;
        int row = from < d.rows ? from : i;
        e.rel[k] = d.rel[row];
        for (int j = 0; j <= d.dim; j++)
            mpq_set(dense_row(&e, k)[j], dense_row(&d, row)[j]);
        if ((rows > 0 && from == d.rows) || (rows == 0 && from == i))
            mpq_sub(dense_rhs(&e, k), dense_rhs(&e, k), t);
    }
    fmb_system *s = dense_system(&e);
    mpq_clear(t);
    dense_free(&d);
    dense_free(&e);
    return s;
}

/* A row of the image and its claim are left out, or the claim alone is, or the row. */
static bool leave_facet_out(proved *p)
{
    size_t i = any_claim(p, FMB_CLAIM_IMPLIED);
    if (i == SIZE_MAX)
        return false;
    size_t row = 0; /* rows come in the order of their claims */
    for (size_t k = 0; k < i; k++)
        row += p->e->claim[k].kind == FMB_CLAIM_IMPLIED;
    fmb_evidence *e = copy_claims(p, i);
    fmb_system *image = other_image(p, (int)row, -1);
    if (convinces(p->s, e, image) || convinces(p->s, e, p->image) || convinces(p->s, p->e, image))
        complain(p, e, image, "a facet is missing");
    fmb_system_free(image);
    fmb_evidence_free(e);
    return true;
}

/* A row more, or a tighter one, beside the proof; then claimed there, too. */
static bool add_row(proved *p)
{
    size_t i = any_claim(p, FMB_CLAIM_IMPLIED);
    if (i == SIZE_MAX)
        return false;
    size_t row = 0;
    for (size_t k = 0; k < i; k++)
        row += p->e->claim[k].kind == FMB_CLAIM_IMPLIED;
    bool more = any(p, 2);
    fmb_system *image = other_image(p, (int)row, more);
    if (convinces(p->s, p->e, image))
        complain(p, p->e, image, "a row too many");
    fmb_evidence *e = copy_claims(p, SIZE_MAX);
    fmb_claim *c = &e->claim[i];
    mpq_t b, t;
    mpq_inits(b, t, NULL);
    int var = fmb_system_term_q(p->image, row, 0, t);
    for (size_t k = 0; k < c->terms.size; k++)
        if (c->terms.index[k] == (size_t)var)
            mpq_div(t, c->terms.value[k], t);
    fmb_system_rhs_q(image, more ? fmb_system_rows(image) - 1 : row, b);
    mpq_mul(c->value, b, t);
    if (convinces(p->s, e, image))
        complain(p, e, image, "a row that does not follow");
    mpq_clears(b, t, NULL);
    fmb_evidence_free(e);
    fmb_system_free(image);
    return true;
}

/* A corner is left out, or its image is moved, or that of another one. */
static bool move_corner(proved *p)
{
    size_t i = any_claim(p, FMB_CLAIM_CORNER);
    bool leave_out = any(p, 3) == 0;
    if (!p->bounded || p->strict || i == SIZE_MAX)
        return false;
    fmb_evidence *e = copy_claims(p, leave_out ? i : SIZE_MAX);
    size_t var = any(p, (size_t)fmb_system_dim(p->image));
    mpq_t by;
    mpq_init(by);
    mpq_set_si(by, any(p, 2) ? 1 : -1, (unsigned)(1 + any(p, 1000)));
    fmb_sparse_vector *point = &e->claim[leave_out ? 0 : i].point;
    bool found = leave_out;
    for (size_t k = 0; !found && k < point->size; k++)
        if (point->index[k] == var) {
            mpq_add(point->value[k], point->value[k], by);
            found = true;
        }
    if (!found) {
        must(fmb_evidence_push(e, point, var, by));
        point->mixed = true;
    }
    if (convinces(p->s, e, p->image))
        complain(p, e, p->image, leave_out ? "a corner is missing" : "a corner has moved");
    mpq_clear(by);
    fmb_evidence_free(e);
    return true;
}

/* Another system, of which the proof would have to be one: its projection is another one if a point
 * of the old one goes, which is what the new row says. */
static bool cut_system(proved *p)
{
    size_t i = any_claim(p, FMB_CLAIM_CORNER);
    if (!p->bounded || p->strict || i == SIZE_MAX || fmb_system_rows(p->image) == 0)
        return false;
    dense d = dense_of(p->s);
    int row = support_between(&p->g, 0, d.rows - 1);
    mpq_t t;
    mpq_init(t);
    mpq_set_si(t, 1, (unsigned)(1 + any(p, 4)));
    mpq_sub(dense_rhs(&d, row), dense_rhs(&d, row), t);
    fmb_system *s = dense_system(&d), *image = NULL;
    fmb_solver *v = NULL;
    fmb_options o = {.size = sizeof o};
    fmb_result r = {.size = sizeof r};
    int keep[] = {0, 1, 2, 3};
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_project(v, s, keep, fmb_system_dim(p->image), &image, &r));
    fmb_evidence *now = NULL;
    must(fmb_solver_evidence(v, &now));
    bool meets = false; /* the old rows, of the new system, all needed */
    must(fmb_evidence_meets(now, s, FMB_DEMAND_PROJECTION, p->image, &meets, NULL, 0));
    bool same = meets && fmb_system_rows(image) == fmb_system_rows(p->image);
    if (convinces(s, p->e, p->image) && !same)
        complain(p, p->e, image, "the proof is of another system");
    fmb_evidence_free(now);
    fmb_solver_free(v);
    fmb_system_free(s);
    fmb_system_free(image);
    mpq_clear(t);
    dense_free(&d);
    return true;
}

static void change(uint64_t first, int wanted)
{
    static bool (*const changes[])(proved * p) = {leave_facet_out, add_row, move_corner,
                                                  move_corner, cut_system};
    int changed = 0;
    for (uint64_t seed = first; changed < wanted; seed++) {
        proved p = prove(seed, FMB_METHOD_AUTO);
        for (int k = 0; k < 50; k++)
            changed += changes[any(&p, k % 10 == 0 ? 5 : 4)](&p);
        forget(&p);
    }
}

/* Together 10,000. */
Test(whole, changes_1)
{
    change(1000, 2500 / WATCHED);
}

Test(whole, changes_2)
{
    change(2000, 2500 / WATCHED);
}

Test(whole, changes_3)
{
    change(3000, 2500 / WATCHED);
}

Test(whole, changes_4)
{
    change(4000, 2500 / WATCHED);
}

/* The number modulo which the judge first looks at values (num/residue.h): these are 0 there, and
 * not 0, and corners prove what they should. */
Test(whole, values_that_are_multiples_of_the_prime)
{
    const int64_t prime = 536870909, row[][3] = {{-1, 0, 0}, {1, 0, 0}, {1, -1, 0}, {-1, 1, 1}};
    const int64_t right[] = {0, prime, 0, 2 * prime};
    const int keep[] = {0, 1};
    for (int k = 0; k < 2; k++) {
        const fmb_method method = k > 0 ? FMB_METHOD_DD : FMB_METHOD_HULL;
        size_t corners = 0;
        proved p = {.s = NULL};
        fmb_options o = {.size = sizeof o, .evidence = FMB_EVIDENCE_WHOLE, .method = method};
        fmb_result r = {.size = sizeof r};
        fmb_solver *v = NULL;
        must(fmb_system_new(3, NULL, &p.s));
        for (int i = 0; i < 4; i++)
            must(fmb_system_add_int(p.s, row[i], FMB_LE, right[i]));
        must(fmb_system_add_int(p.s, (int64_t[]){0, 0, -1}, FMB_LE, -prime));
        must(fmb_solver_new(&o, NULL, &v));
        must(fmb_project(v, p.s, keep, 2, &p.image, &r));
        must(fmb_solver_evidence(v, &p.e));
        cr_expect(convinces(p.s, p.e, p.image), "method %d", method);
        for (size_t i = 0; i < fmb_evidence_claims(p.e); i++)
            corners += fmb_evidence_kind(p.e, i) == FMB_CLAIM_CORNER;
        cr_expect_eq(corners, 4, "method %d: %zu corners", method, corners);
        fmb_solver_free(v);
        forget(&p);
    }
}

/* The cube of n variables, seen along one more that one of them bounds: with all its corners. */
static fmb_stats prove_cube(int n)
{
    dense d = dense_new(n + 1, 2 * n + 3);
    for (int i = 0; i < 2 * n + 2; i++) {
        mpq_set_si(dense_row(&d, i)[i / 2], i % 2 ? 1 : -1, 1);
        mpq_set_si(dense_rhs(&d, i), i % 2, 1);
    }
    mpq_set_si(dense_row(&d, 2 * n + 2)[n], 1, 1);
    mpq_set_si(dense_row(&d, 2 * n + 2)[0], -1, 1);
    mpq_set_si(dense_rhs(&d, 2 * n + 2), 1, 1);
    fmb_system *s = dense_system(&d), *image = NULL;
    fmb_evidence *e = NULL;
    fmb_solver *v = NULL;
    fmb_options o = {.size = sizeof o, .evidence = FMB_EVIDENCE_WHOLE};
    fmb_result r = {.size = sizeof r};
    int keep[40];
    for (int k = 0; k < n; k++)
        keep[k] = k;
    dense_free(&d);
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_project(v, s, keep, n, &image, &r));
    must(fmb_solver_evidence(v, &e));
    cr_expect(convinces(s, e, image), "%d", n);
    fmb_evidence_free(e);
    fmb_system_free(image);
    fmb_system_free(s);
    fmb_solver_free(v);
    return r.stats;
}

/* A cube of one dimension more has twice the corners: proving it whole takes hardly more linear
 * programs and memory. */
Test(whole, cubes)
{
    fmb_stats before = prove_cube(9);
    for (int n = 10; n <= 40; n++) {
        fmb_stats now = prove_cube(n);
        cr_expect_leq(now.lps, before.lps + 16, "%d: %llu programs after %llu", n,
                      (unsigned long long)now.lps, (unsigned long long)before.lps);
        cr_expect_leq(now.bytes_peak, 3 * before.bytes_peak, "%d: %zu bytes after %zu", n,
                      now.bytes_peak, before.bytes_peak);
        before = now;
    }
}
