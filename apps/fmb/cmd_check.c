/* cmd_check.c: fmb check FILE PROOF. Of the library it sees systems, their readers and the checker,
 * so that nothing which solves has a say in what is accepted. */
#include <fmb/io.h>
#include <fmb/proof.h>
#include <fmb/system.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/json.h"
#include "common/message.h"
#include "common/source.h"
#include "fmb/commands.h"

enum { KEY_JSON = 'j' };

typedef struct request {
    app_source source;
    const char *proof;
    bool json;
} request;

static const struct argp_option options[] = {
    {"json", KEY_JSON, NULL, 0, "Print one JSON object instead of text", 2}, {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    request *r = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &r->source;
        return 0;
    case KEY_JSON:
        r->json = true;
        return 0;
    case ARGP_KEY_ARG:
        if (!r->source.file || r->proof)
            return ARGP_ERR_UNKNOWN;
        r->proof = arg;
        return 0;
    case ARGP_KEY_END:
        if (!r->proof)
            argp_error(state, "FILE or PROOF is missing");
        else if (strcmp(r->source.file, "-") == 0 && strcmp(r->proof, "-") == 0)
            argp_error(state, "FILE and PROOF cannot both be standard input");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] =
    "Judge the claims in PROOF about the system in FILE, in exact arithmetic and without the "
    "solver."
    "\v"
    "Exit codes: 0 accepted, 1 rejected.\n"
    "\n"
    "Examples:\n"
    "  fmb solve plan.smt2 --proof plan.proof; fmb check plan.smt2 plan.proof\n"
    "  fmb bounds diet.fmb --proof - | fmb check diet.fmb -\n";

static int read_proof(const request *r, const fmb_system *s, fmb_evidence **out)
{
    FILE *in;
    int code = app_file_open(r->proof, &in);
    if (code != APP_YES)
        return code;
    fmb_where where = {0};
    fmb_status st = fmb_evidence_read(in, s, out, &where);
    code = app_source_outcome(st, r->proof, &where);
    app_file_close_input(in);
    return code;
}

/* What a proof that is accepted says; one without a verdict still makes claims. */
static void print_text(const fmb_judgement *j, const fmb_evidence *e)
{
    if (!j->accepted && j->claim == SIZE_MAX)
        printf("rejected: %s\n", j->reason);
    else if (!j->accepted)
        printf("rejected: claim %zu: %s\n", j->claim + 1, j->reason);
    else if (j->verdict != FMB_UNKNOWN)
        printf("accepted: %s\n", fmb_verdict_text(j->verdict));
    else
        printf("accepted: %zu claims\n", fmb_evidence_claims(e));
}

static void print_json(const fmb_judgement *j, const fmb_evidence *e)
{
    json_t *obj = app_need(json_object());
    app_json_set(obj, "accepted", json_boolean(j->accepted));
    app_json_set(obj, "verdict", json_string(fmb_verdict_text(j->verdict)));
    app_json_set(obj, "claims", json_integer((json_int_t)fmb_evidence_claims(e)));
    if (!j->accepted && j->claim != SIZE_MAX)
        app_json_set(obj, "claim", json_integer((json_int_t)j->claim + 1));
    if (!j->accepted)
        app_json_set(obj, "reason", app_json_text(j->reason));
    app_json_print(obj);
}

static int judge(const request *r, const fmb_system *s, const fmb_evidence *e)
{
    fmb_judgement j = {0};
    fmb_status st = fmb_check(s, e, &j);
    if (st != FMB_OK)
        return app_status_error(st);
    if (r->json)
        print_json(&j, e);
    else
        print_text(&j, e);
    return j.accepted ? APP_YES : APP_NO;
}

int cmd_check(int argc, char **argv)
{
    static const struct argp_child children[] = {{&app_source_argp, 0, NULL, 0},
                                                 {NULL, 0, NULL, 0}};
    static const struct argp whole = {.options = options,
                                      .parser = parse,
                                      .args_doc = "FILE PROOF",
                                      .doc = doc,
                                      .children = children};
    request r = {.proof = NULL};
    argp_parse(&whole, argc, argv, 0, NULL, &r);
    fmb_system *s = NULL;
    fmb_evidence *e = NULL;
    int code = app_source_read(&r.source, &s);
    if (code == APP_YES)
        code = read_proof(&r, s, &e);
    if (code == APP_YES)
        code = judge(&r, s, e);
    fmb_evidence_free(e);
    fmb_system_free(s);
    return code;
}
