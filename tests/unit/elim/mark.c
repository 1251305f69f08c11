/* mark.c: an elimination returns to a mark unchanged: rows, histories, the box and the state of a
 * rule are restored after rounds, a substitution and a new base. */
#include <criterion/criterion.h>
#include <string.h>

#include "elim/history/filter.h"
#include "elim/round/mark.h"
#include "unit/rule/bench.h"

enum { DIM = 4, MOST = 64 };

/* A rule that counts what it is asked, and drops nothing. */
static bool count_question(void *state, const fmb_view *w, size_t row)
{
    (void)w;
    (void)row;
    ++*(int *)state;
    return false;
}

static const fmb_rule counter = {.name = "counter",
                                 .source = "this test",
                                 .flags = FMB_RULE_NEEDS_HISTORY,
                                 .state_bytes = sizeof(int),
                                 .drop_row = count_question};

/* What an elimination knows, read out of it. */
typedef struct picture {
    size_t rows, live, bases, silents;
    const uint64_t *silent[MOST];
    uint32_t row[MOST], base[MOST], box_row[2][DIM];
    uint64_t history[MOST], gone;
    int64_t box_end[2][DIM], unit;
    int rounds, since, asked;
    bool based;
} picture;

static picture take_picture(const fmb_elim *e)
{
    picture p;
    memset(&p, 0, sizeof p); /* pictures are compared as they stand */
    p.rows = e->rows;
    p.live = e->live.size;
    p.bases = e->bases;
    p.silents = e->filter->silents;
    memcpy(p.silent, e->filter->silent, p.silents * sizeof *p.silent);
    p.gone = e->gone[0];
    p.unit = e->box.unit;
    p.rounds = e->rounds;
    p.since = e->since;
    p.asked = *(int *)e->worker[e->workers - 1].state;
    p.based = e->based;
    for (size_t i = 0; i < p.live; i++) {
        p.row[i] = e->live.row[i];
        p.history[i] = e->row[p.row[i]].history[0];
    }
    memcpy(p.base, e->base, p.bases * sizeof *p.base);
    for (int side = 0; side < 2; side++)
        for (int j = 0; j < DIM; j++) {
            p.box_row[side][j] = e->box.row[side][j];
            p.box_end[side][j] = p.box_row[side][j] == FMB_NO_ROW ? 0 : e->box.end[side][j];
        }
    return p;
}

/* 0 <= x <= 10, rows that pair x0, and x2 = x3 + 1, which moves the ends of x3. */
static void open_elimination(bench *b)
{
    bench_open(b, DIM);
    b->how.steps |= FMB_STEP_BOUNDS;
    bench_use(b, fmb_rule_find("kohler"));
    bench_use(b, fmb_rule_find("chernikov"));
    bench_use(b, &counter);
    bench_start(b);
    for (int j = 0; j < DIM; j++) {
        bench_add(b, (int64_t[]){j == 0, j == 1, j == 2, j == 3, 10}, FMB_LE);
        bench_add(b, (int64_t[]){-(j == 0), -(j == 1), -(j == 2), -(j == 3), 0}, FMB_LE);
    }
    bench_add(b, (int64_t[]){1, 1, 0, 0, 12}, FMB_LE);
    bench_add(b, (int64_t[]){-1, 0, 1, 0, 5}, FMB_LE);
    bench_add(b, (int64_t[]){1, 0, 0, -1, 7}, FMB_LE);
    bench_add(b, (int64_t[]){-1, -1, 0, 0, -1}, FMB_LE);
    bench_add(b, (int64_t[]){0, 1, 0, 1, 9}, FMB_LE);
    bench_add(b, (int64_t[]){0, -1, 0, 2, 11}, FMB_LE);
    bench_add(b, (int64_t[]){0, 0, 1, -1, 1}, FMB_EQ);
}

static void eliminate_only(bench *b, int var)
{
    bool drop[DIM] = {false};
    drop[var] = true;
    cr_assert_eq(fmb_elim_eliminate(&b->e, drop), FMB_OK);
}

Test(mark, what_was_known_is_known_again)
{
    bench b;
    fmb_mark mark;
    open_elimination(&b);
    eliminate_only(&b, 0);
    cr_assert_eq(fmb_mark_set(&mark, &b.e), FMB_OK);
    const picture before = take_picture(&b.e);
    for (int again = 0; again < 2; again++) {
        eliminate_only(&b, 2);
        eliminate_only(&b, 1);
        const picture after = take_picture(&b.e);
        cr_assert_eq(b.e.clash, FMB_NO_ROW);
        cr_assert_neq(memcmp(after.box_row, before.box_row, sizeof after.box_row), 0);
        cr_assert_neq(memcmp(after.box_end, before.box_end, sizeof after.box_end), 0);
        cr_assert(after.gone != before.gone && after.asked > before.asked);
        cr_assert(before.silents > 0 && after.silents != before.silents);
        fmb_mark_return(&mark, &b.e);
        const picture back = take_picture(&b.e);
        cr_assert_eq(memcmp(back.box_row, before.box_row, sizeof back.box_row), 0, "box rows");
        cr_assert_eq(memcmp(back.box_end, before.box_end, sizeof back.box_end), 0, "box ends");
        cr_assert_eq(memcmp(back.row, before.row, sizeof back.row), 0, "live rows");
        cr_assert_eq(memcmp(back.history, before.history, sizeof back.history), 0, "histories");
        cr_assert_eq(memcmp(&back, &before, sizeof back), 0, "all the rest");
    }
    bench_close(&b);
}
