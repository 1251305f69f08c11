/* crews.c: several threads at one query, and several threads with queries of their own over what
 * they share, say what one thread says.
 *
 *   crews [--seed=S]
 *
 * Sets of frames, meshes, sessions, evidence, and queries of solvers with threads. For the thread
 * sanitizer, which has no say in Criterion's processes: see the file run.
 */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/frames.h>
#include <fmb/mesh.h>
#include <fmb/session.h>

#include "asking.h"
#include "rows.h"
#include "support.h"

enum { CREW = 4 };

/* work(self, i) in a thread of its own for each i below CREW. */
typedef struct member {
    pthread_t thread;
    void (*work)(void *self, int i);
    void *self;
    int i;
} member;

static void *start_member(void *self)
{
    member *m = self;
    m->work(m->self, m->i);
    return NULL;
}

static void all_at_once(void (*work)(void *self, int i), void *self)
{
    member m[CREW];
    for (int i = 0; i < CREW; i++) {
        m[i] = (member){.work = work, .self = self, .i = i};
        if (pthread_create(&m[i].thread, NULL, start_member, &m[i]) != 0)
            asking_fail("no thread");
    }
    for (int i = 0; i < CREW; i++)
        pthread_join(m[i].thread, NULL);
}

/* Small whole numbers: many ties, which doubles leave to the exact way. */
static void draw_numbers(support_rng *g, int most, size_t n, double *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = support_between(g, -most, most);
}

/* ---- sets of frames -------------------------------------------------------------------------- */

enum { FRAMES = 200, DIM = 3, PAIRS = 4000 };

typedef struct frames_answers {
    fmb_verdict pair[PAIRS], row[FRAMES];
    char meets[FRAMES][FRAMES];
} frames_answers;

typedef struct frames_scene {
    fmb_frames *a, *b;
    fmb_frames_pair pair[PAIRS];
    frames_answers by_one, by_crew[CREW];
} frames_scene;

static fmb_frames *draw_frames(support_rng *g)
{
    static double number[FRAMES][DIM * (DIM + 2)];
    static fmb_frame frame[FRAMES];
    fmb_frames *s = NULL;
    for (int i = 0; i < FRAMES; i++) {
        double *x = number[i];
        draw_numbers(g, 9, DIM, x);
        draw_numbers(g, 3, DIM * (DIM + 1), x + DIM);
        frame[i] = (fmb_frame){.shape = support_chance(g, 50) ? FMB_CUBOID : FMB_SIMPLEX,
                               .dim = DIM,
                               .naxes = support_between(g, 1, DIM),
                               .origin = x,
                               .axes = x + DIM,
                               .speed = support_chance(g, 30) ? x + DIM * (DIM + 1) : NULL};
    }
    must(fmb_frames_new(DIM, FRAMES, frame, NULL, &s));
    return s;
}

static bool note_pairs(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair)
{
    frames_answers *out = self;
    for (size_t i = 0; i < n; i++)
        out->meets[pair[i].a][pair[i].b] = (char)verdict;
    return true;
}

static void ask_frames(const frames_scene *c, size_t threads, frames_answers *out)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    o.threads = threads;
    must(fmb_pair_new(DIM, &o, NULL, &k));
    must(fmb_frames_test(
        k, c->a, c->b, PAIRS, c->pair,
        &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = out->pair}));
    must(fmb_frames_test_row(k, c->a, 0, c->b, out->row));
    must(fmb_frames_meet(k, c->a, c->b, note_pairs, out));
    fmb_pair_free(k);
}

static void ask_frames_as_member(void *self, int i)
{
    frames_scene *c = self;
    ask_frames(c, CREW, &c->by_crew[i]);
}

static void try_frames(support_rng *g)
{
    static frames_scene c;
    c.a = draw_frames(g);
    c.b = draw_frames(g);
    for (int i = 0; i < PAIRS; i++)
        c.pair[i] = (fmb_frames_pair){(uint32_t)support_between(g, 0, FRAMES - 1),
                                      (uint32_t)support_between(g, 0, FRAMES - 1)};
    ask_frames(&c, 1, &c.by_one);
    all_at_once(ask_frames_as_member, &c);
    for (int i = 0; i < CREW; i++)
        if (memcmp(&c.by_one, &c.by_crew[i], sizeof c.by_one) != 0)
            asking_fail("sets of frames: crew %d differs from one thread", i);
    fmb_frames_free(c.a);
    fmb_frames_free(c.b);
}

/* ---- meshes ---------------------------------------------------------------------------------- */

enum { CELLS = 400 };

static fmb_mesh *draw_mesh(support_rng *g, int corners)
{
    static double point[CELLS * 3];
    static uint32_t corner[CELLS * 4];
    fmb_mesh *m = NULL;
    draw_numbers(g, 9, CELLS * 3, point);
    for (int i = 0; i < CELLS * corners; i++)
        corner[i] = (uint32_t)support_between(g, 0, CELLS - 1);
    must(fmb_mesh_new(corners, CELLS, point, CELLS, corner, NULL, &m));
    return m;
}

static void compare_meshes(const fmb_mesh *a, const fmb_mesh *b, const double *motion)
{
    fmb_mesh_options o = {.size = sizeof o, .neighbours = true, .motion = motion};
    fmb_mesh_answer one = {.size = sizeof one}, crew = {.size = sizeof crew};
    must(fmb_mesh_meet(a, b, &o, &one));
    o.threads = CREW;
    must(fmb_mesh_meet(a, b, &o, &crew));
    bool same = one.hits == crew.hits;
    for (size_t i = 0; same && i < one.hits; i++)
        same = one.hit[i].a == crew.hit[i].a && one.hit[i].b == crew.hit[i].b &&
               one.hit[i].how == crew.hit[i].how && one.hit[i].shared == crew.hit[i].shared;
    if (!same || one.hits == 0)
        asking_fail("meshes: %zu hits by one thread, %zu by a crew", one.hits, crew.hits);
    fmb_mesh_answer_clear(&one);
    fmb_mesh_answer_clear(&crew);
}

static void try_meshes(support_rng *g)
{
    const double motion[3] = {1, 2, -1};
    fmb_mesh *a = draw_mesh(g, 3), *b = draw_mesh(g, 4);
    compare_meshes(a, NULL, NULL);
    compare_meshes(a, b, NULL);
    compare_meshes(b, a, motion);
    fmb_mesh_free(a);
    fmb_mesh_free(b);
}

/* ---- sessions -------------------------------------------------------------------------------- */

enum { ROUNDS = 30, MOST_VARIABLES = 32 };

typedef struct sessions {
    const fmb_system *s; /* of all */
    uint64_t seed;
    fmb_verdict by_one[ROUNDS], by_crew[CREW][ROUNDS];
} sessions;

/* Rows come and go, the same for the same seed. */
static void play_session(const sessions *c, size_t threads, fmb_verdict *out)
{
    support_rng g = {c->seed};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    o.threads = threads;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solver_load(v, c->s));
    for (int i = 0; i < ROUNDS; i++) {
        double a[MOST_VARIABLES] = {0};
        draw_numbers(&g, 5, (size_t)fmb_system_dim(c->s), a);
        must(fmb_solver_push(v));
        must(fmb_solver_add(v, a, FMB_LE, support_between(&g, -20, 10)));
        must(fmb_solve(v, fmb_solver_system(v), &r));
        out[i] = r.verdict;
        if (i % 3 > 0 || r.verdict == FMB_INFEASIBLE)
            must(fmb_solver_pop(v));
    }
    fmb_solver_free(v);
}

static void play_session_as_member(void *self, int i)
{
    sessions *c = self;
    play_session(c, 2, c->by_crew[i]);
}

static void try_sessions(support_rng *g, const fmb_system *s)
{
    sessions c = {.s = s, .seed = support_next(g)};
    play_session(&c, 1, c.by_one);
    all_at_once(play_session_as_member, &c);
    for (int i = 0; i < CREW; i++)
        if (memcmp(c.by_one, c.by_crew[i], sizeof c.by_one) != 0)
            asking_fail("sessions: that of thread %d differs", i);
}

/* ---- evidence -------------------------------------------------------------------------------- */

typedef struct trial {
    const scene *c;
    fmb_evidence *e;
} trial;

static void check_evidence(void *self, int i)
{
    const trial *t = self;
    fmb_judgement j = {.size = sizeof j};
    must(fmb_check(t->c->s, t->e, &j));
    if (!j.accepted || j.verdict != t->c->verdict)
        asking_fail("%s: thread %d rejects the evidence: %s", t->c->name, i, j.reason);
}

static void try_evidence(const scene *c)
{
    trial t = {.c = c};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, c->s, &r));
    must(fmb_solver_evidence(v, &t.e));
    all_at_once(check_evidence, &t);
    fmb_evidence_free(t.e);
    fmb_solver_free(v);
}

/* ---- solvers --------------------------------------------------------------------------------- */

/* Every question, in every way, by several threads; the judge is that of race.c. */
static void try_solvers(const scene *c)
{
    for (int method = FMB_METHOD_AUTO; method <= FMB_METHOD_DD; method++)
        for (int kind = 0; kind < ASKING_KINDS; kind++) {
            fmb_options o = {.size = sizeof o};
            fmb_solver *v = NULL;
            size_t readings;
            o.method = (fmb_method)method;
            o.threads = CREW;
            o.max_seconds = 2; /* some ways take for ever */
            o.evidence = FMB_EVIDENCE_WHOLE;
            must(fmb_solver_new(&o, NULL, &v));
            asking(v, c, (asking_kind)kind, &readings);
            fmb_solver_free(v);
        }
}

int main(int argc, char **argv)
{
    scene c[SCENES_MOST];
    support_rng g = {1};
    if (argc > 2 || (argc == 2 && strncmp(argv[1], "--seed=", 7) != 0))
        asking_fail("usage: crews [--seed=S]");
    if (argc == 2)
        g.state = strtoull(argv[1] + 7, NULL, 10);
    int scenes = scenes_all(c);
    try_frames(&g);
    try_meshes(&g);
    for (int i = 0; i <= SCENE_SLOW; i++) {
        if (c[i].verdict == FMB_FEASIBLE)
            try_sessions(&g, c[i].s);
        try_evidence(&c[i]);
        try_solvers(&c[i]);
    }
    for (int i = 0; i < scenes; i++)
        fmb_system_free(c[i].s);
    printf("sets, meshes, sessions, evidence and %d scenes by crews of %d\n", SCENE_SLOW + 1, CREW);
    return 0;
}
