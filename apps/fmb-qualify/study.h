/* study.h: what the studies of fmb-qualify have in common: their options, and how they are run. */
#ifndef QUALIFY_STUDY_H
#define QUALIFY_STUDY_H

#include <fmb/options.h>

#include "fmb-qualify/page.h"

typedef struct qualify_setup {
    size_t pairs; /* of each class */
    int passes;   /* of the clock */
    uint64_t seed;
    fmb_simd simd;
    const char *out;  /* folder for the report, or NULL */
    const char *file; /* the study's input, or NULL */
    bool takes_file;
    bool json, quiet;
    size_t counter; /* of the study's cells (share.h) */
} qualify_setup;

/* The amount of work: pairs of each class, and passes of the clock. */
typedef struct qualify_effort {
    size_t pairs;
    int passes;
} qualify_effort;

typedef struct qualify_study {
    const char *name, *title; /* the title is one line */
    const char *doc;          /* for --help, as argp takes it */
    bool takes_file;          /* a FILE may stand on its command line */
    bool shared;              /* run() is for all ranks (share.h), else for rank 0 alone */
    qualify_effort alone;     /* the default of the study by itself */
    qualify_effort brief;     /* its part of all studies, which together take minutes */
    /* The study: adds to the page, whose section has begun; an exit code, after a message unless it
     * is APP_YES. It calls qualify_watch_step between its steps; if that returns false, it ends
     * early with the complete results. */
    int (*run)(const qualify_setup *o, qualify_page *page);
} qualify_study;

/* The studies in the order of the report. */
extern const qualify_study qualify_study_table1, qualify_study_article, qualify_study_near,
    qualify_study_touching, qualify_study_slender, qualify_study_mesh, qualify_study_faces,
    qualify_study_boxes, qualify_study_scaling, qualify_study_rules, qualify_study_peers,
    qualify_study_bunny;

/* One study; argv[0] is "fmb-qualify NAME". An exit code. */
int qualify_study_main(const qualify_study *s, int argc, char **argv);

/* Commands of fmb-qualify with options of their own. */
int qualify_all(int argc, char **argv);
int qualify_rules(int argc, char **argv);
int qualify_benchmark(int argc, char **argv);

#endif
