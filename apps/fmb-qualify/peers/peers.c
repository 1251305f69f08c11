/* peers.c: other libraries on the same static pairs in 3D: how fast, and how often wrong? */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/peers/measure.h"
#include "fmb-qualify/share.h"

/* Times are relative to driver 0. */
static const peer_driver *const DRIVER[] = {
    &peer_fmb,     &peer_sat,
#ifdef QUALIFY_CCD
    &peer_ccd_gjk, &peer_ccd_mpr,
#endif
#ifdef QUALIFY_FCL
    &peer_fcl_ccd, &peer_fcl_own, &peer_fcl_obb, &peer_fcl_box,
#endif
#ifdef QUALIFY_ODE
    &peer_ode,     &peer_ode_box,
#endif
    &peer_tetra,   &peer_seidel,  &peer_article,
};
enum { DRIVERS = sizeof DRIVER / sizeof *DRIVER, CELLS = 2 * PEERS_KINDS };

static const char *const CELL[CELLS] = {"CC meet", "CC apart", "CT meet",    "CT apart",
                                        "TT meet", "TT apart", "boxes meet", "boxes apart"};

/* The results of a cell: times of a kind of pairs, or faults of a family. */
typedef struct peers_cell {
    peers_times times;
    peers_faults faults;
} peers_cell;

typedef struct peers_report {
    peers_times times[CELLS];
    peers_faults faults[PEERS_FAMILIES];
} peers_report;

/* [give, free()] The libraries that this program was built without, "" if none is missing. */
static char *missing(void)
{
    char *text;
    const char *ccd = "libccd, ", *fcl = "FCL, ", *ode = "ODE, ";
#ifdef QUALIFY_CCD
    ccd = "";
#endif
#ifdef QUALIFY_FCL
    fcl = "";
#endif
#ifdef QUALIFY_ODE
    ode = "";
#endif
    if (asprintf(&text, "%s%s%s", ccd, fcl, ode) < 0)
        app_need(NULL);
    if (strlen(text) >= 2)
        text[strlen(text) - 2] = '\0';
    return text;
}

/* ---- times ----------------------------------------------------------------------------------- */

static const qualify_column TIMES[] = {{"cell", "pairs", NULL},
                                       {"peer", "peer", NULL},
                                       {"queries", NULL, "%.0f"},
                                       {"ns", "ns", "%.1f"},
                                       QUALIFY_RATIO("over_fmb", "over FMB"),
                                       {"wrong", "wrong", "%.0f"},
                                       {0}};

static void report_times(const peers_report *r, qualify_page *page)
{
    json_t *cells = app_need(json_array());
    for (int c = 0; c < CELLS; c++)
        for (int i = 0; i < DRIVERS && r->times[c].complete; i++) {
            const peers_times *t = &r->times[c];
            if (isnan(t->ns[i].median))
                continue;
            json_t *obj = json_object();
            app_json_set(obj, "peer", json_string(DRIVER[i]->name));
            app_json_set(obj, "cell", json_string(CELL[c]));
            app_json_set(obj, "queries", qualify_count_json(t->pairs));
            app_json_set(obj, "ns", app_json_real(t->ns[i].median));
            app_json_set(obj, "over_fmb", qualify_ratio_json(t->ratio[i]));
            app_json_set(obj, "wrong", qualify_count_json(t->wrong[i]));
            app_json_append(cells, obj);
        }
    app_json_set(qualify_page_json(page), "times", cells);
    qualify_page_table(page, "times",
                       "Time of a query on the article's pairs [ns], median of the passes, shapes "
                       "prepared outside the clock; boxes are cuboids with right angles; over that "
                       "of FMB, and the 95 % interval",
                       TIMES, "times");
}

/* ---- right or wrong -------------------------------------------------------------------------- */

static const qualify_column FAULTS[] = {{"family", "family", NULL},
                                        {"peer", "peer", NULL},
                                        {"queries", "asked", "%.0f"},
                                        {"false_meet", "false meet", "%.0f"},
                                        {"false_apart", "false apart", "%.0f"},
                                        {"unknown", "given up", "%.0f"},
                                        {"touching", "touching", "%.0f"},
                                        {"touching_meet", "said to meet", "%.0f"},
                                        {0}};

static void report_faults(const peers_report *r, qualify_page *page)
{
    json_t *cells = app_need(json_array());
    for (int k = 0; k < PEERS_FAMILIES; k++)
        for (int i = 0; i < DRIVERS && r->faults[k].complete; i++) {
            const peers_faults *f = &r->faults[k];
            if (f->clear[i] + f->touching[i] == 0)
                continue;
            json_t *obj = json_object();
            app_json_set(obj, "peer", json_string(DRIVER[i]->name));
            app_json_set(obj, "family", json_string(study_pair_family_text(peers_family[k])));
            app_json_set(obj, "queries", qualify_count_json(f->clear[i]));
            app_json_set(obj, "false_meet", qualify_count_json(f->false_meet[i]));
            app_json_set(obj, "false_apart", qualify_count_json(f->false_apart[i]));
            app_json_set(obj, "unknown", qualify_count_json(f->unknown[i]));
            app_json_set(obj, "touching", qualify_count_json(f->touching[i]));
            app_json_set(obj, "touching_meet", qualify_count_json(f->touching_meet[i]));
            app_json_append(cells, obj);
        }
    app_json_set(qualify_page_json(page), "faults", cells);
    qualify_page_table(
        page, "faults",
        "Answers by family: of pairs that do not touch, those asked and those wrong; "
        "of pairs that touch, those said to meet",
        FAULTS, "faults");
    qualify_page_text(page,
                      "Truth is exact. A pair touches if it meets with its faces and not without "
                      "them; either answer passes there. Pairs without a volume were not asked.");
}

/* Ours must be right everywhere; closed frames that touch meet. */
static size_t our_faults(const peers_report *r)
{
    size_t wrong = 0;
    for (int k = 0; k < PEERS_FAMILIES; k++)
        for (int i = 0; i < 2; i++) {
            const peers_faults *f = &r->faults[k];
            wrong += f->false_meet[i] + f->false_apart[i] + f->unknown[i] + f->touching[i] -
                     f->touching_meet[i];
        }
    return wrong;
}

/* ---- the study ------------------------------------------------------------------------------- */

static void introduce(qualify_page *page)
{
    char *without = missing();
    json_t *peers = app_need(json_array());
    for (int i = 0; i < DRIVERS; i++) {
        qualify_page_text(page, "%s: %s.", DRIVER[i]->name, DRIVER[i]->how);
        app_json_append(peers, json_string(DRIVER[i]->name));
    }
    if (*without)
        qualify_page_text(page, "Built without %s.", without);
    app_json_set(qualify_page_json(page), "peers", peers);
    app_json_set(qualify_page_json(page), "missing", json_string(without));
    free(without);
}

static int measure_cell(size_t i, const qualify_setup *o, peers_cell *cell)
{
    if (i < CELLS)
        return peers_time(DRIVER, DRIVERS, (int)i / 2, i % 2 == 0, o, &cell->times);
    return peers_judge(DRIVER, DRIVERS, peers_family[i - CELLS], o, &cell->faults);
}

/* Runs all cells; true on the rank that reports. */
static bool measure_all(peers_report *r, const qualify_setup *o, int *code)
{
    peers_cell *cell = app_need(calloc(CELLS + PEERS_FAMILIES, sizeof *cell));
    qualify_share share = qualify_share_begin(o, CELLS + PEERS_FAMILIES);
    for (size_t i; *code == APP_YES && qualify_share_next(&share, &i);)
        *code = measure_cell(i, o, &cell[i]);
    if (*code == APP_YES)
        qualify_share_collect(&share, cell, sizeof *cell);
    for (int c = 0; c < CELLS; c++)
        r->times[c] = cell[c].times;
    for (int k = 0; k < PEERS_FAMILIES; k++)
        r->faults[k] = cell[CELLS + k].faults;
    free(cell);
    return qualify_share_end(&share);
}

static int run_study(const qualify_setup *o, qualify_page *page)
{
    peers_report *r = app_need(calloc(1, sizeof *r));
    int code = APP_YES;
    introduce(page);
    bool reports = measure_all(r, o, &code);
    if (reports) {
        report_times(r, page);
        report_faults(r, page);
    }
    size_t wrong = reports ? our_faults(r) : 0;
    if (code == APP_YES && wrong > 0)
        code = app_error(APP_NO, "%zu wrong answers of this library", wrong);
    free(r);
    return code;
}

const qualify_study qualify_study_peers = {
    .name = "peers",
    .title = "other libraries on the same pairs",
    .doc = "Static pairs in three dimensions, answered by this library, by libccd, FCL and ODE "
           "where they were installed when it was built, and by algorithms from the literature: "
           "time of a query, and wrong answers by family, judged exactly.",
    .shared = true,
    .alone = {65536, 3},
    .brief = {8192, 3},
    .run = run_study,
};
