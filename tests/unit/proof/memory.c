/* memory.c: the k-th allocation fails, for every k, while evidence is read and judged: the status
 * is MEMORY, out arguments are untouched, nothing leaks. */
#include <criterion/criterion.h>
#include <stdlib.h>

#include "fault/hook.h"
#include "samples.h"

/* What is done with a sample; *out is set on FMB_OK only. */
typedef fmb_status deed(const fmb_system *s, const fmb_evidence *e, const char *text, void **out);

static fmb_status do_read(const fmb_system *s, const fmb_evidence *e, const char *text, void **out)
{
    (void)e;
    fmb_evidence *made = NULL;
    fmb_status st = proof_parse(s, text, &made, NULL);
    if (made)
        *out = made;
    return st;
}

static fmb_status do_check(const fmb_system *s, const fmb_evidence *e, const char *text, void **out)
{
    static const fmb_judgement untouched = {.size = sizeof untouched, .claim = 12345};
    fmb_judgement j = untouched;
    (void)text, (void)out;
    fmb_status st = fmb_check(s, e, &j);
    cr_assert((st == FMB_OK) == (j.claim != 12345));
    return st;
}

/* The number of requests it takes. */
static size_t fail_each(hook *h, deed *act, const fmb_system *s, const fmb_evidence *e,
                        const char *text, bool forever)
{
    size_t before = h->live, k = 0;
    for (fmb_status st = FMB_ERR_MEMORY; st != FMB_OK;) {
        void *out = NULL;
        hook_arm(h, ++k, forever);
        st = act(s, e, text, &out);
        hook_calm(h);
        cr_assert(st == FMB_OK || (st == FMB_ERR_MEMORY && !out), "request %zu: %s", k,
                  fmb_status_text(st));
        fmb_evidence_free(out);
        cr_assert_eq(h->live, before, "request %zu leaks", k);
    }
    return k - 1;
}

static void every_sample(deed *act, size_t least)
{
    size_t requests = 0;
    for (size_t i = 0; i < proof_samples_count; i++) {
        hook h = {0};
        fmb_alloc mem = hook_alloc(&h);
        fmb_system *s = proof_system(proof_samples[i].system, &mem);
        fmb_evidence *e = proof_claims(s, proof_samples[i].claims);
        char *text = proof_text(s, e);
        requests += fail_each(&h, act, s, e, text, false);
        requests += fail_each(&h, act, s, e, text, true);
        free(text);
        fmb_evidence_free(e);
        fmb_system_free(s);
        cr_assert_eq(h.live, 0);
    }
    cr_assert_geq(requests, least * proof_samples_count, "%zu requests", requests);
}

Test(memory, read)
{
    every_sample(do_read, 8);
}

Test(memory, check)
{
    every_sample(do_check, 4);
}

/* Growing a list must not lose what is in it. */
Test(memory, push)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_evidence *e = NULL;
    fmb_claim *c = NULL;
    mpq_t q;
    mpq_init(q);
    cr_assert_eq(fmb_evidence_new(1, 1000, &mem, &e), FMB_OK);
    cr_assert_eq(fmb_evidence_claim(e, FMB_CLAIM_INFEASIBLE, &c), FMB_OK);
    for (size_t i = 0; i < 1000; i++) {
        mpq_set_ui(q, i + 1, 7);
        mpq_canonicalize(q);
        for (size_t k = 1; k <= 2; k++) {
            hook_arm(&h, k, true);
            if (fmb_evidence_push(e, &c->multipliers, i, q) == FMB_OK)
                break;
        }
        hook_calm(&h);
        if (c->multipliers.size == i)
            cr_assert_eq(fmb_evidence_push(e, &c->multipliers, i, q), FMB_OK);
        cr_assert_eq(c->multipliers.size, i + 1);
    }
    for (size_t i = 0; i < 1000; i++)
        cr_assert(mpq_cmp_ui(c->multipliers.value[i], i + 1, 7) == 0 &&
                  c->multipliers.index[i] == i);
    mpq_clear(q);
    fmb_evidence_free(e);
    cr_assert_eq(h.live, 0);
}
