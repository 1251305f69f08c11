/* own_table.c: what <fmb/rule.h> shows to a rule besides rows: its own table, and numbers as text.
 */
#include <criterion/criterion.h>
#include <string.h>

#include "property/random/rows.h"

/* A rule that holds what it knows: it may see its own table. */
typedef struct knowing_rule {
    fmb_rule table;
    int calls;
} knowing_rule;

static void expect_texts(const fmb_view *w, size_t row)
{
    for (int col = 0; col <= fmb_view_dim(w); col++) {
        char text[40], expected[40];
        snprintf(expected, sizeof expected, "%lld", (long long)fmb_view_int64(w, row)[col]);
        cr_expect_eq(fmb_view_text(w, row, col, text, sizeof text), strlen(expected));
        cr_expect_str_eq(text, expected);
    }
}

static fmb_status look_at_texts(void *state, const fmb_view *w, bool *drop)
{
    knowing_rule *own = (knowing_rule *)fmb_view_rule(w);
    (void)state;
    (void)drop;
    own->calls++;
    for (size_t i = 0; i < fmb_view_rows(w); i++)
        expect_texts(w, fmb_view_row(w, i));
    return FMB_OK;
}

static int choose_without_rule(void *self, const fmb_view *w, const int *col, size_t n)
{
    (void)self;
    (void)n;
    cr_expect_null(fmb_view_rule(w));
    return col[0];
}

Test(window, own_table_and_texts)
{
    static const int64_t row[][4] = {{1, 1, 1, 6},   {1, -1, 0, 1},  {-1, 0, 1, 1},
                                     {-1, -1, 0, 3}, {0, -1, -1, 3}, {-1, 1, -1, 2}};
    knowing_rule own = {.table = {.name = "own", .end_round = look_at_texts}};
    fmb_system *s = rows_none(3);
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    fmb_options o = {.size = sizeof o, .method = FMB_METHOD_FM, .rules = "none"};
    char text[4];
    for (int i = 0; i < 6; i++)
        must(fmb_system_add_int(s, row[i], FMB_LE, row[i][3]));
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solver_add_rule(v, &own.table));
    fmb_solver_set_chooser(v, (fmb_chooser){choose_without_rule, NULL});
    cr_expect_eq(fmb_solve(v, s, &r), FMB_OK);
    cr_expect_gt(own.calls, 0);
    cr_expect_null(fmb_view_rule(NULL));
    cr_expect_eq(fmb_view_text(NULL, 0, 0, text, sizeof text), 1);
    cr_expect_str_eq(text, "0");
    fmb_solver_free(v);
    fmb_system_free(s);
}
