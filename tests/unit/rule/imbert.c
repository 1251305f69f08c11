/* imbert.c: counts of Imbert's theorems: the rows that each of them decides. */
#include <criterion/criterion.h>

#include "bench.h"

/* How often |H| lies where. */
typedef struct tally {
    int rows, least, above, between, minimal;
} tally;

static tally seen;

static int size_of(const uint64_t *set, size_t words)
{
    int n = 0;
    for (size_t k = 0; k < words; k++)
        n += __builtin_popcountll(set[k]);
    return n;
}

/* The theorems, told by the rank: a row that the second one accepts is minimal, one that the first
 * one refuses is not. */
static bool look(void *state, const fmb_view *w, size_t row)
{
    uint64_t most = 0;
    size_t words, columns;
    const uint64_t *history = fmb_view_history(w, row, &words);
    int h = size_of(history, words);
    const uint64_t *effective = fmb_view_effective(w, row, &columns);
    (void)state;
    cr_assert_eq(columns, 1);
    fmb_view_implicit(w, row, &most);
    most = *effective | (most & *fmb_view_gone(w));
    int least = 1 + size_of(effective, 1), upper = 1 + size_of(&most, 1);
    bool minimal = fmb_view_minimal(w, row);
    cr_expect(!minimal || (least <= h && h <= upper), "theorem 1: %d <= %d <= %d", least, h, upper);
    cr_expect(h != least || minimal, "theorem 2");
    seen.rows++;
    seen.least += h == least;
    seen.above += h > upper;
    seen.between += least < h && h <= upper;
    seen.minimal += minimal;
    return false;
}

static const fmb_rule spy = {
    .name = "spy", .flags = FMB_RULE_NEEDS_HISTORY, .source = "this test", .drop_row = look};

static void watch_octahedron(const char *rule, int rounds, size_t left)
{
    bench b;
    seen = (tally){0};
    bench_open(&b, 4);
    bench_use(&b, &spy);
    if (rule)
        bench_use(&b, fmb_rule_find(rule));
    bench_start(&b);
    bench_add_octahedron(&b);
    bench_eliminate(&b, rounds);
    cr_expect_eq(b.e.live.size, left);
    bench_close(&b);
}

/* Plain elimination: all three cases come up. */
Test(imbert, theorems_hold)
{
    watch_octahedron(NULL, 3, 5870);
    cr_expect(seen.least > 0 && seen.above > 0 && seen.between > 0);
    cr_expect(seen.least < seen.minimal && seen.minimal < seen.rows, "only the rank decides some");
}

Test(imbert, octahedron)
{
    watch_octahedron("imbert", 3, 28);
}

/* Two rows that differ in the signs of x and y only, combined to cancel x, lose y by chance: y is
 * implicitly eliminated, and no more when a row brings it back. */
static bool sees_chance(void *state, const fmb_view *w, size_t row)
{
    uint64_t implicit;
    int *found = state;
    fmb_view_implicit(w, row, &implicit);
    if (fmb_view_column(w) == 0)
        found[implicit == 2]++;
    if (fmb_view_column(w) == 2 && fmb_view_sign(w, row, 1) != 0)
        cr_expect_eq(implicit & 2, 0);
    return false;
}

static int *counted;

static void keep_counts(void *state)
{
    counted[0] = ((int *)state)[0];
    counted[1] = ((int *)state)[1];
}

Test(imbert, implicit_afresh)
{
    static const fmb_rule rule = {.name = "chance",
                                  .flags = FMB_RULE_NEEDS_HISTORY,
                                  .source = "this test",
                                  .state_bytes = 2 * sizeof(int),
                                  .drop_row = sees_chance,
                                  .clear = keep_counts};
    static const int64_t row[][5] = {
        {1, 1, 1, 0, 1}, {-1, -1, 1, 0, 1}, {-1, 1, 1, 0, 1}, {0, 1, -1, 1, 1}, {0, 0, -1, 1, 2}};
    int found[2] = {0};
    bench b;
    counted = found;
    bench_open(&b, 4);
    bench_use(&b, &rule);
    bench_start(&b);
    for (int i = 0; i < 5; i++)
        bench_add(&b, row[i], FMB_LE);
    bool drop[4] = {true, false, true, false};
    cr_assert_eq(fmb_elim_eliminate(&b.e, drop), FMB_OK);
    bench_close(&b);
    cr_expect(found[1] == 1 && found[0] == 1, "%d and %d", found[1], found[0]);
}
