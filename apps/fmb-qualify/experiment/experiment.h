/* experiment.h: an experiment: a plan in a JSON file, each run of which becomes a line of CSV.
 *
 * A block is measured together: the systems of one family, size, digits and density, one for each
 * seed, by every way. Blocks are independent, so that a run can stop and resume between any two, or
 * be split into shards.
 */
#ifndef QUALIFY_EXPERIMENT_H
#define QUALIFY_EXPERIMENT_H

#include <jansson.h>

#include "common/rule_library.h"
#include "study/grid/grid.h"

enum { QUALIFY_EXPERIMENT_NAME = 13 };

typedef struct qualify_block {
    const char *file; /* with a system to read; or NULL */
    int family, size, digits, density;
} qualify_block;

/* Names of ways in CSV; "" where a method has none. */
typedef struct qualify_way_names {
    const char *method, *order, *rules, *evidence;
} qualify_way_names;

typedef struct qualify_experiment {
    json_t *plan;                       /* owns all strings */
    char name[QUALIFY_EXPERIMENT_NAME]; /* digest of the plan: the same for equal plans */
    qualify_block *block;
    size_t blocks;
    int *seed;
    size_t seeds;
    study_way *way;
    qualify_way_names *way_names; /* [ways] */
    app_rule_set *set;            /* [ways] */
    size_t ways;
    study_limits limits;
    int passes;
    bool projects;
    app_rule_library library;
} qualify_experiment;

/* [give, qualify_experiment_clear, always] Read a plan. An exit code, after a message. */
int qualify_experiment_read(const char *path, qualify_experiment *out);
/* Likewise from a parsed plan, which *out now owns; messages call it path. */
int qualify_experiment_take(json_t *plan, const char *path, qualify_experiment *out);
void qualify_experiment_clear(qualify_experiment *e);
/* Systems of a block. */
size_t qualify_block_size(const qualify_experiment *e, size_t block);

/* [give, study_grid_clear] Run a block: a grid of one sample. An exit code, after a message unless
 * it is APP_YES. */
int qualify_block_run(const qualify_experiment *e, size_t block, study_grid *g);
/* Write its lines: runs with equal counts have equal lines, except for their times. */
void qualify_block_write(const qualify_experiment *e, size_t block, const study_grid *g, FILE *f);
/* The first line of a file, with its end. */
extern const char qualify_experiment_header[];

/* fmb-qualify run, merge, bias. */
int qualify_run(int argc, char **argv);
int qualify_merge(int argc, char **argv);
int qualify_bias(int argc, char **argv);

#endif
