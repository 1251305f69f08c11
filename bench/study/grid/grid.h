/* grid.h: all ways on all systems: the runs of a study of rules.
 *
 * A sample is the systems of one line of a table: drawn pairs of one class, or one system that was
 * read. Counts depend on the plan alone. A timed pass goes over all systems of a sample, each once;
 * the ways take turns, after one pass that does not count. The order of the ways changes with the
 * pass and the sample, so that no way always finds the same caches. Each system keeps its median.
 */
#ifndef FMB_STUDY_GRID_H
#define FMB_STUDY_GRID_H

#include "study/draw/draw.h"
#include "study/grid/run.h"
#include "study/reference/reference.h"

typedef struct study_case {
    fmb_system *s;
    int *keep, kept;   /* variables to project on */
    fmb_verdict truth; /* FMB_UNKNOWN: from the reference */
    char *projection;  /* the true projection (reference.h); NULL: from the reference */
} study_case;

typedef struct study_sample {
    study_class class; /* of drawn systems */
    const char *file;  /* of a system that was read, borrowed; NULL if drawn */
    study_case *item;
    size_t size, capacity;
} study_sample;

typedef struct study_grid {
    /* The plan: set before study_grid_run. */
    unsigned long seed;
    size_t per_class; /* systems drawn of each class */
    study_limits limits;
    study_way *way; /* [ways], borrowed */
    size_t ways;
    int passes;           /* of the clock; 0: no times */
    bool projects;        /* time is that of the projections, not of the verdicts */
    size_t turn;          /* which way begins */
    size_t shard, shards; /* only part `shard` of 1 ... shards is run; 0 of 0: all */
    /* Called before each query; false ends the study early. May be NULL. */
    bool (*step)(void *self, size_t done, size_t all);
    void *self;
    fmb_solver *volatile *running; /* is set to the working solver, so that it can be cancelled from
                                    * outside; or NULL */

    study_sample *sample; /* [samples] */
    size_t samples, sample_capacity;
    /* The results. */
    study_names names;
    bool *known;     /* [ways] all its rules exist */
    study_run *run;  /* [samples][most][ways] */
    size_t most;     /* systems in the largest sample */
    size_t prepared; /* samples that are drawn and answered */
    size_t complete; /* samples that all ways have gone through */
    size_t rejected; /* answers of the reference that the checker did not accept */
} study_grid;

/* Append an empty sample. Errors: MEMORY. */
fmb_status study_grid_add(study_grid *g, const study_sample *sample);
/* Put a system into a sample; takes over s and keep. Errors: MEMORY (s and keep are freed). */
fmb_status study_sample_put(study_sample *sample, fmb_system *s, int *keep, int kept);

fmb_status study_grid_run(study_grid *g);
void study_grid_clear(study_grid *g);

/* Eliminate as study_engine_count does, and compare the answer with the truth of the case. */
fmb_status study_case_count(study_reference *reference, study_engine *engine, const study_case *c,
                            study_run *run);

/* The way at a place of a pass over a sample: rows of a Latin square that is balanced for
 * carry-over effects of the caches: each way stands once at each place and follows each other way
 * once (Williams 1949: 0, 1, n - 1, 2, n - 2, ..., and its cyclic shifts; an odd n needs two
 * squares, the second one mirrored). Passes, samples and turns go from row to row. */
size_t study_grid_turn(const study_grid *g, size_t sample, size_t pass, size_t place);

static inline study_run *study_grid_at(const study_grid *g, size_t sample, size_t item, size_t way)
{
    return &g->run[(sample * g->most + item) * g->ways + way];
}

#endif
