/* smt2_scripts.c: scripts with several checks: the system of each check. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

static fmb_status open_script(const char *text, const fmb_alloc *mem, fmb_script **out,
                              fmb_where *where)
{
    FILE *in = fmemopen((char *)(uintptr_t)text, strlen(text), "r");
    cr_assert(in);
    fmb_status st =
        fmb_script_read(in, &(fmb_reader){.size = sizeof(fmb_reader), .mem = mem}, out, where);
    fclose(in);
    return st;
}

/* The questions of a script as .fmb text, "-- " between them. */
static char *all_questions(const char *text)
{
    char *said = NULL;
    size_t size;
    FILE *out = open_memstream(&said, &size);
    fmb_script *s = NULL;
    fmb_where where = {0};
    fmb_script_kind kind = FMB_SCRIPT_CHECK;
    cr_assert(open_script(text, NULL, &s, &where) == FMB_OK, "%s", where.text);
    cr_expect(fmb_script_asks_often(s));
    for (bool first = true; kind != FMB_SCRIPT_END; first = false) {
        fmb_system *q = NULL;
        cr_assert(fmb_script_next(s, &kind, &where) == FMB_OK, "%s", where.text);
        if (kind == FMB_SCRIPT_END)
            break;
        cr_assert(fmb_script_question(s, &q, &where) == FMB_OK, "%s", where.text);
        fputs(first ? "" : "-- ", out);
        cr_assert(fmb_system_write(q, FMB_FORMAT_TEXT, out) == FMB_OK);
        fmb_system_free(q);
    }
    fclose(out);
    fmb_script_free(s);
    return said;
}

#define X "(declare-const x Real)"

Test(smt2_scripts, questions)
{
    static const meaning table[] = {
        {X "(assert (<= x 1))(check-sat)(assert (< x 0))(check-sat)",
         "vars: x\nx <= 1\n-- vars: x\nx <= 1\nx < 0\n"},
        {X "(push)(assert (<= x 1))(push 2)(assert (<= x 2))(check-sat)(pop "
           "2)(check-sat)(pop)(check-sat)",
         "vars: x\nx <= 1\nx <= 2\n-- vars: x\nx <= 1\n-- vars: x\n"},
        {X "(assert (<= x 1))(push 0)(pop 0)(check-sat-assuming ((< x 3) (= x 2)))(check-sat)",
         "vars: x\nx <= 1\nx < 3\nx = 2\n-- vars: x\nx <= 1\n"},
        {X "(check-sat-assuming ())(check-sat-assuming\n((< x 3)))",
         "vars: x\n-- vars: x\nx < 3\n"},
        {"(set-option :global-declarations true)(push)" X
         "(assert (< x 1))(pop)(assert (> x 2))(check-sat)",
         "vars: x\n-x < -2\n"},
        {X "(push)(declare-const y Bool)(assert y)(assert (=> y (< x 1)))(check-sat)(pop)"
           "(declare-const y Real)(check-sat)",
         "vars: x\nx < 1\n-- vars: x y\n"},
        {X "(assert (< x 1))(push)(reset)(declare-const z Real)(check-sat)(exit)(check-sat)",
         "vars: z\n"},
        {"(push)" X "(assert (< x 1))(reset-assertions)(declare-const y Real)(check-sat)",
         "vars: y\n"},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        char *said = all_questions(table[i].text);
        cr_expect_str_eq(said, table[i].says, "%s", table[i].text);
        free(said);
    }
}

/* One question is no such script. */
Test(smt2_scripts, one_question)
{
    fmb_script *s = NULL;
    fmb_system *whole = NULL;
    fmb_where where;
    cr_assert(open_script(X "(assert (< x 1))(check-sat)(get-model)", NULL, &s, &where) == FMB_OK);
    cr_expect(!fmb_script_asks_often(s));
    cr_assert(fmb_script_whole(s, &whole, &where) == FMB_OK);
    cr_expect(fmb_system_rows(whole) == 1);
    fmb_system_free(whole);
    fmb_script_free(s);
    fmb_script_free(NULL);
}

/* Terms are forms over what holds there; errors have the places of the script. */
Test(smt2_scripts, terms)
{
    fmb_script *s = NULL;
    fmb_where where;
    fmb_script_kind kind;
    const char *text;
    size_t size;
    fmb_system *form = NULL;
    cr_assert(open_script(X "(push)(maximize x)(check-sat)\n(get-value ((* 2 x) (+ x 1) true))",
                          NULL, &s, &where) == FMB_OK);
    cr_expect(fmb_script_next(s, &kind, &where) == FMB_OK && kind == FMB_SCRIPT_CHECK);
    cr_expect(fmb_script_next(s, &kind, &where) == FMB_OK && kind == FMB_SCRIPT_VALUE);
    for (size_t i = 0; i < 2; i++) {
        mpq_t q;
        mpq_init(q);
        cr_assert(fmb_script_term(s, i, &text, &size, &form, &where) == FMB_OK, "%s", where.text);
        cr_expect(size == 7 && memcmp(text, i == 0 ? "(* 2 x)" : "(+ x 1)", 7) == 0);
        cr_expect(fmb_system_objective_term_q(form, 0, q) == 0 && mpq_cmp_ui(q, 2 - i, 1) == 0);
        mpq_clear(q);
        fmb_system_free(form);
    }
    cr_expect(fmb_script_term(s, 2, &text, &size, &form, &where) == FMB_ERR_PARSE);
    cr_expect(where.line == 2 && where.column == 29, "%ld:%ld", where.line, where.column);
    cr_expect(fmb_script_term(s, 3, &text, &size, &form, &where) == FMB_OK && !text);
    fmb_script_free(s);
}

Test(smt2_scripts, mistakes)
{
    fmb_script *s = NULL;
    fmb_where where;
    fmb_script_kind kind;
    cr_expect(open_script("(push", NULL, &s, &where) == FMB_ERR_PARSE && where.line == 1);
    cr_expect(open_script("(check-sat-assuming x)", NULL, &s, &where) == FMB_ERR_PARSE);
    cr_assert(open_script("\n (pop)", NULL, &s, &where) == FMB_OK);
    cr_expect(fmb_script_next(s, &kind, &where) == FMB_ERR_PARSE);
    cr_expect(where.line == 2 && where.column == 2);
    fmb_script_free(s);
    cr_assert(open_script("(push 99999999999999999999999)", NULL, &s, &where) == FMB_OK);
    cr_expect(fmb_script_next(s, &kind, &where) == FMB_ERR_PARSE);
    fmb_script_free(s);
    cr_expect(fmb_script_read(NULL, NULL, &s, &where) == FMB_ERR_ARG);
}

/* Every request for memory may fail. */
Test(smt2_scripts, memory)
{
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t left = 0; st == FMB_ERR_MEMORY; left++) {
        countdown c = {.left = left};
        const fmb_alloc mem = countdown_alloc(&c);
        fmb_script *s = NULL;
        fmb_system *q = NULL;
        fmb_where where;
        fmb_script_kind kind;
        st = open_script(X "(declare-const p Bool)(assert (=> p (< x 2)))(push)(assert p)"
                           "(declare-const y Real)(check-sat)(pop)(assert (not p))"
                           "(check-sat-assuming ((< x 1)))",
                         &mem, &s, &where);
        for (int check = 0; check < 2; check++) {
            if (st == FMB_OK)
                st = fmb_script_next(s, &kind, &where);
            if (st == FMB_OK)
                st = fmb_script_question(s, &q, &where);
            cr_expect(st == FMB_OK || st == FMB_ERR_MEMORY);
            fmb_system_free(q);
            q = NULL;
        }
        fmb_script_free(s);
        cr_expect_eq(c.live, 0);
    }
}
