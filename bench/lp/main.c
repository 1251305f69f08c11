/* main.c: linear programs, fmb beside GLPK, QSopt_ex and cddlib. See ../README.md. */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "peers.h"
#include "table.h"

static const char USAGE[] =
    "usage: bench-lp [OPTION...] FILE|FAMILY[:SIZE]...    ask about these\n"
    "       bench-lp [OPTION...] --bars[=TRIAL,...]       all trials, or these; exit 1 if a bar "
    "is\n"
    "                                                     broken\n"
    "  --question Q,...   verdict, box, reduce, optimize (default verdict)\n"
    "  --peers P,...      beside these drivers (default glpk,qsopt,cdd-block; none)\n"
    "  --dress D          scales (rows and columns times 10^-9 ... 10^9), fractions (10 digits)\n"
    "  --families         every family in its usual size\n"
    "  --seed N           of what is drawn (default: the time)\n"
    "  --seconds S        CPU time of one answer (default 10)\n"
    "  --bytes B          address space of a run, default 8 GiB; 0: no limit (for sanitizers)\n"
    "  --rounds N         of each driver (default 3)\n"
    "  --quick            less of everything\n"
    "  --cases DIR        the collected cases (default ../shared/cases)\n"
    "  --set NAME=VALUE   an option of fmb\n"
    "  --json FILE        everything as JSON\n"
    "  --print            write the systems as .ine instead\n"
    "  --list             families and trials\n";

enum { PARTS = 16, SYSTEMS = 4096 };

typedef struct run {
    setup how;
    fmb_options options;
    bool asked[PEER_QUESTIONS];
    const char *json, *bars; /* bars: a list, "" for all; NULL: none */
    const char *what[SYSTEMS];
    int systems;
    bool families, print, list;
    subject_dress dress;
    table_part part[PARTS];
    int parts;
} run;

/* ---- arguments ------------------------------------------------------------------------------- */

/* Is the word one of the comma list? */
static bool is_listed(const char *list, const char *word)
{
    size_t n = strlen(word);
    for (const char *at = list; *at;) {
        size_t length = strcspn(at, ",");
        if (length == n && strncmp(at, word, n) == 0)
            return true;
        at += length + (at[length] == ',');
    }
    return false;
}

/* The number of words in the comma list. */
static int words_of(const char *list)
{
    int n = *list != '\0';
    for (; *list; list++)
        n += *list == ',';
    return n;
}

static bool take_questions(run *r, const char *list)
{
    static const char *const word[] = {[PEER_DECIDE] = "verdict",
                                       [PEER_BOX] = "box",
                                       [PEER_REDUCE] = "reduce",
                                       [PEER_OPTIMIZE] = "optimize"};
    int known = 0;
    for (int q = PEER_DECIDE; q < PEER_QUESTIONS; q++)
        known += r->asked[q] = is_listed(list, word[q]) && peer_way(&peer_fmb, (peer_question)q);
    return known == words_of(list);
}

/* Do all names stand for drivers of this build? "none": no driver. */
static bool take_peers(run *r, const char *list)
{
    int known = is_listed(list, "none");
    for (int i = 0; peers[i]; i++)
        known += is_listed(list, peers[i]->name);
    r->how.peers = list;
    return known == words_of(list);
}

static bool take_bars(run *r, const char *list)
{
    int known = 0;
    for (int i = 0; i < TRIALS_COUNT; i++)
        known += is_listed(list, TRIALS[i].name);
    r->bars = list;
    return known == words_of(list);
}

static bool take_option(run *r, const char *text)
{
    const char *equal = strchr(text, '=');
    char name[64];
    if (!equal || (size_t)(equal - text) >= sizeof name)
        return false;
    snprintf(name, sizeof name, "%.*s", (int)(equal - text), text);
    return fmb_options_set(&r->options, name, equal + 1) == FMB_OK;
}

static bool take_dress(run *r, const char *word)
{
    bool scales = strcmp(word, "scales") == 0;
    r->dress = scales ? DRESS_SCALES : DRESS_FRACTIONS;
    return scales || strcmp(word, "fractions") == 0;
}

static bool take_value(run *r, const char *name, const char *value)
{
    if (strcmp(name, "--question") == 0)
        return take_questions(r, value);
    else if (strcmp(name, "--peers") == 0)
        return take_peers(r, value);
    else if (strcmp(name, "--seed") == 0)
        r->how.seed = strtoull(value, NULL, 10);
    else if (strcmp(name, "--seconds") == 0)
        return (r->how.seconds = atof(value)) > 0;
    else if (strcmp(name, "--bytes") == 0)
        r->how.bytes = (size_t)strtoull(value, NULL, 10);
    else if (strcmp(name, "--rounds") == 0)
        return (r->how.rounds = atoi(value)) > 0;
    else if (strcmp(name, "--cases") == 0)
        r->how.cases = value;
    else if (strcmp(name, "--set") == 0)
        return take_option(r, value);
    else if (strcmp(name, "--dress") == 0)
        return take_dress(r, value);
    else if (strcmp(name, "--json") == 0)
        r->json = value;
    else
        return false;
    return true;
}

static bool take_arguments(run *r, int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i];
        if (strcmp(a, "--bars") == 0)
            r->bars = "";
        else if (strncmp(a, "--bars=", 7) == 0) {
            if (!take_bars(r, a + 7))
                return false;
        } else if (strcmp(a, "--quick") == 0)
            r->how.quick = true;
        else if (strcmp(a, "--families") == 0)
            r->families = true;
        else if (strcmp(a, "--print") == 0)
            r->print = true;
        else if (strcmp(a, "--list") == 0)
            r->list = true;
        else if (a[0] == '-') {
            if (i + 1 >= argc || !take_value(r, a, argv[i + 1]))
                return false;
            i++;
        } else if (r->systems < SYSTEMS)
            r->what[r->systems++] = a;
    }
    return r->list || r->bars || r->families || r->systems > 0;
}

/* ---- running --------------------------------------------------------------------------------- */

static table_part *new_part(run *r, const char *name)
{
    table_part *p = &r->part[r->parts++];
    *p = (table_part){.name = name};
    return p;
}

/* Run a trial and judge its bars; false if a bar is missed. */
static bool run_trial(run *r, const trial *t)
{
    table_part *p = new_part(r, t->name);
    char title[160];
    bool good = true;
    p->plan = plan_of(&t->question, &r->how);
    snprintf(title, sizeof title, "%s: %s", t->name, t->about);
    table_head(title, &p->plan);
    if (!t->run(t, &r->how, &p->lines)) {
        printf("skipped: no cases at %s\n", r->how.cases);
        return true;
    }
    table_summary(&p->lines, &p->plan);
    p->bars = bars_judge(t, &p->lines, &p->plan, p->bar);
    table_bars(p->bar, p->bars);
    for (int i = 0; i < p->bars; i++)
        good &= p->bar[i].good;
    return good;
}

static bool run_trials(run *r)
{
    bool good = true;
    for (int i = 0; i < TRIALS_COUNT; i++)
        if (*r->bars == '\0' || is_listed(r->bars, TRIALS[i].name))
            good &= run_trial(r, &TRIALS[i]);
    return good;
}

/* All systems are asked one question; false if one cannot be read, or an answer is wrong. */
static bool run_question(run *r, peer_question kind)
{
    static const char *const title[] = {[PEER_DECIDE] = "verdict",
                                        [PEER_BOX] = "box",
                                        [PEER_REDUCE] = "reduce",
                                        [PEER_OPTIMIZE] = "optimize"};
    question q = {kind, "glpk,qsopt,cdd-block", 10, 3, 0.2};
    table_part *p = new_part(r, title[kind]);
    bool good = true;
    p->plan = plan_of(&q, &r->how);
    table_head(title[kind], &p->plan);
    for (int i = 0; i < r->systems; i++)
        good &= ask_about(&p->lines, r->what[i], r->dress, &q, &r->how);
    for (int f = 0; r->families && f < study_program_families(); f++)
        good &= ask_about(&p->lines, study_program_name(f), r->dress, &q, &r->how);
    table_summary(&p->lines, &p->plan);
    for (size_t i = 0; i < p->lines.n; i++)
        good &= p->lines.list[i].fault < LINE_UNPROVED;
    return good;
}

static bool print_systems(run *r)
{
    bool good = true;
    for (int i = 0; i < r->systems && good; i++) {
        subject s;
        good = subject_open(&s, r->what[i], r->dress, r->how.seed);
        if (!good)
            break;
        good = fmb_system_write(s.variant[0].system, FMB_FORMAT_INE, stdout) == FMB_OK;
        subject_close(&s);
    }
    return good;
}

static void print_lists(void)
{
    for (int f = 0; f < study_program_families(); f++)
        printf("family %-18s%s\n", study_program_name(f), study_program_about(f));
    for (int i = 0; i < TRIALS_COUNT; i++)
        printf("trial  %-18s%s\n", TRIALS[i].name, TRIALS[i].about);
}

int main(int argc, char **argv)
{
    static run r;
    bool good = true;
    r.options = (fmb_options){.size = sizeof(fmb_options)};
    r.options.evidence = FMB_EVIDENCE_NONE;
    r.how = (setup){.cases = "../shared/cases",
                    .bytes = (size_t)8 << 30,
                    .seed = (uint64_t)time(NULL),
                    .options = &r.options};
    r.asked[PEER_DECIDE] = true;
    if (!take_arguments(&r, argc, argv)) {
        fputs(USAGE, stderr);
        return 64;
    }
    if (r.list) {
        print_lists();
        return 0;
    }
    if (r.print)
        return print_systems(&r) ? 0 : 65;
    printf("seed %llu\n", (unsigned long long)r.how.seed);
    if (r.bars)
        good = run_trials(&r);
    for (int q = PEER_DECIDE; q < PEER_QUESTIONS && r.systems + r.families > 0; q++)
        if (r.asked[q])
            good &= run_question(&r, (peer_question)q);
    if (r.json && !table_json(r.json, r.part, r.parts, r.how.seed)) {
        fprintf(stderr, "%s: cannot be written\n", r.json);
        return 74;
    }
    for (int i = 0; i < r.parts; i++)
        free(r.part[i].lines.list);
    return good ? 0 : 1;
}
