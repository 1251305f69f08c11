/* memory.c: the allocator counts and obeys its limit; the arena does what it promises. */
#include <criterion/criterion.h>

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/arrays.h"

Test(mem, counts_what_is_alive)
{
    fmb_mem m;
    fmb_mem_init(&m, NULL, 0);
    char *p = fmb_mem_get(&m, 10, 3);
    cr_assert_eq(m.used, 30);
    p = fmb_mem_grow(&m, p, 10, 20, 3);
    cr_assert_eq(m.used, 60);
    p = fmb_mem_grow(&m, p, 20, 5, 3);
    cr_assert_eq(m.used, 15);
    fmb_mem_put(&m, p, 5, 3);
    cr_assert_eq(m.used, 0);
    cr_assert_eq(m.peak, 60);
}

Test(mem, limit_is_told_from_failure)
{
    fmb_mem m;
    fmb_mem_init(&m, NULL, 100);
    void *p = fmb_mem_get(&m, 60, 1);
    cr_assert_not_null(p);
    cr_assert_null(fmb_mem_get(&m, 41, 1));
    cr_assert_eq(fmb_mem_status(&m), FMB_LIMIT);
    cr_assert_null(fmb_mem_get(&m, SIZE_MAX, 2), "a product that overflows is no block");
    cr_assert_eq(fmb_mem_status(&m), FMB_ERR_MEMORY);
    void *q = fmb_mem_get(&m, 40, 1);
    cr_assert_not_null(q);
    cr_assert_not(fmb_mem_charge(&m, 1));
    fmb_mem_put(&m, q, 40, 1);
    cr_assert(fmb_mem_charge(&m, 40));
    fmb_mem_refund(&m, 40);
    fmb_mem_put(&m, p, 60, 1);
    cr_assert_eq(m.used, 0);
}

Test(mem, reserve_keeps_the_contents)
{
    fmb_mem m;
    int *p = NULL;
    size_t capacity = 0;
    fmb_mem_init(&m, NULL, 0);
    for (int i = 0; i < 1000; i++) {
        cr_assert_eq(fmb_mem_reserve(&m, (void **)&p, &capacity, (size_t)i + 1, sizeof *p), FMB_OK);
        p[i] = i;
    }
    for (int i = 0; i < 1000; i++)
        cr_assert_eq(p[i], i);
    fmb_mem_put(&m, p, capacity, sizeof *p);
    cr_assert_eq(m.used, 0);
}

Test(mem, texts_are_copies)
{
    fmb_mem m;
    char text[] = "wall";
    fmb_mem_init(&m, NULL, 0);
    char *copy = fmb_mem_text(&m, text);
    text[0] = 'b';
    cr_assert_str_eq(copy, "wall");
    fmb_mem_put_text(&m, copy);
    fmb_mem_put_text(&m, NULL);
    cr_assert_eq(m.used, 0);
}

Test(arena, pieces_are_apart_and_aligned)
{
    fmb_mem m;
    fmb_arena a;
    unsigned char *piece[500];
    fmb_mem_init(&m, NULL, 0);
    fmb_arena_init(&a, &m);
    for (size_t i = 0; i < 500; i++) {
        piece[i] = fmb_arena_get(&a, i, 7);
        cr_assert_eq((uintptr_t)piece[i] % 16, 0);
        memset(piece[i], (int)(i & 255), 7 * i);
    }
    for (size_t i = 0; i < 500; i++)
        for (size_t k = 0; k < 7 * i; k++)
            cr_assert_eq(piece[i][k], i & 255);
    fmb_arena_clear(&a);
    cr_assert_eq(m.used, 0);
}

Test(arena, trim_gives_back_what_is_not_handed_out)
{
    fmb_mem m;
    fmb_arena a;
    fmb_mem_init(&m, NULL, 0);
    fmb_arena_init(&a, &m);
    unsigned char *piece = fmb_arena_get(&a, 1000, 1);
    size_t used = m.used;
    memset(piece, 7, 1000);
    fmb_arena_place place = fmb_arena_tell(&a);
    for (int i = 0; i < 50; i++)
        cr_assert_not_null(fmb_arena_get(&a, 10000, 1));
    cr_expect_gt(m.used, used);
    fmb_arena_rewind(&a, place);
    fmb_arena_trim(&a);
    cr_expect_eq(m.used, used);
    cr_expect(piece[0] == 7 && piece[999] == 7);
    fmb_arena_reset(&a);
    fmb_arena_trim(&a);
    cr_expect_eq(m.used, 0);
    cr_assert_not_null(fmb_arena_get(&a, 10, 1));
    fmb_arena_clear(&a);
    cr_expect_eq(m.used, 0);
}

Test(arena, reset_uses_the_same_chunks)
{
    fmb_mem m;
    fmb_arena a;
    fmb_mem_init(&m, NULL, 0);
    fmb_arena_init(&a, &m);
    for (int round = 0; round < 3; round++) {
        size_t before = m.used;
        for (int i = 0; i < 100; i++)
            cr_assert_not_null(fmb_arena_get(&a, 1000, 1));
        cr_assert(round == 0 || m.used == before);
        fmb_arena_reset(&a);
    }
    cr_assert_null(fmb_arena_get(&a, SIZE_MAX, 2));
    cr_assert_eq(fmb_mem_status(&m), FMB_ERR_MEMORY);
    fmb_arena_clear(&a);
}

Test(arena, reserve_moves_the_contents)
{
    fmb_mem m;
    fmb_arena a;
    int *p = NULL;
    size_t capacity = 0;
    fmb_mem_init(&m, NULL, 0);
    fmb_arena_init(&a, &m);
    for (int i = 0; i < 5000; i++) {
        cr_assert_eq(fmb_arena_reserve(&a, (void **)&p, &capacity, (size_t)i + 1, sizeof *p),
                     FMB_OK);
        p[i] = -i;
    }
    for (int i = 0; i < 5000; i++)
        cr_assert_eq(p[i], -i);
    fmb_arena_clear(&a);
}

typedef struct body {
    int *place;
    double *weight;
    char *met;
} body;

static fmb_status hold_body(fmb_mem *m, body *b, bool get)
{
    return FMB_ARRAYS(m, get, FMB_ARRAY(b->place, 10), FMB_ARRAY_ZERO(b->weight, 20),
                      FMB_ARRAY(b->met, 0));
}

/* All, or those that there is memory for: what was got can be put either way, and once more. */
Test(arrays, come_and_go_together)
{
    const size_t whole = 10 * sizeof(int) + 20 * sizeof(double) + 1;
    for (size_t limit = 1; limit <= whole; limit++) {
        body b;
        fmb_mem m;
        fmb_mem_init(&m, NULL, limit);
        fmb_status st = hold_body(&m, &b, true);
        cr_assert_eq(st, limit < whole ? FMB_LIMIT : FMB_OK);
        cr_assert(!b.place == (limit < 10 * sizeof(int)) && !b.met == (st != FMB_OK));
        for (int i = 0; b.weight && i < 20; i++)
            cr_assert_eq(b.weight[i], 0);
        cr_assert_eq(m.used, st == FMB_OK ? whole
                             : b.weight   ? whole - 1
                             : b.place    ? 10 * sizeof(int)
                                          : 0);
        for (int k = 0; k < 2; k++) {
            cr_assert_eq(hold_body(&m, &b, false), FMB_OK);
            cr_assert(m.used == 0 && !b.place && !b.weight && !b.met);
        }
    }
}

static fmb_status hold_body_in_block(fmb_mem *m, body *b, bool get)
{
    return FMB_ARRAYS_IN_BLOCK(m, get, FMB_ARRAY(b->met, 3), FMB_ARRAY_ZERO(b->weight, 20),
                               FMB_ARRAY(b->place, 0));
}

/* One block, of which each array has its own part, for any type; or none, and no pointer. */
Test(arrays, come_and_go_in_one_block)
{
    const size_t unit = _Alignof(max_align_t), whole = unit + 20 * sizeof(double);
    for (size_t limit = whole - 1; limit <= whole; limit++) {
        body b;
        fmb_mem m;
        fmb_mem_init(&m, NULL, limit);
        bool there = limit == whole;
        cr_assert_eq(hold_body_in_block(&m, &b, true), there ? FMB_OK : FMB_LIMIT);
        cr_assert_eq(m.used, there ? whole : 0);
        cr_assert(!b.met == !there && !b.weight == !there && !b.place == !there);
        if (there)
            memset(b.met, 1, 3);
        for (int i = 0; there && i < 20; i++)
            cr_assert_eq(b.weight[i], 0);
        cr_assert(!there || (uintptr_t)b.weight % unit == 0);
        for (int k = 0; k < 2; k++) {
            cr_assert_eq(hold_body_in_block(&m, &b, false), FMB_OK);
            cr_assert(m.used == 0 && !b.place && !b.weight && !b.met);
        }
    }
}

/* As many bytes as no number says are no few bytes. */
Test(arrays, in_one_block_do_not_wrap)
{
    fmb_mem m;
    body b = {.place = NULL, .weight = NULL, .met = NULL};
    fmb_mem_init(&m, NULL, 0);
    for (size_t n = SIZE_MAX / 8 - 1; n <= SIZE_MAX / 8 + 1; n++)
        cr_assert_neq(FMB_ARRAYS_IN_BLOCK(&m, true, FMB_ARRAY(b.weight, n), FMB_ARRAY(b.met, 40)),
                      FMB_OK);
    cr_assert(m.used == 0 && !b.weight && !b.met);
}

Test(words, every_status_verdict_and_stop_has_one)
{
    for (int i = FMB_OK; i <= FMB_ERR_RANGE; i++)
        cr_assert_str_neq(fmb_status_text((fmb_status)i), "unknown status");
    cr_assert_str_eq(fmb_status_text((fmb_status)99), "unknown status");
    cr_assert_str_eq(fmb_verdict_text(FMB_UNKNOWN), "unknown");
    cr_assert_str_eq(fmb_verdict_text(FMB_FEASIBLE), "feasible");
    cr_assert_str_eq(fmb_verdict_text(FMB_INFEASIBLE), "infeasible");
    cr_assert_str_eq(fmb_stop_text(FMB_STOP_DONE), "done");
    cr_assert_str_eq(fmb_stop_text(FMB_STOP_TIME), "time");
    cr_assert_str_eq(fmb_stop_text(FMB_STOP_ROWS), "rows");
    cr_assert_str_eq(fmb_stop_text(FMB_STOP_BYTES), "bytes");
    cr_assert_str_eq(fmb_stop_text(FMB_STOP_CANCELLED), "cancelled");
}

Test(words, the_version_is_the_same_everywhere)
{
    char numbers[32];
    snprintf(numbers, sizeof numbers, "%d.%d.%d", FMB_VERSION_MAJOR, FMB_VERSION_MINOR,
             FMB_VERSION_PATCH);
    cr_assert_str_eq(numbers, FMB_VERSION);
    cr_assert_str_eq(fmb_version(), FMB_VERSION);
    cr_assert_str_eq(MESON_VERSION, FMB_VERSION);
    cr_assert_eq(FMB_VERSION_NUMBER,
                 FMB_VERSION_MAJOR * 10000 + FMB_VERSION_MINOR * 100 + FMB_VERSION_PATCH);
}
