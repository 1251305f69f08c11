/* report.h: what a validation found, in words. */
#ifndef VALIDATE_REPORT_H
#define VALIDATE_REPORT_H

#include <jansson.h>

#include "fmb-validate/plan.h"

/* As in the article: a line for each case and family. */
void validate_table(const validate_plan *p);

/* [give] All counts. */
json_t *validate_json(const validate_plan *p);
/* One line of its cases, back; false if it is none. */
bool validate_job_read(const json_t *obj, validate_job *out);
/* [give] One disagreement: the pair as `fmb intersect --nearest` reads it, and what was said of it.
 */
json_t *validate_failure(const validate_job *job, const study_finding *finding);

#endif
