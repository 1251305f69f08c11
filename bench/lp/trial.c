/* trial.c: see trial.h. */
#include "trial.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

#include "peers.h"
#include "study/program/random.h"
#include "table.h"

/* ---- one system ------------------------------------------------------------------------------ */

static bool listed(const char *list, const char *name)
{
    size_t n = strlen(name);
    for (const char *at = list; at && *at;) {
        size_t length = strcspn(at, ",");
        if (length == n && strncmp(at, name, n) == 0)
            return true;
        at += length + (at[length] == ',');
    }
    return false;
}

line_plan plan_of(const question *q, const setup *how)
{
    line_plan p = {.rounds = how->rounds ? how->rounds : how->quick ? 1 : q->rounds};
    p.limits = (child_limits){.seconds = how->seconds > 0 ? how->seconds : q->seconds,
                              .bytes = how->bytes,
                              .question = q->kind,
                              .later = how->quick ? q->later / 10 : q->later,
                              .options = how->options};
    const char *list = how->peers ? how->peers : q->peers;
    for (int i = 0; peers[i] && p.drivers < LINE_DRIVERS; i++)
        if (peer_way(peers[i], q->kind) && (peers[i]->ours || listed(list, peers[i]->name)))
            p.driver[p.drivers++] = peers[i];
    return p;
}

static line *append_line(lines *to)
{
    to->list = need(realloc(to->list, (to->n + 1) * sizeof *to->list));
    return &to->list[to->n++];
}

static void measure_subject(lines *to, const subject *s, subject_dress dress, const question *q,
                            const setup *how)
{
    line_plan plan = plan_of(q, how);
    line *l = append_line(to);
    line_measure(l, s, dress, &plan);
    if (!how->terse || l->fault != LINE_RIGHT)
        table_line(l, &plan);
}

bool ask_about(lines *to, const char *what, subject_dress dress, const question *q,
               const setup *how)
{
    subject s;
    if (!subject_open(&s, what, dress, how->seed))
        return false;
    measure_subject(to, &s, dress, q, how);
    subject_close(&s);
    return true;
}

/* ---- trials ---------------------------------------------------------------------------------- */

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* The paths of cases/FOLDER/NAME.ine or .mps, sorted, owned; their number. */
static size_t case_paths(const setup *how, const char *name, char ***out)
{
    char folder[1024];
    snprintf(folder, sizeof folder, "%s/%s", how->cases, name);
    DIR *dir = opendir(folder);
    size_t n = 0;
    *out = NULL;
    for (struct dirent *d; dir && (d = readdir(dir));) {
        const char *dot = strrchr(d->d_name, '.');
        if (!dot || (strcmp(dot, ".ine") != 0 && strcmp(dot, ".mps") != 0))
            continue;
        size_t size = strlen(folder) + strlen(d->d_name) + 2;
        *out = need(realloc(*out, (n + 1) * sizeof **out));
        (*out)[n] = need(malloc(size));
        snprintf((*out)[n++], size, "%s/%s", folder, d->d_name);
    }
    if (dir)
        closedir(dir);
    if (n > 0)
        qsort(*out, n, sizeof **out, by_name);
    return n;
}

/* Measure all files of the folder, changed by this dress. */
static bool ask_cases(lines *to, const char *folder, subject_dress dress, const question *q,
                      const setup *how)
{
    char **path;
    size_t n = case_paths(how, folder, &path);
    for (size_t i = 0; i < n; i++) {
        ask_about(to, path[i], dress, q, how);
        free(path[i]);
    }
    free(path);
    return n > 0;
}

static bool run_lp2(const trial *t, const setup *how, lines *to)
{
    return ask_cases(to, "lp2", DRESS_NONE, &t->question, how);
}

static bool run_lp(const trial *t, const setup *how, lines *to)
{
    return ask_cases(to, "lp", DRESS_NONE, &t->question, how);
}

/* The same systems as drawn and with fractions. */
static bool run_fractions(const trial *t, const setup *how, lines *to)
{
    return ask_cases(to, "lp2", DRESS_NONE, &t->question, how) &&
           ask_cases(to, "lp2", DRESS_FRACTIONS, &t->question, how);
}

static bool run_random(const trial *t, const setup *how, lines *to)
{
    static const char *const size[] = {"2000x100", "5000x200", "20000x300"};
    static const char *const family[] = {"sparse-origin", "sparse-point", "sparse-conflict"};
    for (int i = 0; i < (how->quick ? 1 : 3); i++)
        for (int k = 0; k < 3; k++) {
            char what[64];
            snprintf(what, sizeof what, "%s:%s", family[k], size[i]);
            ask_about(to, what, DRESS_NONE, &t->question, how);
        }
    return true;
}

/* Small random systems of every family, each unchanged and rescaled; families of a single size are
 * included. */
static bool run_scaled(const trial *t, const setup *how, lines *to)
{
    setup h = *how;
    h.terse = true;
    for (uint64_t i = 0; i < (how->quick ? 50u : 1000u); i++) {
        study_random g = {how->seed + i};
        study_program_plan plan = {.family = (int)(i % (uint64_t)study_program_families()),
                                   .variables = (int)study_random_between(&g, 4, 30),
                                   .seed = how->seed + i};
        plan.rows = plan.variables + (int)study_random_between(&g, 1, 60);
        for (int dress = DRESS_NONE; dress <= DRESS_SCALES; dress++) {
            subject s;
            subject_draw(&s, &plan, (subject_dress)dress);
            measure_subject(to, &s, (subject_dress)dress, &t->question, &h);
            subject_close(&s);
        }
    }
    return true;
}

static bool run_degenerate(const trial *t, const setup *how, lines *to)
{
    static const char *const what[] = {
        "klee-minty:20",  "beale",          "kuhn",           "cube:20",       "assignment:100",
        "assignment:196", "assignment:289", "assignment:400", "transport:128", "transport:288",
        "transport:392",  "degenerate",     "chain",          "chain-equal",   "staircase:400"};
    question q = t->question;
    for (size_t i = 0; i < sizeof what / sizeof *what; i++)
        for (int kind = PEER_DECIDE; kind < PEER_QUESTIONS; kind++) {
            q.kind = (peer_question)kind;
            if (peer_way(&peer_fmb, q.kind))
                ask_about(to, what[i], DRESS_NONE, &q, how);
        }
    return true;
}

const trial TRIALS[] = {
    {"lp2-verdict",
     "cases/lp2: has it a solution?",
     {PEER_DECIDE, "glpk,qsopt,cdd-block", 10, 5, 0.2},
     run_lp2},
    {"lp2-box", "cases/lp2: both ends of every variable", {PEER_BOX, "glpk", 10, 3, 0.2}, run_lp2},
    {"lp2-reduce", "cases/lp2: which rows stay?", {PEER_REDUCE, "", 10, 3, 0.2}, run_lp2},
    {"lp-verdict",
     "cases/lp: has it a solution? (GLPK without its presolver; see also programs.py)",
     {PEER_DECIDE, "glpk", 60, 1, 0.05},
     run_lp},
    {"lp2-optimize",
     "cases/lp2: how far does an objective go?",
     {PEER_OPTIMIZE, "glpk", 10, 3, 0.2},
     run_lp2},
    {"lp-optimize",
     "cases/lp: the best values of their objectives",
     {PEER_OPTIMIZE, "glpk", 60, 1, 0.05},
     run_lp},
    {"random",
     "8 terms a row, up to 20,000 rows of 300 variables: has it a solution?",
     {PEER_DECIDE, "glpk", 20, 3, 0.2},
     run_random},
    {"scaled",
     "1,000 systems, as they are and with rows and columns times 10^-9 ... 10^9",
     {PEER_DECIDE, "", 10, 1, 0.005},
     run_scaled},
    {"fractions",
     "cases/lp2, as they are and with numbers p/q of 10 digits",
     {PEER_DECIDE, "glpk", 10, 3, 0.2},
     run_fractions},
    {"degenerate",
     "programs on which simplex methods cycle or visit everything",
     {PEER_DECIDE, "glpk", 20, 3, 0.1},
     run_degenerate},
};
const int TRIALS_COUNT = sizeof TRIALS / sizeof *TRIALS;
