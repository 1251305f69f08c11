/* support_cut_short.c: whatever ends support queries, all memory is freed. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "hull/support/support.h"
#include "support/support.h"

enum { COLUMNS = 8, ROWS = 22, KEPT = 4 };

/* After so many allocations one fails, or the query is cancelled. */
typedef struct ending {
    long left, held;    /* held: [bytes] */
    atomic_int *cancel; /* NULL: the allocation fails */
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
    bool now = new_bytes > 0 && e->left-- == 1;
    if (now && e->cancel)
        atomic_store(e->cancel, 1);
    if (new_bytes == 0)
        free(p);
    else if ((now && !e->cancel) || !(q = realloc(p, new_bytes)))
        return NULL;
    e->held += (long)new_bytes - (long)old_bytes;
    return q;
}

/* Rows of all terms around the origin. */
static void write_rows(bench *b, uint64_t seed)
{
    support_rng g = {seed};
    mpz_t z[COLUMNS + 1];
    for (int j = 0; j <= COLUMNS; j++)
        mpz_init(z[j]);
    for (int i = 0; i < ROWS; i++) {
        for (int j = 0; j < COLUMNS; j++)
            mpz_set_si(z[j], support_between(&g, -9, 9));
        mpz_set_si(z[COLUMNS], support_between(&g, 5, 60));
        cr_assert_eq(fmb_program_add_integers(&b->p, z, FMB_LE), FMB_OK);
    }
    for (int j = 0; j <= COLUMNS; j++)
        mpz_clear(z[j]);
}

static void open_bench(bench *b, uint64_t seed)
{
    static const int kept[KEPT] = {0, 1, 2, 3};
    fmb_options o = {.size = sizeof o};
    bool feasible;
    *b = (bench){.at.left = 0};
    fmb_mem_init(&b->mem, &(fmb_alloc){resize_until, &b->at}, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    fmb_program_init(&b->p, &b->mem, COLUMNS);
    write_rows(b, seed);
    cr_assert_eq(fmb_oracle_new(&b->run, &b->p, &b->o), FMB_OK);
    cr_assert_eq(fmb_oracle_feasible(b->o, &feasible), FMB_OK);
    cr_assert(feasible);
    cr_assert_eq(fmb_support_init(&b->s, &b->run, b->o, COLUMNS, kept, KEPT, false, true), FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_support_clear(&b->s);
    fmb_oracle_free(b->o);
    fmb_program_clear(&b->p);
    cr_assert_eq(b->mem.used, 0);
    cr_assert_eq(b->at.held, 0);
}

static fmb_status ask_until_it_ends(bench *b)
{
    bool done = false;
    fmb_status st = fmb_support_ask(&b->s, 0, &done);
    cr_assert(st != FMB_OK || done);
    return st;
}

Test(support_cut_short, little_memory)
{
    static bench b;
    fmb_status st = FMB_LIMIT;
    for (size_t bytes = 1 << 16; st == FMB_LIMIT; bytes += bytes / 2) {
        open_bench(&b, 5);
        b.mem.limit = b.mem.used + bytes;
        st = ask_until_it_ends(&b);
        cr_assert(st == FMB_LIMIT || st == FMB_OK);
        cr_assert_eq(b.mem.limit > 0, true);
        close_bench(&b);
    }
}

Test(support_cut_short, failing_allocations)
{
    static bench b;
    fmb_status st = FMB_ERR_MEMORY;
    for (long k = 1; st != FMB_OK; k += 1 + k / 2) {
        open_bench(&b, 6);
        b.at.left = k;
        st = ask_until_it_ends(&b);
        cr_assert(st == FMB_ERR_MEMORY || (st == FMB_OK && b.at.left > 0));
        close_bench(&b);
    }
}

Test(support_cut_short, cancelled)
{
    static bench b;
    fmb_status st = FMB_LIMIT;
    for (long k = 1; st != FMB_OK; k += 1 + k / 2) {
        open_bench(&b, 7);
        b.at.cancel = &b.cancel;
        b.at.left = k;
        st = ask_until_it_ends(&b);
        cr_assert(st == FMB_LIMIT ? b.run.stop == FMB_STOP_CANCELLED : st == FMB_OK);
        close_bench(&b);
    }
}
