/* rules.c: what the rules promise, on systems small enough to count by hand; and what squeezing
 * leaves out. */
#include <criterion/criterion.h>

#include <string.h>

#include "elim/elim.h"
#include "elim/witness.h"

/* An elimination of integer rows a.x REL b over n variables. */
typedef struct bench {
    fmb_mem mem;
    fmb_arena arena;
    fmb_run run;
    atomic_int cancel;
    fmb_elim e;
} bench;

static void open_bench(bench *b, int n, const char *rules)
{
    fmb_options o = fmb_options_default();
    const fmb_rule *rule[FMB_MAX_RULES];
    fmb_elim_options how = {.order = FMB_ORDER_GIVEN, .steps = FMB_STEP_EQUALITIES, .rule = rule};
    *b = (bench){0};
    for (size_t i = 0; fmb_rule_at(i); i++)
        if (strstr(rules, fmb_rule_at(i)->name))
            rule[how.rules++] = fmb_rule_at(i);
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_arena_init(&b->arena, &b->mem);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    cr_assert_eq(fmb_elim_init(&b->e, &b->run, &b->arena, n, &how), FMB_OK);
}

static void add(bench *b, const int64_t *row, fmb_rel rel)
{
    int64_t words[16];
    fmb_vec v = {.s = words};
    for (int j = 0; j <= b->e.n; j++)
        words[j] = row[j];
    fmb_vec_measure(&v, (size_t)b->e.n + 1);
    cr_assert_eq(fmb_elim_add(&b->e, &v, rel), FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_elim_clear(&b->e);
    fmb_arena_clear(&b->arena);
    cr_assert_eq(b->mem.used, 0);
}

/* The cube |x_i| <= 1, sheared: x_i - x_{i+1} as well. */
static void add_cube(bench *b)
{
    int64_t row[8];
    for (int j = 0; j < b->e.n; j++)
        for (int sign = -1; sign <= 1; sign += 2) {
            memset(row, 0, sizeof row);
            row[j] = sign;
            if (j + 1 < b->e.n)
                row[j + 1] = -sign;
            row[b->e.n] = 1;
            add(b, row, FMB_LE);
        }
}

/* Rows made when all but the last variable of the sheared cube go. */
static uint64_t rows_made(const char *rules, size_t *left)
{
    bench b;
    bool drop[4] = {true, true, true, false};
    open_bench(&b, 4, rules);
    add_cube(&b);
    for (int64_t s = -1; s <= 1; s += 2) { /* and some rows that make it grow */
        add(&b, (int64_t[]){s, s, 0, 1, 5}, FMB_LE);
        add(&b, (int64_t[]){s, -s, s, 1, 7}, FMB_LE);
    }
    cr_assert_eq(fmb_elim_eliminate(&b.e, drop), FMB_OK);
    cr_assert_eq(b.e.clash, FMB_NO_ROW);
    *left = b.e.live.size;
    uint64_t made = b.run.stats.rows_made;
    close_bench(&b);
    return made;
}

Test(rules, kohler_makes_fewer_rows)
{
    size_t plain_left, kohler_left;
    uint64_t plain = rows_made("none", &plain_left), kohler = rows_made("kohler", &kohler_left);
    cr_assert_lt(kohler, plain);
    cr_assert_lt(kohler_left, plain_left);
}

Test(rules, duplicate_keeps_one_and_the_strict_one)
{
    bench b;
    bool drop[2] = {true, false};
    open_bench(&b, 2, "duplicate");
    add(&b, (int64_t[]){1, 1, 1}, FMB_LE);
    add(&b, (int64_t[]){2, 2, 2}, FMB_LT);
    add(&b, (int64_t[]){-1, 0, 0}, FMB_LE);
    cr_assert_eq(fmb_elim_eliminate(&b.e, drop), FMB_OK);
    cr_assert_eq(b.e.live.size, 1, "both pairs give x2 <= 1, once strictly");
    cr_assert(b.e.row[b.e.live.row[0]].strict);
    close_bench(&b);
}

Test(rules, are_found_by_name)
{
    cr_assert_str_eq(fmb_rule_find("kohler")->name, "kohler");
    cr_assert_null(fmb_rule_find("kohle"));
    cr_assert_null(fmb_rule_find("kohler,"));
    for (size_t i = 0; fmb_rule_at(i); i++)
        cr_assert_eq(fmb_rule_find(fmb_rule_at(i)->name), fmb_rule_at(i));
}

Test(elim, the_last_variable_combines_one_pair)
{
    bench b;
    bool drop[1] = {true};
    open_bench(&b, 1, "none");
    for (int64_t k = 1; k <= 20; k++) {
        add(&b, (int64_t[]){3, 10 + k}, FMB_LE);
        add(&b, (int64_t[]){-3, k - 9}, FMB_LE);
    }
    cr_assert_eq(fmb_elim_eliminate(&b.e, drop), FMB_OK);
    cr_assert_eq(b.run.stats.rows_made, 1);
    cr_assert_eq(b.e.clash, FMB_NO_ROW, "8/3 <= x <= 11/3");
    close_bench(&b);
}

Test(elim, strict_bounds_that_touch_clash)
{
    for (int strict = 0; strict < 2; strict++) {
        bench b;
        bool drop[1] = {true};
        open_bench(&b, 1, "none");
        add(&b, (int64_t[]){2, 6}, FMB_LE);
        add(&b, (int64_t[]){1, 3}, strict ? FMB_LT : FMB_LE);
        add(&b, (int64_t[]){-5, -15}, FMB_LE);
        cr_assert_eq(fmb_elim_eliminate(&b.e, drop), FMB_OK);
        cr_assert_eq(b.e.clash != FMB_NO_ROW, strict);
        close_bench(&b);
    }
}

Test(witness, simple_numbers_first)
{
    static const struct {
        int lower, lower_den, lower_open, upper, upper_den, upper_open, num, den;
    } cases[] = {
        {-3, 2, 0, 5, 1, 0, 0, 1},   {1, 2, 0, 5, 1, 0, 1, 1},    {1, 1, 1, 5, 1, 0, 2, 1},
        {1, 3, 0, 1, 2, 0, 1, 3},    {1, 3, 1, 1, 2, 1, 5, 12},   {-7, 2, 0, -5, 2, 0, -3, 1},
        {-1, 2, 0, -1, 3, 0, -1, 3}, {-2, 1, 0, -1, 1, 1, -2, 1}, {0, 1, 1, 1, 1, 1, 1, 2},
        {3, 7, 0, 3, 7, 0, 3, 7},
    };
    mpq_t lower, upper, x;
    mpq_inits(lower, upper, x, NULL);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mpq_set_si(lower, cases[i].lower, (unsigned long)cases[i].lower_den);
        mpq_set_si(upper, cases[i].upper, (unsigned long)cases[i].upper_den);
        fmb_simple_between(x, lower, cases[i].lower_open, upper, cases[i].upper_open);
        cr_assert_eq(mpq_cmp_si(x, cases[i].num, (unsigned long)cases[i].den), 0, "case %zu", i);
    }
    mpq_set_si(lower, 5, 2);
    fmb_simple_between(x, lower, false, NULL, false);
    cr_assert_eq(mpq_cmp_si(x, 3, 1), 0);
    mpq_set_si(upper, -5, 2);
    fmb_simple_between(x, NULL, false, upper, true);
    cr_assert_eq(mpq_cmp_si(x, -3, 1), 0);
    mpq_clears(lower, upper, x, NULL);
}
