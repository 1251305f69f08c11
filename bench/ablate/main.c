/* main.c: the gain by each way of the library. See ../README.md.
 *
 * Every problem is solved twice with all ways on, and once with each way off that its first run
 * consulted. A problem counts for the ways that were consulted there.
 */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "pairs.h"
#include "subjects.h"
#include "table.h"

static const char USAGE[] =
    "usage: bench-ablate [--seed N] [--each N] [--seconds S] [--later S] [--way NAME,...]\n"
    "                    [--question WORD] [FILE...]\n"
    "Problems of all families, N seeds of each from --seed on, and the files.\n";

typedef struct setup {
    subject_plan plan;
    child_limits limits;
    fmb_options options;
    const char *only;     /* these ways, with commas between them */
    const char *question; /* one question */
    table table;
    unsigned problems, wrong;
} setup;

/* Our driver for this question about this problem. */
static const peer *peer_with(const problem *p, peer_question question)
{
    for (int i = 0; !p->own && peers[i]; i++)
        if (peers[i]->ours && (peer_maker(peers[i], question) || peer_way(peers[i], question)))
            return peers[i];
    return &peer_pairs;
}

static child_outcome ask(setup *s, const problem *variants, int way)
{
    memset(fmb_ways_at_hand, 0, sizeof *fmb_ways_at_hand);
    if (way >= 0)
        fmb_ways_at_hand->off[way] = true;
    return child_run(peer_with(variants, s->limits.question), variants, &s->limits);
}

/* Are both answers equal, unless one is missing? */
static bool agree(const child_outcome *a, const child_outcome *b)
{
    if (a->end != CHILD_DONE || b->end != CHILD_DONE)
        return true;
    if (a->text && b->text)
        return strcmp(a->text, b->text) == 0;
    return a->verdict == b->verdict && a->numbers == b->numbers &&
           (a->numbers == 0 || memcmp(a->number, b->number, a->numbers * sizeof *a->number) == 0);
}

static table_cell cell_of(const child_outcome *with, const child_outcome *without)
{
    return (table_cell){.with = with->typical,
                        .without = without->end == CHILD_DONE ? without->typical : without->limit,
                        .unfinished = without->end != CHILD_DONE,
                        .peak_with = (double)with->peak,
                        .peak_without = (double)without->peak};
}

static bool is_wanted(const setup *s, int way)
{
    const char *name = table_way_name(way);
    size_t n = strlen(name);
    for (const char *at = s->only; at; at = strchr(at, ',')) {
        at += *at == ',';
        if (strncmp(at, name, n) == 0 && (at[n] == ',' || at[n] == '\0'))
            return true;
    }
    return !s->only;
}

static void try_without(setup *s, const problem *variants, const child_outcome *with, int way,
                        const fmb_ways *counts)
{
    child_outcome without = ask(s, variants, way);
    table_cell cell = cell_of(with, &without);
    cell.asked = counts->asked[way];
    cell.answered = counts->answered[way];
    if (!agree(with, &without)) {
        fprintf(stderr, "%s: another answer without %s\n", variants->name, table_way_name(way));
        s->wrong++;
    }
    table_add(&s->table, way, variants->name, &cell);
    child_outcome_clear(&without);
}

static void ask_with_and_without(void *self, problem *p, peer_question question)
{
    setup *s = self;
    problem variants[CHILD_VARIANTS];
    if (s->question && strcmp(s->question, subject_word(p, question)) != 0) {
        problem_clear(p);
        return;
    }
    int count = p->own || p->m * (size_t)(p->n + 1) > 20000 ? 1 : 4;
    for (int v = 0; v < count; v++)
        problem_variant(&variants[v], p, (unsigned)v);
    s->limits.question = question;
    s->limits.variants = count;
    child_outcome with = ask(s, variants, -1);
    fmb_ways counts = *fmb_ways_at_hand;
    s->problems++;
    if (with.end == CHILD_DONE) {
        child_outcome again = ask(s, variants, -1);
        table_cell noise = cell_of(&with, &again);
        noise.asked = noise.answered = 1;
        table_add(&s->table, FMB_WAY_COUNT, p->name, &noise);
        child_outcome_clear(&again);
        for (int way = 0; way < FMB_WAY_COUNT; way++)
            if (counts.asked[way] > 0 && is_wanted(s, way))
                try_without(s, variants, &with, way, &counts);
    } else {
        fprintf(stderr, "%s: %s\n", p->name,
                with.end == CHILD_CRASHED ? "crashed" : "not finished with all ways");
        s->wrong += with.end == CHILD_CRASHED;
    }
    child_outcome_clear(&with);
    for (int v = 0; v < count; v++)
        problem_clear(&variants[v]);
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%u problems, last %-40s", s->problems, p->name);
    problem_clear(p);
}

static bool take_arguments(setup *s, int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i];
        if (a[0] != '-') {
            s->plan.file = argv + i;
            s->plan.files = (size_t)(argc - i);
            return true;
        }
        if (++i >= argc)
            return false;
        if (strcmp(a, "--seed") == 0)
            s->plan.seed = strtoull(argv[i], NULL, 10);
        else if (strcmp(a, "--each") == 0)
            s->plan.each = strtoull(argv[i], NULL, 10);
        else if (strcmp(a, "--seconds") == 0)
            s->limits.seconds = atof(argv[i]);
        else if (strcmp(a, "--later") == 0)
            s->limits.later = atof(argv[i]);
        else if (strcmp(a, "--way") == 0)
            s->only = argv[i];
        else if (strcmp(a, "--question") == 0)
            s->question = argv[i];
        else
            return false;
    }
    return true;
}

/* Put the switches and counts into memory shared with child processes. */
static bool share_switches(void)
{
    void *shared = mmap(NULL, sizeof *fmb_ways_at_hand, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED)
        return false;
    fmb_ways_at_hand = shared;
    return true;
}

int main(int argc, char **argv)
{
    setup s = {.options = {.size = sizeof s.options}, .plan = {.seed = 1, .each = 2}};
    s.options.evidence = FMB_EVIDENCE_NONE;
    s.limits = (child_limits){.seconds = 5, .bytes = (size_t)4 << 30, .later = 0.05};
    s.limits.options = &s.options;
    if (!take_arguments(&s, argc, argv)) {
        fputs(USAGE, stderr);
        return 64;
    }
    if (!share_switches()) {
        perror("bench-ablate");
        return 71;
    }
    bool good = subjects_each(&s.plan, ask_with_and_without, &s);
    fputc('\n', stderr);
    table_print(&s.table, s.problems, &s.plan);
    table_clear(&s.table);
    return !good ? 66 : s.wrong > 0 ? 1 : 0;
}
