/* peers.c: others on the same static pairs in three dimensions: how fast, and how often wrong? */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/json.h"
#include "common/message.h"
#include "qualify/peers/measure.h"
#include "qualify/watch.h"

/* Driver 0 is what the others are measured by. */
static const peer_driver *const DRIVER[] = {
    &peer_fmb,     &peer_sat,
#ifdef QUALIFY_CCD
    &peer_ccd_gjk, &peer_ccd_mpr,
#endif
#ifdef QUALIFY_FCL
    &peer_fcl_ccd, &peer_fcl_own,
#endif
#ifdef QUALIFY_ODE
    &peer_ode,
#endif
    &peer_tetra,   &peer_seidel,  &peer_article,
};
enum { DRIVERS = sizeof DRIVER / sizeof *DRIVER, CELLS = 2 * PEERS_KINDS };

static const char *const CELL[CELLS] = {"CC meet",  "CC apart", "CT meet",
                                        "CT apart", "TT meet",  "TT apart"};

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

/* ns first, then, beside it, how many times driver 0's. */
static void report_times(const peers_report *r, qualify_page *page)
{
    app_table ns = {.columns = CELLS + 1, .align = "lrrrrrr"},
              ratio = {.columns = CELLS + 1, .align = "lrrrrrr"};
    json_t *cells = app_need(json_array());
    qualify_cell(&ns, "ns");
    qualify_cell(&ratio, "over FMB");
    for (int c = 0; c < CELLS; c++) {
        qualify_cell(&ns, "%s", CELL[c]);
        qualify_cell(&ratio, "%s", CELL[c]);
    }
    for (int i = 0; i < DRIVERS; i++) {
        qualify_cell(&ns, "%s", DRIVER[i]->name);
        qualify_cell(&ratio, "%s", DRIVER[i]->name);
        for (int c = 0; c < CELLS; c++) {
            const peers_times *t = &r->times[c];
            double time = t->complete ? t->ns[i].median : NAN,
                   times = t->complete ? t->ratio[i].median : NAN;
            json_t *obj = json_object();
            qualify_number_cell(&ns, "%.1f", time);
            qualify_number_cell(&ratio, "%.2f", times);
            app_json_set(obj, "peer", json_string(DRIVER[i]->name));
            app_json_set(obj, "cell", json_string(CELL[c]));
            app_json_set(obj, "queries", json_integer((json_int_t)t->pairs));
            app_json_set(obj, "ns", app_json_real(time));
            app_json_set(obj, "over_fmb", app_json_real(times));
            app_json_append(cells, obj);
        }
    }
    qualify_page_table(page, "ns",
                       "Time of a query on the article's pairs [ns]: shapes are prepared outside "
                       "the clock",
                       &ns);
    qualify_page_table(page, "ratio", "The same over that of FMB, pass by pass", &ratio);
    app_json_set(qualify_page_json(page), "times", cells);
}

static void draw_times(const peers_report *r, qualify_page *page)
{
    qualify_figure f;
    qualify_figure_begin(&f);
    fputs("peer", f.data);
    for (int c = 0; c < CELLS; c++)
        fprintf(f.data, " \"%s\"", CELL[c]);
    for (int i = 0; i < DRIVERS; i++) {
        fprintf(f.data, "\n\"%s\"", DRIVER[i]->name);
        for (int c = 0; c < CELLS; c++)
            if (r->times[c].complete && isfinite(r->times[c].ns[i].median))
                fprintf(f.data, " %.6g", r->times[c].ns[i].median);
            else
                fputs(" -", f.data);
    }
    fputc('\n', f.data);
    fprintf(f.script,
            "set style data histogram\nset style histogram clustered gap 1\n"
            "set style fill solid 0.8\nset logscale y\nset yrange [5:]\nset grid ytics\n"
            "set key left top\nset xtics rotate by -20\nset ylabel 'time of a query [ns]'\n"
            "plot for [i=2:%d] data using i:xtic(1) title columnheader(i)\n",
            CELLS + 1);
    qualify_page_figure(page, "ns", "Time of a query on static pairs in three dimensions", &f);
}

/* ---- right or wrong -------------------------------------------------------------------------- */

static json_t *faults_json(const peers_faults *f, int i, const char *family)
{
    json_t *obj = json_object();
    app_json_set(obj, "peer", json_string(DRIVER[i]->name));
    app_json_set(obj, "family", json_string(family));
    app_json_set(obj, "queries", json_integer((json_int_t)f->clear[i]));
    app_json_set(obj, "false_meet", json_integer((json_int_t)f->false_meet[i]));
    app_json_set(obj, "false_apart", json_integer((json_int_t)f->false_apart[i]));
    app_json_set(obj, "unknown", json_integer((json_int_t)f->unknown[i]));
    app_json_set(obj, "touching", json_integer((json_int_t)f->touching[i]));
    app_json_set(obj, "touching_meet", json_integer((json_int_t)f->touching_meet[i]));
    return obj;
}

static void report_faults(const peers_report *r, qualify_page *page)
{
    app_table t = {.columns = 1 + PEERS_FAMILIES + 1, .align = "lrrrrr"};
    json_t *cells = app_need(json_array());
    qualify_cell(&t, "wrong");
    for (int k = 0; k < PEERS_FAMILIES; k++)
        qualify_cell(&t, "%s", study_pair_family_text(peers_family[k]));
    qualify_cell(&t, "touching");
    for (int i = 0; i < DRIVERS; i++) {
        size_t touching = 0, meet = 0;
        qualify_cell(&t, "%s", DRIVER[i]->name);
        for (int k = 0; k < PEERS_FAMILIES; k++) {
            const peers_faults *f = &r->faults[k];
            touching += f->touching[i];
            meet += f->touching_meet[i];
            if (!f->complete)
                qualify_cell(&t, "-");
            else if (f->unknown[i] > 0)
                qualify_cell(&t, "%zu+%zu-%zu?/%zu", f->false_meet[i], f->false_apart[i],
                             f->unknown[i], f->clear[i]);
            else
                qualify_cell(&t, "%zu+%zu-/%zu", f->false_meet[i], f->false_apart[i], f->clear[i]);
            app_json_append(cells, faults_json(f, i, study_pair_family_text(peers_family[k])));
        }
        qualify_cell(&t, "%zu/%zu", meet, touching);
    }
    qualify_page_table(page, "wrong",
                       "Wrong answers by family: + said to meet, - said to be apart, ? given up, "
                       "of so many that do not touch; and of those that touch, said to meet",
                       &t);
    qualify_page_text(page,
                      "Truth is exact. A pair touches if it meets with its faces and not without "
                      "them; either answer passes there. Pairs without a volume were not asked.");
    app_json_set(qualify_page_json(page), "faults", cells);
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

static int measure_all(peers_report *r, const qualify_setup *o)
{
    int code = APP_YES;
    size_t part = 0;
    for (int c = 0; code == APP_YES && c < CELLS && !qualify_watch_interrupted(); c++) {
        qualify_watch_part(part++, CELLS + PEERS_FAMILIES);
        code = peers_time(DRIVER, DRIVERS, c / 2, c % 2 == 0, o, &r->times[c]);
    }
    for (int k = 0; code == APP_YES && k < PEERS_FAMILIES && !qualify_watch_interrupted(); k++) {
        qualify_watch_part(part++, CELLS + PEERS_FAMILIES);
        code = peers_judge(DRIVER, DRIVERS, peers_family[k], o, &r->faults[k]);
    }
    return code;
}

static int run_study(const qualify_setup *o, qualify_page *page)
{
    peers_report *r = app_need(calloc(1, sizeof *r));
    introduce(page);
    int code = measure_all(r, o);
    report_times(r, page);
    draw_times(r, page);
    report_faults(r, page);
    size_t wrong = our_faults(r);
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
    .alone = {65536, 3},
    .brief = {8192, 3},
    .run = run_study,
};
