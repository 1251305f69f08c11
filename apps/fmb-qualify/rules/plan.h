/* plan.h: what a study of rules is to look at, from its command line. */
#ifndef QUALIFY_PLAN_H
#define QUALIFY_PLAN_H

#include <argp.h>
#include <jansson.h>

#include "common/rule_library.h"
#include "study/grid/grid.h"

enum { PLAN_MOST_SETS = 32, PLAN_MOST_ORDERS = 8, PLAN_MOST_DIM = 12, PLAN_MOST_FILES = 1024 };

/* Which variable goes next. */
typedef struct qualify_order {
    const char *name; /* of the library, or of a rule library */
    fmb_order order;
    fmb_chooser chooser; /* in its place, unless choose is NULL */
} qualify_order;

/* [borrows name] What the word means: an order of the library, or one of the rule library. An exit
 * code, after a message that names the option unless it is APP_YES. */
int qualify_order_find(const app_rule_library *l, const char *option, const char *name,
                       qualify_order *out);

typedef struct qualify_plan {
    study_family family;
    bool dim[PLAN_MOST_DIM + 1];     /* which */
    bool motion[2];                  /* static, dynamic */
    bool kind[2][2];                 /* shapes of A and B */
    bool meeting[2];                 /* no, yes */
    bool frames_asked, pairs_asked;  /* --dim, --pairs were given */
    const char *set[PLAN_MOST_SETS]; /* rules; "default" is the library's choice */
    size_t sets; /* once made, set[0] is none; way k * sets + i is set i in order k */
    qualify_order order[PLAN_MOST_ORDERS];
    size_t orders;
    char *order_words; /* of --orders, where the names are; or NULL */
    const char *file[PLAN_MOST_FILES];
    size_t files;
    study_grid grid; /* numbers of the plan; filled by qualify_plan_make */
    study_way way[PLAN_MOST_SETS * PLAN_MOST_ORDERS];
    const char *rule_library; /* shared object with rules and orders of one's own, or NULL */
    app_rule_library library;
    app_rule_set rules[PLAN_MOST_SETS]; /* what each set is made of */
    const char *out;                    /* folder for the report, or NULL */
    bool json, counts, detail, quiet;
    bool brief;             /* without the counts on small frames */
    uint64_t shard, shards; /* as --shard says; 0 of 0 without */
    bool merge;             /* the files hold the shards of one run */
    json_t *arguments;      /* what was said of systems, ways and limits */
    json_t **part;          /* [files of --merge] whose runs these are, or NULL */
    size_t parts;
} qualify_plan;

extern const struct argp qualify_plan_argp;

void qualify_plan_init(qualify_plan *p);
/* Samples and ways of the grid; reads the files. An exit code, after a message unless 0. */
int qualify_plan_make(qualify_plan *p);
/* [give, qualify_plan_clear] What the files that p names, the shards of one run, hold together: a
 * plan that was run. An exit code, after a message unless it is APP_YES. */
int qualify_plan_merge(const qualify_plan *p, qualify_plan *out);
/* All runs of a shard, for qualify_plan_merge. */
void qualify_runs_json(const qualify_plan *p, json_t *obj);
/* Only the ways of the grid, from sets and orders. An exit code. */
int qualify_plan_ways(qualify_plan *p);
void qualify_plan_clear(qualify_plan *p);
/* Wrong answers found; queries that the clock stopped. */
size_t qualify_wrong(const qualify_plan *p);
size_t qualify_stopped_by_time(const qualify_plan *p);

/* The order of a way. */
const qualify_order *qualify_order_of(const qualify_plan *p, size_t way);
/* "order-pairs", ...: where the lines of that order are. */
enum { PLAN_ORDER_KEY = 40 };
void qualify_order_key(const qualify_order *order, char out[PLAN_ORDER_KEY]);

#endif
