/* mutate.c: no mutation of right evidence is accepted wrongly.
 *
 * Proofs of the solver and of the table in samples.c are changed, a number, a name or a relation at
 * a time, in the evidence or in the system; then fmb_check must say what the naive judge says, and
 * never prove a verdict that the ground truth denies.
 */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/solve.h>

#include "dense.h"
#include "exact/exact.h"
#include "naive.h"
#include "samples.h"

typedef struct subject {
    support_rng g;
    fmb_system *s;
    fmb_evidence *e;
} subject;

/* ---- mutations: each returns false if there was nothing to change ---------------------------- */

static void change_number(support_rng *g, mpq_t q)
{
    mpq_t by;
    mpq_init(by);
    mpq_set_si(by, support_between(g, -3, 3), (unsigned)support_between(g, 1, 3));
    mpq_canonicalize(by);
    switch (support_between(g, 0, 3)) {
    case 0:
        mpq_neg(q, q);
        break;
    case 1:
        mpq_set(q, by);
        break;
    case 2:
        mpq_mul(q, q, by);
        break;
    default:
        mpq_add(q, q, by);
    }
    mpq_clear(by);
}

static size_t any(support_rng *g, size_t n)
{
    return (size_t)(support_next(g) % n);
}

static fmb_claim *any_claim(subject *u)
{
    return &u->e->claim[any(&u->g, u->e->claims)];
}

static bool change_list_value(subject *u, fmb_sparse *list)
{
    if (list->size > 0)
        change_number(&u->g, list->value[any(&u->g, list->size)]);
    return list->size > 0;
}

static bool change_multiplier(subject *u)
{
    return change_list_value(u, &any_claim(u)->multipliers);
}

static bool change_reverse(subject *u)
{
    return change_list_value(u, &any_claim(u)->reverse);
}

static bool change_term(subject *u)
{
    return change_list_value(u, &any_claim(u)->terms);
}

/* A multiplier moves to another row, perhaps one that there is not. */
static bool rename_multiplier(subject *u)
{
    fmb_sparse *list = &any_claim(u)->multipliers;
    if (list->size > 0)
        list->index[any(&u->g, list->size)] = any(&u->g, u->e->rows + 1);
    return list->size > 0;
}

static bool add_multiplier(subject *u)
{
    mpq_t q;
    mpq_init(q);
    change_number(&u->g, q);
    fmb_status st =
        fmb_evidence_push(u->e, &any_claim(u)->multipliers, any(&u->g, u->e->rows + 1), q);
    mpq_clear(q);
    return st == FMB_OK;
}

static bool drop_multiplier(subject *u)
{
    fmb_sparse *list = &any_claim(u)->multipliers;
    if (list->size == 0)
        return false;
    mpq_clear(list->value[--list->size]);
    return true;
}

static bool change_vector(subject *u, mpq_t *vector)
{
    if (vector && u->e->dim > 0)
        change_number(&u->g, vector[any(&u->g, (size_t)u->e->dim)]);
    return vector && u->e->dim > 0;
}

static bool change_point(subject *u)
{
    return change_vector(u, any_claim(u)->point);
}

static bool change_ray(subject *u)
{
    return change_vector(u, any_claim(u)->ray);
}

static bool swap_point_and_ray(subject *u)
{
    fmb_claim *c = any_claim(u);
    mpq_t *point = c->point;
    c->point = c->ray;
    c->ray = point;
    return c->point || c->ray;
}

static bool is_inequality(const fmb_claim *c)
{
    return c->kind == FMB_CLAIM_BOUND || c->kind == FMB_CLAIM_IMPLIED;
}

static bool is_end(const fmb_claim *c)
{
    return c->kind == FMB_CLAIM_BOUND || c->kind == FMB_CLAIM_UNBOUNDED;
}

static bool change_value(subject *u)
{
    fmb_claim *c = any_claim(u);
    if (is_inequality(c))
        change_number(&u->g, c->value);
    return is_inequality(c);
}

static bool change_kind(subject *u)
{
    any_claim(u)->kind =
        (fmb_claim_kind)support_between(&u->g, FMB_CLAIM_NONE, FMB_CLAIM_IRREDUNDANT);
    return true;
}

static bool change_claim_relation(subject *u)
{
    fmb_claim *c = any_claim(u);
    c->rel = (fmb_rel)support_between(&u->g, FMB_LE, FMB_EQ);
    return is_inequality(c);
}

static bool change_side(subject *u)
{
    fmb_claim *c = any_claim(u);
    c->side = c->side == FMB_UPPER ? FMB_LOWER : FMB_UPPER;
    return is_end(c);
}

static bool change_row(subject *u)
{
    fmb_claim *c = any_claim(u);
    c->row = any(&u->g, u->e->rows + 1);
    return !is_end(c) && !is_inequality(c);
}

static bool change_variable(subject *u)
{
    fmb_claim *c = any_claim(u);
    c->var = support_between(&u->g, -1, u->e->dim);
    return is_end(c);
}

static bool drop_claim(subject *u)
{
    fmb_evidence_drop_last(u->e);
    return u->e->claims > 0;
}

static bool swap_claims(subject *u)
{
    fmb_claim *a = any_claim(u), *b = any_claim(u), keep = *a;
    *a = *b;
    *b = keep;
    return a != b;
}

/* The system, changed through a table of its numbers. */
static bool change_system(subject *u, void (*change)(support_rng *g, dense *d))
{
    dense d = dense_of(u->s);
    if (d.rows > 0)
        change(&u->g, &d);
    fmb_system_free(u->s);
    u->s = dense_system(&d);
    dense_free(&d);
    return d.rows > 0;
}

static int any_row(support_rng *g, const dense *d)
{
    return support_between(g, 0, d->rows - 1);
}

static void number_in_system(support_rng *g, dense *d)
{
    change_number(g, dense_row(d, any_row(g, d))[support_between(g, 0, d->dim)]);
}

static void relation_in_system(support_rng *g, dense *d)
{
    d->rel[any_row(g, d)] = (fmb_rel)support_between(g, FMB_LE, FMB_EQ);
}

static void rows_in_system(support_rng *g, dense *d)
{
    dense_swap(d, any_row(g, d), any_row(g, d));
}

static bool change_system_number(subject *u)
{
    return change_system(u, number_in_system);
}

static bool change_system_relation(subject *u)
{
    return change_system(u, relation_in_system);
}

static bool swap_system_rows(subject *u)
{
    return change_system(u, rows_in_system);
}

static bool (*const MUTATION[])(subject *u) = {change_multiplier,
                                               change_multiplier,
                                               change_reverse,
                                               change_term,
                                               rename_multiplier,
                                               add_multiplier,
                                               drop_multiplier,
                                               change_point,
                                               change_point,
                                               change_ray,
                                               swap_point_and_ray,
                                               change_value,
                                               change_claim_relation,
                                               change_side,
                                               change_row,
                                               change_variable,
                                               drop_claim,
                                               swap_claims,
                                               change_system_number,
                                               change_system_number,
                                               change_system_number,
                                               change_kind,
                                               swap_system_rows,
                                               change_system_relation};

enum { MUTATIONS = sizeof MUTATION / sizeof *MUTATION };

/* ---- judging --------------------------------------------------------------------------------- */

typedef struct tally {
    int judged, accepted;
    int by_kind[FMB_CLAIM_IRREDUNDANT + 1]; /* rejected for a claim of that kind */
} tally;

static void judge(const fmb_system *s, const fmb_evidence *e, const char *what, tally *t)
{
    fmb_judgement j = {0};
    fmb_verdict truth = FMB_UNKNOWN;
    cr_assert_eq(fmb_check(s, e, &j), FMB_OK);
    size_t failing = naive_first_failing(s, e);
    if (j.claim != failing || j.accepted != (failing == SIZE_MAX && e->claims > 0)) {
        support_print(s, what, stderr);
        (void)!fmb_evidence_write(e, s, stderr);
        cr_assert_fail("%s: claim %zu fails (%s), but %zu for the naive judge", what, j.claim,
                       j.reason, failing);
    }
    if (j.verdict != FMB_UNKNOWN) {
        cr_assert_eq(fmb_exact_solve(s, 5000, &truth), FMB_OK);
        cr_assert(truth == FMB_UNKNOWN || truth == j.verdict, "%s: proves what is not", what);
    }
    t->judged++;
    t->accepted += j.accepted;
    if (!j.accepted && failing < e->claims && e->claim[failing].kind <= FMB_CLAIM_IRREDUNDANT)
        t->by_kind[e->claim[failing].kind]++;
}

/* Change copies of s and e so many times, one to three changes each, and judge them. */
static void mutate(const fmb_system *s, const fmb_evidence *e, uint64_t seed, int times, tally *t)
{
    char what[64];
    subject u = {.g = {seed}};
    for (int k = 0; k < times; k++) {
        support_must(fmb_system_copy(s, &u.s));
        support_must(fmb_evidence_copy(e, &u.e));
        snprintf(what, sizeof what, "seed %llu, mutation %d", (unsigned long long)seed, k);
        int changes = 0, wanted = support_chance(&u.g, 80) ? 1 : support_between(&u.g, 2, 3);
        while (changes < wanted && u.e->claims > 0)
            changes += MUTATION[any(&u.g, MUTATIONS)](&u);
        judge(u.s, u.e, what, t);
        fmb_evidence_free(u.e);
        fmb_system_free(u.s);
    }
}

/* ---- the tests ------------------------------------------------------------------------------- */

Test(mutate, samples)
{
    tally t = {0};
    for (size_t i = 0; i < proof_samples_count; i++) {
        fmb_system *s = proof_system(proof_samples[i].system, NULL);
        fmb_evidence *e = proof_claims(s, proof_samples[i].claims);
        if (fmb_evidence_claims(e) > 0)
            mutate(s, e, i, 60, &t);
        fmb_evidence_free(e);
        fmb_system_free(s);
    }
    cr_expect_geq(t.judged, 4000);
    cr_expect_geq(t.accepted, 200);
    for (fmb_claim_kind kind = FMB_CLAIM_FEASIBLE; kind <= FMB_CLAIM_IRREDUNDANT; kind++)
        cr_expect_geq(t.by_kind[kind], 50, "kind %d", kind);
}

/* Ask question number which; the evidence, or NULL. */
static fmb_evidence *ask(fmb_solver *v, const fmb_system *s, int which)
{
    fmb_result r;
    fmb_box *box = NULL;
    fmb_system *out = NULL;
    fmb_evidence *e = NULL;
    int keep[] = {0};
    support_must(which == 0   ? fmb_solve(v, s, &r)
                 : which == 1 ? fmb_bound(v, s, NULL, 0, &box, &r)
                 : which == 2 ? fmb_reduce(v, s, NULL, &out, &r)
                              : fmb_project(v, s, keep, 1, &out, &r));
    support_must(fmb_solver_evidence(v, &e));
    fmb_box_free(box);
    fmb_system_free(out);
    return e;
}

Test(mutate, proofs_of_the_solver, .timeout = 600)
{
    tally right = {0}, t = {0};
    fmb_options o = fmb_options_default();
    fmb_solver *v = NULL;
    o.evidence = true;
    support_must(fmb_solver_new(&o, NULL, &v));
    for (uint64_t seed = 0; t.judged < 30000; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_case c = support_make(family, seed, NULL);
            fmb_evidence *e = ask(v, c.s, (int)(seed % 4));
            if (fmb_evidence_claims(e) > 0) {
                judge(c.s, e, "as the solver made it", &right);
                mutate(c.s, e, seed * SUPPORT_FAMILIES + family, 10, &t);
            }
            fmb_evidence_free(e);
            support_case_clear(&c);
        }
    fmb_solver_free(v);
    cr_expect_eq(right.accepted, right.judged);
    cr_expect_geq(t.accepted, 300);
    cr_expect_geq(t.judged - t.accepted, 5000);
    for (fmb_claim_kind kind = FMB_CLAIM_FEASIBLE; kind <= FMB_CLAIM_IRREDUNDANT; kind++)
        cr_expect_geq(t.by_kind[kind], 100, "kind %d: %d", kind, t.by_kind[kind]);
}

/* One byte for another, mostly a digit for a digit. */
static void change_byte(support_rng *g, char *text)
{
    static const char bytes[] = "0123456789-/<>= \n\"#\\xyrowpointend";
    size_t length = strlen(text), at = any(g, length);
    bool digit = support_chance(g, 80);
    while (digit && !strchr("0123456789", text[at]))
        at = (at + 1) % length;
    text[at] = bytes[any(g, digit ? 10 : sizeof bytes - 1)];
}

/* Bytes of the text changed: refused by the reader, or judged as the naive judge does. */
Test(mutate, text)
{
    support_rng g = {7};
    int parsed = 0;
    for (int k = 0; k < 20000; k++) {
        const proof_sample *p = &proof_samples[any(&g, proof_samples_count)];
        fmb_system *s = proof_system(p->system, NULL);
        fmb_evidence *e = proof_claims(s, p->claims);
        char *text = proof_text(s, e);
        fmb_evidence_free(e);
        for (int n = support_between(&g, 1, 3); n > 0; n--)
            change_byte(&g, text);
        fmb_where where;
        fmb_status st = proof_parse(s, text, &e, &where);
        cr_assert(st == FMB_OK || (st == FMB_ERR_PARSE && where.line > 0 && where.column > 0));
        if (st == FMB_OK) {
            tally t = {0};
            judge(s, e, text, &t);
            fmb_evidence_free(e);
            parsed++;
        }
        free(text);
        fmb_system_free(s);
    }
    cr_expect_geq(parsed, 2000, "%d", parsed);
}
