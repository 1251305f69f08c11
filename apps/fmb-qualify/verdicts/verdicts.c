/* verdicts.c: see verdicts.h; and the studies that use it. */
#include "fmb-qualify/verdicts/verdicts.h"

#include <math.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/bunny/bunny.h"
#include "fmb-qualify/share.h"
#include "fmb-qualify/verdicts/cells.h"

static const struct {
    int dim;
    bool moves;
} CASE[VERDICT_CASES] = {{2, false}, {3, false}, {2, true}, {3, true}};

/* ---- the run --------------------------------------------------------------------------------- */

enum { UNITS_OF_A_CASE = 2 * VERDICT_ANY + 1 }; /* its duels, and the mix */

/* One of both. */
typedef struct verdict_unit {
    verdict_duel duel;
    verdict_mix mix;
} verdict_unit;

static fmb_status run_unit(const verdict_source *from, int number, int i, const qualify_setup *o,
                           verdict_unit *unit)
{
    const int dim = CASE[number].dim;
    const bool moves = CASE[number].moves;
    verdict_class c = {dim, moves, i % 2 == 0, (verdict_kind)(i / 2)};
    verdict_rivals r;
    fmb_status st = verdict_rivals_open(&r, dim, o->simd);
    unit->mix = (verdict_mix){.dim = dim, .moves = moves};
    if (st == FMB_OK)
        st = c.kind == VERDICT_ANY ? verdict_mix_run(from, o, &r, &unit->mix)
                                   : verdict_duel_run(from, &c, o, &r, &unit->duel);
    verdict_rivals_close(&r);
    return st;
}

static void keep_complete_units(const verdict_unit *unit, size_t units, verdict_study *s)
{
    for (size_t i = 0; i < units; i++) {
        if (unit[i].duel.complete)
            s->duel[s->duels++] = unit[i].duel;
        if (unit[i].mix.complete)
            s->mix[s->mixes++] = unit[i].mix;
    }
}

static size_t count_wrong(const verdict_study *s)
{
    size_t wrong = 0;
    for (size_t i = 0; i < s->duels; i++)
        wrong += s->duel[i].wrong;
    return wrong;
}

static int report(const verdict_study *s, qualify_page *page)
{
    verdict_numbers(s, page);
    verdict_tables(s, page);
    size_t wrong = count_wrong(s);
    return wrong > 0 ? app_error(APP_NO, "%zu verdicts differ", wrong) : APP_YES;
}

int verdict_study_run(const verdict_source *from, const bool is_case[VERDICT_CASES],
                      const qualify_setup *o, qualify_page *page)
{
    verdict_study *s = app_need(calloc(1, sizeof *s));
    verdict_unit unit[VERDICT_CASES * UNITS_OF_A_CASE] = {0};
    int number[VERDICT_CASES], cases = 0, code = APP_YES;
    fmb_status st = FMB_OK;
    for (int i = 0; i < VERDICT_CASES; i++)
        if (is_case[i])
            number[cases++] = i;
    qualify_share share = qualify_share_begin(o, (size_t)cases * UNITS_OF_A_CASE);
    for (size_t i; st == FMB_OK && qualify_share_next(&share, &i);)
        st = run_unit(from, number[i / UNITS_OF_A_CASE], (int)(i % UNITS_OF_A_CASE), o, &unit[i]);
    if (st == FMB_OK)
        qualify_share_collect(&share, unit, sizeof *unit);
    keep_complete_units(unit, share.cells, s);
    bool reports = qualify_share_end(&share);
    code = st != FMB_OK ? app_status_error(st) : reports ? report(s, page) : APP_YES;
    free(s);
    return code;
}

/* ---- the studies ----------------------------------------------------------------------------- */

static const bool ALL_CASES[VERDICT_CASES] = {true, true, true, true};
static const bool STATIC_3D[VERDICT_CASES] = {[1] = true};
static const bool ALL_3D[VERDICT_CASES] = {[1] = true, [3] = true};

static int run_table1(const qualify_setup *o, qualify_page *page)
{
    qualify_page_text(page,
                      "Pairs of the article's generator: origins, axes and speeds evenly from -100 "
                      "to 100, |det| > 0.1. C is a cuboid, T a simplex; CT holds both orders.");
    return verdict_study_run(&(verdict_source){0}, ALL_CASES, o, page);
}

static int run_near(const qualify_setup *o, qualify_page *page)
{
    qualify_page_text(page,
                      "Pairs as in table1, but only those whose axis-aligned boxes meet: what "
                      "a broad phase leaves to be asked. Boxes of moving frames hold all "
                      "places where these come.");
    return verdict_study_run(&(verdict_source){.near = true}, ALL_CASES, o, page);
}

static int run_touching(const qualify_setup *o, qualify_page *page)
{
    qualify_page_text(page, "Pairs that are made to touch in a face, an edge or a corner; of those "
                            "that are apart, 1e-6 to 1e-15 are between. Meeting ones are closed "
                            "frames, and most of them do no more than touch.");
    return verdict_study_run(&(verdict_source){.family = {STUDY_PAIR_NEAR, STUDY_PAIR_TOUCHING}},
                             ALL_CASES, o, page);
}

/* One axis keeps its length, the others become a fiftieth; origins move closer. */
static void make_slender(const void *self, int dim, const verdict_draft f[2])
{
    (void)self;
    for (int i = 0; i < 2; i++) {
        for (int k = dim; k < dim * dim; k++)
            f[i].axes[k] *= 0.02;
        for (int j = 0; j < dim; j++)
            f[i].origin[j] *= 0.05;
    }
}

static int run_slender(const qualify_setup *o, qualify_page *page)
{
    qualify_page_text(page, "Rods and blades: of the generator's frames one axis keeps its length, "
                            "the others a fiftieth of it; origins are twenty times as near.");
    return verdict_study_run(&(verdict_source){.reshape = make_slender}, ALL_CASES, o, page);
}

static void make_faces(const void *self, int dim, const verdict_draft f[2])
{
    (void)self;
    (void)dim;
    for (int i = 0; i < 2; i++)
        verdict_make_thick(f[i].axes, 1);
}

static int run_faces(const qualify_setup *o, qualify_page *page)
{
    qualify_page_text(page, "The article's faces in 3D: parallelograms and triangles of the "
                            "generator's first two axes, one unit thick: their third axis is the "
                            "unit normal.");
    return verdict_study_run(&(verdict_source){.reshape = make_faces}, STATIC_3D, o, page);
}

static int time_cells(const verdict_cells *cells, const qualify_setup *o, qualify_page *page)
{
    qualify_page_text(page,
                      "Neighbouring and near cells of a mesh of %zu triangles with an area: C is "
                      "the parallelogram of two edges, T the triangle, each as thick as edges are "
                      "long on average, %.3g; those that move go up to four times as far.",
                      cells->n, cells->edge);
    return verdict_study_run(&(verdict_source){.reshape = verdict_cells_put, .self = cells}, ALL_3D,
                             o, page);
}

static int run_mesh(const qualify_setup *o, qualify_page *page)
{
    fmb_mesh *m = NULL;
    verdict_cells cells = {0};
    int code = bunny_read(o->file, &m);
    if (code != APP_YES)
        return code;
    fmb_status st = verdict_cells_open(m, &cells);
    fmb_mesh_free(m);
    if (st != FMB_OK)
        code = app_status_error(st);
    else if (cells.n < 2)
        code = app_error(APP_BAD_INPUT, "expected at least two triangles with an area");
    else
        code = time_cells(&cells, o, page);
    verdict_cells_close(&cells);
    return code;
}

static const char doc[] =
    "Time verdicts by FMB, by SAT, and by SAT as the article has it, on distinct random pairs, all "
    "in one run; and on one pair repeated, as the article does.";

const qualify_study qualify_study_table1 = {
    .name = "table1",
    .title = "verdicts by FMB and by SAT, the article's 24 cells",
    .doc = doc,
    .shared = true,
    .alone = {65536, 9},
    .brief = {65536, 5},
    .run = run_table1,
};

const qualify_study qualify_study_near = {
    .name = "near",
    .title = "verdicts on pairs whose axis-aligned boxes meet",
    .doc = doc,
    .shared = true,
    .alone = {65536, 9},
    .brief = {65536, 3},
    .run = run_near,
};

const qualify_study qualify_study_touching = {
    .name = "touching",
    .title = "verdicts on pairs that touch, and on those that nearly do",
    .doc = doc,
    .shared = true,
    .alone = {16384, 5},
    .brief = {4096, 3},
    .run = run_touching,
};

const qualify_study qualify_study_slender = {
    .name = "slender",
    .title = "verdicts on rods and blades",
    .doc = doc,
    .shared = true,
    .alone = {65536, 9},
    .brief = {16384, 3},
    .run = run_slender,
};

const qualify_study qualify_study_mesh = {
    .name = "mesh",
    .title = "verdicts on neighbouring and near cells of a mesh",
    .doc = "Time verdicts by FMB, by SAT, and by SAT as the article has it, on neighbouring and "
           "near triangles of a mesh, as thick as their edges are long. FILE is the mesh; without "
           "it, it is a bumpy ball.",
    .takes_file = true,
    .shared = true,
    .alone = {16384, 5},
    .brief = {4096, 3},
    .run = run_mesh,
};

const qualify_study qualify_study_faces = {
    .name = "faces",
    .title = "verdicts on faces with their unit normals",
    .doc = doc,
    .shared = true,
    .alone = {65536, 9},
    .brief = {65536, 5},
    .run = run_faces,
};
