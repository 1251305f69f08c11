/* kohler.c: the bound of Kohler's rule: k + 1. */
#include <criterion/criterion.h>

#include "bench.h"
#include "cuboids.h"

/* Rows made, and those of more than k + 1 base rows among them. */
static int rows, large;

static int size_of(const uint64_t *set, size_t words)
{
    int n = 0;
    for (size_t k = 0; k < words; k++)
        n += __builtin_popcountll(set[k]);
    return n;
}

static bool look(void *state, const fmb_view *w, size_t row)
{
    size_t words;
    const uint64_t *history = fmb_view_history(w, row, &words);
    (void)state;
    rows++;
    large += size_of(history, words) > fmb_view_eliminated(w) + 1;
    return false;
}

static const fmb_rule spy = {
    .name = "spy", .flags = FMB_RULE_NEEDS_HISTORY, .source = "this test", .drop_row = look};

static size_t octahedron_left(bool with)
{
    bench b;
    rows = large = 0;
    bench_open(&b, 4);
    bench_use(&b, &spy);
    if (with)
        bench_use(&b, fmb_rule_find("kohler"));
    bench_start(&b);
    bench_add_octahedron(&b);
    bench_eliminate(&b, 3);
    size_t left = b.e.live.size;
    bench_close(&b);
    return left;
}

Test(kohler, k_plus_one_base_rows)
{
    cr_expect_eq(octahedron_left(false), 5870);
    cr_expect_gt(large, 0, "a test that cannot fail");
    cr_expect_eq(octahedron_left(true), 48);
    cr_expect(rows > 0 && large == 0, "%d of %d rows are too large", large, rows);
}

Test(kohler, moving_cuboids)
{
    double without = cuboids_rows_made("none", "none"), with = cuboids_rows_made("kohler", "none");
    cr_expect(382.5 < without && without < 383.5, "%g rows without", without);
    cr_expect(60 < with && with < 61, "%g rows with it", with);
}
