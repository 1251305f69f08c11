/* given_symmetries.c: given symmetries: the same answers and proofs as without; maps that are no
 * symmetry are refused; and rows of projections by classes. */
#include <criterion/criterion.h>

#include <stdlib.h>
#include <string.h>

#include <fmb/symmetry.h>

#include "fault/hook.h"
#include "property/random/agree.h"
#include "support.h"

enum { DIM = 8, KEPT = 4 };
static const int KEEP[KEPT] = {0, 1, 2, 3};

static fmb_solver *solver_with(fmb_method method, fmb_symmetries symmetry)
{
    return must_open((fmb_options){.method = method, .symmetry = symmetry});
}

/* ---- the same answers ------------------------------------------------------------------------ */

/* The permutation that rotates the kept variables by turn, the others by other. */
static fmb_permutations *rotation(int turn, int other)
{
    int image[DIM];
    fmb_permutations *p = NULL;
    must(fmb_permutations_new(DIM, NULL, &p));
    for (int j = 0; j < KEPT; j++) {
        image[j] = (j + turn) % KEPT;
        image[KEPT + j] = KEPT + (j + other) % KEPT;
    }
    must(fmb_permutations_add(p, image));
    return p;
}

/* [give] So many rows around the origin, each with its four images, now and then one twice as long,
 * and now and then an equality, of which the images are not all there. */
static fmb_system *rows_with_images(support_rng *g, int turn, int other, int orbits)
{
    fmb_system *s = rows_none(DIM);
    for (int i = 0; i < orbits; i++) {
        int64_t a[DIM], next[DIM], b = support_between(g, 5, 60);
        fmb_rel rel = support_chance(g, 10) ? FMB_LT : FMB_LE;
        for (int j = 0; j < DIM; j++)
            a[j] = support_chance(g, 60) ? support_between(g, -5, 5) : 0;
        for (int k = 0; k < KEPT; k++) {
            int64_t by = support_chance(g, 1) ? 2 : 1;
            for (int j = 0; j < DIM; j++)
                next[j] = by * a[j];
            must(fmb_system_add_int(s, next, rel, by * b));
            for (int j = 0; j < KEPT; j++) {
                next[(j + turn) % KEPT] = a[j];
                next[KEPT + (j + other) % KEPT] = a[KEPT + j];
            }
            memcpy(a, next, sizeof a);
        }
    }
    if (support_chance(g, 30))
        must(fmb_system_add_int(s, (int64_t[]){1, 1, 1, 1, -1, -1, -1, -1}, FMB_EQ, 1));
    return s;
}

static fmb_system *projection_by(fmb_solver *v, const fmb_system *s, uint64_t *programs)
{
    fmb_system *out = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    must(fmb_project(v, s, KEEP, KEPT, &out, &r));
    cr_assert(r.stop == FMB_STOP_DONE && r.verdict == FMB_FEASIBLE);
    *programs += r.stats.lps;
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted, "%s", j.reason);
    fmb_evidence_free(e);
    return out;
}

/* Orbits of rows by asking whether row k is what row i becomes, for all pairs. */
static size_t count_classes_plainly(const fmb_system *s, int turn, size_t *first)
{
    size_t m = fmb_system_rows(s), count = 0;
    int map[KEPT];
    for (int j = 0; j < KEPT; j++)
        map[j] = (j + turn) % KEPT;
    for (size_t i = 0; i < m; i++)
        first[i] = i;
    for (size_t round = 0; round < KEPT; round++)
        for (size_t i = 0; i < m; i++) {
            fmb_system *moved = rows_none(KEPT);
            rows_append(moved, s, i, ROW_SAME, map);
            for (size_t k = 0; k < m; k++)
                if (rows_equal(moved, 0, s, k)) {
                    size_t least = first[i] < first[k] ? first[i] : first[k];
                    first[i] = first[k] = least;
                }
            fmb_system_free(moved);
        }
    for (size_t i = 0; i < m; i++)
        count += first[i] == i;
    return count;
}

Test(given_symmetries, answers_and_classes_are_the_same)
{
    agree g = {.max_rows = 100000};
    size_t together = 0;
    uint64_t fewer = 0, more = 0;
    fmb_solver *with = solver_with(FMB_METHOD_HULL, FMB_SYMMETRY_AUTO);
    fmb_solver *without = solver_with(FMB_METHOD_HULL, FMB_SYMMETRY_NONE);
    for (uint64_t seed = 0; seed < 16; seed++) {
        support_rng rng = {seed};
        int turn = support_between(&rng, 1, KEPT - 1), other = support_between(&rng, 0, KEPT - 1);
        fmb_system *s = rows_with_images(&rng, turn, other, 4);
        fmb_permutations *p = rotation(turn, other);
        must(fmb_solver_set_symmetries(with, p));
        must(fmb_solver_set_symmetries(without, p));
        fmb_system *a = projection_by(with, s, &fewer), *b = projection_by(without, s, &more);
        cr_assert(agree_same(&g, a, b), "seed %lu: %s", (unsigned long)seed, g.why);
        cr_assert_eq(fmb_system_rows(a), fmb_system_rows(b));
        size_t m = fmb_system_rows(a), classes = 0;
        size_t *class_of = calloc(2 * m + 1, sizeof *class_of);
        must(fmb_rows_classes(a, p, KEEP, KEPT, class_of));
        for (size_t i = 0; i < m; i++)
            classes += class_of[i] == i;
        cr_assert_eq(classes, count_classes_plainly(a, turn, class_of + m));
        cr_assert(m == 0 || memcmp(class_of, class_of + m, m * sizeof *class_of) == 0);
        together += m - classes;
        free(class_of);
        fmb_system_free(a);
        fmb_system_free(b);
        fmb_permutations_free(p);
        fmb_system_free(s);
    }
    cr_expect_gt(together, 50, "%zu", together);
    cr_expect_lt(fewer, more - more / 4, "%lu %lu", (unsigned long)fewer, (unsigned long)more);
    fmb_solver_free(with);
    fmb_solver_free(without);
}

/* Two equalities, and rows that are images of each other but for them. */
Test(given_symmetries, rows_count_modulo_equalities)
{
    static const int all[4] = {0, 1, 2, 3}, swap[4] = {1, 0, 3, 2};
    fmb_system *s = rows_none(4);
    fmb_permutations *p = NULL;
    size_t class_of[4] = {9, 9, 9, 9};
    must(fmb_system_add_int(s, (int64_t[]){1, 0, -1, 0}, FMB_EQ, 0));
    must(fmb_system_add_int(s, (int64_t[]){1, -1, -1, 1}, FMB_EQ, 0));
    must(fmb_system_add_int(s, (int64_t[]){4, 0, -2, 0}, FMB_LE, 6));
    must(fmb_system_add_int(s, (int64_t[]){0, 0, 0, 1}, FMB_LE, 3));
    must(fmb_permutations_new(4, NULL, &p));
    must(fmb_permutations_add(p, swap));
    must(fmb_rows_classes(s, p, all, 4, class_of));
    cr_expect(class_of[0] == 0 && class_of[1] == 1 && class_of[2] == 2 && class_of[3] == 2);
    fmb_solver *v = solver_with(FMB_METHOD_AUTO, FMB_SYMMETRY_AUTO);
    fmb_system *out = NULL;
    must(fmb_solver_set_symmetries(v, p));
    must(fmb_project(v, s, all, 2, &out, NULL));
    fmb_system_free(out);
    fmb_solver_free(v);
    fmb_permutations_free(p);
    fmb_system_free(s);
}

/* ---- what is none ---------------------------------------------------------------------------- */

Test(given_symmetries, what_is_no_symmetry_is_refused)
{
    static const int two[2] = {0, 1}, swap[3] = {1, 0, 2}, out_of_kept[3] = {2, 1, 0};
    fmb_solver *v = solver_with(FMB_METHOD_AUTO, FMB_SYMMETRY_AUTO);
    fmb_system *s = rows_none(3), *small = rows_none(2), *out = s;
    fmb_permutations *p = NULL;
    must(fmb_system_add_int(s, (int64_t[]){1, 1, 1}, FMB_LE, 3));
    must(fmb_system_add_int(s, (int64_t[]){1, 0, -1}, FMB_LT, 1));
    must(fmb_permutations_new(3, NULL, &p));
    must(fmb_permutations_add(p, swap));
    must(fmb_solver_set_symmetries(v, p));
    cr_expect_eq(fmb_project(v, s, two, 2, &out, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "permutation 0 is no symmetry: row 1 has no image");
    cr_expect_eq(fmb_project(v, small, two, 2, &out, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "symmetries of 3 variables, but there are 2");
    must(fmb_permutations_add(p, out_of_kept));
    must(fmb_system_add_int(s, (int64_t[]){0, 1, -1}, FMB_LT, 1));
    must(fmb_solver_set_symmetries(v, p));
    cr_expect_eq(fmb_project(v, s, two, 2, &out, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v),
                     "permutation 1 takes variable 0 to 2: only one is kept");
    cr_expect_eq(out, s);
    must(fmb_solver_set_symmetries(v, NULL));
    must(fmb_project(v, s, two, 2, &out, NULL));
    size_t class_of[8];
    cr_expect_eq(fmb_rows_classes(out, p, two, 2, class_of), FMB_ERR_ARG);
    cr_expect_eq(fmb_rows_classes(out, NULL, two, 2, class_of), FMB_ERR_ARG);
    cr_expect_eq(fmb_rows_classes(s, p, two, 2, class_of), FMB_ERR_ARG);
    fmb_system_free(out);
    fmb_system_free(small);
    fmb_system_free(s);
    fmb_permutations_free(p);
    fmb_solver_free(v);
}

Test(given_symmetries, permutations_are_such)
{
    fmb_permutations *p = NULL;
    cr_expect_eq(fmb_permutations_new(-1, NULL, &p), FMB_ERR_ARG);
    cr_expect_eq(fmb_permutations_new(1, NULL, NULL), FMB_ERR_ARG);
    must(fmb_permutations_new(3, NULL, &p));
    cr_expect_eq(fmb_permutations_add(p, (int[]){0, 0, 1}), FMB_ERR_ARG);
    cr_expect_eq(fmb_permutations_add(p, (int[]){0, 3, 1}), FMB_ERR_ARG);
    cr_expect_eq(fmb_permutations_add(p, (int[]){0, -1, 1}), FMB_ERR_ARG);
    cr_expect_eq(fmb_permutations_add(p, NULL), FMB_ERR_ARG);
    must(fmb_permutations_add(p, (int[]){2, 0, 1}));
    cr_expect(fmb_permutations_size(p) == 1 && fmb_permutations_dim(p) == 3);
    cr_expect_eq(fmb_permutations_image(p, 0, 0), 2);
    cr_expect_eq(fmb_permutations_image(p, 0, 3), -1);
    cr_expect_eq(fmb_permutations_image(p, 1, 0), -1);
    cr_expect_eq(fmb_permutations_dim(NULL), 0);
    cr_expect_eq(fmb_solver_set_symmetries(NULL, p), FMB_ERR_ARG);
    fmb_permutations_free(p);
    fmb_permutations_free(NULL);
}

/* ---- found ----------------------------------------------------------------------------------- */

Test(given_symmetries, those_that_are_found_are_such)
{
    fmb_solver *v = solver_with(FMB_METHOD_AUTO, FMB_SYMMETRY_AUTO);
    for (uint64_t seed = 0; seed < 10; seed++) {
        support_rng rng = {seed};
        fmb_system *s = rows_with_images(&rng, 1, 1, 4), *out = NULL;
        fmb_permutations *p = NULL;
        must(fmb_symmetries_find(v, s, KEEP, KEPT, &p, NULL));
        cr_assert(p && fmb_permutations_dim(p) == DIM);
        must(fmb_solver_set_symmetries(v, p));
        must(fmb_project(v, s, KEEP, KEPT, &out, NULL));
        fmb_system_free(out);
        fmb_permutations_free(p);
        fmb_system_free(s);
    }
    fmb_permutations *p = NULL;
    cr_expect_eq(fmb_symmetries_find(v, NULL, KEEP, KEPT, &p, NULL), FMB_ERR_ARG);
    fmb_system *cube = rows_none(4);
    cr_expect_eq(fmb_symmetries_find(v, cube, NULL, 2, &p, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_symmetries_find(v, cube, (int[]){7}, 1, &p, NULL), FMB_ERR_ARG);
    fmb_system_free(cube);
    fmb_solver_free(v);
}

/* ---- text ------------------------------------------------------------------------------------ */

static const char CONE[] = "vars: \"H(A)\" \"H(B)\" \"H(A,B)\" z\n"
                           "\"H(A)\" <= \"H(A,B)\"\n2 \"H(B)\" <= 2 \"H(A,B)\"\n"
                           "\"H(A,B)\" <= \"H(A)\" + \"H(B)\"\nz >= \"H(A)\" + \"H(B)\"\n";

static fmb_system *parse(const char *text)
{
    fmb_system *s = NULL;
    fmb_where where;
    must(fmb_system_parse(text, strlen(text), NULL, &s, &where));
    return s;
}

Test(given_symmetries, texts_name_variables_or_letters)
{
    static const char *const texts[] = {
        "\"H(A)\" <> \"H(B)\"\n", "# both ways\n \"H(A)\", \"H(B)\" <> \"H(B)\" \"H(A)\" # so",
        "#:: a b\n#>> AB<>BA\n 0 0 1 2\n", "#>>A <> B"};
    fmb_system *s = parse(CONE);
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        fmb_permutations *p = NULL;
        fmb_where where = {0};
        must(fmb_permutations_parse(texts[i], strlen(texts[i]), NULL, s, KEEP, 3, &p, &where));
        cr_assert_eq(fmb_permutations_size(p), 1);
        for (int j = 0; j < 4; j++)
            cr_expect_eq(fmb_permutations_image(p, 0, j), j < 2 ? 1 - j : j);
        fmb_permutations_free(p);
    }
    fmb_permutations *p = NULL;
    FILE *file = tmpfile();
    cr_assert(fputs("#>> A<>B; AB<>AB\n", file) >= 0 && fflush(file) == 0);
    rewind(file);
    must(fmb_permutations_read(file, NULL, s, KEEP, 3, &p, NULL));
    cr_expect_eq(fmb_permutations_size(p), 2);
    fclose(file);
    fmb_permutations_free(p);
    fmb_system_free(s);
}

Test(given_symmetries, bad_texts_are_told_where)
{
    static const struct {
        const char *text;
        long line, column;
        const char *says;
    } bad[] = {
        {"# none\n", 0, 0, "expected lines NAMES <> NAMES, found none"},
        {"z <>", 1, 5, "expected names, '<>' and as many names, found end of file"},
        {"z z <> z", 1, 3, "expected each name once on a side, found 'z' again"},
        {"z y", 1, 3, "expected a variable of the system, found 'y'"},
        {"z <> z z", 1, 8, "expected names, '<>' and as many names, found 'z'"},
        {"z = z", 1, 3, "expected names, '<>' and as many names, found '='"},
        {"\n z <> \"H(A)\"", 2, 2, "expected a symmetry, but 'H(A)' is kept, and 'z' is not"},
        {"\"H(A)\" <> \"H(A,B)\"", 1, 1,
         "expected a symmetry, but row 1 would become none of the rows"},
        {"z <> z 3", 1, 8, "expected ';' or the end of the line, found '3'"},
        {"#>> AC<>CA", 1, 5, "expected a variable that 'H(A)' goes to, found none"},
        {"#>> AB<>A", 1, 9, "expected 2 letters, as on the left, found 1"},
        {"#>> AA<>BA", 1, 6, "expected each letter once on a side"},
        {"#>> AB BA", 1, 8, "expected names, '<>' and as many names, found 'BA'"},
        {"#>> <>BA", 1, 5, "expected letters, '<>' and as many letters, found '<>BA'"}};
    fmb_system *s = parse(CONE);
    fmb_permutations *p = NULL;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        fmb_where where = {0};
        cr_expect_eq(
            fmb_permutations_parse(bad[i].text, strlen(bad[i].text), NULL, s, KEEP, 3, &p, &where),
            FMB_ERR_PARSE);
        cr_expect(!p && where.line == bad[i].line && where.column == bad[i].column, "%zu: %ld:%ld",
                  i, where.line, where.column);
        cr_expect_str_eq(where.text, bad[i].says);
    }
    fmb_system *twins = parse("vars: x12 x21\nx12 <= x21\n");
    fmb_where where;
    cr_expect_eq(fmb_permutations_parse("#>> 1<>2", 8, NULL, twins, KEEP, 2, &p, &where),
                 FMB_ERR_PARSE);
    cr_expect_str_eq(where.text, "expected names of different letters, found 'x12' and 'x21'");
    cr_expect_eq(fmb_permutations_parse("z<>z", 4, NULL, NULL, KEEP, 3, &p, &where), FMB_ERR_ARG);
    cr_expect_eq(fmb_permutations_parse("z<>z", 4, NULL, s, NULL, 3, &p, &where), FMB_ERR_ARG);
    cr_expect_eq(fmb_permutations_parse("z<>z", 4, NULL, s, (int[]){9}, 1, &p, &where),
                 FMB_ERR_ARG);
    cr_expect_eq(fmb_permutations_parse(NULL, 4, NULL, s, KEEP, 3, &p, &where), FMB_ERR_ARG);
    cr_expect_eq(fmb_permutations_read(NULL, NULL, s, KEEP, 3, &p, &where), FMB_ERR_ARG);
    fmb_system_free(twins);
    fmb_system_free(s);
}

/* ---- memory that runs out -------------------------------------------------------------------- */

static fmb_status ask_for_everything(const fmb_alloc *mem, const fmb_system *s,
                                     const fmb_permutations *given)
{
    const fmb_reader how = {.size = sizeof how, .mem = mem};
    fmb_options o = {.size = sizeof o};
    fmb_permutations *p = NULL, *found = NULL;
    fmb_solver *v = NULL;
    fmb_system *out = NULL;
    size_t class_of[256];
    o.method = FMB_METHOD_HULL;
    fmb_status st = fmb_solver_new(&o, mem, &v);
    if (st == FMB_OK)
        st = fmb_permutations_parse("x1 x2 x3 x4 <> x2 x3 x4 x1; #", 28, &how, s, KEEP, KEPT, &p,
                                    NULL);
    if (st == FMB_ERR_PARSE)
        st = fmb_permutations_parse("x1 <> x1", 8, &how, s, KEEP, KEPT, &p, NULL);
    if (st == FMB_OK)
        st = fmb_symmetries_find(v, s, KEEP, KEPT, &found, NULL);
    if (st == FMB_OK)
        st = fmb_solver_set_symmetries(v, given);
    if (st == FMB_OK)
        st = fmb_project(v, s, KEEP, KEPT, &out, NULL);
    if (st == FMB_OK && fmb_system_rows(out) <= 256)
        st = fmb_rows_classes(out, given, KEEP, KEPT, class_of);
    fmb_system_free(out);
    fmb_permutations_free(found);
    fmb_permutations_free(p);
    fmb_solver_free(v);
    return st;
}

Test(given_symmetries, every_request_may_fail)
{
    support_rng rng = {3};
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_system *s = rows_with_images(&rng, 1, 1, 3);
    fmb_permutations *p = rotation(1, 1);
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st == FMB_ERR_MEMORY; k += 1 + k / 64) {
        hook_arm(&h, k, k % 2 == 0);
        st = ask_for_everything(&mem, s, p);
        hook_calm(&h);
        cr_assert(st == FMB_OK || st == FMB_ERR_MEMORY);
        cr_assert_eq(h.live, 0, "request %zu: %zu bytes leak", k, h.live);
    }
    fmb_permutations_free(p);
    fmb_system_free(s);
}
