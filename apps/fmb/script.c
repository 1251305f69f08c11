/* script.c: see script.h. The solver keeps the common first rows of consecutive checks, and its
 * state for them (<fmb/session.h>). */
#include "fmb/script.h"

#include <fmb/session.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"
#include "common/text.h"
#include "fmb/integers.h"
#include "fmb/show.h"
#include "fmb/verdict.h"

/* ---- the rows of the next check -------------------------------------------------------------- */

static bool is_same_row(const fmb_system *a, const fmb_system *b, size_t i)
{
    mpq_t p, q;
    size_t n = fmb_system_terms(a, i);
    bool same = n == fmb_system_terms(b, i) && fmb_system_rel(a, i) == fmb_system_rel(b, i);
    mpq_inits(p, q, NULL);
    for (size_t k = 0; same && k < n; k++)
        same = fmb_system_term_q(a, i, k, p) == fmb_system_term_q(b, i, k, q) && mpq_equal(p, q);
    fmb_system_rhs_q(a, i, p);
    fmb_system_rhs_q(b, i, q);
    same = same && mpq_equal(p, q);
    mpq_clears(p, q, NULL);
    return same;
}

static fmb_status add_row(fmb_solver *v, const fmb_system *s, size_t i)
{
    size_t n = fmb_system_terms(s, i);
    int *var = app_need(malloc((n + 1) * sizeof *var));
    mpq_t *coef = app_need(malloc((n + 1) * sizeof *coef)), b;
    mpq_init(b);
    for (size_t k = 0; k < n; k++) {
        mpq_init(coef[k]);
        var[k] = fmb_system_term_q(s, i, k, coef[k]);
    }
    fmb_system_rhs_q(s, i, b);
    fmb_status st = fmb_solver_add_q(v, n, var, coef, fmb_system_rel(s, i), b);
    for (size_t k = 0; k < n; k++)
        mpq_clear(coef[k]);
    mpq_clear(b);
    free(var);
    free(coef);
    return st;
}

/* Change the loaded system to s. */
static fmb_status change_loaded(fmb_solver *v, const fmb_system *s)
{
    const fmb_system *old = fmb_solver_system(v);
    if (!old || fmb_system_dim(old) != fmb_system_dim(s))
        return fmb_solver_load(v, s);
    size_t same = 0, m = fmb_system_rows(s);
    while (same < m && same < fmb_system_rows(old) && is_same_row(old, s, same))
        same++;
    fmb_status st = FMB_OK;
    while (st == FMB_OK && fmb_system_rows(old) > same)
        st = fmb_solver_remove(v, fmb_system_rows(old) - 1);
    for (size_t i = same; st == FMB_OK && i < m; i++)
        st = add_row(v, s, i);
    return st;
}

/* ---- printing -------------------------------------------------------------------------------- */

/* 2.0, (/ 1.0 3.0), (- 5) */
static void print_smt_number(const mpq_t q, bool integer)
{
    mpq_t size;
    mpq_init(size);
    mpq_abs(size, q);
    const char *point = integer ? "" : ".0";
    fputs(mpq_sgn(q) < 0 ? "(- " : "", stdout);
    if (mpz_cmp_ui(mpq_denref(size), 1) == 0)
        gmp_printf("%Zd%s", mpq_numref(size), point);
    else
        gmp_printf("(/ %Zd.0 %Zd.0)", mpq_numref(size), mpq_denref(size));
    fputs(mpq_sgn(q) < 0 ? ")" : "", stdout);
    mpq_clear(size);
}

static void print_smt_symbol(const char *name)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "~!@$%^&*_-+=<>.?/";
    bool bare = name[strspn(name, plain)] == '\0' && !(*name >= '0' && *name <= '9');
    char *shown = app_text(name, APP_TEXT_TERMINAL);
    printf(bare ? "%s" : "|%s|", shown);
    free(shown);
}

static void print_model(const app_session *s, size_t claim)
{
    mpq_t q;
    mpq_init(q);
    puts("(");
    for (int j = 0; j < fmb_system_dim(s->system); j++) {
        bool integer = fmb_system_is_integer(s->system, j);
        fmb_evidence_coordinate_q(s->evidence, claim, j, q);
        fputs("  (define-fun ", stdout);
        print_smt_symbol(fmb_system_name(s->system, j));
        printf(" () %s ", integer ? "Int" : "Real");
        print_smt_number(q, integer);
        puts(")");
    }
    puts(")");
    mpq_clear(q);
}

/* The labels of the rows in conflict, each once. */
static void print_core(const app_session *s, size_t claim)
{
    const char *separator = "",
               **shown = app_need(calloc(fmb_system_rows(s->system) + 1, sizeof *shown));
    size_t n = 0;
    putchar('(');
    for (size_t i = fmb_evidence_next_row(s->evidence, claim, 0); i != SIZE_MAX;
         i = fmb_evidence_next_row(s->evidence, claim, i + 1)) {
        const char *label = fmb_system_label(s->system, i);
        size_t k = 0;
        while (label && k < n && strcmp(shown[k], label) != 0)
            k++;
        if (!label || k < n)
            continue;
        shown[n++] = label;
        fputs(separator, stdout);
        print_smt_symbol(label);
        separator = " ";
    }
    puts(")");
    free(shown);
}

/* The value of a system's objective at the point. */
static void evaluate_objective(const app_session *s, const fmb_system *form, size_t claim,
                               mpq_t out)
{
    mpq_t c, x;
    mpq_inits(c, x, NULL);
    fmb_system_objective_constant_q(form, out);
    for (size_t k = 0; k < fmb_system_objective_terms(form); k++) {
        int j = fmb_system_objective_term_q(form, k, c);
        fmb_evidence_coordinate_q(s->evidence, claim,
                                  fmb_system_find(s->system, fmb_system_name(form, j)), x);
        mpq_mul(c, c, x);
        mpq_add(out, out, c);
    }
    mpq_clears(c, x, NULL);
}

static int print_values(const app_session *s, fmb_script *script, size_t claim, const char *file)
{
    const char *text = "";
    mpq_t value;
    mpq_init(value);
    int code = APP_YES;
    for (size_t i = 0; code == APP_YES && text; i++) {
        size_t size;
        fmb_where where = {0};
        fmb_system *form = NULL;
        code = app_source_outcome(fmb_script_term(script, i, &text, &size, &form, &where), file,
                                  &where);
        if (code != APP_YES || !text)
            break;
        evaluate_objective(s, form, claim, value);
        printf("%s(%.*s ", i == 0 ? "(" : "\n ", (int)size, text);
        print_smt_number(value, false);
        putchar(')');
        fmb_system_free(form);
    }
    if (code == APP_YES)
        puts(")");
    mpq_clear(value);
    return code;
}

/* ---- proofs ---------------------------------------------------------------------------------- */

/* [give, free()] "p.proof" as "p.3.proof", or with another ending. */
static char *numbered_path(const char *path, size_t number, const char *ending)
{
    const char *name = strrchr(path, '/'), *dot = strrchr(name ? name : path, '.');
    int stem = dot ? (int)(dot - path) : (int)strlen(path);
    return app_print("%.*s.%zu%s", stem, path, number, ending ? ending : dot ? dot : "");
}

/* Write the proof, and the rows that it is about, as the whole script is no system. */
static int write_numbered(const app_session *s, size_t number, const char *ending)
{
    FILE *out;
    char *path = numbered_path(s->ask->proof, number, ending);
    int code = app_file_create(path, &out);
    if (code == APP_YES) {
        fmb_status st = ending        ? fmb_system_write(s->system, FMB_FORMAT_TEXT, out)
                        : s->evidence ? fmb_evidence_write(s->evidence, s->system, out)
                                      : FMB_OK;
        code = st == FMB_OK ? APP_YES : app_session_proof_error(path, st);
        if (code == APP_YES)
            code = app_file_close(out, path);
        else
            app_file_discard(out);
    }
    free(path);
    return code;
}

/* ---- the script ------------------------------------------------------------------------------ */

static int check_next(app_session *s, fmb_script *script, const char *file)
{
    fmb_where where = {0};
    fmb_system *next = NULL;
    fmb_evidence_free(s->evidence);
    s->evidence = NULL;
    s->relaxed = false;
    int code = app_source_outcome(fmb_script_question(script, &next, &where), file, &where);
    if (code != APP_YES)
        return code;
    fmb_system_free(s->system);
    s->system = next;
    fmb_status st = change_loaded(s->solver, next);
    if (st != FMB_OK)
        return app_status_error(st);
    app_session_begin(s);
    code = app_session_end(s, fmb_solve(s->solver, fmb_solver_system(s->solver), &s->result));
    return code == APP_YES ? app_integers_seek(s) : code;
}

static int verdict_of_check(const app_session *s)
{
    return s->relaxed && !s->ask->relax ? APP_UNDECIDED : app_session_verdict_code(s);
}

static json_t *check_json(const app_session *s)
{
    json_t *obj = app_verdict_json(s);
    if (s->result.verdict == FMB_FEASIBLE)
        app_json_set_witness(obj, s);
    app_json_set_stats(obj, &s->result.stats);
    return obj;
}

static int print_what_is_asked(const app_session *s, fmb_script *script, fmb_script_kind kind,
                               const char *file)
{
    bool core = kind == FMB_SCRIPT_CORE;
    size_t claim = app_verdict_claim(s, core ? FMB_CLAIM_INFEASIBLE : FMB_CLAIM_FEASIBLE);
    fmb_verdict wanted = core ? FMB_INFEASIBLE : FMB_FEASIBLE;
    if (!s->system || s->result.verdict != wanted || claim == SIZE_MAX) {
        printf("(error \"the last check-sat was not %s\")\n", core ? "unsat" : "sat");
        return APP_YES;
    }
    if (kind == FMB_SCRIPT_VALUE)
        return print_values(s, script, claim, file);
    if (core)
        print_core(s, claim);
    else
        print_model(s, claim);
    return APP_YES;
}

int app_script_answer(app_session *s, fmb_script *script, const char *file)
{
    static const char *const word[] = {
        [APP_YES] = "sat", [APP_NO] = "unsat", [APP_UNDECIDED] = "unknown"};
    json_t *checks = s->ask->json ? app_need(json_array()) : NULL;
    fmb_script_kind kind = FMB_SCRIPT_CHECK;
    size_t number = 0;
    int code = APP_YES, last = APP_YES;
    bool undecided = false;
    while (code == APP_YES && kind != FMB_SCRIPT_END) {
        fmb_where where = {0};
        code = app_source_outcome(fmb_script_next(script, &kind, &where), file, &where);
        if (code != APP_YES || kind == FMB_SCRIPT_END)
            break;
        if (kind != FMB_SCRIPT_CHECK) {
            code = checks ? APP_YES : print_what_is_asked(s, script, kind, file);
            continue;
        }
        code = check_next(s, script, file);
        if (code != APP_YES)
            break;
        last = verdict_of_check(s);
        undecided = undecided || last == APP_UNDECIDED;
        number++;
        if (checks)
            app_json_append(checks, check_json(s));
        else
            puts(word[last]);
        fflush(stdout);
        if (s->ask->proof)
            code = write_numbered(s, number, NULL);
        if (s->ask->proof && code == APP_YES)
            code = write_numbered(s, number, ".fmb");
        if (s->result.stop == FMB_STOP_CANCELLED)
            break;
    }
    if (checks && code == APP_YES) {
        json_t *obj = app_need(json_object());
        app_json_set(obj, "checks", checks);
        app_json_print(obj);
    } else {
        json_decref(checks);
    }
    return code != APP_YES ? code : undecided ? APP_UNDECIDED : last;
}
