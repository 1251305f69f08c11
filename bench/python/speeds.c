/* speeds.c: the tasks of speeds.py in C: bench-python tiny N | pairs FILE FRAMES PAIRS. Prints
 * seconds of the processor, of a second pass. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>

static void need(bool good, const char *what)
{
    if (good)
        return;
    fprintf(stderr, "bench-python: %s\n", what);
    exit(1);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- tiny systems ---------------------------------------------------------------------------- */

static fmb_system *make_tiny(size_t k)
{
    fmb_system *s = NULL;
    need(fmb_system_new(2, NULL, &s) == FMB_OK &&
             fmb_system_add_int(s, (int64_t[]){1, 1}, FMB_LE, 3 + (int64_t)(k % 7)) == FMB_OK &&
             fmb_system_add_int(s, (int64_t[]){-1, 2}, FMB_LT, -4 - (int64_t)(k % 5)) == FMB_OK,
         "no system");
    return s;
}

/* Seconds for verdict and evidence of n systems, one after the other. */
static double pass_tiny(fmb_solver *v, fmb_system *const *s, size_t n)
{
    double begin = now();
    for (size_t k = 0; k < n; k++) {
        fmb_result r = {.size = sizeof r};
        fmb_evidence *e = NULL;
        need(fmb_solve(v, s[k], &r) == FMB_OK && r.verdict == FMB_FEASIBLE &&
                 fmb_solver_evidence(v, &e) == FMB_OK,
             "no answer");
        fmb_evidence_free(e);
    }
    return now() - begin;
}

static double ask_tiny(size_t n)
{
    fmb_system **s = calloc(n, sizeof *s);
    fmb_solver *v = NULL;
    need(s && fmb_solver_new(NULL, NULL, &v) == FMB_OK, "no memory");
    for (size_t k = 0; k < n; k++)
        s[k] = make_tiny(k);
    pass_tiny(v, s, n);
    double taken = pass_tiny(v, s, n);
    for (size_t k = 0; k < n; k++)
        fmb_system_free(s[k]);
    free(s);
    fmb_solver_free(v);
    return taken;
}

/* ---- pairs ----------------------------------------------------------------------------------- */

static void *read_block(FILE *in, size_t bytes)
{
    void *block = malloc(bytes);
    need(block && fread(block, 1, bytes, in) == bytes, "no such data");
    return block;
}

/* Seconds for frames into a set, and verdicts on all pairs of it. */
static double pass_pairs(size_t frames, const fmb_frame_arrays *a, size_t pairs,
                         const fmb_frames_pair *pair)
{
    fmb_frames *set = NULL;
    fmb_pair *k = NULL;
    double begin = now();
    fmb_verdict *verdict = calloc(pairs, sizeof *verdict);
    fmb_pair_answers out = {.size = sizeof out, .verdict = verdict};
    need(verdict && fmb_frames_from_arrays(3, frames, a, NULL, &set) == FMB_OK &&
             fmb_pair_new(3, NULL, NULL, &k) == FMB_OK &&
             fmb_frames_test(k, set, set, pairs, pair, &out) == FMB_OK,
         "no answer");
    fmb_pair_free(k);
    fmb_frames_free(set);
    free(verdict);
    return now() - begin;
}

/* origin[frames][3], axes[frames][3][3] and pair[pairs], as the file has them one after the other.
 */
static double ask_pairs(const char *path, size_t frames, size_t pairs)
{
    FILE *in = fopen(path, "rb");
    need(in, "no such file");
    double *origin = read_block(in, frames * 3 * sizeof *origin);
    double *axes = read_block(in, frames * 9 * sizeof *axes);
    fmb_frames_pair *pair = read_block(in, pairs * sizeof *pair);
    fclose(in);
    fmb_frame_arrays a = {
        .size = sizeof a, .shape = FMB_CUBOID, .naxes = 3, .origin = origin, .axes = axes};
    pass_pairs(frames, &a, pairs, pair);
    double taken = pass_pairs(frames, &a, pairs, pair);
    free(pair);
    free(axes);
    free(origin);
    return taken;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "tiny") == 0)
        printf("%.9f\n", ask_tiny(strtoul(argv[2], NULL, 10)));
    else if (argc == 5 && strcmp(argv[1], "pairs") == 0)
        printf("%.9f\n",
               ask_pairs(argv[2], strtoul(argv[3], NULL, 10), strtoul(argv[4], NULL, 10)));
    else
        need(false, "usage: bench-python tiny N | pairs FILE FRAMES PAIRS");
    return 0;
}
