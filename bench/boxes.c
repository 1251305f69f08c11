/* boxes.c: what tightest boxes cost in four and more dimensions, and what `fmb intersect` does.
 *
 * Boxes: pairs of the article's generator that meet, still and moving, of any shapes; this thread's
 * CPU time, the median of several seeds. With --command PATH that program reads pairs of each
 * family of fmb-validate, and article's of which half meet, as lines of JSON, and answers as it
 * does by default: outward boxes, exact times and a witness; user and system time of the whole
 * process. See README.md.
 *
 * usage: bench-boxes [--seed S] [--command PATH]
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <fmb/pair.h>

#include "cells.h"
#include "machine.h"
#include "study/draw/pairs.h"

enum { LEAST_DIM = 4, MOST_DIM = 6, SEEDS = 5, PAIRS = 1000, LINES = 2000 };

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median_of_seeds(double x[SEEDS])
{
    qsort(x, SEEDS, sizeof *x, compare_numbers);
    return x[SEEDS / 2];
}

static study_pair_plan plan_of(study_pair_family family, int dim, bool moves)
{
    return (study_pair_plan){.family = family,
                             .dim = dim,
                             .moves = moves,
                             .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
}

/* ---- tightest boxes -------------------------------------------------------------------------- */

static double thread_microseconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

static bool meets(void *self, const fmb_frame *p, const fmb_frame *q)
{
    fmb_verdict is;
    must(fmb_pair_test(self, 1, p, q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &is}));
    return is == FMB_FEASIBLE;
}

/* The time of a pair, with all that a box is asked for. */
static double measure_boxes(const study_pair_plan *plan, uint64_t seed)
{
    static fmb_verdict verdict[PAIRS];
    static double world[PAIRS][2 * MOST_DIM], inside[PAIRS][2 * MOST_DIM], time[PAIRS][2],
        witness[PAIRS][MOST_DIM];
    fmb_pair_options o = {.size = sizeof o, .tightest = true};
    fmb_pair_answers out = {.size = sizeof out,
                            .verdict = verdict,
                            .world = world[0],
                            .inside = inside[0],
                            .time = time[0],
                            .witness = witness[0]};
    fmb_pair *k = NULL;
    study_pairs pairs;
    must(fmb_pair_new(plan->dim, &o, NULL, &k));
    must(study_pairs_make(plan, seed, PAIRS, meets, k, &pairs));
    const double begin = thread_microseconds();
    must(fmb_pair_test(k, PAIRS, pairs.p, pairs.q, &out));
    const double took = (thread_microseconds() - begin) / PAIRS;
    study_pairs_free(&pairs);
    fmb_pair_free(k);
    return took;
}

static void print_boxes(uint64_t seed)
{
    printf("tightest boxes of pairs that meet, times and witness [us a pair]\n%-10s %9s %9s\n", "",
           "still", "moving");
    for (int dim = LEAST_DIM; dim <= MOST_DIM; dim++) {
        printf("%dD        ", dim);
        for (int moves = 0; moves < 2; moves++) {
            const study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, dim, moves);
            double us[SEEDS];
            for (uint64_t i = 0; i < SEEDS; i++)
                us[i] = measure_boxes(&plan, seed + i);
            printf(" %9.1f", median_of_seeds(us));
        }
        printf("\n");
    }
}

/* ---- the command ----------------------------------------------------------------------------- */

static void write_vector(FILE *to, const double *x, int n)
{
    for (int j = 0; j < n; j++)
        fprintf(to, "%s%.17g", j ? "," : "[", x[j]);
    fputc(']', to);
}

static void write_frame(FILE *to, const fmb_frame *f)
{
    fprintf(to, "{\"type\":\"%s\",\"orig\":", f->shape == FMB_CUBOID ? "cuboid" : "tetrahedron");
    write_vector(to, f->origin, f->dim);
    for (int k = 0; k < f->naxes; k++) {
        fputs(k ? "," : ",\"comp\":[", to);
        write_vector(to, f->axes + k * f->dim, f->dim);
    }
    fputs("]}", to);
}

/* Pairs as drawn, or, given k, every other one of which meets. */
static void write_pairs(const study_pair_plan *plan, uint64_t seed, fmb_pair *k, const char *path)
{
    FILE *to = fopen(path, "w");
    study_pair pair;
    if (!to)
        must(FMB_ERR_IO);
    for (uint64_t i = 0, lines = 0; lines < LINES; i++) {
        study_pair_draw(plan, seed, i, &pair);
        if (k && meets(k, &pair.p, &pair.q) != (lines % 2 == 1))
            continue;
        lines++;
        fputs("{\"A\":", to);
        write_frame(to, &pair.p);
        fputs(",\"B\":", to);
        write_frame(to, &pair.q);
        fputs("}\n", to);
    }
    fclose(to);
}

/* User and system time of one run [us], by a child that waits for it. */
static double time_command(const char *command, const char *path)
{
    int end[2];
    struct rusage used = {0};
    fflush(stdout);
    if (pipe(end) != 0)
        must(FMB_ERR_IO);
    if (fork() == 0) {
        pid_t child = fork();
        if (child == 0) {
            if (!freopen("/dev/null", "w", stdout))
                _exit(74);
            execl(command, command, "intersect", path, (char *)NULL);
            _exit(127);
        }
        int status = 0;
        waitpid(child, &status, 0);
        getrusage(RUSAGE_CHILDREN, &used);
        double took = WIFEXITED(status) && WEXITSTATUS(status) != 127
                          ? 1e6 * (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                                (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec)
                          : -1;
        _exit(write(end[1], &took, sizeof took) != (ssize_t)sizeof took);
    }
    double took = -1;
    if (read(end[0], &took, sizeof took) != (ssize_t)sizeof took || took < 0) {
        fprintf(stderr, "bench-boxes: %s cannot be run\n", command);
        exit(66);
    }
    wait(NULL);
    close(end[0]);
    close(end[1]);
    return took;
}

/* half: half of the pairs meet, else they are as drawn. */
static void print_row(const char *command, const char *path, const char *what, uint64_t seed,
                      study_pair_family family, bool half)
{
    printf("%-10s", what);
    for (int dim = 4; dim <= 5; dim++) {
        const study_pair_plan plan = plan_of(family, dim, false);
        fmb_pair *k = NULL;
        double us[SEEDS];
        if (half)
            must(fmb_pair_new(dim, NULL, NULL, &k));
        for (uint64_t i = 0; i < SEEDS; i++) {
            write_pairs(&plan, seed + i, k, path);
            us[i] = time_command(command, path) / LINES;
        }
        fmb_pair_free(k);
        printf(" %9.1f", median_of_seeds(us));
    }
    printf("\n");
}

static void print_command(const char *command, uint64_t seed)
{
    char path[] = "/tmp/bench-boxes-XXXXXX";
    int file = mkstemp(path);
    if (file < 0)
        must(FMB_ERR_IO);
    close(file);
    printf("%s intersect, of %d pairs [us a pair]\n%-10s %9s %9s\n", command, LINES, "family", "4D",
           "5D");
    print_row(command, path, "half meet", seed, STUDY_PAIR_ARTICLE, true);
    for (int f = 0; f < STUDY_PAIR_FAMILIES; f++)
        print_row(command, path, study_pair_family_text((study_pair_family)f), seed,
                  (study_pair_family)f, false);
    unlink(path);
}

int main(int argc, char **argv)
{
    const char *command = NULL;
    uint64_t seed = 1;
    for (int i = 1; i < argc; i += 2)
        if (i + 1 < argc && strcmp(argv[i], "--seed") == 0) {
            seed = strtoull(argv[i + 1], NULL, 10);
        } else if (i + 1 < argc && strcmp(argv[i], "--command") == 0) {
            command = argv[i + 1];
        } else {
            fprintf(stderr, "usage: bench-boxes [--seed S] [--command PATH]\n");
            return 64;
        }
    setvbuf(stdout, NULL, _IOLBF, 0);
    printf("{");
    print_machine_json(stdout);
    printf("}\n");
    print_boxes(seed);
    if (command)
        print_command(command, seed);
    return 0;
}
