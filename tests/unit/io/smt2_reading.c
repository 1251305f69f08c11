/* smt2_reading.c: in a script with many checks, each check means the commands so far, and each
 * command is read a bounded number of times. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "io/smt2/script/script_private.h"
#include "support/support.h"

static void must(fmb_status st, const fmb_where *where)
{
    cr_assert(st == FMB_OK, "%s: %s", fmb_status_text(st), where->text);
}

static fmb_script *open_text(const char *text)
{
    fmb_script *s = NULL;
    fmb_where where = {0};
    must(fmb_script_parse(text, strlen(text), NULL, &s, &where), &where);
    return s;
}

/* ---- how much is read ------------------------------------------------------------------------ */

/* A script of n rows in front of n checks, each between a push and a pop, with a row of its own. */
static char *make_checks(size_t n)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fputs("(declare-const x Real)(declare-const p Bool)\n", out);
    for (size_t i = 0; i < n; i++)
        fprintf(out, "(assert (! (<= (* 2 x) %zu) :named r%zu))\n", 1000 + i, i);
    for (size_t i = 0; i < n; i++)
        fprintf(out,
                "(push)(declare-const y Real)(assert (and p (<= x y %zu)))(check-sat)(pop)"
                "(check-sat-assuming (r%zu))(get-value (x 1 (+ x 2)))\n",
                i, i);
    fclose(out);
    return text;
}

/* Ask all that the script asks; rows of the last question. */
static size_t ask_everything(fmb_script *s)
{
    fmb_where where = {0};
    size_t rows = 0;
    for (;;) {
        fmb_script_kind kind;
        fmb_system *q = NULL;
        const char *term = "";
        must(fmb_script_next(s, &kind, &where), &where);
        if (kind == FMB_SCRIPT_END)
            return rows;
        for (size_t i = 0, size; kind == FMB_SCRIPT_VALUE && term; i++) {
            must(fmb_script_term(s, i, &term, &size, &q, &where), &where);
            if (term)
                fmb_system_free(q);
        }
        if (kind == FMB_SCRIPT_VALUE)
            continue;
        must(fmb_script_question(s, &q, &where), &where);
        rows = fmb_system_rows(q);
        fmb_system_free(q);
    }
}

static size_t tokens_of_checks(size_t n)
{
    char *text = make_checks(n);
    fmb_script *s = open_text(text);
    size_t before = fmb_script_tokens(s);
    cr_expect_eq(ask_everything(s), n + 1);
    size_t after = fmb_script_tokens(s);
    cr_expect(after <= 3 * before, "%zu tokens, %zu of them read after that", before,
              after - before);
    fmb_script_free(s);
    free(text);
    return after;
}

/* 200 checks behind 200 rows: finding the commands and understanding them reads each token twice,
 * and a list of terms once more. */
Test(smt2_reading, is_linear)
{
    size_t few = tokens_of_checks(20), many = tokens_of_checks(200);
    cr_expect(many <= 10 * few, "%zu tokens for 20 checks, %zu for 200", few, many);
}

/* A fact that a later command tells has what holds read again, once, not once a check. */
Test(smt2_reading, facts_once)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fputs("(declare-const x Real)(declare-const p Bool)(assert (=> p (< x 1)))(assert p)\n", out);
    for (size_t i = 0; i < 200; i++)
        fprintf(out, "(assert (< x %zu))(push)(assert (=> (< x 2) p))(check-sat)(pop)\n", i);
    fclose(out);
    fmb_script *s = open_text(text);
    size_t before = fmb_script_tokens(s);
    cr_expect_eq(ask_everything(s), 201);
    cr_expect(fmb_script_tokens(s) <= 3 * before, "%zu tokens became %zu", before,
              fmb_script_tokens(s));
    fmb_script_free(s);
    free(text);
}

/* ---- what it means --------------------------------------------------------------------------- */

enum { NAMES = 4, MOST = 120 };

/* A script on its way, and the commands that hold at its end, as a text of their own. */
typedef struct writer {
    support_rng g;
    FILE *out;
    char *command[MOST];
    size_t level[MOST + 1], commands, levels;
    bool declaration[MOST], global;
} writer;

static const char *random_number_term(writer *w, char buf[64])
{
    snprintf(buf, 64, "(- (* %d x%d) (* %d x%d))", support_between(&w->g, 0, 2),
             support_between(&w->g, 0, NAMES - 1), support_between(&w->g, 0, 2),
             support_between(&w->g, 0, NAMES - 1));
    return buf;
}

static const char *random_atom(writer *w, char buf[128])
{
    static const char *const rel[] = {"<=", "<", "=", ">="};
    char term[64];
    switch (support_between(&w->g, 0, 5)) {
    case 0:
        snprintf(buf, 128, "p%d", support_between(&w->g, 0, 2));
        break;
    case 1:
        snprintf(buf, 128, "(f %s)", random_number_term(w, term));
        break;
    default:
        snprintf(buf, 128, "(%s %s %d)", rel[support_between(&w->g, 0, 3)],
                 random_number_term(w, term), support_between(&w->g, 0, 4));
    }
    return buf;
}

static const char *random_formula(writer *w, char buf[512])
{
    char a[128], b[128];
    random_atom(w, a);
    random_atom(w, b);
    switch (support_between(&w->g, 0, 5)) {
    case 0:
        snprintf(buf, 512, "(and %s (not %s))", a, b);
        break;
    case 1:
        snprintf(buf, 512, "(=> p%d %s)", support_between(&w->g, 0, 2), a);
        break;
    case 2:
        snprintf(buf, 512, "(let ((p0 %s)) (and p0 %s))", a, b);
        break;
    case 3:
        snprintf(buf, 512, "(! %s :named a%d)", a, support_between(&w->g, 0, 9));
        break;
    default:
        snprintf(buf, 512, "%s", a);
    }
    return buf;
}

/* The system as text, or "" and the status. */
static char *text_of(fmb_status st, fmb_system *q, const fmb_where *where)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (st == FMB_OK)
        cr_assert(fmb_system_write(q, FMB_FORMAT_TEXT, out) == FMB_OK);
    else
        fprintf(out, "%s: %s", fmb_status_text(st), where->text);
    fclose(out);
    return text;
}

/* What holds now, with an assumption or one more command or neither, asked afresh. */
static char *ask_afresh(const writer *w, const char *assumption, const char *command, bool *good)
{
    char *text = NULL;
    size_t size;
    fmb_where where = {0};
    fmb_system *q = NULL;
    FILE *out = open_memstream(&text, &size);
    for (size_t k = 0; k < w->commands; k++)
        fputs(w->command[k], out);
    if (assumption)
        fprintf(out, "(assert (and true %s))", assumption);
    if (command)
        fputs(command, out);
    fclose(out);
    const fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_SMT2};
    fmb_status st = fmb_system_parse(text, size, &how, &q, &where);
    free(text);
    text = text_of(st, q, &where);
    *good = st == FMB_OK;
    if (st == FMB_OK)
        fmb_system_free(q);
    return text;
}

static void add_command(writer *w, bool declaration, const char *text)
{
    fputs(text, w->out);
    w->declaration[w->commands] = declaration;
    w->command[w->commands++] = strdup(text);
}

/* Mostly only what can be read behind the others: most questions are to have an answer. */
static void try_command(writer *w, bool declaration, const char *text)
{
    bool good;
    free(ask_afresh(w, NULL, text, &good));
    if (good || support_chance(&w->g, 2))
        add_command(w, declaration, text);
}

static void add_declaration(writer *w)
{
    char buf[128], atom[128];
    switch (support_between(&w->g, 0, 3)) {
    case 0:
        snprintf(buf, sizeof buf, "(declare-const p%d Bool)", support_between(&w->g, 0, 2));
        break;
    case 1:
        snprintf(buf, sizeof buf, "(define-fun f ((z Real)) Bool (< z %d))\n",
                 support_between(&w->g, 0, 3));
        break;
    case 2:
        random_atom(w, atom);
        snprintf(buf, sizeof buf, "(define-fun a%d () Bool %.90s)\n", support_between(&w->g, 0, 9),
                 atom);
        break;
    default:
        snprintf(buf, sizeof buf, "(declare-const x%d %s)\n", support_between(&w->g, 0, NAMES - 1),
                 support_chance(&w->g, 70) ? "Real" : "Int");
    }
    try_command(w, true, buf);
}

/* From command `from` on none holds, but for declarations that are global. */
static void forget(writer *w, size_t from)
{
    size_t kept = from;
    for (size_t k = from; k < w->commands; k++) {
        if (w->global && w->declaration[k]) {
            w->declaration[kept] = true;
            w->command[kept++] = w->command[k];
        } else {
            free(w->command[k]);
        }
    }
    w->commands = kept;
}

static void pop_or_reset(writer *w)
{
    if (w->levels > 0) {
        fputs("(pop)\n", w->out);
        forget(w, w->level[--w->levels]);
    } else if (support_chance(&w->g, 30)) {
        fputs("(reset-assertions)\n", w->out);
        forget(w, 0);
    }
}

static void push_level(writer *w)
{
    fputs("(push)", w->out);
    w->level[w->levels++] = w->commands;
}

/* A row that needs a fact which comes behind it, perhaps one level up, mostly. */
static void add_late_fact(writer *w)
{
    char atom[128], text[256];
    int p = support_between(&w->g, 0, 2);
    random_atom(w, atom);
    snprintf(text, sizeof text, "(assert (=> p%d %s))", p, atom);
    add_command(w, false, text);
    if (support_chance(&w->g, 40))
        push_level(w);
    if (support_chance(&w->g, 50))
        snprintf(text, sizeof text, "(assert p%d)", p);
    else
        snprintf(text, sizeof text, "(assert (not p%d))\n", p);
    if (support_chance(&w->g, 90))
        add_command(w, false, text);
}

static void add_something(writer *w)
{
    char formula[512], text[640];
    int die = support_between(&w->g, 0, 9);
    if (die < 2) {
        push_level(w);
    } else if (die < 4) {
        pop_or_reset(w);
    } else if (die < 5) {
        add_late_fact(w);
    } else if (die < 6) {
        add_declaration(w);
    } else {
        snprintf(text, sizeof text, "(assert %s)\n", random_formula(w, formula));
        try_command(w, false, text);
    }
}

enum { CHECKS = 12 };

/* As a script, nothing is a row that always holds. Unknowns that are told true and told false are
 * one row that cannot hold, wherever that stands. */
static bool means_the_same(const char *said, const char *afresh)
{
    if (strcmp(said, "0 <= 0\n") == 0 && strstr(afresh, "expected rows or variables, found none"))
        return true;
    return strcmp(said, afresh) == 0 ||
           (strstr(said, "\n0 <= -1\n") && strstr(afresh, "\n0 <= -1\n"));
}

static void compare_answers(const char *text, char *const *expected, size_t *good)
{
    fmb_script *s = open_text(text);
    for (size_t i = 0; i < CHECKS; i++) {
        fmb_where where = {0};
        fmb_script_kind kind;
        fmb_system *q = NULL;
        must(fmb_script_next(s, &kind, &where), &where);
        cr_assert_eq(kind, FMB_SCRIPT_CHECK);
        fmb_status st = fmb_script_question(s, &q, &where);
        char *said = text_of(st, q, &where);
        cr_assert(means_the_same(said, expected[i]), "check %zu is\n%sand not\n%sof\n%s", i, said,
                  expected[i], text);
        *good += st == FMB_OK;
        if (st == FMB_OK)
            fmb_system_free(q);
        free(said);
    }
    fmb_script_free(s);
}

static void try_script(uint64_t seed, size_t *good)
{
    char *text = NULL, *expected[CHECKS], atom[128];
    size_t size;
    writer w = {.g = {seed}, .out = open_memstream(&text, &size)};
    w.global = support_chance(&w.g, 40);
    if (w.global)
        fputs("(set-option :global-declarations true)", w.out);
    add_command(&w, true, "(declare-const x0 Real)");
    add_command(&w, true, "(declare-const x1 Real)(declare-const x2 Real)(declare-const x3 Int)");
    add_command(&w, true, "(define-fun f ((z Real)) Bool (<= z 1))(declare-const p0 Bool)");
    add_command(&w, true, "(declare-const p1 Bool)(declare-const p2 Bool)\n");
    for (size_t i = 0; i < CHECKS; i++) {
        for (int k = support_between(&w.g, 0, 3); k > 0; k--)
            add_something(&w);
        bool assume = support_chance(&w.g, 25);
        if (assume)
            fprintf(w.out, "(check-sat-assuming (%s))\n", random_atom(&w, atom));
        else
            fputs("(check-sat)\n", w.out);
        bool fine;
        expected[i] = ask_afresh(&w, assume ? atom : NULL, NULL, &fine);
    }
    fclose(w.out);
    compare_answers(text, expected, good);
    w.global = false;
    forget(&w, 0);
    for (size_t i = 0; i < CHECKS; i++)
        free(expected[i]);
    free(text);
}

Test(smt2_reading, as_if_asked_afresh)
{
    size_t good = 0, scripts = 500 / WATCHED;
    for (uint64_t seed = 0; seed < scripts; seed++)
        try_script(seed, &good);
    cr_expect(good > scripts * CHECKS / 2, "only %zu questions could be read", good);
}
