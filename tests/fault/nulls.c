/* nulls.c: see nulls.h. */
#include "nulls.h"

bool hear_of_pairs(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair)
{
    (void)self, (void)verdict, (void)n, (void)pair;
    return true;
}

static void *resize(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    (void)self, (void)old_bytes;
    if (new_bytes > 0)
        return realloc(p, new_bytes);
    free(p);
    return NULL;
}

static void put_number(void *self, mpq_srcptr q, FILE *out)
{
    (void)self;
    mpq_out_str(out, 10, q);
}

/* ---- plain values ---------------------------------------------------------------------------- */

static void fill_arrays(world *w)
{
    for (int i = 0; i < 64; i++) {
        mpq_init(w->q[i]);
        mpq_set_ui(w->q[i], 1, 1);
        w->numbers[i] = 1;
        w->integers[i] = 1;
    }
    mpz_init(w->z);
    w->start[1] = 1;
    w->order[1] = 1;
    for (uint32_t i = 0; i < 3; i++)
        w->corners[i] = i;
    w->words[0] = w->words[1] = "1";
    w->numbers[0] = w->numbers[4] = 0; /* a triangle */
}

static void fill_structures(world *w)
{
    w->alloc = (fmb_alloc){resize, NULL};
    w->event = (fmb_event){.kind = FMB_EVENT_BEGIN, .name = "solve"};
    for (int i = 0; i < 2; i++) {
        w->frames[i] = (fmb_frame){FMB_CUBOID, 1, 1, w->numbers, w->numbers + 1, NULL};
        w->frames_q[i] = (fmb_frame_q){FMB_CUBOID, 1, 1, w->q, w->q + 1, NULL};
    }
    w->arrays = (fmb_frame_arrays){.size = sizeof w->arrays,
                                   .shape = FMB_CUBOID,
                                   .naxes = 1,
                                   .origin = w->numbers,
                                   .axes = w->numbers + 1};
    w->place = (fmb_mesh_place){{1, 1, 1}, {0, 0, 0}};
    w->objective = (fmb_objective){.sense = FMB_SENSE_MAX, .coef = w->numbers};
    w->objective_q =
        (fmb_objective_q){.sense = FMB_SENSE_MAX, .n = 1, .var = w->indices, .coef = w->q};
    w->rule.name = "mine";
    w->style.put = put_number;
    w->answers = (fmb_pair_answers){.size = sizeof w->answers, .verdict = w->verdicts};
    w->answers_q.size = sizeof w->answers_q;
    w->mesh_options.size = sizeof w->mesh_options;
    w->options.size = sizeof w->options;
    w->pair_options.size = sizeof w->pair_options;
    w->patience.size = sizeof w->patience;
    w->reader.size = sizeof w->reader;
    w->judgement.size = sizeof w->judgement;
    w->mesh_answer.size = sizeof w->mesh_answer;
    w->mesh_nearest.size = sizeof w->mesh_nearest;
    w->counts.size = sizeof w->counts;
    w->result.size = sizeof w->result;
}

/* ---- objects --------------------------------------------------------------------------------- */

static const char PAIR[] = "{\"A\": {\"type\": \"cuboid\", \"orig\": [0], \"comp\": [[1]]}, "
                           "\"B\": {\"type\": \"cuboid\", \"orig\": [0], \"comp\": [[1]]}}\n";
static const char SCRIPT[] = "(declare-const x Real)(assert (< x 1))(check-sat)(get-value (x))";

static void open_systems(world *w)
{
    must(fmb_system_new(2, NULL, &w->s));
    must(fmb_system_add_int(w->s, (int64_t[]){1, 1}, FMB_LE, 4));
    must(fmb_system_set_objective(w->s, &w->objective));
    must(fmb_system_new(1, NULL, &w->line));
    must(fmb_system_add_int(w->line, (int64_t[]){1}, FMB_LE, 1));
    must(fmb_system_new(3, NULL, &w->graph));
    must(fmb_system_add_int(w->graph, (int64_t[]){1, 0, -1}, FMB_EQ, 0));
    w->systems[0] = w->s;
    must(fmb_system_matrix(w->s, &w->matrix));
}

static void open_answers(world *w)
{
    must(fmb_solver_new(NULL, NULL, &w->v));
    must(fmb_solver_load(w->v, w->s));
    must(fmb_solver_push(w->v));
    must(fmb_bound(w->v, w->s, NULL, 0, &w->box, NULL));
    must(fmb_optimize(w->v, w->line, &w->objective, &w->best, NULL));
    must(fmb_generate(w->v, w->line, &w->g, NULL));
    must(fmb_distance(w->v, w->frames, FMB_NORM_MAX, &w->near, NULL));
    must(fmb_solve(w->v, w->s, NULL));
    must(fmb_solver_evidence(w->v, &w->e));
    must(fmb_permutations_new(2, NULL, &w->p));
    must(fmb_permutations_add(w->p, (int[]){0, 1}));
}

static void open_bodies(world *w)
{
    static const double corner[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    must(fmb_mesh_new(3, 3, corner, 1, w->corners, NULL, &w->mesh));
    must(fmb_mesh_placed(w->mesh, &w->place, NULL, &w->other_mesh));
    must(fmb_pair_new(1, NULL, NULL, &w->k));
    must(fmb_frames_new(1, 1, w->frames, NULL, &w->set));
    must(fmb_frame_reader_from_text(PAIR, sizeof PAIR - 1, NULL, &w->lines));
    must(fmb_frame_reader_next(w->lines, &w->of_text, NULL));
    must(fmb_script_parse(SCRIPT, sizeof SCRIPT - 1, NULL, &w->script, NULL));
    must(fmb_script_next(w->script, &w->script_kind, NULL));
    must(fmb_script_next(w->script, &w->script_kind, NULL));
}

static void open_world(world *w)
{
    *w = (world){.stream = tmpfile()};
    cr_assert_not_null(w->stream);
    fill_arrays(w);
    fill_structures(w);
    open_systems(w);
    open_answers(w);
    open_bodies(w);
}

static void close_outputs(world *w)
{
    fmb_system_free(w->out.system);
    fmb_solver_free(w->out.solver);
    fmb_evidence_free(w->out.evidence);
    fmb_box_free(w->out.box);
    fmb_optimum_free(w->out.optimum);
    fmb_generators_free(w->out.generators);
    fmb_mesh_free(w->out.mesh);
    fmb_pair_free(w->out.pair);
    fmb_frames_free(w->out.frames);
    fmb_frame_reader_free(w->out.frame_reader);
    fmb_permutations_free(w->out.permutations);
    fmb_proximity_free(w->out.proximity);
    fmb_script_free(w->out.script);
    fmb_matrix_free(w->out.matrix);
    fmb_mesh_answer_clear(&w->mesh_answer);
    fmb_proximity_free(w->mesh_nearest.distance);
}

static void close_world(world *w)
{
    close_outputs(w);
    fmb_matrix_free(w->matrix);
    fmb_script_free(w->script);
    fmb_frame_reader_free(w->lines);
    fmb_frames_free(w->set);
    fmb_pair_free(w->k);
    fmb_mesh_free(w->mesh);
    fmb_mesh_free(w->other_mesh);
    fmb_permutations_free(w->p);
    fmb_evidence_free(w->e);
    fmb_proximity_free(w->near);
    fmb_generators_free(w->g);
    fmb_optimum_free(w->best);
    fmb_box_free(w->box);
    fmb_solver_free(w->v);
    fmb_system_free(w->graph);
    fmb_system_free(w->line);
    fmb_system_free(w->s);
    for (int i = 0; i < 64; i++)
        mpq_clear(w->q[i]);
    mpz_clear(w->z);
    fclose(w->stream);
}

/* ---- calls ----------------------------------------------------------------------------------- */

/* With nothing NULL (null = -1) the arguments are good ones. */
static void ask(const nulls_call *call, world *w, int null)
{
    nulls_answer got = {FMB_OK, false};
    call->ask(w, null, &got);
    bool needed = null >= 0 && call->needed[null];
    if (call->gives_status)
        cr_expect(null >= 0 ? !needed || got.status == FMB_ERR_ARG : got.status != FMB_ERR_ARG,
                  "%s, pointer %d: %s", call->name, null, fmb_status_text(got.status));
    else if (null == 0 && needed)
        cr_expect(got.is_neutral, "%s: says something of NULL", call->name);
}

/* ---- in a round of an elimination: a window is good there alone ------------------------------ */

typedef struct round_state {
    const nulls_call *call;
    world *w;
    bool asked;
} round_state;

/* The one that is asked by the rule at hand: tests are processes of their own. */
static round_state at_hand;

static void ask_in_round(void *state, const fmb_view *window, size_t i, uint64_t *drop)
{
    (void)state, (void)i, (void)drop;
    at_hand.w->view = window;
    for (int null = 0; !at_hand.asked && null < at_hand.call->pointers; null++)
        ask(at_hand.call, at_hand.w, null);
    at_hand.asked = true;
}

static void sweep_in_round(const nulls_call *call)
{
    static const fmb_rule rule = {
        .name = "asking", .flags = FMB_RULE_NEEDS_HISTORY, .drop_pairs = ask_in_round};
    world w;
    fmb_solver *v = NULL;
    fmb_system *s = NULL;
    open_world(&w);
    at_hand = (round_state){call, &w, false};
    must(fmb_solver_new(&(fmb_options){.size = sizeof(fmb_options), .method = FMB_METHOD_FM}, NULL,
                        &v));
    must(fmb_solver_add_rule(v, &rule));
    must(fmb_system_new(2, NULL, &s));
    for (int i = 0; i < 8; i++)
        must(fmb_system_add_int(s, (int64_t[]){i % 2 ? 3 + i : -3 - i, i % 3 - 1}, FMB_LE, 9 + i));
    must(fmb_project(v, s, (int[]){1}, 1, &w.out.system, NULL));
    cr_assert(at_hand.asked);
    fmb_system_free(s);
    fmb_solver_free(v);
    close_world(&w);
}

void sweep(const nulls_call *call)
{
    if (call->in_round) {
        sweep_in_round(call);
        return;
    }
    for (int null = call->frees ? 0 : -1; null < call->pointers; null++) {
        world w;
        open_world(&w);
        ask(call, &w, null);
        close_world(&w);
    }
}
