/* verbs.c: see verbs.h. */
#include <criterion/criterion.h>
#include <stdarg.h>
#include <string.h>

#include "property/random/rows.h"
#include "verbs.h"

/* Append to a text of VERB_ANSWER bytes. */
__attribute__((format(printf, 2, 3))) static void say(char *out, const char *format, ...)
{
    va_list list;
    size_t used = strlen(out);
    va_start(list, format);
    int n = vsnprintf(out + used, VERB_ANSWER - used, format, list);
    va_end(list);
    cr_assert(n >= 0 && used + (size_t)n < VERB_ANSWER, "the answer is too long for this test");
}

static void say_system(char *out, const fmb_system *s)
{
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    rows_print(s, f);
    fclose(f);
    say(out, "%s", text);
    free(text);
}

/* The last query's evidence, which must be accepted. */
static fmb_status prove(fmb_solver *v, const fmb_system *s, char *out)
{
    fmb_evidence *const mark = (fmb_evidence *)out, *e = mark;
    fmb_judgement j = {.size = sizeof j};
    fmb_status st = fmb_solver_evidence(v, &e);
    if (st != FMB_OK) {
        cr_assert_eq(e, mark, "evidence was touched");
        return st;
    }
    fmb_judgement untouched = {.size = sizeof untouched};
    memset(&j, 0x5a, sizeof j);
    j.size = sizeof j;
    untouched = j;
    st = fmb_check(s, e, &j);
    if (st == FMB_OK) {
        cr_assert(j.accepted || fmb_evidence_claims(e) == 0, "rejected: %s", j.reason);
        say(out, "claims %zu\n", fmb_evidence_claims(e));
    } else {
        cr_assert_eq(memcmp(&j, &untouched, sizeof j), 0, "the judgement was touched");
    }
    fmb_evidence_free(e);
    return st;
}

/* Common end of all verbs: status of the call, whether its outputs are as they should be. */
static fmb_status finish(fmb_status st, bool untouched, fmb_solver *v, const fmb_system *s,
                         const fmb_result *r, char *out)
{
    static const fmb_result fresh = {.size = sizeof fresh};
    if (st != FMB_OK) {
        cr_assert(untouched, "an out argument was touched");
        cr_assert_eq(memcmp(r, &fresh, sizeof fresh), 0, "the result was touched");
        return st;
    }
    say(out, "%s\n", fmb_verdict_text(r->verdict));
    return r->verdict == FMB_UNKNOWN ? FMB_OK : prove(v, s, out);
}

static fmb_status solve(fmb_solver *v, const fmb_system *s, fmb_result *r, char *out)
{
    return finish(fmb_solve(v, s, r), true, v, s, r, out);
}

static fmb_status project(fmb_solver *v, const fmb_system *s, fmb_result *r, char *out)
{
    static const int keep[] = {0, 2};
    fmb_system *const mark = (fmb_system *)out, *p = mark;
    fmb_status st = fmb_project(v, s, keep, 2, &p, r);
    if (st == FMB_OK && p) {
        say_system(out, p);
        fmb_system_free(p);
    }
    return finish(st, p == mark, v, s, r, out);
}

static fmb_status bound(fmb_solver *v, const fmb_system *s, fmb_result *r, char *out)
{
    fmb_box *const mark = (fmb_box *)out, *box = mark;
    fmb_status st = fmb_bound(v, s, NULL, 0, &box, r);
    if (st == FMB_OK && box) {
        for (int i = 0; i < fmb_box_size(box); i++)
            for (int side = 0; side < 2; side++) {
                fmb_end e = fmb_box_end(box, i, (fmb_side)side);
                say(out, "%d %d %a\n", (int)e.kind, e.attained, e.value);
            }
        fmb_box_free(box);
    }
    return finish(st, box == mark, v, s, r, out);
}

enum { MOST_ROWS = 128 };

static fmb_status reduce(fmb_solver *v, const fmb_system *s, fmb_result *r, char *out)
{
    fmb_system *const mark = (fmb_system *)out, *p = mark;
    fmb_fate fate[MOST_ROWS] = {FMB_FATE_UNKNOWN};
    cr_assert_leq(fmb_system_rows(s), MOST_ROWS);
    fmb_status st = fmb_reduce(v, s, fate, &p, r);
    for (size_t i = 0; st != FMB_OK && i < fmb_system_rows(s); i++)
        cr_assert_eq(fate[i], FMB_FATE_UNKNOWN, "a fate was touched");
    if (st == FMB_OK && p) {
        say_system(out, p);
        fmb_system_free(p);
    }
    return finish(st, p == mark, v, s, r, out);
}

/* max 2 x1 - x2 + 2 x3 ... + 1/2 */
static fmb_status optimize(fmb_solver *v, const fmb_system *s, fmb_result *r, char *out)
{
    enum { MOST_VARIABLES = 64 };
    double coef[MOST_VARIABLES];
    fmb_optimum *const mark = (fmb_optimum *)out, *o = mark;
    cr_assert_leq(fmb_system_dim(s), MOST_VARIABLES);
    for (int j = 0; j < MOST_VARIABLES; j++)
        coef[j] = j % 2 ? -1 : 2;
    fmb_status st = fmb_optimize(v, s, &(fmb_objective){FMB_SENSE_MAX, coef, 0.5}, &o, r);
    if (st == FMB_OK && o) {
        fmb_end e = fmb_optimum_end(o);
        say(out, "%d %d %a\n", (int)e.kind, e.attained, e.value);
        for (int j = 0; j < fmb_system_dim(s); j++)
            say(out, "%a %a\n", fmb_optimum_coordinate(o, j), fmb_optimum_ray(o, j));
        fmb_optimum_free(o);
    }
    return finish(st, o == mark, v, s, r, out);
}

const verb VERBS[] = {{"solve", solve},
                      {"project", project},
                      {"bound", bound},
                      {"reduce", reduce},
                      {"optimize", optimize}};
const int VERBS_COUNT = (int)(sizeof VERBS / sizeof *VERBS);
