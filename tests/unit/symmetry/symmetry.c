/* symmetry.c: symmetries planted in random programs are found, every map found is a symmetry, and
 * orbits are those of the group by definition. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "dense.h"
#include "support.h"
#include "support/must.h"
#include "symmetry/orbits.h"

enum { N = 8, KEPT = 4, MOST_ROWS = 64 };

static const int kept[KEPT] = {0, 1, 2, 3};
static const bool keeps[N] = {true, true, true, true, false, false, false, false};

typedef struct bench {
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    int64_t row[MOST_ROWS][N + 1];
    fmb_rel rel[MOST_ROWS];
    int rows;
    int moves[N]; /* the planted one: column j goes there */
    fmb_program p;
    fmb_group group;
} bench;

static int find_row(const bench *b, const int64_t *row, fmb_rel rel)
{
    for (int i = 0; i < b->rows; i++)
        if (b->rel[i] == rel && memcmp(b->row[i], row, sizeof b->row[i]) == 0)
            return i;
    return -1;
}

static void move_row_by(const int *moves, const int64_t *row, int64_t *to)
{
    for (int j = 0; j < N; j++)
        to[moves[j]] = row[j];
    to[N] = row[N];
}

/* The row and its images under the planted symmetry. */
static void add_orbit_of_row(bench *b, const int64_t *row, fmb_rel rel)
{
    int64_t at[N + 1], next[N + 1];
    memcpy(at, row, sizeof at);
    while (find_row(b, at, rel) < 0) {
        cr_assert_lt(b->rows, MOST_ROWS);
        memcpy(b->row[b->rows], at, sizeof at);
        b->rel[b->rows++] = rel;
        move_row_by(b->moves, at, next);
        memcpy(at, next, sizeof at);
    }
}

/* Kept columns go to such. */
static void draw_moves(bench *b, support_rng *g)
{
    for (int j = 0; j < N; j++)
        b->moves[j] = j;
    for (int half = 0; half < N; half += KEPT)
        for (int j = KEPT - 1; j > 0; j--) {
            int k = support_between(g, 0, j), t = b->moves[half + j];
            b->moves[half + j] = b->moves[half + k];
            b->moves[half + k] = t;
        }
}

static void append_to_program(bench *b, int i)
{
    mpz_t z[N + 1];
    for (int j = 0; j <= N; j++)
        mpz_init_set_si(z[j], b->row[i][j]);
    must(fmb_program_add_integers(&b->p, z, b->rel[i]));
    for (int j = 0; j <= N; j++)
        mpz_clear(z[j]);
}

static void open_bench(bench *b, uint64_t seed)
{
    support_rng g = {seed};
    fmb_options o = {.size = sizeof o};
    memset(b, 0, sizeof *b);
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    draw_moves(b, &g);
    for (int i = 0; i < 4; i++) {
        int64_t row[N + 1] = {0};
        for (int k = 0; k < 3; k++)
            row[support_between(&g, 0, N - 1)] = support_between(&g, -3, 3);
        row[N] = support_between(&g, 1, 9);
        add_orbit_of_row(b, row, (fmb_rel)support_between(&g, FMB_LE, FMB_EQ));
    }
    fmb_program_init(&b->p, &b->mem, N);
    for (int i = 0; i < b->rows; i++)
        append_to_program(b, i);
    must(fmb_symmetry_find(&b->run, &b->p, keeps, &b->group));
}

static void close_bench(bench *b)
{
    fmb_group_clear(&b->group);
    fmb_program_clear(&b->p);
    cr_assert_eq(b->mem.used, 0);
}

/* What is found takes rows to rows, and moves kept columns. */
static void check_generators(const bench *b)
{
    for (size_t g = 0; g < b->group.size; g++) {
        int moves[N];
        bool moved = false;
        for (int j = 0; j < N; j++) {
            moves[j] = (int)b->group.image[g][j];
            moved |= keeps[j] && moves[j] != j;
            cr_assert(keeps[j] == keeps[moves[j]]);
        }
        cr_assert(moved);
        for (int i = 0; i < b->rows; i++) {
            int64_t to[N + 1];
            move_row_by(moves, b->row[i], to);
            uint32_t image = b->group.image[g][N + i];
            cr_assert(memcmp(to, b->row[image], sizeof to) == 0 && b->rel[i] == b->rel[image]);
        }
    }
}

static void set_vector(fmb_vec *v, int64_t *entry, const int64_t *from)
{
    memcpy(entry, from, (KEPT + 1) * sizeof *entry);
    *v = (fmb_vec){.s = entry};
    fmb_vec_measure(v, KEPT + 1);
}

/* All images of v under the generators found, by definition. */
static size_t count_orbit(const bench *b, const int64_t *v, int64_t (*orbit)[KEPT + 1])
{
    size_t size = 1;
    memcpy(orbit[0], v, (KEPT + 1) * sizeof *v);
    for (size_t i = 0; i < size; i++)
        for (size_t g = 0; g < b->group.size; g++) {
            bool old = false;
            orbit[size][0] = orbit[i][0];
            for (int j = 0; j < KEPT; j++)
                orbit[size][1 + b->group.image[g][j]] = orbit[i][1 + j];
            for (size_t k = 0; k < size; k++)
                old |= memcmp(orbit[k], orbit[size], sizeof orbit[size]) == 0;
            size += !old;
        }
    return size;
}

static void check_orbits(bench *b)
{
    static int64_t orbit[25][KEPT + 1];
    const int64_t v[KEPT + 1] = {7, 1, 2, 3, 4};
    int64_t entry[KEPT + 1];
    fmb_orbits o;
    fmb_vec x;
    size_t size = count_orbit(b, v, orbit);
    must(fmb_orbits_init(&o, &b->run, &b->group, kept, KEPT));
    set_vector(&x, entry, v);
    must(fmb_orbits_add(&o, &x, 5));
    cr_assert_eq(o.size, size);
    for (size_t i = 0; i < size; i++) {
        set_vector(&x, entry, orbit[i]);
        size_t item = fmb_orbits_find(&o, &x);
        cr_assert_neq(item, SIZE_MAX);
        cr_assert_eq(o.item[fmb_orbits_root(&o, item)].tag, 5);
        must(fmb_orbits_add(&o, &x, 6));
    }
    cr_assert_eq(o.size, size);
#ifdef FMB_HAVE_NAUTY /* the planted symmetry is among them */
    int64_t image[KEPT + 1] = {7};
    for (int j = 0; j < KEPT; j++)
        image[1 + b->moves[j]] = v[1 + j];
    set_vector(&x, entry, image);
    cr_assert_neq(fmb_orbits_find(&o, &x), SIZE_MAX);
#endif
    set_vector(&x, entry, (const int64_t[]){8, 1, 2, 3, 4});
    cr_assert_eq(fmb_orbits_find(&o, &x), SIZE_MAX);
    fmb_orbits_clear(&o);
}

/* Multipliers that give a row over kept columns give its image, when they are moved. */
static void check_moved_weights(bench *b, int64_t factor)
{
    int64_t entry[KEPT + 1];
    fmb_orbits o;
    fmb_vec x;
    fmb_weights from = {0};
    mpq_t q;
    mpq_init(q);
    set_vector(&x, entry, (const int64_t[]){9, 4, 3, 2, 1});
    for (int i = 0; i < b->rows; i++) {
        mpq_set_si(q, factor + i, 1);
        must(fmb_weights_add(&from, (uint32_t)i, q, &b->mem));
    }
    must(fmb_orbits_init(&o, &b->run, &b->group, kept, KEPT));
    must(fmb_orbits_add(&o, &x, 0));
    for (size_t item = 0; item < o.size; item++) {
        int64_t moved[N + 1] = {0}, sum[N + 1] = {0}, plain[N + 1] = {0};
        int moves[N] = {0, 1, 2, 3, 4, 5, 6, 7};
        fmb_weights to = {0};
        uint32_t chain[64], length = 0;
        for (size_t at = item; o.item[at].from != FMB_ORBIT_ROOT; at = o.item[at].from)
            chain[length++] = o.item[at].by;
        while (length-- > 0)
            for (int j = 0; j < N; j++)
                moves[j] = (int)b->group.image[chain[length]][moves[j]];
        must(fmb_orbits_move_weights(&o, item, &from, &to));
        for (size_t k = 0; k < to.size; k++)
            for (int j = 0; j <= N; j++) {
                sum[j] += (int64_t)mpz_get_si(mpq_numref(to.value[k])) * b->row[to.index[k]][j];
                plain[j] += (factor + (int64_t)k) * b->row[k][j];
            }
        move_row_by(moves, plain, moved);
        cr_assert(memcmp(sum, moved, sizeof sum) == 0);
        fmb_weights_clear(&to, &b->mem);
    }
    fmb_orbits_clear(&o);
    fmb_weights_clear(&from, &b->mem);
    mpq_clear(q);
}

Test(symmetry, planted)
{
    static bench b;
    for (uint64_t seed = 1; seed <= 200; seed++) {
        open_bench(&b, seed * 7919);
        check_generators(&b);
        check_orbits(&b);
        check_moved_weights(&b, (int64_t)seed);
        close_bench(&b);
    }
}

/* What is no symmetry does not become a generator. */
Test(symmetry, refused)
{
    static bench b;
    for (uint64_t seed = 1; seed <= 200; seed++) {
        support_rng g = {seed};
        uint32_t image[N + MOST_ROWS];
        bool fits;
        open_bench(&b, seed * 104729);
        for (int j = 0; j < N + b.rows; j++)
            image[j] = (uint32_t)(j < N ? j : j - N);
        int x = support_between(&g, 0, N - 1), y = support_between(&g, 0, N - 1);
        image[x] = (uint32_t)y;
        image[y] = (uint32_t)x;
        bool moves = x != y && keeps[x], symmetry = keeps[x] == keeps[y];
        for (int i = 0; i < b.rows; i++)
            for (int j = 0; j < N; j++)
                symmetry &= b.row[i][j] == b.row[i][image[j]];
        must(fmb_group_add(&b.group, &b.p, keeps, image, &fits));
        cr_assert_eq(fits, symmetry && moves);
        image[x] = image[y]; /* no permutation, unless they are one */
        must(fmb_group_add(&b.group, &b.p, keeps, image, &fits));
        cr_assert(!fits);
        close_bench(&b);
    }
}

/* Memory that runs out ends it cleanly. */
Test(symmetry, little_memory)
{
    static bench b;
    for (size_t bytes = 1; bytes < 400000; bytes += bytes / 2 + 1) {
        fmb_group group;
        open_bench(&b, 31);
        b.mem.limit = b.mem.used + bytes;
        fmb_status st = fmb_symmetry_find(&b.run, &b.p, keeps, &group);
        cr_assert(st == FMB_OK || st == FMB_LIMIT);
        fmb_group_clear(&group);
        close_bench(&b);
    }
}

/* ---- cancelled ------------------------------------------------------------------------------- */

/* x1 + ... + x8 <= 1, under all permutations of its columns, by two of them. */
static void open_crowd(bench *b)
{
    static const bool all[N] = {true, true, true, true, true, true, true, true};
    fmb_options o = {.size = sizeof o};
    bool fits;
    memset(b, 0, sizeof *b);
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    for (int j = 0; j <= N; j++)
        b->row[0][j] = 1;
    b->rows = 1;
    fmb_program_init(&b->p, &b->mem, N);
    append_to_program(b, 0);
    fmb_group_init(&b->group, &b->mem, N, 1);
    must(
        fmb_group_add(&b->group, &b->p, all, (const uint32_t[]){1, 2, 3, 4, 5, 6, 7, 0, 0}, &fits));
    must(
        fmb_group_add(&b->group, &b->p, all, (const uint32_t[]){1, 0, 2, 3, 4, 5, 6, 7, 0}, &fits));
    cr_assert_eq(b->group.size, 2);
}

/* What sets the cancel when so many bytes are held: from within, at the same moment each time. */
typedef struct fuse {
    size_t held, most;
    atomic_int *cancel;
} fuse;

static void *burn(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    fuse *f = self;
    f->held += new_bytes - old_bytes;
    if (f->held > f->most)
        atomic_store(f->cancel, 1);
    if (new_bytes > 0)
        return realloc(p, new_bytes);
    free(p);
    return NULL;
}

/* Of an orbit of 40,320 images few are made after the cancel, and those before it are there. */
Test(symmetry, orbits_end_when_cancelled)
{
    static const int columns[N] = {0, 1, 2, 3, 4, 5, 6, 7};
    static bench b;
    int64_t entry[N + 1] = {1, 1, 2, 3, 4, 5, 6, 7, 8};
    fmb_vec x = {.s = entry};
    fmb_vec_measure(&x, N + 1);
    for (size_t most = 1000; most < 300000; most *= 3) {
        fmb_orbits o;
        open_crowd(&b);
        fuse f = {0, most, &b.cancel};
        fmb_mem mem;
        fmb_mem_init(&mem, &(fmb_alloc){burn, &f}, 0);
        b.run.mem = &mem;
        fmb_status st = fmb_orbits_init(&o, &b.run, &b.group, columns, N);
        if (st == FMB_OK)
            st = fmb_orbits_add(&o, &x, 0);
        cr_expect_eq(st, FMB_LIMIT);
        cr_expect_eq(b.run.stop, FMB_STOP_CANCELLED);
        cr_expect_lt(f.held, 4 * most + 65536, "%zu after %zu", f.held, most);
        for (size_t i = 0; i < o.size; i++)
            cr_expect_eq(fmb_orbits_find(&o, &o.item[i].v), i);
        fmb_orbits_clear(&o);
        cr_expect(mem.used == 0 && f.held == 0);
        b.run.mem = &b.mem;
        close_bench(&b);
    }
}
