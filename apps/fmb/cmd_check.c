/* cmd_check.c: fmb check FILE PROOF. It includes only systems, their readers and the checker of the
 * library, so that no solving code influences what is accepted. */
#include <float.h>
#include <fmb/gmp.h>
#include <fmb/io.h>
#include <fmb/proof.h>
#include <fmb/system.h>
#include <jansson.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "common/budget.h"
#include "common/decimal.h"
#include "common/exit_code.h"
#include "common/file.h"
#include "common/form.h"
#include "common/json.h"
#include "common/message.h"
#include "common/options.h"
#include "common/signals.h"
#include "common/source.h"
#include "common/value.h"
#include "fmb/commands.h"

enum { KEY_JSON = 'j', KEY_LIST = 'l', KEY_EXPECT = 'e', KEY_SECONDS = 256, KEY_BYTES, KEY_RELAX };

typedef struct request {
    app_source source;
    const char *proof;
    bool json, list, relax;
    int digits; /* of decimals, or 0: fractions */
    fmb_patience patience;
    double deadline; /* of fmb_monotonic_seconds, where there is one */
    fmb_demand demand;
    const char *projection; /* the file that holds it, where that is what is demanded */
    const char *form;       /* the objective, where one is given */
    fmb_sense sense;        /* which way it goes */
} request;

static const struct argp_option options[] = {
    {"list", KEY_LIST, NULL, 0, "List every claim", 2},
    {"expect", KEY_EXPECT, "WHAT", 0,
     "Demand more: feasible, infeasible, bounds (both ends of every variable), reduced (each row "
     "is redundant, irredundant, or an equality), projection=OUT (each row of the system in OUT "
     "is implied), whole=OUT (and no row is missing there), "
     "optimum (of the objective of FILE), max=FORM or min=FORM (of this one)",
     2},
    {"relax", KEY_RELAX, NULL, 0, "All variables are real, whatever the files say", 2},
    {"max-seconds", KEY_SECONDS, "SECONDS", 0,
     "Stop reading and judging the proof after that time (default 0: no limit)", 2},
    {"max-bytes", KEY_BYTES, "BYTES", 0,
     "Limit on the system, the proof and the memory of the checker, in all (default 0: no limit)",
     2},
    {"json", KEY_JSON, NULL, 0, "Print one JSON object instead of text", 2},
    {0}};

#define PROJECTION "projection="
#define WHOLE      "whole="

/* False: no such demand. */
static bool read_demand(request *r, const char *word)
{
    static const char *const known[] = {[FMB_DEMAND_FEASIBLE] = "feasible",
                                        [FMB_DEMAND_INFEASIBLE] = "infeasible",
                                        [FMB_DEMAND_BOUNDS] = "bounds",
                                        [FMB_DEMAND_REDUCED] = "reduced"};
    if (strncmp(word, PROJECTION, sizeof PROJECTION - 1) == 0) {
        r->demand = FMB_DEMAND_PROJECTION;
        r->projection = word + sizeof PROJECTION - 1;
        return true;
    }
    if (strncmp(word, WHOLE, sizeof WHOLE - 1) == 0) {
        r->demand = FMB_DEMAND_WHOLE;
        r->projection = word + sizeof WHOLE - 1;
        return true;
    }
    bool max = strncmp(word, "max=", 4) == 0, min = strncmp(word, "min=", 4) == 0;
    if (max || min || strcmp(word, "optimum") == 0) {
        r->demand = FMB_DEMAND_OPTIMUM;
        r->form = max || min ? word + 4 : NULL;
        r->sense = max ? FMB_SENSE_MAX : FMB_SENSE_MIN;
        return true;
    }
    for (int k = FMB_DEMAND_FEASIBLE; k <= FMB_DEMAND_REDUCED; k++)
        if (strcmp(word, known[k]) == 0) {
            r->demand = (fmb_demand)k;
            return true;
        }
    return false;
}

static bool both_are_input(const char *a, const char *b)
{
    return strcmp(a, "-") == 0 && strcmp(b, "-") == 0;
}

static void check_files(const request *r, struct argp_state *state)
{
    if (!r->proof)
        argp_error(state, "FILE or PROOF is missing");
    else if (both_are_input(r->source.file, r->proof))
        argp_error(state, "FILE and PROOF cannot both be standard input");
    else if (r->projection && strcmp(r->projection, "-") == 0)
        argp_error(state, "--expect %s=OUT: OUT cannot be standard input",
                   r->demand == FMB_DEMAND_WHOLE ? "whole" : "projection");
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    request *r = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &r->source;
        state->child_inputs[1] = &r->digits;
        return 0;
    case KEY_JSON:
        r->json = true;
        return 0;
    case KEY_LIST:
        r->list = true;
        return 0;
    case KEY_RELAX:
        r->relax = true;
        return 0;
    case KEY_SECONDS:
        r->patience.max_seconds = app_value_number("--max-seconds", arg, 0, DBL_MAX, state);
        return 0;
    case KEY_BYTES:
        r->patience.max_bytes = (size_t)app_value_whole("--max-bytes", arg, 0, SIZE_MAX, state);
        return 0;
    case KEY_EXPECT:
        if (!read_demand(r, arg))
            argp_error(state,
                       "--expect: expected feasible, infeasible, bounds, reduced, " PROJECTION
                       "OUT, " WHOLE "OUT, optimum, max=FORM or min=FORM, found '%s'",
                       arg);
        return 0;
    case ARGP_KEY_ARG:
        if (!r->source.file || r->proof)
            return ARGP_ERR_UNKNOWN;
        r->proof = arg;
        return 0;
    case ARGP_KEY_END:
        check_files(r, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] =
    "Judge the claims in PROOF about the system in FILE, in exact arithmetic and without the "
    "solver, and say what they are."
    "\v"
    "Exit codes: 0 accepted, 1 rejected, or not all that is expected, 2 a limit or Ctrl-C came\n"
    "first. Where FILE has integer variables, \"over the reals\" says that some claims\n"
    "need not hold for integers.\n"
    "\n"
    "Examples:\n"
    "  fmb solve plan.smt2 --proof plan.proof; fmb check plan.smt2 plan.proof\n"
    "  fmb bounds diet.fmb --proof - | fmb check diet.fmb - --expect bounds\n"
    "  fmb check diet.fmb cheap.proof --expect 'min=0.4 bread + 0.35 milk'\n";

/* ---- limits ---------------------------------------------------------------------------------- */

static volatile sig_atomic_t is_asked_to_stop;

static void ask_to_stop(int signal_number)
{
    (void)signal_number;
    is_asked_to_stop = 1;
}

static bool give_up(void *self)
{
    (void)self;
    return is_asked_to_stop != 0;
}

/* Start the clock; from here on signals stop the check. */
static void begin_to_wait(request *r)
{
    r->patience.give_up = give_up;
    r->deadline = fmb_monotonic_seconds() + r->patience.max_seconds;
    app_signals_set(ask_to_stop);
}

/* The remaining patience; it is never 0, which would mean no limit. */
static fmb_patience patience_left(const request *r)
{
    fmb_patience p = r->patience;
    if (p.max_seconds > 0)
        p.max_seconds = fmax(r->deadline - fmb_monotonic_seconds(), DBL_MIN);
    return p;
}

/* Print a stop before anything was judged. */
static void print_stop_as_json(fmb_stop stop)
{
    json_t *obj = app_need(json_object());
    app_json_set(obj, "accepted", json_false());
    app_json_set(obj, "verdict", json_string(fmb_verdict_text(FMB_UNKNOWN)));
    app_json_set(obj, "stop", json_string(fmb_stop_text(stop)));
    app_json_print(obj);
}

static int report_stop_of_reader(const request *r, fmb_stop stop)
{
    if (r->json)
        print_stop_as_json(stop);
    return app_error(APP_UNDECIDED,
                     "undecided (%s): the proof was not read to its end, and no claim judged",
                     fmb_stop_text(stop));
}

static int read_proof(const request *r, const fmb_system *s, fmb_evidence **out)
{
    fmb_stop stop = FMB_STOP_DONE;
    const fmb_patience patience = patience_left(r);
    FILE *in;
    int code = app_file_open(r->proof, &in);
    if (code != APP_YES)
        return code;
    fmb_where where = {0};
    fmb_status st = fmb_evidence_read_within(in, s, &patience, out, &stop, &where);
    code = app_source_outcome(st, r->proof, &where);
    app_file_close_input(in);
    return code == APP_YES && stop != FMB_STOP_DONE ? report_stop_of_reader(r, stop) : code;
}

/* ---- what was found -------------------------------------------------------------------------- */

typedef struct finding {
    const fmb_system *s;
    const fmb_evidence *e;
    fmb_judgement j;
    fmb_stop stop; /* of the checker, or of the test of the demand */
    bool integers; /* the system has some */
    bool meets;    /* the demand */
    char missing[160];
    bool tells_rows; /* that follow, perhaps those of a projection ... */
    bool whole;      /* ... of which none is missing */
} finding;

static const char *const KIND[] = {
    [FMB_CLAIM_FEASIBLE] = "feasible", [FMB_CLAIM_INFEASIBLE] = "infeasible",
    [FMB_CLAIM_BOUND] = "bound",       [FMB_CLAIM_UNBOUNDED] = "unbounded",
    [FMB_CLAIM_IMPLIED] = "implied",   [FMB_CLAIM_REDUNDANT] = "redundant",
    [FMB_CLAIM_EQUALITY] = "equality", [FMB_CLAIM_IRREDUNDANT] = "irredundant",
    [FMB_CLAIM_CORNER] = "corner",     [FMB_CLAIM_WHOLE] = "whole",
    [FMB_CLAIM_FOLLOWS] = "follows"};

enum { KINDS = sizeof KIND / sizeof *KIND };

static void count_kinds(const fmb_evidence *e, size_t count[KINDS])
{
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        count[fmb_evidence_kind(e, i)]++;
}

/* Are there claims about a projection, the demanded one or any, and is it proved complete? */
static fmb_status look_at_projection(const request *r, const fmb_system *image, finding *f)
{
    const fmb_patience patience = patience_left(r);
    size_t count[KINDS] = {0};
    bool of_image = r->demand == FMB_DEMAND_PROJECTION || r->demand == FMB_DEMAND_WHOLE;
    count_kinds(f->e, count);
    f->whole = count[FMB_CLAIM_WHOLE] > 0;
    f->tells_rows = f->whole || count[FMB_CLAIM_IMPLIED] > 0 || of_image;
    return of_image ? fmb_evidence_meets_within(f->e, f->s, FMB_DEMAND_WHOLE, image, &patience,
                                                &f->stop, &f->whole, NULL, 0)
                    : FMB_OK;
}

/* Do the claims meet the demand? Not tested after a limit of the checker. */
static fmb_status look_at_claims(const request *r, const fmb_system *image, finding *f)
{
    const fmb_patience patience = patience_left(r);
    f->stop = f->j.stop;
    if (f->stop != FMB_STOP_DONE)
        return FMB_OK;
    fmb_status st = fmb_evidence_meets_within(f->e, f->s, r->demand, image, &patience, &f->stop,
                                              &f->meets, f->missing, sizeof f->missing);
    return st == FMB_OK && f->stop == FMB_STOP_DONE ? look_at_projection(r, image, f) : st;
}

/* "(1 feasible, 6 bound)" */
static void print_kinds(const fmb_evidence *e)
{
    size_t count[KINDS] = {0};
    const char *before = " (";
    count_kinds(e, count);
    for (int k = FMB_CLAIM_FEASIBLE; k < KINDS; k++) {
        if (count[k] == 0)
            continue;
        printf("%s%zu %s", before, count[k], KIND[k]);
        before = ", ";
    }
    printf(")\n");
}

static void put_number(void *digits, mpq_srcptr q, FILE *out)
{
    char *text = app_number(q, *(const int *)digits, APP_NEAREST);
    fputs(text, out);
    free(text);
}

static fmb_status tell(const finding *f, size_t i, int digits, FILE *out)
{
    const fmb_number_style style = {.put = put_number, .self = &digits};
    return fmb_evidence_tell_with(f->e, f->s, i, &style, out);
}

static int list_claims(const finding *f, int digits)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < fmb_evidence_claims(f->e); i++) {
        printf("claim %zu: ", i + 1);
        st = tell(f, i, digits, stdout);
    }
    return st == FMB_OK ? APP_YES : app_status_error(st);
}

/* A proof without a verdict still makes claims. */
static int print_text(const request *r, const finding *f)
{
    const fmb_judgement *j = &f->j;
    if (!j->accepted && j->claim == SIZE_MAX) {
        printf("rejected: %s\n", j->reason);
    } else if (!j->accepted) {
        printf("rejected: claim %zu: %s\n", j->claim + 1, j->reason);
    } else {
        bool decided = j->verdict != FMB_UNKNOWN;
        printf("accepted%s%s%s", decided ? ": " : "", decided ? fmb_verdict_text(j->verdict) : "",
               j->relaxed ? " over the reals" : "");
        print_kinds(f->e);
        if (f->tells_rows)
            printf("%s\n", f->whole
                               ? "whole: no row of the projection is missing"
                               : "outward only: all that is implied holds, and perhaps more does");
        if (r->list && list_claims(f, r->digits) != APP_YES)
            return APP_INTERNAL;
    }
    if (j->accepted && f->stop == FMB_STOP_DONE && !f->meets)
        printf("missing: %s\n", f->missing);
    return APP_YES;
}

/* [give] The words of fmb_evidence_tell. */
static json_t *claim_json(const finding *f, size_t i, int digits)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    fmb_status st = out ? tell(f, i, digits, out) : FMB_ERR_MEMORY;
    if (out)
        fclose(out);
    if (text)
        text[strcspn(text, "\n")] = '\0';
    json_t *words = st == FMB_OK && text ? app_json_text(text) : json_null();
    free(text);
    return words;
}

static void print_json(const request *r, const finding *f)
{
    json_t *obj = app_need(json_object()), *kinds = app_need(json_object());
    size_t count[KINDS] = {0}, claims = fmb_evidence_claims(f->e);
    count_kinds(f->e, count);
    app_json_set(obj, "accepted", json_boolean(f->j.accepted));
    app_json_set(obj, "verdict", json_string(fmb_verdict_text(f->j.verdict)));
    app_json_set(obj, "over", json_string(f->integers && !f->j.relaxed ? "integers" : "reals"));
    app_json_set(obj, "stop", json_string(fmb_stop_text(f->stop)));
    app_json_set(obj, "claims", json_integer((json_int_t)claims));
    if (f->j.stop != FMB_STOP_DONE)
        app_json_set(obj, "held", json_integer((json_int_t)f->j.held));
    for (int k = FMB_CLAIM_FEASIBLE; k < KINDS; k++)
        if (count[k] > 0)
            app_json_set(kinds, KIND[k], json_integer((json_int_t)count[k]));
    app_json_set(obj, "kinds", kinds);
    if (f->tells_rows)
        app_json_set(obj, "whole", json_boolean(f->whole));
    json_t *list = r->list ? app_need(json_array()) : NULL;
    for (size_t i = 0; list && i < claims; i++)
        json_array_append_new(list, claim_json(f, i, r->digits));
    if (list)
        app_json_set(obj, "list", list);
    if (!f->j.accepted && f->j.claim != SIZE_MAX)
        app_json_set(obj, "claim", json_integer((json_int_t)f->j.claim + 1));
    if (!f->j.accepted)
        app_json_set(obj, "reason", app_json_text(f->j.reason));
    if (f->j.accepted && f->stop == FMB_STOP_DONE && !f->meets)
        app_json_set(obj, "missing", app_json_text(f->missing));
    app_json_print(obj);
}

/* Make all variables real. */
static int forget_integers(fmb_system *s)
{
    fmb_status st = FMB_OK;
    for (int j = 0; s && st == FMB_OK && j < fmb_system_dim(s); j++)
        st = fmb_system_set_integer(s, j, false);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}

static int judge(const request *r, const fmb_system *s, const fmb_evidence *e,
                 const fmb_system *image)
{
    finding f = {.s = s, .e = e, .j = {.size = sizeof f.j}, .integers = app_source_has_integers(s)};
    const fmb_patience patience = patience_left(r);
    fmb_status st = fmb_check_within(s, e, &patience, &f.j);
    if (st == FMB_OK)
        st = look_at_claims(r, image, &f);
    if (st != FMB_OK)
        return app_status_error(st);
    int code = APP_YES;
    bool undecided = !f.j.accepted && f.j.claim == SIZE_MAX && f.j.stop != FMB_STOP_DONE;
    if (r->json)
        print_json(r, &f);
    else if (!undecided)
        code = print_text(r, &f);
    if (undecided)
        return app_error(APP_UNDECIDED, "%s so far; nothing is accepted", f.j.reason);
    if (code == APP_YES && f.j.accepted && f.stop != FMB_STOP_DONE)
        return app_error(APP_UNDECIDED, "undecided (%s): whether the claims are those expected",
                         fmb_stop_text(f.stop));
    return code != APP_YES ? code : f.j.accepted && f.meets ? APP_YES : APP_NO;
}

/* [give] The projection, or a copy of s with the objective, that is demanded; NULL for neither. */
static int read_image(const request *r, const fmb_system *s, fmb_system **out)
{
    if (r->form) {
        fmb_status st = fmb_system_copy(s, out);
        return st == FMB_OK ? app_form_read("--expect", r->form, r->sense, *out)
                            : app_status_error(st);
    }

    app_source other = r->source;
    other.file = r->projection;
    other.format = FMB_FORMAT_AUTO;
    return r->projection ? app_source_read(&other, out) : APP_YES;
}

int cmd_check(int argc, char **argv)
{
    static const struct argp_child children[] = {
        {&app_source_argp, 0, NULL, 0}, {&app_decimal_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp whole = {.options = options,
                                      .parser = parse,
                                      .args_doc = "FILE PROOF",
                                      .doc = doc,
                                      .children = children};
    request r = {.patience = {.size = sizeof r.patience}};
    app_options_parse(&whole, argc, argv, &r);
    fmb_system *s = NULL, *image = NULL;
    fmb_evidence *e = NULL;
    app_budget_begin(r.patience.max_bytes);
    int code = app_source_read(&r.source, &s);
    if (code == APP_YES)
        code = read_image(&r, s, &image);
    if (code == APP_YES && r.relax)
        code = app_first_code(forget_integers(s), forget_integers(image));
    r.patience.max_bytes = app_budget_end();
    if (code == APP_UNDECIDED && r.json)
        print_stop_as_json(FMB_STOP_BYTES);
    begin_to_wait(&r);
    if (code == APP_YES)
        code = read_proof(&r, s, &e);
    if (code == APP_YES)
        code = judge(&r, s, e, image);
    fmb_evidence_free(e);
    fmb_system_free(image);
    fmb_system_free(s);
    return code;
}
