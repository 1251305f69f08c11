/* nulls.h: every public function, asked with NULL in place of each of its pointers in turn: ARG, an
 * answer that says nothing, or, where NULL has a meaning (nulls.py), anything but a crash. Included
 * by the text that nulls.py makes of the headers. */
#ifndef FMB_TEST_NULLS_H
#define FMB_TEST_NULLS_H

#include <criterion/criterion.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>
#include <fmb/gmp.h>
#include <fmb/lift.h>
#include <fmb/rule.h>
#include <fmb/session.h>
#include <fmb/symmetry.h>

#include "property/random/rows.h"

/* One of each: what calls are about. */
typedef struct world {
    fmb_system *s, *line, *graph; /* two variables, one row; x1 <= 1; y = x1 */
    const fmb_system *systems[1];
    fmb_solver *v; /* which has s loaded, and knows a point of it */
    fmb_evidence *e;
    fmb_box *box;
    fmb_optimum *best;
    fmb_generators *g;
    fmb_mesh *mesh, *other_mesh;
    fmb_pair *k;
    fmb_frames *set;
    fmb_frame_reader *lines;
    const fmb_frame_line *of_text, *next_line;
    fmb_permutations *p;
    fmb_proximity *near;
    fmb_script *script;
    fmb_matrix *matrix;
    const fmb_view *view;
    FILE *stream, *pairs;
    struct {
        fmb_system *system;
        fmb_solver *solver;
        fmb_evidence *evidence;
        fmb_box *box;
        fmb_optimum *optimum;
        fmb_generators *generators;
        fmb_mesh *mesh;
        fmb_pair *pair;
        fmb_frames *frames;
        fmb_frame_reader *frame_reader;
        fmb_permutations *permutations;
        fmb_proximity *proximity;
        fmb_script *script;
        fmb_matrix *matrix;
    } out; /* what calls give */
    char text[2000];
    const char *words[2], *said;
    double numbers[64];
    int indices[64], order[2];
    int64_t integers[64];
    size_t sizes[64], start[2];
    uint32_t corners[3];
    uint64_t bits[64];
    mpq_t q[64];
    mpz_t z;
    bool yes;
    fmb_alloc alloc;
    fmb_event event;
    fmb_frame frames[2];
    fmb_frame_q frames_q[2];
    fmb_frame_arrays arrays;
    fmb_frames_pair couple;
    fmb_mesh_options mesh_options;
    fmb_mesh_place place;
    fmb_number_style style;
    fmb_objective objective;
    fmb_objective_q objective_q;
    fmb_options options;
    fmb_pair_answers answers;
    fmb_pair_answers_q answers_q;
    fmb_pair_options pair_options;
    fmb_patience patience;
    fmb_reader reader;
    fmb_rel rels[4];
    fmb_rule rule;
    fmb_where where;
    fmb_fate fates[4];
    fmb_format format;
    fmb_generator_kind kind;
    fmb_judgement judgement;
    fmb_mesh_answer mesh_answer;
    fmb_mesh_nearest mesh_nearest;
    fmb_mesh_format mesh_format;
    fmb_pair_counts counts;
    fmb_result result;
    fmb_script_kind script_kind;
    fmb_stop stop;
    fmb_verdict verdicts[4];
} world;

typedef struct nulls_answer {
    fmb_status status;
    bool is_neutral;
} nulls_answer;

typedef struct nulls_call {
    const char *name;
    int pointers;
    bool needed[12]; /* is NULL in place of it wrong? */
    void (*ask)(world *w, int null, nulls_answer *answer);
    bool gives_status, frees, in_round;
} nulls_call;

#define P(k, pointer) (null == (k) ? NULL : (pointer))

bool hear_of_pairs(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair);
void sweep(const nulls_call *call);

#endif
