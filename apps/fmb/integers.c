/* integers.c: see integers.h. */
#include "fmb/integers.h"

#include <fmb/gmp.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "fmb/verdict.h"

void app_integers_note(app_session *s)
{
    app_integers_note_of(s, s->system);
}

void app_integers_note_of(app_session *s, const fmb_system *file)
{
    if (s->ask->relax || s->relaxed || !app_source_has_integers(file))
        return;
    s->relaxed = true;
    app_session_note(s, "the file has integer variables: this is the answer over the reals");
}

static bool is_integral(const app_session *s, size_t claim)
{
    bool integral = true;
    mpq_t q;
    mpq_init(q);
    for (int j = 0; integral && j < fmb_system_dim(s->system); j++) {
        fmb_evidence_coordinate_q(s->evidence, claim, j, q);
        integral = !fmb_system_is_integer(s->system, j) || mpz_cmp_ui(mpq_denref(q), 1) == 0;
    }
    mpq_clear(q);
    return integral;
}

void app_integers_judge(app_session *s, const fmb_optimum *o)
{
    if (!o || s->result.verdict == FMB_INFEASIBLE || !app_source_has_integers(s->system))
        return;
    fmb_end end = fmb_optimum_end(o);
    if (end.kind != FMB_END_FINITE && end.kind != FMB_END_INFINITE)
        return;
    bool integral = end.kind == FMB_END_INFINITE || end.attained;
    mpq_t q;
    mpq_init(q);
    for (int j = 0; integral && j < fmb_system_dim(s->system); j++) {
        fmb_optimum_coordinate_q(o, j, q);
        integral = !fmb_system_is_integer(s->system, j) || mpz_cmp_ui(mpq_denref(q), 1) == 0;
    }
    mpq_clear(q);
    s->relaxed = !integral;
}

/* floor(q + 1/2) */
static void round_to_integer(mpq_t q)
{
    mpz_mul_2exp(mpq_numref(q), mpq_numref(q), 1);
    mpz_add(mpq_numref(q), mpq_numref(q), mpq_denref(q));
    mpz_mul_2exp(mpq_denref(q), mpq_denref(q), 1);
    mpz_fdiv_q(mpq_numref(q), mpq_numref(q), mpq_denref(q));
    mpz_set_ui(mpq_denref(q), 1);
}

/* [give] The system with each integer variable at the integer nearest to the point. */
static fmb_status fix_integers(const app_session *s, size_t claim, fmb_system **out)
{
    fmb_system *t;
    fmb_status st = fmb_system_copy(s->system, &t);
    mpq_t coef[1], q;
    mpq_inits(coef[0], q, NULL);
    mpq_set_ui(coef[0], 1, 1);
    for (int j = 0; st == FMB_OK && j < fmb_system_dim(s->system); j++) {
        if (!fmb_system_is_integer(s->system, j))
            continue;
        fmb_evidence_coordinate_q(s->evidence, claim, j, q);
        round_to_integer(q);
        st = fmb_system_add_q(t, 1, &j, coef, FMB_EQ, q);
        if (st != FMB_OK)
            fmb_system_free(t);
    }
    mpq_clears(coef[0], q, NULL);
    if (st == FMB_OK)
        *out = t;
    return st;
}

/* [give] Convert evidence about fixed to evidence about the system, which has fewer rows: for a
 * point only the shape changes in the text of the proof (docs/proof-format.md). */
static fmb_status evidence_of_system(const app_session *s, const fmb_system *fixed,
                                     fmb_evidence **out)
{
    char *text = NULL, *moved = NULL;
    size_t size;
    FILE *to = app_need(open_memstream(&text, &size));
    fmb_status st = fmb_evidence_write(s->evidence, fixed, to);
    fclose(to);
    if (st == FMB_OK) {
        const char *second = strchr(text, '\n') + 1;
        to = app_need(open_memstream(&moved, &size));
        fprintf(to, "%.*ssystem %zu rows %d variables%s", (int)(second - text), text,
                fmb_system_rows(s->system), fmb_system_dim(s->system), strchr(second, '\n'));
        fclose(to);
        st = fmb_evidence_parse(app_need(moved), size, s->system, out, NULL);
    }
    free(text);
    free(moved);
    return st;
}

/* Solve fixed in the remaining time; its point, if there is one, becomes the session's. */
static int solve_fixed(app_session *s, const fmb_system *fixed)
{
    fmb_options o = s->options;
    if (o.max_seconds > 0)
        o.max_seconds = o.max_seconds > 2 * s->result.stats.seconds
                            ? o.max_seconds - s->result.stats.seconds
                            : o.max_seconds / 2;
    fmb_solver *first = s->solver;
    fmb_evidence *relaxed = s->evidence;
    fmb_result res = {.size = sizeof res};
    fmb_status st = fmb_solver_new(&o, NULL, &s->solver);
    if (st != FMB_OK)
        return app_status_error(st);
    fmb_solver_free(first);
    s->evidence = NULL;
    app_session_begin(s);
    int code = app_session_end(s, fmb_solve(s->solver, fixed, &res));
    fmb_evidence *point = NULL;
    if (code == APP_YES && s->evidence && res.verdict == FMB_FEASIBLE &&
        (st = evidence_of_system(s, fixed, &point)) != FMB_OK)
        code = app_status_error(st);
    fmb_evidence_free(s->evidence);
    s->evidence = point ? point : relaxed;
    s->relaxed = point == NULL;
    if (point)
        fmb_evidence_free(relaxed);
    return code;
}

int app_integers_seek(app_session *s)
{
    size_t claim = app_verdict_claim(s, FMB_CLAIM_FEASIBLE);
    if (s->result.verdict != FMB_FEASIBLE || claim == SIZE_MAX)
        return APP_YES;
    s->relaxed = !is_integral(s, claim);
    if (!s->relaxed || s->ask->relax)
        return APP_YES;
    fmb_system *fixed;
    fmb_status st = fix_integers(s, claim, &fixed);
    if (st != FMB_OK)
        return app_status_error(st);
    int code = solve_fixed(s, fixed);
    fmb_system_free(fixed);
    return code;
}
