/* fuzz_solve.c: any bytes are a small system, a way to solve and a question; the answer must agree
 * with the ground truth and its evidence be accepted.
 *
 * Byte 0: variables; 1: way to solve; 2: question; 3: variables kept. Then rows: a byte whose low
 * bits choose the relation and whose high bits how wide the numbers are, one byte for each
 * coefficient and the right side. What is missing is 0.
 */
#include "property/random/agree.h"
#include "property/random/options.h"
#include "round.h"

#include <stdlib.h>

enum { MOST_VARIABLES = 4, MOST_ROWS = 8, TRUTH_ROWS = 1000 };

/* Widths: numbers are byte * 2^shift + byte. */
static const unsigned SHIFT[] = {0, 0, 0, 24, 46, 56, 57, 193};

typedef struct input {
    const uint8_t *at, *end;
} input;

static int take(input *in)
{
    return in->at < in->end ? *in->at++ : 0;
}

static void number(input *in, unsigned shift, mpq_t q)
{
    int byte = take(in);
    int value = byte < 128 ? byte : byte - 256;
    mpz_set_si(mpq_denref(q), 1);
    mpz_set_si(mpq_numref(q), value);
    if (shift > 0) {
        mpz_mul_2exp(mpq_numref(q), mpq_numref(q), shift);
        mpz_set_si(mpq_denref(q), 1 + (byte & 3));
        mpq_canonicalize(q);
        if (byte & 4)
            mpz_add(mpq_numref(q), mpq_numref(q), mpq_denref(q));
    }
}

static void add_row(input *in, fmb_system *s)
{
    static const fmb_rel rel[] = {FMB_LE, FMB_LE, FMB_LT, FMB_EQ};
    int var[MOST_VARIABLES], dim = fmb_system_dim(s), how = take(in);
    mpq_t coef[MOST_VARIABLES], rhs;
    for (int j = 0; j < MOST_VARIABLES; j++) {
        mpq_init(coef[j]);
        var[j] = j;
        if (j < dim)
            number(in, SHIFT[how >> 5], coef[j]);
    }
    mpq_init(rhs);
    number(in, SHIFT[how >> 5], rhs);
    must(fmb_system_add_q(s, (size_t)dim, var, coef, rel[how & 3], rhs));
    for (int j = 0; j < MOST_VARIABLES; j++)
        mpq_clear(coef[j]);
    mpq_clear(rhs);
}

static bool ask(int question, int kept, agree *g, fmb_solver *v, const truth *t)
{
    int keep[MOST_VARIABLES], n = 0;
    for (int j = 0; j < fmb_system_dim(t->s); j++)
        if (kept >> j & 1)
            keep[n++] = j;
    switch (question % 5) {
    case 0:
        return agree_solve(g, v, t);
    case 1:
        return agree_bound(g, v, t);
    case 2:
        return agree_project(g, v, t, keep, n, NULL);
    case 3:
        return agree_reduce(g, v, t, NULL);
    default:
        return agree_optimize(g, v, t, (uint64_t)kept);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, data + size};
    int dim = take(&in) % (MOST_VARIABLES + 1);
    fmb_options o = options_at(take(&in) % options_count());
    int question = take(&in), kept = take(&in);
    fmb_system *s = rows_none(dim);
    for (int i = 0; i < MOST_ROWS && in.at < in.end; i++)
        add_row(&in, s);
    agree g = {.max_rows = TRUTH_ROWS};
    fmb_solver *v = NULL;
    truth t;
    o.max_rows = 100000;
    o.max_bytes = (size_t)1 << 28;
    must(fmb_solver_new(&o, NULL, &v));
    truth_init(&t, s, g.max_rows);
    if (!ask(question, kept, &g, v, &t)) {
        fprintf(stderr, "disagreement: %s\n", g.why);
        rows_print(s, stderr);
        abort();
    }
    truth_clear(&t);
    fmb_solver_free(v);
    fmb_system_free(s);
    return 0;
}
