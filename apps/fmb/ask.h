/* ask.h: the common part of the command lines of commands that solve. */
#ifndef APP_ASK_H
#define APP_ASK_H

#include <fmb/options.h>

#include "common/source.h"

typedef struct app_ask {
    app_source source;
    fmb_options options;
    bool json;
    int digits;               /* of decimals, or 0: fractions */
    bool relax;               /* treat integer variables as reals */
    const char *trace;        /* file for the events, or NULL */
    const char *proof;        /* file for the evidence, or NULL */
    const char *rule_library; /* shared object with rules and orders, or NULL */
    const char *order;        /* word of --order that must be from such an object, or NULL */
    const char *symmetry;     /* file of symmetries, or NULL */
    void *own_input;          /* of the command's own parser */
    const struct app_usage *usage;
} app_ask;

/* The properties of one command. */
typedef struct app_usage {
    const char *args, *doc;
    const struct argp *own; /* options of this command alone, or NULL */
    bool shows_claims;      /* the report shows other claims than that of the verdict */
    bool takes_symmetries;  /* --symmetry may name a file */
} app_usage;

/* Parse the words of a command; the parser of usage->own gets own_input as state->input. Exits with
 * APP_USAGE, or after --help. */
void app_ask_parse(app_ask *ask, const app_usage *usage, void *own_input, int argc, char **argv);

/* The default memory limit, so that a command cannot bring its machine down: half of the memory, or
 * of the limit of this process [bytes]. */
size_t app_ask_half_of_memory(void);

/* For a command that prints nothing but a system, whose numbers are exact: APP_USAGE after a
 * message if --decimal is given without --json, which has decimals beside them; else APP_YES. */
int app_ask_exact_rows(const app_ask *ask);

/* Does the proof replace the report on standard output? (--proof -) */
bool app_ask_proof_only(const app_ask *ask);

#endif
