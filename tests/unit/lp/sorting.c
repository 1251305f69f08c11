/* sorting.c: rows sorted into redundant and others by guesses: the oracle decides feasibility only
 * if a quick search finds no interior point and none is known. For many rows, of short or long
 * numbers, any number of threads agrees with the oracle. */
#include <criterion/criterion.h>
#include <string.h>

#include "lp/redundancy/active_set/implied.h"
#include "lp/redundancy/irredundant.h"
#include "support.h"

enum { ROWS = 4 };

/* The square 0 <= x, y with x <= right, y <= top, whose rows are sorted; each column is multiplied
 * by its unit. */
static fmb_stats sort_square_in_units(int64_t right, int64_t top, const int64_t *unit, bool known,
                                      fmb_sorting *out)
{
    int64_t words[ROWS][3] = {{-1, 0, 0}, {1, 0, right}, {0, -1, 0}, {0, 1, top}};
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    fmb_vec v[ROWS] = {{0}};
    fmb_lp_row row[ROWS];
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (size_t i = 0; i < ROWS; i++) {
        for (size_t j = 0; j < 3; j++)
            words[i][j] *= unit[j];
        v[i].s = words[i];
        fmb_vec_measure(&v[i], 3);
        row[i] = (fmb_lp_row){&v[i], FMB_LE};
    }
    out->known = known;
    cr_assert_eq(fmb_lp_sort_rows(&run, 2, ROWS, row, out), FMB_OK);
    cr_expect_eq(mem.used, 0);
    return run.stats;
}

static fmb_stats sort_square(int64_t right, int64_t top, bool known, fmb_sorting *out)
{
    return sort_square_in_units(right, top, (const int64_t[]){1, 1, 1}, known, out);
}

Test(sorting, asks_the_oracle_only_in_doubt)
{
    static const struct {
        int64_t right, top;
        bool known, inner, feasible;
        unsigned lps;
    } table[] = {
        {5, 7, false, true, true, 0},    /* a point inside is seen at once */
        {5, 7, true, true, true, 0},     /* */
        {5, 0, true, false, true, 0},    /* flat, and known to have a solution */
        {5, 0, false, false, true, 1},   /* flat: the oracle knows */
        {5, -3, false, false, false, 1}, /* empty: the oracle ends it */
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        bool gone[ROWS] = {0}, kept[ROWS] = {0};
        fmb_sorting out = {.gone = gone, .kept = kept};
        fmb_stats stats = sort_square(table[i].right, table[i].top, table[i].known, &out);
        cr_expect_eq(out.inner, table[i].inner, "%zu", i);
        cr_expect_eq(out.feasible, table[i].feasible, "%zu", i);
        cr_expect_eq(stats.lps, table[i].lps, "%zu: %lu", i, (unsigned long)stats.lps);
        for (size_t k = 0; k < ROWS; k++) {
            cr_expect(!gone[k]);
            cr_expect(kept[k] == table[i].inner, "%zu: row %zu", i, k);
        }
    }
}

/* They would be too long for rays. */
Test(sorting, powers_of_two_in_columns_do_not_count)
{
    const int64_t unit[] = {(int64_t)1 << 50, (int64_t)1 << 40, (int64_t)1 << 45};
    bool gone[ROWS] = {0}, kept[ROWS] = {0};
    fmb_sorting out = {.gone = gone, .kept = kept};
    fmb_stats stats = sort_square_in_units(5, 7, unit, false, &out);
    cr_expect(out.inner);
    cr_expect_eq(stats.lps, 0);
    for (size_t k = 0; k < ROWS; k++)
        cr_expect(kept[k] && !gone[k], "row %zu", k);
}

/* The same square in two columns of so many that all of them together would be refused. */
Test(sorting, columns_that_no_row_names_do_not_count)
{
    enum { COLUMNS = 500, X = 17, Y = 400 };
    static int64_t words[ROWS][COLUMNS + 1];
    bool gone[ROWS] = {0}, kept[ROWS] = {0};
    fmb_sorting out = {.gone = gone, .kept = kept};
    for (size_t i = 0; i < ROWS; i++) {
        words[i][i < 2 ? X : Y] = i % 2 == 0 ? -1 : 1;
        words[i][COLUMNS] = i % 2 == 0 ? 0 : 5;
    }
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    fmb_vec v[ROWS] = {{0}};
    fmb_lp_row row[ROWS];
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (size_t i = 0; i < ROWS; i++) {
        v[i].s = words[i];
        fmb_vec_measure(&v[i], COLUMNS + 1);
        row[i] = (fmb_lp_row){&v[i], FMB_LE};
    }
    cr_assert_eq(fmb_lp_sort_rows(&run, COLUMNS, ROWS, row, &out), FMB_OK);
    cr_expect(out.inner);
    cr_expect_eq(out.doubtful, 0);
    for (size_t i = 0; i < ROWS; i++)
        cr_expect(kept[i] && !gone[i], "row %zu", i);
    cr_expect_eq(mem.used, 0);
}

/* ---- many rows ------------------------------------------------------------------------------- */

enum { WIDE = 8, MANY = 240 };

typedef struct crowd {
    int64_t words[MANY][WIDE + 1];
    fmb_vec v[MANY];
    fmb_lp_row row[MANY];
} crowd;

/* Rows around 0, some twice, some sums of others, some of them strict. flat: one of them backwards
 * as well, and no point inside. */
static void draw_crowd(crowd *c, support_rng *g, bool flat)
{
    memset(c, 0, sizeof *c);
    for (int i = 0; i < MANY; i++) {
        int64_t *w = c->words[i];
        const int64_t *p = c->words[i / 2], *q = c->words[i / 3];
        bool sum = i > 2 * WIDE && support_chance(g, 40);
        for (int j = 0; j <= WIDE; j++)
            w[j] = sum ? p[j] + (i % 5 > 0 ? q[j] : 0)
                       : support_between(g, j < WIDE ? -9 : 40, j < WIDE ? 9 : 80);
        if (i == 1 && flat)
            for (int j = 0; j <= WIDE; j++)
                w[j] = -c->words[0][j];
        c->v[i].s = w;
        fmb_vec_measure(&c->v[i], WIDE + 1);
        c->row[i] = (fmb_lp_row){&c->v[i], support_chance(g, 10) && !flat ? FMB_LT : FMB_LE};
    }
}

static void sort_crowd(const crowd *c, size_t threads, fmb_sorting *out)
{
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    o.threads = threads;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    out->known = true;
    cr_assert_eq(fmb_lp_sort_rows(&run, WIDE, MANY, c->row, out), FMB_OK);
    cr_expect_eq(mem.used, 0);
}

/* Do the rows not gone imply those that are? And are those kept irredundant among them? */
static void expect_truth(const crowd *c, const fmb_sorting *found)
{
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    fmb_lp_row row[MANY];
    fmb_fate fate[MANY];
    size_t m = 0, place[MANY];
    bool feasible;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (int gone = 0; gone <= 1; gone++) /* the oracle looks at the last first */
        for (size_t i = 0; i < MANY; i++)
            if (found->gone[i] == (gone == 1)) {
                place[m] = i;
                fate[m] = FMB_FATE_UNKNOWN;
                row[m++] = c->row[i];
            }
    cr_assert_eq(fmb_redundant(&run, WIDE, m, row, NULL, fate, &feasible), FMB_OK);
    cr_assert(feasible);
    for (size_t k = 0; k < m; k++) {
        cr_expect(!found->gone[place[k]] || fate[k] == FMB_FATE_REDUNDANT, "row %zu", place[k]);
        cr_expect(!found->kept[place[k]] || fate[k] == FMB_FATE_KEPT, "row %zu", place[k]);
    }
}

Test(sorting, the_same_by_any_number_of_threads)
{
    static crowd c;
    support_rng g = {5};
    for (int i = 0; i < 3; i++) {
        bool gone[4][MANY] = {{0}}, kept[4][MANY] = {{0}};
        draw_crowd(&c, &g, i == 2);
        for (int k = 0; k < 4; k++) {
            fmb_sorting out = {.gone = gone[k], .kept = kept[k]};
            sort_crowd(&c, (size_t[]){1, 2, 3, 7}[k], &out);
            cr_expect_eq(out.inner, i < 2);
            cr_expect_arr_eq(gone[0], gone[k], sizeof *gone);
            cr_expect_arr_eq(kept[0], kept[k], sizeof *kept);
        }
        fmb_sorting found = {.gone = gone[0], .kept = kept[0]};
        expect_truth(&c, &found);
    }
}

static size_t count_open_rows(const fmb_sorting *found)
{
    size_t open = 0;
    for (int i = 0; i < MANY; i++)
        open += !found->gone[i] && !found->kept[i];
    return open;
}

/* Right sides, or one column, times numbers that are no powers of two, up to 25 bits in all: about
 * as many rows are decided, and what is decided is true. */
Test(sorting, units_do_not_count)
{
    static const struct {
        int column;
        int64_t unit;
    } table[] = {{WIDE, 1}, {WIDE, 177147}, {2, 177147}, {5, 59049}};
    static crowd c;
    size_t open = 0;
    for (size_t t = 0; t < sizeof table / sizeof *table; t++) {
        support_rng g = {7};
        bool gone[MANY] = {0}, kept[MANY] = {0};
        fmb_sorting found = {.gone = gone, .kept = kept};
        draw_crowd(&c, &g, false);
        for (int i = 0; i < MANY; i++) {
            c.words[i][table[t].column] *= table[t].unit;
            fmb_vec_measure(&c.v[i], WIDE + 1);
        }
        sort_crowd(&c, 1, &found);
        expect_truth(&c, &found);
        open = t == 0 ? count_open_rows(&found) : open;
        cr_expect(found.inner, "%zu", t);
        cr_expect_leq(count_open_rows(&found), open + MANY / 10, "%zu: %zu open for %zu", t,
                      count_open_rows(&found), open);
    }
}

/* In slices of so much work, or in one go (0), by several threads; how often it paused. */
static int sort_in_slices(const crowd *c, uint64_t slice, int most, fmb_sorting *out)
{
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    int pauses = 0;
    o.threads = 2;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    out->known = true;
    out->pauses = true;
    do {
        run.slice_end = slice > 0 ? run.work + slice : 0;
        cr_assert_eq(fmb_lp_sort_rows(&run, WIDE, MANY, c->row, out), FMB_OK);
        pauses += out->paused != NULL;
    } while (out->paused && pauses < most);
    fmb_lp_sorting_clear(out);
    cr_expect_eq(mem.used, 0);
    return pauses;
}

/* Slices change nothing of what is found, and it may be given up between two of them. */
Test(sorting, the_same_in_slices)
{
    static crowd c;
    support_rng g = {6};
    for (int i = 0; i < 2; i++) {
        bool gone[3][MANY] = {{0}}, kept[3][MANY] = {{0}};
        fmb_sorting out[3];
        draw_crowd(&c, &g, i == 1);
        for (int k = 0; k < 3; k++)
            out[k] = (fmb_sorting){.gone = gone[k], .kept = kept[k]};
        cr_expect_eq(sort_in_slices(&c, 0, 1000, &out[0]), 0);
        cr_expect_gt(sort_in_slices(&c, 1 << 14, 1000, &out[1]), 3);
        cr_expect_arr_eq(gone[0], gone[1], sizeof *gone);
        cr_expect_arr_eq(kept[0], kept[1], sizeof *kept);
        cr_expect_eq(sort_in_slices(&c, 1 << 14, 2, &out[2]), 2);
    }
}

/* ---- long numbers ---------------------------------------------------------------------------- */

/* The same rows, each times a long number and a power of two, in columns that have units of their
 * own; digits: and then digits that doubles do not see. */
static void lengthen_crowd(crowd *c, support_rng *g, bool digits, fmb_mem *mem)
{
    mpz_t z[WIDE + 1], factor, digit;
    mp_bitcnt_t unit[WIDE + 1];
    mpz_inits(factor, digit, NULL);
    for (int j = 0; j <= WIDE; j++) {
        mpz_init(z[j]);
        unit[j] = (mp_bitcnt_t)support_between(g, 0, j < WIDE ? 9 : 60);
    }
    for (int i = 0; i < MANY; i++) {
        const mp_bitcnt_t shift = (mp_bitcnt_t)support_between(g, 0, 300);
        mpz_set_si(factor, support_between(g, 1, 1000000000));
        mpz_pow_ui(factor, factor, (unsigned long)support_between(g, 3, 9));
        for (int j = 0; j <= WIDE; j++) {
            mpz_mul_si(z[j], factor, c->words[i][j]);
            mpz_mul_2exp(z[j], z[j], shift + unit[j] + 60);
            mpz_set_si(digit, support_between(g, -9, 9));
            mpz_mul_2exp(digit, digit, shift);
            if (digits)
                mpz_add(z[j], z[j], digit);
        }
        cr_assert_eq(fmb_vec_set_z(&c->v[i], WIDE + 1, z, mem), FMB_OK);
    }
    for (int j = 0; j <= WIDE; j++)
        mpz_clear(z[j]);
    mpz_clears(factor, digit, NULL);
}

/* Nearly all is decided where digits do not count, and there is a point inside. */
Test(sorting, long_rows_are_what_the_oracle_says)
{
    static crowd c;
    support_rng g = {9};
    fmb_mem mem;
    fmb_mem_init(&mem, NULL, 0);
    for (int i = 0; i < 6; i++) {
        bool gone[MANY] = {0}, kept[MANY] = {0}, flat = i % 3 == 2, digits = i % 2 == 1;
        fmb_sorting found = {.gone = gone, .kept = kept};
        draw_crowd(&c, &g, flat);
        lengthen_crowd(&c, &g, digits, &mem);
        sort_crowd(&c, 1 + (size_t)i % 2, &found);
        expect_truth(&c, &found);
        cr_expect_eq(found.inner, !flat);
        cr_expect(digits || flat || 8 * found.doubtful < MANY, "%d: %zu in doubt", i,
                  found.doubtful);
        for (int k = 0; k < MANY; k++)
            fmb_vec_clear(&c.v[k], WIDE + 1, &mem);
    }
    cr_expect_eq(mem.used, 0);
}

/* Every variable at least 0, in numbers of one digit, among long rows of which some have right
 * sides 2^40 times as long: a point inside is seen all the same. */
Test(sorting, short_rows_among_long_ones)
{
    static crowd c;
    support_rng g = {10};
    fmb_mem mem;
    bool gone[MANY] = {0}, kept[MANY] = {0};
    fmb_sorting found = {.gone = gone, .kept = kept};
    mpz_t z[WIDE + 1];
    fmb_mem_init(&mem, NULL, 0);
    draw_crowd(&c, &g, false);
    for (int j = 0; j <= WIDE; j++)
        mpz_init(z[j]);
    for (int i = 0; i < MANY; i++) {
        for (int j = 0; j <= WIDE; j++) {
            mpz_set_si(z[j], c.words[i][j]);
            mpz_mul_2exp(z[j], z[j], j == WIDE && i % 3 == 0 ? 140 : 100);
            mpz_add_ui(z[j], z[j], (unsigned long)support_between(&g, 0, 1000));
        }
        for (int j = 0; i < WIDE && j <= WIDE; j++)
            mpz_set_si(z[j], j == i ? -1 : 0);
        cr_assert_eq(fmb_vec_set_z(&c.v[i], WIDE + 1, z, &mem), FMB_OK);
    }
    sort_crowd(&c, 1, &found);
    expect_truth(&c, &found);
    cr_expect(found.inner);
    for (int j = 0; j <= WIDE; j++)
        mpz_clear(z[j]);
    for (int k = 0; k < MANY; k++)
        fmb_vec_clear(&c.v[k], WIDE + 1, &mem);
    cr_expect_eq(mem.used, 0);
}

enum { FEW_ROWS = 60 };

/* The oracle's fates of the first rows, in slices of so much work; how many calls it took. */
static int decide_in_slices(const crowd *c, uint64_t slice, fmb_fate *fate)
{
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    int calls = 0;
    size_t unknown = FEW_ROWS;
    fmb_pruner *paused = NULL;
    bool feasible;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (; unknown > 0; calls++) {
        size_t before = unknown;
        run.slice_end = run.work + slice;
        cr_assert_eq(fmb_redundant(&run, WIDE, FEW_ROWS, c->row, &paused, fate, &feasible), FMB_OK);
        cr_assert(feasible);
        unknown = 0;
        for (size_t i = 0; i < FEW_ROWS; i++)
            unknown += fate[i] == FMB_FATE_UNKNOWN;
        cr_assert_lt(unknown, before);
    }
    fmb_pruner_close(paused);
    cr_expect_eq(mem.used, 0);
    return calls;
}

/* A pause between two rows changes no fate. */
Test(sorting, the_oracle_decides_the_same_in_slices)
{
    static crowd c;
    support_rng g = {8};
    fmb_fate all[FEW_ROWS] = {FMB_FATE_UNKNOWN}, sliced[FEW_ROWS] = {FMB_FATE_UNKNOWN};
    draw_crowd(&c, &g, false);
    cr_expect_eq(decide_in_slices(&c, UINT64_MAX / 2, all), 1);
    cr_expect_gt(decide_in_slices(&c, 1, sliced), 2);
    cr_expect_arr_eq(all, sliced, sizeof all);
}
