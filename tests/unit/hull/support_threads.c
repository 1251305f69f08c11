/* support_threads.c: support queries by several threads find the same, in the same order, as by any
 * other number of them, and the facets that one thread finds; whatever ends them, all is given
 * back. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "hull/support/support.h"
#include "support/support.h"

enum { COLUMNS = 8, ROWS = 22, KEPT = 4 };

/* After so many allocations one fails, or the query is cancelled. */
typedef struct ending {
    atomic_long left, held; /* held: [bytes] */
    atomic_int *cancel;     /* NULL: the allocation fails */
} ending;

typedef struct bench {
    ending at;
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_program p;
    fmb_oracle *o;
    fmb_support s;
} bench;

static void *resize_until(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    ending *e = self;
    void *q = NULL;
    bool now = new_bytes > 0 && atomic_fetch_sub(&e->left, 1) == 1;
    if (now && e->cancel)
        atomic_store(e->cancel, 1);
    if (new_bytes == 0)
        free(p);
    else if ((now && !e->cancel) || !(q = realloc(p, new_bytes)))
        return NULL;
    e->held += (long)new_bytes - (long)old_bytes;
    return q;
}

/* Rows of all terms around the origin, with numbers of so many bits; if bits < 0, of none, and some
 * rows are strict. */
static void write_rows(bench *b, uint64_t seed, int bits)
{
    support_rng g = {seed};
    mpz_t z[COLUMNS + 1];
    for (int j = 0; j <= COLUMNS; j++)
        mpz_init(z[j]);
    for (int i = 0; i < ROWS; i++) {
        for (int j = 0; j <= COLUMNS; j++) {
            int low = j < COLUMNS ? -9 : 5, high = j < COLUMNS ? 9 : 60;
            mpz_set_si(z[j], support_between(&g, low, high));
            mpz_mul_2exp(z[j], z[j], (mp_bitcnt_t)(bits > 0 ? bits : 0));
            mpz_add_ui(z[j], z[j], (unsigned long)support_between(&g, 0, bits > 0));
        }
        cr_assert_eq(fmb_program_add_integers(&b->p, z, bits < 0 && i % 4 == 0 ? FMB_LT : FMB_LE),
                     FMB_OK);
    }
    for (int j = 0; j <= COLUMNS; j++)
        mpz_clear(z[j]);
}

static void open_bench(bench *b, size_t threads, uint64_t seed, int bits)
{
    static const int kept[KEPT] = {0, 1, 2, 3};
    fmb_options o = {.size = sizeof o, .threads = threads};
    bool feasible;
    *b = (bench){.at.left = 0};
    fmb_mem_init(&b->mem, &(fmb_alloc){resize_until, &b->at}, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    fmb_program_init(&b->p, &b->mem, COLUMNS);
    write_rows(b, seed, bits);
    cr_assert_eq(fmb_oracle_new(&b->run, &b->p, &b->o), FMB_OK);
    cr_assert_eq(fmb_oracle_feasible(b->o, &feasible), FMB_OK);
    cr_assert(feasible);
    cr_assert_eq(fmb_support_init(&b->s, &b->run, b->o, COLUMNS, kept, KEPT, bits < 0, true),
                 FMB_OK);
    if (threads > 1)
        cr_assert_eq(fmb_support_hire(&b->s, &b->p), FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_support_clear(&b->s);
    fmb_oracle_free(b->o);
    fmb_program_clear(&b->p);
    cr_assert_eq(b->mem.used, 0);
    cr_assert_eq(b->at.held, 0);
}

static void ask_all(bench *b, uint64_t pairs)
{
    bool done = false;
    while (!done)
        cr_assert_eq(fmb_support_ask(&b->s, pairs, &done), FMB_OK);
    cr_assert_gt(b->s.rows, 64, "too few to try threads");
}

static int compare_rows(const void *a, const void *b)
{
    const fmb_support_row *x = a, *y = b;
    int sign = 0;
    for (size_t k = 0; sign == 0 && k <= KEPT; k++)
        sign = mpz_cmp(x->z.z[k], y->z.z[k]);
    return sign != 0 ? sign : (int)x->rel - (int)y->rel;
}

static void check_same_rows(const bench *a, const bench *b, bool proofs)
{
    cr_assert_eq(a->s.rows, b->s.rows);
    for (size_t i = 0; i < a->s.rows; i++) {
        const fmb_weights *v = &a->s.row[i].proof, *w = &b->s.row[i].proof;
        cr_assert_eq(compare_rows(&a->s.row[i], &b->s.row[i]), 0, "row %zu", i);
        cr_assert(!proofs || v->size == w->size);
        for (size_t k = 0; proofs && k < v->size; k++) {
            cr_assert_eq(v->index[k], w->index[k]);
            cr_assert(mpq_equal(v->value[k], w->value[k]));
        }
    }
}

static void sort_rows(bench *b)
{
    qsort(b->s.row, b->s.rows, sizeof *b->s.row, compare_rows);
}

static void check_threads(uint64_t seed, int bits, uint64_t pairs)
{
    static bench one, two, more;
    open_bench(&one, 1, seed, bits);
    open_bench(&two, 2, seed, bits);
    ask_all(&one, 0);
    ask_all(&two, pairs);
    for (size_t threads = 3; threads <= 7; threads += 4) {
        open_bench(&more, threads, seed, bits);
        ask_all(&more, pairs);
        check_same_rows(&two, &more, true);
        close_bench(&more);
    }
    sort_rows(&one);
    sort_rows(&two);
    check_same_rows(&one, &two, false);
    close_bench(&one);
    close_bench(&two);
}

Test(support_threads, the_same_by_any_number)
{
    check_threads(1, 0, 0);
    check_threads(2, 0, 5000);
    check_threads(3, 20, 0);
    check_threads(4, 70, 1000);
    check_threads(5, -1, 0);
}

/* ---- cut short ------------------------------------------------------------------------------- */

static fmb_status ask_until_it_ends(bench *b)
{
    bool done = false;
    fmb_status st = fmb_support_ask(&b->s, 0, &done);
    cr_assert(st != FMB_OK || done);
    return st;
}

Test(support_threads, little_memory)
{
    static bench b;
    fmb_status st = FMB_LIMIT;
    for (size_t bytes = 1 << 16; st == FMB_LIMIT; bytes += bytes / 2) {
        open_bench(&b, 3, 5, 0);
        b.mem.limit = b.mem.used + bytes;
        st = ask_until_it_ends(&b);
        cr_assert(st == FMB_LIMIT || st == FMB_OK);
        cr_assert_eq(b.mem.limit > 0, true);
        close_bench(&b);
    }
}

Test(support_threads, failing_allocations)
{
    static bench b;
    fmb_status st = FMB_ERR_MEMORY;
    for (long k = 1; st != FMB_OK; k += 1 + k / 2) {
        open_bench(&b, 3, 6, 0);
        b.at.left = k;
        st = ask_until_it_ends(&b);
        cr_assert(st == FMB_ERR_MEMORY || (st == FMB_OK && b.at.left > 0));
        close_bench(&b);
    }
}

Test(support_threads, cancelled)
{
    static bench b;
    fmb_status st = FMB_LIMIT;
    for (long k = 1; st != FMB_OK; k += 1 + k / 2) {
        open_bench(&b, 2, 7, 0);
        b.at.cancel = &b.cancel;
        b.at.left = k;
        st = ask_until_it_ends(&b);
        cr_assert(st == FMB_LIMIT ? b.run.stop == FMB_STOP_CANCELLED : st == FMB_OK);
        close_bench(&b);
    }
}
