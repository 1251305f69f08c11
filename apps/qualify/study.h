/* study.h: what all studies of fmb-qualify have in common: their options, and how they are run. */
#ifndef QUALIFY_STUDY_H
#define QUALIFY_STUDY_H

#include <argp.h>
#include <stdint.h>

#include <fmb/options.h>

#include "qualify/page.h"

typedef struct qualify_setup {
    size_t pairs; /* of each class */
    int passes;   /* of the clock */
    uint64_t seed;
    fmb_simd simd;
    const char *out; /* folder for the report, or NULL */
    bool json, quiet;
} qualify_setup;

typedef struct qualify_study {
    const char *name, *title;         /* the title is one line */
    const char *doc;                  /* for --help: what it does; may have \v as argp takes it */
    size_t pairs, passes;             /* as long as nothing else is asked for: by itself */
    size_t brief_pairs, brief_passes; /* as one of all studies, which take minutes together */
    /* The study: adds to the page, and returns an exit code after a message unless it is APP_YES.
     * Between its steps it asks qualify_watch_step, and ends early, with what is complete, if that
     * says so. */
    int (*run)(const qualify_setup *o, qualify_page *page);
} qualify_study;

/* The studies in the order of the report. */
extern const qualify_study qualify_table1, qualify_near, qualify_faces, qualify_boxes,
    qualify_scaling, qualify_peers;

/* argv[0] is "fmb-qualify NAME"; an exit code. */
int qualify_study_main(const qualify_study *s, int argc, char **argv);

#endif
