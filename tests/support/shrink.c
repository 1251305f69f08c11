/* shrink.c: shrinks a failing system and prints it; see support.h. */
#include "dense.h"

typedef struct hunt {
    dense now; /* fails */
    support_predicate fails;
    void *self;
} hunt;

/* Keep the candidate, which is consumed, if it still fails. */
static bool try(hunt *h, dense candidate)
{
    fmb_system *s = dense_system(&candidate);
    bool fails = h->fails(h->self, s);
    fmb_system_free(s);
    dense worse = fails ? h->now : candidate;
    if (fails)
        h->now = candidate;
    dense_free(&worse);
    return fails;
}

static bool drop_rows(hunt *h)
{
    bool progress = false;
    for (int i = h->now.rows - 1; i >= 0; i--)
        progress |= try(h, dense_without(&h->now, i, -1));
    return progress;
}

static bool drop_variables(hunt *h)
{
    bool progress = false;
    for (int j = h->now.dim - 1; j >= 0; j--)
        progress |= try(h, dense_without(&h->now, -1, j));
    return progress;
}

static bool simplify_relations(hunt *h)
{
    bool progress = false;
    for (int i = 0; i < h->now.rows; i++) {
        if (h->now.rel[i] == FMB_LE)
            continue;
        dense candidate = dense_without(&h->now, -1, -1);
        candidate.rel[i] = FMB_LE;
        progress |= try(h, candidate);
    }
    return progress;
}

/* The n-th candidate simpler than q: 0, its sign, its integer part, half of that, that less one.
 * False if it is not simpler. */
static bool simpler(mpq_t q, int n)
{
    mpz_t whole;
    int sign = mpq_sgn(q);
    bool was_whole = mpz_cmp_ui(mpq_denref(q), 1) == 0;
    mpz_init(whole);
    mpz_tdiv_q(whole, mpq_numref(q), mpq_denref(q));
    bool above_one = mpz_cmpabs_ui(whole, 1) > 0;
    if (n == 0)
        mpz_set_ui(whole, 0);
    else if (n == 1)
        mpz_set_si(whole, sign);
    else if (n == 3)
        mpz_tdiv_q_ui(whole, whole, 2);
    else if (n == 4 && sign > 0)
        mpz_sub_ui(whole, whole, 1);
    else if (n == 4)
        mpz_add_ui(whole, whole, 1);
    mpq_set_z(q, whole);
    mpz_clear(whole);
    return n == 0 ? sign != 0 : n == 2 ? !was_whole : above_one || (n == 1 && !was_whole);
}

static bool simplify_numbers(hunt *h)
{
    bool progress = false;
    for (int i = 0; i < h->now.rows; i++)
        for (int j = 0; j <= h->now.dim; j++)
            for (int n = 0; n < 5; n++) {
                dense candidate = dense_without(&h->now, -1, -1);
                if (simpler(dense_row(&candidate, i)[j], n))
                    progress |= try(h, candidate);
                else
                    dense_free(&candidate);
            }
    return progress;
}

fmb_system *support_shrink(const fmb_system *s, support_predicate fails, void *self)
{
    hunt h = {dense_of(s), fails, self};
    while (drop_rows(&h) || drop_variables(&h) || simplify_relations(&h) || simplify_numbers(&h))
        continue;
    fmb_system *small = dense_system(&h.now);
    dense_free(&h.now);
    return small;
}

/* ---- printing -------------------------------------------------------------------------------- */

static void print_row(const fmb_system *s, size_t i, FILE *out)
{
    static const char *const rel[] = {[FMB_LE] = "<=", [FMB_LT] = "<", [FMB_EQ] = "="};
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int var = fmb_system_term_q(s, i, k, q);
        fputs(mpq_sgn(q) < 0 ? (k > 0 ? " - " : "-") : (k > 0 ? " + " : ""), out);
        mpq_abs(q, q);
        if (mpq_cmp_ui(q, 1, 1) != 0)
            gmp_fprintf(out, "%Qd ", q);
        fputs(fmb_system_name(s, var), out);
    }
    fmb_system_rhs_q(s, i, q);
    gmp_fprintf(out, "%s %s %Qd\n", fmb_system_terms(s, i) == 0 ? "0" : "",
                rel[fmb_system_rel(s, i)], q);
    mpq_clear(q);
}

void support_print(const fmb_system *s, const char *comment, FILE *out)
{
    if (comment)
        fprintf(out, "# %s\n", comment);
    fputs("vars:", out);
    for (int j = 0; j < fmb_system_dim(s); j++)
        fprintf(out, " %s", fmb_system_name(s, j));
    fputc('\n', out);
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        print_row(s, i, out);
}

void support_report(const support_case *c, support_predicate fails, void *self)
{
    char comment[160];
    snprintf(comment, sizeof comment, "%s, seed %llu, %d variables, %d rows, bits %d; shrunken:",
             support_family_name(c->family), (unsigned long long)c->seed, c->shape.dim,
             c->shape.rows, c->shape.bits);
    fmb_system *small = support_shrink(c->s, fails, self);
    support_print(small, comment, stderr);
    fmb_system_free(small);
}
