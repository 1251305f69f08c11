/* verdict.h: reporting a verdict: the point, or the rows in conflict. */
#ifndef APP_VERDICT_H
#define APP_VERDICT_H

#include <gmp.h>
#include <jansson.h>

#include "fmb/query.h"

/* The first claim of that kind; SIZE_MAX if there is none. */
size_t app_verdict_claim(const app_session *s, fmb_claim_kind kind);

/* The verdict line ("unknown (time)"), and its proof: point or conflict. */
void app_verdict_print(const app_session *s);
/* Print a line for each row with its multiplier in the claim. *sum: the sum of the right sides
 * times these; *strict: one of the rows is strict. */
void app_verdict_print_multipliers(const app_session *s, size_t claim, mpq_t sum, bool *strict);
/* A JSON object with verdict, stop, and conflict if it is infeasible. The caller adds more, and
 * app_json_set_stats at the end. */
json_t *app_verdict_json(const app_session *s);
void app_json_set_witness(json_t *obj, const app_session *s);
void app_json_set_stats(json_t *obj, const fmb_stats *stats);
/* [{"row": ..., "multiplier": ...}] of claim i. */
json_t *app_json_multipliers(const app_session *s, size_t claim);

#endif
