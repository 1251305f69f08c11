/* bunny.c: the article's study: which faces of a scan, a unit thick, meet its mirror image? By
 * trees of boxes, and by all pairs: some faces against all others are timed, and the total is
 * extrapolated. */
#include <string.h>

#include <fmb/frames.h>

#include "common/message.h"
#include "common/ranks.h"
#include "fmb-qualify/bunny/bunny.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/share.h"
#include "fmb-qualify/watch.h"
#include "study/clock/clock.h"

typedef struct bunny_study {
    const qualify_setup *setup;
    bunny_body a, b;
    fmb_mesh_answer answer;
    double tree_seconds, meet_seconds, pair_seconds, pair_ns; /* thread time */
    size_t timed, sampled, wrong;                             /* pairs */
} bunny_study;

/* ---- by trees -------------------------------------------------------------------------------- */

static bool tell_bunny_progress(void *self, double done)
{
    (void)self;
    return qualify_watch_step_within(NULL, (size_t)(done * 1000), 1000);
}

/* Frames, their corners and trees; then the meeting pairs. */
static fmb_status ask_by_trees(bunny_study *s, const fmb_mesh *m)
{
    const fmb_mesh_options o = {
        .size = sizeof o, .neighbours = true, .progress = tell_bunny_progress};
    double start = study_thread_seconds();
    fmb_status st = bunny_body_make(m, false, &s->a);
    if (st == FMB_OK)
        st = bunny_body_make(m, true, &s->b);
    double middle = study_thread_seconds();
    if (st == FMB_OK)
        st = fmb_mesh_meet(s->a.cells, s->b.cells, &o, &s->answer);
    s->tree_seconds = middle - start;
    s->meet_seconds = study_thread_seconds() - middle;
    return st;
}

/* ---- all pairs, sampled ---------------------------------------------------------------------- */

/* Did face i of A and face j of B meet? Hits are in order. */
static bool find_hit(const fmb_mesh_answer *answer, size_t i, size_t j)
{
    size_t low = 0, high = answer->hits;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const fmb_mesh_hit *h = &answer->hit[middle];
        if (h->a < i || (h->a == i && h->b < j))
            low = middle + 1;
        else
            high = middle;
    }
    return low < answer->hits && answer->hit[low].a == i && answer->hit[low].b == j;
}

/* Face i of A against all of B; its time is added. */
static fmb_status ask_face(bunny_study *s, fmb_pair *k, size_t i, const fmb_frames *const set[2],
                           fmb_verdict *v, double *seconds)
{
    size_t n = s->b.faces;
    double start = study_thread_seconds();
    fmb_status st = fmb_frames_test_row(k, set[0], i, set[1], v);
    *seconds += study_thread_seconds() - start;
    for (size_t j = 0; st == FMB_OK && j < n; j++)
        s->wrong += (v[j] == FMB_FEASIBLE) != find_hit(&s->answer, i, j);
    s->sampled += n;
    return st;
}

/* The hit whose face of A is number r of `rows` sampled faces. */
static size_t sampled_hit(const fmb_mesh_answer *answer, size_t r, size_t rows)
{
    return answer->hit[r * answer->hits / rows % answer->hits].a;
}

/* Row r < rows: evenly spread faces of A, which are timed; then sampled meeting faces. */
static fmb_status ask_row(bunny_study *s, fmb_pair *k, size_t r, size_t rows,
                          const fmb_frames *const set[2], fmb_verdict *v)
{
    double untimed = 0;
    if (r < rows)
        return ask_face(s, k, (size_t)((2 * (uint64_t)r + 1) * s->a.faces / (2 * rows)), set, v,
                        &s->pair_seconds);
    r -= rows;
    size_t i = r < s->answer.hits ? sampled_hit(&s->answer, r, rows) : 0;
    bool again = r > 0 && r < s->answer.hits && sampled_hit(&s->answer, r - 1, rows) == i;
    return r >= s->answer.hits || again ? FMB_OK : ask_face(s, k, i, set, v, &untimed);
}

/* As many faces of A as give the requested number of pairs, and at most as many meeting faces.
 * Ranks share them. */
static fmb_status ask_some_faces(bunny_study *s, fmb_pair *k, const fmb_frames *const set[2])
{
    size_t n = s->a.faces, rows = s->setup->pairs / (s->b.faces + 1) + 1;
    fmb_verdict *v = app_need(malloc((s->b.faces + 1) * sizeof *v));
    fmb_status st = FMB_OK;
    rows = rows < n ? rows : n;
    qualify_share share = qualify_share_begin(s->setup, 2 * rows);
    for (size_t r;
         st == FMB_OK && qualify_share_next(&share, &r) && qualify_watch_step_within(NULL, 0, 1);)
        st = ask_row(s, k, r, rows, set, v);
    s->timed = rows * s->b.faces;
    qualify_share_end(&share);
    free(v);
    return st;
}

/* On rank 0: the sums over all ranks. */
static void collect_sums(bunny_study *s)
{
    uint64_t sum[3] = {s->sampled, s->wrong, (uint64_t)(1e9 * s->pair_seconds)};
    app_ranks_sum(sum, 3);
    s->sampled = (size_t)sum[0];
    s->wrong = (size_t)sum[1];
    s->pair_ns = s->timed > 0 ? (double)sum[2] / (double)s->timed : 0;
}

static fmb_status ask_by_pairs(bunny_study *s)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    fmb_frames *a = NULL, *b = NULL;
    o.simd = s->setup->simd;
    fmb_status st = fmb_pair_new(3, &o, NULL, &k);
    if (st == FMB_OK)
        st = fmb_frames_new(3, s->a.faces, s->a.frame, NULL, &a);
    if (st == FMB_OK)
        st = fmb_frames_new(3, s->b.faces, s->b.frame, NULL, &b);
    if (st == FMB_OK)
        st = ask_some_faces(s, k, (const fmb_frames *[2]){a, b});
    fmb_frames_free(a);
    fmb_frames_free(b);
    fmb_pair_free(k);
    return st;
}

/* ---- the report ------------------------------------------------------------------------------ */

static void add_way(json_t *ways, const char *way, double tests, double seconds, size_t faces)
{
    json_t *obj = json_object();
    app_json_set(obj, "way", json_string(way));
    app_json_set(obj, "tests", app_json_real(tests));
    app_json_set(obj, "seconds", app_json_real(seconds));
    app_json_set(obj, "ns", app_json_real(tests > 0 ? 1e9 * seconds / tests : 0));
    app_json_set(obj, "meeting_faces", faces > 0 ? qualify_count_json(faces) : json_null());
    app_json_append(ways, obj);
}

/* The faces of A that meet some face of B; or of B, some of A. */
static json_t *list_meeting_faces(const fmb_mesh_answer *answer, size_t faces, bool of_b)
{
    json_t *list = app_need(json_array());
    bool *meets = app_need(calloc(faces + 1, sizeof *meets));
    for (size_t i = 0; i < answer->hits; i++)
        meets[of_b ? answer->hit[i].b : answer->hit[i].a] = true;
    for (size_t i = 0; i < faces; i++)
        if (meets[i])
            app_json_append(list, qualify_count_json(i));
    free(meets);
    return list;
}

/* The faces for the picture, one corner a line; the meeting ones are in the JSON object. */
static void put_faces(FILE *f, const void *of)
{
    const bunny_body *b = of;
    fputs("x,y,z\n", f);
    for (size_t i = 0; i < 3 * b->faces; i++) {
        const double *at = b->number + 12 * (i / 3), *edge = at + 3 * (i % 3);
        double on = i % 3 > 0;
        fprintf(f, "%.6g,%.6g,%.6g\n", at[0] + on * edge[0], at[1] + on * edge[1],
                at[2] + on * edge[2]);
    }
}

static const qualify_column WAYS[] = {{"way", "way", NULL},
                                      {"tests", "pairs tested", "%.0f"},
                                      {"ns", "a pair [ns]", "%.1f"},
                                      {"seconds", "all [s]", "%.3f"},
                                      {"meeting_faces", "faces of A that meet", "%.0f"},
                                      {0}};

static int conclude_bunny(bunny_study *s, qualify_page *page)
{
    json_t *obj = qualify_page_json(page), *ways = app_need(json_array());
    json_t *faces = list_meeting_faces(&s->answer, s->a.faces, false);
    double all = (double)s->a.faces * (double)s->b.faces;
    add_way(ways, "trees of boxes", (double)s->answer.tested, s->meet_seconds,
            json_array_size(faces));
    add_way(ways, "all pairs, concluded from the sample", all, 1e-9 * s->pair_ns * all, 0);
    app_json_set(obj, "ways", ways);
    app_json_set(obj, "faces", qualify_count_json(s->a.faces));
    app_json_set(obj, "hits", qualify_count_json(s->answer.hits));
    app_json_set(obj, "sampled", qualify_count_json(s->sampled));
    app_json_set(obj, "wrong", qualify_count_json(s->wrong));
    app_json_set(obj, "faces_of_A_that_meet", faces);
    app_json_set(obj, "faces_of_B_that_meet", list_meeting_faces(&s->answer, s->b.faces, true));
    qualify_page_file(page, "mesh.csv", put_faces, &s->a);
    qualify_page_table(page, "ways",
                       "Which of the faces, each a unit thick, meet the mirror image? Time of one "
                       "thread, without that of reading and of making frames and trees",
                       WAYS, "ways");
    qualify_page_text(page,
                      "%zu faces; %zu pairs of faces meet. Frames, their corners and both trees "
                      "take %.3f s. Of the sample, %zu pairs, %zu verdicts differ from those by "
                      "trees.",
                      s->a.faces, s->answer.hits, s->tree_seconds, s->sampled, s->wrong);
    return s->wrong > 0 ? app_error(APP_NO, "%zu verdicts differ", s->wrong) : APP_YES;
}

static int run_bunny(const qualify_setup *o, qualify_page *page)
{
    bunny_study s = {.setup = o, .answer = {.size = sizeof s.answer}};
    fmb_mesh *m = NULL;
    int code = bunny_read(o->file, &m);
    if (code != APP_YES)
        return code;
    qualify_watch_part(0, 2);
    fmb_status st = ask_by_trees(&s, m);
    if (st == FMB_OK && !qualify_watch_interrupted())
        st = ask_by_pairs(&s);
    if (st == FMB_OK)
        collect_sums(&s);
    if (st != FMB_OK)
        code = app_status_error(st);
    else if (app_rank() == 0 && !qualify_watch_interrupted())
        code = conclude_bunny(&s, page);
    fmb_mesh_answer_clear(&s.answer);
    bunny_body_clear(&s.a);
    bunny_body_clear(&s.b);
    fmb_mesh_free(m);
    return code;
}

const qualify_study qualify_study_bunny = {
    .name = "bunny",
    .title = "a scan against its mirror image: by trees, and by all pairs",
    .doc =
        "Which faces of a mesh, each a unit thick, meet the mesh mirrored and moved? By trees of "
        "boxes; and by all pairs, of which --pairs are asked, and compared. FILE is the mesh, in "
        "metres, such as the Stanford Bunny that the article has (coordinates times 1000; the "
        "mirror image of (x, y, z) is (50 - x, y - 10, z)). Without FILE it is a bumpy ball.",
    .takes_file = true,
    .shared = true,
    .alone = {10000000, 1},
    .brief = {1000000, 1},
    .run = run_bunny,
};
