/* meet.c: trees find the same as tests of all pairs, in order; places, motions and limits. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/mesh.h>
#include <fmb/pair.h>

#include "counted_clock.h"
#include "fault/hook.h"
#include "property/random/rows.h"
#include "soup.h"
#include "support/support.h"

static fmb_mesh *cell_of(const soup *s, size_t c)
{
    fmb_mesh *m = NULL;
    must(fmb_mesh_new(s->corners, VERTICES, s->point, 1, s->corner + c * (size_t)s->corners, NULL,
                      &m));
    return m;
}

/* The answer of meshes of one cell each. */
static fmb_mesh_hit ask_cells(const soup *s, size_t a, const soup *t, size_t b,
                              const fmb_mesh_options *o)
{
    fmb_mesh *m = cell_of(s, a), *n = cell_of(t, b);
    fmb_mesh_answer answer = {.size = sizeof answer};
    fmb_mesh_hit hit = {.how = FMB_MESH_APART};
    must(fmb_mesh_meet(m, n, o, &answer));
    cr_assert(answer.hits <= 1);
    if (answer.hits > 0)
        hit = answer.hit[0];
    hit.a = (uint32_t)a;
    hit.b = (uint32_t)b;
    fmb_mesh_answer_clear(&answer);
    fmb_mesh_free(m);
    fmb_mesh_free(n);
    return hit;
}

static void compare(const soup *s, const soup *t, const fmb_mesh_options *o)
{
    fmb_mesh *m = mesh_of(s), *n = t ? mesh_of(t) : NULL;
    fmb_mesh_answer answer = {.size = sizeof answer};
    size_t next = 0;
    must(fmb_mesh_meet(m, n, o, &answer));
    for (size_t a = 0; a < s->cells; a++)
        for (size_t b = t ? 0 : a + 1; b < (t ? t->cells : s->cells); b++) {
            fmb_mesh_hit want = ask_cells(s, a, t ? t : s, b, o);
            if (want.how == FMB_MESH_APART)
                continue;
            cr_assert(next < answer.hits);
            const fmb_mesh_hit *got = &answer.hit[next++];
            cr_expect(got->a == want.a && got->b == want.b && got->how == want.how &&
                          got->shared == want.shared,
                      "%u %u %s, not %u %u %s", got->a, got->b, fmb_mesh_how_text(got->how), want.a,
                      want.b, fmb_mesh_how_text(want.how));
        }
    cr_expect(next == answer.hits && next > 10, "%zu of %zu", next, answer.hits);
    fmb_mesh_answer_clear(&answer);
    fmb_mesh_free(m);
    fmb_mesh_free(n);
}

Test(meet, soups)
{
    support_rng g = {7};
    soup s, t;
    for (int neighbours = 0; neighbours < 2; neighbours++) {
        fmb_mesh_options o = {.size = sizeof o, .neighbours = neighbours};
        draw_soup(&g, 3, 40, &s);
        draw_soup(&g, 4, 20, &t);
        compare(&s, NULL, &o);
        compare(&t, NULL, &o);
        compare(&s, &t, &o);
        compare(&t, &s, &o);
    }
}

Test(meet, motion)
{
    support_rng g = {8};
    soup s, t;
    draw_soup(&g, 3, 12, &s);
    draw_soup(&g, 3, 12, &t);
    const double motion[3] = {0.5, -3, 1.25};
    compare(&s, &t, &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .motion = motion});
}

/* Every cell of a sound mesh meets its neighbours and no one else, however coordinates round. */
Test(meet, neighbours)
{
    enum { SIDE = 24 };
    static double point[SIDE * SIDE][3];
    static uint32_t corner[2 * (SIDE - 1) * (SIDE - 1)][3];
    size_t cells = 0, meet = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = i % SIDE / 7.0, y = i / SIDE / 3.0;
        point[i][0] = x + 100;
        point[i][1] = y;
        point[i][2] = sin(x) * cos(y) / 3;
    }
    for (uint32_t i = 0; i < SIDE * (SIDE - 1); i++)
        if (i % SIDE < SIDE - 1) {
            const uint32_t square[2][3] = {{i, i + 1, i + SIDE}, {i + SIDE + 1, i + SIDE, i + 1}};
            memcpy(corner[cells], square, sizeof square);
            cells += 2;
        }
    fmb_mesh *m = NULL;
    fmb_mesh_answer answer = {.size = sizeof answer};
    must(fmb_mesh_new(3, SIDE * SIDE, point[0], cells, corner[0], NULL, &m));
    must(fmb_mesh_meet(m, NULL,
                       &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .neighbours = true},
                       &answer));
    for (size_t i = 0; i < answer.hits; i++) {
        meet++;
        cr_expect(answer.hit[i].how == FMB_MESH_SHARE && answer.hit[i].shared > 0);
    }
    size_t want = 0;
    for (size_t a = 0; a < cells; a++)
        for (size_t b = a + 1; b < cells; b++) {
            bool common = false;
            for (int k = 0; k < 9; k++)
                common |= corner[a][k / 3] == corner[b][k % 3];
            want += common;
        }
    cr_expect(meet == want && want > 5000, "%zu of %zu", meet, want);
    cr_expect(answer.framed == 0);
    fmb_mesh_answer_clear(&answer);
    must(fmb_mesh_meet(m, m, NULL, &answer));
    cr_expect(answer.hits == 0 && answer.stop == FMB_STOP_DONE);
    fmb_mesh_answer_clear(&answer);
    fmb_mesh_free(m);
}

Test(meet, place)
{
    support_rng g = {9};
    soup s;
    draw_soup(&g, 3, 4, &s);
    fmb_mesh *m = mesh_of(&s), *placed = NULL;
    fmb_mesh_place p = {{-3, 1 / 3.0, 0}, {0.1, 0.2, 0.3}};
    must(fmb_mesh_placed(m, &p, NULL, &placed));
    for (int i = 0; i < 3 * VERTICES; i++)
        cr_expect(fmb_mesh_points(placed)[i] == fma(p.scale[i % 3], s.point[i], p.move[i % 3]));
    cr_expect(memcmp(fmb_mesh_indices(placed), s.corner, 12 * sizeof *s.corner) == 0);
    fmb_mesh_free(placed);
    p.scale[0] = 1e308;
    p.move[0] = INFINITY;
    cr_expect(fmb_mesh_placed(m, &p, NULL, &placed) == FMB_ERR_ARG);
    fmb_mesh_free(m);
}

static bool waste_time(void *self, double done)
{
    ++*(int *)self;
    counted_clock_pass(1000);
    return done >= 0;
}

/* A limit that is always reached ends trees and rows, before a pair is tested; one that
 * progress uses up ends them at once. */
Test(meet, seconds)
{
    support_rng g = {13};
    soup s;
    draw_soup(&g, 3, CELLS, &s);
    fmb_mesh *m = mesh_of(&s);
    int calls = 0;
    for (size_t threads = 1; threads < 4; threads += 2) {
        fmb_mesh_answer trees = {.size = sizeof trees}, pairs = {.size = sizeof pairs};
        fmb_mesh_options o = {.size = sizeof o, .max_seconds = 1, .threads = threads};
        counted_clock_start(0, NULL, NULL);
        must(fmb_mesh_meet(m, NULL, &o, &trees));
        counted_clock_stop();
        cr_expect(trees.stop == FMB_STOP_TIME && trees.hits == 0 && trees.tested == 0);
        counted_clock_start(0, NULL, NULL);
        must(fmb_mesh_meet_pairs(m, 0, CELLS, NULL, &o, &pairs));
        counted_clock_stop();
        cr_expect(pairs.stop == FMB_STOP_TIME && pairs.hits == 0 && pairs.tested == 0);
        o.max_seconds = COUNTED_FOREVER;
        must(fmb_mesh_meet(m, NULL, &o, &trees));
        cr_expect(trees.stop == FMB_STOP_DONE && trees.hits > 10);
        fmb_mesh_answer_clear(&trees);
    }
    fmb_mesh_options slow = {
        .size = sizeof slow, .max_seconds = 1000, .progress = waste_time, .self = &calls};
    fmb_mesh_answer late = {.size = sizeof late};
    counted_clock_start(0, NULL, NULL);
    must(fmb_mesh_meet(m, NULL, &slow, &late));
    counted_clock_stop();
    cr_expect(late.stop == FMB_STOP_TIME && calls == 1, "%d", calls);
    fmb_mesh_answer_clear(&late);
    fmb_mesh_free(m);
}

static bool stop(void *self, double done)
{
    ++*(int *)self;
    return done < 0;
}

Test(meet, limits)
{
    support_rng g = {10};
    soup s;
    int calls = 0;
    draw_soup(&g, 3, CELLS, &s);
    fmb_mesh *m = mesh_of(&s);
    fmb_mesh_answer answer = {.size = sizeof answer};
    must(fmb_mesh_meet(
        m, NULL,
        &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .progress = stop, .self = &calls},
        &answer));
    cr_expect(answer.stop == FMB_STOP_CANCELLED && calls == 1);
    fmb_mesh_answer_clear(&answer);
    must(fmb_mesh_meet_pairs(
        m, 0, 8, NULL,
        &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .progress = stop, .self = &calls},
        &answer));
    cr_expect(answer.stop == FMB_STOP_DONE && calls == 1 && answer.tested == 8 * CELLS - 36);
    fmb_mesh_answer_clear(&answer);
    must(fmb_mesh_meet(
        m, NULL, &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .max_bytes = 300}, &answer));
    cr_expect(answer.stop == FMB_STOP_BYTES && answer.hits == 0);
    fmb_mesh_answer_clear(&answer);
    fmb_mesh_free(m);
}

/* The most that was held at any time. */
typedef struct peak {
    atomic_size_t live, most;
} peak;

static void *resize_and_note(void *self, void *p, size_t old, size_t size)
{
    peak *k = self;
    void *q = size > 0 ? realloc(p, size) : NULL;
    if (size == 0)
        free(p);
    size_t live = atomic_fetch_add(&k->live, size - old) + size - old;
    size_t most = atomic_load(&k->most);
    while (live > most && !atomic_compare_exchange_weak(&k->most, &most, live))
        ;
    return q;
}

/* What a search by so many threads takes that finds nothing, beyond what is held before. */
static size_t peak_of_no_cells(peak *k, const fmb_alloc *mem, size_t threads)
{
    const size_t before = atomic_load(&k->live);
    fmb_mesh *none = NULL;
    fmb_mesh_answer answer = {.size = sizeof answer};
    must(fmb_mesh_new(3, 0, NULL, 0, NULL, mem, &none));
    atomic_store(&k->most, before);
    must(fmb_mesh_meet(
        none, NULL,
        &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .mem = mem, .threads = threads},
        &answer));
    fmb_mesh_answer_clear(&answer);
    fmb_mesh_free(none);
    return atomic_load(&k->most) - before;
}

/* Meshes, hits and their sorting stay within the limit, but for what asks pairs as frames, which is
 * the same for any mesh; enough finds all. */
Test(meet, bytes)
{
    enum { MANY = 600 };
    static double point[3 * MANY][3];
    static uint32_t corner[3 * MANY];
    support_rng g = {14};
    peak k = {0};
    fmb_alloc mem = {.self = &k, .resize = resize_and_note};
    fmb_mesh *m = NULL;
    fmb_mesh_answer answer = {.size = sizeof answer};
    for (uint32_t i = 0; i < 3 * MANY; i++) {
        corner[i] = i;
        for (int j = 0; j < 3; j++)
            point[i][j] = support_between(&g, 0, 99);
    }
    must(fmb_mesh_new(3, 3 * MANY, point[0], MANY, corner, &mem, &m));
    const size_t meshes = atomic_load(&k.live);
    must(fmb_mesh_meet(m, NULL, &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .mem = &mem},
                       &answer));
    const size_t all = answer.hits, bytes = all * sizeof *answer.hit;
    cr_assert(bytes > meshes);
    fmb_mesh_answer_clear(&answer);
    for (size_t threads = 1; threads < 4; threads += 2) {
        const size_t fixed = peak_of_no_cells(&k, &mem, threads);
        for (size_t part = 1; part < 6; part++) {
            fmb_mesh_options o = {.size = sizeof o,
                                  .max_bytes = meshes + part * bytes,
                                  .threads = threads,
                                  .mem = &mem};
            atomic_store(&k.most, 0);
            must(fmb_mesh_meet(m, NULL, &o, &answer));
            cr_expect(atomic_load(&k.most) <= o.max_bytes + fixed, "%zu of %zu",
                      atomic_load(&k.most), o.max_bytes);
            cr_expect(answer.hits > 0);
            cr_expect(answer.stop == FMB_STOP_DONE
                          ? answer.hits == all
                          : answer.stop == FMB_STOP_BYTES && (part < 5 || threads > 1));
            fmb_mesh_answer_clear(&answer);
        }
    }
    fmb_mesh_free(m);
    cr_expect(atomic_load(&k.live) == 0);
}

Test(meet, arguments)
{
    const double point[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, bad[3] = {0, INFINITY, 0};
    const uint32_t corner[3] = {0, 1, 2}, beyond[3] = {0, 1, 3};
    fmb_mesh *m = NULL, *none = NULL;
    fmb_mesh_answer answer = {.size = sizeof answer};
    must(fmb_mesh_new(3, 3, point, 1, corner, NULL, &m));
    cr_expect(fmb_mesh_new(2, 3, point, 1, corner, NULL, &none) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_new(3, 3, point, 1, beyond, NULL, &none) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_new(3, 1, bad, 0, NULL, NULL, &none) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_new(3, 3, NULL, 1, corner, NULL, &none) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_new(3, 3, point, 1, corner, NULL, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_meet(NULL, m, NULL, &answer) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_meet(m, NULL, NULL, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_meet(m, NULL,
                            &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .motion = point},
                            &answer) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_meet(m, m,
                            &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .motion = bad},
                            &answer) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_meet(
                  m, m, &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .max_seconds = -1},
                  &answer) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_meet(
                  m, m, &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .max_seconds = NAN},
                  &answer) == FMB_ERR_ARG);
    cr_expect(!none && fmb_mesh_cells(NULL) == 0 && !fmb_mesh_points(NULL) &&
              !fmb_mesh_indices(NULL) && fmb_mesh_corners(NULL) == 0 &&
              fmb_mesh_vertices(NULL) == 0 && fmb_mesh_face(NULL, 3) == 0);
    fmb_mesh_free(m);
    fmb_mesh_free(NULL);
    fmb_mesh_answer_clear(NULL);
    fmb_mesh_answer_clear(&answer);
    must(fmb_mesh_new(4, 0, NULL, 0, NULL, NULL, &m));
    must(fmb_mesh_meet(m, NULL, NULL, &answer));
    cr_expect(answer.hits == 0);
    fmb_mesh_answer_clear(&answer);
    fmb_mesh_free(m);
}

/* The same from any number of threads. */
Test(meet, threads)
{
    support_rng g = {11};
    soup s, t;
    draw_soup(&g, 3, CELLS, &s);
    draw_soup(&g, 4, 30, &t);
    fmb_mesh *m = mesh_of(&s), *n = mesh_of(&t);
    for (int both = 0; both < 2; both++) {
        fmb_mesh_answer one = {.size = sizeof one}, many = {.size = sizeof many};
        must(fmb_mesh_meet(
            m, both ? n : NULL,
            &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .neighbours = true}, &one));
        must(fmb_mesh_meet(
            m, both ? n : NULL,
            &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .neighbours = true, .threads = 3},
            &many));
        cr_assert(one.hits == many.hits && one.hits > 100);
        cr_expect(one.tested == many.tested && one.framed == many.framed);
        for (size_t i = 0; i < one.hits; i++)
            cr_expect(one.hit[i].a == many.hit[i].a && one.hit[i].b == many.hit[i].b &&
                      one.hit[i].how == many.hit[i].how && one.hit[i].shared == many.hit[i].shared);
        fmb_mesh_answer_clear(&one);
        fmb_mesh_answer_clear(&many);
    }
    fmb_mesh_free(m);
    fmb_mesh_free(n);
}

/* Read, place and ask, with flat cells among them. */
static fmb_status do_all(const char *text, const fmb_alloc *mem)
{
    fmb_mesh *m = NULL, *placed = NULL;
    fmb_mesh_answer answer = {.size = sizeof answer};
    const fmb_mesh_place place = {{1, 1, 1}, {0.25, 0, 0}};
    fmb_reader how = {.size = sizeof how, .mem = mem};
    fmb_where w;
    fmb_status st = fmb_mesh_parse(text, strlen(text), FMB_MESH_AUTO, &how, &m, &w);
    if (st == FMB_OK)
        st = fmb_mesh_placed(m, &place, mem, &placed);
    if (st == FMB_OK)
        st = fmb_mesh_meet(
            m, placed,
            &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .neighbours = true, .mem = mem},
            &answer);
    cr_expect(st == FMB_OK ? answer.hits > 3 && answer.framed > 0 : answer.hits == 0);
    fmb_mesh_answer_clear(&answer);
    fmb_mesh_free(placed);
    fmb_mesh_free(m);
    return st;
}

Test(meet, memory)
{
    static const char *const text[] = {
        "OFF 5 4 0\n0 0 0\n1 0 0\n0 1 0\n2 0 0\n1.5 1 1\n3 0 1 2\n3 0 1 3\n3 1 2 4\n4 0 1 4 2",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4\nproperty list uchar int vertex_index\nend_header\n"
        "0 0 0 1 0 0 2 0 0 1 1 1 3 0 1 2 3 0 1 3 3 1 2 3 3 0 2 3"};
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    for (int i = 0; i < 2; i++) {
        fmb_status st = FMB_ERR_MEMORY;
        for (size_t k = 1; st != FMB_OK; k++) {
            hook_arm(&h, k, false);
            st = do_all(text[i], &mem);
            hook_calm(&h);
            cr_assert(st == FMB_OK || st == FMB_ERR_MEMORY, "%zu: %s", k, fmb_status_text(st));
            cr_assert(h.live == 0, "%zu: %zu bytes", k, h.live);
        }
    }
}
