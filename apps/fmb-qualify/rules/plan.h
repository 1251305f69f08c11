/* plan.h: the plan of a study of rules, from its command line. */
#ifndef QUALIFY_PLAN_H
#define QUALIFY_PLAN_H

#include <argp.h>
#include <jansson.h>

#include "common/rule_library.h"
#include "study/grid/grid.h"

enum { PLAN_MOST_SETS = 32, PLAN_MOST_ORDERS = 8, PLAN_MOST_DIM = 12, PLAN_MOST_FILES = 1024 };

/* An order of elimination. */
typedef struct qualify_order {
    const char *name; /* of the library, or of a rule library */
    fmb_order order;
    fmb_chooser chooser; /* in its place, unless choose is NULL */
} qualify_order;

/* [borrows name] Find the order by its name, in the library or in the rule library. An exit code,
 * after a message that names the option unless it is APP_YES. */
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
    size_t sets; /* after _make set[0] is "none"; way k * sets + i is set i in order k */
    qualify_order order[PLAN_MOST_ORDERS];
    size_t orders;
    char *order_words; /* of --orders, owns their names; or NULL */
    const char *file[PLAN_MOST_FILES];
    size_t files;
    study_grid grid; /* numbers of the plan; filled by qualify_plan_make */
    study_way way[PLAN_MOST_SETS * PLAN_MOST_ORDERS];
    const char *rule_library; /* shared object with a user's rules and orders, or NULL */
    app_rule_library library;
    app_rule_set rules[PLAN_MOST_SETS]; /* the rules of each set */
    const char *out;                    /* folder for the report, or NULL */
    bool json, counts, detail, quiet;
    bool brief;             /* skips the counts on small frames */
    uint64_t shard, shards; /* as --shard says; 0 of 0 without */
    bool merge;             /* the files hold the shards of one run */
    json_t *arguments;      /* the options on systems, ways and limits */
    json_t **part;          /* [files of --merge] the shards with the runs, or NULL */
    size_t parts;
} qualify_plan;

extern const struct argp qualify_plan_argp;

void qualify_plan_init(qualify_plan *p);
/* Samples and ways of the grid; reads the files. An exit code, after a message unless 0. */
int qualify_plan_make(qualify_plan *p);
/* [give, qualify_plan_clear] Merge the files that p names, all shards of one run, into a plan that
 * was run. An exit code, after a message unless it is APP_YES. */
int qualify_plan_merge(const qualify_plan *p, qualify_plan *out);
/* All runs of a shard, for qualify_plan_merge. */
void qualify_runs_json(const qualify_plan *p, json_t *obj);
/* Make only the ways of the grid, from sets and orders. An exit code. */
int qualify_plan_ways(qualify_plan *p);
void qualify_plan_clear(qualify_plan *p);
/* Wrong answers found; queries that the clock stopped. */
size_t qualify_wrong(const qualify_plan *p);
size_t qualify_stopped_by_time(const qualify_plan *p);

/* The order of a way. */
const qualify_order *qualify_order_of(const qualify_plan *p, size_t way);
/* "order-pairs", ...: the key of the lines of that order. */
enum { PLAN_ORDER_KEY = 40 };
void qualify_order_key(const qualify_order *order, char out[PLAN_ORDER_KEY]);

#endif
